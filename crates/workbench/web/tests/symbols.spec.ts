// Checks of the contract: symbols.
import { expect, id, open, test } from './sieben';

test.use({ example: 'tank' });

test('65: a filter leaves what is called so', async ({ page }) => {
  await open(page, '#symbols');
  await id(page, 'symbols-filter').fill('over');
  await expect(id(page, 'symbols-count')).toHaveText('2 of 25');
  await expect(id(page, 'symbol-Overflow')).toBeVisible();
});

test('68: what nothing uses is marked', async ({ page }) => {
  await open(page, '#symbols');
  await expect(id(page, 'symbol-InletOpen')).toContainText('unused');
  await expect(id(page, 'symbol-Overflow')).not.toContainText('unused');
});

test('67: it is printed without what one presses, on A4 landscape', async ({ page }) => {
  await open(page, '#symbols');
  await expect(id(page, 'symbol-InletOpen')).toBeVisible();
  await page.emulateMedia({ media: 'print' });
  for (const part of ['nav-live', 'strip', 'timeline', 'xref', 'symbols-filter', 'symbols-print', 'assignment']) await expect(id(page, part), part).not.toBeVisible();
  await expect(page.locator('.print-only')).toContainText('tank');
  const pdf = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
  const sizes = [...pdf.matchAll(/\/MediaBox \[\s*0 0 ([\d.]+) ([\d.]+)/g)].map((box) => [Math.round(Number(box[1])), Math.round(Number(box[2]))]);
  expect(sizes.length, 'all rows, on few pages').toBeLessThanOrEqual(3);
  for (const size of sizes) expect(size).toEqual([842, 595]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(1440);
});
