// Checks of the contract: CPU.
import { readFileSync } from 'node:fs';
import { expect, id, open, test } from './sieben';

test('69: the diagnostic buffer has a hundred events, the newest first', async ({ page, request }) => {
  test.setTimeout(120_000);
  await open(page, '#cpu');
  // STOP and RUN write two events or more each.
  for (let i = 0; i < 40; i += 1) for (const mode of ['stop', 'run']) expect((await request.post('/api/v1/mode', { data: { mode } })).ok()).toBe(true);
  await expect(page.locator('[data-testid^=diag-][role=option]')).toHaveCount(100);
  const text = await (await request.get('/api/v1/diagnostics?format=text')).text();
  await request.post('/api/v1/mode', { data: { mode: 'stop' } });
  await expect(id(page, 'diag-1')).toContainText('STOP');
  await expect(page.locator('[data-testid^=diag-][role=option]')).toHaveCount(100);
  expect(text.length).toBeGreaterThan(0);
});

test('71: the diagnostic buffer is saved as text', async ({ page, request }) => {
  await open(page, '#cpu');
  const saved = page.waitForEvent('download');
  await id(page, 'diag-save').click();
  const file = await saved;
  expect(file.suggestedFilename()).toMatch(/^dosing.*\.txt$/);
  expect(readFileSync(await file.path(), 'utf8')).toBe(await (await request.get('/api/v1/diagnostics?format=text')).text());
});
