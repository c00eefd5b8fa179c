// Checks of the contract: states.
import { dose, expect, id, open, OWN, scan, test } from './sieben';

const TOML = '[project]\nname = "own"\nmnemonics = "en"\n[cpu]\ncycle = "10ms"\nwatchdog = "6s"\n';

test('31: STOP switches the outputs off and keeps what is retentive', async ({ page, request }) => {
  await open(page);
  await dose(page);
  const litres = async () => ((await (await request.get('/api/v1/tags?names=C%200')).json()) as { items: { value: number }[] }).items[0]?.value ?? 0;
  await expect.poll(litres).toBeGreaterThan(0);
  await id(page, 'mode-stop').click();
  await expect(id(page, 'led-stop')).toHaveAttribute('data-on', '1');
  await expect(id(page, 'led-run')).toHaveAttribute('data-on', '0');
  await expect(id(page, 'out-0.0')).toHaveAttribute('data-on', '0');
  await expect(id(page, 'mode-mres')).toBeEnabled();
  await expect(id(page, 'state-message')).toContainText('The CPU is in STOP');
  const kept = await litres();
  expect(kept).toBeGreaterThan(0);
  await page.waitForTimeout(500);
  expect(await litres()).toBe(kept);
  await expect(id(page, 'plant-picture').locator('.big')).toHaveText(String(kept));
  // No client is connected: MRES does not ask.
  await id(page, 'mode-mres').click();
  await expect.poll(litres).toBe(0);
});

test.describe('with a restart block', () => {
  test.use({
    example: OWN,
    files: {
      'sieben.toml': TOML,
      'main.awl': 'ORGANIZATION_BLOCK OB 100\nBEGIN\n L MW 10;\n + 1;\n T MW 10;\nEND_ORGANIZATION_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n L MW 10;\n T QW 4;\nEND_ORGANIZATION_BLOCK\n',
    },
  });
  test('32: RUN, and OB 100 ran once', async ({ page, request }) => {
    await open(page);
    const restarts = async () => ((await (await request.get('/api/v1/tags?names=MW%2010')).json()) as { items: { value: string }[] }).items[0]?.value;
    expect(await restarts()).toBe('16#0001');
    await id(page, 'mode-stop').click();
    await expect(id(page, 'connection')).toHaveText('STOP');
    await id(page, 'mode-run').click();
    await expect(id(page, 'connection')).toHaveText('Live');
    await expect(id(page, 'led-run')).toHaveAttribute('data-on', '1');
    const n = await scan(page);
    await expect.poll(() => scan(page)).toBeGreaterThan(n + 20);
    expect(await restarts()).toBe('16#0002');
  });
});

test('33: the server goes away and comes back', async ({ page, sieben }) => {
  await open(page, '#watch');
  await id(page, 'watch-new-C0').fill('12');
  await sieben.kill();
  await expect(id(page, 'connection')).toHaveText('Offline', { timeout: 3000 });
  await expect(id(page, 'state-message')).toContainText(/These are the values of scan [\d,]+/);
  for (const control of ['watch-modify', 'force-add', 'mode-stop', 'pause', 'watch-tick-C0']) await expect(id(page, control)).toBeDisabled();
  await expect(id(page, 'state-message')).toContainText(/No connection for [2-9] s/);
  await sieben.start();
  await expect(id(page, 'connection')).toHaveText('Live', { timeout: 16_000 });
  await expect(id(page, 'toast')).toContainText(/there was no connection for [1-9]\d* s/);
  await expect(id(page, 'watch-new-C0')).toHaveValue('12');
  // The timeline goes on as well.
  await id(page, 'nav-live').click();
  const drawn = () => id(page, 'timeline').locator('path').evaluateAll((all) => all.map((path) => path.getAttribute('d')).join());
  const before = await drawn();
  await expect.poll(drawn).not.toBe(before);
});

test('33: the server comes back with another program: nothing of the one before is left', async ({ page, sieben }) => {
  await open(page);
  await expect(id(page, 'stl-row-8')).toBeVisible();
  await sieben.kill();
  await expect(id(page, 'connection')).toHaveText('Offline', { timeout: 3000 });
  sieben.become('tank');
  await sieben.start();
  await expect(id(page, 'connection')).toHaveText('Live', { timeout: 16_000 });
  await expect(page).toHaveTitle('tank · RUN · Sieben');
  await expect(id(page, 'plant')).toContainText('Tank');
  await expect(id(page, 'program')).not.toContainText('Dosing');
  await id(page, 'nav-symbols').click();
  await expect(id(page, 'symbol-Overflow')).toBeVisible();
  await expect(page.getByTestId('symbol-LITRES')).toHaveCount(0);
  await expect(id(page, 'call-structure')).toContainText('FC 1');
  await id(page, 'nav-watch').click();
  await expect(id(page, 'watch-tab-tank')).toBeVisible();
});

/** Inputs and outputs, more than a page may ask for. */
const WIDE = `number,symbol,address,type,comment\n${Array.from({ length: 400 }, (_, i) => `${i},Bit${i},${i % 2 === 0 ? 'I' : 'Q'} ${(i - (i % 2)) / 2 + 100}.0,BOOL,`).join('\n')}\n`;
test.describe('with thousands of channels', () => {
  test.use({
    example: OWN,
    files: {
      'sieben.toml': '[project]\nname = "own"\nsources = ["main.awl"]\nsymbols = ["symbols.csv"]\nmnemonics = "en"\n[cpu]\ntype = "416-3"\ncycle = "10ms"\n',
      'symbols.csv': WIDE,
      'main.awl': 'ORGANIZATION_BLOCK OB 1\nBEGIN\n A I 100.0;\n = Q 299.0;\nEND_ORGANIZATION_BLOCK\n',
      'long.watch': `name,format,comment\nMW 10,DEC,\n${'x'.repeat(300)},DEC,too long\n`,
    },
  });
  test('the rack asks for what is in sight, and the connection stays', async ({ page, request }) => {
    const asked: number[] = [];
    let connections = 0;
    page.on('websocket', (socket) => {
      connections += 1;
      socket.on('framesent', ({ payload }) => {
        const message = JSON.parse(String(payload)) as { t: string; what?: string; names?: string[] };
        if (message.what === 'tags') asked.push(message.names?.length ?? 0);
      });
    });
    await open(page);
    await request.patch('/api/v1/tags', { data: { 'I 100.0': true } });
    await id(page, 'in-100.0').scrollIntoViewIfNeeded();
    await expect(id(page, 'in-100.0')).toHaveAttribute('data-on', '1');
    await id(page, 'out-299.0').scrollIntoViewIfNeeded();
    await expect(id(page, 'out-299.0')).toHaveAttribute('data-on', '1');
    expect(Math.max(...asked)).toBeLessThan(600);
    expect(connections).toBe(1);
  });

  test('a name that is too long is refused at its row', async ({ page }) => {
    let connections = 0;
    page.on('websocket', () => (connections += 1));
    await open(page, '#watch/long.watch');
    await expect(id(page, 'watch-value-MW10')).toHaveText('0');
    await expect(page.getByText('The name is longer than 200 bytes')).toBeVisible();
    const n = await scan(page);
    await expect.poll(() => scan(page)).toBeGreaterThan(n + 50);
    expect(connections).toBe(1);
  });
});

test.describe('with a programming error', () => {
  test.use({
    example: OWN,
    files: {
      'sieben.toml': TOML,
      'main.awl': 'ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nTITLE = M 50.0 opens a block that is not there\n      AN    M 50.0;\n      BEC;\n      L     77;\n      T     MW 52;\n      OPN   DB [MW 52];\nEND_ORGANIZATION_BLOCK\n',
    },
  });
  test('34: what stopped the CPU, and where', async ({ page, request }) => {
    await open(page);
    await request.patch('/api/v1/tags', { data: { 'M 50.0': true } });
    await expect(id(page, 'led-sf')).toHaveAttribute('data-on', '1');
    await expect(id(page, 'state-message')).toContainText('The CPU is in STOP');
    await id(page, 'nav-cpu').click();
    await expect(id(page, 'event-text')).toContainText(/programming error/i);
    await expect(id(page, 'stop-source').locator('.failed')).toContainText('OPN');
    await expect(id(page, 'stack-b')).toContainText('OB 1, line 9');
    await expect(id(page, 'stack-i')).toContainText('RLO');
    await id(page, 'event-open').click();
    await expect(id(page, 'stl-row-9')).toBeVisible();
    await expect(id(page, 'stl-row-9')).toHaveAttribute('aria-selected', 'true');
  });
});

test.describe('with the tank', () => {
  test.use({ example: 'tank' });
  test('35: what was jumped over has no value', async ({ page }) => {
    await open(page, '#program/FC1/n5');
    await id(page, 'view-stl').click();
    const row = id(page, 'stl-row-71');
    await expect(row).toHaveAttribute('data-executed', '0');
    await expect(row.locator('td.bit')).toContainText('–');
    await expect(row.locator('td.num').first()).toHaveText('–');
    await expect(id(page, 'stl-row-70')).toHaveAttribute('data-executed', '1');
  });
});

test.describe('with a scan of six seconds', () => {
  test.use({
    example: OWN,
    files: {
      'sieben.toml': TOML,
      'main.awl': 'ORGANIZATION_BLOCK OB 1\nBEGIN\n      AN    M 50.0;\n      BEC;\n      R     M 50.0;\n      L     180;\nnext: T     MW 52;\n      CALL  SFC 47 (WT := 30000);\n      L     MW 52;\n      LOOP  next;\nEND_ORGANIZATION_BLOCK\n',
    },
  });
  test('a scan of six seconds: the page says so, and stays connected', async ({ page, request }) => {
    await open(page);
    await request.patch('/api/v1/tags', { data: { 'M 50.0': true } });
    await expect(id(page, 'state-message')).toContainText(/One scan has been running for [2-5] s/, { timeout: 5000 });
    await expect(id(page, 'connection')).toHaveText('Live');
    await expect(id(page, 'stl-row-3').locator('.old')).toBeVisible();
    await expect(id(page, 'state-message')).toHaveText('', { timeout: 10_000 });
    await expect(id(page, 'connection')).toHaveText('Live');
    await expect(id(page, 'toast')).toHaveCount(0);
  });
});

test.describe('without a cyclic program', () => {
  test.use({ example: OWN, files: { 'sieben.toml': TOML, 'main.awl': 'FUNCTION FC 1 : VOID\nBEGIN\n      A     I 0.0;\n      =     Q 0.0;\nEND_FUNCTION\n' } });
  test('a program without OB 1: the page says what to do', async ({ page }) => {
    const wrong = await open(page);
    await expect(id(page, 'program')).toContainText('There is no OB 1');
    await expect(id(page, 'plant')).toContainText('no simulated plant');
    await id(page, 'nav-program').click();
    await expect(id(page, 'tree-FC1')).toBeVisible();
    expect(wrong).toEqual([]);
  });
});

test('a page that is not seen asks for less', async ({ page }) => {
  const asked: number[] = [];
  let came = 0;
  page.on('websocket', (socket) => {
    socket.on('framesent', ({ payload }) => {
      const message = JSON.parse(String(payload)) as { t: string; hz?: number };
      if (message.t === 'rate') asked.push(message.hz ?? -1);
    });
    socket.on('framereceived', () => (came += 1));
  });
  await page.clock.install();
  await open(page);
  const look = (state: string) =>
    page.evaluate((state) => {
      Object.defineProperty(document, 'visibilityState', { value: state, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
    }, state);
  await look('hidden');
  await expect.poll(() => asked).toEqual([2]);
  await page.waitForTimeout(500);
  came = 0;
  await page.waitForTimeout(3000);
  expect(came).toBeGreaterThan(2);
  expect(came).toBeLessThan(10);
  // At once, as after a sleep: what is due comes once, not the retries of five minutes without a server.
  await page.clock.fastForward('05:00');
  await expect.poll(() => asked.at(-1)).toBe(0);
  // The page takes five minutes without a message for a lost connection, and comes back: a new one has 20 without a word.
  await page.waitForTimeout(3000);
  await look('visible');
  await expect.poll(() => asked.at(-1)).toBe(20);
  const n = await scan(page);
  await expect.poll(() => scan(page)).toBeGreaterThan(n);
  await expect(id(page, 'connection')).toHaveText('Live');
});
