//! An operand of a diagram: as written, with its place.

use std::fmt;
use std::ops::Deref;

/// An operand, a constant or a name as it is written, without spaces around it.
#[derive(Clone, Debug, Default, Eq)]
pub struct Operand {
    /// What is written: `I 0.0`, `"Start"`, `S5T#2S`.
    pub text: String,
    /// Its first byte in the text of the diagram; `None` if it was made from something else.
    pub start: Option<u32>,
}

impl Operand {
    /// An operand at a byte of the text of a diagram.
    pub fn at(text: impl Into<String>, start: usize) -> Self {
        Self { text: text.into(), start: u32::try_from(start).ok() }
    }

    /// It is a status bit, which a contact may read.
    pub fn is_status(&self) -> bool {
        STATUS_BITS.contains(&self.text.as_str())
    }
}

/// Whether a word before `=>` may be the name of an output: no number, no path, and neither TRUE nor FALSE.
pub(super) fn may_name_output(word: &str) -> bool {
    let is_truth = ["TRUE", "FALSE"].iter().any(|truth| truth.eq_ignore_ascii_case(word));
    let is_word = word.chars().all(|sign| sign.is_alphanumeric() || sign == '_');
    is_word && !is_truth && word.starts_with(|sign: char| sign.is_alphabetic() || sign == '_')
}

/// The status bits that a contact may read; BIE is BR in German mnemonics.
pub const STATUS_BITS: [&str; 11] = ["OV", "OS", "UO", "BR", "BIE", "==0", "<>0", ">0", "<0", ">=0", "<=0"];

impl PartialEq for Operand {
    /// Where an operand stands makes no difference, nor a space in an address: `I0.0` is `I 0.0`.
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text || (self.text.len() != other.text.len() && compact(&self.text) == compact(&other.text))
    }
}

impl PartialEq<str> for Operand {
    fn eq(&self, other: &str) -> bool {
        self.text == other
    }
}

impl PartialEq<&str> for Operand {
    fn eq(&self, other: &&str) -> bool {
        self.text == *other
    }
}

impl Deref for Operand {
    type Target = str;
    fn deref(&self) -> &str {
        &self.text
    }
}

impl From<&str> for Operand {
    fn from(text: &str) -> Self {
        Self { text: text.to_owned(), start: None }
    }
}

impl From<String> for Operand {
    fn from(text: String) -> Self {
        Self { text, start: None }
    }
}

impl fmt::Display for Operand {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.pad(&self.text)
    }
}

impl Operand {
    /// An operand in its usual notation: an address without spaces, everything else as it is written.
    pub fn read(text: &str, start: usize) -> Self {
        Self::at(compact(text), start)
    }

    /// As the name of a pin or a variable is written: in quotes if it has other signs than letters, digits and `_`.
    pub fn as_name(&self) -> String {
        let plain = self.chars().all(|sign| sign.is_alphanumeric() || sign == '_');
        if plain { self.text.clone() } else { format!("\"{}\"", self.text) }
    }

    /// As people read it: `I 0.0`, `MW 10`, `DB10.DBX 0.0`.
    pub fn spaced(&self) -> String {
        let text = self.text.as_str();
        let (block, address) =
            text.rsplit_once('.').filter(|(block, _)| block.starts_with("DB") || block.starts_with('"')).unwrap_or(("", text));
        // `DB10.DBX0.0`: the last dot is that of the bit.
        let (block, address) = match block.rsplit_once('.') {
            Some((before, letters)) if letters.starts_with("DB") => (before, &text[before.len() + 1..]),
            _ => (block, address),
        };
        let letters = address.find(|sign: char| sign.is_ascii_digit()).unwrap_or(0);
        let (word, number) = address.split_at(letters);
        let is_number = !number.is_empty() && number.bytes().all(|sign| sign.is_ascii_digit() || sign == b'.');
        if !is_number || !ADDRESS_LETTERS.contains(&word.to_ascii_uppercase().as_str()) {
            return text.to_owned();
        }
        let dot = if block.is_empty() { "" } else { "." };
        format!("{block}{dot}{word} {number}")
    }

    /// It is the address of a bit of I, Q, M, L or a data block.
    pub fn is_bit_address(&self) -> bool {
        let text = compact(&self.text);
        let address = match text.split_once(".DBX") {
            Some((block, _)) if block.starts_with("DB") || block.starts_with('"') => &text[block.len() + 1..],
            _ => text.as_str(),
        };
        let letters = address.find(|sign: char| sign.is_ascii_digit()).unwrap_or(0);
        let (word, number) = address.split_at(letters);
        let numbers = number.split_once('.').is_some_and(|(byte, bit)| {
            let digits = |text: &str| !text.is_empty() && text.bytes().all(|sign| sign.is_ascii_digit());
            digits(byte) && digits(bit)
        });
        numbers && BIT_LETTERS.contains(&word.to_ascii_uppercase().as_str())
    }
}

/// The letters of addresses, in both mnemonic languages.
const ADDRESS_LETTERS: [&str; 54] = [
    "I", "IB", "IW", "ID", "E", "EB", "EW", "ED", "Q", "QB", "QW", "QD", "A", "AB", "AW", "AD", "M", "MB", "MW", "MD", "L", "LB", "LW",
    "LD", "T", "C", "Z", "DBX", "DBB", "DBW", "DBD", "DIX", "DIB", "DIW", "DID", "PIB", "PIW", "PID", "PQB", "PQW", "PQD", "PEB", "PEW",
    "PED", "PAB", "PAW", "PAD", "FC", "FB", "DB", "SFC", "SFB", "DI", "OB",
];

/// The letters of bits.
const BIT_LETTERS: [&str; 8] = ["I", "E", "Q", "A", "M", "L", "DBX", "DIX"];

/// A text without the spaces between the letters of an address and its number; quotes, `#` names, constants and pointers keep theirs.
fn compact(text: &str) -> String {
    let text = text.trim();
    if text.contains(['#', '\'']) || !text.contains([' ', '\t']) {
        return text.to_owned();
    }
    let mut out = String::with_capacity(text.len());
    let mut quoted = false;
    let mut rest = text.chars().peekable();
    while let Some(sign) = rest.next() {
        quoted ^= sign == '"';
        let blank = sign == ' ' || sign == '\t';
        if blank && !quoted && out.ends_with(|before: char| before.is_ascii_alphabetic()) {
            let mut next = rest.clone();
            while next.next_if(|sign| *sign == ' ' || *sign == '\t').is_some() {}
            let letters = out.trim_end_matches(|before: char| before.is_ascii_alphabetic()).len();
            let is_address = ADDRESS_LETTERS.contains(&out[letters..].to_ascii_uppercase().as_str());
            if is_address && next.peek().is_some_and(|sign| sign.is_ascii_digit()) {
                rest = next;
                continue;
            }
        }
        out.push(sign);
    }
    out
}
