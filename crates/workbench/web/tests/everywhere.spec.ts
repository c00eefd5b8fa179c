// Checks of the contract: everywhere.
import { violations } from './axe';
import { expect, id, open, scan, test, type Page } from './sieben';
import { TABLE } from './words';

const THEMES = ['light', 'dark', 'hc'];

for (const theme of THEMES)
  test(`72: axe finds nothing in five views, ${theme}`, async ({ page }) => {
    test.setTimeout(90_000);
    for (const view of ['live', 'program', 'watch', 'symbols', 'cpu']) {
      await page.goto('about:blank');
      await open(page, `#${view}`, `?theme=${theme}`);
      await page.waitForTimeout(700);
      expect(await violations(page), view).toEqual([]);
    }
  });

/** What can be opened in a view, and how. */
const MENUS: [view: string, testid: string][] = [
  ['live', 'project-menu'], ['live', 'step-unit'], ['live', 'speed'], ['live', 'columns'], ['live', 'plant-fault'], ['watch', 'timing-export'],
];
const DIALOGS: [view: string, testid: string, how: (page: Page) => Promise<void>][] = [
  ['live', 'palette', (page) => page.keyboard.press('Control+k')],
  ['live', 'palette', async (page) => {
    await page.keyboard.press('Control+k');
    await id(page, 'palette-input').fill('MW 4711');
  }],
  ['live', 'keys', (page) => page.keyboard.press('?')],
  ['watch', 'force-dialog', (page) => id(page, 'watch-force-I0.1').click()],
  ['live', 'ask-stop', (page) => id(page, 'mode-stop').click()],
];

for (const theme of THEMES)
  test(`72: axe finds nothing in menus and dialogs, ${theme}`, async ({ page }) => {
    test.setTimeout(120_000);
    // STOP asks while a client is connected.
    await page.route('**/api/v1/clients', (route) => route.fulfill({ json: [{ id: 'S7 1', name: 'OP', protocol: 'S7', peer: '127.0.0.1:1' }] }));
    await open(page, '#live', `?theme=${theme}`);
    await expect(id(page, 'plant-fault')).toBeVisible();
    for (const [view, testid] of MENUS) {
      await id(page, `nav-${view}`).click();
      await id(page, testid).click();
      await expect(page.locator('.menu:popover-open')).toBeVisible();
      expect(await violations(page), testid).toEqual([]);
      await page.keyboard.press('Escape');
      await expect(page.locator('.menu:popover-open')).toHaveCount(0);
    }
    for (const [view, testid, how] of DIALOGS) {
      await id(page, `nav-${view}`).click();
      await how(page);
      await expect(id(page, testid)).toBeVisible();
      expect(await violations(page), testid).toEqual([]);
      await page.keyboard.press('Escape');
      await expect(page.getByRole('dialog')).toHaveCount(0);
    }
    // What is not in sight on wide screens: the drawer of reasons and the menu of blocks.
    await page.setViewportSize({ width: 1024, height: 768 });
    await id(page, 'nav-program').click();
    await id(page, 'block-menu').click();
    expect(await violations(page), 'block-menu').toEqual([]);
    await page.keyboard.press('Escape');
    await id(page, 'nav-live').click();
    await id(page, 'why-open').click();
    await expect(id(page, 'inspector')).toBeVisible();
    expect(await violations(page), 'drawer').toEqual([]);
    await page.keyboard.press('Escape');
  });

for (const theme of THEMES)
  test(`72: axe finds nothing in the past, in STOP and on a phone, ${theme}`, async ({ page }) => {
    test.setTimeout(90_000);
    await open(page, '#live', `?theme=${theme}`);
    await expect.poll(() => scan(page)).toBeGreaterThan(30);
    await id(page, 'step-scan-back').click();
    await expect(id(page, 'connection')).toHaveText('Past');
    expect(await violations(page), 'past').toEqual([]);
    await page.keyboard.press('End');
    await id(page, 'mode-stop').click();
    await expect(id(page, 'connection')).toHaveText('STOP');
    for (const view of ['live', 'cpu']) {
      await id(page, `nav-${view}`).click();
      expect(await violations(page), `STOP, ${view}`).toEqual([]);
    }
    await page.setViewportSize({ width: 390, height: 844 });
    for (const view of ['live', 'program', 'watch', 'symbols', 'cpu']) {
      await id(page, `nav-${view}`).click();
      await page.waitForTimeout(300);
      expect(await violations(page), `phone, ${view}`).toEqual([]);
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
  const rows = () => page.locator('[data-testid^=stl-row-]').evaluateAll((all) => all.filter((row) => row.getBoundingClientRect().bottom <= (row.closest('.pb')?.getBoundingClientRect().bottom ?? 0)).length);
  await expect.poll(rows).toBeGreaterThanOrEqual(13);
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

/** Words that an English sentence has and a German one has not. */
const ENGLISH = /\b(the|is|are|of|and|not|with|from|this|that|has|have|by|no)\b/i;

/** Texts that people read or hear, without code and without what says itself that it is English. */
const texts = (page: Page) =>
  page.evaluate(() => {
    const isOther = (node: Element | null) => node?.closest('code, kbd, .kbd, .mono, td.m, td.op, td.text, .stl .lbl, [lang=en], script, noscript, style, svg text') != null;
    const out: string[] = [document.title];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) if (!isOther(walker.currentNode.parentElement)) out.push(walker.currentNode.textContent?.trim() ?? '');
    for (const name of ['title', 'aria-label', 'placeholder', 'aria-valuetext']) for (const node of document.querySelectorAll(`[${name}]`)) if (!isOther(node)) out.push(node.getAttribute(name) ?? '');
    return out;
  });

test('77: German has no English', async ({ page, request }) => {
  test.setTimeout(90_000);
  // Names and comments of the project stay as they are.
  const project = ((await (await request.get('/api/v1/symbols')).json()) as { symbol: string; comment: string }[]).flatMap((one) => [one.symbol, one.comment]);
  const blocks = ((await (await request.get('/api/v1/blocks')).json()) as { title: string }[]).map((one) => one.title);
  const networks = ((await (await request.get('/api/v1/blocks/OB1')).json()) as { networks: { title: string }[] }).networks.map((one) => one.title);
  const watched = ((await (await request.get('/api/v1/watch/dosing.watch')).json()) as { comment: string }[]).map((one) => one.comment);
  const plants = ((await (await request.get('/api/v1/plants')).json()) as { detail: string; name: string; signals: { name: string; about: string }[] }[]).flatMap((one) => [one.detail, one.name, ...one.signals.flatMap((signal) => [signal.name, signal.about])]);
  const own = [...project, ...blocks, ...networks, ...watched, ...plants].filter((text) => text !== undefined && text !== '');
  const german = new Set(Object.values(TABLE).map(([, de]) => de));
  const pattern = (text: string) => new RegExp(`^${text.replace(/[.*+?^$()|[\]\\]/g, '\\$&').replace(/\{\d\}/g, '.+')}$`);
  const english = Object.values(TABLE).filter(([en, de]) => en !== de && en.replace(/\{\d\}/g, '').trim().length > 2 && !german.has(en)).map(([en]) => pattern(en));
  const alsoGerman = Object.values(TABLE).map(([, de]) => pattern(de));
  const nothing = async (where: string) => {
    const wrong = (await texts(page)).filter((text) => !own.some((one) => text === one || text.includes(one) && !ENGLISH.test(text.replace(one, '')))).filter((text) => ENGLISH.test(text) || english.some((one) => one.test(text) && !alsoGerman.some((other) => other.test(text))));
    expect.soft([...new Set(wrong)], where).toEqual([]);
  };
  await page.goto('/?theme=light&lang=de#live');
  await expect(id(page, 'connection')).toHaveText('Live');
  await expect(page.locator('html')).toHaveAttribute('lang', 'de');
  for (const view of ['live', 'program', 'watch', 'symbols', 'cpu']) {
    await id(page, `nav-${view}`).click();
    await page.waitForTimeout(500);
    await nothing(view);
  }
  for (const [view, testid] of MENUS) {
    await id(page, `nav-${view}`).click();
    await id(page, testid).click();
    await nothing(testid);
    await page.keyboard.press('Escape');
  }
  for (const [view, testid, how] of DIALOGS.filter(([, testid]) => testid !== 'ask-stop')) {
    await id(page, `nav-${view}`).click();
    await how(page);
    await expect(id(page, testid)).toBeVisible();
    await nothing(testid);
    await page.keyboard.press('Escape');
  }
  await id(page, 'nav-live').click();
  await id(page, 'stl-row-21').click();
  await id(page, 'who').click();
  await expect(id(page, 'who-answer')).toBeVisible();
  await nothing('who');
  await page.keyboard.press('<');
  await expect(id(page, 'connection')).toHaveText('Vergangenheit');
  await nothing('past');
  await page.keyboard.press('End');
  await id(page, 'mode-stop').click();
  await expect(id(page, 'connection')).toHaveText('STOP');
  await nothing('STOP');
  await id(page, 'nav-cpu').click();
  await page.waitForTimeout(500);
  await nothing('STOP, CPU');
});

test('84: with reduced motion nothing is animated', async ({ browser }) => {
  const context = await browser.newContext({ reducedMotion: 'reduce' });
  const page = await context.newPage();
  await page.goto('/');
  await expect(id(page, 'plant-picture')).toBeVisible();
  expect(await page.evaluate(() => document.getAnimations().filter((one) => one.playState === 'running').length)).toBe(0);
  await context.close();
});
