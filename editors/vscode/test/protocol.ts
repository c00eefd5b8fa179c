// A client of the language server that does what it is told, over standard input and output.
import { spawn, type ChildProcess } from 'node:child_process';
import { pathToFileURL } from 'node:url';
import { createMessageConnection, StreamMessageReader, StreamMessageWriter, type MessageConnection } from 'vscode-jsonrpc/node';
import type { CodeAction, Diagnostic, InitializeResult, PublishDiagnosticsParams, TextEdit, WorkspaceEdit } from 'vscode-languageserver-protocol';

/** Within this time an answer is there. */
const ANSWERS_WITHIN = 30_000;

/** A client with a folder. */
export class Client {
  private readonly diagnostics = new Map<string, Diagnostic[]>();
  private readonly waiting = new Set<() => void>();
  private readonly child: ChildProcess;
  private readonly connection: MessageConnection;
  private version = 0;

  constructor(
    binary: string,
    private readonly folder: string,
  ) {
    this.child = spawn(binary, ['lsp'], { cwd: folder, stdio: ['pipe', 'pipe', 'inherit'] });
    if (this.child.stdout === null || this.child.stdin === null) throw new Error('the server has no pipes');
    this.connection = createMessageConnection(new StreamMessageReader(this.child.stdout), new StreamMessageWriter(this.child.stdin));
    this.connection.onNotification('textDocument/publishDiagnostics', ({ uri, diagnostics }: PublishDiagnosticsParams) => {
      this.diagnostics.set(decodeURIComponent(uri), diagnostics);
      this.waiting.forEach((look) => look());
    });
    this.connection.onRequest((_method, parameters) => (Array.isArray((parameters as { items?: unknown[] } | undefined)?.items) ? [] : null));
    this.connection.listen();
  }

  async begin(): Promise<InitializeResult> {
    const uri = pathToFileURL(this.folder).href;
    const answer = await this.ask<InitializeResult>('initialize', {
      processId: process.pid,
      rootUri: uri,
      workspaceFolders: [{ uri, name: 'project' }],
      capabilities: {
        general: { positionEncodings: ['utf-16'] },
        workspace: { workspaceEdit: { documentChanges: true } },
        textDocument: { codeAction: { codeActionLiteralSupport: { codeActionKind: { valueSet: ['quickfix', 'refactor', 'source'] } }, dataSupport: true, resolveSupport: { properties: ['edit'] } } },
      },
    });
    this.tell('initialized', {});
    return answer;
  }

  /** Ends the server as an editor does; its exit code. */
  async end(): Promise<number | null> {
    const ended = new Promise<number | null>((done) => this.child.once('exit', done));
    await this.ask('shutdown', undefined);
    this.tell('exit', undefined);
    const code = await ended;
    this.connection.dispose();
    return code;
  }

  uri(file: string): string {
    return pathToFileURL(`${this.folder}/${file}`).href;
  }

  async ask<Answer>(method: string, parameters: unknown): Promise<Answer> {
    const late = new Promise<never>((_, failed) => setTimeout(() => failed(new Error(`no answer to ${method}`)), ANSWERS_WITHIN).unref());
    return Promise.race([this.connection.sendRequest<Answer>(method, parameters), late]);
  }

  tell(method: string, parameters: unknown): void {
    void this.connection.sendNotification(method, parameters);
  }

  open(file: string, languageId: string, text: string): void {
    this.tell('textDocument/didOpen', { textDocument: { uri: this.uri(file), languageId, version: (this.version += 1), text } });
  }

  /** Replaces the whole text of an open file. */
  write(file: string, text: string): void {
    this.tell('textDocument/didChange', { textDocument: { uri: this.uri(file), version: (this.version += 1) }, contentChanges: [{ text }] });
  }

  /** Waits until what is wrong with a file is as it should be. */
  async until(file: string, holds: (diagnostics: readonly Diagnostic[]) => boolean): Promise<readonly Diagnostic[]> {
    const uri = decodeURIComponent(this.uri(file));
    return new Promise((done, failed) => {
      const timer = setTimeout(() => failed(new Error(`${file}: ${JSON.stringify(this.diagnostics.get(uri))}`)), ANSWERS_WITHIN);
      const look = (): void => {
        const found = this.diagnostics.get(uri);
        if (found === undefined || !holds(found)) return;
        clearTimeout(timer);
        this.waiting.delete(look);
        done(found);
      };
      this.waiting.add(look);
      look();
    });
  }

  /** An action with its edit. */
  async resolved(action: CodeAction): Promise<CodeAction> {
    return action.edit === undefined ? this.ask<CodeAction>('codeAction/resolve', action) : action;
  }
}

/** The edits of one file in an edit of many. */
export function editsOf(edit: WorkspaceEdit, uri: string): TextEdit[] {
  const same = (other: string): boolean => decodeURIComponent(other) === decodeURIComponent(uri);
  const changes = Object.entries(edit.changes ?? {}).flatMap(([of, edits]) => (same(of) ? edits : []));
  const documents = (edit.documentChanges ?? []).flatMap((change) => ('edits' in change && same(change.textDocument.uri) ? (change.edits as TextEdit[]) : []));
  return [...changes, ...documents];
}

/** A text after its edits. */
export function edited(text: string, edits: readonly TextEdit[]): string {
  const starts = [0, ...[...text.matchAll(/\r\n|\n|\r/gu)].map((end) => end.index + end[0].length)];
  const at = ({ line, character }: { line: number; character: number }): number => (starts[line] ?? text.length) + character;
  const sorted = [...edits].sort((a, b) => at(b.range.start) - at(a.range.start));
  return sorted.reduce((all, { range, newText }) => all.slice(0, at(range.start)) + newText + all.slice(at(range.end)), text);
}
