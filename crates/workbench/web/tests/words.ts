// The tables of words as the page has them, read from their sources: no runes outside of a page.
import { readFileSync } from 'node:fs';

const source = ['words.svelte.ts', 'plants/words.ts', 'watch/words.ts', 'symbols/words.ts', 'cpu/words.ts'].map((file) => readFileSync(new URL(`../src/${file}`, import.meta.url), 'utf8')).join('\n');
export const TABLE: Record<string, [string, string]> = Object.fromEntries([...source.matchAll(/^ {2}(\w+): \[(['"])(.*?)\2, (['"])(.*?)\4\],$/gm)].map((row) => [row[1] ?? '', [row[3] ?? '', row[5] ?? ''] as [string, string]]));
if (Object.keys(TABLE).length < 150) throw new Error('the table of words could not be read');
