// The item of the status bar: whether the server runs, and what can be done about it.
import * as vscode from 'vscode';

/** What the server does. */
export type State = { readonly kind: 'starting' | 'stopped' } | { readonly kind: 'running'; readonly version: string } | { readonly kind: 'failed'; readonly reason: string };

/** The item. */
export class Status implements vscode.Disposable {
  private readonly item = vscode.window.createStatusBarItem('sieben.status', vscode.StatusBarAlignment.Right, 90);

  constructor() {
    this.item.name = 'Sieben';
    this.set({ kind: 'starting' });
    this.item.show();
  }

  dispose(): void {
    this.item.dispose();
  }

  set(state: State): void {
    void vscode.commands.executeCommand('setContext', 'sieben.serverRuns', state.kind === 'running');
    const plain = state.kind !== 'failed';
    this.item.backgroundColor = plain ? undefined : new vscode.ThemeColor('statusBarItem.errorBackground');
    this.item.command = plain ? 'sieben.showLog' : 'sieben.restartServer';
    switch (state.kind) {
      case 'starting':
        this.item.text = '$(loading~spin) Sieben';
        this.item.tooltip = 'The language server is starting.';
        return;
      case 'running':
        this.item.text = '$(check) Sieben';
        this.item.tooltip = `sieben ${state.version} is running. A click shows its log.`;
        return;
      case 'stopped':
        this.item.text = '$(circle-slash) Sieben';
        this.item.tooltip = 'The language server is stopped.';
        return;
      case 'failed':
        this.item.text = '$(error) Sieben';
        this.item.tooltip = `${state.reason} A click starts it again.`;
    }
  }
}
