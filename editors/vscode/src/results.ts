// What `sieben test --json` says, as plain data, and what of it is shown of a test that failed.

/** Where a test stands: one of `places` of `sieben test --list --json`. */
export interface Place {
  readonly name: string;
  /** The test file; null for a scenario and a program that checks itself. */
  readonly test_file: string | null;
  /** The line of the test, from 1. */
  readonly line: number | null;
}

/** One of `tests` of `sieben test --json`. */
export interface Result {
  readonly name: string;
  readonly test_file: string | null;
  readonly verdict: string;
  readonly message: string | null;
  readonly file: string | null;
  readonly line: number | null;
  readonly statement: string | null;
  readonly said: string | null;
  /** Further lines: who changed the value last, the timing diagram as text. */
  readonly more: readonly string[];
  readonly scans: number;
  /** Virtual time. */
  readonly time_ms: number;
  /** Real time. */
  readonly duration_s: number;
}

/** The tests of a list; nothing if it is none. */
export function placesOf(json: string): readonly Place[] {
  const read = parsed(json);
  if (Array.isArray(read['places'])) return read['places'] as Place[];
  const names = Array.isArray(read['tests']) ? (read['tests'] as unknown[]) : [];
  return names.filter((name) => typeof name === 'string').map((name) => ({ name, test_file: null, line: null }));
}

/** The results of a run; undefined if the output holds none. */
export function resultsOf(json: string): readonly Result[] | undefined {
  const tests = parsed(json)['tests'];
  return Array.isArray(tests) ? (tests as Result[]) : undefined;
}

function parsed(json: string): Record<string, unknown> {
  try {
    const value: unknown = JSON.parse(json);
    return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : {};
  } catch {
    return {};
  }
}

/** The name of a test without the file before it. */
export function shortName(place: Place): string {
  const before = place.test_file === null ? '' : `${place.test_file}: `;
  return place.name.startsWith(before) ? place.name.slice(before.length) : place.name;
}

/** A line of `more` that says where the timing diagram lies. */
const DIAGRAM = 'timing diagram: ';

/** A failure as it is shown. */
export interface Failure {
  /** In Markdown, without the diagram. */
  readonly markdown: string;
  /** The timing diagram as text. */
  readonly drawn: string;
  /** The file of the timing diagram, as SVG. */
  readonly diagram: string | undefined;
}

/** What is shown of a test that failed. */
export function failureOf(result: Result): Failure {
  // The first line is also a title, in which code in backticks is not shown as it is.
  const parts = [escaped((result.message ?? result.verdict).replaceAll('`', ''))];
  if (result.said !== null) parts.push(escaped(result.said));
  if (result.statement !== null) parts.push(fenced(result.statement, 'st'));
  const lines = result.more.filter((line) => !line.startsWith(DIAGRAM));
  parts.push(...lines.filter(isSentence).map(escaped));
  return {
    markdown: parts.join('\n\n'),
    drawn: lines.filter((line) => !isSentence(line)).join('\n'),
    diagram: result.more.find((line) => line.startsWith(DIAGRAM))?.slice(DIAGRAM.length),
  };
}

/** Whether a further line is a sentence and no part of a drawing: who changed a value last, or what was left out. */
const isSentence = (line: string): boolean => /^`[^`]+` was changed last by /u.test(line);

const fenced = (text: string, language: string): string => {
  const ticks = '`'.repeat(Math.max(3, ...[...text.matchAll(/`+/gu)].map((run) => run[0].length + 1)));
  return `${ticks}${language}\n${text}\n${ticks}`;
};

/** Text in which Markdown finds nothing but code in backticks. */
const escaped = (text: string): string => text.replace(/[\\*_{}[\]()#+\-!<>|~]/gu, '\\$&').replace(/`[^`]*`/gu, (code) => code.replace(/\\(.)/gu, '$1'));
