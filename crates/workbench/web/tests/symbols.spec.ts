// Checks of the contract: symbols.
import { expect, id, open, test } from './sieben';

test.use({ example: 'tank' });

test('65: a filter leaves what is called so', async ({ page }) => {
  await open(page, '#symbols');
  await id(page, 'symbols-filter').fill('over');
  await expect(id(page, 'symbols-count')).toHaveText('2 of 25');
  await expect(id(page, 'symbol-Overflow')).toBeVisible();
});

test('68: what nothing uses is marked', async ({ page }) => {
  await open(page, '#symbols');
  await expect(id(page, 'symbol-InletOpen')).toContainText('unused');
  await expect(id(page, 'symbol-Overflow')).not.toContainText('unused');
});
