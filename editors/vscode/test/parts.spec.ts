// Parts of the extension that need no editor, and what the manifest promises.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { find, type Places } from '../src/binary';
import { failureOf, placesOf, resultsOf, shortName, type Result } from '../src/results';
import { EXTENSION, MANIFEST } from './grammar';

const places = (programs: string[], further: Partial<Places> = {}): Places => ({
  setting: '',
  path: ['/usr/bin', 'relative', '/opt/sieben'].join(':'),
  home: '/people/me',
  extension: '/ext',
  windows: false,
  isProgram: (path) => programs.includes(path),
  ...further,
});

test('the program is the one of the setting, else the one on PATH, else the bundled one', () => {
  const all = ['/my/sieben', '/opt/sieben/sieben', '/ext/bin/sieben', '/people/me/sieben', 'relative/sieben'];
  expect(find(places(all, { setting: '/my/sieben' }))).toEqual({ path: '/my/sieben', from: 'setting' });
  expect(find(places(all, { setting: '~/sieben' }))).toEqual({ path: '/people/me/sieben', from: 'setting' });
  expect(find(places(all, { setting: ' sieben ' }))).toEqual({ path: '/opt/sieben/sieben', from: 'setting' });
  expect(find(places(all))).toEqual({ path: '/opt/sieben/sieben', from: 'PATH' });
  expect(find(places(['/ext/bin/sieben']))).toEqual({ path: '/ext/bin/sieben', from: 'bundled' });
  expect(find(places(['/ext/bin/sieben.exe'], { windows: true, path: undefined }))).toEqual({ path: '/ext/bin/sieben.exe', from: 'bundled' });
});

test('what the setting names is never replaced by another one', () => {
  const all = ['/opt/sieben/sieben', '/ext/bin/sieben'];
  for (const setting of ['/my/sieben', './sieben', 'other']) expect(find(places(all, { setting }))).toHaveProperty('missing');
  expect(find(places([]))).toHaveProperty('missing');
});

const RESULT: Result = {
  name: 'a.test.st: the display shows 26',
  test_file: 'a.test.st',
  verdict: 'failed',
  message: '`"DISPLAY"` is W#16#0025 (WORD), not 16#0026',
  file: 'a.test.st',
  line: 10,
  statement: 'ASSERT_EQ("DISPLAY", 16#0026);',
  said: 'why *not*',
  more: ['`DISPLAY` was changed last by dosing.awl:30 `T QW 4` (OB 1, statement 15), in scan 1 at 10 ms', 'START ──┘', 'timing diagram: /tmp/x.svg'],
  scans: 2,
  time_ms: 10,
  duration_s: 0.1,
};

test('a failure is shown with its statement, who changed the value, and its diagram', () => {
  expect(failureOf(RESULT)).toEqual({
    markdown: [
      '"DISPLAY" is W\\#16\\#0025 \\(WORD\\), not 16\\#0026',
      'why \\*not\\*',
      '```st\nASSERT_EQ("DISPLAY", 16#0026);\n```',
      '`DISPLAY` was changed last by dosing.awl:30 `T QW 4` \\(OB 1, statement 15\\), in scan 1 at 10 ms',
    ].join('\n\n'),
    drawn: 'START ──┘',
    diagram: '/tmp/x.svg',
  });
  expect(failureOf({ ...RESULT, message: null, statement: 'a ``` b', said: null, more: [] }).markdown).toBe('failed\n\n````st\na ``` b\n````');
});

test('output that is no list of tests or no result is none', () => {
  for (const text of ['', 'null', '[]', '{"tests": 1}', '{']) {
    expect(placesOf(text)).toEqual([]);
    expect(resultsOf(text)).toBeUndefined();
  }
  expect(placesOf('{"tests": ["a: b", 1]}')).toEqual([{ name: 'a: b', test_file: null, line: null }]);
  const [place] = placesOf('{"tests": [], "places": [{"name": "a.test.st: b: c", "test_file": "a.test.st", "line": 3}]}');
  expect(place && shortName(place)).toBe('b: c');
});

test('every command of the manifest is registered, and every registered one is in the manifest', () => {
  const source = readFileSync(join(EXTENSION, 'src/extension.ts'), 'utf8');
  const registered = [...source.matchAll(/command\('(\w+)'/gu)].map(([, name]) => `sieben.${name}`).sort();
  const contributed = (MANIFEST.contributes['commands'] as { command: string }[]).map(({ command }) => command).sort();
  expect(registered).toEqual(contributed);
});

test('the problem matcher understands the lines of check', () => {
  const [matcher] = MANIFEST.contributes['problemMatchers'] as { pattern: { regexp: string } }[];
  const pattern = new RegExp(matcher?.pattern.regexp ?? '', 'u');
  expect(pattern.exec('line 4/a.awl:3:5: error[P2001]: `X`: is none')?.slice(1)).toEqual(['line 4/a.awl', '3', '5', 'error', 'P2001', '`X`: is none']);
  expect(pattern.exec('C:\\x\\a.awl:3:5: warning[P4022]: it')?.[1]).toBe('C:\\x\\a.awl');
  expect(pattern.test('1 block in 1 source, no errors, no warnings.')).toBe(false);
});

test('the words of the languages have umlauts and no quotation marks', () => {
  for (const { configuration } of MANIFEST.contributes['languages'] as { configuration: string }[]) {
    const { wordPattern } = JSON.parse(readFileSync(join(EXTENSION, configuration), 'utf8')) as { wordPattern: { pattern: string; flags: string } };
    const words = new RegExp(wordPattern.pattern, `g${wordPattern.flags}`);
    expect('U "Tür_1 offen" #größe'.match(words)).toEqual(['U', 'Tür_1', 'offen', 'größe']);
  }
});

test('snippets, folding marks and pages of the walkthrough can be read', () => {
  for (const { path } of MANIFEST.contributes['snippets'] as { path: string }[]) {
    const snippets = Object.values(JSON.parse(readFileSync(join(EXTENSION, path), 'utf8')) as Record<string, { body: string[]; description: string }>);
    expect(snippets.length).toBeGreaterThan(4);
    for (const { body, description } of snippets) expect([Array.isArray(body), description.length > 0]).toEqual([true, true]);
  }
  for (const { configuration } of MANIFEST.contributes['languages'] as { configuration: string }[]) {
    const { folding } = JSON.parse(readFileSync(join(EXTENSION, configuration), 'utf8')) as { folding: { markers: { start: string; end: string } } };
    expect([new RegExp(folding.markers.start, 'u').test('nothing'), new RegExp(folding.markers.end, 'u').test('nothing')]).toEqual([false, false]);
  }
  const [walkthrough] = MANIFEST.contributes['walkthroughs'] as { steps: { media: { markdown: string } }[] }[];
  for (const { media } of walkthrough?.steps ?? []) expect(existsSync(join(EXTENSION, media.markdown)), media.markdown).toBe(true);
});
