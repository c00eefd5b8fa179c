// Programs that are too long to write by hand, put into the place of an example.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Sieben } from '../tests/sieben';

/** Lets the run have this program alone, without a plant. */
export async function replaced(sieben: Sieben, program: string, further: Record<string, string> = {}): Promise<void> {
  await sieben.kill();
  writeFileSync(join(sieben.folder, 'sieben.toml'), '[project]\nname = "long"\nsources = ["long.awl"]\n\n[cpu]\ncycle = "10ms"\n');
  writeFileSync(join(sieben.folder, 'long.awl'), program);
  for (const [name, text] of Object.entries(further)) writeFileSync(join(sieben.folder, name), text);
  await sieben.start();
}

const block = (networks: string[]) => `ORGANIZATION_BLOCK OB 1\nBEGIN\n${networks.join('')}END_ORGANIZATION_BLOCK\n`;
const word = (n: number) => 100 + (n % 500) * 2;

/** So many statements, each with another value in each scan. */
export function statements(count: number): string {
  const four = (n: number) => `      L     MW 10;\n      L     ${n};\n      +I    ;\n      T     MW ${word(n)};\n`;
  const first = 'NETWORK\nTITLE = Counts scans\n      L     MW 10;\n      L     1;\n      +I    ;\n      T     MW 10;\n';
  const rest = Array.from({ length: Math.ceil((count - 4) / 20) }, (_, n) => `NETWORK\nTITLE = Sums\n${[0, 1, 2, 3, 4].map((part) => four(n * 5 + part)).join('')}`);
  return block([first, ...rest]);
}

/** So many networks that ladder can show; their power flow is another in each scan. */
export function networks(count: number): string {
  const first = 'NETWORK\nTITLE = One scan on, one scan off\n      AN    M 0.0;\n      =     M 0.0;\n';
  const one = (n: number) => `NETWORK\nTITLE = Follows\n      A     M 0.0;\n      A(    ;\n      O     M 0.1;\n      O     M 0.0;\n      )     ;\n      AN    M 0.2;\n      =     M ${10 + (n >> 3) % 200}.${n % 8};\n`;
  return block([first, ...Array.from({ length: count - 1 }, (_, n) => one(n))]);
}

/** A watch table of so many rows. */
export function watch(rows: number): string {
  return `name,format,comment\n${Array.from({ length: rows }, (_, n) => `M ${(n >> 3) % 1000}.${n % 8},BOOL,row ${n}\n`).join('')}`;
}
