/** Keys of the page: single letters while no text is typed. RUN, STOP and MRES have none. */
import { rest } from './rest';
import { named } from './names';
import { added } from './watch/added.svelte';
import { route, type View } from './route.svelte';
import { page } from './state.svelte';
import { t, type Word } from './words.svelte';

let prefix = -Infinity;

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
  if (next === undefined) return;
  const seen = (within: string) => [...next.querySelectorAll<HTMLElement>(`${within} :is(button:not([disabled]), a, input:not([disabled]), [tabindex="0"])`)].find((node) => node.checkVisibility());
  const first = seen('.pb') ?? next.querySelector<HTMLElement>('.pb[tabindex="0"]') ?? seen('') ?? next;
  if (first === next) next.tabIndex = -1;
  first.focus();
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
  { keys: ['F12'], word: 'kDefinition', group: 'kSelection', match: ['F12'], run: () => definition() },
  { keys: ['F1'], word: 'kHelp', group: 'kSelection', match: ['F1'], run: () => window.open(help(), '_blank', 'noopener') },
  { keys: ['Ctrl', 'F9'], word: 'kModify', group: 'kSelection', match: ['Ctrl F9'], run: () => document.querySelector<HTMLElement>('[data-testid=watch-modify]')?.click() },
  { keys: ['?'], word: 'keys', group: 'kPages', match: ['?'], run: () => (page.dialog = 'keys') },
];

/** The book, at the instruction that is selected. */
export const help = (): string => {
  const language = page.blocks.find((block) => block.block === page.selected?.block)?.language;
  return page.selected === null ? '/docs/' : language === 'STL' ? `/docs/reference/instructions#${encodeURIComponent(page.selected.op)}` : '/docs/reference/st-library';
};

export async function toggle(address = page.selected?.address ?? ''): Promise<void> {
  if (!/^I \d+\.\d$/.test(address)) return page.say(t('selectInput'));
  if (page.locked !== '') return page.say(page.locked);
  await page.do(rest.bit(address).then((on) => rest.set({ [address]: !on })));
}

export function addToWatch(address: string): void {
  if (address === '') return page.say(t('selectOperand'));
  added.add(address);
  page.say(t('added', page.nameOf(address)));
}

/** A CPU 3xx forces inputs and outputs, a CPU 4xx bit memory too. */
export const canForce = (address: string): boolean => (page.cpu.startsWith('4') ? /^[IQM]/ : /^[IQ]/).test(address);
export const forcesOnly = (): string => t(page.cpu.startsWith('4') ? 'forces400' : 'forces300', page.cpu);

export function force(address: string): void {
  if (address === '') return page.say(t('selectOperand'));
  if (page.locked !== '') return page.say(page.locked);
  if (!canForce(address)) return page.say(forcesOnly());
  page.forceWanted = address;
  page.dialog = 'force';
}

export function whereUsed(address = page.selected?.address ?? ''): void {
  if (address === '') return page.say(t('selectOperand'));
  route.go('symbols', address, 'uses');
}

/** Where the selected operand is declared: a block is opened, an address is shown in the symbol table. */
function definition(): void {
  const operand = page.selected?.operand ?? '';
  const name = /^"([^"]*)"|^\w+ \d+/.exec(operand);
  const block = page.blocks.find((one) => name !== null && (name[1] === undefined ? named(one.block) === name[0] : one.symbol === name[1]));
  if (block !== undefined) return route.go('program', block.block);
  const address = page.selected?.address ?? '';
  if (address !== '') return route.go('symbols', address);
  page.say(t('selectOperand'));
}

/** The key before this one was `g`: the next names a view. */
export const isPrefixed = (): boolean => performance.now() - prefix < 1500;

export function press(event: KeyboardEvent): void {
  const target = event.target as HTMLElement;
  const typing = target.matches('input:not([type=checkbox]), textarea, select, [contenteditable]');
  const name = `${event.ctrlKey || event.metaKey ? 'Ctrl ' : ''}${event.shiftKey && event.key.length > 1 ? 'Shift ' : ''}${event.ctrlKey ? event.key.toLowerCase().replace(/^f9$/, 'F9') : event.key}`;
  if (typing && !name.startsWith('Ctrl ') && !/^(Shift )?F\d/.test(name)) return;
  if (name === ' ' && target.matches('button, a, [role=button], [role=switch], [role=tab], input')) return;
  if (event.altKey) return;
  const wanted = isPrefixed() ? `g ${event.key}` : name;
  if (name === 'g') {
    prefix = performance.now();
    return;
  }
  prefix = -Infinity;
  const key = KEYS.find((one) => one.match.includes(wanted)) ?? KEYS.find((one) => one.match.includes(name));
  if (key === undefined) return;
  event.preventDefault();
  key.run(event);
}
