// Checks of the contract: states.
import { expect, id, open, test } from './sieben';

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

test('33: the server goes away and comes back', async ({ page, sieben }) => {
  await open(page, '#watch');
  await id(page, 'watch-new-C0').fill('12');
  await sieben.kill();
  await expect(id(page, 'connection')).toHaveText('Offline', { timeout: 3000 });
  await expect(id(page, 'state-message')).toContainText(/These are the values of scan [\d,]+/);
  for (const control of ['watch-modify', 'force-add', 'mode-stop', 'pause', 'watch-tick-C0']) await expect(id(page, control)).toBeDisabled();
  await sieben.start();
  await expect(id(page, 'connection')).toHaveText('Live', { timeout: 16_000 });
  await expect(id(page, 'watch-new-C0')).toHaveValue('12');
});
