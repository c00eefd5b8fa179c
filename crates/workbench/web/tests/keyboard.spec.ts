// Checks of the contract: everything by keyboard alone.
import { expect, id, open, scan, test, type Page } from './sieben';

/** Presses of Tab that one needs at most to come round the page. */
const ROUND = 400;

/** Goes to an element as one without a mouse does. */
async function tabTo(page: Page, name: string): Promise<void> {
  for (let i = 0; i < ROUND; i += 1) {
    const there = await page.evaluate((wanted) => document.activeElement?.closest(`[data-testid="${wanted}"]`) !== null && document.activeElement !== document.body, name);
    if (there) return;
    await page.keyboard.press('Tab');
  }
  throw new Error(`Tab does not come to ${name}`);
}

test('73: the plant and its inputs by keyboard alone', async ({ page }) => {
  await open(page);
  await tabTo(page, 'in-0.0');
  await page.keyboard.down('Space');
  await expect(id(page, 'in-0.0')).toHaveAttribute('data-on', '1');
  await page.keyboard.up('Space');
  await expect(id(page, 'in-0.0')).toHaveAttribute('data-on', '0');
  await expect(id(page, 'out-0.0')).toHaveAttribute('data-on', '1');
  await tabTo(page, 'in-0.1');
  await page.keyboard.press('Space');
  await expect(id(page, 'out-0.0')).toHaveAttribute('data-on', '0');
  await tabTo(page, 'plant-start');
  await page.keyboard.down('Enter');
  await expect(id(page, 'in-0.0')).toHaveAttribute('data-on', '1');
  await page.keyboard.up('Enter');
  await tabTo(page, 'stl-row-8');
  await page.keyboard.press('ArrowDown');
  await expect(id(page, 'stl-row-9')).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('Shift+F12');
  await expect(id(page, 'xref')).toContainText('EDGE');
});

test('73: time by keyboard alone', async ({ page }) => {
  await open(page);
  await expect.poll(() => scan(page)).toBeGreaterThan(150);
  await page.keyboard.press('Space');
  await expect(id(page, 'pause')).toContainText('Go on');
  await page.keyboard.press('.');
  await expect(page.locator('body')).toHaveAttribute('data-state', 'stepping');
  const first = await id(page, 'reason').textContent();
  await page.keyboard.press('.');
  await expect(id(page, 'reason')).not.toHaveText(first ?? '');
  await page.keyboard.press(',');
  await expect(id(page, 'reason')).toHaveText(first ?? '');
  await page.keyboard.press('n');
  await expect(id(page, 'reason')).not.toHaveText(first ?? '');
  await page.keyboard.press('End');
  const n = await scan(page);
  await page.keyboard.press('<');
  await expect.poll(() => scan(page)).toBeLessThan(n);
  await page.keyboard.press('Home');
  await expect(id(page, 'connection')).toHaveText('Past');
  await page.keyboard.press('End');
  await tabTo(page, 'timeline-track');
  await page.keyboard.press('ArrowLeft');
  await expect(id(page, 'connection')).toHaveText('Past');
  await page.keyboard.press('End');
  await page.keyboard.press('Space');
  await expect(id(page, 'connection')).toHaveText('Live');
  await tabTo(page, 'mode-stop');
  await page.keyboard.press('Enter');
  await expect(id(page, 'led-stop')).toHaveAttribute('data-on', '1');
  await tabTo(page, 'mode-run');
  await page.keyboard.press('Enter');
  await expect(id(page, 'connection')).toHaveText('Live');
});

test('73: views, values, forcing and the palette by keyboard alone', async ({ page }) => {
  await open(page);
  for (const [letter, part] of [['p', 'program'], ['s', 'symbols-table'], ['c', 'diagnostic-buffer'], ['w', 'watch']] as const) {
    await page.keyboard.press('g');
    await page.keyboard.press(letter);
    await expect(id(page, part)).toBeVisible();
  }
  await tabTo(page, 'watch-tick-C0');
  await page.keyboard.press('Space');
  await page.keyboard.press('Tab');
  await page.keyboard.type('12');
  await page.keyboard.press('Control+F9');
  await expect(id(page, 'watch-value-C0')).toContainText('12');
  await tabTo(page, 'watch-force-I0.1');
  await page.keyboard.press('Enter');
  const dialog = page.getByRole('dialog');
  await expect(dialog).toBeVisible();
  await tabTo(page, 'force-dialog-value');
  await page.keyboard.type('0');
  await page.keyboard.press('Tab');
  await page.keyboard.type('a broken wire');
  await page.keyboard.press('Enter');
  await expect(id(page, 'force-I0.1')).toContainText('a broken wire');
  await tabTo(page, 'force-release-I0.1');
  await page.keyboard.press('Enter');
  await expect(id(page, 'force-I0.1')).toHaveCount(0);
  await tabTo(page, 'trigger');
  await page.keyboard.type('VALVE rises');
  await page.keyboard.press('Enter');
  await expect(id(page, 'trigger-state')).toBeVisible();
  await page.keyboard.press('Control+k');
  await expect(id(page, 'palette-input')).toBeFocused();
  await page.keyboard.type('OB1');
  await page.keyboard.press('Enter');
  await expect(id(page, 'program')).toBeVisible();
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toHaveCount(0);
  for (const view of ['view-lad', 'view-fbd', 'view-stl']) {
    await tabTo(page, view);
    await page.keyboard.press('Enter');
    await expect(id(page, view)).toHaveAttribute('aria-pressed', 'true');
  }
});

/** The panel that has the focus. */
const panel = (page: Page) => page.evaluate(() => document.activeElement?.closest<HTMLElement>('.panel')?.dataset['testid'] ?? '');

test('73: F6 goes from panel to panel, Shift F6 back', async ({ page }) => {
  await open(page);
  for (const [view, names] of [['l', ['plant', 'io-rack', 'program', 'inspector']], ['p', ['block-tree', 'program', 'inspector']], ['w', ['watch', 'force-list', 'timing']], ['s', ['call-structure', 'assignment', 'symbols', 'xref']], ['c', ['diagnostic-buffer', 'event', 'communications', 'module-info']]] as const) {
    await page.evaluate(() => document.activeElement instanceof HTMLElement && document.activeElement.blur());
    await page.keyboard.press('g');
    await page.keyboard.press(view);
    await expect(id(page, names.at(-1) ?? '')).toBeVisible();
    await page.waitForTimeout(300);
    const seen: string[] = [];
    for (let i = 0; i < names.length; i += 1) {
      await page.keyboard.press('F6');
      seen.push(await panel(page));
    }
    expect(seen).toEqual(names);
    await page.keyboard.press('Shift+F6');
    expect(await panel(page)).toBe(names.at(-2));
  }
});

test('73: t, w and f are about the selected operand', async ({ page }) => {
  await open(page);
  const announced = id(page, 'toast');
  await id(page, 'stl-row-8').click();
  for (const value of ['1', '0']) {
    await page.keyboard.press('t');
    await expect(id(page, 'in-0.0')).toHaveAttribute('data-on', value);
  }
  await page.keyboard.press('w');
  await expect(announced).toContainText('is in the watch table');
  await page.keyboard.press('f');
  await expect(id(page, 'force-dialog')).toContainText('I 0.0');
  await page.keyboard.press('Escape');
  // An output is no input, and a counter cannot be forced: the page says so.
  await id(page, 'stl-row-21').click();
  await page.keyboard.press('t');
  await expect(announced).toContainText('Select a statement with an input');
  await id(page, 'stl-row-29').click();
  await page.keyboard.press('f');
  await expect(announced).toContainText('forces inputs and outputs only');
  await expect(id(page, 'force-dialog')).toHaveCount(0);
  // Where there is no rack in sight it is the same.
  await id(page, 'stl-row-8').click();
  await page.keyboard.press('g');
  await page.keyboard.press('p');
  await expect(id(page, 'block-tree')).toBeVisible();
  for (const value of ['1', '0']) {
    await page.keyboard.press('t');
    await expect.poll(() => bit(page, 'I 0.0')).toBe(value);
  }
  await page.keyboard.press('g');
  await page.keyboard.press('w');
  await expect(id(page, 'watch-remove-I0.0')).toBeVisible();
});

/** A bit as the server has it. */
const bit = async (page: Page, address: string) => String(((await (await page.request.get(`/api/v1/tags?names=${encodeURIComponent(address)}`)).json()) as { items: { value: number }[] }).items[0]?.value);

test('73: g and a letter leads to a view from a row of the rack too', async ({ page }) => {
  await open(page);
  await tabTo(page, 'in-0.1');
  await page.keyboard.press('g');
  await page.keyboard.press('w');
  await expect(id(page, 'watch')).toBeVisible();
});

test('73: t of a row of the rack switches it, m changes the mnemonics, ? shows all keys', async ({ page }) => {
  await open(page);
  await tabTo(page, 'in-0.1');
  await page.keyboard.press('t');
  await expect(id(page, 'in-0.1')).toHaveAttribute('data-on', '0');
  await page.keyboard.press('t');
  await expect(id(page, 'in-0.1')).toHaveAttribute('data-on', '1');
  const op = id(page, 'stl-row-8').locator('td.op');
  await expect(op).toHaveText('A');
  await page.keyboard.press('m');
  await expect(op).toHaveText('U');
  await page.keyboard.press('m');
  await expect(op).toHaveText('A');
  await page.keyboard.press('?');
  for (const key of ['Space', '.', ',', '>', '<', 'n', 'N', 'End', 'Home', 'g', 'F6', 'F1', 'F12', 't', 'w', 'f', 'm', 'F9']) await expect(id(page, 'keys').locator('kbd', { hasText: new RegExp(`^${key.replace('.', '\\.').replace('?', '\\?')}$`) }).first(), key).toBeVisible();
});

test('73: F1, F12 and Shift F12 lead to the book, to the definition and to where it is used', async ({ page, context }) => {
  await open(page);
  await id(page, 'stl-row-21').click();
  const [book] = await Promise.all([context.waitForEvent('page'), page.keyboard.press('F1')]);
  await expect(book).toHaveURL(/\/docs\/reference\/instructions#R$/);
  await expect(book.locator('code[id="R"]')).toBeInViewport();
  await book.close();
  await page.keyboard.press('F12');
  await expect(id(page, 'symbol-VALVE').getByRole('button')).toBeFocused();
  await page.keyboard.press('g');
  await page.keyboard.press('l');
  await id(page, 'stl-row-21').click();
  await page.keyboard.press('Shift+F12');
  await expect(id(page, 'xref-0')).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(id(page, 'block-tree')).toBeVisible();
});

test.describe('with a call', () => {
  test.use({ example: 'star-delta' });
  test('73: F12 on a call opens the block', async ({ page }) => {
    await open(page, '#program/OB1');
    await id(page, 'view-stl').click();
    await page.locator('tr.st', { hasText: 'CALL' }).first().click();
    await page.keyboard.press('F12');
    await expect(page).toHaveURL(/#program\/FB20/);
    await expect(id(page, 'tree-FB20')).toHaveAttribute('aria-current', 'true');
  });
});
