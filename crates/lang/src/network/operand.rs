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

    /// As it is written it may be a bit: a bit of an area, a timer, a counter or a name, but no constant and nothing that is wider.
    pub fn may_be_bit(&self) -> bool {
        let text = self.text.as_str();
        if text.starts_with('#') {
            return true;
        }
        if let Some((_, member)) = text.rsplit_once('"') {
            // `"Data".DBW 0`
            return !member.starts_with('.') || !is_wide(member);
        }
        let constant = text.contains(['#', '\'']) || text.starts_with(|sign: char| sign.is_ascii_digit() || matches!(sign, '+' | '-'));
        !constant && !["TRUE", "FALSE"].iter().any(|constant| text.eq_ignore_ascii_case(constant)) && !is_wide(text)
    }

    /// It is a status bit, which a contact may read.
    pub fn is_status(&self) -> bool {
        STATUS_BITS.contains(&self.text.as_str())
    }
}

/// Areas and blocks whose operands are wider than a bit, in both languages.
const WIDE: [&str; 46] = [
    "IB", "IW", "ID", "QB", "QW", "QD", "MB", "MW", "MD", "LB", "LW", "LD", "EB", "EW", "ED", "AB", "AW", "AD", "PIB", "PIW", "PID", "PQB",
    "PQW", "PQD", "PEB", "PEW", "PED", "PAB", "PAW", "PAD", "DBB", "DBW", "DBD", "DIB", "DIW", "DID", "DB", "DI", "FB", "FC", "SFB", "SFC",
    "OB", "UDT", "VAT", "SDB",
];

/// Letters of [`WIDE`] with a number after them, at the end.
fn is_wide(text: &str) -> bool {
    let area = text.trim_end_matches(|sign: char| sign.is_ascii_digit());
    let number = area.len() < text.len();
    let area = area.trim_end();
    let letters = area.len() - area.trim_end_matches(|sign: char| sign.is_ascii_alphabetic()).len();
    let area = area.get(area.len() - letters..).unwrap_or_default();
    number && WIDE.iter().any(|wide| area.eq_ignore_ascii_case(wide))
}

/// The status bits that a contact may read.
pub const STATUS_BITS: [&str; 10] = ["OV", "OS", "UO", "BR", "==0", "<>0", ">0", "<0", ">=0", "<=0"];

impl PartialEq for Operand {
    /// Where an operand stands makes no difference.
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
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
