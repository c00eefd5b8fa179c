import { availableParallelism } from 'node:os';
import { defineConfig } from '@playwright/test';

export default defineConfig({
  testDir: 'tests',
  testMatch: '*.spec.ts',
  // What failed, with pictures: not here, where the checks of the project would read it.
  outputDir: '../../../target/page-tests',
  workers: Number(process.env['WORKERS'] ?? Math.min(2, availableParallelism())),
  fullyParallel: true,
  timeout: 40_000,
  expect: { timeout: 10_000 },
  reporter: 'line',
  use: { viewport: { width: 1440, height: 900 }, locale: 'en-GB', launchOptions: { executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium', args: ['--no-sandbox'] } },
});
