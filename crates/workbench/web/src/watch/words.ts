/** Words of the watch table, of forcing and of the timing diagram in their two languages; they come with it. */
import { spoken, WORDS as COMMON } from '../words.svelte';

const WORDS = {
  watchTable: ['Watch table', 'Variablentabelle'],
  format: ['Format', 'Format'],
  newValue: ['New value', 'Steuerwert'],
  modify: ['Modify values', 'Werte steuern'],
  modifyN: ['Modify {0} values', '{0} Werte steuern'],
  modify1: ['Modify 1 value', '1 Wert steuern'],
  modifyTitle: ['Writes the ticked values once (Ctrl F9)', 'Schreibt die angekreuzten Werte einmal (Strg F9)'],
  writeOf: ['Write {0}', '{0} schreiben'],
  removeOf: ['Remove {0} from the table', '{0} aus der Tabelle entfernen'],
  removed: ['{0} is no longer in the watch table.', '{0} steht nicht mehr in der Variablentabelle.'],
  keyDelete: ['Delete', 'Entf'],
  saveTable: ['Save the table as a file', 'Tabelle als Datei sichern'],
  longName: ['The name is longer than 200 bytes: it has no value.', 'Der Name ist länger als 200 Byte: er hat keinen Wert.'],
  typeAddress: ['Type an address or a symbol', 'Adresse oder Symbol eingeben'],
  forcedValues: ['Forced values', 'Geforcte Werte'],
  releaseAll: ['Release all', 'Alle lösen'],
  release: ['Release', 'Lösen'],
  sees: ['Program sees', 'Programm sieht'],
  sinceWhen: ['Since', 'Seit'],
  by: ['By', 'Von'],
  because: ['Because', 'Weil'],
  sinceScan: ['{0}, scan {1}', '{0}, Zyklus {1}'],
  noForces: ['Nothing is forced. Force an input or output to hold its value against program and plant.', 'Nichts ist geforct. Ein Ein- oder Ausgang lässt sich gegen Programm und Anlage festhalten.'],
  addressOrSymbol: ['Address or symbol', 'Adresse oder Symbol'],
  addressToForce: ['Address to force', 'Zu forcende Adresse'],
  forceDots: ['Force…', 'Forcen…'],
  timing: ['Timing diagram', 'Zeitdiagramm'],
  noTrigger: ['no trigger', 'kein Trigger'],
  waitsFor: ['waits for {0}', 'wartet auf {0}'],
  triggered: ['triggered in scan {0}', 'ausgelöst in Zyklus {0}'],
  trigger: ['Trigger', 'Trigger'],
  triggerHint: ['Trigger: VALVE rises', 'Trigger: VALVE steigt'],
  badTrigger: ['Write a name and `rises`, `falls` or a comparison: `LITRES < 5`.', 'Einen Namen und `steigt`, `fällt` oder einen Vergleich schreiben: `LITRES < 5`.'],
  narrower: ['Show more time', 'Mehr Zeit zeigen'],
  wider: ['Show less time', 'Weniger Zeit zeigen'],
  exportAs: ['VCD, CSV, SVG', 'VCD, CSV, SVG'],
  cursor: ['Cursor', 'Cursor'],
  secondCursor: ['Second cursor', 'Zweiter Cursor'],
  between: ['Between', 'Dazwischen'],
  oneScan: ['1 scan', '1 Zyklus'],
  nScans: ['{0} scans', '{0} Zyklen'],
  showsCursor: ["The whole page shows the cursor's scan", 'Die ganze Seite zeigt den Zyklus des Cursors'],
  timingOf: ['Timing diagram of {0} signals', 'Zeitdiagramm von {0} Signalen'],
} as const satisfies Record<string, readonly [string, string]>;

export type Word = keyof typeof WORDS | keyof typeof COMMON;

/** The word in the language of the page. */
export const t = spoken<Word>({ ...COMMON, ...WORDS });
