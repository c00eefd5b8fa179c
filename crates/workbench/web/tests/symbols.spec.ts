// Checks of the contract: symbols.
import { expect, id, open, OWN, test } from './sieben';

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

test.describe('in German mnemonics', () => {
  test.use({ example: 'star-delta' });
  test('what is used is shown, and local data are those of the CPU', async ({ page, request }) => {
    await open(page, '#symbols');
    const assignment = id(page, 'assignment');
    await expect(assignment).toContainText('EB 8');
    await expect(assignment.locator('b.x')).toHaveCount(14);
    await expect(assignment.getByTitle('E 8.0', { exact: true })).toHaveText('×');
    const { local_data } = (await (await request.get('/api/v1/info')).json()) as { local_data: number };
    await expect(id(page, 'call-structure')).toContainText(`of ${local_data.toLocaleString('en-GB')} bytes`);
    await expect(id(page, 'symbol-LineOn')).toContainText('E 0.0');
    await id(page, 'symbols-filter').fill('a 8.1');
    await expect(id(page, 'symbols-count')).toHaveText('1 of 19');
    await id(page, 'symbol-RunLamp').click();
    await expect(id(page, 'xref-0')).toBeVisible();
    // The other way: addresses follow the mnemonics.
    await id(page, 'mnemonics').click();
    await id(page, 'symbols-filter').fill('');
    await expect(id(page, 'symbol-RunLamp')).toContainText('Q 8.1');
    await expect(assignment).toContainText('IB 8');
  });
});

test.describe('with a program that uses a thousand bytes', () => {
  test.use({
    example: OWN,
    files: { 'sieben.toml': '[project]\nname = "own"\nmnemonics = "en"\n', 'main.awl': `ORGANIZATION_BLOCK OB 1\nBEGIN\n${Array.from({ length: 1000 }, (_, i) => ` L MB ${i};`).join('\n')}\nEND_ORGANIZATION_BLOCK\n` },
  });
  test('the assignment shows so many of them, and more when they are wanted', async ({ page }) => {
    await open(page, '#symbols');
    const rows = id(page, 'assignment').locator('.asg .l');
    await expect(rows).toHaveCount(128);
    await expect(id(page, 'assignment-more')).toHaveText('… and 872 more bytes');
    await id(page, 'assignment-more').click();
    await expect(rows).toHaveCount(256);
  });
});
