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
