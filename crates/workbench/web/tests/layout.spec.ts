// What the design says about sizes: columns, drawer, presentation.
import { dose, expect, id, open, test, type Page } from './sieben';

const width = async (page: Page, name: string) => Math.round((await id(page, name).boundingBox())?.width ?? 0);

test('columns are made wider by keys, kept for their view, and reset', async ({ page }) => {
  await open(page);
  const before = await width(page, 'inspector');
  const splitter = page.locator('.splitter.s-whyw');
  await splitter.focus();
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => width(page, 'inspector')).toBe(before + 32);
  await id(page, 'nav-program').click();
  await expect.poll(() => width(page, 'inspector')).toBe(before);
  await id(page, 'nav-live').click();
  await expect.poll(() => width(page, 'inspector')).toBe(before + 32);
  await page.reload();
  await expect.poll(() => width(page, 'inspector')).toBe(before + 32);
  await splitter.dblclick();
  await expect.poll(() => width(page, 'inspector')).toBe(before);
});

test('below 1100 px the reasons are a drawer and the blocks a menu', async ({ page }) => {
  await page.setViewportSize({ width: 1024, height: 768 });
  await open(page);
  await expect(id(page, 'inspector')).not.toBeVisible();
  await id(page, 'why-open').click();
  await expect(id(page, 'reason')).toBeInViewport({ ratio: 1 });
  await expect(id(page, 'why-close')).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(id(page, 'inspector')).not.toBeVisible();
  await expect(id(page, 'why-open')).toBeFocused();
  await id(page, 'nav-program').click();
  await id(page, 'block-menu').click();
  await id(page, 'block-menu-OB1').click();
  await expect(page).toHaveURL(/#program\/OB1/);
});

for (const [name, size, query] of [
  ['1440×900', [1440, 900], ''], ['1367×768', [1367, 768], ''], ['1280×720', [1280, 720], ''], ['1024×768', [1024, 768], ''], ['820×1180', [820, 1180], ''], ['390×844', [390, 844], ''], ['320 px', [320, 700], ''],
  ['200 %', [720, 450], ''], ['presentation', [1440, 900], '&zoom=1.25'],
] as const)
  test(`nothing is cut off at ${name}`, async ({ page }) => {
    await page.setViewportSize({ width: size[0], height: size[1] });
    for (const view of ['live', 'program']) {
      await page.goto('about:blank');
      const wrong = await open(page, `#${view}`, `?theme=light${query}`);
      await page.waitForTimeout(300);
      const cut = await page.evaluate(() => {
        const out: string[] = [];
        if (document.documentElement.scrollWidth > innerWidth) out.push(`the page scrolls: ${document.documentElement.scrollWidth}`);
        if (document.documentElement.scrollHeight > innerHeight) out.push(`the page scrolls down: ${document.documentElement.scrollHeight}`);
        for (const node of document.querySelectorAll<HTMLElement>('.top button, .strip [data-testid=connection], .ph button, .time button')) {
          const box = node.getBoundingClientRect();
          if (box.width === 0 || getComputedStyle(node).visibility === 'hidden') continue;
          const at = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
          if (box.top >= 0 && box.bottom <= innerHeight && at !== null && !node.contains(at) && !node.closest('.main')) out.push(`${node.dataset['testid']} is covered by ${at.className}`);
          if (box.right > innerWidth + 1) out.push(`${node.dataset['testid']} ends at ${Math.round(box.right)}`);
        }
        return out;
      });
      expect([...cut, ...wrong.filter((text) => !text.includes('404'))], view).toEqual([]);
    }
  });

test('nothing that a hand can do ends the connection', async ({ page }) => {
  test.setTimeout(60_000);
  let connections = 0;
  page.on('websocket', () => (connections += 1));
  await open(page);
  await dose(page);
  await page.waitForTimeout(1500);
  const track = id(page, 'timeline-track');
  const box = (await track.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  await page.mouse.move(box.x + box.width - 20, box.y + 30);
  await page.mouse.down();
  for (let i = 0; i < 300; i += 1) await page.mouse.move(box.x + box.width - 20 - (i % 150), box.y + 30);
  await page.mouse.up();
  await expect(id(page, 'connection')).toHaveText('Past');
  // A key held down repeats thirty times a second.
  for (let i = 0; i < 90; i += 1) await page.keyboard.press('ArrowLeft', { delay: 5 });
  await page.keyboard.press('End');
  await id(page, 'stl-row-8').click();
  for (let i = 0; i < 90; i += 1) await page.keyboard.press(i % 24 < 12 ? 'ArrowDown' : 'ArrowUp', { delay: 5 });
  await page.waitForTimeout(1500);
  expect(connections).toBe(1);
  await expect(id(page, 'connection')).toHaveText('Live');
});
