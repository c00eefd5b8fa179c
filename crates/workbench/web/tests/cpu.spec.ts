// Checks of the contract: the CPU, its diagnostic buffer, who is connected.
import { spawn, spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { EXAMPLES, expect, id, open, PYTHON, test } from './sieben';
import { join } from 'node:path';

test('69: the newest event is number 1, and a hundred are kept', async ({ page, request }) => {
  test.setTimeout(90_000);
  await open(page, '#cpu');
  await expect(id(page, 'diag-1')).toContainText(/RUN|STARTUP/);
  for (let i = 0; i < 50; i += 1)
    for (const mode of ['stop', 'run']) expect((await request.post('/api/v1/mode', { data: { mode } })).ok()).toBe(true);
  await request.post('/api/v1/mode', { data: { mode: 'stop' } });
  await expect(id(page, 'led-stop')).toHaveAttribute('data-on', '1');
  await expect(page.locator('[data-testid^=diag-]:is(li)')).toHaveCount(100);
  await expect(id(page, 'diag-1')).toContainText('STOP');
});

test('71: the buffer is saved as text', async ({ page, request }) => {
  await open(page, '#cpu');
  const saved = page.waitForEvent('download');
  await id(page, 'diag-save').click();
  const download = await saved;
  expect(download.suggestedFilename()).toBe('dosing-diagnostics.txt');
  const text = readFileSync(await download.path(), 'utf8');
  expect(text).toBe(await (await request.get('/api/v1/diagnostics?format=text')).text());
  expect(text).toContain('16#');
});

test.describe('with an S7 server', () => {
  const settings = readFileSync(join(EXAMPLES, 'dosing', 'sieben.toml'), 'utf8');
  test.use({ files: { 'sieben.toml': settings }, further: ['--s7', '127.0.0.1:0'] });
  test('70: a python-snap7 client, and what it wrote last', async ({ page, sieben }) => {
    const has = spawnSync(PYTHON, ['-c', 'import snap7'], { encoding: 'utf8' });
    if (has.status !== 0 && process.env['SIEBEN_NO_SKIP'] !== '1') test.skip(true, 'skipped: python-snap7 is not installed');
    const port = /S7[^\n]*127\.0\.0\.1:(\d+)/.exec(sieben.printed)?.[1] ?? '';
    expect(port, sieben.printed).not.toBe('');
    await open(page, '#cpu');
    const script = `
import snap7, time
client = snap7.client.Client()
client.connect("127.0.0.1", 0, 2, ${port})
client.mb_write(40, 2, bytearray(b"\\x12\\x34"))
time.sleep(20)
`;
    const client = spawn(PYTHON, ['-c', script], { stdio: 'inherit' });
    try {
      const row = id(page, 'clients').locator('tr', { hasText: 'S7' });
      await expect(row).toContainText(/127\.0\.0\.1:\d+/);
      await expect(row).toContainText(/M.*40.*scan [\d,]+/);
    } finally {
      client.kill('SIGKILL');
    }
    await expect(id(page, 'clients').locator('tr', { hasText: 'S7' })).toHaveCount(0);
  });
});

test('why the CPU stands is said once, and a memory reset is no reason', async ({ page }) => {
  await open(page, '#cpu');
  await id(page, 'mode-stop').click();
  await expect(id(page, 'event')).toContainText('Why the CPU stopped');
  await expect(id(page, 'event-text')).toHaveText(/^\s*STOP by a programming device[^.]*\.\s*$/);
  await id(page, 'mode-mres').click();
  await expect(id(page, 'diag-1')).toContainText('memory reset');
  await expect(id(page, 'event-text')).toContainText('memory reset done');
  await expect(id(page, 'event')).not.toContainText('Why the CPU stopped');
  await expect(id(page, 'event-text')).not.toContainText('programming device');
});
