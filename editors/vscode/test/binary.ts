// The binary that the tests work with: the one that `SIEBEN` names, or the one that cargo builds.
import { join } from 'node:path';
import { EXTENSION } from './grammar';

/** The folder of the project. */
export const ROOT = join(EXTENSION, '../..');
export const BINARY = process.env['SIEBEN'] ?? join(process.env['CARGO_TARGET_DIR'] ?? join(ROOT, 'target'), 'debug/sieben');
