/** The one model of the page: it shows one scan; everything that is drawn is read from here. */
import { SvelteMap } from 'svelte/reactivity';
import { german } from './names';
import { rest, takeToken, speak, Problem, type BlockHead, type PlantHead, type SymbolRow } from './rest';
import { chooseLanguage, setLanguage, speech, t } from './words.svelte';
import { Wire, type Change, type Client, type Cycle, type DiagnosticEvent, type Force, type FromServer, type History, type Language, type Leds, type Mode, type PlantLook, type Row, type Scan, type Subscription, type Unit, type Value, type Welcome, type Who } from './wire';

export type State = 'run' | 'paused' | 'stepping' | 'past' | 'stop' | 'startup' | 'offline' | 'readonly';
type Handler = (data: unknown, scan: Scan) => void;

/** How many changes the page keeps. */
const CHANGES = 200;
/** A question that has no answer by then gets none. */
const ANSWER_MS = 5000;
/** Values are stale when they are older than this. */
const STALE_MS = 2000;
/** What the server takes: bytes of a name, names, bytes of all of them in a message. */
const NAME_BYTES = 200;
const NAMES = 2000;
const NAMES_BYTES = 60_000;

const encoder = new TextEncoder();
const bytes = (text: string): number => encoder.encode(text).length;
/** Whether the server takes this as a name: a longer one would end the connection. */
export const isShort = (name: string): boolean => bytes(name) <= NAME_BYTES;

export interface Selected {
  block: string;
  index: number;
  line: number;
  network: number;
  op: string;
  operand: string;
  symbol: string;
  address: string;
}

class Page {
  link = $state<'connecting' | 'up' | 'down'>('connecting');
  /** Since when nothing was heard, in the time of `performance.now()`; 0 while connected. */
  lostAt = $state(0);
  clock = $state(performance.now());
  /** When the page last saw time go on, or stand because it was asked to. */
  #freshAt = $state(performance.now());
  project = $state('');
  cpu = $state('');
  programHash = $state('');
  role = $state<'program' | 'view'>('program');
  cycleUs = $state(10_000);
  examples = $state<string[]>([]);
  /** Grows when what REST gives has to be asked for again. */
  revision = $state(0);

  n = $state(0);
  us = $state(0);
  oldest = $state(0);
  newest = $state(0);
  newestUs = $state(0);
  mode = $state<Mode>('run');
  following = $state(true);
  paused = $state(false);
  speed = $state(1);
  pos = $state.raw<Scan['pos']>(undefined);
  why = $state('');
  stopScan = $state(0);
  shown = $state(false);

  leds = $state<Leds>({ sf: 0, bf: 0, dc5v: 0, frce: 0, run: 0, stop: 0 });
  cycle = $state<Cycle>({ last_us: 0, mean_us: 0, max_us: 0, program_us: 0, histogram: [] });
  spark = $state.raw<number[]>([]);
  plants = $state.raw<PlantLook[]>([]);
  changes = $state.raw<Change[]>([]);
  clients = $state.raw<Client[]>([]);
  events = $state.raw<DiagnosticEvent[]>([]);
  forces = $state.raw<Force[]>([]);
  tags = new SvelteMap<string, Value>();

  blocks = $state.raw<BlockHead[]>([]);
  symbols = $state.raw<SymbolRow[]>([]);
  heads = $state.raw<PlantHead[]>([]);

  selected = $state.raw<Selected | null>(null);
  mnemonics = $state<Language>('en');
  unit = $state<Unit>('statement');
  toast = $state('');
  announcement = $state('');
  /** What the page was asked to open: palette, keys, force dialog. */
  dialog = $state<'' | 'palette' | 'keys' | 'force' | 'token'>('');
  /** On narrow screens the reasons are in a drawer. */
  drawer = $state(false);
  forceWanted = $state('');
  forceValue = $state('');

  state: State = $derived.by(() => {
    if (this.link === 'down') return 'offline';
    if (!this.following) return this.pos !== undefined && this.n === this.newest ? 'stepping' : 'past';
    if (this.pos !== undefined) return 'stepping';
    if (this.mode === 'stop' || this.mode === 'defect') return 'stop';
    if (this.mode === 'startup') return 'startup';
    if (this.paused) return 'paused';
    return this.role === 'view' ? 'readonly' : 'run';
  });
  /** Why nothing can be written; empty where it can. */
  locked: string = $derived.by(() => {
    if (this.link !== 'up') return t('offOffline');
    if (this.role === 'view') return t('offView');
    if (this.state === 'past') return t('offPast');
    if (this.state === 'startup') return t('offStartup');
    return '';
  });
  /** For how many seconds one scan has been running; 0 while scans come as they should. */
  waits: number = $derived(this.link !== 'down' && this.clock - this.#freshAt > STALE_MS ? Math.floor((this.clock - this.#freshAt) / 1000) : 0);
  /** Time from scan to scan: what is set, or where the scan is free about what it takes. */
  scanUs: number = $derived(this.cycleUs || Math.max(1, Number((this.newestUs / Math.max(1, this.newest)).toPrecision(1))));
  offlineFor: number = $derived(this.lostAt === 0 ? 0 : Math.max(0, Math.round((this.clock - this.lostAt) / 1000)));

  #wire: Wire | null = null;
  #handlers = new Map<string, { subscription: Subscription; handler: Handler }>();
  #questions = new Map<string, (answer: FromServer | null) => void>();
  #tagCounts = new Map<string, number>();
  #tagTimer = false;
  #refused = false;
  #next = 0;

  start(): void {
    speak(chooseLanguage());
    this.mnemonics = (localStorage.getItem('mnemonics') as Language | null) ?? 'en';
    const token = takeToken();
    const url = new URL('/ws', location.href);
    url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
    if (token !== '') url.searchParams.set('token', token);
    this.subscribe('leds', { what: 'leds' }, (data) => Object.assign(this.leds, data));
    this.subscribe('plant', { what: 'plant' }, (data) => (this.plants = data as PlantLook[]));
    this.subscribe('changes', { what: 'changes' }, (data) => {
      this.changes = Array.isArray(data) ? (data as Change[]) : [...(data as { add: Change[] }).add, ...this.changes].slice(0, CHANGES);
    });
    this.subscribe('forces', { what: 'forces' }, (data) => (this.forces = data as Force[]));
    this.subscribe('cycle', { what: 'cycle' }, (data) => {
      Object.assign(this.cycle, data);
      this.spark = [...this.spark, this.cycle.last_us].slice(-24);
    });
    this.#wire = new Wire(url.toString(), {
      opened: () => this.#hello(),
      message: (message) => this.#take(message),
      closed: (_wait, _why, since) => {
        if (this.link !== 'down') {
          this.lostAt = since;
          this.clock = performance.now();
          this.announce(t('connOffline'));
        }
        // It cannot be seen from the end of a WebSocket why it was refused.
        if (!this.#refused) void rest.info().catch((error: Problem) => error.status === 401 && (this.#refused = true) && (this.dialog = 'token'));
        this.link = 'down';
        for (const answer of this.#questions.values()) answer(null);
        this.#questions.clear();
      },
    });
    this.#wire.connect();
    setInterval(() => (this.clock = performance.now()), 500);
    document.addEventListener('visibilitychange', () => (this.#freshAt = performance.now()));
    addEventListener('pagehide', () => this.#wire?.end());
  }

  retry(): void {
    this.#wire?.retry();
  }

  #send(message: Parameters<Wire['send']>[0]): void {
    this.#wire?.send(message);
  }

  #take(message: FromServer): void {
    switch (message.t) {
      case 'welcome':
        this.#welcome(message);
        break;
      case 'scan':
        this.#scan(message);
        break;
      case 'history':
      case 'who':
        this.#questions.get(message.id)?.(message);
        break;
      case 'program':
        this.programHash = message.hash;
        if (message.project !== undefined) {
          // Another CPU: nothing of this one holds there.
          this.project = message.project;
          this.tags.clear();
        }
        this.#other();
        break;
      case 'event':
        this.say(message.text);
        break;
      case 'bye':
        this.say(message.text ?? message.why);
        break;
    }
  }

  #welcome(message: Welcome): void {
    const known = this.programHash;
    if (this.lostAt > 0) this.say(t('backAgain', this.offlineFor));
    this.link = 'up';
    this.#refused = false;
    this.lostAt = 0;
    this.project = message.project;
    this.cpu = message.cpu;
    this.role = message.role;
    this.cycleUs = message.cycle_us;
    this.examples = message.examples ?? [];
    this.oldest = message.oldest;
    this.newest = message.newest;
    this.following = true;
    this.pos = undefined;
    const said = this.mnemonics;
    if (localStorage.getItem('mnemonics') === null) this.mnemonics = message.mnemonics;
    this.programHash = message.program;
    // Without a choice the mnemonics are those of the project, and sentences follow.
    if (this.mnemonics !== said) this.#hello();
    if (known !== message.program && known !== '') {
      this.tags.clear();
      this.#other();
    } else if (this.blocks.length === 0) this.#load();
    for (const [id, entry] of this.#handlers) this.#subscribe(id, entry.subscription);
    this.#tagsNow();
  }

  /** Another program: nothing that was looked up of the one before holds. */
  #other(): void {
    this.selected = null;
    this.changes = [];
    this.#load();
  }

  #scan(message: Scan): void {
    const mode = this.mode;
    if (this.us !== message.t_us || message.paused || !message.live || message.mode === 'stop') this.#freshAt = performance.now();
    this.n = message.n;
    this.us = message.t_us;
    this.mode = message.mode;
    this.oldest = message.oldest;
    this.newest = message.newest;
    this.newestUs = message.newest_us;
    this.following = message.live;
    this.paused = message.paused;
    this.speed = message.speed;
    this.why = message.why ?? '';
    const reason = message.pos?.reason;
    if (reason !== undefined && reason !== this.pos?.reason) this.announce(reason);
    this.pos = message.pos;
    if (mode !== message.mode) {
      this.announce(message.mode.toUpperCase());
      if (message.mode === 'stop') this.stopScan = message.n;
    }
    for (const [id, data] of Object.entries(message.s)) {
      const entry = this.#handlers.get(id);
      if (entry !== undefined) entry.handler(data, message);
      else if (id === 'tags') for (const [name, value] of Object.entries(data as Record<string, Value>)) this.tags.set(name, value);
    }
    for (const [id, entry] of this.#handlers) if (entry.subscription.what === 'rows' && !(id in message.s)) entry.handler({}, message);
    this.shown = true;
  }

  async #load(): Promise<void> {
    try {
      const [blocks, symbols, heads] = await Promise.all([rest.blocks(), rest.symbols(), rest.plants()]);
      this.blocks = blocks;
      this.symbols = symbols;
      this.heads = heads.map(withHandles);
      this.revision += 1;
    } catch (error) {
      this.fail(error);
    }
  }

  /** What is subscribed comes now and after each connection; ends with the function that it gives. */
  subscribe(id: string, subscription: Subscription, handler: Handler): () => void {
    this.#handlers.set(id, { subscription, handler });
    if (this.link === 'up') this.#subscribe(id, subscription);
    return () => {
      this.#handlers.delete(id);
      this.#send({ t: 'unsub', id });
    };
  }

  #subscribe(id: string, subscription: Subscription): void {
    this.#send({ t: 'sub', id, ...subscription });
  }

  id(prefix: string): string {
    this.#next += 1;
    return `${prefix}${this.#next}`;
  }

  /** Values by name, as long as they are read. */
  watch(names: string[]): () => void {
    for (const name of names) this.#tagCounts.set(name, (this.#tagCounts.get(name) ?? 0) + 1);
    this.#tagsSoon();
    return () => {
      for (const name of names) {
        const left = (this.#tagCounts.get(name) ?? 1) - 1;
        if (left > 0) this.#tagCounts.set(name, left);
        else this.#tagCounts.delete(name);
      }
      this.#tagsSoon();
    };
  }

  #tagsSoon(): void {
    if (this.#tagTimer) return;
    this.#tagTimer = true;
    queueMicrotask(() => {
      this.#tagTimer = false;
      this.#tagsNow();
    });
  }

  #tagsNow(): void {
    if (this.link !== 'up') return;
    let room = NAMES_BYTES;
    const names = [...this.#tagCounts.keys()].filter((name) => isShort(name) && (room -= bytes(JSON.stringify(name)) + 1) > 0).slice(0, NAMES);
    if (names.length === 0) this.#send({ t: 'unsub', id: 'tags' });
    else this.#send({ t: 'sub', id: 'tags', what: 'tags', names });
  }

  /** Nothing where the connection ended, or the server does not say. */
  history(from: number, to: number, channels: string[], points: number): Promise<History | null> {
    const id = this.id('h');
    return this.#asks(id, { t: 'history', id, from, to, channels: channels.filter(isShort), points });
  }

  who(name: string): Promise<Who | null> {
    const id = this.id('w');
    return isShort(name) ? this.#asks(id, { t: 'who', id, name, scan: this.n }) : Promise.resolve(null);
  }

  #asks<T extends FromServer>(id: string, question: Parameters<Wire['send']>[0]): Promise<T | null> {
    return new Promise((resolve) => {
      const answer = (given: FromServer | null) => {
        this.#questions.delete(id);
        resolve(given as T | null);
      };
      this.#questions.set(id, answer);
      setTimeout(() => answer(null), ANSWER_MS);
      this.#send(question);
    });
  }

  // time
  goTo(scan: number | 'live'): void {
    this.#send({ t: 'at', scan: scan === 'live' ? 'live' : Math.max(this.oldest, Math.min(this.newest, Math.round(scan))) });
  }

  step(unit: Unit, n: 1 | -1): void {
    this.#send({ t: 'at', step: unit, n });
  }

  async pause(): Promise<void> {
    const goesOn = this.paused || !this.following || this.pos !== undefined;
    if (goesOn) this.goTo('live');
    if (this.role === 'view' || (goesOn && !this.paused)) return;
    await this.do(rest.time(goesOn ? { go: true } : { pause: true }));
  }

  async set(name: string, value: boolean | number | string): Promise<void> {
    if (this.locked !== '') return;
    await this.do(rest.set({ [name]: value }));
  }

  async setMode(mode: 'run' | 'stop' | 'mres'): Promise<void> {
    await this.do(rest.mode({ mode }));
  }

  async do(work: Promise<unknown>): Promise<boolean> {
    try {
      await work;
      return true;
    } catch (error) {
      this.fail(error);
      return false;
    }
  }

  fail(error: unknown): void {
    if (error instanceof Problem && error.status === 0) return;
    const text = error instanceof Error ? error.message : String(error);
    const code = error instanceof Problem && error.code !== '' ? ` (${error.code})` : '';
    this.say(t('notSaved', text) + code);
  }

  #toastTimer: ReturnType<typeof setTimeout> | undefined;
  /** A short word about what was just done; what lasts stands in the strip. */
  say(text: string): void {
    this.toast = text;
    this.announce(text);
    clearTimeout(this.#toastTimer);
    this.#toastTimer = setTimeout(() => (this.toast = ''), 5000);
  }

  #announced = 0;
  announce(text: string): void {
    const now = performance.now();
    clearTimeout(this.#announceTimer);
    const say = () => {
      this.#announced = performance.now();
      this.announcement = text;
    };
    if (now - this.#announced > 3000) say();
    else this.#announceTimer = setTimeout(say, 3000 - (now - this.#announced));
  }
  #announceTimer: ReturnType<typeof setTimeout> | undefined;

  setMnemonics(to: Language): void {
    this.mnemonics = to;
    localStorage.setItem('mnemonics', to);
    this.#hello();
    this.#load();
  }

  setLanguage(to: Language): void {
    setLanguage(to);
    speak(to);
    this.#hello();
    this.#load();
  }

  /** How sentences shall be written. */
  #hello(): void {
    this.#send({ t: 'hello', v: 1, lang: speech.lang, mnemonics: this.mnemonics });
  }

  /** An address in the mnemonics that were chosen. */
  spell(address: string): string {
    return this.mnemonics === 'de' ? german(address) : address;
  }

  /** The symbol or the address of an address. */
  nameOf(address: string): string {
    return this.symbols.find((s) => s.address === address)?.symbol ?? this.spell(address);
  }
}

export const page = new Page();

/** What is a button is pressed, not switched. */
function withHandles(head: PlantHead): PlantHead {
  const signals = head.signals.map((signal) => {
    if (!/button/i.test(signal.about ?? '')) return signal;
    if (signal.handle === 'switch') return { ...signal, handle: 'push' as const };
    return signal.handle === 'switch-nc' ? { ...signal, handle: 'push-nc' as const } : signal;
  });
  return { ...head, signals };
}

/** One statement of one scan; its fields change, it stays. */
export class RowState {
  executed = $state<0 | 1 | 2>(0);
  stw = $state(0);
  accu1 = $state(0);
  accu2 = $state(0);
  reason = $state('');
  /** What an assignment has written. */
  value = $state('');
  known = $state(false);
  changedBit = $state(false);
  changedAccu = $state(false);

  take(row: Row): void {
    const [, executed, stw, accu1, accu2, reason, value = ''] = row;
    this.changedBit = this.known && executed === 1 && ((this.stw ^ stw) & 4) !== 0;
    this.changedAccu = this.known && executed === 1 && (value === '' ? this.accu1 !== accu1 : this.value !== value);
    this.executed = executed;
    this.stw = stw;
    this.accu1 = accu1;
    this.accu2 = accu2;
    this.reason = reason ?? '';
    this.value = value;
    this.known = true;
  }

  calm(): void {
    if (this.changedBit) this.changedBit = false;
    if (this.changedAccu) this.changedAccu = false;
  }
}

/** Bits of the status word on the wire. */
export const STW = { FC: 1, RLO: 2, STA: 4, OR: 8, OS: 16, OV: 32, CC0: 64, CC1: 128, BR: 256 } as const;
export const bit = (stw: number, mask: number): 0 | 1 => ((stw & mask) !== 0 ? 1 : 0);

/** The rows of a block, in place. */
export class Rows {
  list: RowState[];
  constructor(size: number) {
    this.list = Array.from({ length: size }, () => new RowState());
  }
  take(data: Row[] | Record<string, Row>): void {
    const touched = new Set<number>();
    if (Array.isArray(data)) data.forEach((row, i) => this.#one(i, row, touched));
    else for (const [i, row] of Object.entries(data)) this.#one(Number(i), row, touched);
    this.list.forEach((row, i) => {
      if (!touched.has(i)) row.calm();
    });
  }
  #one(i: number, row: Row, touched: Set<number>): void {
    const state = this.list[i];
    if (state === undefined) return;
    state.take(row);
    touched.add(i);
  }
}
