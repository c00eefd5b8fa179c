// Checks of the contract: live.
import { expect, id, open, scan, test } from './sieben';

test('1–7: it opens live, without an error', async ({ page }) => {
  const wrong = await open(page);
  for (const part of ['plant', 'io-rack', 'program', 'inspector', 'timeline']) await expect(id(page, part)).toBeVisible();
  const before = await scan(page);
  await expect.poll(() => scan(page)).toBeGreaterThan(before);
  await expect(id(page, 'led-run')).toHaveAttribute('data-on', '1');
  await expect(id(page, 'led-stop')).toHaveAttribute('data-on', '0');
  await expect(page).toHaveTitle('dosing · RUN · Sieben');
  for (const view of ['program', 'watch', 'symbols', 'cpu', 'live']) {
    await id(page, `nav-${view}`).click();
    await page.waitForTimeout(300);
  }
  expect(wrong).toEqual([]);
});

test('8: another example without a page load', async ({ page }) => {
  await open(page);
  await page.evaluate(() => Object.assign(window, { same: true }));
  await id(page, 'project-menu').click();
  await id(page, 'project-menu-star-delta').click();
  await id(page, 'nav-program').click();
  await expect(id(page, 'tree-FB20')).toBeVisible();
  expect(await page.evaluate(() => 'same' in window)).toBe(true);
});

test('9, 10, 12: inputs are pressed and switched, the program answers', async ({ page }) => {
  await open(page);
  const button = id(page, 'in-0.0').getByRole('button');
  await button.hover();
  await page.mouse.down();
  await expect(id(page, 'in-0.0')).toHaveAttribute('data-on', '1');
  await expect(id(page, 'stl-row-8')).toHaveAttribute('data-sta', '1');
  await page.mouse.up();
  await expect(id(page, 'in-0.0')).toHaveAttribute('data-on', '0');
  await expect(id(page, 'stl-row-8')).toHaveAttribute('data-sta', '0');
  await expect(id(page, 'out-0.0')).toHaveAttribute('data-on', '1');
  await expect(id(page, 'plant-picture')).toContainText('open');
  await expect(id(page, 'sentence')).toContainText('LITRES counted down');
  await id(page, 'stl-row-21').click();
  await id(page, 'in-0.1').getByRole('switch').click();
  await expect(id(page, 'out-0.0')).toHaveAttribute('data-on', '0');
  await expect(id(page, 'reason')).toHaveText('The RLO is 1, so Q 0.0 "VALVE" is reset to 0.');
});

test('14–18: rows stay, the reason and who', async ({ page }) => {
  await open(page);
  const row = await id(page, 'stl-row-17').elementHandle();
  await page.waitForTimeout(3000);
  expect(await row?.evaluate((node) => node.isConnected)).toBe(true);
  await row?.click();
  await expect(id(page, 'stl-row-17')).toHaveAttribute('aria-selected', 'true');
  await id(page, 'stl-row-15').click();
  for (const text of ['A', 'I 0.7', 'FLOW']) await expect(id(page, 'inspector')).toContainText(text);
  await id(page, 'stl-row-12').click();
  await id(page, 'who').click();
  await expect(id(page, 'who-answer')).toContainText(/OB 1.*line \d+.*scan \d+/);
  const scans = await id(page, 'changes').locator('.t').allTextContents();
  const numbers = scans.map((text) => Number(text.replace(/\D/g, '')));
  expect(numbers).toEqual([...numbers].sort((a, b) => b - a));
});

test('17: where used lists four places of Q 0.0', async ({ page }) => {
  await open(page);
  await id(page, 'stl-row-12').click();
  await id(page, 'where-used').click();
  await expect(id(page, 'xref')).toContainText('VALVE');
  await expect(id(page, 'xref').locator('[data-testid^=xref-]')).toHaveCount(4);
});

test('20: a column is hidden and stays so', async ({ page }) => {
  await open(page);
  await expect(page.getByRole('columnheader', { name: 'ACCU 2' })).toBeVisible();
  await id(page, 'columns').click();
  await id(page, 'columns-accu2').click();
  await expect(page.getByRole('columnheader', { name: 'ACCU 2' })).toHaveCount(0);
  await page.reload();
  await expect(id(page, 'stl-row-8')).toBeVisible();
  await expect(page.getByRole('columnheader', { name: 'ACCU 2' })).toHaveCount(0);
});
