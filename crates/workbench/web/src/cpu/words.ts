/** Words of the CPU view in their two languages; they come with it. */
import { spoken, WORDS as COMMON } from '../words.svelte';

const WORDS = {
  buffer: ['Diagnostic buffer', 'Diagnosepuffer'],
  bufferSub: ['{0} of at most 100 events, newest first', '{0} von höchstens 100 Ereignissen, Neuestes zuerst'],
  saveText: ['Save as text', 'Als Text sichern'],
  events: ['Events', 'Ereignisse'],
  whyStopped: ['Why the CPU stopped', 'Warum die CPU steht'],
  openPlace: ['Open {0}, line {1}', '{0}, Zeile {1} öffnen'],
  showScan: ['Show this scan', 'Diesen Zyklus zeigen'],
  noEvents: ['The diagnostic buffer is empty.', 'Der Diagnosepuffer ist leer.'],
  connections: ['Connections', 'Verbindungen'],
  servers: ['servers: {0}', 'Server: {0}'],
  client: ['Client', 'Client'],
  protocol: ['Protocol', 'Protokoll'],
  reads: ['Read / s', 'Gelesen/s'],
  written: ['Written', 'Geschrieben'],
  lastWrite: ['Last write', 'Letztes Schreiben'],
  cycleTab: ['Cycle', 'Zyklus'],
  memoryTab: ['Memory', 'Speicher'],
  timeTab: ['Time', 'Uhrzeit'],
  moduleInfo: ['Module information', 'Baugruppenzustand'],
  mean: ['mean', 'Mittel'],
  longest: ['longest', 'längster'],
  ofProgram: ['of it program', 'davon Programm'],
  histogram: ['Histogram of the cycle time', 'Histogramm der Zykluszeit'],
  workMemory: ['Work memory', 'Arbeitsspeicher'],
  ofBytes: ['{0} of {1} bytes', '{0} von {1} Byte'],
  localData: ['Local data', 'Lokaldaten'],
  stacksAtStop: ['Stacks at the STOP', 'Stacks beim STOP'],
  blocksThatRan: ['Blocks', 'Bausteine'],
  openedBlocks: ['Data blocks', 'Datenbausteine'],
  noLocalData: ['none', 'keine'],
  cpuTime: ['Time of the CPU', 'Zeit der CPU'],
  scans: ['Scans', 'Zyklen'],
  setCycle: ['Cycle of the scan', 'Takt des Zyklus'],
  code: ['Code', 'Kennung'],
  when: ['When', 'Wann'],
  place: ['Place', 'Stelle'],
  details: ['Details', 'Einzelheiten'],
} as const satisfies Record<string, readonly [string, string]>;

export type Word = keyof typeof WORDS | keyof typeof COMMON;

/** The word in the language of the page. */
export const t = spoken<Word>({ ...COMMON, ...WORDS });
