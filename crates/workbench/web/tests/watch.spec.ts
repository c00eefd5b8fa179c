// Checks of the contract: watch.
import { dose, expect, id, open, scan, test, type Page } from './sieben';

/** Rows of the largest table that is tried. */
const MANY = 10_000;

/** Forces a value as a person does. */
async function force(page: Page, name: string, value: string, reason: string): Promise<void> {
  await id(page, 'force-address').fill(name);
  await id(page, 'force-value').fill(value);
  await id(page, 'force-add').click();
  const dialog = page.getByRole('dialog');
  await expect(dialog.getByLabel('Value')).toHaveValue(value);
  await dialog.getByLabel('Reason').fill(reason);
  await dialog.getByRole('button', { name: /^Force/ }).click();
}

test('49: a row by its symbol has the address', async ({ page }) => {
  await open(page, '#watch');
  await expect(id(page, 'watch-row-C0')).toBeVisible();
  const before = await id(page, 'watch-row-C0').count();
  await id(page, 'watch-add').fill('LITRES');
  await id(page, 'watch-add').press('Enter');
  await expect(id(page, 'watch-row-C0')).toHaveCount(before + 1);
  await expect(id(page, 'watch-row-C0').last()).toContainText('C 0');
  await id(page, 'watch-add').fill('q0.0');
  await id(page, 'watch-add').press('Enter');
  await expect(id(page, 'watch-row-Q0.0').last()).toContainText('VALVE');
});

test('50: what is ticked is written once', async ({ page, request }) => {
  await open(page, '#watch');
  const row = id(page, 'watch-row-C0').first();
  await row.getByTestId('watch-new-C0').fill('7');
  await row.getByTestId('watch-tick-C0').check();
  let written = 0;
  page.on('request', (one) => one.method() === 'PATCH' && (written += 1));
  await id(page, 'watch-modify').click();
  await expect(row.getByTestId('watch-value-C0')).toContainText('7');
  expect(written).toBe(1);
  // Another writer has the last word: nothing writes the 7 again.
  expect((await request.patch('/api/v1/tags', { data: { 'C 0': 3 } })).ok()).toBe(true);
  await expect(row.getByTestId('watch-value-C0')).toContainText('3');
  await page.waitForTimeout(500);
  await expect(row.getByTestId('watch-value-C0')).toContainText('3');
  expect(written).toBe(1);
});

test('51–53: a force is seen by every page, with what the terminal has, until it is released', async ({ page, context }) => {
  await open(page, '#watch');
  const other = await context.newPage();
  await open(other, '#watch');
  // Without the force the program sees the terminal: 0 from here on.
  await page.request.patch('/api/v1/tags', { data: { 'I 0.1': false } });
  await expect(id(page, 'watch-value-I0.1').first()).toHaveText(/^\s*(0|FALSE)\s*$/);
  await force(page, 'STOP', '1', 'wire broken');
  await expect(id(page, 'force-I0.1')).toContainText('wire broken');
  await expect(id(other, 'force-I0.1')).toContainText('wire broken', { timeout: 5000 });
  for (const one of [page, other]) {
    await expect(id(one, 'led-frce')).toHaveAttribute('data-on', '1');
    await expect(id(one, 'watch-row-I0.1').first()).toHaveClass(/forced/);
    await expect(id(one, 'watch-row-I0.1').first()).toContainText('forced');
  }
  const [sees, terminal] = await id(page, 'force-I0.1').locator('dd').allTextContents();
  expect([sees?.trim(), terminal?.trim()]).toEqual(['1', '0']);
  await id(page, 'force-release-I0.1').click();
  await expect(id(page, 'force-I0.1')).toHaveCount(0);
  for (const one of [page, other]) await expect(id(one, 'led-frce')).toHaveAttribute('data-on', '0');
});

test('54: a 315 offers to force inputs and outputs alone', async ({ page }) => {
  await open(page, '#watch');
  await expect(id(page, 'watch-force-I0.1').first()).toBeVisible();
  await expect(id(page, 'watch-row-C0').first()).toBeVisible();
  await expect(id(page, 'watch-force-C0')).toHaveCount(0);
});

test('55: a trigger names the scan in which it came', async ({ page, request }) => {
  await open(page, '#watch');
  await id(page, 'trigger').fill('VALVE rises');
  await id(page, 'trigger').press('Enter');
  await expect(id(page, 'trigger-state')).toHaveText('waits for VALVE rises');
  await request.patch('/api/v1/tags', { data: { 'I 0.0': true } });
  await expect(id(page, 'trigger-state')).toHaveText(/^triggered in scan [\d,]+$/);
  const n = Number((await id(page, 'trigger-state').textContent())?.replace(/\D/g, ''));
  const trace = await (await request.get(`/api/v1/trace?from=${n - 1}&to=${n}&channels=VALVE&format=csv`)).text();
  expect(trace.trim().split('\n').slice(1).map((row) => row.split(',').pop()?.trim())).toEqual(['0', '1']);
});

test('56: the cursor of the timing diagram moves the whole page', async ({ page, request }) => {
  await open(page);
  await dose(page);
  await page.waitForTimeout(2500);
  await id(page, 'nav-watch').click();
  const box = (await id(page, 'timing').locator('.trend svg').boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  await page.mouse.click(box.x + box.width - 60, box.y + 60);
  await expect(id(page, 'connection')).toHaveText('Past');
  const n = Number(/scan ([\d,]+)/.exec((await id(page, 'timing-foot').textContent()) ?? '')?.[1]?.replace(/,/g, ''));
  await id(page, 'nav-live').click();
  await expect.poll(() => scan(page)).toBe(n);
  const trace = await (await request.get(`/api/v1/trace?from=${n}&to=${n}&channels=FLOW&format=csv`)).text();
  await expect(id(page, 'in-0.7')).toHaveAttribute('data-on', trace.trim().split('\n')[1]?.split(',').pop()?.trim() ?? '');
  await expect(id(page, 'plant-picture')).toContainText('open');
});

test.describe('a large table', () => {
  test.use({ files: { 'big.watch': `name,format,comment\n${Array.from({ length: MANY }, (_, i) => `M ${Math.floor(i / 8) % 2000}.${i % 8},BOOL,row ${i + 1}`).join('\n')}\n` } });
  test('58: ten thousand rows, a hundred in the page', async ({ page }) => {
    await open(page, '#watch/big.watch');
    await expect(id(page, 'watch-table')).toHaveAttribute('aria-rowcount', String(MANY + 1));
    expect(await id(page, 'watch-table').locator('tbody tr').count()).toBeLessThanOrEqual(100);
    await page.locator('.vat-panel .pb').evaluate((node) => (node.scrollTop = 100_000));
    await expect(page.locator('.vat-panel tr[aria-rowindex="3575"]')).toBeAttached();
    await expect(page.locator('.vat-panel tr[aria-rowindex="3575"]')).toContainText('row 3574');
  });
});
