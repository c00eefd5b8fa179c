/**
 * The protocol of `/ws`: what is said in both directions, as types, and the one client that speaks it.
 *
 * One message is one JSON text. Two rules make every update small: an array replaces what the subscription had, an object
 * changes it by key. What is silent in the contract is settled in the comments here.
 */

export type Language = 'en' | 'de';
export type Mode = 'run' | 'stop' | 'startup' | 'hold' | 'defect';
export type Role = 'program' | 'view';
export type Unit = 'statement' | 'network' | 'scan';

/** `[line, executed, stw, accu1, accu2, reason?, value?]`. `executed`: 0 not in this scan, 1 in this scan, 2 not yet: values of the scan before.
 *  `stw`: bit 0 /FC, then RLO STA OR OS OV CC0 CC1 BR. Only the row that `reason` of the subscription names has a reason; others that need the place have `null`.
 *  `value`: what an assignment of Structured Text has written. */
export type Row = [number, 0 | 1 | 2, number, number, number, (string | null)?, string?];
/** `[element, flow, value]`; `net` of a wire, or the id of an element; flow after it: 1, 0, "not-run", "unknown". */
export type Flow = [string, string | number, string];

/** A value that became another, or a note about the CPU; never both. */
export interface Change {
  /** Scan at whose end the value was another. */
  n: number;
  name: string;
  address: string;
  from: string;
  to: string;
  /** "CPU in STOP": then there is no value. */
  note?: string;
  /** The statement that wrote it; without it the plant, a client or the user did. */
  by?: { block: string; network: number; line: number };
}

/** A simulated plant at one moment. */
export interface PlantLook {
  kind: string;
  name: string;
  /** First byte of inputs and outputs. */
  input: number;
  output: number;
  parameters: number[];
  inputs: number[];
  outputs: number[];
  /** What only the plant knows: name, value, unit. */
  state: [string, number, string][];
  /** Faults that it has, in the words of `--fault`. */
  faults: string[];
  /** Those of them whose time it is. */
  acting?: string[];
}

export interface Leds {
  sf: Lamp;
  bf: Lamp;
  dc5v: Lamp;
  frce: Lamp;
  run: Lamp;
  stop: Lamp;
}
/** Off, on, flashing. */
export type Lamp = 0 | 1 | 2;

export interface Client {
  id: string;
  name: string;
  protocol: string;
  peer: string;
  role?: Role;
  /** Requests of a client of a server in the last second. */
  reads?: number;
  writes?: number;
  last?: { name: string; n: number; t_us: number; from: string; to: string };
}

export interface DiagnosticEvent {
  /** `16#4562`. */
  id: string;
  text: string;
  detail: string;
  /** Time of the CPU as it writes it. */
  time: string;
  /** In which scan; not known of events before the run. */
  n: number | null;
  kind: 'error' | 'warning' | 'mode' | 'load' | 'info';
  place?: { block: string; network: number; line: number };
}

export interface Cycle {
  last_us: number;
  mean_us: number;
  max_us: number;
  program_us: number;
  /** Lower edge of a class in microseconds, scans in it. */
  histogram: [number, number][];
}

export interface Force {
  name: string;
  address: string;
  value: string;
  /** What the terminal has. */
  terminal: string;
  reason: string;
  by: string;
  since: string;
  n: number;
}

/** What a page can have sent to it; each gives its snapshot at once, and again after `at`. */
export type Subscription =
  /** Statements `from` to `to` of a block, counted from 0, both included; `reason`: the one whose reason is wanted.
   *  What changed comes by the number of the statement in its block. */
  | { what: 'rows'; block: string; instance?: string; from: number; to: number; reason?: number }
  /** Power flow in the diagrams of these networks. */
  | { what: 'flow'; block: string; instance?: string; view: 'lad' | 'fbd'; networks: number[] }
  /** `name` gives JSON (true, 17, "…"); `name,FORMAT` the text of that format. The answer is keyed by what was asked for. */
  | { what: 'tags'; names: string[] }
  | { what: 'plant' | 'leds' | 'changes' | 'clients' | 'diag' | 'cycle' | 'forces' };

export type Value = boolean | number | string | null;

export interface Snapshots {
  rows: Row[] | Record<string, Row>;
  flow: Record<string, Flow[]>;
  tags: Record<string, Value>;
  plant: PlantLook[];
  leds: Partial<Leds>;
  /** Newest first: all, or what came. */
  changes: Change[] | { add: Change[] };
  clients: Client[];
  diag: DiagnosticEvent[];
  cycle: Partial<Cycle>;
  forces: Force[];
}

export type ToServer =
  | { t: 'hello'; v: 1; lang: Language; mnemonics: Language }
  | ({ t: 'sub'; id: string } & Subscription)
  | { t: 'unsub'; id: string }
  /** A scan; the newest from now on; or so many statements, networks or scans from where the page is.
   *  A step past the newest scan of a CPU that is paused runs one scan. */
  | { t: 'at'; scan: number | 'live' }
  | { t: 'at'; step: Unit; n: number }
  | { t: 'history'; id: string; from: number; to: number; channels: string[]; points: number }
  | { t: 'who'; id: string; name: string; scan: number }
  | { t: 'ack'; seq: number }
  /** So many messages a second are enough; 0 for none. */
  | { t: 'rate'; hz: number };

export interface Welcome {
  t: 'welcome';
  v: 1;
  cpu: string;
  project: string;
  program: string;
  role: Role;
  oldest: number;
  newest: number;
  cycle_us: number;
  mnemonics: Language;
  /** Examples that this page may change to. */
  examples?: string[];
}

export interface Scan {
  t: 'scan';
  seq: number;
  /** The scan shown and its time. */
  n: number;
  t_us: number;
  mode: Mode;
  oldest: number;
  newest: number;
  /** Time of the newest scan. */
  newest_us: number;
  /** The page follows the newest scan. */
  live: boolean;
  paused: boolean;
  speed: number;
  /** Between statements: the statement that has just run. */
  pos?: { block: string; index: number; line: number; reason: string };
  /** Why the CPU stands, in STOP. */
  why?: string;
  s: Record<string, unknown>;
}

export interface History {
  t: 'history';
  id: string;
  from: number;
  to: number;
  /** Scans with their times in microseconds; those between are on lines between them. */
  times: [number, number][];
  /** Where the value became another: scan, value; the first entry is of `from`. */
  channels: Record<string, [number, number][]>;
}

export interface Who {
  t: 'who';
  id: string;
  name: string;
  text: string;
  block?: string;
  network?: number;
  line?: number;
  scan?: number;
}

export type FromServer =
  | Welcome
  | Scan
  | History
  | Who
  | { t: 'event'; level: 'info' | 'warning' | 'error'; code: string; text: string }
  | { t: 'program'; hash: string; changed: string[]; project?: string }
  | { t: 'bye'; why: string; text?: string };

/** Seconds between two attempts to connect. */
const WAITS = [1, 2, 4, 8, 15];
/** After so long without a word the server is asked whether it lives: it sends a scan once a second, but none while a long one runs. */
const SILENCE_MS = 1500;
/** So long it may take with the answer. */
const ANSWER_MS = 1000;
/** No scan takes as long as this: the connection is lost, whatever the server says. */
const LOST_MS = 15_000;
/** The connection is looked at so often. */
const LOOK_MS = 500;
/** What a page in sight gets, what a hidden one gets, and after how long it gets nothing at all. */
const RATE = { seen: 20, hidden: 2, none: 0 };
const HIDDEN_MS = 5 * 60_000;
/** A page may say 50 things a second beside acknowledgements: so many at once, and so many a second, because they arrive late and together where the computer is busy. */
const AT_ONCE = 12;
const A_SECOND = 16;

export interface Listener {
  opened(): void;
  message(message: FromServer): void;
  /** Waits so many seconds for the next attempt; nothing was heard since then, in the time of `performance.now()`. */
  closed(wait: number, why: string, since: number): void;
}

/** One connection that comes back by itself. */
export class Wire {
  #socket: WebSocket | null = null;
  #attempt = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #heard = 0;
  /** What the computer slept after that: its own clock stood still. */
  #slept = 0;
  #hidden: ReturnType<typeof setTimeout> | undefined;
  #rate = RATE.seen;
  /** What is still to be said, and how much of it may be said now. */
  #waiting: ToServer[] = [];
  #may = AT_ONCE;
  #said = 0;
  #soon: ReturnType<typeof setTimeout> | undefined;
  #asking = false;
  #why = '';
  #ended = false;
  #listener: Listener;
  #url: string;

  constructor(url: string, listener: Listener) {
    this.#url = url;
    this.#listener = listener;
    let wall = Date.now();
    let own = performance.now();
    setInterval(() => {
      const [now, at] = [Date.now(), performance.now()];
      // Asleep, or its clock was set: the connection has to say that it lives.
      this.#slept += Math.max(0, now - wall - (at - own) - LOOK_MS);
      [wall, own] = [now, at];
      const socket = this.#socket;
      if (socket !== null && this.#rate > 0 && at - this.#heard > SILENCE_MS) void this.#ask(socket, at - this.#heard > LOST_MS);
    }, LOOK_MS);
    document.addEventListener('visibilitychange', () => this.#pace());
  }

  /** As many messages as are looked at. */
  #pace(): void {
    clearTimeout(this.#hidden);
    this.#heard = performance.now();
    if (document.visibilityState === 'visible') {
      this.#hz(RATE.seen);
      this.retry();
    } else {
      this.#hz(RATE.hidden);
      this.#hidden = setTimeout(() => this.#hz(RATE.none), HIDDEN_MS);
    }
  }

  #hz(hz: number): void {
    this.#rate = hz;
    this.send({ t: 'rate', hz });
  }

  connect(): void {
    clearTimeout(this.#timer);
    this.#why = '';
    const socket = new WebSocket(this.#url);
    this.#socket = socket;
    this.#hear();
    this.#waiting = [];
    socket.onopen = () => {
      if (socket !== this.#socket) return;
      this.#hear();
      this.#listener.opened();
      if (this.#rate !== RATE.seen) this.#hz(this.#rate);
    };
    socket.onmessage = (event) => {
      if (socket !== this.#socket) return;
      this.#hear();
      let message: FromServer;
      try {
        message = JSON.parse(String(event.data)) as FromServer;
      } catch {
        return;
      }
      if (message.t === 'welcome') this.#attempt = 0;
      if (message.t === 'bye') this.#why = message.text ?? message.why;
      this.#listener.message(message);
      if (message.t === 'scan') this.send({ t: 'ack', seq: message.seq });
    };
    socket.onclose = () => this.#lost(socket);
  }

  async #ask(socket: WebSocket, long: boolean): Promise<void> {
    if (this.#asking) return;
    this.#asking = true;
    // A peer that has forgotten this connection says so now.
    this.#hz(this.#rate);
    const answered = await fetch('/icon.svg', { method: 'HEAD', cache: 'no-store', signal: AbortSignal.timeout(ANSWER_MS) }).then((answer) => answer.ok, () => false);
    this.#asking = false;
    if ((long || !answered) && performance.now() - this.#heard > SILENCE_MS) this.#lost(socket);
  }

  #hear(): void {
    this.#heard = performance.now();
    this.#slept = 0;
  }

  #lost(socket: WebSocket): void {
    if (socket !== this.#socket || this.#ended) return;
    this.#socket = null;
    socket.close();
    const wait = WAITS[Math.min(this.#attempt, WAITS.length - 1)] ?? 15;
    this.#attempt += 1;
    this.#listener.closed(wait, this.#why, this.#heard - this.#slept);
    this.#timer = setTimeout(() => this.connect(), wait * 1000);
  }

  /** Says it, in its order; where there is too much to say, what is overtaken is left out. */
  send(message: ToServer): void {
    if (this.#socket?.readyState !== WebSocket.OPEN) return;
    if (message.t === 'ack') return this.#socket.send(JSON.stringify(message));
    const waiting = this.#waiting;
    const last = waiting[waiting.length - 1];
    const same = 'id' in message ? waiting.findIndex((other) => 'id' in other && other.id === message.id) : -1;
    if (same >= 0) waiting[same] = message;
    else if (message.t === 'at' && last?.t === 'at' && 'scan' in message && 'scan' in last) last.scan = message.scan;
    else if (message.t === 'at' && last?.t === 'at' && 'step' in message && 'step' in last && message.step === last.step) last.n += message.n;
    else waiting.push(message);
    this.#soon ??= setTimeout(() => this.#flush(), 0);
  }

  #flush(): void {
    const now = performance.now();
    this.#may = Math.min(AT_ONCE, this.#may + ((now - this.#said) / 1000) * A_SECOND);
    this.#said = now;
    while (this.#waiting.length > 0 && this.#may >= 1) {
      this.#may -= 1;
      this.#socket?.send(JSON.stringify(this.#waiting.shift()));
    }
    this.#soon = this.#waiting.length > 0 ? setTimeout(() => this.#flush(), 1000 / A_SECOND) : undefined;
  }

  /** Tries at once. */
  retry(): void {
    if (this.#socket === null) {
      this.#attempt = 0;
      this.connect();
    }
  }

  end(): void {
    this.#ended = true;
    clearTimeout(this.#timer);
    this.#socket?.close();
  }
}
