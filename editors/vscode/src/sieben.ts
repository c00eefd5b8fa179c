// The program `sieben` as a process: found by the settings, run to its end.
import { execFile } from 'node:child_process';
import { accessSync, constants, statSync } from 'node:fs';
import { homedir } from 'node:os';
import * as vscode from 'vscode';
import { find, type Found } from './binary';

/** What a run of the program gave. */
export interface Ended {
  /** Its exit code; null if it was ended from outside or did not start. */
  readonly code: number | null;
  readonly stdout: string;
  readonly stderr: string;
}

/** Output that is kept of one run: results of many thousand tests are smaller. */
const OUTPUT_BYTES_MAX = 64 << 20;

/** The program as the settings of this moment say. */
export function program(context: vscode.ExtensionContext): Found {
  return find({
    setting: vscode.workspace.getConfiguration('sieben').get('path', ''),
    path: process.env['PATH'],
    home: homedir(),
    extension: context.extensionPath,
    windows: process.platform === 'win32',
    isProgram,
  });
}

function isProgram(path: string): boolean {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}

/** Runs the program in a folder. Messages are English, whatever the environment says: they are read by us. */
export async function run(path: string, folder: string, words: readonly string[], token?: vscode.CancellationToken): Promise<Ended> {
  return new Promise((done) => {
    const options = { cwd: folder, maxBuffer: OUTPUT_BYTES_MAX, windowsHide: true, env: { ...process.env, LC_ALL: 'C.UTF-8' } };
    const child = execFile(path, words, options, (error, stdout, stderr) => {
      cancelled?.dispose();
      const code = error === null ? 0 : typeof error.code === 'number' ? error.code : null;
      done({ code, stdout, stderr: stderr === '' && code === null && error !== null ? error.message : stderr });
    });
    const cancelled = token?.onCancellationRequested(() => child.kill());
  });
}
