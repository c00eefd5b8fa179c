// The grammars of the extension, in the engine that VS Code itself uses.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import * as oniguruma from 'vscode-oniguruma';
import * as textmate from 'vscode-textmate';

/** The folder of the extension. */
export const EXTENSION = join(__dirname, '..');
/** The manifest of the extension. */
export const MANIFEST = JSON.parse(readFileSync(join(EXTENSION, 'package.json'), 'utf8')) as {
  version: string;
  contributes: { grammars: { language?: string; scopeName: string; path: string }[]; [part: string]: unknown };
};

const paths = new Map(MANIFEST.contributes.grammars.map(({ scopeName, path }) => [scopeName, path]));
const wasm = readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm'));
const onigLib = oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength)).then(() => ({
  createOnigScanner: (patterns: string[]) => new oniguruma.OnigScanner(patterns),
  createOnigString: (text: string) => new oniguruma.OnigString(text),
}));
const registry = new textmate.Registry({
  onigLib,
  loadGrammar: async (scope) => {
    const path = paths.get(scope);
    return path === undefined ? null : textmate.parseRawGrammar(readFileSync(join(EXTENSION, path), 'utf8'), path);
  },
});

/** A piece of a line and its scopes, the innermost last. */
export interface Piece {
  readonly text: string;
  readonly scopes: readonly string[];
}

/** The pieces of each line of a text of a language. */
export async function tokenized(language: string, text: string): Promise<Piece[][]> {
  const scope = MANIFEST.contributes.grammars.find((grammar) => grammar.language === language)?.scopeName ?? language;
  const grammar = await registry.loadGrammar(scope);
  if (grammar === null) throw new Error(`there is no grammar of ${language}`);
  let state: textmate.StateStack = textmate.INITIAL;
  return text.split(/\r\n|\n|\r/u).map((line) => {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, state);
    state = ruleStack;
    return tokens.map(({ startIndex, endIndex, scopes }) => ({ text: line.slice(startIndex, endIndex), scopes }));
  });
}

/** The lines of a text with what each piece is, without what has no colour: `A=keyword.other.instruction I 0.0=variable.other.address`. */
export async function shown(language: string, text: string): Promise<string[]> {
  const lines = await tokenized(language, text);
  return lines.map((pieces) =>
    pieces
      .filter(({ text, scopes }) => text.trim() !== '' && scopes.length > 1)
      .map(({ text, scopes }) => `${text.trim()}=${innermost(scopes)}`)
      .join(' '),
  );
}

/** The innermost scope without the language at its end. */
const innermost = (scopes: readonly string[]): string => (scopes.at(-1) ?? '').replace(/\.(?:awl|scl|st|s7db)$/u, '');
