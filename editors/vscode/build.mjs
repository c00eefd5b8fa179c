// Bundles the extension into one file. The editor brings the module `vscode`; all else is in it.
import { build } from 'esbuild';

await build({
  entryPoints: ['src/extension.ts'],
  outfile: 'dist/extension.js',
  bundle: true,
  platform: 'node',
  target: 'node18',
  format: 'cjs',
  external: ['vscode'],
  // The browser build of the protocol's libraries comes first for `import`: the one for Node is meant.
  mainFields: ['main', 'module'],
  minify: true,
  legalComments: 'none',
  logLevel: 'warning',
});
