// Checks of the contract that need the page and the development server alone; numbers are those of the contract.
import { spawn, type ChildProcess } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test, type Page } from '@playwright/test';
import { TABLE } from './words';

const id = (page: Page, name: string) => page.getByTestId(name);
const number = async (page: Page) => Number((await id(page, 'scan-number').textContent())?.replace(/\D/g, ''));

async function open(page: Page, hash = '', query = '?theme=light'): Promise<string[]> {
  const wrong: string[] = [];
  page.on('console', (message) => message.type() === 'error' && wrong.push(message.text()));
  page.on('pageerror', (error) => wrong.push(error.message));
  page.on('request', (request) => new URL(request.url()).host.startsWith('127.0.0.1') || wrong.push(`leaves the origin: ${request.url()}`));
  await page.goto(`/${query}${hash}`);
  await expect(id(page, 'connection')).toHaveText('Live');
  return wrong;
}

test.beforeEach(async ({ request }) => {
  await request.post('/api/v1/project', { data: { example: 'dosing' } });
});

test('1–7: it opens live, without an error', async ({ page }) => {
  const wrong = await open(page);
  for (const part of ['plant', 'io-rack', 'program', 'inspector', 'timeline']) await expect(id(page, part)).toBeVisible();
  const before = await number(page);
  await expect.poll(() => number(page)).toBeGreaterThan(before);
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

test('21–23, 26, 27: pause, steps, the past and back; nothing jumps', async ({ page }) => {
  await open(page);
  await page.waitForTimeout(1000);
  const place = async () => [(await id(page, 'strip').boundingBox())?.height, (await id(page, 'stl').boundingBox())?.y];
  const before = await place();
  await id(page, 'pause').click();
  await expect(id(page, 'pause')).toContainText('Go on');
  const stands = await number(page);
  await page.waitForTimeout(500);
  expect(await number(page)).toBe(stands);
  await page.keyboard.press('.');
  await expect(page.locator('body')).toHaveAttribute('data-state', 'stepping');
  const first = await id(page, 'reason').textContent();
  await page.keyboard.press('.');
  await expect(id(page, 'reason')).not.toHaveText(first ?? '');
  await page.keyboard.press(',');
  await expect(id(page, 'reason')).toHaveText(first ?? '');
  await page.keyboard.press('End');
  await id(page, 'pause').click();
  await expect(id(page, 'connection')).toHaveText('Live');
  await id(page, 'pause').click();
  await expect(id(page, 'pause')).toContainText('Go on');
  const n = await number(page);
  await id(page, 'step-scan-back').click();
  await expect.poll(() => number(page)).toBe(n - 1);
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
  await page.waitForTimeout(2500);
  const track = id(page, 'timeline-track');
  const box = (await track.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  await page.mouse.click(box.x + box.width - 80, box.y + 30);
  await expect(id(page, 'connection')).toHaveText('Past');
  const n = await number(page);
  const flow = await id(page, 'in-0.7').getAttribute('data-on');
  const trace = await (await request.get(`/api/v1/trace?from=${n}&to=${n}&channels=FLOW&format=csv`)).text();
  expect(flow).toBe(trace.trim().split('\n')[1]?.split(',')[1]);
  await expect(id(page, 'in-0.1').getByRole('switch')).toBeDisabled();
  await expect(id(page, 'in-0.1').getByRole('switch')).toHaveAttribute('title', /past/);
  await expect(id(page, 'plant-start')).toHaveAttribute('aria-disabled', 'true');
  await track.focus();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => number(page)).toBe(n - 1);
  await page.keyboard.press('PageDown');
  await expect.poll(() => number(page)).toBe(Math.max(0, n - 101));
  await expect(track).toHaveAttribute('aria-valuetext', /Scan \d+ at [\d.]+ s, in the past/);
  await id(page, 'nav-watch').click();
  await expect(id(page, 'watch-modify')).toBeDisabled();
  await expect(id(page, 'watch-modify')).toHaveAttribute('title', /past/);
  await expect(id(page, 'force-add')).toBeDisabled();
});

test('31, 32: STOP and RUN', async ({ page }) => {
  await open(page);
  await id(page, 'mode-stop').click();
  await expect(id(page, 'led-stop')).toHaveAttribute('data-on', '1');
  await expect(id(page, 'out-0.0')).toHaveAttribute('data-on', '0');
  await expect(id(page, 'mode-mres')).toBeEnabled();
  await expect(id(page, 'state-message')).toContainText('The CPU is in STOP');
  await id(page, 'mode-run').click();
  await expect(id(page, 'connection')).toHaveText('Live');
});

test('33: the server goes away and comes back', async ({ page }) => {
  const port = '7312';
  const start = async (): Promise<ChildProcess> => {
    const child = spawn('node', [fileURLToPath(new URL('../dev/server.js', import.meta.url))], { env: { ...process.env, PORT: port } });
    await new Promise((done) => child.stdout.once('data', done));
    return child;
  };
  let server = await start();
  try {
    await page.goto(`http://127.0.0.1:${port}/#watch`);
    await expect(id(page, 'connection')).toHaveText('Live');
    await id(page, 'watch-new-C0').fill('12');
    server.kill('SIGKILL');
    await expect(id(page, 'connection')).toHaveText('Offline', { timeout: 3000 });
    await expect(id(page, 'state-message')).toContainText(/These are the values of scan [\d,]+/);
    for (const control of ['watch-modify', 'force-add', 'mode-stop', 'pause', 'watch-tick-C0']) await expect(id(page, control)).toBeDisabled();
    server = await start();
    await expect(id(page, 'connection')).toHaveText('Live', { timeout: 16_000 });
    await expect(id(page, 'watch-new-C0')).toHaveValue('12');
  } finally {
    server.kill('SIGKILL');
  }
});

test('79: who may only look finds nothing to write with', async ({ page }) => {
  const child = spawn('node', [fileURLToPath(new URL('../dev/server.js', import.meta.url))], { env: { ...process.env, PORT: '7313', ROLE: 'view' } });
  try {
    await new Promise((done) => child.stdout.once('data', done));
    await page.goto('http://127.0.0.1:7313/');
    await expect(page.locator('body')).toHaveAttribute('data-state', 'readonly');
    await expect(id(page, 'connection')).toHaveText('View only');
    for (const control of ['mode-run', 'mode-stop', 'mode-mres', 'speed', 'plant-fault']) await expect(id(page, control)).toBeDisabled();
    await expect(id(page, 'in-0.1').getByRole('switch')).toBeDisabled();
    await expect(id(page, 'plant-start')).toHaveAttribute('aria-disabled', 'true');
    const answer = await page.request.patch('http://127.0.0.1:7313/api/v1/tags', { data: { 'I 0.0': true } });
    expect(answer.status()).toBe(403);
  } finally {
    child.kill('SIGKILL');
  }
});

test('36–39, 43: diagrams with power flow', async ({ page, request }) => {
  await request.post('/api/v1/project', { data: { example: 'star-delta' } });
  await open(page, '#program/FB20/n8');
  await id(page, 'view-lad').click();
  await expect(id(page, 'lad-contact-120')).toHaveAttribute('data-flow', '1');
  await expect(id(page, 'lad-contact-120')).toHaveAttribute('data-value', '1');
  await id(page, 'view-side').click();
  const side = id(page, 'side-by-side');
  for (const form of ['LAD', 'STL', 'FBD']) await expect(side.getByRole('heading', { name: form })).toBeVisible();
  await side.getByTestId('stl-row-123').click();
  await expect(side.getByTestId('lad-contact-123')).toHaveAttribute('aria-selected', 'true');
  await expect(side.getByTestId('fbd-contact-123')).toHaveAttribute('aria-selected', 'true');
  await id(page, 'network-3').getByRole('button').first().click();
  await expect(id(page, 'reason-3')).toContainText(/^Stays STL:.*line \d+/);
  await expect(id(page, 'instance')).toContainText('DB 20');
});

test('49–55: watch, modify, force, trigger', async ({ page }) => {
  await open(page, '#watch');
  await id(page, 'watch-add').fill('LITRES');
  await id(page, 'watch-add').press('Enter');
  await expect(id(page, 'watch-row-C0')).toHaveCount(2);
  await id(page, 'watch-row-C0').nth(1).getByTestId('watch-new-C0').fill('7');
  await id(page, 'watch-row-C0').nth(1).getByTestId('watch-tick-C0').check();
  await id(page, 'watch-modify').click();
  await id(page, 'force-address').fill('STOP');
  await id(page, 'force-value').fill('0');
  await id(page, 'force-add').click();
  const dialog = page.getByRole('dialog');
  await expect(dialog.getByLabel('Value')).toHaveValue('0');
  await dialog.getByLabel('Reason').fill('wire broken');
  await dialog.getByRole('button', { name: /^Force/ }).click();
  await expect(id(page, 'force-I0.1')).toContainText('wire broken');
  await expect(id(page, 'led-frce')).toHaveAttribute('data-on', '1');
  await expect(id(page, 'watch-row-I0.1')).toHaveClass(/forced/);
  await expect(id(page, 'watch-row-I0.1')).toContainText('forced');
  await id(page, 'force-release-I0.1').click();
  await expect(id(page, 'led-frce')).toHaveAttribute('data-on', '0');
  await expect(id(page, 'watch-force-C0')).toHaveCount(0);
  await id(page, 'trigger').fill('VALVE rises');
  await id(page, 'trigger').press('Enter');
  await page.keyboard.press('Escape');
  await id(page, 'nav-live').click();
  await expect(id(page, 'plant-start')).toBeVisible();
});

test('58: ten thousand rows, a hundred in the page', async ({ page }) => {
  await open(page, '#watch/big.watch');
  await expect(id(page, 'watch-table')).toHaveAttribute('aria-rowcount', '10001');
  expect(await id(page, 'watch-table').locator('tbody tr').count()).toBeLessThanOrEqual(100);
  await page.locator('.vat-panel .pb').evaluate((node) => (node.scrollTop = 100_000));
  await expect(page.locator('.vat-panel tr[aria-rowindex="3575"]')).toBeAttached();
});

test('65, 68: symbols are found and judged', async ({ page, request }) => {
  await request.post('/api/v1/project', { data: { example: 'tank' } });
  await open(page, '#symbols');
  await expect(id(page, 'symbol-InletOpen')).toContainText('unused');
  await id(page, 'symbols-filter').fill('over');
  await expect(id(page, 'symbols-count')).toHaveText('2 of 25');
});

for (const theme of ['light', 'dark', 'hc'])
  test(`72: axe finds nothing in five views, ${theme}`, async ({ page }) => {
    test.setTimeout(90_000);
    const source = readFileSync(new URL('../node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
    for (const view of ['live', 'program', 'watch', 'symbols', 'cpu']) {
      await page.goto('about:blank');
      await open(page, `#${view}`, `?theme=${theme}`);
      await page.waitForTimeout(700);
      await page.evaluate(source);
      // The contract leaves out experimental rules; the one that is named is the only one of these tags.
      const found = await page.evaluate(async () => {
        const axe = (window as unknown as { axe: { run(node: Document, options: unknown): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> } }).axe;
        const result = await axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'], rules: { 'label-content-name-mismatch': { enabled: false } } });
        return result.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 160)).join(' | ')}`);
      });
      expect(found, view).toEqual([]);
    }
  });

test('74: a phone has no horizontal scroll and large targets', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  for (const view of ['live', 'program', 'watch', 'symbols', 'cpu']) {
    await page.goto('about:blank');
    await open(page, `#${view}`);
    await page.waitForTimeout(400);
    expect(await page.evaluate(() => document.documentElement.scrollWidth), view).toBeLessThanOrEqual(390);
    const small = await page.evaluate(() =>
      [...document.querySelectorAll<HTMLElement>('button, [role=switch], [role=tab], input, select, nav.rail a')]
        .filter((node) => node.offsetParent !== null && !node.closest('[popover]'))
        .map((node) => [node, node.getBoundingClientRect()] as const)
        .filter(([, box]) => box.width > 0 && (box.width < 43.5 || box.height < 43.5))
        .map(([node, box]) => `${node.dataset['testid'] ?? node.className ?? node.tagName} ${Math.round(box.width)}×${Math.round(box.height)}`),
    );
    expect(small, view).toEqual([]);
  }
});

test('75: on a projector the plant, 13 rows and the reason are in sight', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  await open(page);
  await expect(id(page, 'plant-picture')).toBeInViewport({ ratio: 1 });
  await expect(id(page, 'reason')).toBeInViewport();
  const rows = await page.locator('[data-testid^=stl-row-]').evaluateAll((all) => all.filter((row) => row.getBoundingClientRect().bottom <= (row.closest('.pb')?.getBoundingClientRect().bottom ?? 0)).length);
  expect(rows).toBeGreaterThanOrEqual(13);
});

test('76: themes in their order, and kept', async ({ page }) => {
  await page.goto('/');
  const theme = () => page.locator('html').getAttribute('data-theme');
  expect(await theme()).toBe('light');
  for (const wanted of ['dark', 'hc', 'light', 'dark']) {
    await id(page, 'theme').click();
    expect(await theme()).toBe(wanted);
  }
  await page.reload();
  expect(await theme()).toBe('dark');
});

test('77: German has no English word of the table', async ({ page, request }) => {
  // Comments of the project stay as they are.
  const project = ((await (await request.get('/api/v1/symbols')).json()) as { comment: string }[]).map((one) => one.comment);
  const english = Object.values(TABLE).filter(([en, de]) => en !== de && !project.includes(en) && !en.includes('{') && en.length > 4).map(([en]) => en);
  const german = new Set(Object.values(TABLE).map(([, de]) => de));
  for (const view of ['live', 'program', 'watch', 'symbols', 'cpu']) {
    await page.goto('about:blank');
    await page.goto(`/?theme=light&lang=de#${view}`);
    await expect(id(page, 'connection')).toHaveText('Live');
    await page.waitForTimeout(500);
    await expect(page.locator('html')).toHaveAttribute('lang', 'de');
    const texts = await page.evaluate(() => {
      const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
      const out: string[] = [];
      while (walker.nextNode()) out.push(walker.currentNode.textContent?.trim() ?? '');
      for (const node of document.querySelectorAll('[title],[aria-label],[placeholder]')) for (const name of ['title', 'aria-label', 'placeholder']) out.push(node.getAttribute(name) ?? '');
      return out;
    });
    expect(texts.filter((text) => english.includes(text) && !german.has(text)), view).toEqual([]);
  }
});

test('84: with reduced motion nothing is animated', async ({ browser }) => {
  const context = await browser.newContext({ reducedMotion: 'reduce' });
  const page = await context.newPage();
  await page.goto('/');
  await expect(id(page, 'plant-picture')).toBeVisible();
  expect(await page.evaluate(() => document.getAnimations().filter((one) => one.playState === 'running').length)).toBe(0);
  await context.close();
});
