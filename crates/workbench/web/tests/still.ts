// A run that stands still at a scan that is known, for pictures that are the same each time.
import type { APIRequestContext, Page } from '@playwright/test';
import { expect, id, type Sieben } from './sieben';

/** Scans that a run may have made before it is held; what is done to it is done later. */
const HELD_BEFORE = 90;
/** Scans that are asked for at once: what changes in them is seen scan by scan. */
const STEP_MAX = 100;
/** So often a run that was held too late is begun again. */
const ATTEMPTS = 10;

/** How many scans a run has made. */
async function scans(request: APIRequestContext): Promise<number> {
  return ((await (await request.get('/api/v1/state')).json()) as { scans: number }).scans;
}

/** Holds the run at its beginning. */
export async function hold(sieben: Sieben, request: APIRequestContext): Promise<void> {
  for (let attempt = 0; attempt < ATTEMPTS; attempt++) {
    await request.post('/api/v1/time', { data: { pause: true } });
    if ((await scans(request)) < HELD_BEFORE) return;
    await sieben.kill();
    sieben.forget();
    await sieben.start();
  }
  throw new Error(`the run was never held before scan ${HELD_BEFORE}`);
}

/** Lets the run go on to a scan. Each of these takes its cycle, to the microsecond. */
export async function runTo(request: APIRequestContext, scan: number): Promise<void> {
  for (let done = await scans(request); done < scan; done = await scans(request)) {
    expect((await request.post('/api/v1/time', { data: { step: 'scan', n: Math.min(scan - done, STEP_MAX) } })).ok()).toBe(true);
    await expect.poll(() => scans(request)).toBeGreaterThan(done);
  }
}

/** Writes values. */
export async function write(request: APIRequestContext, values: Record<string, unknown>): Promise<void> {
  expect((await request.patch('/api/v1/tags', { data: values })).ok()).toBe(true);
}

/** What a page is made to believe of the run. */
export type Belief = 'it goes on' | 'it stands';

/**
 * Shows a page time as it would be if each scan had come in its cycle: those before the run was held came when the computer let them. If it shall believe
 * that the run goes on, it is not told that time stands.
 */
export async function undisturbed(page: Page, belief: Belief): Promise<void> {
  let cycle = 10_000;
  let messages = 0;
  await page.routeWebSocket(/\/ws/, (socket) => {
    const server = socket.connectToServer();
    server.onMessage((text) => {
      const message = JSON.parse(String(text)) as Record<string, unknown>;
      if (message['t'] === 'welcome') cycle = Number(message['cycle_us']);
      if (message['t'] === 'history') message['times'] = [message['from'], message['to']].map((scan) => [scan, Number(scan) * cycle]);
      if (message['t'] === 'scan') {
        // A microsecond more with each message: time that stands is a scan that does not end.
        message['t_us'] = Number(message['n']) * cycle + (belief === 'it goes on' ? messages++ : 0);
        message['newest_us'] = Number(message['newest']) * cycle;
        if (belief === 'it goes on') message['paused'] = false;
      }
      socket.send(JSON.stringify(message));
    });
  });
}

/** Opens a view. */
export async function show(page: Page, hash: string, theme: string, state: string): Promise<void> {
  await page.goto('about:blank');
  await page.goto(`/?theme=${theme}${hash}`);
  await expect(id(page, 'connection')).toHaveText(state);
}
