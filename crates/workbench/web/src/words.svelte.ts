/** Every word of the page in its two languages: one table; those of what comes on demand are in `words.ts` of its folder. */
import type { Language } from './wire';

export const WORDS = {
  // views and shell
  live: ['Live', 'Live'],
  program: ['Program', 'Programm'],
  watch: ['Watch', 'Variablen'],
  symbols: ['Symbols', 'Symbole'],
  cpu: ['CPU', 'CPU'],
  help: ['Help', 'Hilfe'],
  views: ['Views', 'Ansichten'],
  operatingMode: ['Operating mode', 'Betriebszustand'],
  mresTitle: ['Memory reset: only in STOP', 'Urlöschen: nur in STOP'],
  step: ['Step', 'Schritt'],
  scanBack: ['One scan back', 'Ein Zyklus zurück'],
  scanOn: ['One scan on', 'Ein Zyklus weiter'],
  statementBack: ['One statement back', 'Eine Anweisung zurück'],
  statementOn: ['One statement on', 'Eine Anweisung weiter'],
  networkOn: ['One network on', 'Ein Netzwerk weiter'],
  pause: ['Pause', 'Pause'],
  goOn: ['Go on', 'Weiter'],
  pauseTitle: ['Pause or go on (Space)', 'Anhalten oder weiter (Leertaste)'],
  statement: ['Statement', 'Anweisung'],
  network: ['Network', 'Netzwerk'],
  scan: ['Scan', 'Zyklus'],
  stepUnit: ['What a step is', 'Was ein Schritt ist'],
  speed: ['Speed of time', 'Geschwindigkeit der Zeit'],
  find: ['Find', 'Suchen'],
  share: ['Share link', 'Link teilen'],
  shared: ['The link is in the clipboard.', 'Der Link ist in der Zwischenablage.'],
  mnemonicsEn: ['Mnemonics: English', 'Befehle: Englisch'],
  mnemonicsDe: ['Mnemonics: German', 'Befehle: Deutsch'],
  theme: ['Theme: light, dark, high contrast', 'Farben: hell, dunkel, hoher Kontrast'],
  projectMenu: ['Project', 'Projekt'],
  ledsOfCpu: ['LEDs of the CPU', 'LEDs der CPU'],
  on: ['on', 'an'],
  off: ['off', 'aus'],
  flashing: ['flashing', 'blinkt'],
  cycle: ['cycle', 'Zyklus'],
  max: ['max', 'max.'],
  connLive: ['Live', 'Live'],
  connPaused: ['Paused', 'Angehalten'],
  connPast: ['Past', 'Vergangenheit'],
  connOffline: ['Offline', 'Getrennt'],
  connView: ['View only', 'Nur ansehen'],
  connWaiting: ['Connecting', 'Verbinden'],
  ago: ['{0} s ago.', 'Vor {0} s.'],
  goesOn: ['The CPU goes on', 'Die CPU läuft weiter'],
  stands: ['The CPU is paused', 'Die CPU ist angehalten'],
  backToLive: ['Back to live', 'Zurück zu Live'],
  inStop: ['The CPU is in STOP', 'Die CPU ist in STOP'],
  outputsOff: ['Outputs are off.', 'Die Ausgänge sind aus.'],
  since: ['since scan {0}', 'seit Zyklus {0}'],
  diagnostics: ['Diagnostics', 'Diagnose'],
  backAgain: ['Connected again: there was no connection for {0} s.', 'Wieder verbunden: {0} s ohne Verbindung.'],
  longScan: ['One scan has been running for {0} s.', 'Ein Zyklus läuft schon {0} s.'],
  longValues: ['These are the values of scan {0}, before it.', 'Das sind die Werte von Zyklus {0}, davor.'],
  noAnswer: ['The CPU has not answered for {0} s: it starts, or a scan takes long.', 'Die CPU antwortet seit {0} s nicht: sie läuft an, oder ein Zyklus dauert lang.'],
  staleValue: ['older than 2 s', 'älter als 2 s'],
  inStartup: ['The CPU starts: OB 100 runs.', 'Die CPU läuft an: OB 100 wird bearbeitet.'],
  noConnection: ['No connection for {0} s.', 'Keine Verbindung seit {0} s.'],
  lastValues: ['These are the values of scan {0}; the CPU may have gone on.', 'Das sind die Werte von Zyklus {0}; die CPU kann weitergelaufen sein.'],
  tryNow: ['Try now', 'Jetzt versuchen'],
  stepping: ['Stepping:', 'Schrittweise:'],
  hasRun: ['line {0} of {1} has run', 'Zeile {0} von {1} ist ausgeführt'],
  scanShown: ['Scan shown', 'Gezeigter Zyklus'],
  seconds: ['seconds', 'Sekunden'],
  beforeStart: ['before the start', 'vor dem Start'],
  now: ['now', 'jetzt'],
  scansAgo: ['{0} scans ago', 'vor {0} Zyklen'],
  scanAgo: ['1 scan ago', 'vor einem Zyklus'],
  scanAt: ['Scan {0} at {1} s', 'Zyklus {0} bei {1} s'],
  inThePast: [', in the past', ', in der Vergangenheit'],
  isLive: [', live', ', live'],
  close: ['Close', 'Schließen'],
  cancel: ['Cancel', 'Abbrechen'],
  askMres: ['Clients that are connected: {0}. Reset the memory of the CPU all the same? All values are lost; the program is loaded again.', 'Verbundene Clients: {0}. CPU trotzdem urlöschen? Alle Werte gehen verloren; das Programm wird neu geladen.'],
  askStop: ['Clients that are connected: {0}. Stop the CPU all the same?', 'Verbundene Clients: {0}. CPU trotzdem stoppen?'],
  // why writing is off
  offPast: ['The page shows the past: go back to live to write', 'Die Seite zeigt die Vergangenheit: zum Schreiben zurück zu Live'],
  offOffline: ['No connection to the CPU', 'Keine Verbindung zur CPU'],
  offView: ['View only: this page may not write', 'Nur ansehen: diese Seite darf nicht schreiben'],
  offStartup: ['The CPU starts', 'Die CPU läuft an'],
  // live
  plant: ['Plant', 'Anlage'],
  noPlant: ['This project has no simulated plant. Add a [[module]] to sieben.toml, or switch its inputs on the rack.', 'Dieses Projekt hat keine simulierte Anlage. Ein [[module]] in sieben.toml ergänzen oder die Eingänge an der Baugruppe schalten.'],
  fault: ['Fault', 'Fehler'],
  faultTitle: ['Let a part of the plant fail', 'Einen Teil der Anlage ausfallen lassen'],
  rack: ['I/O rack', 'E/A-Baugruppen'],
  rackHint: ['click = input', 'Klick = Eingang'],
  noRack: ['No input or output has a symbol, and no plant has terminals. Give an input a symbol, and it is here.', 'Kein Ein- oder Ausgang hat ein Symbol, und keine Anlage hat Klemmen. Ein Eingang mit Symbol steht hier.'],
  driven: ['driven by the plant', 'von der Anlage'],
  free: ['free', 'frei'],
  writeNumber: ['Write a whole number: `25`.', 'Eine ganze Zahl schreiben: `25`.'],
  writeHex: ['Write hexadecimal digits: `0025`.', 'Hexadezimale Ziffern schreiben: `0025`.'],
  press: ['press', 'Taste'],
  pressOf: ['Press {0}', '{0} drücken'],
  normallyClosed: ['normally closed: 1 while not pressed', 'Öffner: 1, solange nicht gedrückt'],
  language: ['Language of the view', 'Darstellung'],
  columns: ['Status columns', 'Statusspalten'],
  line: ['Line', 'Zeile'],
  symbol: ['Symbol', 'Symbol'],
  statementsWithStatus: ['Statements with status', 'Anweisungen mit Status'],
  notExecuted: ['not executed', 'nicht ausgeführt'],
  why: ['Why', 'Warum'],
  noSelection: ['Select a statement, a contact or a lamp.', 'Eine Anweisung, einen Kontakt oder eine Lampe auswählen.'],
  whoWrote: ['Who wrote {0}?', 'Wer schrieb {0}?'],
  whereUsed: ['Where used', 'Verwendung'],
  statusWord: ['Status word', 'Statuswort'],
  afterThis: ['after this statement', 'nach dieser Anweisung'],
  registers: ['Registers', 'Register'],
  about: ['About {0}', 'Zu {0}'],
  whatChanged: ['What changed', 'Was sich änderte'],
  newestFirst: ['newest first', 'Neuestes zuerst'],
  nothingYet: ['Nothing has changed yet.', 'Noch hat sich nichts geändert.'],
  placeLine: ['line {0}', 'Zeile {0}'],
  placeNetwork: ['network {0}', 'Netzwerk {0}'],
  // the sentence
  became: ['became {0}', 'wurde {0}'],
  counted: ['counted {0} {1} → {2}', 'zählte {0} {1} → {2}'],
  down: ['down', 'abwärts'],
  up: ['up', 'aufwärts'],
  so: [', so ', ', darum '],
  and: [' and ', ' und '],
  comma: [', ', ', '],
  andMore: [' and {0} more', ' und {0} weitere'],
  // plants
  kind_conveyor: ['Conveyor', 'Förderband'],
  kind_dosing: ['Dosing plant', 'Dosieranlage'],
  kind_elevator: ['Elevator', 'Aufzug'],
  kind_junction: ['Junction', 'Kreuzung'],
  kind_motor: ['Motor', 'Motor'],
  kind_tank: ['Tank', 'Behälter'],
  kind_thermal: ['Heater', 'Heizung'],
  kind_panel: ['Training panel', 'Schaltbrett'],
  // program
  blocks: ['Blocks', 'Bausteine'],
  everyScan: ['Called every scan', 'In jedem Zyklus'],
  atRestart: ['At a restart', 'Bei einem Anlauf'],
  atInterrupt: ['At interrupts', 'Bei Alarmen'],
  atError: ['At errors', 'Bei Fehlern'],
  data: ['Data', 'Daten'],
  notCalled: ['Not called', 'Nicht aufgerufen'],
  instance: ['Whose data is shown', 'Wessen Daten gezeigt werden'],
  loaded: ['loaded', 'geladen'],
  sideBySide: ['Side by side', 'Nebeneinander'],
  sideTitle: ['STL, LAD and FBD of the selected network', 'AWL, KOP und FUP des gewählten Netzwerks'],
  textOnly: ['Structured Text has no ladder and no function blocks', 'Strukturierter Text hat weder KOP noch FUP'],
  staysStl: ['stays STL', 'bleibt AWL'],
  staysAsStl: ['Stays STL:', 'Bleibt AWL:'],
  statements: ['{0} statements', '{0} Anweisungen'],
  statement1: ['1 statement', '1 Anweisung'],
  stl: ['STL', 'AWL'],
  lad: ['LAD', 'KOP'],
  fbd: ['FBD', 'FUP'],
  powerHere: ['Power here', 'Strom hier'],
  arrives: ['arrives from the left', 'kommt von links an'],
  leaves: ['goes on to the right', 'geht nach rechts weiter'],
  inNetwork: ['In this network', 'In diesem Netzwerk'],
  elements: ['Elements of the diagram', 'Elemente des Plans'],
  contact: ['contact', 'Kontakt'],
  coil: ['coil', 'Spule'],
  powerOn: ['power goes on', 'Strom fließt weiter'],
  powerOff: ['no power goes on', 'kein Strom fließt weiter'],
  noOb1: ['There is no OB 1, so nothing runs in the cycle. Write the cyclic program as OB 1; what there is stands under Program.', 'Es gibt keinen OB 1, darum läuft nichts im Zyklus. Das zyklische Programm als OB 1 schreiben; was da ist, steht unter Programm.'],
  dataBlock: ['A data block has no statements: see its values in Watch.', 'Ein Datenbaustein hat keine Anweisungen: seine Werte stehen unter Variablen.'],
  expand: ['Show or hide network {0}', 'Netzwerk {0} zeigen oder verbergen'],
  allKeys: ['all keys', 'alle Tasten'],
  // watch
  address: ['Address', 'Adresse'],
  value: ['Value', 'Wert'],
  comment: ['Comment', 'Kommentar'],
  newValueOf: ['New value of {0}', 'Steuerwert von {0}'],
  forceOf: ['Force {0}', '{0} forcen'],
  forced: ['forced', 'geforct'],
  terminal: ['Terminal has', 'Klemme hat'],
  forceInput: ['The program reads this value, whatever the terminal has. What the plant and other pages set does not count.', 'Das Programm liest diesen Wert, was auch immer die Klemme hat. Was Anlage und andere Seiten setzen, zählt nicht.'],
  forceOutput: ['The terminal has this value, whatever the program writes.', 'Die Klemme hat diesen Wert, was auch immer das Programm schreibt.'],
  forceMemory: ['The program reads this value, whatever it writes.', 'Das Programm liest diesen Wert, was auch immer es schreibt.'],
  forces300: ['A CPU {0} forces inputs and outputs only.', 'Eine CPU {0} forct nur Ein- und Ausgänge.'],
  forces400: ['A CPU {0} forces inputs, outputs and bit memory only.', 'Eine CPU {0} forct nur Ein- und Ausgänge und Merker.'],
  forceLasts: ['Forcing lasts until it is released, also without this page.', 'Forcen dauert, bis es gelöst wird, auch ohne diese Seite.'],
  reason: ['Reason', 'Grund'],
  reasonHint: ['Kept, and shown to everybody', 'Wird aufbewahrt und allen gezeigt'],
  forceIt: ['Force {0}', '{0} forcen'],
  zoom: ['Zoom', 'Zoom'],
  cursorScan: ['scan {0}', 'Zyklus {0}'],
  // symbols
  memory: ['Memory, timers, counters', 'Merker, Zeiten, Zähler'],
  current: ['Now', 'Jetzt'],
  // cpu
  event: ['Event', 'Ereignis'],
  from: ['From', 'Von'],
  nBytesMore: ['… and {0} more bytes', '… und {0} weitere Bytes'],
  // palette and keys
  palette: ['Find a view, a block, a symbol, a command', 'Ansicht, Baustein, Symbol, Befehl suchen'],
  nothingFound: ['Nothing has this name.', 'Nichts heißt so.'],
  view: ['view', 'Ansicht'],
  block: ['block', 'Baustein'],
  command: ['command', 'Befehl'],
  keys: ['Keys', 'Tasten'],
  kTime: ['Time', 'Zeit'],
  kPages: ['Views', 'Ansichten'],
  kSelection: ['Selection', 'Auswahl'],
  kStatement: ['statement on, back', 'Anweisung weiter, zurück'],
  kScan: ['scan on, back', 'Zyklus weiter, zurück'],
  kNetwork: ['network on, back', 'Netzwerk weiter, zurück'],
  kPause: ['pause, go on', 'anhalten, weiter'],
  kLive: ['live', 'Live'],
  kOldest: ['oldest scan', 'ältester Zyklus'],
  kPalette: ['find', 'suchen'],
  kPanel: ['next panel, panel before', 'nächstes Feld, Feld davor'],
  kToggle: ['toggle the selected input', 'gewählten Eingang umschalten'],
  kWatch: ['add to the watch table', 'in die Variablentabelle'],
  kForce: ['force…', 'forcen…'],
  kMnemonics: ['mnemonics EN/DE', 'Befehle EN/DE'],
  kUsed: ['where used', 'Verwendung'],
  kDefinition: ['definition', 'Definition'],
  kHelp: ['help on the selection', 'Hilfe zur Auswahl'],
  kTimeline: ['on the timeline: scan back, on', 'auf der Zeitleiste: Zyklus zurück, weiter'],
  kHundred: ['on the timeline: 100 scans on, back', 'auf der Zeitleiste: 100 Zyklen weiter, zurück'],
  kRow: ['in lists, tables, diagrams: before, next', 'in Listen, Tabellen, Plänen: davor, danach'],
  kRemove: ['remove a row that was added', 'hinzugefügte Zeile entfernen'],
  kModify: ['modify values', 'Werte steuern'],
  selectInput: ['Select a statement with an input to switch it.', 'Eine Anweisung mit einem Eingang auswählen, um ihn umzuschalten.'],
  selectOperand: ['Select a statement with an operand.', 'Eine Anweisung mit Operand auswählen.'],
  added: ['{0} is in the watch table.', '{0} steht in der Variablentabelle.'],
  noToken: ['This page needs its token', 'Diese Seite braucht ihr Token'],
  needsToken: ['Open the address with `?token=` that was printed when the run began. The tokens also stand in `.sieben/page-tokens` of the project, or in the file that `tokens` of `[servers.page]` names.', 'Die Adresse mit `?token=` öffnen, die beim Start ausgegeben wurde. Die Token stehen auch in `.sieben/page-tokens` des Projekts oder in der Datei, die `tokens` in `[servers.page]` nennt.'],
  changeTheme: ['Change the theme', 'Farben wechseln'],
  changeLanguage: ['Deutsch', 'English'],
  changeMnemonics: ['Change the mnemonics', 'Befehle umschalten'],
  notSaved: ['It could not be done: {0}', 'Es ging nicht: {0}'],
} as const satisfies Record<string, readonly [string, string]>;

export type Word = keyof typeof WORDS;

class Speech {
  lang = $state<Language>('en');
}
export const speech = new Speech();

/** `?lang=` wins, then what was chosen before, then the browser. */
export function chooseLanguage(): Language {
  const asked = new URLSearchParams(location.search).get('lang') ?? localStorage.getItem('lang') ?? navigator.languages[0] ?? 'en';
  speech.lang = asked.toLowerCase().startsWith('de') ? 'de' : 'en';
  document.documentElement.lang = speech.lang;
  return speech.lang;
}

export function setLanguage(lang: Language): void {
  speech.lang = lang;
  document.documentElement.lang = lang;
  localStorage.setItem('lang', lang);
}

type Pair = readonly [string, string];
/** Words of a table in the language of the page, with `{0}`, `{1}` … filled. */
export const spoken =
  <W extends string>(table: Record<W, Pair>) =>
  (word: W, ...parts: (string | number)[]): string => {
    const text = table[word][speech.lang === 'de' ? 1 : 0];
    return parts.length === 0 ? text : text.replace(/\{(\d)\}/g, (_, i: string) => String(parts[Number(i)] ?? ''));
  };

/** The word in the language of the page. */
export const t = spoken<Word>(WORDS);

/** 1,234 or 1.234. */
export function count(n: number | undefined): string {
  return n === undefined ? '–' : n.toLocaleString(speech.lang === 'de' ? 'de-DE' : 'en-GB');
}

/** Seconds of microseconds, two decimals. */
export function seconds(us: number): string {
  return (us / 1e6).toLocaleString(speech.lang === 'de' ? 'de-DE' : 'en-GB', { minimumFractionDigits: 2, maximumFractionDigits: 2, useGrouping: false });
}

export function milliseconds(us: number): string {
  return us < 1000 ? `${Math.round(us)} µs` : `${(us / 1000).toLocaleString(speech.lang === 'de' ? 'de-DE' : 'en-GB', { minimumFractionDigits: us < 100_000 ? 1 : 0, maximumFractionDigits: us < 100_000 ? 1 : 0 })} ms`;
}

/** A word that may not be there. */
export function maybe(word: string, otherwise: string): string {
  return word in WORDS ? t(word as Word) : otherwise;
}

