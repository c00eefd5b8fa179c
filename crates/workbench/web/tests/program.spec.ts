// Checks of the contract: program.
import { expect, id, open, test } from './sieben';

test.use({ example: 'star-delta' });

test('36–39, 43: diagrams with power flow', async ({ page }) => {
  await open(page, '#program/FB20/n8');
  await id(page, 'view-lad').click();
  await expect(id(page, 'lad-contact-120')).toHaveAttribute('data-flow', '1');
  await expect(id(page, 'lad-contact-120')).toHaveAttribute('data-value', '1');
  await id(page, 'view-side').click();
  const side = id(page, 'side-by-side');
  for (const form of ['LAD', 'STL', 'FBD']) await expect(side.getByRole('heading', { name: form })).toBeVisible();
  await side.getByTestId('stl-row-123').click();
  await expect(side.getByTestId('lad-contact-123')).toHaveAttribute('aria-selected', 'true');
  await expect(side.getByTestId('fbd-contact-123')).toHaveAttribute('aria-selected', 'true');
  await id(page, 'network-3').getByRole('button').first().click();
  await expect(id(page, 'reason-3')).toContainText(/^Stays STL:.*line \d+/);
  await expect(id(page, 'instance')).toContainText('DB 20');
});
