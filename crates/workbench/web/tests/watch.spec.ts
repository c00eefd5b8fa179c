// Checks of the contract: watch.
import { expect, id, open, test } from './sieben';

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
