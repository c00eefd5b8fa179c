//! The words of the screen, in English and German.

use sieben_sim::history::Halt;

use crate::stepping::Language;

/// One of two words.
pub(super) fn pick(language: Language, [english, german]: [&'static str; 2]) -> &'static str {
    match language {
        Language::English => english,
        Language::German => german,
    }
}

/// Why a movement ended, if it did not simply come to where it was to go.
pub(super) fn halt(halt: &Halt, language: Language) -> &'static str {
    let words = match halt {
        Halt::Reached | Halt::Watch => ["", ""],
        Halt::ScanEnd => ["the scan is over", "der Zyklus ist zu Ende"],
        Halt::Limit => ["stopped after 1,000,000 statements; run on with r", "nach 1.000.000 Anweisungen angehalten; weiter mit r"],
        Halt::Stopped => ["the CPU is in STOP", "die CPU ist in STOP"],
        Halt::NoMoreScans => ["there are no more scans (--scans)", "es gibt keine Zyklen mehr (--scans)"],
        Halt::Beginning => ["this is the beginning of the run", "hier beginnt der Lauf"],
        Halt::Forgotten => ["what was before is no longer kept", "was davor war, ist nicht mehr aufgehoben"],
    };
    pick(language, words)
}

/// The line of keys, shortened to what is used most.
pub(super) const KEYS: [(&str, [&str; 2]); 8] = [
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
pub(super) const HELP: &[(&str, [&str; 2])] = &[
    ("s o u", ["step one statement, over a call, out of the block", "eine Anweisung, über einen Aufruf, aus dem Baustein"]),
    ("n b c", ["step to the next network, block, scan", "zum nächsten Netzwerk, Baustein, Zyklus"]),
    ("S O U N B C", ["the same steps back", "dieselben Schritte zurück"]),
    ("r R", ["run to a breakpoint, run back to one", "bis zu einem Haltepunkt, zurück zu einem"]),
    ("↑ ↓ PgUp PgDn", ["move the cursor", "Schreibmarke bewegen"]),
    ("g", ["run to the line of the cursor", "bis zur Zeile der Schreibmarke"]),
    ("space", ["breakpoint here; among the bits: switch the bit", "Haltepunkt hier; bei den Bits: Bit umschalten"]),
    ("⇥", ["between source and bits; ← → choose a bit", "zwischen Quelle und Bits; ← → wählen ein Bit"]),
    ("w p f", ["watch a value, print one, find who changed one", "Wert beobachten, zeigen, finden, wer ihn änderte"]),
    (":", ["any command of `sieben step --commands`", "jeder Befehl von `sieben step --commands`"]),
    ("l", ["German", "Englisch"]),
    ("q", ["quit", "Ende"]),
];
