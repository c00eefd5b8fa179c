/** The REST client: what is not live, and what writes. */
import type { Client, Force, Language } from './wire';

export interface BlockHead {
  /** `OB1`, as ids and addresses write it. */
  block: string;
  title: string;
  symbol: string;
  language: string;
  /** Where the tree shows it. */
  group: 'cyclic' | 'restart' | 'interrupt' | 'error' | 'data' | 'not-called';
  /** Calls between it and what begins it. */
  depth: number;
  /** Data blocks that can be shown with it. */
  instances: string[];
}

export interface Statement {
  line: number;
  label?: string;
  op: string;
  operand: string;
  symbol: string;
  /** The address by which `who` and `refs` know the operand. */
  address?: string;
  comment?: string;
}

export interface Network {
  n: number;
  title: string;
  comment: string;
  /** How it is shown: as asked for, or `stl` with a reason. */
  view: 'stl' | 'lad' | 'fbd';
  reason?: string;
  svg?: string;
  statements: Statement[];
}

export interface BlockView {
  /** Of Structured Text its lines with their numbers, as they are written. */
  lines?: [number, string][] | null;
  block: string;
  title: string;
  symbol: string;
  language: string;
  instances: string[];
  networks: Network[];
}

export interface SymbolRow {
  symbol: string;
  address: string;
  type: string;
  comment: string;
  /** Places of use. */
  used: number;
}

export interface Reference {
  block: string;
  network: number;
  title?: string;
  file: string;
  line: number;
  type: 'R' | 'W' | 'RW' | string;
  instruction: string;
  text: string;
}

export interface References {
  address: string;
  symbol: string;
  indirect: boolean;
  references: Reference[];
}

export interface AssignedByte {
  byte: number;
  bits: number[];
  bits_of_wider_accesses: number[];
  accessed_as_byte: boolean;
  accessed_as_word: boolean;
  accessed_as_double_word: boolean;
  named_by_pointer: boolean;
}

export interface Assignments {
  areas: { area: string; bytes: AssignedByte[]; indirect: unknown[] }[];
  timers?: number[];
  counters?: number[];
}

export interface Structure {
  cpu: string;
  organization_blocks: string[];
  not_called: string[];
  blocks: Record<string, { symbol: string; local_data: number; path_local_data: number; library: boolean; recursive: boolean; calls: { block: string; instance: string | null }[] }>;
}

/** What an input or output of a plant is for. */
export interface Signal {
  name: string;
  address: string;
  direction: 'in' | 'out';
  /** Who sets an input. */
  driven: 'plant' | 'user';
  /** How a person sets it. */
  about?: string;
  /** Of a word: what it is measured in, and what it counts for one of it. */
  unit?: string;
  per_unit?: number;
  handle?: 'push' | 'push-nc' | 'switch' | 'switch-nc';
}

export interface PlantHead {
  name: string;
  kind: string;
  title: string;
  detail: string;
  signals: Signal[];
  /** Names of what a look has in `parameters`. */
  parameters?: string[];
}

export interface WatchRow {
  name: string;
  format: string;
  comment: string;
}

export interface Info {
  cpu: string;
  work_memory?: number;
  work_used?: number;
  data_bytes?: number;
  local_data: number;
  servers: { name: string; address: string }[];
  connections: number;
}

/** What ran when a statement sent the CPU to STOP. */
export interface Stacks {
  n: number;
  /** What the statement could not do. */
  reason: string | null;
  /** The register that was wrong. */
  register: { name: string; value: string } | null;
  source: { line: number; text: string; failed: boolean }[];
  /** The block stack, innermost first. */
  b: { block: string; symbol: string; network: number; line: number | null; db: number; di: number }[];
  /** Registers before the statement. */
  i: Record<string, string | number> & { bits: Record<string, number | boolean> };
  /** Local data. */
  l: { block: string; bytes: string; more: number }[];
}

/** What became of each value that was to be written. */
interface Written {
  items: { name: string; error?: { code: string; message: string } }[];
}

/** An answer that is no success: the code and the sentence of the product. */
export class Problem extends Error {
  readonly status: number;
  readonly code: string;
  constructor(status: number, code: string, text: string) {
    super(text);
    this.status = status;
    this.code = code;
  }
}

let token = '';
let language: Language = 'en';

/** The token comes with the address once, and is gone from the address bar. */
export function takeToken(): string {
  const url = new URL(location.href);
  const given = url.searchParams.get('token');
  if (given !== null) {
    token = given;
    sessionStorage.setItem('token', given);
    url.searchParams.delete('token');
    history.replaceState(history.state, '', url);
  } else {
    token = sessionStorage.getItem('token') ?? '';
  }
  return token;
}

export function speak(to: Language): void {
  language = to;
}

async function call<T>(method: string, path: string, body?: unknown): Promise<T> {
  const headers: Record<string, string> = { 'accept-language': language };
  if (token !== '') headers['authorization'] = `Bearer ${token}`;
  if (body !== undefined) headers['content-type'] = 'application/json';
  let answer: Response;
  try {
    const init: RequestInit = { method, headers, cache: 'no-cache' };
    if (body !== undefined) init.body = JSON.stringify(body);
    answer = await fetch(`/api/v1/${path}`, init);
  } catch {
    throw new Problem(0, '', 'offline');
  }
  if (!answer.ok) {
    const problem = (await answer.json().catch(() => ({}))) as { code?: string; detail?: string; title?: string };
    throw new Problem(answer.status, problem.code ?? '', problem.detail ?? problem.title ?? answer.statusText);
  }
  if (answer.status === 204) return undefined as T;
  const kind = answer.headers.get('content-type') ?? '';
  return (kind.includes('json') ? await answer.json() : await answer.text()) as T;
}

const name = encodeURIComponent;

export const rest = {
  blocks: () => call<BlockHead[]>('GET', 'blocks'),
  block: (block: string, view: 'stl' | 'lad' | 'fbd', mnemonics: Language) => call<BlockView>('GET', `blocks/${name(block)}?view=${view}&mnemonics=${mnemonics}`),
  symbols: () => call<SymbolRow[]>('GET', 'symbols'),
  refs: (address: string) => call<References[]>('GET', `refs?name=${name(address)}`),
  assignments: () => call<Assignments>('GET', 'assignments'),
  structure: () => call<Structure>('GET', 'structure'),
  plants: () => call<PlantHead[]>('GET', 'plants'),
  clients: () => call<Client[]>('GET', 'clients'),
  info: () => call<Info>('GET', 'info'),
  stacks: (mnemonics: string) => call<Stacks | null>('GET', `stacks?mnemonics=${mnemonics}`),
  about: (op: string) => call<{ text: string }>('GET', `explain/${name(op)}`),
  watch: (file: string) => call<WatchRow[]>('GET', `watch/${name(file)}`),
  watches: () => call<string[]>('GET', 'watch'),
  trace: (from: number, to: number, channels: string[], format: 'csv' | 'vcd' | 'svg') => call<string>('GET', `trace?from=${from}&to=${to}&channels=${channels.map(name).join(',')}&format=${format}`),
  diagnostics: () => call<string>('GET', 'diagnostics?format=text'),

  mode: (body: { mode: 'run' | 'stop' | 'mres'; restart?: string }) => call<void>('POST', 'mode', body),
  time: (body: { pause: true } | { go: true } | { step: string; n: number } | { speed: number }) => call<void>('POST', 'time', body),
  /** All of them, or the first that could not be written. */
  set: async (values: Record<string, boolean | number | string>): Promise<void> => {
    const wrong = (await rest.write(values)).find((one) => one.error !== undefined);
    if (wrong?.error !== undefined) throw new Problem(422, wrong.error.code, `${wrong.name}: ${wrong.error.message}`);
  },
  /** What became of each of them. */
  write: async (values: Record<string, boolean | number | string>): Promise<Written['items']> => (await call<Written>('PATCH', 'tags', values)).items,
  /** Whether a bit is 1 now. */
  bit: async (address: string): Promise<boolean> => {
    const { items } = await call<{ items: { value?: unknown }[] }>('GET', `tags?names=${name(address)}`);
    return Number(items[0]?.value) === 1;
  },
  force: (body: { name: string; value: string; reason: string }) => call<Force[]>('POST', 'forces', body),
  release: (address?: string) => call<Force[]>('DELETE', address === undefined ? 'forces' : `forces/${name(address)}`),
  fault: (signal: string, fault: string) => call<void>('POST', 'faults', { name: signal, fault }),
  project: (example: string) => call<void>('POST', 'project', { example }),
};
