// The extension: what it brings when it is started, and what goes when it ends.
import * as vscode from 'vscode';
import { associateSt, checkProject, newProject } from './commands';
import { DiagramPanel } from './diagram';
import { Server } from './server';
import { Status } from './status';
import { Tasks } from './tasks';
import { Tests } from './tests';

let server: Server | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const status = new Status();
  const tests = new Tests(context);
  const started = new Server(context, status, async (parameters) => runTest(tests, parameters));
  server = started;
  const diagram = new DiagramPanel(started);
  const command = (name: string, act: (...words: never[]) => unknown): vscode.Disposable => vscode.commands.registerCommand(`sieben.${name}`, act);
  context.subscriptions.push(
    status,
    tests,
    started,
    diagram,
    vscode.tasks.registerTaskProvider('sieben', new Tasks(context)),
    command('openDiagram', async () => diagram.open()),
    command('showFailureDiagram', (test: vscode.TestItem | string | undefined) => tests.showDiagram(test)),
    command('associateSt', async (where?: 'workspace' | 'everywhere') => associateSt(where)),
    command('newProject', async (example?: string, place?: vscode.Uri) => newProject(context, example, place)),
    command('checkProject', async () => checkProject()),
    command('restartServer', async () => started.restart()),
    command('showLog', () => started.showLog()),
    command('openWalkthrough', async () => vscode.commands.executeCommand('workbench.action.openWalkthrough', `${context.extension.id}#start`)),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration('sieben.path') || change.affectsConfiguration('sieben.otherLanguages')) {
        void started.restart();
        tests.lookSoon();
      } else if (change.affectsConfiguration('sieben')) {
        started.tellSettings();
      }
    }),
  );
  await started.start();
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}

/** Runs the test that a lens of the server names by its file and name. */
async function runTest(tests: Tests, parameters: readonly unknown[]): Promise<void> {
  const [uri, name] = parameters;
  if (typeof uri === 'string') await tests.runNamed(vscode.Uri.parse(uri), typeof name === 'string' ? name : undefined);
}
