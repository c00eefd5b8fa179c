//! Everything that `sieben step` says by itself, in English and German: headings, answers, errors of commands.
//!
//! A text with `{0}`, `{1}` has values put there by [`fill`]. The reasons of statements are a table of their own, in `lang::reason`.

pub use sieben_model::language::{Text, fill, pick};

// The table of statements.

pub(crate) const HEAD: Text = [
    "      pos  scan  place           RLO STA /FC OR CC OV OS BR  ACCU1        ACCU2        statement\n",
    "      Pos  Zykl  Stelle          VKE STA /ER OR A  OV OS BIE AKKU1        AKKU2        Anweisung\n",
];
pub(crate) const HEAD_OF_VARIABLES: Text = [
    "      pos  scan  place           statement                                     // variables after it\n",
    "      Pos  Zykl  Stelle          Anweisung                                     // Variablen danach\n",
];
pub(crate) const RUN_BEGINS: Text = ["the run begins", "der Lauf beginnt"];
pub(crate) const NEXT: Text = ["next: {0}:{1}: {2}", "weiter mit: {0}:{1}: {2}"];
pub(crate) const NEXT_SCAN: Text = ["next: scan {0} begins", "weiter mit: Zyklus {0} beginnt"];
pub(crate) const WHILE_STARTING: Text = ["while the CPU started", "während des Anlaufs"];
pub(crate) const IN_SCAN: Text = ["in scan {0}", "im Zyklus {0}"];
pub(crate) const END_OF_SCAN: Text = ["the end of scan {0}", "das Ende von Zyklus {0}"];
pub(crate) const NOT_YET: Text =
    ["it has not come there yet; the same command goes on", "so weit ist es noch nicht; derselbe Befehl geht weiter"];
/// The CPU does not run.
pub const STOPPED: Text = ["the CPU is in STOP", "die CPU ist in STOP"];
pub(crate) const ALL_SCANS: Text = ["all {0} scans have run", "alle {0} Zyklen sind gelaufen"];
pub(crate) const BEGINNING: Text = ["this is the beginning", "hier ist der Anfang"];
pub(crate) const FORGOTTEN: Text = [
    "what lies further back is no longer kept; the history begins after statement {0}",
    "was weiter zurückliegt, ist nicht mehr aufgehoben; die Aufzeichnung beginnt nach Anweisung {0}",
];
pub(crate) const IS_SET: Text = ["{0} is set to {1}", "{0} ist auf {1} gesetzt"];
pub(crate) const SEEN_LATER: Text = [", seen at the next cycle control point", ", zu sehen ab dem nächsten Zykluskontrollpunkt"];
pub(crate) const NOT_HERE: Text =
    ["no value here: {0} is not the block that runs", "hier ohne Wert: {0} ist nicht der Baustein, der läuft"];
pub(crate) const NOT_LOADED: Text = ["not loaded", "nicht geladen"];
pub(crate) const NOT_THERE: Text = ["not there", "nicht da"];

// What the CPU has to say.

pub(crate) const DIAGNOSTIC_BUFFER: Text = ["diagnostic buffer, newest entry first:", "Diagnosepuffer, der neueste Eintrag zuerst:"];
pub(crate) const NONE_FAILED: Text = ["no statement has failed", "keine Anweisung ist fehlgeschlagen"];
pub(crate) const FAILED_TIMES: Text = [
    "statements that failed while the program went on: {0}; {1}",
    "Anweisungen, die fehlschlugen, während das Programm weiterlief: {0}; {1}",
];

// Breakpoints.

pub(crate) const BREAKPOINT: Text = ["breakpoint {0}: {1}", "Haltepunkt {0}: {1}"];
pub(crate) const NO_BREAKPOINTS: Text = ["no breakpoints", "keine Haltepunkte"];
pub(crate) const BREAKPOINT_SEEN: Text = ["{0}: {1} (seen {2}×)", "{0}: {1} ({2}× gesehen)"];
pub(crate) const BETWEEN: Text = [", between two statements", ", zwischen zwei Anweisungen"];
pub(crate) const PAUSES_BEFORE: Text = ["pauses before {0}:{1}: {2}", "hält vor {0}:{1}: {2}"];
pub(crate) const MOVED: Text = ["no statement stands there; ", "dort steht keine Anweisung; "];
pub(crate) const PAUSES_WHEN_TRUE: Text = ["pauses when `{0}` becomes true", "hält, wenn `{0}` wahr wird"];
pub(crate) const PAUSES_WHEN_CHANGED: Text = ["pauses when `{0}` changes", "hält, wenn sich `{0}` ändert"];
pub(crate) const PAUSES_WHEN_WRITTEN: Text =
    ["pauses when `{0}` is written, even with the same value", "hält, wenn `{0}` geschrieben wird, auch mit demselben Wert"];

// Who did it.

pub(crate) const NOTHING_CHANGED: Text = ["nothing has changed `{0}` {1}", "nichts hat `{0}` geändert {1}"];
pub(crate) const SINCE_BEGINNING: Text = ["since the beginning", "seit dem Anfang"];
pub(crate) const SINCE_KEPT: Text =
    ["since statement {0}, where the kept history begins", "seit Anweisung {0}, wo die Aufzeichnung beginnt"];
pub(crate) const WROTE_LAST: Text = [
    "{0}:{1}: {2} ({3}) wrote it last, after statement {4} {5}: {6}",
    "{0}:{1}: {2} ({3}) hat es zuletzt geschrieben, nach Anweisung {4} {5}: {6}",
];
pub(crate) const CHANGED_BY: Text =
    ["{0}: {1} -> {2} after statement {3} {4}, by {5}", "{0}: {1} -> {2} nach Anweisung {3} {4}, durch {5}"];
pub(crate) const BY_IMAGE: Text =
    ["no statement: the process image of the inputs was read", "keine Anweisung: Das Prozessabbild der Eingänge wurde gelesen"];
pub(crate) const BY_SET: Text = ["no statement: it was set from outside", "keine Anweisung: Es wurde von außen gesetzt"];
pub(crate) const BY_CPU: Text = [
    "no statement: the CPU itself, as when it starts or a timer runs on",
    "keine Anweisung: die CPU selbst, etwa beim Anlauf oder weil eine Zeit weiterläuft",
];

// Commands.

pub(crate) const COMMAND_TOO_LONG: Text =
    ["a command has at most {0} bytes, this one has {1}", "ein Befehl hat höchstens {0} Bytes, dieser hat {1}"];
pub(crate) const NO_COMMAND: Text = ["`{0}` is no command; there are {1}", "`{0}` ist kein Befehl; es gibt {1}"];
pub(crate) const DID_YOU_MEAN: Text = ["did you mean `{0}`?", "war `{0}` gemeint?"];
pub(crate) const NOTHING_BEHIND: Text = ["`{0}` takes nothing behind it, not `{1}`", "hinter `{0}` steht nichts, auch nicht `{1}`"];
pub(crate) const SOMETHING_BEHIND: Text = ["`{0}` needs something behind it: {1}", "hinter `{0}` muss etwas stehen: {1}"];
pub(crate) const NO_POSITION: Text = [
    "`{0}` is no position; write how many statements of the run lie before it",
    "`{0}` ist keine Stelle; hier steht, wie viele Anweisungen des Laufs davor liegen",
];
pub(crate) const NO_COUNT: Text = [
    "`{0}` is no number of steps; write a whole number from 1 on",
    "`{0}` ist keine Anzahl von Schritten; hier steht eine ganze Zahl ab 1",
];
pub(crate) const NO_BREAKPOINT: Text = ["`{0}` is the number of no breakpoint; {1}", "`{0}` ist die Nummer keines Haltepunkts; {1}"];
pub(crate) const THERE_ARE_NONE: Text = ["there are none", "es gibt keine"];
pub(crate) const THERE_ARE: Text = ["there are {0}", "es gibt {0}"];
pub(crate) const BREAKPOINTS_FULL: Text = ["there are {0} breakpoints already; delete one", "es gibt schon {0} Haltepunkte; einen löschen"];
pub(crate) const WATCHED_FULL: Text = ["{0} values are shown already", "es werden schon {0} Werte gezeigt"];
pub(crate) const REGISTER_WRITTEN: Text = [
    "`{0}` is a register, which nearly every statement writes; `watch {0}` waits for a change",
    "`{0}` ist ein Register, das fast jede Anweisung schreibt; `watch {0}` wartet auf eine Änderung",
];
pub(crate) const NO_BLOCK_RUNS: Text =
    ["no block runs: the CPU is between two scans", "es läuft kein Baustein: Die CPU ist zwischen zwei Zyklen"];
/// Between two scans there are only variables that an instance keeps.
pub const NOTHING_KEPT: Text = [
    "no block runs, and the program keeps no variables between two scans",
    "es läuft kein Baustein, und zwischen zwei Zyklen behält das Programm keine Variablen",
];
pub(crate) const NO_VARIABLES: Text = ["{0} has no variables of its own", "{0} hat keine eigenen Variablen"];
/// The heading of the variables of a block.
pub const VARIABLES_OF: Text = ["variables of {0}", "Variablen von {0}"];
pub(crate) const NOTHING_RAN: Text = ["no statement has run", "es ist noch keine Anweisung gelaufen"];

// Places.

pub(crate) const END_OF_BLOCK: Text = ["end of the block", "Ende des Bausteins"];
pub(crate) const NO_PLACE: Text = [
    "`{0}` is no place; write `FC 1:3` (statement), `FC 1:label` or `file:line`",
    "`{0}` ist keine Stelle; so geht es: `FC 1:3` (Anweisung), `FC 1:marke` oder `datei:zeile`",
];
pub(crate) const NO_STATEMENTS: Text = ["the program has no statements", "das Programm hat keine Anweisungen"];
pub(crate) const COUNTED_FROM_ONE: Text = ["statements are counted from 1", "Anweisungen werden ab 1 gezählt"];
pub(crate) const NEITHER: Text =
    ["the program has neither a block nor a file `{0}`", "das Programm hat weder einen Baustein noch eine Datei `{0}`"];
pub(crate) const NO_LINE: Text =
    ["`{0}` is no line of `{1}`; lines are counted from 1", "`{0}` ist keine Zeile von `{1}`; Zeilen werden ab 1 gezählt"];
pub(crate) const STATEMENTS_OF: Text = ["`{0}` has {1} statements", "`{0}` hat {1} Anweisungen"];
pub(crate) const NO_LABEL: Text = ["`{0}` has no label `{1}`", "`{0}` hat keine Sprungmarke `{1}`"];
pub(crate) const NO_STATEMENT_FROM: Text = [
    "no statement stands in `{0}` from line {1} on; the last one is in line {2}",
    "in `{0}` steht ab Zeile {1} keine Anweisung mehr; die letzte steht in Zeile {2}",
];
