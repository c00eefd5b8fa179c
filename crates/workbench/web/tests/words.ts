// The table of words as the page has it, read from its source: no runes outside of a page.
import { readFileSync } from 'node:fs';

const source = readFileSync(new URL('../src/words.svelte.ts', import.meta.url), 'utf8');
export const TABLE: Record<string, [string, string]> = Object.fromEntries([...source.matchAll(/^ {2}(\w+): \[(['"])(.*?)\2, (['"])(.*?)\4\],$/gm)].map((row) => [row[1] ?? '', [row[3] ?? '', row[5] ?? ''] as [string, string]]));
if (Object.keys(TABLE).length < 150) throw new Error('the table of words could not be read');
