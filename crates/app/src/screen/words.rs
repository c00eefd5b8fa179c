//! All words that the screen says by itself, in English and German.

use sieben_workspace::session::texts::Text;

/// Heads of the panels.
pub(super) const PLANT: Text = ["Plant", "Anlage"];
pub(super) const INPUTS: Text = ["Inputs", "Eingänge"];
pub(super) const OUTPUTS: Text = ["Outputs", "Ausgänge"];
pub(super) const VALUES: Text = ["Timers, counters, words", "Zeiten, Zähler, Wörter"];
pub(super) const CHANGES: Text = ["What changed", "Was sich änderte"];
pub(super) const DIAGNOSTICS: Text = ["Diagnostic buffer", "Diagnosepuffer"];
pub(super) const RUN: Text = ["Run", "Lauf"];
pub(super) const CLIENTS: Text = ["Clients", "Clients"];

/// The header.
pub(super) const PAUSED: Text = ["paused", "angehalten"];
pub(super) const AUTO: Text = ["auto", "auto"];

/// The program.
pub(super) const RLO: Text = ["RLO", "VKE"];
pub(super) const ACCU: Text = ["ACCU 1", "AKKU 1"];
pub(super) const VALUE: Text = ["value", "Wert"];
pub(super) const NETWORK: Text = ["network", "Netzwerk"];
pub(super) const NO_LISTING: Text = ["no block is listed", "kein Baustein ist aufgelistet"];
pub(super) const NOT_THE_SAME: Text = ["replayed differently", "anders nachgespielt"];

/// The run.
pub(super) const CYCLE: Text = ["cycle", "Zykluszeit"];
pub(super) const SHORTEST: Text = ["shortest", "kürzeste"];
pub(super) const LONGEST: Text = ["longest", "längste"];
pub(super) const AT_MOST: Text = ["longest", "max."];
pub(super) const EXECUTION: Text = ["program", "Programm"];
pub(super) const SCANS: Text = ["scans", "Zyklen"];
pub(super) const SCAN: Text = ["scan", "Zyklus"];
pub(super) const CLOCK: Text = ["clock", "Uhr"];
pub(super) const FORCED: Text = ["forced", "geforct"];
pub(super) const CONNECTED: Text = ["connected", "verbunden"];
pub(super) const NOTHING: Text = ["nothing", "nichts"];

/// Lists without anything in them.
pub(super) const NONE: Text = ["none", "keine"];

/// A terminal that is too small: the least size, then its own.
pub(super) const TOO_SMALL: Text = [
    "This screen needs {0} × {1} characters; the terminal has {2} × {3}. Enlarge it, or press q to quit.",
    "Diese Anzeige braucht {0} × {1} Zeichen; das Terminal hat {2} × {3}. Vergrößern, oder q beendet.",
];

/// Answers to keys.
pub(super) const DRIVEN: Text =
    ["{0} is driven by the plant `{1}`; hold it with a fault: f", "{0} gibt die Anlage `{1}` vor; mit einem Fehler festhalten: f"];
pub(super) const OUTPUT: Text = ["{0} is written by the program in every scan", "{0} schreibt das Programm in jedem Zyklus"];
pub(super) const NOT_A_BIT: Text = ["{0} is no bit; e sets its value", "{0} ist kein Bit; e setzt den Wert"];
pub(super) const NOTHING_SELECTED: Text = ["there is nothing to choose here", "hier gibt es nichts zu wählen"];
pub(super) const NO_INPUT: Text = ["there is no input {0} to operate", "es gibt keinen Eingang {0} zum Bedienen"];
pub(super) const NO_PLANT: Text = [
    "the project has no simulated plant whose signals could fail",
    "das Projekt hat keine simulierte Anlage, deren Signale ausfallen könnten",
];
pub(super) const NO_FORMATS: Text = ["{0} has no other format", "{0} hat kein anderes Format"];
pub(super) const SET: Text = ["{0} = {1}", "{0} = {1}"];
pub(super) const MRES_ASKED: Text =
    ["Reset all memory (MRES)? y yes, any other key no", "Alles urlöschen (MRES)? j ja, jede andere Taste nein"];
pub(super) const IS_RESET: Text = ["all memory is as after loading", "alles steht wie nach dem Laden"];
pub(super) const INJECTED: Text = ["{0}", "{0}"];
pub(super) const MENDED: Text = ["{0} is mended", "{0} ist behoben"];
pub(super) const NEW_VALUE: Text = ["New value of {0}, in any notation", "Neuer Wert von {0}, in jeder Schreibweise"];
pub(super) const IS_AUTO: Text = ["the demo presses START by itself", "die Demo drückt START von selbst"];
pub(super) const IS_MANUAL: Text = ["START is yours", "START gehört jetzt Ihnen"];

/// The frame of the demo's plant.
pub(super) const AUTO_IN: Text = ["auto: START in {0} s", "auto: START in {0} s"];

/// Lists to choose from.
pub(super) const FAULTS: Text = ["Faults: Enter injects or mends", "Fehler: Enter setzt oder behebt"];
pub(super) const MEND: Text = ["mend {0}", "beheben: {0}"];
pub(super) const BLOCKS: Text = ["Blocks: Enter shows one", "Bausteine: Enter zeigt einen"];
pub(super) const KEYS_HEAD: Text = ["Keys", "Tasten"];

/// The line of keys, shortened to what is used most; what has no room is left out from the end.
pub(super) const KEYS: [(&str, Text); 13] = [
    ("?", ["keys", "Tasten"]),
    ("q", ["quit", "Ende"]),
    ("␣", ["switch", "schalten"]),
    ("⏎", ["press", "drücken"]),
    ("e", ["set", "setzen"]),
    ("r s", ["RUN STOP", "RUN STOP"]),
    ("p", ["pause", "Pause"]),
    ("n", ["scan", "Zyklus"]),
    ("+ -", ["speed", "Tempo"]),
    ("f", ["fault", "Fehler"]),
    ("⇥", ["next", "weiter"]),
    ("b", ["block", "Baustein"]),
    ("x", ["format", "Format"]),
];
/// The pause key while time stands still.
pub(super) const GO_ON: Text = ["go on", "weiter"];
/// The demo's key.
pub(super) const AUTO_KEY: (&str, Text) = ("a", ["auto", "auto"]);

/// Keys of the help that have other names on a German keyboard.
pub(super) const GERMAN_KEYS: [(&str, &str); 2] = [("space", "Leertaste"), ("PgUp PgDn", "Bild↑ Bild↓")];

/// All keys, for the help.
pub(super) const HELP: &[(&str, Text)] = &[
    ("↑ ↓", ["choose an input, output or value", "Eingang, Ausgang oder Wert wählen"]),
    ("← →", ["go to the inputs, the outputs, the values", "zu den Eingängen, den Ausgängen, den Werten"]),
    ("space", ["switch the chosen bit, which stays so", "das gewählte Bit umschalten; es bleibt so"]),
    ("Enter", ["press it for 400 ms, like a push button", "400 ms lang drücken, wie einen Taster"]),
    ("1 … 9", ["the first nine inputs: buttons are pressed, others switched", "die ersten neun Eingänge: Taster drücken, andere schalten"]),
    ("e", ["type a value, in any notation", "einen Wert eingeben, in jeder Schreibweise"]),
    ("x", ["the next format of the chosen value", "das nächste Format des gewählten Werts"]),
    ("r s m", ["RUN, STOP, memory reset (it asks)", "RUN, STOP, Urlöschen (mit Rückfrage)"]),
    ("p n", ["time stands still or goes on; one scan", "die Zeit steht oder geht weiter; ein Zyklus"]),
    ("+ -", ["time goes faster, slower", "die Zeit geht schneller, langsamer"]),
    ("f", ["faults of the plant", "Fehler der Anlage"]),
    ("b", ["choose the block that is shown", "den gezeigten Baustein wählen"]),
    ("PgUp PgDn", ["move in the block", "im Baustein blättern"]),
    ("Tab", ["what the changing part of the screen shows", "was der wechselnde Teil der Anzeige zeigt"]),
    ("o", ["the next plant", "die nächste Anlage"]),
    ("q Esc", ["quit; the program ends with its own screen", "Ende; mit seiner eigenen Anzeige endet auch das Programm"]),
];
/// The demo's own key, for the help.
pub(super) const AUTO_HELP: (&str, Text) =
    ("a", ["the demo presses START by itself, or not", "die Demo drückt START von selbst oder nicht"]);
