// The panel that draws the network at the cursor.
import * as vscode from 'vscode';
import type { Server } from './server';
import { html, isDark } from './picture';

/** Languages that have networks. */
const LANGUAGES = ['awl', 'lad', 'fbd', 'st', 'scl'];
/** So long the cursor rests before the network is drawn. */
const REST_MS = 150;

/** What the server draws. */
interface Drawing {
  readonly svg: string;
  readonly block: string;
  readonly network: number;
}

/** The panel; there is one at most. */
export class DiagramPanel implements vscode.Disposable {
  private panel: vscode.WebviewPanel | undefined;
  private editor: vscode.TextEditor | undefined;
  private timer: NodeJS.Timeout | undefined;
  private shown: { svg: string; title: string } = { svg: '', title: '' };
  private asked = 0;
  private readonly listeners: vscode.Disposable;

  constructor(private readonly server: Server) {
    this.listeners = vscode.Disposable.from(
      vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => this.follow(textEditor)),
      vscode.window.onDidChangeActiveTextEditor((editor) => editor !== undefined && this.follow(editor)),
      vscode.workspace.onDidChangeTextDocument(({ document }) => document === this.editor?.document && this.follow(this.editor)),
      vscode.window.onDidChangeActiveColorTheme(() => this.show()),
    );
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.panel?.dispose();
    this.listeners.dispose();
  }

  /** Opens it next to the text, and draws the network at the cursor. */
  async open(): Promise<void> {
    const editor = vscode.window.activeTextEditor ?? this.editor;
    if (editor === undefined || !LANGUAGES.includes(editor.document.languageId)) {
      void vscode.window.showInformationMessage('Put the cursor into a network of a block first.');
      return;
    }
    if (this.panel === undefined) {
      const place = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
      this.panel = vscode.window.createWebviewPanel('sieben.diagram', 'Diagram', place, { enableScripts: false, localResourceRoots: [] });
      this.panel.onDidDispose(() => (this.panel = undefined));
    } else {
      this.panel.reveal(undefined, true);
    }
    this.editor = editor;
    await this.draw();
  }

  private follow(editor: vscode.TextEditor): void {
    if (this.panel === undefined || !LANGUAGES.includes(editor.document.languageId)) return;
    this.editor = editor;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.draw(), REST_MS);
  }

  private async draw(): Promise<void> {
    const editor = this.editor;
    if (editor === undefined) return;
    const question = ++this.asked;
    const { line, character } = editor.selection.active;
    const form = editor.document.languageId === 'fbd' ? 'fbd' : 'lad';
    const drawing = await this.server.execute<Drawing>('sieben.showDiagram', this.server.uriOf(editor.document), { line, character }, form);
    // An older answer must not take the place of a newer one.
    if (question !== this.asked) return;
    if (drawing === undefined) this.shown = { svg: '', title: 'There is no network at the cursor that can be drawn.' };
    else this.shown = { svg: drawing.svg, title: `${drawing.block}, network ${drawing.network}` };
    this.show();
  }

  private show(): void {
    if (this.panel === undefined) return;
    this.panel.title = this.shown.svg === '' ? 'Diagram' : `Diagram: ${this.shown.title}`;
    this.panel.webview.html = html(this.shown.svg, this.shown.title, isDark());
  }
}
