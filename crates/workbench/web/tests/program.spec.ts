// Checks of the contract: program.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { EXAMPLES, expect, id, open, test, type Page } from './sieben';
import type { APIRequestContext } from '@playwright/test';

test.use({ example: 'star-delta' });

/** The motor is started: first in star, four seconds later in delta. */
async function start(request: APIRequestContext): Promise<void> {
  await request.patch('/api/v1/tags', { data: { 'I 8.1': true, 'I 8.2': true } });
  await request.patch('/api/v1/tags', { data: { 'I 8.0': true } });
  await new Promise((done) => setTimeout(done, 200));
  await request.patch('/api/v1/tags', { data: { 'I 8.0': false } });
}

/** Flow and value of an element. */
const flow = async (page: Page, element: string, flow: string, value: string) => {
  await expect(id(page, element)).toHaveAttribute('data-value', value);
  await expect(id(page, element)).toHaveAttribute('data-flow', flow);
};

test('36: power flow of the scan', async ({ page, request }) => {
  await open(page, '#program/FB20/n8');
  await id(page, 'view-lad').click();
  await flow(page, 'lad-contact-120', '0', '0');
  await start(request);
  await flow(page, 'lad-contact-120', '1', '1');
  await flow(page, 'lad-coil-125', '1', '1');
});

test('37: an operand is toggled; a normally closed contact with 1 carries nothing', async ({ page, request }) => {
  await open(page, '#program/FB20/n2');
  await id(page, 'view-lad').click();
  await request.patch('/api/v1/tags', { data: { 'I 8.3': true } });
  await flow(page, 'lad-contact-57', '1', '1');
  await request.patch('/api/v1/tags', { data: { 'I 8.3': false } });
  await flow(page, 'lad-contact-57', '0', '0');
  await start(request);
  await page.goto('about:blank');
  await open(page, '#program/FB20/n5');
  // In delta: `UN #delta` in the network of the star contactor.
  await expect(id(page, 'lad-contact-97')).toHaveAttribute('data-value', '1', { timeout: 15_000 });
  await expect(id(page, 'lad-contact-97')).toHaveAttribute('data-flow', '0');
});

test('38: three languages side by side, one selection', async ({ page }) => {
  await open(page, '#program/FB20/n8');
  await id(page, 'view-lad').click();
  await id(page, 'view-side').click();
  const side = id(page, 'side-by-side');
  for (const form of ['LAD', 'STL', 'FBD']) await expect(side.getByRole('heading', { name: form })).toBeVisible();
  const selected = async (line: number) => {
    await expect(side.getByTestId(`stl-row-${line}`)).toHaveAttribute('aria-selected', 'true');
    await expect(side.getByTestId(`lad-contact-${line}`)).toHaveAttribute('aria-selected', 'true');
    await expect(side.getByTestId(`fbd-contact-${line}`)).toHaveAttribute('aria-selected', 'true');
    await expect(id(page, 'inspector')).toContainText(`line ${line}`);
  };
  await side.getByTestId('stl-row-123').click();
  await selected(123);
  await side.getByTestId('lad-contact-120').click();
  await selected(120);
  await side.getByTestId('fbd-contact-122').click();
  await selected(122);
});

test('39: each network that stays STL says why', async ({ page }) => {
  await open(page, '#program/FB20');
  await id(page, 'view-lad').click();
  for (const [network, statement, line] of [[1, 'X #star', 40], [3, 'ON #stop', 71], [4, 'U #star_timer', 87]] as const) {
    await id(page, `network-${network}`).locator('.ttl').click();
    const reason = id(page, `reason-${network}`);
    await expect(reason).toContainText(/^Stays STL: /);
    await expect(reason).toContainText(statement);
    await expect(reason).toContainText(`line ${line}`);
  }
  for (const network of [2, 5, 6, 7, 8]) await expect(id(page, `reason-${network}`)).toHaveCount(0);
});

test.describe('with a second motor', () => {
  const source = readFileSync(new URL('../../../../examples/star-delta/star-delta.awl', import.meta.url), 'utf8');
  const second = source
    .replace('ORGANIZATION_BLOCK OB 1\n', 'DATA_BLOCK DB 21\nTITLE = Motor 2\nFB 20\nBEGIN\nEND_DATA_BLOCK\n\nORGANIZATION_BLOCK OB 1\n')
    .replace('NETWORK\nTITLE = The motor runs', 'NETWORK\nTITLE = Motor 2, which never starts\n      CALL  FB 20, DB 21 (\n        start := M 100.0,\n        stop := "Stop",\n        emergency_stop := "EmergencyStop",\n        overload := "Overload",\n        acknowledge := "Acknowledge",\n        line_on := M 100.1,\n        star_on := M 100.2,\n        delta_on := M 100.3,\n        star_timer := T 11,\n        pause_timer := T 12,\n        watch_timer := T 13);\n\nNETWORK\nTITLE = The motor runs');
  test.use({ files: { 'star-delta.awl': second } });
  test('43: whose data is shown', async ({ page, request }) => {
    await open(page, '#program/FB20/n8');
    await id(page, 'view-lad').click();
    await start(request);
    await expect(id(page, 'instance')).toContainText('DB 20');
    await flow(page, 'lad-contact-120', '1', '1');
    await id(page, 'instance').click();
    await id(page, 'instance-DB21').click();
    await expect(id(page, 'instance')).toContainText('DB 21');
    await flow(page, 'lad-contact-120', '0', '0');
    await id(page, 'view-stl').click();
    await expect(id(page, 'stl-row-120')).toHaveAttribute('data-sta', '0');
    await id(page, 'instance').click();
    await id(page, 'instance-DB20').click();
    await expect(id(page, 'stl-row-120')).toHaveAttribute('data-sta', '1');
  });
});

test.describe('with the dosing plant', () => {
  test.use({ example: 'dosing' });
  test('47: the other mnemonics, and the file as it was', async ({ page, sieben }) => {
    const file = join(sieben.folder, 'dosing.awl');
    const before = readFileSync(file);
    await open(page);
    const row = id(page, 'stl-row-15');
    await expect(row.locator('.op')).toHaveText('A');
    await row.click();
    await id(page, 'mnemonics').click();
    await expect(row.locator('.op')).toHaveText('U');
    await expect(row).toContainText('E 0.7');
    await expect(row).toHaveAttribute('aria-selected', 'true');
    await expect(id(page, 'reason')).toContainText('E 0.7');
    await page.keyboard.press('m');
    await expect(row.locator('.op')).toHaveText('A');
    await expect(row).toContainText('I 0.7');
    expect(readFileSync(file).equals(before)).toBe(true);
  });
});

test.describe('with Structured Text', () => {
  const TOML = readFileSync(join(EXAMPLES, 'heater/sieben.toml'), 'utf8');
  test.use({ example: 'heater', files: { 'sieben.toml': TOML.replace('interval = "100ms"', 'interval = "6s"').replace('cycle = "10ms"', 'cycle = "10ms"\nwatchdog = "6s"') } });
  test('a line of Structured Text shows what it has written, and no value where it was left out', async ({ page, request }) => {
    await open(page, '#program/OB1');
    const value = id(page, 'value-161');
    await expect(id(page, 'view-lad'), 'there is no ladder of it').toBeDisabled();
    await expect(id(page, 'stl-row-161')).toContainText('PowerRaw := 0;');
    // The thermostat is closed: nothing is switched off.
    await expect(id(page, 'stl-row-160')).toHaveAttribute('data-executed', '1');
    await expect(id(page, 'stl-row-161')).toHaveAttribute('data-executed', '0');
    await expect(value).toContainText('–');
    await request.post('/api/v1/forces', { data: { name: 'Thermostat', value: 0, reason: 'too hot' } });
    await expect(id(page, 'stl-row-161')).toHaveAttribute('data-executed', '1');
    await expect(value).toHaveText('0');
    // The past has its own values.
    await page.keyboard.press('Home');
    await expect(id(page, 'connection')).toHaveText('Past');
    await expect(value).toContainText('–');
    await page.keyboard.press('End');
    await expect(value).toHaveText('0');
    await id(page, 'stl-row-160').click();
    await page.keyboard.press('ArrowDown');
    await expect(id(page, 'stl-row-161')).toHaveAttribute('aria-selected', 'true');
  });
});

test.describe('in the language and the mnemonics of a German', () => {
  test('addresses have the mnemonics of the project, also in the palette', async ({ page }) => {
    const hellos: string[] = [];
    page.on('websocket', (socket) => socket.on('framesent', ({ payload }) => {
      const message = JSON.parse(String(payload)) as { t: string; mnemonics?: string };
      if (message.t === 'hello') hellos.push(message.mnemonics ?? '');
    }));
    await open(page);
    await expect(id(page, 'mnemonics')).toHaveText('E/A');
    await expect.poll(() => hellos.at(-1), 'sentences too').toBe('de');
    await expect(id(page, 'in-8.0')).toContainText('E 8.0');
    await page.keyboard.press('Control+k');
    await id(page, 'palette-input').fill('e8.0');
    await expect(id(page, 'hit-0')).toContainText('Start');
    await id(page, 'palette-input').fill('A 99.0');
    await page.keyboard.press('Enter');
    await id(page, 'nav-watch').click();
    await expect(id(page, 'watch-row-Q99.0')).toContainText('A 99.0');
  });

  test('the palette changes to German: the words of the page and of the server', async ({ page }) => {
    await open(page, '#program/FB20/l120');
    await id(page, 'view-lad').click();
    await expect(id(page, 'reason')).toContainText('RLO');
    await page.keyboard.press('Control+k');
    await id(page, 'palette-input').fill('Deutsch');
    await page.keyboard.press('Enter');
    await expect(id(page, 'reason')).toContainText('VKE');
    await expect(id(page, 'view-lad')).toHaveText('KOP');
    await id(page, 'network-3').locator('.ttl').click();
    await expect(id(page, 'reason-3')).toContainText(/^Bleibt AWL: /);
  });

  test('power is shown where there is a diagram', async ({ page }) => {
    await open(page, '#program/FB20/l120');
    await id(page, 'view-lad').click();
    await expect(id(page, 'inspector')).toContainText('Power here');
    await id(page, 'network-3').locator('.ttl').click();
    await expect(id(page, 'inspector')).not.toContainText('Power here');
    await id(page, 'network-8').locator('.ttl').click();
    await expect(id(page, 'inspector')).toContainText('Power here');
    await id(page, 'view-stl').click();
    await expect(id(page, 'inspector')).not.toContainText('Power here');
  });
});
