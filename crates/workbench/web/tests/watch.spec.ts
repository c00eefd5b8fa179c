// Checks of the contract: watch tables, forcing, timing diagram.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { BINARY, EXAMPLES, expect, id, open, OWN, scan, test, type Page } from './sieben';

/** Forces STOP of the dosing plant to 0, as a user does. */
async function forceStop(page: Page): Promise<void> {
  await id(page, 'force-address').fill('STOP');
  await id(page, 'force-value').fill('0');
  await id(page, 'force-add').click();
  const dialog = page.getByRole('dialog');
  await expect(dialog.getByLabel('Value')).toHaveValue('0');
  await dialog.getByLabel('Reason').fill('wire broken');
  await dialog.getByRole('button', { name: /^Force/ }).click();
}

test('49: address and symbol complete each other', async ({ page }) => {
  await open(page, '#watch');
  await expect(id(page, 'watch-row-C0')).toBeVisible();
  for (const [typed, row, symbol] of [['LITRES', 'C0', 'LITRES'], ['q0.0', 'Q0.0', 'VALVE']] as const) {
    const before = await id(page, `watch-row-${row}`).count();
    await id(page, 'watch-add').fill(typed);
    await id(page, 'watch-add').press('Enter');
    await expect(id(page, `watch-row-${row}`)).toHaveCount(before + 1);
    await expect(id(page, `watch-row-${row}`).last()).toContainText(symbol);
    await expect(id(page, 'watch-add')).toHaveValue('');
  }
});

test('50: a value is written once, at the moment that is chosen', async ({ page, request }) => {
  await open(page, '#watch');
  const litres = async () => ((await (await request.get('/api/v1/tags?names=C%200')).json()) as { items: { shown: string }[] }).items[0]?.shown ?? '';
  const modify = id(page, 'watch-modify');
  await expect(modify).toBeDisabled();
  await id(page, 'watch-new-C0').fill('17');
  await expect(modify, 'nothing is ticked').toBeDisabled();
  await id(page, 'watch-tick-C0').check();
  await expect(modify).toHaveText('Modify 1 value');
  expect(await litres()).toContain('0');
  await modify.click();
  await expect(id(page, 'watch-value-C0')).toContainText('17');
  // Once: what the program or another writes after that stays.
  await request.patch('/api/v1/tags', { data: { 'C 0': 5 } });
  await expect(id(page, 'watch-value-C0')).toContainText('5');
  await page.waitForTimeout(500);
  await expect(id(page, 'watch-value-C0')).not.toContainText('17');
});

test('50: a value that is refused is said at its row, and nothing is lost', async ({ page }) => {
  await open(page, '#watch');
  await id(page, 'watch-new-C0').fill('many');
  await id(page, 'watch-tick-C0').check();
  await id(page, 'watch-new-I0.1').fill('1');
  await id(page, 'watch-tick-I0.1').check();
  await id(page, 'watch-modify').click();
  const problem = page.locator('[data-testid=watch-row-C0] + tr').getByTestId('watch-problem-C0');
  await expect(problem).toContainText(/P\d{4}/);
  await expect(page.getByTestId(/^watch-problem-/), 'the other row is well').toHaveCount(1);
  await expect(id(page, 'watch-new-C0')).toHaveAttribute('aria-invalid', 'true');
  expect(await id(page, 'watch-new-C0').getAttribute('aria-describedby')).toBe(await problem.getAttribute('id'));
  await expect(id(page, 'watch-new-C0')).toHaveValue('many');
  await id(page, 'watch-new-C0').fill('7');
  await expect(problem).toHaveCount(0);
  await id(page, 'watch-modify').click();
  await expect(id(page, 'watch-value-C0')).toContainText('7');
  // Where there is no room beside the value the sentence stands below it.
  await page.setViewportSize({ width: 390, height: 844 });
  await id(page, 'watch-new-C0').fill('many');
  await id(page, 'watch-modify').click();
  await expect(id(page, 'watch-problem-C0')).toBeInViewport({ ratio: 1 });
});

test('49: a row that was added is kept, and goes by its button or by Delete', async ({ page }) => {
  await open(page, '#watch');
  const add = async (name: string) => {
    await id(page, 'watch-add').fill(name);
    await id(page, 'watch-add').press('Enter');
  };
  await add('MW 10');
  await add('MW 12');
  await page.reload();
  await expect(id(page, 'watch-row-MW10')).toBeVisible();
  await expect(id(page, 'watch-remove-C0'), 'what a file has stays').toHaveCount(0);
  await id(page, 'watch-remove-MW10').click();
  await expect(id(page, 'watch-row-MW10')).toHaveCount(0);
  await expect(id(page, 'watch-remove-MW12')).toBeFocused();
  await id(page, 'watch-new-MW12').fill('12');
  await id(page, 'watch-new-MW12').press('Delete');
  await expect(id(page, 'watch-row-MW12'), 'Delete in a field is about its text').toBeVisible();
  await id(page, 'watch-tick-MW12').focus();
  await page.keyboard.press('Delete');
  await expect(id(page, 'watch-row-MW12')).toHaveCount(0);
  await expect(id(page, 'watch-add')).toBeFocused();
  await page.reload();
  await expect(id(page, 'watch-row-C0')).toBeVisible();
  await expect(id(page, 'watch-row-MW12')).toHaveCount(0);
});

test('49: the table is saved as a file that is a table', async ({ page, request, sieben }) => {
  await open(page, '#watch');
  await id(page, 'watch-add').fill('MW 10');
  await id(page, 'watch-add').press('Enter');
  await page.getByLabel('Format: LITRES').selectOption('DEC');
  const saved = page.waitForEvent('download');
  await id(page, 'watch-save').click();
  const download = await saved;
  expect(download.suggestedFilename()).toBe('dosing.watch');
  const text = readFileSync(await download.path(), 'utf8');
  expect(text).toMatch(/^name,format,comment\n/);
  writeFileSync(join(sieben.folder, 'saved.watch'), text);
  const rows = (await (await request.get('/api/v1/watch/saved.watch')).json()) as { name: string; format: string; comment: string }[];
  const before = (await (await request.get('/api/v1/watch/dosing.watch')).json()) as { name: string; comment: string }[];
  expect(rows.map((row) => row.name)).toEqual([...before.map((row) => row.name), 'MW 10']);
  expect(rows.map((row) => row.comment)).toEqual([...before.map((row) => row.comment), '']);
  expect(rows.find((row) => row.name === 'LITRES')?.format).toBe('DEC');
});

test('51: the dialog says what forcing disables, and what this CPU forces', async ({ page }) => {
  await open(page, '#watch');
  for (const [row, says] of [['I0.1', 'The program reads this value'], ['Q0.0', 'The terminal has this value']] as const) {
    await id(page, `watch-force-${row}`).click();
    await expect(id(page, 'force-disables')).toContainText(says);
    await expect(id(page, 'force-disables')).toContainText(/A CPU 3\S+ forces inputs and outputs only/);
    await expect(id(page, 'force-ok'), 'without a reason').toBeDisabled();
    await page.keyboard.press('Escape');
  }
});

test('51–53: forcing is seen everywhere, with who and why', async ({ page, context }) => {
  await open(page, '#watch');
  const other = await context.newPage();
  await open(other, '#watch');
  await forceStop(page);
  for (const one of [page, other]) {
    await expect(id(one, 'force-I0.1')).toContainText('wire broken');
    await expect(id(one, 'led-frce')).toHaveAttribute('data-on', '1');
    await expect(id(one, 'watch-row-I0.1')).toHaveClass(/forced/);
    await expect(id(one, 'watch-row-I0.1')).toContainText('forced');
    // The program sees the one, the terminal has the other.
    const values = id(one, 'force-I0.1').locator('dd.mono');
    await expect(values.nth(0)).toHaveText('0');
    await expect(values.nth(1)).toHaveText('1');
  }
  await id(other, 'force-release-I0.1').click();
  for (const one of [page, other]) {
    await expect(id(one, 'led-frce')).toHaveAttribute('data-on', '0');
    await expect(id(one, 'force-I0.1')).toHaveCount(0);
    await expect(id(one, 'watch-row-I0.1')).not.toHaveClass(/forced/);
  }
});

test('54: a CPU 315 forces inputs and outputs, and says so', async ({ page, request }) => {
  await open(page, '#watch');
  await expect(id(page, 'watch-force-I0.1')).toBeVisible();
  await expect(id(page, 'watch-row-C0')).toBeVisible();
  await expect(id(page, 'watch-force-C0')).toHaveCount(0);
  const refused = await request.post('/api/v1/forces', { data: { name: 'C 0', value: 1, reason: 'x' } });
  expect([refused.status(), ((await refused.json()) as { code: string }).code]).toEqual([404, 'P7003']);
});

test('55, 56: a trigger keeps its moment, and the cursor is the scan of the page', async ({ page, request }) => {
  await open(page, '#watch');
  await expect(id(page, 'watch-row-Q0.0')).toBeVisible();
  await id(page, 'trigger').fill('VALVE rises');
  await id(page, 'trigger').press('Enter');
  await expect(id(page, 'trigger-state')).not.toContainText('triggered');
  await request.post('/api/v1/press', { data: { items: ['I 0.0'], ms: 200 } });
  await expect(id(page, 'trigger-state')).toHaveText(/triggered in scan [\d,]+/);
  const hit = Number((await id(page, 'trigger-state').textContent())?.replace(/\D/g, ''));
  const values = async () => {
    const trace = await (await request.get(`/api/v1/trace?from=${hit - 1}&to=${hit}&channels=Q0.0&format=csv`)).text();
    return trace.trim().split(/\r?\n/).slice(1).map((line) => line.split(',').at(-1));
  };
  // The newest scans are there a moment later.
  await expect.poll(values, 'it rose in this scan').toEqual(['0', '1']);
  // Half a second after the trigger, which is a tenth of ten seconds from the left end; the names have 232 px, the right margin 16.
  await expect.poll(() => scan(page)).toBeGreaterThan(hit + 150);
  const svg = id(page, 'timing').locator('svg[width]');
  const box = (await svg.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  const x = Math.round(232 + 0.15 * (box.width - 248));
  await page.mouse.click(box.x + x, box.y + 40);
  await expect(id(page, 'connection')).toHaveText('Past');
  // The cursor is where the click was: a scan of ten milliseconds is about one point wide, and late ones leave gaps.
  const cursor = async () => Number(/^M([\d.]+)/.exec((await svg.locator('path[stroke-width="2"]').getAttribute('d')) ?? '')?.[1]);
  await expect.poll(async () => Math.abs((await cursor()) - x)).toBeLessThan(10);
  await expect(svg).toContainText(`scan ${(await scan(page)).toLocaleString('en-GB')}`);
  const n = await scan(page);
  await expect(id(page, 'timing-foot')).toContainText(`scan ${n.toLocaleString('en-GB')}`);
  await id(page, 'nav-live').click();
  expect(await scan(page)).toBe(n);
  const row = await (await request.get(`/api/v1/trace?from=${n}&to=${n}&channels=C0,I0.7&format=csv`)).text();
  const flow = row.trim().split(/\r?\n/)[1]?.split(',').at(-1);
  await expect(id(page, 'in-0.7')).toHaveAttribute('data-on', flow ?? '');
  await expect(id(page, 'stl-row-15')).toHaveAttribute('data-sta', flow ?? '');
});

test.describe('with values of many formats', () => {
  const rows = ['M 0.0,BOOL', 'M 0.1,BOOL', 'M 0.2,BOOL', 'M 0.3,BOOL', 'MD 20,REAL', 'MW 24,INT', 'MW 26,BCD', 'MW 28,S5TIME', 'M 0.4,BOOL', 'MD 30,REAL'];
  test.use({
    example: OWN,
    files: {
      'sieben.toml': '[project]\nname = "own"\nmnemonics = "en"\n[cpu]\ncycle = "20ms"\n',
      'own.watch': `name,format,comment\n${rows.map((row) => `${row},`).join('\n')}\n`,
      'main.awl': 'ORGANIZATION_BLOCK OB 1\nBEGIN\n L 1.5;\n T MD 20;\n L -7;\n T MW 24;\n L W#16#142;\n T MW 26;\n L S5T#2S500MS;\n T MW 28;\n A M 0.0;\n JC on;\n L -2.5;\n T MD 30;\n BEU;\non: L 5.000000e-001;\n T MD 30;\nEND_ORGANIZATION_BLOCK\n',
    },
  });
  test('55: values are those of their formats, and a trigger compares them in any row', async ({ page, request }) => {
    await open(page, '#watch');
    const values = id(page, 'timing').locator('text.vv');
    await expect.poll(async () => (await values.allTextContents()).slice(4)).toEqual(['1.5', '-7', '0142', '2.5 s']);
    await id(page, 'trigger').fill('MD 30 > 0.25');
    await id(page, 'trigger').press('Enter');
    await expect(id(page, 'trigger-state')).toHaveText('waits for MD 30 > 0.25');
    await request.patch('/api/v1/tags', { data: { 'M 0.0': true } });
    await expect(id(page, 'trigger-state')).toHaveText(/triggered in scan \d+/);
    const saved = page.waitForEvent('download');
    await id(page, 'timing-export').click();
    await id(page, 'timing-export-csv').click();
    expect((await saved).suggestedFilename()).toMatch(/^own-\d+-\d+\.csv$/);
  });

  test('every format of the product can be chosen', async ({ page }) => {
    await open(page, '#watch');
    const table = readFileSync(new URL('../../../../docs/reference/formats.md', import.meta.url), 'utf8');
    const names = [...(table.split('## Values')[0] ?? '').matchAll(/^\| `(\w+)`/gm)].map((row) => row[1] ?? '');
    const offered = async () => (await page.getByLabel('Format: MD 20').locator('option').allTextContents()).sort();
    await expect.poll(offered).toEqual(names.sort());
  });
});

test('55: the axis is the time of the CPU, also where it stood', async ({ page, request }) => {
  await open(page, '#watch');
  await expect.poll(() => scan(page)).toBeGreaterThan(50);
  await request.post('/api/v1/mode', { data: { mode: 'stop' } });
  await expect(id(page, 'connection')).toHaveText('STOP');
  const stoodAt = performance.now();
  await expect.poll(() => performance.now() - stoodAt).toBeGreaterThan(1500);
  await request.post('/api/v1/mode', { data: { mode: 'run' } });
  await expect(id(page, 'connection')).toHaveText('Live');
  const n = await scan(page);
  await expect.poll(() => scan(page)).toBeGreaterThan(n + 60);
  await id(page, 'pause').click();
  await expect(id(page, 'connection')).toHaveText('Paused');
  const time = Number.parseFloat((await id(page, 'scan-time').textContent()) ?? '');
  expect(time - (await scan(page)) / 100).toBeGreaterThan(1.4);
  const label = async () => Math.max(...(await id(page, 'timing').locator('text[text-anchor=middle]').allTextContents()).filter((text) => / s$/.test(text)).map((text) => Number.parseFloat(text)));
  // The axis ends at the scan that is shown: it may be that of a full second, which then has no label.
  const since = async () => time - (await label());
  await expect.poll(since).toBeLessThan(1.02);
  expect(await since()).toBeGreaterThan(-0.01);
});

test.describe('with a free cycle', () => {
  const settings = readFileSync(join(EXAMPLES, 'dosing', 'sieben.toml'), 'utf8');
  test.use({ files: { 'sieben.toml': settings.replace('cycle = "10ms"', 'cycle = "free"') } });
  test('55: scans without a set cycle have their times', async ({ page }) => {
    await open(page, '#watch');
    for (let i = 0; i < 5; i += 1) await id(page, 'zoom-in').click();
    await expect(id(page, 'zoom-fit')).toHaveText('0.01 s');
    await id(page, 'pause').click();
    await expect(id(page, 'connection')).toHaveText('Paused');
    const diagram = id(page, 'timing').locator('svg[width]');
    await expect(diagram.locator('text.vv').first()).toHaveText(/^[01]$/);
    expect(await diagram.evaluate((node) => node.outerHTML)).not.toMatch(/NaN|Infinity/);
    const [from, to] = [Number(await diagram.getAttribute('data-from')), Number(await diagram.getAttribute('data-to'))];
    expect(to).toBeGreaterThan(from);
    expect(to - from).toBeLessThan(2000);
    expect(await id(page, 'timeline').evaluate((node) => node.outerHTML)).not.toMatch(/NaN|Infinity/);
  });
});

test('55: a trigger that means nothing is said', async ({ page }) => {
  await open(page, '#watch');
  await expect(id(page, 'watch-row-Q0.0')).toBeVisible();
  await id(page, 'trigger').fill('when it rains');
  await id(page, 'trigger').press('Enter');
  await expect(id(page, 'toast')).toBeVisible();
});

test.describe('in virtual time', () => {
  test.use({ example: 'traffic-light', further: ['--speed', 'max'] });
  test('57: the same window as sieben trace writes it', async ({ page, request, sieben }) => {
    await expect.poll(async () => ((await (await request.get('/api/v1/state')).json()) as { scans: number }).scans).toBeGreaterThan(1000);
    await request.post('/api/v1/time', { data: { pause: true } });
    await page.goto('/?theme=light#watch');
    await expect(id(page, 'pause')).toContainText('Go on');
    for (const format of ['vcd', 'csv', 'svg'] as const) {
      const asked = page.waitForRequest((request) => request.url().includes('/trace?') && request.url().includes(format));
      const saved = page.waitForEvent('download');
      await id(page, 'timing-export').click();
      await id(page, `timing-export-${format}`).click();
      const query = new URL((await asked).url()).searchParams;
      const [from, to, channels] = [Number(query.get('from')), Number(query.get('to')), query.get('channels') ?? ''];
      expect(to - from).toBeGreaterThan(100);
      const text = readFileSync(await (await saved).path(), 'utf8');
      if (format === 'svg') {
        expect(text).toMatch(/^<svg[^]*<\/svg>\s*$/);
        continue;
      }
      const folder = mkdtempSync(join(tmpdir(), 'sieben-trace-'));
      const file = join(folder, `window.${format}`);
      // The first scan of a run is scan 1; a trace counts from 0.
      execFileSync(BINARY, ['trace', sieben.folder, '--channels', channels, '--scans', String(to), '--last', String(to - from + 1), `--${format}`, file]);
      const wanted = readFileSync(file, 'utf8');
      rmSync(folder, { recursive: true });
      // A trace names its sources, the page its project.
      const values = (one: string) => one.replace(/^\$version .*$/m, '').replace(/^([\d.]+),(\d+),/gm, '$1,');
      expect(values(text)).toBe(values(wanted));
    }
  });
});

const MANY = 10_000;
test.describe('with ten thousand rows', () => {
  test.use({ files: { 'big.watch': `name,format,comment\n${Array.from({ length: MANY }, (_, i) => `MB ${i % 2048},DEC,row ${i}`).join('\n')}\n` } });
  test('58: a hundred of them are in the page', async ({ page }) => {
    await open(page, '#watch/big.watch');
    const table = id(page, 'watch-table');
    await expect(table).toHaveAttribute('aria-rowcount', String(MANY + 1));
    const body = page.locator('.vat-panel .pb');
    for (const top of [0, 100_000, 1e9, 5_000]) {
      await body.evaluate((node, to) => (node.scrollTop = to), top);
      const first = top === 1e9 ? MANY + 1 : Math.floor(top / 28) + 3;
      await expect(table.locator(`tr[aria-rowindex="${first}"]`)).toBeInViewport();
      expect(await table.locator('tbody tr').count()).toBeLessThanOrEqual(100);
      await expect(table.locator(`tr[aria-rowindex="${first}"] td.v`)).not.toContainText('–');
    }
  });
});
