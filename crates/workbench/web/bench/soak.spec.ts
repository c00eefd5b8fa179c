// A page that stays open: its memory does not grow, and it is not sent too much.
import { readFileSync } from 'node:fs';
import { expect, id, open, test } from '../tests/sieben';

const MINUTES = Number(process.env['SOAK_MINUTES'] ?? 60);
/** The first look that counts: until then caches fill. Ten minutes of an hour. */
const FIRST_MINUTE = Math.max(1, Math.round(MINUTES / 6));
/** What the page may hold more at the end. */
const GROWTH_BYTES_MAX = 5 * 1024 * 1024;
/** What a page may be sent. */
const BYTES_PER_SECOND_MAX = 60_000;

test.setTimeout((MINUTES + 3) * 60_000);

test('soak: a page that stays open', async ({ page, browser, request }) => {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable');
  await session.send('Network.enable');
  let bytes = 0;
  session.on('Network.webSocketFrameReceived', ({ response }) => (bytes += response.payloadData.length));
  await open(page);
  const system = await browser.newBrowserCDPSession();
  const looks: { minute: number; heap: number; nodes: number }[] = [];
  for (let minute = 1; minute <= MINUTES; minute++) {
    const begun = Date.now();
    const before = bytes;
    // A dose at the beginning of each minute; the views take turns.
    await request.post('/api/v1/press', { data: { items: ['I 0.0'], ms: 300 } });
    for (const view of minute % 5 === 0 ? ['program', 'watch', 'symbols', 'cpu', 'live'] : []) {
      await id(page, `nav-${view}`).click();
      await page.waitForTimeout(1000);
    }
    await page.waitForTimeout(Math.max(0, 60_000 - (Date.now() - begun)));
    const rate = (bytes - before) / ((Date.now() - begun) / 1000);
    await session.send('HeapProfiler.collectGarbage');
    const { metrics } = await session.send('Performance.getMetrics');
    const metric = (name: string) => metrics.find((one) => one.name === name)?.value ?? NaN;
    const { processInfo } = await system.send('SystemInfo.getProcessInfo');
    const resident = processInfo.filter((one) => one.type === 'renderer').map((one) => /VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${one.id}/status`, 'utf8'))?.[1]);
    looks.push({ minute, heap: metric('JSHeapUsedSize'), nodes: metric('Nodes') });
    const mib = (metric('JSHeapUsedSize') / 1024 / 1024).toFixed(2);
    console.log(`minute ${minute}: ${mib} MiB in use, ${metric('Nodes')} nodes, ${metric('JSEventListeners')} listeners, ${(rate / 1000).toFixed(1)} kB/s; resident ${resident.join(', ')} KiB`);
    expect(rate, 'bytes a second').toBeLessThanOrEqual(BYTES_PER_SECOND_MAX);
    await expect(id(page, 'connection')).toHaveText('Live');
  }
  const [first, last] = [looks.find((look) => look.minute === FIRST_MINUTE), looks.at(-1)];
  console.log(`soak page: ${first?.heap} bytes after ${FIRST_MINUTE} min, ${last?.heap} after ${MINUTES} min`);
  expect((last?.heap ?? NaN) - (first?.heap ?? NaN), 'growth').toBeLessThanOrEqual(GROWTH_BYTES_MAX);
});
