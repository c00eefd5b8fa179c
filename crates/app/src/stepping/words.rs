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
    // The messages of the microscope are in its language already.
    failure::render(refusal, &refusal.message, colour, language)
}

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
