// Tasks: what the program does with a project, with the problems that it reports.
import * as vscode from 'vscode';
import { program } from './sieben';

/** The verbs, the words that come after them, and what they are called. */
const VERBS = {
  check: { words: ['--output-format', 'concise'], name: 'check the project', matchers: ['$sieben'], group: vscode.TaskGroup.Build },
  test: { words: [], name: 'run the tests', matchers: [], group: vscode.TaskGroup.Test },
  fmt: { words: [], name: 'format all sources', matchers: [], group: undefined },
} as const;
type Verb = keyof typeof VERBS;

const isVerb = (word: unknown): word is Verb => typeof word === 'string' && word in VERBS;

/** Offers a task for each verb, and makes those of `tasks.json` runnable. */
export class Tasks implements vscode.TaskProvider {
  constructor(private readonly context: vscode.ExtensionContext) {}

  provideTasks(): vscode.Task[] {
    const folders = vscode.workspace.workspaceFolders ?? [];
    return folders.flatMap((folder) => (Object.keys(VERBS) as Verb[]).flatMap((verb) => this.task({ type: 'sieben', verb }, folder) ?? []));
  }

  resolveTask(task: vscode.Task): vscode.Task | undefined {
    const scope = task.scope;
    const folder = typeof scope === 'object' && 'uri' in scope ? scope : vscode.workspace.workspaceFolders?.[0];
    return folder === undefined ? undefined : this.task(task.definition, folder);
  }

  private task(definition: vscode.TaskDefinition, folder: vscode.WorkspaceFolder): vscode.Task | undefined {
    const verb: unknown = definition['verb'];
    const found = program(this.context);
    if (!isVerb(verb) || 'missing' in found) return undefined;
    const { words, name, matchers, group } = VERBS[verb];
    const further: unknown = definition['arguments'];
    const own = Array.isArray(further) ? further.map(String) : [];
    const at: unknown = definition['folder'];
    const paths = typeof at === 'string' && at !== '' ? [at] : [];
    // Messages are English: the problem matcher reads them.
    const process = new vscode.ProcessExecution(found.path, [verb, ...words, ...own, ...paths], { cwd: folder.uri.fsPath, env: { LC_ALL: 'C.UTF-8' } });
    const task = new vscode.Task(definition, folder, name, 'sieben', process, [...matchers]);
    if (group !== undefined) task.group = group;
    return task;
  }
}
