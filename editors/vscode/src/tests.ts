// The Test Explorer: the tests of all folders, and runs of `sieben test --json`.
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, isAbsolute, join } from 'node:path';
import * as vscode from 'vscode';
import { html, isDark } from './picture';
import { failureOf, placesOf, resultsOf, shortName, type Failure, type Place, type Result } from './results';
import { program, run } from './sieben';

/** So long files rest before the tests are looked for again. */
const REST_MS = 300;
/** Files whose change may bring other tests. */
const WATCHED = '**/{*.test.st,*_test.st,test_*.st,*.scenario,sieben.toml}';

/** What is known of an item. */
interface Known {
  readonly folder: vscode.WorkspaceFolder;
  /** The test; a file has none. */
  readonly place?: Place;
  /** The test file as the program names it. */
  readonly file?: string;
}

/** The Test Explorer. */
export class Tests implements vscode.Disposable {
  private readonly controller = vscode.tests.createTestController('sieben', 'Sieben');
  private readonly known = new WeakMap<vscode.TestItem, Known>();
  /** Timing diagrams of tests that failed last. */
  private readonly diagrams = new Map<string, string>();
  private readonly listeners: vscode.Disposable[] = [];
  private timer: NodeJS.Timeout | undefined;
  private looking: Promise<void> | undefined;

  constructor(private readonly context: vscode.ExtensionContext) {
    this.controller.resolveHandler = async (item) => (item === undefined ? this.look() : undefined);
    this.controller.refreshHandler = async () => this.look();
    this.controller.createRunProfile('Run', vscode.TestRunProfileKind.Run, async (request, token) => this.run(request, token), true);
    const watcher = vscode.workspace.createFileSystemWatcher(WATCHED);
    const later = (): void => this.lookSoon();
    this.listeners.push(
      watcher,
      watcher.onDidCreate(later),
      watcher.onDidChange(later),
      watcher.onDidDelete(later),
      vscode.workspace.onDidChangeWorkspaceFolders(later),
    );
    this.lookSoon();
  }

  dispose(): void {
    clearTimeout(this.timer);
    vscode.Disposable.from(...this.listeners, this.controller).dispose();
  }

  lookSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.look(), REST_MS);
  }

  /** Looks for the tests of all folders; who asks while that is done waits for the same answer. */
  private async look(): Promise<void> {
    this.looking ??= this.lookNow().finally(() => (this.looking = undefined));
    return this.looking;
  }

  private async lookNow(): Promise<void> {
    const found = program(this.context);
    if ('missing' in found) return;
    const folders = (vscode.workspace.workspaceFolders ?? []).filter((folder) => folder.uri.scheme === 'file');
    const items = await Promise.all(
      folders.map(async (folder) => {
        const ended = await run(found.path, folder.uri.fsPath, ['test', '--list', '--json']);
        return this.itemsOf(folder, placesOf(ended.stdout));
      }),
    );
    if (folders.length <= 1) {
      this.controller.items.replace(items.flat());
      return;
    }
    this.controller.items.replace(
      folders.flatMap((folder, index) => {
        const children = items[index] ?? [];
        if (children.length === 0) return [];
        const root = this.item(folder.uri.toString(), folder.name, folder.uri, { folder });
        root.children.replace(children);
        return [root];
      }),
    );
  }

  /** The tests of a folder, in the files that they stand in. */
  private itemsOf(folder: vscode.WorkspaceFolder, places: readonly Place[]): vscode.TestItem[] {
    const top: vscode.TestItem[] = [];
    const files = new Map<string, vscode.TestItem>();
    for (const place of places) {
      const id = `${folder.uri.toString()}\n${place.name}`;
      const path = place.test_file;
      if (path === null) {
        // A scenario is called like its file.
        top.push(this.item(id, shortName(place), at(folder, place.name), { folder, place }));
        continue;
      }
      let file = files.get(path);
      if (file === undefined) {
        file = this.item(`${folder.uri.toString()}\n${path}`, path, at(folder, path), { folder, file: path });
        files.set(path, file);
        top.push(file);
      }
      // A file that does not compile is a test of its own name.
      if (place.name === path) {
        file.error = 'The tests of this file cannot be run; a run says why.';
        continue;
      }
      const item = this.item(id, shortName(place), at(folder, path), { folder, place, file: path });
      // In the order of the file.
      item.sortText = String(file.children.size).padStart(6, '0');
      if (place.line !== null) item.range = new vscode.Range(place.line - 1, 0, place.line - 1, 0);
      file.children.add(item);
    }
    return top;
  }

  private item(id: string, label: string, uri: vscode.Uri, known: Known): vscode.TestItem {
    const item = this.controller.createTestItem(id, label, uri);
    this.known.set(item, known);
    return item;
  }

  /** Runs the tests that are asked for. */
  private async run(request: vscode.TestRunRequest, token: vscode.CancellationToken): Promise<void> {
    const test = this.controller.createTestRun(request);
    const found = program(this.context);
    const excluded = new Set(request.exclude ?? []);
    const chosen = (request.include ?? [...this.controller.items].map(([, item]) => item)).filter((item) => !excluded.has(item));
    const pictures = await mkdtemp(join(tmpdir(), 'sieben-tests-'));
    try {
      for (const [folder, items] of this.byFolder(chosen)) {
        if (token.isCancellationRequested) break;
        const leaves = items.flatMap((item) => this.leaves(item)).filter((item) => !excluded.has(item));
        leaves.forEach((item) => test.started(item));
        if ('missing' in found) {
          leaves.forEach((item) => test.errored(item, new vscode.TestMessage(found.missing)));
          continue;
        }
        const all = request.include === undefined && excluded.size === 0;
        for (const { words, tests } of all ? [{ words: [], tests: leaves }] : this.portions(leaves)) {
          if (token.isCancellationRequested) break;
          const ended = await run(found.path, folder.uri.fsPath, ['test', '--json', '--svg', pictures, ...words], token);
          if (token.isCancellationRequested) break;
          if (ended.stderr !== '') test.appendOutput(ended.stderr.replaceAll(/\r?\n/gu, '\r\n'));
          await this.take(test, folder, tests, resultsOf(ended.stdout) ?? [], ended.stderr);
        }
      }
    } finally {
      test.end();
      await rm(pictures, { recursive: true, force: true });
    }
  }

  private byFolder(items: readonly vscode.TestItem[]): Map<vscode.WorkspaceFolder, vscode.TestItem[]> {
    const folders = new Map<vscode.WorkspaceFolder, vscode.TestItem[]>();
    for (const item of items) {
      const folder = this.known.get(item)?.folder;
      if (folder !== undefined) folders.set(folder, [...(folders.get(folder) ?? []), item]);
    }
    return folders;
  }

  /** The tests below an item, or itself. */
  private leaves(item: vscode.TestItem): vscode.TestItem[] {
    return item.children.size === 0 ? [item] : [...item.children].flatMap(([, child]) => this.leaves(child));
  }

  /** How tests are run with few runs of the program: several of a file by the whole file, one by its name. */
  private portions(leaves: readonly vscode.TestItem[]): { words: string[]; tests: vscode.TestItem[] }[] {
    const files = new Map<string, vscode.TestItem[]>();
    const portions: { words: string[]; tests: vscode.TestItem[] }[] = [];
    for (const item of leaves) {
      const { file, place } = this.known.get(item) ?? {};
      if (file !== undefined) files.set(file, [...(files.get(file) ?? []), item]);
      else portions.push({ words: place === undefined ? [] : ['--filter', place.name], tests: [item] });
    }
    for (const [file, tests] of files) {
      const only = tests.length === 1 && tests[0] !== undefined ? this.known.get(tests[0])?.place : undefined;
      portions.push({ words: only === undefined ? [file] : [file, '--filter', only.name], tests });
    }
    return portions;
  }

  /** Shows results at their items. What was asked for and has no result says what the program said. */
  private async take(test: vscode.TestRun, folder: vscode.WorkspaceFolder, leaves: readonly vscode.TestItem[], results: readonly Result[], said: string): Promise<void> {
    const items = new Map(leaves.map((item) => [item.id, item]));
    for (const result of results) {
      const id = `${folder.uri.toString()}\n${result.name}`;
      const item = items.get(id);
      if (item === undefined) continue;
      this.diagrams.delete(id);
      const took = result.duration_s * 1000;
      test.appendOutput(`${result.verdict.padEnd(7)} ${result.name}  (${result.scans} scans, ${result.time_ms} ms of virtual time)\r\n`, undefined, item);
      if (result.verdict === 'passed') {
        test.passed(item, took);
        continue;
      }
      const failure = failureOf(result);
      // The output has letters of one width, as a drawing needs them.
      if (failure.drawn !== '') test.appendOutput(`${failure.drawn.replaceAll('\n', '\r\n')}\r\n`, undefined, item);
      test.failed(item, await this.message(item, folder, result, failure), took);
    }
    // A file that does not compile has one result of its own name, and its tests have none.
    const names = new Set(results.map(({ name }) => name));
    for (const item of leaves) {
      const { place, file } = this.known.get(item) ?? {};
      if (names.has(place?.name ?? file ?? '')) continue;
      const whole = results.find(({ name }) => name === file);
      const message = new vscode.TestMessage(whole === undefined ? said.trim() || 'The program gave no result.' : new vscode.MarkdownString(failureOf(whole).markdown));
      test.errored(item, message);
    }
  }

  /** What is shown of a failure: the sentence, the statement, the diagram as a picture. */
  private async message(item: vscode.TestItem, folder: vscode.WorkspaceFolder, result: Result, failure: Failure): Promise<vscode.TestMessage> {
    const text = new vscode.MarkdownString(failure.markdown);
    if (failure.diagram !== undefined) {
      const path = isAbsolute(failure.diagram) ? failure.diagram : join(folder.uri.fsPath, failure.diagram);
      const svg = await readFile(path, 'utf8').catch(() => '');
      if (svg !== '') {
        this.diagrams.set(item.id, svg);
        const words = encodeURIComponent(JSON.stringify([item.id]));
        text.isTrusted = { enabledCommands: ['sieben.showFailureDiagram'] };
        text.appendMarkdown(`\n\n[Show the timing diagram](command:sieben.showFailureDiagram?${words})\n\n![timing diagram](data:image/svg+xml;base64,${Buffer.from(svg).toString('base64')})`);
      }
    }
    const message = new vscode.TestMessage(text);
    if (result.file !== null && result.line !== null) {
      message.location = new vscode.Location(at(folder, result.file), new vscode.Position(result.line - 1, 0));
    }
    return message;
  }

  /** Opens the timing diagram of a test that failed. */
  showDiagram(test: vscode.TestItem | string | undefined): void {
    const id = typeof test === 'string' ? test : test?.id;
    const svg = id === undefined ? undefined : this.diagrams.get(id);
    if (svg === undefined) {
      void vscode.window.showInformationMessage('There is no timing diagram of this test: it has not failed since the editor was started.');
      return;
    }
    const title = id?.split('\n')[1] ?? '';
    const panel = vscode.window.createWebviewPanel('sieben.failure', basename(title), vscode.ViewColumn.Beside, { enableScripts: false, localResourceRoots: [] });
    panel.webview.html = html(svg, title, isDark(), 'fitting');
  }

  /** Runs a test of a file by its name, or all of the file: what a lens of the server does. */
  async runNamed(uri: vscode.Uri, name: string | undefined): Promise<void> {
    await this.look();
    const of = [...this.controller.items].flatMap(([, item]) => this.leaves(item)).filter((item) => item.uri?.toString() === uri.toString());
    const chosen = of.filter((item) => name === undefined || item.label === name);
    if (chosen.length > 0) await this.run(new vscode.TestRunRequest(chosen), new vscode.CancellationTokenSource().token);
  }
}

/** A file as the program names it. */
const at = (folder: vscode.WorkspaceFolder, path: string): vscode.Uri => (isAbsolute(path) ? vscode.Uri.file(path) : vscode.Uri.joinPath(folder.uri, path));
