/** The watch table: rows of a `*.watch` file and those that were added on this page. */
import { Problem, rest, type WatchRow } from '../rest';
import { added, keepAdded } from './added';
import { page } from '../state.svelte';

export interface Line extends WatchRow {
  address: string;
  symbol: string;
  key: string;
}

export const FORMATS = ['BOOL', 'DEC', 'HEX', 'BIN', 'BCD', 'REAL', 'COUNTER', 'TIMER', 'CHAR', 'DATE'];

/** Address and symbol complete each other. */
export function place(name: string): { address: string; symbol: string; type: string } {
  const plain = name.trim().replace(/^"|"$/g, '');
  const bySymbol = page.symbols.find((one) => one.symbol.toLowerCase() === plain.toLowerCase());
  if (bySymbol !== undefined) return { address: bySymbol.address, symbol: bySymbol.symbol, type: bySymbol.type };
  const address = plain.toUpperCase().replace(/^([A-Z]+)\s*(\d)/, '$1 $2');
  const byAddress = page.symbols.find((one) => one.address === address);
  return { address, symbol: byAddress?.symbol ?? '', type: byAddress?.type ?? (/\.\d$/.test(address) ? 'BOOL' : '') };
}

export function usualFormat(type: string, address: string): string {
  if (type === 'BOOL' || /\.\d$/.test(address)) return 'BOOL';
  if (/^C /.test(address)) return 'COUNTER';
  if (/^T /.test(address)) return 'TIMER';
  if (type === 'REAL') return 'REAL';
  return type === 'WORD' || type === 'DWORD' || type === 'BYTE' ? 'HEX' : 'DEC';
}

const line = (row: WatchRow, i: number): Line => {
  const { address, symbol, type } = place(row.name);
  return { ...row, format: row.format || usualFormat(type, address), address, symbol, key: `${i} ${row.name}` };
};

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
  lines = $state.raw<Line[]>([]);
  ticks = $state<Record<string, boolean>>({});
  values = $state<Record<string, string>>({});

  async open(wanted: string): Promise<void> {
    try {
      this.files = await rest.watches().catch(missing);
      const file = this.files.includes(wanted) || wanted.endsWith('.watch') ? wanted : (this.files[0] ?? '');
      const rows = file === '' ? usual() : await rest.watch(file);
      this.file = file;
      const further = added().map((name) => ({ name, format: '', comment: '' }));
      this.lines = [...rows, ...further].map(line);
    } catch (error) {
      page.fail(error);
    }
  }

  add(name: string): void {
    if (name.trim() === '') return;
    const { address } = place(name);
    const comment = page.symbols.find((one) => one.address === address)?.comment ?? '';
    this.lines = [...this.lines, line({ name: address, format: '', comment }, this.lines.length)];
    keepAdded([...added(), address]);
  }

  format(row: Line, format: string): void {
    this.lines = this.lines.map((one) => (one.key === row.key ? { ...one, format } : one));
  }

  get ticked(): Line[] {
    return this.lines.filter((one) => this.ticks[one.key] === true && (this.values[one.key] ?? '') !== '');
  }

  /** Writes the ticked values once. */
  async modify(): Promise<void> {
    if (page.locked !== '' || this.ticked.length === 0) return;
    const wanted = Object.fromEntries(this.ticked.map((one) => {
      const text = (this.values[one.key] ?? '').trim();
      const bool = /^(true|1)$/i.test(text) ? true : /^(false|0)$/i.test(text) ? false : text;
      return [one.address, one.format === 'BOOL' ? bool : text];
    }));
    await page.do(rest.set(wanted));
  }
}
export const watch = new Watch();
