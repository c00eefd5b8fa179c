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
