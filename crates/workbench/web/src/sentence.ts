/** What just changed, in one sentence: at most three changes, the cause first. */
import { page } from './state.svelte';
import type { Change } from './wire';
import { count, t } from './words.svelte';

/** Parts of the sentence; `b` = a name. */
export type Part = { text: string; b?: true };

const NAMED = 3;

function verb(change: Change): string {
  const from = Number(change.from.replace(/^\D*#/, ''));
  const to = Number(change.to.replace(/^\D*#/, ''));
  if (/^[CZ] /.test(change.address) && Math.abs(to - from) === 1) return t('counted', to < from ? t('down') : t('up'), from, to);
  return t('became', short(change.to));
}

/** Without what is said in brackets behind it. */
export const short = (value: string): string => value.replace(/ \(.*\)$/, '');

/** What comes from outside first, then counters, then what else the program wrote. */
const order = (change: Change): number => (/^P?I/.test(change.address) ? 0 : /^C /.test(change.address) ? 1 : 2);

/** The sentence about the newest changes up to a scan. */
export function sentence(changes: Change[], scan: number): Part[] {
  const newest = changes.find((change) => change.n <= scan);
  if (newest === undefined) return [{ text: t('nothingYet') }];
  if (newest.note !== undefined) return [{ text: `${t('scan')} ${count(newest.n)}: ${newest.note}.` }];
  const together = changes.filter((change) => change.n === newest.n && change.note === undefined).reverse().sort((a, b) => order(a) - order(b));
  const parts: Part[] = [{ text: `${t('scan')} ${count(newest.n)}: ` }];
  const named = together.slice(0, NAMED);
  named.forEach((change, i) => {
    const before = named[i - 1];
    if (before !== undefined) {
      const cause = order(before) === 0 && order(change) > 0;
      parts.push({ text: cause ? t('so') : i === named.length - 1 && together.length <= NAMED ? t('and') : t('comma') });
    }
    parts.push({ text: change.name === '' ? page.spell(change.address) : change.name, b: true });
    parts.push({ text: ` ${verb(change)}${change.by !== undefined ? ` (${t('placeNetwork', change.by.network)})` : ''}` });
  });
  if (together.length > NAMED) parts.push({ text: t('andMore', together.length - NAMED) });
  parts.push({ text: '.' });
  return parts;
}
