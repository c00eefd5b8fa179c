// Checks of the contract: symbols.
import { expect, id, open, test } from './sieben';

test.use({ example: 'tank' });

test('65, 68: symbols are found and judged', async ({ page }) => {
  await open(page, '#symbols');
  await expect(id(page, 'symbol-InletOpen')).toContainText('unused');
  await id(page, 'symbols-filter').fill('over');
  await expect(id(page, 'symbols-count')).toHaveText('2 of 25');
});
