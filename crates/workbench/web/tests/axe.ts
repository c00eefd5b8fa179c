// What axe finds on a page: WCAG 2.2 A and AA.
import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';

const SOURCE = readFileSync(new URL('../node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
// The contract leaves out experimental rules; the one that is named is the only one of these tags.
const OPTIONS = { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'], rules: { 'label-content-name-mismatch': { enabled: false } } };

interface Axe {
  run(node: Document, options: unknown): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }>;
}

/** Each rule that is broken, with the elements that break it. */
export async function violations(page: Page): Promise<string[]> {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(SOURCE);
  return page.evaluate(async (options) => {
    const result = await (window as unknown as { axe: Axe }).axe.run(document, options);
    return result.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 160)).join(' | ')}`);
  }, OPTIONS);
}
