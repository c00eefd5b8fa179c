// The real binary with a page: each test has a run of its own, on a copy of one of the examples or on a project that it writes itself. `SIEBEN` names the binary.
import { spawn, type ChildProcess } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test as base, type Page } from '@playwright/test';

const ROOT = fileURLToPath(new URL('../../../../', import.meta.url));
export const BINARY = process.env['SIEBEN'] ?? join(process.env['CARGO_TARGET_DIR'] ?? join(ROOT, 'target'), 'debug/sieben');
/** Where the examples are. */
export const EXAMPLES = join(ROOT, 'examples');
/** The Python whose modules `cargo xtask clients` has installed. */
const CLIENT_PYTHON = join(ROOT, 'target/clients/python-snap7/bin/python');
export const PYTHON = existsSync(CLIENT_PYTHON) ? CLIENT_PYTHON : 'python3';
/** Within this time a run says where its page is. */
const STARTS_WITHIN = 20_000;

/** Files of a project by name. */
export type Files = Record<string, string>;
/** As `example`: a project that has only the files of the test. */
export const OWN = 'own';

/** A run of an example with its page. */
export class Sieben {
  readonly folder: string;
  private child: ChildProcess | undefined;
  private output = '';

  private constructor(
    readonly example: string,
    readonly port: number,
    private readonly further: string[],
    files: Files,
  ) {
    this.folder = join(mkdtempSync(join(tmpdir(), 'sieben-page-')), example);
    if (example === OWN) mkdirSync(this.folder);
    else cpSync(join(ROOT, 'examples', example), this.folder, { recursive: true, filter: (path) => !path.endsWith('/.sieben') });
    for (const [name, text] of Object.entries(files)) writeFileSync(join(this.folder, name), text);
  }

  static async start(example: string, further: string[] = [], files: Files = {}): Promise<Sieben> {
    const sieben = new Sieben(example, await freePort(), further, files);
    await sieben.start();
    return sieben;
  }

  get url(): string {
    return `http://127.0.0.1:${this.port}`;
  }

  /** What the run has printed. */
  get printed(): string {
    return this.output;
  }

  /** Starts it, or starts it again after `kill`. */
  async start(): Promise<void> {
    const child = spawn(BINARY, ['run', this.folder, '--plain', '--page', `127.0.0.1:${this.port}`, ...this.further], { stdio: ['ignore', 'pipe', 'pipe'] });
    this.child = child;
    this.output = '';
    const take = (data: Buffer) => (this.output += data.toString());
    child.stdout.on('data', take);
    child.stderr.on('data', take);
    const end = Date.now() + STARTS_WITHIN;
    while (!this.output.includes('The page is at')) {
      if (child.exitCode !== null || Date.now() > end) throw new Error(`${BINARY} does not serve its page:\n${this.output}`);
      await new Promise((done) => setTimeout(done, 20));
    }
  }

  /** The folder has another example from now on. */
  become(example: string): void {
    rmSync(this.folder, { recursive: true });
    cpSync(join(ROOT, 'examples', example), this.folder, { recursive: true, filter: (path) => !path.endsWith('/.sieben') });
  }

  /** Ends it as a power failure does, or by another signal. */
  async kill(signal: NodeJS.Signals = 'SIGKILL'): Promise<void> {
    const child = this.child;
    if (child === undefined || child.exitCode !== null || child.signalCode !== null) return;
    const ended = new Promise((done) => child.once('exit', done));
    child.kill(signal);
    await ended;
  }

  /** Nothing is kept of the runs before: the next one begins as the first one did. */
  forget(): void {
    rmSync(join(this.folder, '.sieben'), { recursive: true, force: true });
  }

  async end(): Promise<void> {
    await this.kill();
    rmSync(join(this.folder, '..'), { recursive: true, force: true });
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

interface Fixtures {
  /** The example that runs: `test.use({ example: 'tank' })`. */
  example: string;
  /** Further arguments of `sieben run`. */
  further: string[];
  /** Files that come to those of the example, or take their place. */
  files: Files;
  sieben: Sieben;
}

export const test = base.extend<Fixtures>({
  example: ['dosing', { option: true }],
  further: [[], { option: true }],
  files: [{}, { option: true }],
  sieben: async ({ example, further, files }, use) => {
    const sieben = await Sieben.start(example, further, files);
    await use(sieben);
    await sieben.end();
  },
  baseURL: async ({ sieben }, use) => use(sieben.url),
});

export { expect };
export type { Page };

/** An element of the contract. */
export const id = (page: Page, name: string) => page.getByTestId(name);

/** The scan that the page shows. */
export const scan = async (page: Page) => Number((await id(page, 'scan-number').textContent())?.replace(/\D/g, ''));

/** Presses the START button of the dosing plant. */
export async function dose(page: Page): Promise<void> {
  const button = id(page, 'in-0.0').getByRole('button');
  await button.hover();
  await page.mouse.down();
  await expect(id(page, 'in-0.0')).toHaveAttribute('data-on', '1');
  await page.mouse.up();
  await expect(id(page, 'out-0.0')).toHaveAttribute('data-on', '1');
}

/** A row as the server sends it: line, executed, status word, ACCU 1, ACCU 2. */
export type Row = [number, number, number, number, number];

/** What a second client is sent of one scan of a block. */
export async function rowsOf(page: Page, block: string, n: number, last: number): Promise<Row[]> {
  return page.evaluate(
    async ([block, n, last]) =>
      new Promise<Row[]>((done) => {
        const socket = new WebSocket(location.origin.replace('http', 'ws') + '/ws');
        const say = (message: unknown) => socket.send(JSON.stringify(message));
        socket.onopen = () => {
          say({ t: 'hello', v: 1, lang: 'en' });
          say({ t: 'at', scan: n });
          say({ t: 'sub', id: 'r', what: 'rows', block, from: 0, to: last });
        };
        socket.onmessage = (event) => {
          const message = JSON.parse(String(event.data)) as { t: string; n: number; s: { r?: Row[] } };
          if (message.t !== 'scan' || message.n !== n || !Array.isArray(message.s.r)) return;
          socket.close();
          done(message.s.r);
        };
      }),
    [block, n, last] as const,
  );
}

/** Opens the page, waits until it is live, and collects what must not happen: errors on the console, requests to elsewhere. */
export async function open(page: Page, hash = '', query = '?theme=light'): Promise<string[]> {
  const wrong: string[] = [];
  page.on('console', (message) => message.type() === 'error' && wrong.push(message.text()));
  page.on('pageerror', (error) => wrong.push(error.message));
  page.on('request', (request) => new URL(request.url()).host.startsWith('127.0.0.1') || wrong.push(`leaves the origin: ${request.url()}`));
  await page.goto(`/${query}${hash}`);
  await expect(id(page, 'connection')).toHaveText('Live');
  return wrong;
}
