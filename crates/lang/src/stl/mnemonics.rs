//! Judges the mnemonic language of a whole source, and translates single words.

use sieben_model::mnemonics::Mnemonics;

use super::extension::translate_status_bit;
use super::instructions::Instruction;
use super::lexer::{Raw, token};
use crate::network::flavour::Drawing;

/// Address letters that differ: international and SIMATIC.
const ADDRESS_LETTERS: [(&str, &str); 19] = [
    ("I", "E"),
    ("IX", "EX"),
    ("IB", "EB"),
    ("IW", "EW"),
    ("ID", "ED"),
    ("Q", "A"),
    ("QX", "AX"),
    ("QB", "AB"),
    ("QW", "AW"),
    ("QD", "AD"),
    ("PI", "PE"),
    ("PIB", "PEB"),
    ("PIW", "PEW"),
    ("PID", "PED"),
    ("PQ", "PA"),
    ("PQB", "PAB"),
    ("PQW", "PAW"),
    ("PQD", "PAD"),
    ("C", "Z"),
];

/// Status words that differ.
const STATUS_WORDS: [(&str, &str); 1] = [("BR", "BIE")];

/// Instructions that look the same in both languages or are easily taken for the other one; they prove nothing alone.
const AMBIGUOUS: [&str; 2] = ["SE", "SS"];

/// What the words of a file say about its language.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Judgement {
    /// Words that only the international set has.
    pub english: u32,
    /// Words that only the SIMATIC set has.
    pub german: u32,
    /// The first word that means different things in the two sets, as bytes of the text.
    pub ambiguous: Option<(usize, usize)>,
}

impl Judgement {
    /// The language of the majority, international without one.
    pub fn mnemonics(&self) -> Mnemonics {
        if self.german > self.english { Mnemonics::German } else { Mnemonics::English }
    }
    /// No word decided.
    pub fn is_open(&self) -> bool {
        self.english == 0 && self.german == 0
    }
}

/// Whether networks are diagrams.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawn {
    /// They are: only addresses tell the language.
    Yes,
    /// They are statements.
    No,
}

/// Where the word ends that says how a network is written, if there is one at this byte; else the byte itself.
pub(super) fn notation_after(text: &str, end: usize) -> usize {
    notation(text, end, Drawn::No).1
}

/// What the word after NETWORK says, and where what follows begins.
fn notation(text: &str, end: usize, usual: Drawn) -> (Drawn, usize) {
    let mut at = end;
    while let (Raw::Blank, next) = token(text, at) {
        at = next;
    }
    let (raw, behind) = token(text, at);
    match NOTATIONS.iter().find(|(word, _)| raw == Raw::Word && text[at..behind].eq_ignore_ascii_case(word)) {
        Some((_, Some(_))) => (Drawn::Yes, behind),
        Some((_, None)) => (Drawn::No, behind),
        None => (usual, end),
    }
}

/// The words after NETWORK that say how it is written.
pub(super) const NOTATIONS: [(&str, Option<Drawing>); 6] = [
    ("LAD", Some(Drawing::Lad)),
    ("KOP", Some(Drawing::Lad)),
    ("FBD", Some(Drawing::Fbd)),
    ("FUP", Some(Drawing::Fbd)),
    ("STL", None),
    ("AWL", None),
];

/// The instruction word in the other language; `None` if `from` has no such word.
pub fn translate_instruction(word: &str, from: Mnemonics) -> Option<&'static str> {
    Instruction::candidates(word, from).next().map(|instruction| instruction.mnemonic(from.other()))
}

/// An international instruction word in a mnemonic language.
pub fn instruction_in(word: &'static str, mnemonics: Mnemonics) -> &'static str {
    let translated = || translate_instruction(word, Mnemonics::English).unwrap_or(word);
    if mnemonics == Mnemonics::English { word } else { translated() }
}

/// An international status word in a mnemonic language; every other word stays as it is.
pub fn status_in(word: &str, mnemonics: Mnemonics) -> &str {
    let translated = || translate_status(word, Mnemonics::English).unwrap_or(word);
    if mnemonics == Mnemonics::English { word } else { translated() }
}

/// The letters of an address in the other language; `None` if they are the same or unknown.
pub fn translate_letters(letters: &str, from: Mnemonics) -> Option<&'static str> {
    pick(&ADDRESS_LETTERS, letters, from)
}

/// A status word in the other language; `None` if it is the same or unknown.
pub fn translate_status(word: &str, from: Mnemonics) -> Option<&'static str> {
    pick(&STATUS_WORDS, word, from)
}

/// A word of a table of pairs, international and SIMATIC, in the other language.
pub(super) fn pick(table: &[(&'static str, &'static str)], word: &str, from: Mnemonics) -> Option<&'static str> {
    table.iter().find_map(|&(english, german)| {
        let (source, target) = match from {
            Mnemonics::English => (english, german),
            Mnemonics::German => (german, english),
        };
        source.eq_ignore_ascii_case(word).then_some(target)
    })
}

/// The language of a single instruction word; `None` if both sets or neither have it.
fn instruction_language(word: &str) -> Option<Mnemonics> {
    let english = translate_instruction(word, Mnemonics::English).is_some();
    let german = translate_instruction(word, Mnemonics::German).is_some();
    match (english, german) {
        (true, false) => Some(Mnemonics::English),
        (false, true) => Some(Mnemonics::German),
        _ => None,
    }
}

/// Counts the words of a source that only one language has, in statements only.
pub fn judge(text: &str, drawn: Drawn) -> Judgement {
    let mut drawn_here = drawn;
    let mut judgement = Judgement::default();
    let mut position = 0;
    let mut at_start = true;
    let mut behind_point = false;
    let mut declarations = 0_u32;
    loop {
        let (raw, end) = token(text, position);
        let word = &text[position..end];
        match raw {
            Raw::End => return judgement,
            Raw::Newline | Raw::Semicolon => at_start = true,
            Raw::Blank | Raw::LineComment | Raw::BlockComment => {}
            Raw::Colon => at_start = true,
            // A field may be called `e` and have an index.
            Raw::Word if behind_point => {}
            Raw::Literal if declarations == 0 => count_pointer(word, &mut judgement),
            Raw::Word => {
                let upper = word.to_ascii_uppercase();
                match upper.as_str() {
                    "VAR" | "VAR_INPUT" | "VAR_OUTPUT" | "VAR_IN_OUT" | "VAR_TEMP" | "STRUCT" => declarations += 1,
                    "END_VAR" | "END_STRUCT" => declarations = declarations.saturating_sub(1),
                    "NETWORK" => {
                        declarations = 0;
                        (drawn_here, position) = notation(text, end, drawn);
                        at_start = false;
                        continue;
                    }
                    "BEGIN" => declarations = 0,
                    "TITLE" | "AUTHOR" | "FAMILY" | "NAME" | "VERSION" if at_start => {
                        position = text[end..].find(['\r', '\n']).map_or(text.len(), |line| end + line);
                        continue;
                    }
                    _ if declarations > 0 => {}
                    // The words of elements are the same in both languages.
                    _ if at_start && drawn_here == Drawn::Yes && upper.len() > 1 => {}
                    _ if at_start && drawn_here == Drawn::No => {
                        let mut behind = end;
                        while let (Raw::Blank, next) = token(text, behind) {
                            behind = next;
                        }
                        match token(text, behind).0 {
                            // A label, a parameter or a declaration.
                            Raw::Colon | Raw::Becomes => {}
                            next => {
                                let bracket = next == Raw::ParenOpen && !upper.starts_with("CALL");
                                match instruction_language(&upper).or_else(|| match bracket {
                                    true => instruction_language(&format!("{upper}(")),
                                    false => None,
                                }) {
                                    Some(Mnemonics::English) => judgement.english += 1,
                                    Some(Mnemonics::German) => judgement.german += 1,
                                    None if AMBIGUOUS.contains(&upper.as_str()) => {
                                        judgement.ambiguous.get_or_insert((position, end));
                                    }
                                    None => {}
                                }
                            }
                        }
                    }
                    "__STW" => {
                        let (name, behind) = status_bit_behind(text, end);
                        match (translate_status_bit(name, Mnemonics::English), translate_status_bit(name, Mnemonics::German)) {
                            (Some(_), None) => judgement.english += 1,
                            (None, Some(_)) => judgement.german += 1,
                            _ => {}
                        }
                        position = behind;
                        continue;
                    }
                    _ => count_operand(text, &upper, end, &mut judgement),
                }
                at_start = false;
            }
            _ => at_start = false,
        }
        behind_point = raw == Raw::Point;
        position = end;
    }
}

/// `P#E 1.0`, `P#I 1.0 BYTE 4`: the letters of the area.
fn count_pointer(literal: &str, judgement: &mut Judgement) {
    let Some(behind) = literal.strip_prefix(['P', 'p']).and_then(|rest| rest.strip_prefix('#')) else { return };
    let behind = behind.trim_start();
    let letters = &behind[..behind.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(behind.len())];
    if translate_letters(letters, Mnemonics::English).is_some() {
        judgement.english += 1;
    } else if translate_letters(letters, Mnemonics::German).is_some() {
        judgement.german += 1;
    }
}

/// The name of a status bit behind `__STW`, and where it ends; empty if something else stands there.
fn status_bit_behind(text: &str, end: usize) -> (&str, usize) {
    let (raw, behind) = token(text, end);
    let start = if raw == Raw::Blank { behind } else { end };
    let slash = usize::from(text[start..].starts_with('/'));
    match token(text, start + slash) {
        (Raw::Word, behind) => (&text[start..behind], behind),
        _ => ("", start),
    }
}

fn count_operand(text: &str, word: &str, end: usize, judgement: &mut Judgement) {
    let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = letters.len() < word.len() || {
        let (raw, behind) = token(text, end);
        let next = if raw == Raw::Blank { token(text, behind).0 } else { raw };
        matches!(next, Raw::Number | Raw::BracketOpen)
    };
    let differs = |from| translate_status(word, from).is_some() || (number && translate_letters(letters, from).is_some());
    if differs(Mnemonics::English) {
        judgement.english += 1;
    } else if differs(Mnemonics::German) {
        judgement.german += 1;
    }
}
