// The extension in VS Code itself.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from './code';

test('it is activated by a project, knows its languages and colours a source', async ({ window }) => {
  await window.open('dosing.awl');
  await expect(window.status('STL (S7)')).toBeVisible();
  // Pieces of the first statement differ in their colours.
  const statement = window.lines.locator('.view-line', { hasText: 'I 0.0' }).first();
  await expect.poll(async () => new Set(await statement.locator('span[class^=mtk]').evaluateAll((pieces) => pieces.map((piece) => piece.className))).size).toBeGreaterThan(1);
});

test('a command has files that end in .st belong to Sieben', async ({ window, folder }) => {
  await window.run('Sieben: Use Sieben for Files that End in .st');
  await expect(window.page.locator('.quick-input-list .monaco-list-row').first()).toContainText('In this workspace');
  await window.page.keyboard.press('Enter');
  const settings = join(folder, '.vscode/settings.json');
  await expect.poll(() => readIfThere(settings)).toContain('"*.st": "st"');
});

test('a task checks the project', async ({ window }) => {
  await window.run('Sieben: Check the Project');
  await expect(window.page.locator('.terminal-wrapper .xterm-rows')).toContainText('1 block in 1 source, no errors, no warnings.');
});

test.describe('tests', () => {
  test.use({
    files: {
      'dosing.test.st': "SETUP\n  SCAN(1);\nEND_SETUP\n\nTEST 'START opens the valve'\n  \"START\" := TRUE;\n  SCAN(1);\n  ASSERT_TRUE(\"VALVE\");\nEND_TEST\n\nTEST 'the display shows 26'\n  \"START\" := TRUE;\n  SCAN(1);\n  ASSERT_EQ(\"DISPLAY\", 16#0026);\nEND_TEST\n",
    },
  });

  test('the Test Explorer runs the tests of a project, and shows the timing diagram of a failure', async ({ window }) => {
    const { page } = window;
    await window.open('dosing.test.st');
    await window.run('Testing: Focus on Test Explorer View');
    const rows = page.locator('.test-explorer .monaco-list-row');
    await expect(rows.filter({ hasText: 'dosing.test.st' })).toBeVisible();
    // Each test stands in its line.
    await expect(page.locator('.glyph-margin-widgets .testing-run-glyph')).toHaveCount(2);
    await window.run('Test: Run All Tests');
    await expect(rows.filter({ hasText: 'START opens the valve' }).locator('.codicon-testing-passed-icon')).toBeVisible();
    await expect(rows.filter({ hasText: 'the display shows 26' }).locator('.codicon-testing-failed-icon')).toBeVisible();
    await page.screenshot({ path: '/tmp/wt/ext-scratch/c.png' });
    const message = page.locator('.test-message, .test-output-peek-message-container').first();
    await expect(message).toContainText('is W#16#0025 (WORD), not 16#0026');
    await expect(message).toContainText('was changed last by');
    await expect(message.locator('img')).toHaveAttribute('src', /^data:image\/svg/u);
    await page.screenshot({ path: '/tmp/wt/ext-scratch/c.png' });
    // The same as a panel of its own.
    await rows.filter({ hasText: 'the display shows 26' }).hover();
    await rows.filter({ hasText: 'the display shows 26' }).getByRole('button', { name: 'Show Timing Diagram of the Failure' }).click();
    const picture = page.frameLocator('iframe.webview').last().frameLocator('iframe').locator('img');
    await expect(picture).toHaveAttribute('alt', /the display shows 26/u);
    expect(await picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(100);
    await page.screenshot({ path: '/tmp/wt/ext-scratch/d.png' });
  });
});

const readIfThere = (path: string): string => {
  try {
    return readFileSync(path, 'utf8');
  } catch {
    return '';
  }
};
