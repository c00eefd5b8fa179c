// Checks of the contract: who may do what, hostile frames, many pages.
import { readFileSync } from 'node:fs';
import { get } from 'node:http';
import { join } from 'node:path';
import WebSocket from 'ws';
import { EXAMPLES, expect, id, open, scan, test } from './sieben';

/** What the server answers to an opened WebSocket with this origin: 101 if it takes it. */
async function upgrade(url: string, origin: string): Promise<number> {
  return new Promise((done, failed) => {
    const asked = get(`${url}/ws`, { headers: { origin, connection: 'Upgrade', upgrade: 'websocket', 'sec-websocket-version': '13', 'sec-websocket-key': 'dGhlIHNhbXBsZSBub25jZQ==' } });
    asked.once('upgrade', (_, socket) => {
      socket.destroy();
      done(101);
    });
    asked.once('response', (answer) => {
      answer.resume();
      done(answer.statusCode ?? 0);
    });
    asked.once('error', failed);
  });
}

const settings = readFileSync(join(EXAMPLES, 'dosing', 'sieben.toml'), 'utf8');

test.describe('with tokens', () => {
  test.use({ files: { 'sieben.toml': `${settings}\n[servers.page]\ntokens = "tokens"\n` } });
  test('79: who may only look finds nothing to write with', async ({ page, request, sieben }) => {
    const tokens = [...sieben.printed.matchAll(/token=(\S+)/g)].map((found) => found[1]?.replace(/[.,]$/, '') ?? '');
    expect(tokens, sieben.printed).toHaveLength(2);
    const [all, view] = tokens;
    await page.goto(`/?theme=light&token=${view}`);
    await expect(page.locator('body')).toHaveAttribute('data-state', 'readonly');
    await expect(id(page, 'connection')).toHaveText('View only');
    expect(page.url()).not.toContain('token');
    for (const control of ['mode-run', 'mode-stop', 'mode-mres', 'speed', 'plant-fault', 'pause']) await expect(id(page, control), control).toBeDisabled();
    await expect(id(page, 'in-0.1').getByRole('switch')).toBeDisabled();
    await expect(id(page, 'plant-start')).toHaveAttribute('aria-disabled', 'true');
    await id(page, 'nav-watch').click();
    for (const control of ['watch-modify', 'force-add', 'watch-tick-C0', 'watch-new-C0']) await expect(id(page, control), control).toBeDisabled();
    const ask = async (token: string | undefined, method: 'patch' | 'post' | 'delete', path: string, data: object) =>
      (await request[method](`/api/v1/${path}`, { data, headers: token === undefined ? {} : { authorization: `Bearer ${token}` } })).status();
    const writes = [['patch', 'tags', { 'I 0.0': true }], ['post', 'mode', { mode: 'stop' }], ['post', 'time', { pause: true }], ['post', 'forces', { name: 'I 0.1', value: 0, reason: 'x' }], ['delete', 'forces', {}], ['post', 'press', { items: ['I 0.0'], ms: 10 }], ['post', 'faults', { name: 'plant.flow', fault: 'stuck=0' }], ['post', 'project', { example: 'tank' }]] as const;
    for (const [method, path, data] of writes) {
      expect(await ask(view, method, path, data), path).toBe(403);
      expect(await ask(undefined, method, path, data), path).toBe(401);
      expect(await ask('wrong', method, path, data), path).toBe(401);
    }
    expect(await ask(all, 'patch', 'tags', { 'M 50.0': true })).toBe(200);
  });
});

test.describe('without its token', () => {
  test.use({ files: { 'sieben.toml': `${settings}\n[servers.page]\ntokens = "tokens"\n` } });
  test('a page without its token says where to find it', async ({ page, sieben }) => {
    await page.goto('/?theme=light');
    await expect(id(page, 'no-token')).toContainText('?token=');
    await expect(id(page, 'no-token')).toContainText('.sieben/page-tokens');
    await expect(id(page, 'no-token').getByRole('link')).toHaveAttribute('href', '/docs/problems/P7132');
    await page.keyboard.press('Escape');
    await expect(id(page, 'connection')).toHaveText('Offline');
    const token = /token=([^\s.,]+)/.exec(sieben.printed)?.[1] ?? '';
    await page.goto(`/?theme=light&token=${token}`);
    await expect(id(page, 'connection')).toHaveText('Live');
    await expect(id(page, 'no-token')).toHaveCount(0);
  });
});

test('80: another origin and another host are refused', async ({ request, sieben }) => {
  const headers = { origin: 'http://evil.example' };
  expect((await request.post('/api/v1/mode', { data: { mode: 'stop' }, headers })).status()).toBe(403);
  expect(await upgrade(sieben.url, sieben.url)).toBe(101);
  for (const origin of ['http://evil.example', 'null', sieben.url.replace('127.0.0.1', '127.0.0.2')]) expect(await upgrade(sieben.url, origin), origin).toBe(403);
  expect((await request.get('/api/v1/state', { headers: { host: 'evil.example' } })).status()).toBe(421);
  expect((await request.patch('/api/v1/tags', { data: { 'M 50.0': true }, headers: { origin: sieben.url } })).ok()).toBe(true);
});

test('81: ten thousand hostile frames: goodbye, and other pages stay live', async ({ page, sieben }) => {
  test.setTimeout(90_000);
  await open(page);
  const hello = '{"t":"hello","v":1}';
  const kinds: (string | Uint8Array)[] = ['['.repeat(60_000), `{"t":${'{"t":'.repeat(10_000)}`, 'x'.repeat(1_000_000), new Uint8Array([0xff, 0xfe, 0x00]), '{"t":"nothing"}', '{"t":"at","scan":-1}', '{"t":"sub","id":"r","what":"rows","block":"OB1","from":0,"to":4294967295}', '{"t":"history","id":"h","from":0,"to":1e99,"channels":[],"points":-1}'];
  const attack = (kind: string | Uint8Array) =>
    new Promise<string>((done) => {
      const socket = new WebSocket(`ws://127.0.0.1:${sieben.port}/ws`);
      let bye = '';
      socket.onopen = () => {
        socket.send(hello);
        for (let i = 0; i < 25; i += 1) socket.send(kind);
      };
      socket.onmessage = (event) => {
        const message = JSON.parse(String(event.data)) as { t: string; why?: string };
        if (message.t === 'bye') bye = message.why ?? '';
      };
      socket.onclose = () => done(bye);
      socket.onerror = () => {};
    });
  const before = await scan(page);
  let frames = 0;
  const goodbyes = kinds.map(() => new Set<string>());
  while (frames < 10_000) {
    const round = await Promise.all(kinds.map(attack));
    // A busy machine may lose the farewell to one who still sends.
    round.forEach((why, kind) => why && goodbyes[kind]?.add(why));
    frames += kinds.length * 25;
  }
  expect(goodbyes.map((of) => [...of].join())).toEqual(['P7131', 'P7131', 'P7130', 'P7131', 'P7131', 'P7131', 'P7130', 'P7131']);
  await expect(id(page, 'connection')).toHaveText('Live');
  await expect.poll(() => scan(page)).toBeGreaterThan(before + 20);
});

test('82: fifty pages, each with each scan that it is told', async ({ page, sieben }) => {
  test.setTimeout(60_000);
  await open(page);
  const pages = await Promise.all(
    Array.from({ length: 50 }, () => new Promise<{ socket: WebSocket; scans: number[]; seen: () => number }>((done) => {
      const socket = new WebSocket(`ws://127.0.0.1:${sieben.port}/ws`);
      const scans: number[] = [];
      socket.onopen = () => {
        for (const message of [{ t: 'hello', v: 1 }, { t: 'sub', id: 'r', what: 'rows', block: 'OB1', from: 0, to: 20 }, { t: 'sub', id: 'p', what: 'plant' }]) socket.send(JSON.stringify(message));
        done({ socket, scans, seen: () => scans.length });
      };
      socket.onmessage = (event) => {
        const message = JSON.parse(String(event.data)) as { t: string; n: number; seq: number };
        if (message.t !== 'scan') return;
        scans.push(message.n);
        socket.send(JSON.stringify({ t: 'ack', seq: message.seq }));
      };
    })),
  );
  await expect.poll(() => Math.min(...pages.map((one) => one.seen())), { timeout: 30_000 }).toBeGreaterThan(20);
  for (const { scans } of pages) expect(scans).toEqual([...scans].sort((a, b) => a - b));
  await expect(id(page, 'connection')).toHaveText('Live');
  pages.forEach(({ socket }) => socket.close());
});
