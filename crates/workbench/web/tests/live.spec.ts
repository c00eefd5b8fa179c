// Checks of the contract: live.
import { dose, expect, id, open, rowsOf, scan, test } from './sieben';

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

test('11: LITRES begins at 25 and counts down', async ({ page }) => {
  await open(page);
  const cell = id(page, 'stl-row-29').locator('td.num').first();
  // Its value before the dose has come.
  await expect(cell).toHaveText('0');
  const seen = await cell.evaluateHandle((node) => {
    const seen: [number, string][] = [];
    new MutationObserver(() => seen.push([performance.now(), node.textContent ?? ''])).observe(node, { characterData: true, childList: true, subtree: true });
    return seen;
  });
  await dose(page);
  await expect.poll(async () => (await seen.jsonValue()).length).toBeGreaterThan(2);
  const [first, second, third] = await seen.jsonValue();
  expect([first?.[1], second?.[1], third?.[1]]).toEqual(['0025', '0024', '0023']);
  // Ten times the second of the contract.
  expect((second?.[0] ?? Infinity) - (first?.[0] ?? 0)).toBeLessThan(10_000);
});

test('13: a flow meter that is stuck lets the vessel overflow', async ({ page }) => {
  await open(page);
  await dose(page);
  await id(page, 'plant-fault').click();
  await id(page, 'plant-fault-flow-stuck=0').click();
  await expect(id(page, 'plant-faults')).toContainText('flow stuck=0');
  await page.waitForTimeout(300);
  const litres = await id(page, 'stl-row-29').locator('td.num').first().textContent();
  await id(page, 'speed').click();
  await id(page, 'speed-10').click();
  const vessel = async () => Number.parseFloat((await id(page, 'vessel').textContent()) ?? '');
  await expect.poll(vessel, { timeout: 30_000 }).toBeGreaterThan(25);
  await expect(id(page, 'stl-row-29').locator('td.num').first()).toHaveText(litres ?? '');
  await expect(id(page, 'out-0.0')).toHaveAttribute('data-on', '1');
});

test('19: the status word is that of the scan', async ({ page }) => {
  await open(page);
  await dose(page);
  await page.waitForTimeout(500);
  await id(page, 'pause').click();
  await expect(id(page, 'pause')).toContainText('Go on');
  // The last scan arrives.
  await page.waitForTimeout(500);
  const now = await scan(page);
  await id(page, 'step-scan-back').click();
  await expect.poll(() => scan(page)).toBe(now - 1);
  const rows = await rowsOf(page, 'OB1', now - 1, 15);
  const names = ['fc', 'rlo', 'sta', 'or', 'os', 'ov'];
  let compared = 0;
  for (const [line, executed, stw] of rows) {
    if (executed !== 1) continue;
    await id(page, `stl-row-${line}`).click();
    for (const [bit, name] of names.entries()) await expect(id(page, `sw-${name}`).locator('b')).toHaveText(String((stw >> bit) & 1));
    await expect(id(page, 'sw-cc').locator('b')).toHaveText(`${(stw >> 7) & 1}${(stw >> 6) & 1}`);
    await expect(id(page, 'sw-br').locator('b')).toHaveText(String((stw >> 8) & 1));
    compared += 1;
  }
  expect(compared).toBeGreaterThan(10);
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
  await dose(page);
  await expect.poll(() => id(page, 'changes').locator('.t').count()).toBeGreaterThan(4);
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
