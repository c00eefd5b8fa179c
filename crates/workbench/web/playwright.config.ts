import { defineConfig } from '@playwright/test';

const PORT = 7311;

export default defineConfig({
  testDir: 'tests',
  testMatch: '*.spec.ts',
  workers: 1,
  timeout: 30_000,
  reporter: 'line',
  use: { baseURL: `http://127.0.0.1:${PORT}`, viewport: { width: 1440, height: 900 }, locale: 'en-GB', launchOptions: { executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium', args: ['--no-sandbox'] } },
  webServer: { command: 'node dev/server.js', port: PORT, env: { PORT: String(PORT) }, reuseExistingServer: false },
});
