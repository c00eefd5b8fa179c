/** The rail in the RLO column: which statements of a block belong to one logic string. Data: the status words, nothing else. */
import { bit, STW } from './state.svelte';

const CHECKS = new Set(['A', 'AN', 'O', 'ON', 'X', 'XN', 'U', 'UN', 'A(', 'AN(', 'O(', 'ON(', 'X(', 'XN(', 'U(', 'UN(']);
const USERS = new Set([...CHECKS, ')', '=', 'S', 'R', 'FP', 'FN', 'NOT', 'SET', 'CLR', 'SAVE', 'SP', 'SE', 'SD', 'SS', 'SF', 'SI', 'SV', 'SA', 'FR', 'CU', 'CD', 'ZV', 'ZR', 'JC', 'JCN', 'JCB', 'JNB', 'SPB', 'SPBN', 'SPBB', 'SPBNB', 'BEC', 'BEB', 'CC']);

export interface Wire {
  /** Above, below: 1, 0 or nothing. */
  up: 0 | 1 | null;
  down: 0 | 1 | null;
  dot: boolean;
}

export interface RailRow {
  op: string;
  executed: 0 | 1 | 2;
  stw: number;
}

/** How the rail looks at a statement; `at` gives a statement by its place, nothing beyond the ends. */
export function wire(at: (index: number) => RailRow | undefined, index: number): Wire {
  const row = at(index);
  if (row === undefined || row.executed === 0) return { up: null, down: null, dot: false };
  const before = at(index - 1);
  const uses = USERS.has(row.op);
  const begins = before === undefined || before.executed === 0 || (CHECKS.has(row.op) && bit(before.stw, STW.FC) === 0);
  let last = true;
  for (let i = index + 1; i < index + 12; i += 1) {
    const next = at(i);
    const previous = at(i - 1);
    if (next === undefined || previous === undefined || next.executed === 0) break;
    if (CHECKS.has(next.op) && bit(previous.stw, STW.FC) === 0) break;
    if (USERS.has(next.op)) {
      last = false;
      break;
    }
  }
  if (!uses && last) return { up: null, down: null, dot: false };
  return { up: begins ? null : bit(before.stw, STW.RLO), down: last ? null : bit(row.stw, STW.RLO), dot: uses };
}

/** ACCU as the columns write it: hexadecimal, the upper half only where it is not 0. */
export function accu(value: number): string {
  const unsigned = value >>> 0;
  if (unsigned === 0) return '0';
  const text = unsigned.toString(16).toUpperCase().padStart(8, '0');
  return text.startsWith('0000') ? text.slice(4) : text;
}
