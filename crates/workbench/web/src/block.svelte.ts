/** A block that is shown: its statements and what they did in the scan of the page. */
import { rest, type BlockView, type Statement } from './rest';
import { page, RowState, type Selected } from './state.svelte';
import type { Flow, Row, Subscription, Unit } from './wire';

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
  /** What came last, by statement; and of the scan before, while statements are stepped through. */
  #raw: Row[] = [];
  #before: Row[] | null = null;
  #at = 0;
  #waiting: { fits: (scan: number) => boolean; done: () => void }[] = [];

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
      if (this.instance === '') this.instance = stl.instances[0] ?? '';
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
    this.#end = page.subscribe(`rows-${this.block}`, subscription, (data, scan) => this.#take(data as Row[] | Record<string, Row>, from, scan.n));
  }

  #take(data: Row[] | Record<string, Row>, from: number, scan: number): void {
    const rows = Array.isArray(data) ? data.map((row, i) => [from + i, row] as const) : Object.entries(data).map(([i, row]) => [from + Number(i), row] as const);
    const touched = new Set<number>();
    for (const [i, row] of rows) this.#raw[i] = row;
    const arrived = this.#waiting.filter((one) => one.fits(scan));
    this.#waiting = this.#waiting.filter((one) => !arrived.includes(one));
    arrived.forEach((one) => one.done());
    if (this.#before !== null && page.stepped >= 0) {
      this.#apply();
      return;
    }
    this.#before = null;
    for (const [i, row] of rows) {
      this.row(i).take(row);
      touched.add(i);
    }
    this.#rows.forEach((row, i) => {
      if (!touched.has(i)) row.calm();
    });
  }

  /** One statement or network on or back, in the scan of the page; then the neighbouring scan. */
  async step(unit: Unit, n: 1 | -1): Promise<void> {
    const count = this.statements.length;
    if (count === 0) return;
    if (page.stepped < 0 || this.#before === null) {
      await this.#begin(page.n, n > 0 ? 0 : count - 1);
      return;
    }
    let to = this.#at + n;
    const network = this.statements[this.#at]?.network;
    while (unit === 'network' && this.statements[to]?.network === network && to >= 0 && to < count - 1) to += n;
    if (to < 0) await this.#begin(page.stepped - 1, count - 1);
    else if (to < count) await this.#place(to);
    else {
      if (page.stepped >= page.newest && !(page.paused && (await page.do(rest.time({ step: 'scan', n: 1 }))))) return;
      await this.#begin(page.stepped + 1, 0);
    }
  }

  async #begin(scan: number, at: number): Promise<void> {
    if (scan < page.oldest) return;
    page.stepped = -1;
    this.#before = null;
    if (scan > page.oldest) {
      page.goTo(scan - 1, true);
      await this.#until((n) => n === scan - 1);
      this.#before = this.#raw.map((row): Row => [row[0], row[1] === 0 ? 0 : 2, row[2], row[3], row[4]]);
    } else this.#before = [];
    page.stepped = scan;
    page.goTo(scan, true);
    await this.#until((n) => n === scan);
    await this.#place(at);
  }

  async #place(at: number): Promise<void> {
    this.#at = at;
    this.#reason = at;
    this.#raw[at]?.splice(5);
    this.#subscribe();
    page.goTo(page.stepped, true);
    await this.#until(() => (this.#raw[at]?.length ?? 0) > 5);
    this.#apply();
  }

  /** Waits for the rows of what was asked for. */
  #until(fits: (scan: number) => boolean): Promise<void> {
    return new Promise((done) => {
      this.#waiting.push({ fits, done });
      setTimeout(done, 1000);
    });
  }

  /** Statements that have run with their values, the others with those of the scan before. */
  #apply(): void {
    const before = this.#before ?? [];
    this.statements.forEach((statement, i) => {
      const row = i <= this.#at ? this.#raw[i] : before[i];
      if (row !== undefined) this.row(i).take(row);
      if (i === this.#at) page.pos = { block: this.block, index: i, line: statement.line, reason: this.#raw[i]?.[5] ?? '' };
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
    page.stepper = (unit, n) => void model.step(unit, n);
    void model.load();
    return model;
  }

  /** Everything anew: another program, other mnemonics. */
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
