/** A block that is shown: its statements and what they did in the scan of the page. */
import { rest, type BlockView, type Statement } from './rest';
import { page, RowState, type Selected } from './state.svelte';
import type { Flow, Row, Subscription } from './wire';

/** Rows that one subscription may have. */
const ROWS = 400;

export interface Placed extends Statement {
  index: number;
  network: number;
}

export class BlockModel {
  block: string;
  instance = $state('');
  stl = $state.raw<BlockView | null>(null);
  statements = $state.raw<Placed[]>([]);
  failed = $state('');
  #rows: RowState[] = [];
  #end: (() => void) | null = null;
  #from = 0;
  #to = -1;
  #reason = -1;

  constructor(block: string, instance: string) {
    this.block = block;
    this.instance = instance;
  }

  async load(): Promise<void> {
    try {
      const stl = await rest.block(this.block, 'stl', page.mnemonics);
      let index = 0;
      this.statements = stl.networks.flatMap((network) => network.statements.map((statement) => ({ ...statement, network: network.n, index: index++ })));
      this.stl = stl;
      if (!stl.instances.includes(this.instance)) this.instance = stl.instances[0] ?? '';
      const count = this.statements.length;
      if (count > 0) this.range(0, Math.min(count, ROWS) - 1, true);
      const selected = page.selected;
      if (selected === null || selected.block !== this.block) this.select(0);
      else this.select(Math.min(selected.index, count - 1));
    } catch (error) {
      this.failed = error instanceof Error ? error.message : String(error);
    }
  }

  row(index: number): RowState {
    return (this.#rows[index] ??= new RowState());
  }

  /** The statements whose values are wanted: those that are seen. */
  range(from: number, to: number, again = false): void {
    from = Math.max(0, from);
    to = Math.min(this.statements.length - 1, to, from + ROWS - 1);
    if (!again && from >= this.#from && to <= this.#to) return;
    this.#from = from;
    this.#to = to;
    this.#subscribe();
  }

  #subscribe(): void {
    if (this.#to < this.#from) return;
    const subscription: Subscription = { what: 'rows', block: this.block, from: this.#from, to: this.#to };
    if (this.instance !== '') subscription.instance = this.instance;
    if (this.#reason >= 0) subscription.reason = this.#reason;
    const from = this.#from;
    this.#end?.();
    this.#end = page.subscribe(`rows-${this.block}`, subscription, (data) => this.#take(data as Row[] | Record<string, Row>, from));
  }

  #take(data: Row[] | Record<string, Row>, from: number): void {
    const rows = Array.isArray(data) ? data.map((row, i) => [from + i, row] as const) : Object.entries(data).map(([i, row]) => [Number(i), row] as const);
    const touched = new Set<number>();
    for (const [i, row] of rows) {
      this.row(i).take(row);
      touched.add(i);
    }
    this.#rows.forEach((row, i) => {
      if (!touched.has(i)) row.calm();
    });
  }

  setInstance(instance: string): void {
    this.instance = instance;
    this.#subscribe();
  }

  select(index: number): void {
    const statement = this.statements[index];
    if (statement === undefined) return;
    const selected: Selected = { block: this.block, index, line: statement.line, network: statement.network, op: statement.op, operand: statement.operand, symbol: statement.symbol, address: statement.address ?? '' };
    page.selected = selected;
    if (this.#reason !== index) {
      this.#reason = index;
      this.#subscribe();
    }
  }

  selectLine(line: number): void {
    const found = this.statements.find((statement) => statement.line === line);
    if (found !== undefined) this.select(found.index);
  }

  end(): void {
    this.#end?.();
    this.#end = null;
  }
}

/** Power flow of networks as diagrams, by network and element. */
export class FlowModel {
  networks = $state.raw<Record<string, Flow[]>>({});
  #end: (() => void) | null = null;

  show(block: string, instance: string, view: 'lad' | 'fbd', networks: number[]): void {
    this.#end?.();
    const subscription: Subscription = { what: 'flow', block, view, networks };
    if (instance !== '') subscription.instance = instance;
    this.#end = page.subscribe(`flow-${view}`, subscription, (data) => (this.networks = { ...this.networks, ...(data as Record<string, Flow[]>) }));
  }

  end(): void {
    this.#end?.();
    this.#end = null;
  }
}

class Shown {
  model = $state.raw<BlockModel | null>(null);

  open(block: string, instance = ''): BlockModel {
    const before = this.model;
    if (before !== null && before.block === block && (instance === '' || before.instance === instance)) return before;
    before?.end();
    const model = new BlockModel(block, instance);
    this.model = model;
    void model.load();
    return model;
  }

  /** Everything from the beginning: another program, other mnemonics. */
  reload(): void {
    const before = this.model;
    if (before === null) return;
    before.end();
    this.model = null;
    const known = page.blocks.some((one) => one.block === before.block);
    if (known) this.open(before.block, before.instance);
  }
}
export const shown = new Shown();
