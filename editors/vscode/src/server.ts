// The language server as the editor sees it: found, started, asked, started again, given up.
import * as vscode from 'vscode';
import {
  CloseAction,
  ErrorAction,
  LanguageClient,
  State as ClientState,
  TransportKind,
  type DocumentSelector,
  type ErrorHandler,
  type LanguageClientOptions,
} from 'vscode-languageclient/node';
import { program } from './sieben';
import type { Status } from './status';

/** The languages of the extension. */
export const LANGUAGES = ['awl', 'scl', 'st', 'lad', 'fbd', 's7db', 's7udt'];
/** Files that belong to a project and have no language of ours. */
const PROJECT_FILES = ['**/sieben.toml', '**/*.{sdf,asc,dif,seq,csv}', '**/*.scenario'];
/** The settings that the server is given. */
const SETTINGS = ['cpu', 'mnemonics', 'dialect', 'strict', 'extended', 'liveValues'] as const;
/** So many ends within that time are too many: a server that falls again and again is not started again. */
const ENDS_MAX = 4;
const ENDS_WITHIN_MS = 180_000;

/** The server. */
export class Server implements vscode.Disposable {
  private client: LanguageClient | undefined;
  private readonly log = vscode.window.createOutputChannel('Sieben', { log: true });
  private ends: number[] = [];
  /** Starts and stops one after another. */
  private order: Promise<void> = Promise.resolve();

  /** `runTest` is what a lens at a test does. */
  constructor(
    private readonly context: vscode.ExtensionContext,
    private readonly status: Status,
    private readonly runTest: (parameters: readonly unknown[]) => Promise<void>,
  ) {}

  dispose(): void {
    void this.stop();
    this.log.dispose();
  }

  showLog(): void {
    this.log.show();
  }

  /** Starts it, or says why it does not start. */
  async start(): Promise<void> {
    return this.inOrder(async () => this.startNow());
  }

  async stop(): Promise<void> {
    return this.inOrder(async () => this.stopNow());
  }

  async restart(): Promise<void> {
    this.ends = [];
    return this.inOrder(async () => {
      await this.stopNow();
      await this.startNow();
    });
  }

  private async inOrder(step: () => Promise<void>): Promise<void> {
    this.order = this.order.then(step, step);
    return this.order;
  }

  private async startNow(): Promise<void> {
    this.status.set({ kind: 'starting' });
    const found = program(this.context);
    if ('missing' in found) {
      this.fail(found.missing, 'Open the Settings', () => void vscode.commands.executeCommand('workbench.action.openSettings', 'sieben.path'));
      return;
    }
    this.log.info(`${found.path} (${found.from})`);
    const command = { command: found.path, args: ['lsp'], transport: TransportKind.stdio };
    const client = new LanguageClient('sieben', 'Sieben', { run: command, debug: command }, this.options());
    this.client = client;
    client.onDidChangeState(({ newState }) => {
      if (this.client !== client) return;
      if (newState === ClientState.Running) this.running(client);
      else if (newState === ClientState.Starting) this.status.set({ kind: 'starting' });
    });
    try {
      await client.start();
    } catch (error) {
      this.fail(`The language server did not start: ${error instanceof Error ? error.message : String(error)}.`, 'Show the Log', () => this.log.show());
    }
  }

  private async stopNow(): Promise<void> {
    const client = this.client;
    this.client = undefined;
    this.status.set({ kind: 'stopped' });
    try {
      await client?.dispose();
    } catch {
      // One that has ended already, or never started, cannot be stopped.
    }
  }

  /** Says which version runs; an older one than the extension may lack what it offers. */
  private running(client: LanguageClient): void {
    const version = client.initializeResult?.serverInfo?.version ?? 'of an unknown version';
    const own = String(this.context.extension.packageJSON.version);
    this.log.info(`sieben ${version}; extension ${own}`);
    if (isOlder(version, own)) this.log.warn(`sieben ${version} is older than the extension (${own}): some of what it offers may be missing.`);
    this.status.set({ kind: 'running', version });
  }

  private fail(reason: string, action: string, act: () => void): void {
    this.log.error(reason);
    this.status.set({ kind: 'failed', reason });
    void vscode.window.showErrorMessage(`Sieben: ${reason}`, action).then((chosen) => chosen === action && act());
  }

  private options(): LanguageClientOptions {
    return {
      documentSelector: selector(),
      initializationOptions: settings(),
      outputChannel: this.log,
      diagnosticCollectionName: 'sieben',
      errorHandler: this.errorHandler(),
      middleware: {
        // A lens of the server runs a test where the results are shown.
        executeCommand: async (command, parameters: unknown[], next) => (command === 'sieben.runTest' ? this.runTest(parameters) : next(command, parameters)),
      },
    };
  }

  private errorHandler(): ErrorHandler {
    return {
      error: (_error, _message, count) => ({ action: (count ?? 0) <= 3 ? ErrorAction.Continue : ErrorAction.Shutdown }),
      closed: () => {
        const now = Date.now();
        this.ends = [...this.ends.filter((end) => now - end < ENDS_WITHIN_MS), now];
        if (this.ends.length <= ENDS_MAX) return { action: CloseAction.Restart };
        const reason = `The language server ended ${this.ends.length} times within three minutes.`;
        this.fail(reason, 'Start It Again', () => void this.restart());
        return { action: CloseAction.DoNotRestart, handled: true };
      },
    };
  }

  /** Has the server execute a command; undefined if it does not run or refuses. */
  async execute<Answer>(command: string, ...parameters: unknown[]): Promise<Answer | undefined> {
    const client = this.client;
    if (client === undefined || !client.isRunning()) return undefined;
    try {
      return await client.sendRequest<Answer>('workspace/executeCommand', { command, arguments: parameters });
    } catch (error) {
      this.log.warn(`${command}: ${error instanceof Error ? error.message : String(error)}`);
      return undefined;
    }
  }

  /** Tells it what the settings are now. */
  tellSettings(): void {
    void this.client?.sendNotification('workspace/didChangeConfiguration', { settings: { sieben: settings() } });
  }

  /** A document as the protocol names it. */
  uriOf(document: vscode.TextDocument): string {
    return this.client?.code2ProtocolConverter.asUri(document.uri) ?? document.uri.toString();
  }
}

/** The documents that the server is told of. */
function selector(): DocumentSelector {
  const others = vscode.workspace.getConfiguration('sieben').get<string[]>('otherLanguages', []);
  const languages = [...new Set([...LANGUAGES, ...others])];
  const named = languages.flatMap((language) => [
    { scheme: 'file', language },
    { scheme: 'untitled', language },
  ]);
  return [...named, ...PROJECT_FILES.map((pattern) => ({ scheme: 'file', pattern }))];
}

function settings(): Record<string, unknown> {
  const configuration = vscode.workspace.getConfiguration('sieben');
  return Object.fromEntries(SETTINGS.map((name) => [name, configuration.get(name)]));
}

/** Whether a version such as `0.1.0` is before another one; one that is none is not. */
export function isOlder(version: string, than: string): boolean {
  const numbers = (text: string): number[] => (/^\d+(?:\.\d+)*/u.exec(text)?.[0] ?? '').split('.').filter(Boolean).map(Number);
  const [one, other] = [numbers(version), numbers(than)];
  if (one.length === 0) return false;
  for (let index = 0; index < Math.max(one.length, other.length); index += 1) {
    const difference = (one[index] ?? 0) - (other[index] ?? 0);
    if (difference !== 0) return difference < 0;
  }
  return false;
}
