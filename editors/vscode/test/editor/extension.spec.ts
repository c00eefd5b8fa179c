// The extension in VS Code itself.
import { expect, test } from './code';

test('it is activated by a project, and its languages are known', async ({ window }) => {
  await window.open('dosing.awl');
  await expect(window.status('STL (S7)')).toBeVisible();
  await window.page.screenshot({ path: '/tmp/wt/ext-scratch/a.png' });
});
