// The steps of the walkthrough, done by a script: what a person does there with the program and the language server.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import type { CodeAction, WorkspaceEdit } from 'vscode-languageserver-protocol';
import { BINARY } from './binary';
import { resultsOf } from '../src/results';
import { Client, edited, editsOf } from './protocol';

const FILES = ['dosing.awl', 'symbols.csv', 'dosing.test.st'] as const;

let above: string;
let folder: string;
let client: Client;
const read = (file: string): string => readFileSync(join(folder, file), 'utf8');

test.describe.configure({ mode: 'serial' });

test.beforeAll(() => {
  above = realpathSync(mkdtempSync(join(tmpdir(), 'sieben-walk-')));
  folder = join(above, 'dosing');
});
test.afterAll(() => rmSync(above, { recursive: true, force: true }));

test('project: an example is taken', () => {
  execFileSync(BINARY, ['new', 'dosing', '--example', 'dosing'], { cwd: above });
  for (const file of FILES) expect(read(file).length).toBeGreaterThan(0);
});

test('server: it is found, and says what it is', async () => {
  client = new Client(BINARY, folder);
  const { serverInfo, capabilities } = await client.begin();
  expect(serverInfo?.name).toBe('sieben');
  expect(serverInfo?.version).toMatch(/^\d+\.\d+\.\d+/u);
  expect(capabilities.positionEncoding).toBe('utf-16');
});

test('problems: a mistake is marked, and a fix mends it', async () => {
  const text = read('dosing.awl');
  client.open('dosing.awl', 'awl', text);
  await client.until('dosing.awl', (found) => found.length === 0);
  const line = text.split('\n').findIndex((words) => words.includes('R     Q 0.0'));
  const lines = text.split('\n');
  lines.splice(line, 0, '      JC    weg;');
  client.write('dosing.awl', lines.join('\n'));
  const [missing] = await client.until('dosing.awl', (found) => found.length > 0);
  expect(missing).toMatchObject({ code: 'P3004', severity: 1, range: { start: { line, character: 12 }, end: { line, character: 15 } } });
  expect(missing?.codeDescription?.href).toContain('P3004');

  // A slip that can mean only one thing has a fix.
  const slip = text.replace('FP    M 0.0;', 'FP    M 0,0;');
  client.write('dosing.awl', slip);
  const wrong = await client.until('dosing.awl', (found) => found.length > 0 && found[0]?.code !== 'P3004');
  const range = wrong[0]?.range;
  const actions = await client.ask<CodeAction[]>('textDocument/codeAction', { textDocument: { uri: client.uri('dosing.awl') }, range, context: { diagnostics: wrong, only: ['quickfix'] } });
  const fix = actions.find((action) => action.kind === 'quickfix');
  if (fix === undefined) throw new Error(`no quick fix: ${JSON.stringify(actions)}`);
  const { edit } = await client.resolved(fix);
  const mended = edited(slip, editsOf(edit ?? {}, client.uri('dosing.awl')));
  expect(mended).toBe(text);
  client.write('dosing.awl', mended);
  await client.until('dosing.awl', (found) => found.length === 0);
});

test('rename: a symbol is renamed in the symbol table and the tests', async () => {
  const tests = read('dosing.test.st');
  client.open('dosing.test.st', 'st', tests);
  const line = tests.split('\n').findIndex((words) => words.includes('"VALVE"'));
  const character = (tests.split('\n')[line] ?? '').indexOf('VALVE') + 1;
  const edit = await client.ask<WorkspaceEdit>('textDocument/rename', { textDocument: { uri: client.uri('dosing.test.st') }, position: { line, character }, newName: 'OUTLET' });
  for (const file of ['symbols.csv', 'dosing.test.st']) {
    const text = edited(read(file), editsOf(edit, client.uri(file)));
    expect(text).toContain('OUTLET');
    expect(text).not.toContain('VALVE');
    writeFileSync(join(folder, file), text);
  }
});

test('diagram: the network at the cursor is drawn', async () => {
  const { svg } = await client.ask<{ svg: string }>('workspace/executeCommand', {
    command: 'sieben.showDiagram',
    arguments: [client.uri('dosing.awl'), { line: 7, character: 6 }],
  });
  expect(svg).toMatch(/^<svg /u);
  expect(svg).toContain('I 0.0');
  expect(svg).not.toContain('<script');
});

test('tests: those of the project pass, and one that fails draws its signals', () => {
  const passed = resultsOf(execFileSync(BINARY, ['test', '--json'], { cwd: folder, encoding: 'utf8' }));
  expect(passed?.length).toBeGreaterThan(3);
  expect(new Set(passed?.map(({ verdict }) => verdict))).toEqual(new Set(['passed']));
  writeFileSync(join(folder, 'dosing.test.st'), read('dosing.test.st').replace('16#0025', '16#0026'));
  const failed = run(['test', '--json', '--svg', join(above, 'pictures')]).find(({ verdict }) => verdict === 'failed');
  expect(failed?.more.some((line) => line.startsWith('timing diagram: '))).toBe(true);
});

test('the server ends with the editor', async () => {
  expect(await client.end()).toBe(0);
});

/** Runs tests of which some fail. */
function run(words: readonly string[]): NonNullable<ReturnType<typeof resultsOf>> {
  try {
    return resultsOf(execFileSync(BINARY, words, { cwd: folder, encoding: 'utf8', stdio: 'pipe' })) ?? [];
  } catch (error) {
    return resultsOf((error as { stdout: string }).stdout) ?? [];
  }
}
