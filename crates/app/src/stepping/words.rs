//! What the screen of `sieben step` says by itself, in English and German: keys, why a movement ended, what was refused.

use sieben_sim::history::Halt;
use sieben_workspace::Refusal;
use sieben_workspace::session::Language;
use sieben_workspace::session::texts::{STOPPED, Text, pick};

use crate::failure;

/// Why a movement ended, for the screen, if it did not simply come to where it was to go.
pub(crate) fn halt(halt: &Halt, language: Language) -> &'static str {
    let words = match halt {
        Halt::Reached | Halt::Watch => ["", ""],
        Halt::ScanEnd => ["the scan is over", "der Zyklus ist zu Ende"],
        Halt::Limit => ["stopped after 1,000,000 statements; run on with r", "nach 1.000.000 Anweisungen angehalten; weiter mit r"],
        Halt::Stopped => STOPPED,
        Halt::NoMoreScans => ["there are no more scans (--scans)", "es gibt keine Zyklen mehr (--scans)"],
        Halt::Beginning => ["this is the beginning of the run", "hier beginnt der Lauf"],
        Halt::Forgotten => ["what was before is no longer kept", "was davor war, ist nicht mehr aufgehoben"],
    };
    pick(language, words)
}

/// A command that could not be carried out, as people read it.
pub(crate) fn refused(refusal: &Refusal, colour: bool, language: Language) -> String {
    let german = HELP_GERMAN.iter().find(|(code, _)| *code == refusal.problem.code());
    let help = match language {
        Language::German => german.map_or(refusal.problem.help(), |(_, help)| help),
        Language::English => refusal.problem.help(),
    };
    failure::render(refusal, colour, pick(language, ERROR), pick(language, HELP_WORD), help)
}

const ERROR: Text = ["Error", "Fehler"];
const HELP_WORD: Text = ["Help", "Hilfe"];

/// What to do about a problem, in German; in English the table of problems says it.
const HELP_GERMAN: [(&str, &str); 8] = [
    ("P7003", "Eine Adresse, ein Symbol, `DB1.name`, `#name` oder ein Register angeben."),
    ("P7004", "Einen Wert angeben, der zu dem Namen passt: `I0.0=1`, `MW10=W#16#00FF`."),
    ("P7040", "`help` zeigt die Befehle."),
    ("P7041", "So geht es: `FC 1:3` (die dritte Anweisung), `FC 1:marke` oder `main.awl:12` (eine Zeile)."),
    ("P7113", "In der Quelle ändern und neu übersetzen, oder als Variable deklarieren."),
    ("P7125", "Nach dem Doppelpunkt steht ein Format: `MW10:INT`; `sieben explain formats` zeigt alle."),
    ("P7126", "Ein Format für so viele Bits wählen, wie der Wert hat; `sieben explain formats` zeigt alle."),
    ("P7042", "Ein Name, eines von =, <>, >, >=, <, <= und ein Wert: `MW10 > 5`."),
];

/// The line of keys, shortened to what is used most.
pub(crate) const KEYS: [(&str, Text); 8] = [
    ("s", ["step", "Schritt"]),
    ("S", ["back", "zurück"]),
    ("n", ["network", "Netzwerk"]),
    ("c", ["scan", "Zyklus"]),
    ("r", ["run", "Lauf"]),
    ("␣", ["break", "Halt"]),
    ("h", ["help", "Hilfe"]),
    ("q", ["quit", "Ende"]),
];

/// All keys, for the help.
pub(crate) const HELP: &[(&str, Text)] = &[
    ("s i o u", ["step one statement, into the library, over a call, out", "eine Anweisung, in die Bibliothek, über einen Aufruf, hinaus"]),
    ("n b c", ["step to the next network, block, scan", "zum nächsten Netzwerk, Baustein, Zyklus"]),
    ("S I O U N B C", ["the same steps back", "dieselben Schritte zurück"]),
    ("r R", ["run to a breakpoint, run back to one", "bis zu einem Haltepunkt, zurück zu einem"]),
    ("↑ ↓ PgUp PgDn", ["move the cursor", "Schreibmarke bewegen"]),
    ("g", ["run to the line of the cursor", "bis zur Zeile der Schreibmarke"]),
    ("space", ["breakpoint here; among the bits: switch the bit", "Haltepunkt hier; bei den Bits: Bit umschalten"]),
    ("⇥", ["between source and bits; ← → choose a bit", "zwischen Quelle und Bits; ← → wählen ein Bit"]),
    ("v", ["bits, or the variables of the block", "Bits oder die Variablen des Bausteins"]),
    ("d", ["the network as a diagram, as ladder, FBD or not", "das Netzwerk als Plan: KOP, FUP oder keiner"]),
    ("x", ["registers bit by bit, POINTER and ANY field by field", "Register Bit für Bit, POINTER und ANY Feld für Feld"]),
    ("w p f", ["watch a value, print one, find who changed one", "Wert beobachten, zeigen, finden, wer ihn änderte"]),
    (":", ["any command of `sieben step --commands`", "jeder Befehl von `sieben step --commands`"]),
    ("l", ["German", "Englisch"]),
    ("q", ["quit", "Ende"]),
];
