// VS Code itself, served by code-server, with the extension installed from its `.vsix`: one server for all tests of a worker, a folder for each test.
// `CODE_SERVER` names its program, `VSIX` the extension, `SIEBEN` the binary.
import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { chromium, expect, test as base, type Browser, type Locator, type Page } from '@playwright/test';
import { BINARY, ROOT } from '../binary';

const CODE_SERVER = process.env['CODE_SERVER'] ?? join(ROOT, 'target/code-server/node_modules/code-server/out/node/entry.js');
const VSIX = process.env['VSIX'] ?? join(ROOT, 'target/sieben.vsix');
/** Within this time code-server is ready. */
const STARTS_WITHIN = 60_000;

/** What the user of these tests has set. */
const SETTINGS = {
  'sieben.path': BINARY,
  'workbench.startupEditor': 'none',
  'workbench.tips.enabled': false,
  'workbench.colorTheme': 'Default Light Modern',
  'telemetry.telemetryLevel': 'off',
  'extensions.autoCheckUpdates': false,
  'extensions.ignoreRecommendations': true,
  'git.enabled': false,
  'files.simpleDialog.enable': true,
  'editor.minimap.enabled': false,
  'terminal.integrated.gpuAcceleration': 'off',
  'testing.automaticallyOpenPeekView': 'failureInVisibleDocument',
};

/** A running code-server. */
export class CodeServer {
  private constructor(
    private readonly child: ChildProcess,
    readonly port: number,
    private readonly home: string,
  ) {}

  static async start(): Promise<CodeServer> {
    const home = mkdtempSync(join(tmpdir(), 'sieben-code-'));
    const port = await freePort();
    const user = join(home, 'user');
    mkdirSync(join(user, 'User'), { recursive: true });
    writeFileSync(join(user, 'User/settings.json'), JSON.stringify(SETTINGS));
    const places = ['--user-data-dir', user, '--extensions-dir', join(home, 'extensions')];
    const environment = { ...process.env, HOME: home, XDG_DATA_HOME: home, XDG_CONFIG_HOME: home, LC_ALL: 'C.UTF-8' };
    execFileSync('node', [CODE_SERVER, ...places, '--install-extension', VSIX], { env: environment, stdio: 'pipe' });
    const quiet = ['--disable-telemetry', '--disable-update-check', '--disable-workspace-trust', '--disable-getting-started-override'];
    const child = spawn('node', [CODE_SERVER, '--auth', 'none', '--bind-addr', `127.0.0.1:${port}`, ...places, ...quiet], { env: environment, stdio: ['ignore', 'pipe', 'pipe'] });
    let said = '';
    const take = (data: Buffer): void => void (said += data.toString());
    child.stdout.on('data', take);
    child.stderr.on('data', take);
    const end = Date.now() + STARTS_WITHIN;
    while (!said.includes('HTTP server listening')) {
      if (child.exitCode !== null || Date.now() > end) throw new Error(`code-server does not start:\n${said}`);
      await new Promise((done) => setTimeout(done, 50));
    }
    return new CodeServer(child, port, home);
  }

  async end(): Promise<void> {
    const ended = new Promise((done) => this.child.once('exit', done));
    this.child.kill('SIGTERM');
    await ended;
    rmSync(this.home, { recursive: true, force: true, maxRetries: 5 });
  }
}

async function freePort(): Promise<number> {
  return new Promise((done, failed) => {
    const server = createServer();
    server.once('error', failed);
    server.listen(0, '127.0.0.1', () => {
      const address = server.address();
      server.close(() => (typeof address === 'object' && address !== null ? done(address.port) : failed(new Error('no port'))));
    });
  });
}

/** A window of the editor with a folder. */
export class Window {
  constructor(
    readonly page: Page,
    readonly folder: string,
  ) {}

  /** Opens a file of the folder. */
  async open(file: string): Promise<void> {
    await this.page.keyboard.press('Control+P');
    await this.page.locator('.quick-input-widget input').fill(file);
    await expect(this.page.locator('.quick-input-list .monaco-list-row').first()).toContainText(file);
    await this.page.keyboard.press('Enter');
    await expect(this.tab(file)).toBeVisible();
    await expect(this.page.locator('.editor-instance .view-lines').first()).toBeVisible();
  }

  /** Runs a command by its title. */
  async run(title: string): Promise<void> {
    await this.page.keyboard.press('F1');
    await this.page.locator('.quick-input-widget input').fill(`>${title}`);
    await expect(this.page.locator('.quick-input-list .monaco-list-row').first()).toContainText(title);
    await this.page.keyboard.press('Enter');
  }

  /** Puts the cursor at a line and column, from 1. */
  async go(line: number, column: number): Promise<void> {
    await this.page.keyboard.press('Control+G');
    const input = this.page.locator('.quick-input-widget input');
    await expect(input).toHaveValue(':');
    await input.fill(`:${line}:${column}`);
    await this.page.keyboard.press('Enter');
    await expect(this.status(`Ln ${line}, Col ${column}`)).toBeVisible();
  }

  tab(file: string): Locator {
    return this.page.locator('.tab', { hasText: file });
  }

  /** An item of the status bar. */
  status(text: string): Locator {
    return this.page.locator('.statusbar-item', { hasText: text });
  }

  /** The lines of the editor that is shown, as they are drawn. */
  get lines(): Locator {
    return this.page.locator('.editor-instance .view-lines').first();
  }

  /** What is wrong, as the panel lists it. */
  async problems(): Promise<Locator> {
    await this.run('View: Toggle Problems');
    return this.page.locator('.markers-panel .monaco-list-row');
  }
}

interface WorkerFixtures {
  browser: Browser;
  codeServer: CodeServer;
}

interface Fixtures {
  /** The example that the folder is a copy of. */
  example: string;
  /** Files that come to those of the example, or take their place. */
  files: Record<string, string>;
  folder: string;
  window: Window;
}

export const test = base.extend<Fixtures, WorkerFixtures>({
  browser: [
    // eslint-disable-next-line no-empty-pattern
    async ({}, use) => {
      const browser = await chromium.launch({ executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
      await use(browser);
      await browser.close();
    },
    { scope: 'worker' },
  ],
  codeServer: [
    // eslint-disable-next-line no-empty-pattern
    async ({}, use) => {
      const server = await CodeServer.start();
      await use(server);
      await server.end();
    },
    { scope: 'worker', timeout: 120_000 },
  ],
  example: ['dosing', { option: true }],
  files: [{}, { option: true }],
  folder: async ({ example, files }, use) => {
    const above = realpathSync(mkdtempSync(join(tmpdir(), 'sieben-folder-')));
    const folder = join(above, example);
    cpSync(join(ROOT, 'examples', example), folder, { recursive: true, filter: (path) => !path.endsWith('/.sieben') });
    for (const [name, text] of Object.entries(files)) {
      mkdirSync(dirname(join(folder, name)), { recursive: true });
      writeFileSync(join(folder, name), text);
    }
    await use(folder);
    rmSync(above, { recursive: true, force: true });
  },
  window: async ({ browser, codeServer, folder }, use) => {
    const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, locale: 'en-GB' });
    const page = await context.newPage();
    await page.goto(`http://127.0.0.1:${codeServer.port}/?folder=${encodeURIComponent(folder)}`);
    await page.locator('.monaco-workbench').waitFor({ timeout: 60_000 });
    const window = new Window(page, folder);
    await expect(window.status('Sieben')).toBeVisible({ timeout: 60_000 });
    await use(window);
    await context.close();
  },
});

export { expect };
