// The extension in VS Code itself.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from './code';

test('it is activated by a project, knows its languages and colours a source', async ({ window }) => {
  await window.open('dosing.awl');
  await expect(window.status('STL (S7)')).toBeVisible();
  // Pieces of the first statement differ in their colours.
  const statement = window.lines.locator('.view-line', { hasText: 'I 0.0' }).first();
  await expect.poll(async () => new Set(await statement.locator('span[class^=mtk]').evaluateAll((pieces) => pieces.map((piece) => piece.className))).size).toBeGreaterThan(1);
});

test('what is wrong is marked while it is typed, and a quick fix mends it', async ({ window }) => {
  const { page } = window;
  await window.open('dosing.awl');
  await expect(window.status('Sieben').locator('.codicon-check')).toBeVisible();
  await expect(page.locator('.squiggly-error')).toHaveCount(0);
  // The point of `M 0.0` in line 9 becomes a comma.
  await window.go(9, 16);
  await page.keyboard.press('Delete');
  await page.keyboard.type(',');
  await expect(page.locator('.squiggly-error')).toHaveCount(1);
  const problems = await window.problems();
  await expect(problems.filter({ hasText: 'did you mean' })).toContainText('P2004');
  await window.tab('dosing.awl').click();
  await window.go(9, 16);
  await page.keyboard.press('Control+.');
  const fix = page.locator('.action-widget .monaco-list-row', { hasText: 'write' }).first();
  await expect(fix).toBeVisible();
  await page.keyboard.press('Enter');
  await expect(page.locator('.squiggly-error')).toHaveCount(0);
  await expect(window.lines.locator('.view-line', { hasText: 'FP' })).toContainText('M\u00a00.0');
});

test('the diagram panel draws the network at the cursor and follows it', async ({ window }) => {
  const { page } = window;
  await window.open('dosing.awl');
  await expect(window.status('Sieben').locator('.codicon-check')).toBeVisible();
  await window.go(8, 7);
  await window.run('Sieben: Show Network as Diagram');
  const inner = page.frameLocator('iframe.webview').frameLocator('iframe#active-frame');
  const picture = inner.locator('img');
  await expect(picture).toHaveAttribute('src', /^data:image\/svg\+xml;base64,/u);
  expect(await picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(50);
  const first = await picture.getAttribute('src');
  // Nothing of it runs, and nothing is fetched.
  await expect(inner.locator('meta[http-equiv="Content-Security-Policy"]')).toHaveAttribute('content', /default-src 'none'; img-src data:; style-src 'nonce-[0-9a-f]+'/u);
  await window.tab('dosing.awl').click();
  await window.go(15, 7);
  await expect(picture).not.toHaveAttribute('src', first ?? '');
  // Above the first network there is none.
  await window.go(2, 1);
  await expect(inner.locator('p')).toContainText('no network at the cursor');
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

test.describe('without the program', () => {
  test.use({ files: { '.vscode/settings.json': '{ "sieben.path": "/nowhere/sieben" }\n' } });

  test('the status bar says that the program is missing, and colours are there all the same', async ({ window }) => {
    await window.open('dosing.awl');
    await expect(window.status('Sieben').locator('.codicon-error')).toBeVisible();
    await expect(window.page.locator('.notifications-toasts')).toContainText('/nowhere/sieben');
    await expect.poll(async () => window.lines.locator('.view-line', { hasText: 'I 0.0' }).first().locator('span[class^=mtk]').count()).toBeGreaterThan(1);
  });
});

test('the walkthrough leads through all steps', async ({ window }) => {
  await window.run('Sieben: Open the Walkthrough');
  const steps = window.page.locator('.getting-started-step');
  await expect(steps).toHaveCount(6);
  await steps.filter({ hasText: 'Look at the network as a diagram' }).click();
  await expect(window.page.getByRole('button', { name: 'Show Network as Diagram' })).toBeVisible();
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
    const message = page.locator('.test-message, .test-output-peek-message-container').first();
    await expect(message).toContainText('is W#16#0025 (WORD), not 16#0026');
    await expect(message).toContainText('was changed last by');
    await expect(message.locator('img')).toHaveAttribute('src', /^data:image\/svg/u);
    // The same as a panel of its own.
    await rows.filter({ hasText: 'the display shows 26' }).hover();
    await rows.filter({ hasText: 'the display shows 26' }).getByRole('button', { name: 'Show Timing Diagram of the Failure' }).click();
    const picture = page.frameLocator('iframe.webview').last().frameLocator('iframe#active-frame').locator('img');
    await expect(picture).toHaveAttribute('alt', /the display shows 26/u);
    expect(await picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(100);
  });

  test('a test that is chosen runs alone, and a file that does not compile says why', async ({ window, folder }) => {
    const { page } = window;
    await window.run('Testing: Focus on Test Explorer View');
    const rows = page.locator('.test-explorer .monaco-list-row');
    const opens = rows.filter({ hasText: 'START opens the valve' });
    await rows.filter({ hasText: 'dosing.test.st' }).locator('.monaco-tl-twistie').click();
    await opens.hover();
    await opens.getByRole('button', { name: 'Run Test' }).click();
    await expect(opens.locator('.codicon-testing-passed-icon')).toBeVisible();
    await expect(rows.filter({ hasText: 'the display shows 26' }).locator('.codicon-testing-unset-icon')).toBeVisible();
    writeFileSync(join(folder, 'dosing.test.st'), "TEST 'no end'\n  nothing := 1;\nEND_TEST\n");
    const whole = rows.filter({ hasText: 'dosing.test.st' });
    await expect(opens).toHaveCount(0);
    await whole.hover();
    await whole.getByRole('button', { name: 'Run Test' }).click();
    await expect(whole.locator('.codicon-testing-failed-icon, .codicon-testing-error-icon')).toBeVisible();
  });

  test('a lens at a test runs it', async ({ window }) => {
    const { page } = window;
    await window.open('dosing.test.st');
    const lens = page.locator('.codelens-decoration a').first();
    await expect(lens).toBeVisible();
    await lens.click();
    await expect(page.locator('.glyph-margin-widgets .codicon-testing-passed-icon')).toHaveCount(1);
  });
});

const readIfThere = (path: string): string => {
  try {
    return readFileSync(path, 'utf8');
  } catch {
    return '';
  }
};
