/** The watch table: rows of a `*.watch` file and those that were added on this page. */
import { Problem, rest, type WatchRow } from '../rest';
import { english } from '../names';
import { added } from './added.svelte';
import { saveFile } from '../save';
import { page } from '../state.svelte';

export interface Line extends WatchRow {
  address: string;
  symbol: string;
  key: string;
  /** It is in no file: this browser has it. */
  added: boolean;
}

/** All formats of values: `docs/reference/formats.md`. */
export const FORMATS = ['BOOL', 'BIN', 'HEX', 'DEC', 'INT', 'DINT', 'LINT', 'REAL', 'LREAL', 'CHAR', 'BCD', 'S5TIME', 'TIME', 'LTIME', 'DATE', 'LDATE', 'TOD', 'LTOD', 'DT', 'LDT', 'COUNTER', 'POINTER', 'ANY'];

/** Address and symbol complete each other. */
export function place(name: string): { address: string; symbol: string; type: string } {
  const plain = name.trim().replace(/^"|"$/g, '');
  const bySymbol = page.symbols.find((one) => one.symbol.toLowerCase() === plain.toLowerCase());
  if (bySymbol !== undefined) return { address: bySymbol.address, symbol: bySymbol.symbol, type: bySymbol.type };
  const address = english(plain.toUpperCase().replace(/^([A-Z]+)\s*(\d)/, '$1 $2'));
  const byAddress = page.symbols.find((one) => one.address === address);
  return { address, symbol: byAddress?.symbol ?? '', type: byAddress?.type ?? (/\.\d$/.test(address) ? 'BOOL' : '') };
}

export function usualFormat(type: string, address: string): string {
  if (type === 'BOOL' || /\.\d$/.test(address)) return 'BOOL';
  if (/^C /.test(address)) return 'COUNTER';
  if (/^T /.test(address)) return 'S5TIME';
  if (type === 'REAL') return 'REAL';
  return type === 'WORD' || type === 'DWORD' || type === 'BYTE' ? 'HEX' : 'DEC';
}

const line = (row: WatchRow, key: string): Line => {
  const { address, symbol, type } = place(row.name);
  return { ...row, format: row.format || usualFormat(type, address), address, symbol, key, added: false };
};

/** A row that was added. */
const ofName = (name: string): Line => {
  const comment = page.symbols.find((one) => one.address === name)?.comment ?? '';
  return { ...line({ name, format: '', comment }, `+ ${name}`), added: true };
};

/** A field of a watch table, as its file has it. */
const field = (text: string): string => (/[",;\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/** A server without watch tables has none. */
function missing(error: unknown): string[] {
  if (error instanceof Problem && error.status === 404) return [];
  throw error;
}

/** Without a table: what the project calls by name. */
const usual = (): WatchRow[] => page.symbols.filter((one) => /^([IQMTC]|[IQM][BWD]) /.test(one.address)).slice(0, 40).map((one) => ({ name: one.symbol, format: '', comment: one.comment }));

class Watch {
  file = $state('');
  files = $state.raw<string[]>([]);
  #rows = $state.raw<Line[]>([]);
  #formats = $state<Record<string, string>>({});
  ticks = $state<Record<string, boolean>>({});
  values = $state<Record<string, string>>({});
  /** Why the value of a row was not written. */
  problems = $state<Record<string, string>>({});

  readonly lines: Line[] = $derived([...this.#rows, ...added.names.map(ofName)].map((row) => ({ ...row, format: this.#formats[row.key] ?? row.format })));

  async open(wanted: string): Promise<void> {
    try {
      this.files = await rest.watches().catch(missing);
      const file = this.files.includes(wanted) || wanted.endsWith('.watch') ? wanted : (this.files[0] ?? '');
      const rows = file === '' ? usual() : await rest.watch(file);
      this.file = file;
      this.#rows = rows.map((row, i) => line(row, `${i} ${row.name}`));
    } catch (error) {
      page.fail(error);
    }
  }

  add(name: string): void {
    if (name.trim() !== '') added.add(place(name).address);
  }

  remove(row: Line): void {
    added.remove(row.name);
    for (const of of [this.ticks, this.values, this.problems, this.#formats]) delete of[row.key];
  }

  format(row: Line, format: string): void {
    this.#formats[row.key] = format;
  }

  type(row: Line, text: string): void {
    this.values[row.key] = text;
    delete this.problems[row.key];
  }

  /** The table as a file of the project has it. */
  save(): void {
    const rows = this.lines.map((row) => [row.added && /^\w+$/.test(row.symbol) ? row.symbol : row.name, row.format, row.comment].map(field).join(','));
    saveFile(this.file || `${page.project}.watch`, `name,format,comment\n${rows.join('\n')}\n`);
  }

  get ticked(): Line[] {
    return this.lines.filter((one) => this.ticks[one.key] === true && (this.values[one.key] ?? '') !== '');
  }

  /** Writes the ticked values once; what is refused is said at its row. */
  async modify(): Promise<void> {
    const rows = this.ticked;
    if (page.locked !== '' || rows.length === 0) return;
    const wanted = Object.fromEntries(rows.map((one) => {
      const text = (this.values[one.key] ?? '').trim();
      const bool = /^(true|1)$/i.test(text) ? true : /^(false|0)$/i.test(text) ? false : text;
      return [one.address, one.format === 'BOOL' ? bool : text];
    }));
    for (const row of rows) delete this.problems[row.key];
    try {
      for (const { name, error } of await rest.write(wanted)) {
        if (error !== undefined) for (const row of rows.filter((one) => one.address === name)) this.problems[row.key] = `${error.message} (${error.code})`;
      }
    } catch (error) {
      const [only] = rows;
      if (rows.length === 1 && only !== undefined && error instanceof Problem && error.code !== '') this.problems[only.key] = `${error.message} (${error.code})`;
      else page.fail(error);
    }
  }
}
export const watch = new Watch();
