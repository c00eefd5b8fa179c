// 85: pictures of the page, as they stand in the book. `cargo xtask screenshots` takes them again.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { APIRequestContext, Page } from '@playwright/test';
import { decode, difference, encode, type Box } from './png';
import { EXAMPLES, expect, id, test, type Files } from './sieben';
import { hold, runTo, show, undisturbed, write, type Belief } from './still';

const FOLDER = fileURLToPath(new URL('../../../../docs/reference/workbench/', import.meta.url));
/** What the pictures were taken with. */
const RECORDED = `${FOLDER}chromium.txt`;
const TAKES = process.env['SCREENSHOTS'] === 'write';
/** So much of a picture may differ. */
const DIFFERENCE_MAX = 0.005;
/** What shows times, ports and rates of the computer: it stands in the pictures and is not compared. */
const VARIES = [
  '[data-testid=cycle]',
  '[data-testid^=diag-] .t',
  '[data-testid=event] .kv',
  '[data-testid=communications] .tag',
  '[data-testid=clients] td',
  '[data-testid=module-info] .sec',
  '[data-testid=force-list] .kv',
].join(', ');

/** Chromium and the fonts of the page, with their versions. */
function renderer(): string {
  const said = (program: string, ...words: string[]) => {
    try {
      return execFileSync(program, words, { stdio: ['ignore', 'pipe', 'ignore'] }).toString().trim();
    } catch {
      return `${program} is not there`;
    }
  };
  const chromium = /\d+(\.\d+)+/.exec(said(process.env['CHROMIUM'] ?? 'chromium', '--version'))?.[0] ?? 'unknown';
  const fonts = ['Inter', 'JetBrains Mono'].map((font) => said('fc-match', '--format=%{family[0]} %{fontversion}', font));
  return `${[`Chromium ${chromium}`, ...fonts].join('\n')}\n`;
}

const here = renderer();
const recorded = existsSync(RECORDED) ? readFileSync(RECORDED, 'utf8') : '';
const compares = !TAKES && here === recorded;

/** Takes a picture, and compares it with the one in the book or puts it there. */
async function picture(page: Page, name: string): Promise<void> {
  await page.evaluate(async () => {
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    await document.fonts.ready;
  });
  const boxes: Box[] = await page.locator(VARIES).evaluateAll((all) =>
    all.map((node) => node.getBoundingClientRect()).map((box) => ({ x: box.x * devicePixelRatio, y: box.y * devicePixelRatio, width: box.width * devicePixelRatio, height: box.height * devicePixelRatio })),
  );
  const taken = await page.screenshot({ animations: 'disabled', caret: 'hide' });
  const path = `${FOLDER}${name}.png`;
  if (TAKES) {
    mkdirSync(FOLDER, { recursive: true });
    writeFileSync(path, encode(decode(taken)));
    writeFileSync(RECORDED, here);
  } else if (compares) {
    const part = difference(decode(taken), decode(readFileSync(path)), boxes);
    if (part > DIFFERENCE_MAX) writeFileSync(test.info().outputPath(`${name}.png`), taken);
    expect.soft(part, `${name}: which part differs from the picture in the book; as it should be: \`cargo xtask screenshots\``).toBeLessThanOrEqual(DIFFERENCE_MAX);
  } else {
    expect(existsSync(path), path).toBe(true);
  }
}

/** The dosing plant without the noise of its flow, which goes by the time since the start: how long the scans took before the run was held is different each time. */
const EVEN_FLOW: Files = { 'sieben.toml': `${readFileSync(join(EXAMPLES, 'dosing/sieben.toml'), 'utf8')}noise = 0\n` };
test.use({ files: async ({ example }, use) => use(example === 'dosing' ? EVEN_FLOW : {}) });

test.beforeEach(() => {
  if (!TAKES && !compares) console.log(`pictures are not compared: recorded with another Chromium or other fonts (${recorded.trim().split('\n').join(', ') || 'never'}; here ${here.trim().split('\n').join(', ')})`);
});

/** The window of a phone, in its own points. */
const PHONE = { width: 390, height: 844 };
const WIDE = { width: 1440, height: 900 };
const THEMES = ['light', 'dark', 'hc'];
const VIEWS = ['live', 'program', 'watch', 'symbols', 'cpu'];

/** Goes back on the timeline, as one does by keys. */
async function back(page: Page, from: number, to: number): Promise<void> {
  await id(page, 'timeline-track').focus();
  for (let scan = from; scan > to; ) {
    const step = scan - to >= 100 ? 100 : 1;
    await page.keyboard.press(step === 100 ? 'PageDown' : 'ArrowLeft');
    scan -= step;
    await expect(id(page, 'scan-number')).toHaveText(`Scan ${scan.toLocaleString('en-GB')}`);
  }
  await page.waitForTimeout(600);
}

/** The dose of the example: START pressed from scan 100 to 134. */
async function dose(request: APIRequestContext, until: number): Promise<void> {
  await runTo(request, 99);
  await write(request, { 'I 0.0': true });
  await runTo(request, 133);
  await write(request, { 'I 0.0': false });
  await runTo(request, until);
}

/** A page of the dose at scan 742, one after a pulse. A second page looks on from the beginning, so that what changes is noted. */
async function dosing(page: Page, request: APIRequestContext, belief: Belief = 'it goes on', until = 742): Promise<void> {
  await undisturbed(page, belief);
  await onlooker(page);
  await dose(request, until);
}

/** A page that looks at the run for as long as the test goes, from the moment on at which the server notes changes for it. */
async function onlooker(page: Page): Promise<void> {
  const other = await page.context().newPage();
  let noted = false;
  other.on('websocket', (socket) => socket.on('framereceived', ({ payload }) => (noted ||= /"changes":\[/.test(String(payload)))));
  await other.goto('/?theme=light#live');
  await expect(id(other, 'scan-number')).toHaveText(/Scan \d+/);
  await expect.poll(() => noted).toBe(true);
  await page.bringToFront();
}

/** Opens a view at scan 742, with statement 15 chosen where it is in sight, and waits until its values are there. */
async function settled(page: Page, view: string, theme: string): Promise<void> {
  await show(page, `#${view}`, theme, 'Live');
  await expect(id(page, 'scan-number')).toHaveText('Scan 742');
  if (view === 'live') {
    await expect(id(page, 'stl-row-15')).toHaveAttribute('data-sta', '1');
    if ((page.viewportSize()?.width ?? 0) > 900) {
      await id(page, 'stl-row-15').click();
      await expect.soft(id(page, 'reason')).toContainText('FLOW');
    }
  }
  // What is asked for over HTTP, and the reason, have come.
  await page.waitForLoadState('networkidle');
  await page.waitForTimeout(400);
}

test('85: five views in three themes and two sizes', async ({ page, request, sieben }) => {
  test.setTimeout(240_000);
  await hold(sieben, request);
  await dosing(page, request);
  for (const [size, viewport] of [['1440', WIDE], ['phone', PHONE]] as const) {
    await page.setViewportSize(viewport);
    for (const view of VIEWS)
      for (const theme of THEMES) {
        await settled(page, view, theme);
        await picture(page, `${view}-${theme}-${size}`);
      }
  }
  await page.setViewportSize({ width: 1280, height: 720 });
  await settled(page, 'live', 'light');
  await picture(page, 'live-light-1280');
});

test.describe('on a phone with fine points', () => {
  test.use({ viewport: PHONE, deviceScaleFactor: 2 });
  test('85: the dose on a phone', async ({ page, request, sieben }) => {
    await hold(sieben, request);
    await dosing(page, request);
    await settled(page, 'live', 'light');
    await picture(page, 'live-light-phone-2x');
  });
});

test('85: the past', async ({ page, request, sieben }) => {
  await hold(sieben, request);
  await dosing(page, request);
  await settled(page, 'live', 'light');
  await back(page, 742, 421);
  await picture(page, 'past');
});

test('85: a statement of a scan', async ({ page, request, sieben }) => {
  await hold(sieben, request);
  await dosing(page, request, 'it stands', 740);
  await show(page, '#live', 'light', 'Paused');
  await expect(id(page, 'scan-number')).toHaveText('Scan 740');
  // The next scan is run: the statements of network 1, and two of network 2.
  for (const line of [8, 9, 10, 11, 12, 15, 16]) {
    await page.keyboard.press('.');
    await expect(id(page, `stl-row-${line}`)).toHaveClass(/\bcur\b/);
  }
  await expect(page.locator('body')).toHaveAttribute('data-state', 'stepping');
  await page.waitForTimeout(400);
  await picture(page, 'step');
});

test('85: STOP', async ({ page, request, sieben }) => {
  await hold(sieben, request);
  await dosing(page, request);
  await settled(page, 'live', 'light');
  await id(page, 'mode-stop').click();
  await expect(id(page, 'state-message')).toContainText('The CPU is in STOP');
  await page.waitForTimeout(600);
  await picture(page, 'stop');
});

test('85: no connection', async ({ page, request, sieben }) => {
  await hold(sieben, request);
  await dosing(page, request);
  await settled(page, 'live', 'dark');
  await sieben.kill();
  await expect(id(page, 'connection')).toHaveText('Offline');
  await expect(id(page, 'state-message')).toContainText('4 s');
  await picture(page, 'offline');
});

test('85: forced, triggered, and a scan of the past in the watch table', async ({ page, request, sieben }) => {
  await hold(sieben, request);
  await undisturbed(page, 'it goes on');
  await onlooker(page);
  await runTo(request, 95);
  expect((await request.post('/api/v1/forces', { data: { name: 'I 0.1', value: 'true', reason: 'Wire of S2 broken, new one on Friday' } })).ok()).toBe(true);
  await show(page, '#watch', 'light', 'Live');
  await id(page, 'trigger').fill('VALVE rises');
  await id(page, 'trigger').press('Enter');
  // A page looks for the trigger in what it shows: a run that is faster than its cycle leaves its window too soon.
  await dose(request, 140);
  await expect(id(page, 'trigger-state')).toHaveText('triggered in scan 100');
  await runTo(request, 1140);
  await expect(id(page, 'scan-number')).toHaveText('Scan 1,140');
  await id(page, 'watch-new-C0').fill('C#10');
  await id(page, 'watch-tick-C0').check();
  await back(page, 1140, 421);
  await picture(page, 'watch-past');
});

test.describe('star-delta', () => {
  test.use({ example: 'star-delta' });
  test('85: a block as ladder, with its three forms side by side', async ({ page, request, sieben }) => {
    test.setTimeout(60_000);
    await hold(sieben, request);
    await undisturbed(page, 'it goes on');
    await onlooker(page);
    // STOP and emergency stop are normally closed.
    await write(request, { Stop: true, EmergencyStop: true });
    await runTo(request, 119);
    await write(request, { Start: true });
    await runTo(request, 130);
    await write(request, { Start: false });
    await runTo(request, 600);
    for (const theme of ['light', 'dark']) {
      await show(page, '#program/FB20/n8', theme, 'Live');
      await id(page, 'view-lad').click();
      // What was chosen is kept from one load to the next.
      if ((await id(page, 'side-by-side').count()) === 0) await id(page, 'view-side').click();
      await id(page, 'side-by-side').getByTestId('stl-row-123').click();
      await expect.soft(id(page, 'side-by-side').getByTestId('lad-contact-120')).toHaveAttribute('data-flow', '1');
      await page.waitForTimeout(800);
      await picture(page, `lad-${theme}`);
    }
  });
});

test.describe('tank', () => {
  test.use({ example: 'tank' });
  test('85: symbols, where they are used, which bits are free', async ({ page, request, sieben }) => {
    await hold(sieben, request);
    await undisturbed(page, 'it goes on');
    await onlooker(page);
    await runTo(request, 2310);
    await show(page, '#symbols', 'light', 'Live');
    await id(page, 'symbol-Overflow').click();
    await page.waitForLoadState('networkidle');
    await page.waitForTimeout(600);
    await picture(page, 'symbols');
  });
});

test.describe('decade-switches', () => {
  test.use({ example: 'decade-switches' });
  test('85: why the CPU stopped', async ({ page, request, sieben }) => {
    // With the OB 121 of the example the CPU would go on.
    await sieben.kill();
    const file = join(sieben.folder, 'decade-switches.awl');
    writeFileSync(file, readFileSync(file, 'utf8').replace(/ORGANIZATION_BLOCK OB 121[^]*?END_ORGANIZATION_BLOCK\n/, ''));
    await sieben.start();
    await hold(sieben, request);
    await undisturbed(page, 'it goes on');
    await runTo(request, 1203);
    await show(page, '#cpu', 'light', 'Live');
    await write(request, { 'IW 0': '16#01A5' });
    await request.post('/api/v1/time', { data: { step: 'scan', n: 1 } });
    await expect(id(page, 'led-stop')).toHaveAttribute('data-on', '1');
    await page.waitForTimeout(600);
    await picture(page, 'cpu-stop');
  });
});
