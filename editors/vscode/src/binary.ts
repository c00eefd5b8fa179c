// Where the program `sieben` is: the one that the user names, the one on PATH, or the one that came with the extension.
import { delimiter, isAbsolute, join } from 'node:path';

/** Where it is looked for. */
export interface Places {
  /** What the setting says; empty if it says nothing. */
  readonly setting: string;
  /** The folders of PATH, as the environment has them. */
  readonly path: string | undefined;
  /** The folder of the user, for `~`. */
  readonly home: string;
  /** The folder of the extension. */
  readonly extension: string;
  /** Whether programs end in `.exe`. */
  readonly windows: boolean;
  /** Whether a path is a file that can be run. */
  readonly isProgram: (path: string) => boolean;
}

/** The program and where it was found, or why there is none. */
export type Found = { readonly path: string; readonly from: 'setting' | 'PATH' | 'bundled' } | { readonly missing: string };

/** Finds it. What the setting names is never replaced by another one. */
export function find(places: Places): Found {
  const named = places.setting.trim();
  if (named !== '') {
    const path = named.startsWith('~/') ? join(places.home, named.slice(2)) : named;
    const found = isAbsolute(path) ? (places.isProgram(path) ? path : undefined) : onPath(path, places);
    return found === undefined ? { missing: `\`${named}\`, which the setting sieben.path names, is no program.` } : { path: found, from: 'setting' };
  }
  const installed = onPath('sieben', places);
  if (installed !== undefined) return { path: installed, from: 'PATH' };
  const bundled = join(places.extension, 'bin', withEnding('sieben', places));
  if (places.isProgram(bundled)) return { path: bundled, from: 'bundled' };
  return { missing: 'The program `sieben` is not on PATH, and none came with the extension. Install it, or name it in the setting sieben.path.' };
}

function onPath(name: string, places: Places): string | undefined {
  if (name.includes('/') || name.includes('\\')) return undefined;
  const folders = (places.path ?? '').split(delimiter).filter((folder) => isAbsolute(folder));
  return folders.map((folder) => join(folder, withEnding(name, places))).find(places.isProgram);
}

const withEnding = (name: string, places: Places): string => (places.windows && !name.toLowerCase().endsWith('.exe') ? `${name}.exe` : name);
