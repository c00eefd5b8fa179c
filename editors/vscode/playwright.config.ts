import { defineConfig } from '@playwright/test';

export default defineConfig({
  testDir: 'test',
  // What failed, with pictures: not here, where the checks of the project would read it.
  outputDir: '../../target/vscode-tests',
  workers: Number(process.env['WORKERS'] ?? 2),
  timeout: 60_000,
  expect: { timeout: 15_000 },
  reporter: 'line',
  projects: [
    // Without an editor: grammars, manifest, parts of the extension, the server by its protocol.
    { name: 'parts', testMatch: '*.spec.ts', testIgnore: 'editor/**' },
    // In VS Code itself.
    { name: 'editor', testMatch: 'editor/*.spec.ts' },
  ],
});
