//! The words that begin a line of form A.

use super::boxes::{BoxRow, CounterKind, TimerKind};
use super::flavour::Flavour;

/// Elements of a line other than boxes, as form A writes them.
pub const ELEMENTS: [&str; 12] = ["NO", "NC", "P", "N", "POS", "NEG", "NOT", "MID", "CMP", "OR", "AND", "XOR"];

/// Coils of STEP 7.
pub const COILS: [&str; 18] =
    ["COIL", "SET", "RESET", "SAVE", "JMP", "JMPN", "RET", "CC", "MCR<", "SP", "SE", "SD", "SS", "SF", "SC", "CU", "CD", "UC"];

/// Coils of IEC 61131-3.
pub const COILS_IEC: [&str; 8] = ["COIL", "PCOIL", "NCOIL", "SET", "RESET", "JMP", "JMPN", "RET"];

/// What stands alone, and what divides a network.
pub const OTHERS: [&str; 8] = ["LABEL", "BRANCH", "END", "TAP", "OPN", "MCRA", "MCRD", "MCR>"];

/// A word that begins a coil.
pub fn is_coil(word: &str, flavour: Flavour) -> bool {
    match flavour {
        Flavour::S7 => COILS.contains(&word) && word != "UC",
        Flavour::Iec => COILS_IEC.contains(&word),
    }
}

/// A word that begins a line of form A in diagrams of STEP 7.
pub fn begins_line(word: &str) -> bool {
    let plain = word.trim_start_matches('/');
    ELEMENTS.contains(&plain) || COILS.contains(&plain) || COILS_IEC.contains(&plain) || OTHERS.contains(&plain) || is_box(word)
}

/// The name of a box of STEP 7.
pub fn is_box(word: &str) -> bool {
    matches!(word, "SR" | "RS" | "CALL")
        || BoxRow::of_name(word).is_some()
        || TimerKind::ALL.iter().any(|row| row.2 == word)
        || CounterKind::ALL.iter().any(|row| row.1 == word)
}
