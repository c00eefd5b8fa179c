// Checks of the contract: time.
import { dose, expect, id, open, scan, test } from './sieben';

test('22: statements and networks are stepped through, on and back', async ({ page }) => {
  await open(page);
  await dose(page);
  await id(page, 'pause').click();
  await expect(id(page, 'pause')).toContainText('Go on');
  const now = async () => `${await page.locator('tr.cur').getAttribute('data-testid')} ${await id(page, 'reason').textContent()}`;
  const step = async (key: string) => {
    const before = await page.locator('tr.cur').count() === 0 ? '' : await now();
    await page.keyboard.press(key);
    await expect(page.locator('tr.cur')).toHaveCount(1);
    await expect.poll(now).not.toBe(before);
    return now();
  };
  const on: string[] = [];
  for (let i = 0; i < 7; i += 1) on.push(await step('.'));
  expect(new Set(on).size).toBe(7);
  // What is still to come has the values of the scan before.
  await expect(id(page, 'stl-row-30')).toHaveClass(/pend/);
  await expect(id(page, 'stl-row-8')).not.toHaveClass(/pend/);
  const back: string[] = [];
  for (let i = 0; i < 6; i += 1) back.push(await step(','));
  expect(back).toEqual(on.slice(0, 6).reverse());
  // The first statement of the dose's program stands in network 1, the second network ends with line 17.
  await step('n');
  const end = await step('n');
  expect(end).toContain('stl-row-17');
  await page.keyboard.press('End');
  await expect(page.locator('tr.cur')).toHaveCount(0);
});

test('21, 23, 26, 27: pause, the past and back; nothing jumps', async ({ page }) => {
  await open(page);
  await expect.poll(() => scan(page)).toBeGreaterThan(60);
  const place = async () => [(await id(page, 'strip').boundingBox())?.height, (await id(page, 'stl').boundingBox())?.y];
  /** Paused, once the last scan has arrived. */
  const pause = async () => {
    await id(page, 'pause').click();
    await expect(id(page, 'pause')).toContainText('Go on');
    await page.waitForTimeout(500);
    return scan(page);
  };
  const before = await place();
  const stands = await pause();
  await page.waitForTimeout(500);
  expect(await scan(page)).toBe(stands);
  await id(page, 'pause').click();
  await expect(id(page, 'connection')).toHaveText('Live');
  const n = await pause();
  await id(page, 'step-scan-back').click();
  await expect.poll(() => scan(page)).toBe(n - 1);
  await expect(id(page, 'connection')).toHaveText('Past');
  await expect(id(page, 'state-message')).toContainText('ago');
  expect(await place()).toEqual(before);
  await id(page, 'go-live').click();
  await id(page, 'pause').click();
  await expect(id(page, 'connection')).toHaveText('Live');
  expect(await place()).toEqual(before);
});

test('24, 25, 29: the timeline goes to a scan; there nothing is written', async ({ page, request }) => {
  await open(page);
  await dose(page);
  const begun = await scan(page);
  await expect.poll(() => scan(page)).toBeGreaterThan(begun + 250);
  const track = id(page, 'timeline-track');
  const box = (await track.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  await page.mouse.click(box.x + box.width - 80, box.y + 30);
  await expect(id(page, 'connection')).toHaveText('Past');
  const n = await scan(page);
  const [names, values] = (await (await request.get(`/api/v1/trace?from=${n}&to=${n}&channels=FLOW,LITRES&format=csv`)).text()).trim().split(/\r?\n/).map((line) => line.split(','));
  const traced = (name: string) => values?.[names?.indexOf(name) ?? -1];
  expect(traced('scan')).toBe(String(n));
  await expect(id(page, 'in-0.7')).toHaveAttribute('data-on', traced('FLOW') ?? '');
  const litres = Number(traced('LITRES'));
  expect(litres).toBeGreaterThan(0);
  await expect(id(page, 'plant-picture').locator('.big')).toHaveText(String(litres));
  await expect(id(page, 'stl-row-29').locator('td.num').first()).toHaveText(String(litres).padStart(4, '0'));
  await expect(id(page, 'in-0.1').getByRole('switch')).toBeDisabled();
  await expect(id(page, 'in-0.1').getByRole('switch')).toHaveAttribute('title', /past/);
  await expect(id(page, 'plant-start')).toHaveAttribute('aria-disabled', 'true');
  await track.focus();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => scan(page)).toBe(n - 1);
  await page.keyboard.press('PageDown');
  await expect.poll(() => scan(page)).toBe(Math.max(0, n - 101));
  await expect(track).toHaveAttribute('aria-valuetext', /Scan \d+ at [\d.]+ s, in the past/);
  await id(page, 'nav-watch').click();
  await expect(id(page, 'watch-modify')).toBeDisabled();
  await expect(id(page, 'watch-modify')).toHaveAttribute('title', /past/);
  await expect(id(page, 'force-add')).toBeDisabled();
});

test('28: ten times as fast', async ({ page }) => {
  await open(page);
  await id(page, 'speed').click();
  await id(page, 'speed-10').click();
  await expect(id(page, 'speed')).toContainText('10×');
  const at = () => page.evaluate(() => [performance.now() / 1000, Number.parseFloat(document.querySelector('[data-testid=scan-time]')?.textContent ?? '')] as const);
  // Of a machine that is busy at the moment one more look is taken.
  await expect(async () => {
    const [start, first] = await at();
    await page.waitForFunction((start) => performance.now() / 1000 > start + 3, start);
    const [end, last] = await at();
    const speed = (last - first) / (end - start);
    expect(speed).toBeGreaterThan(9);
    expect(speed).toBeLessThan(11);
  }).toPass({ timeout: 30_000 });
});

test('30: before the start there is nothing', async ({ page }) => {
  await open(page);
  await expect.poll(() => scan(page)).toBeGreaterThan(20);
  await page.keyboard.press('Home');
  await expect(id(page, 'connection')).toHaveText('Past');
  const oldest = await scan(page);
  await expect(id(page, 'timeline')).toContainText('before the start');
  for (const key of [',', '<', 'N']) await page.keyboard.press(key);
  await page.waitForTimeout(500);
  expect(await scan(page)).toBe(oldest);
  const shown = await page.evaluate(() => document.body.outerHTML);
  expect(shown).not.toMatch(/NaN|undefined|Infinity/);
});
