/** Words of the view Symbols in their two languages; they come with it. */
import { spoken, WORDS as COMMON } from '../words.svelte';

const WORDS = {
  callStructure: ['Call structure', 'Aufrufstruktur'],
  maxLocal: ['max. {0} of {1} bytes', 'max. {0} von {1} Byte'],
  library: ['library', 'Bibliothek'],
  assignment: ['Assignment', 'Belegung'],
  area: ['Area', 'Bereich'],
  symbolTable: ['Symbol table', 'Symboltabelle'],
  filter: ['Filter: name, address, comment', 'Filter: Name, Adresse, Kommentar'],
  filterName: ['Filter', 'Filter'],
  nOf: ['{0} of {1}', '{0} von {1}'],
  print: ['Print the assignment table', 'Zuordnungsliste drucken'],
  type: ['Type', 'Typ'],
  used: ['Used', 'Benutzt'],
  unused: ['unused', 'unbenutzt'],
  inputs: ['Inputs', 'Eingänge'],
  outputs: ['Outputs', 'Ausgänge'],
  nextToIt: ['Next to it in byte {0}', 'Daneben in Byte {0}'],
  notUsed: ['not used', 'nicht benutzt'],
  noUse: ['It is used nowhere.', 'Es wird nirgends benutzt.'],
  noIndirect: ['Nothing reaches {0} by a pointer: no indirect access in this project.', 'Nichts erreicht {0} über einen Zeiger: kein indirekter Zugriff in diesem Projekt.'],
  someIndirect: ['Indirect access in this project may reach it too.', 'Indirekte Zugriffe in diesem Projekt können es auch erreichen.'],
  selectSymbol: ['Select a symbol to see where it is used.', 'Ein Symbol auswählen, um seine Verwendung zu sehen.'],
  assignmentTable: ['Assignment table', 'Zuordnungsliste'],
} as const satisfies Record<string, readonly [string, string]>;

export type Word = keyof typeof WORDS | keyof typeof COMMON;

/** The word in the language of the page. */
export const t = spoken<Word>({ ...COMMON, ...WORDS });
