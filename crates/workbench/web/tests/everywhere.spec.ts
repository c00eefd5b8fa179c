// Checks of the contract: everywhere.
import { readFileSync } from 'node:fs';
import { expect, id, open, test } from './sieben';
import { TABLE } from './words';

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
