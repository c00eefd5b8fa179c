import { defineConfig } from '@playwright/test';

export default defineConfig({
  testDir: 'tests',
  testMatch: '*.spec.ts',
  workers: Number(process.env['WORKERS'] ?? 1),
  fullyParallel: true,
  timeout: 40_000,
  expect: { timeout: 10_000 },
  reporter: 'line',
  use: { viewport: { width: 1440, height: 900 }, locale: 'en-GB', launchOptions: { executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium', args: ['--no-sandbox'] } },
});
