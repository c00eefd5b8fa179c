/** Keys of the page: single letters while no text is typed. RUN, STOP and MRES have none. */
import { rest } from './rest';
import { added, keepAdded } from './watch/added';
import { route, type View } from './route.svelte';
import { page } from './state.svelte';
import { t, type Word } from './words.svelte';

let prefix = 0;

interface Key {
  /** As it is shown. */
  keys: string[];
  word: Word;
  group: Word;
  /** `event.key`, or `g x`. */
  match: string[];
  run: (event: KeyboardEvent) => void;
}

const view = (letter: string, to: View): Key => ({ keys: ['g', letter], word: to, group: 'kPages', match: [`g ${letter}`], run: () => route.go(to) });

const panels = (by: 1 | -1): void => {
  const all = [...document.querySelectorAll<HTMLElement>('.main .panel')].filter((p) => p.offsetParent !== null);
  const at = all.findIndex((p) => p.contains(document.activeElement));
  const next = all[(at + by + all.length) % all.length];
  next?.querySelector<HTMLElement>('.pb button:not([disabled]), .pb [tabindex], button:not([disabled]), a, input')?.focus();
};

export const KEYS: Key[] = [
  { keys: ['Space'], word: 'kPause', group: 'kTime', match: [' '], run: () => void page.pause() },
  { keys: ['.', ','], word: 'kStatement', group: 'kTime', match: ['.', ','], run: (e) => page.step('statement', e.key === '.' ? 1 : -1) },
  { keys: ['>', '<'], word: 'kScan', group: 'kTime', match: ['>', '<'], run: (e) => page.step('scan', e.key === '>' ? 1 : -1) },
  { keys: ['n', 'N'], word: 'kNetwork', group: 'kTime', match: ['n', 'N'], run: (e) => page.step('network', e.key === 'n' ? 1 : -1) },
  { keys: ['End'], word: 'kLive', group: 'kTime', match: ['End'], run: () => page.goTo('live') },
  { keys: ['Home'], word: 'kOldest', group: 'kTime', match: ['Home'], run: () => page.goTo(page.oldest) },
  view('l', 'live'),
  view('p', 'program'),
  view('w', 'watch'),
  view('s', 'symbols'),
  view('c', 'cpu'),
  { keys: ['Ctrl', 'K'], word: 'kPalette', group: 'kPages', match: ['Ctrl k'], run: () => (page.dialog = 'palette') },
  { keys: ['F6'], word: 'kPanel', group: 'kPages', match: ['F6', 'Shift F6'], run: (e) => panels(e.shiftKey ? -1 : 1) },
  { keys: ['t'], word: 'kToggle', group: 'kSelection', match: ['t'], run: () => void toggle() },
  { keys: ['w'], word: 'kWatch', group: 'kSelection', match: ['w'], run: () => addToWatch(page.selected?.address ?? '') },
  { keys: ['f'], word: 'kForce', group: 'kSelection', match: ['f'], run: () => force(page.selected?.address ?? '') },
  { keys: ['m'], word: 'kMnemonics', group: 'kSelection', match: ['m'], run: () => page.setMnemonics(page.mnemonics === 'de' ? 'en' : 'de') },
  { keys: ['Shift', 'F12'], word: 'kUsed', group: 'kSelection', match: ['Shift F12'], run: () => whereUsed() },
  { keys: ['F12'], word: 'kDefinition', group: 'kSelection', match: ['F12'], run: () => whereUsed() },
  { keys: ['F1'], word: 'kHelp', group: 'kSelection', match: ['F1'], run: () => window.open(page.selected === null ? '/docs/' : `/docs/reference/instructions#${page.selected.op.toLowerCase()}`, '_blank', 'noopener') },
  { keys: ['Ctrl', 'F9'], word: 'kModify', group: 'kSelection', match: ['Ctrl F9'], run: () => document.querySelector<HTMLElement>('[data-testid=watch-modify]')?.click() },
  { keys: ['?'], word: 'keys', group: 'kPages', match: ['?'], run: () => (page.dialog = 'keys') },
];

export async function toggle(): Promise<void> {
  const address = page.selected?.address ?? '';
  if (!/^[IE] \d+\.\d$/.test(address) || page.locked !== '') return;
  const id = address.replace(/^[IE] /, '');
  const row = document.querySelector<HTMLElement>(`[data-testid="in-${id}"]`);
  await page.do(rest.set({ [address]: row?.dataset['on'] !== '1' }));
}

export function addToWatch(address: string): void {
  if (address === '') return;
  const before = added();
  if (!before.includes(address)) keepAdded([...before, address]);
  page.say(t('added', page.nameOf(address)));
}

export function force(address: string): void {
  if (address === '' || page.locked !== '') return;
  page.forceWanted = address;
  page.dialog = 'force';
}

export function whereUsed(address = page.selected?.address ?? ''): void {
  if (address !== '') route.go('symbols', address);
}

export function press(event: KeyboardEvent): void {
  const target = event.target as HTMLElement;
  const typing = target.matches('input:not([type=checkbox]), textarea, select, [contenteditable]');
  const name = `${event.ctrlKey || event.metaKey ? 'Ctrl ' : ''}${event.shiftKey && event.key.length > 1 ? 'Shift ' : ''}${event.ctrlKey ? event.key.toLowerCase().replace(/^f9$/, 'F9') : event.key}`;
  if (typing && !name.startsWith('Ctrl ') && !/^(Shift )?F\d/.test(name)) return;
  if (name === ' ' && target.matches('button, a, [role=button], [role=switch], [role=tab], input')) return;
  if (event.altKey) return;
  const wanted = performance.now() - prefix < 1500 ? `g ${event.key}` : name;
  if (name === 'g') {
    prefix = performance.now();
    return;
  }
  prefix = 0;
  const key = KEYS.find((one) => one.match.includes(wanted)) ?? KEYS.find((one) => one.match.includes(name));
  if (key === undefined) return;
  event.preventDefault();
  key.run(event);
}
