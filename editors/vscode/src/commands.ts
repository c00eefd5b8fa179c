// What a user asks for by name and is no matter of one file: associations, projects, tasks.
import { join } from 'node:path';
import * as vscode from 'vscode';
import { program, run } from './sieben';

/** Has files that end in `.st` read as those of Sieben, in this workspace or everywhere. */
export async function associateSt(where?: 'workspace' | 'everywhere'): Promise<void> {
  const places = [
    { label: 'In this workspace', target: vscode.ConfigurationTarget.Workspace, where: 'workspace' },
    { label: 'Everywhere', target: vscode.ConfigurationTarget.Global, where: 'everywhere' },
  ].filter((place) => place.where === 'everywhere' || vscode.workspace.workspaceFolders !== undefined);
  const chosen = where === undefined ? await vscode.window.showQuickPick(places, { placeHolder: 'Where files that end in .st belong to Sieben' }) : places.find((place) => place.where === where);
  if (chosen === undefined) return;
  const files = vscode.workspace.getConfiguration('files');
  const set = files.inspect<Record<string, string>>('associations');
  const old = chosen.where === 'workspace' ? set?.workspaceValue : set?.globalValue;
  await files.update('associations', { ...old, '*.st': 'st' }, chosen.target);
}

/** Examples that `sieben new` copies, each with its plant and tests. */
const EXAMPLES = ['dosing', 'tank', 'conveyor', 'elevator', 'traffic-light', 'star-delta', 'heater', 'packing', 'car-park'];

/** Makes a project of an example, and opens it. */
export async function newProject(context: vscode.ExtensionContext, example?: string, place?: vscode.Uri): Promise<vscode.Uri | undefined> {
  const found = program(context);
  if ('missing' in found) {
    void vscode.window.showErrorMessage(found.missing);
    return undefined;
  }
  const name = example ?? (await vscode.window.showQuickPick(EXAMPLES, { placeHolder: 'The example that the project begins with' }));
  if (name === undefined) return undefined;
  const folder = place ?? (await vscode.window.showOpenDialog({ canSelectFiles: false, canSelectFolders: true, openLabel: 'Make the Project Here' }))?.[0];
  if (folder === undefined) return undefined;
  const ended = await run(found.path, folder.fsPath, ['new', name, '--example', name]);
  if (ended.code !== 0) {
    void vscode.window.showErrorMessage(`Sieben: ${ended.stderr.trim()}`);
    return undefined;
  }
  const project = vscode.Uri.file(join(folder.fsPath, name));
  if (place === undefined) await vscode.commands.executeCommand('vscode.openFolder', project, { forceNewWindow: vscode.workspace.workspaceFolders !== undefined });
  return project;
}

/** Runs the task that checks the project. */
export async function checkProject(): Promise<void> {
  const tasks = await vscode.tasks.fetchTasks({ type: 'sieben' });
  const check = tasks.find((task) => task.definition['verb'] === 'check');
  if (check !== undefined) await vscode.tasks.executeTask(check);
}
