//! Values at one moment, apart from the CPU they came from.

use std::fmt;

use sieben_cpu::Cpu;
use sieben_model::value::{Content, Kind, Shown, Value};

use super::{Name, NameError};

/// Longest text that a [`Sample`] keeps, in bytes; the rest is cut, so that a recording of long strings stays small.
pub const TEXT_BYTES_MAX: usize = 4096;

/// A value at one moment.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub enum Sample {
    /// There was none: the data block was not loaded.
    #[default]
    Absent,
    /// The bits, right-justified.
    Bits(u64),
    /// Text, of at most [`TEXT_BYTES_MAX`] bytes.
    Text(Box<str>),
}

impl Sample {
    /// A text, cut where it is too long.
    pub fn text(text: &str) -> Self {
        if text.len() <= TEXT_BYTES_MAX {
            return Self::Text(text.into());
        }
        let end = (0..=TEXT_BYTES_MAX - '…'.len_utf8()).rev().find(|&end| text.is_char_boundary(end)).unwrap_or(0);
        Self::Text(format!("{}…", &text[..end]).into())
    }

    /// What a recording keeps of a value.
    pub fn of(value: &Value) -> Self {
        Self::of_content(&value.kind, &value.content)
    }

    fn of_content(kind: &Kind, content: &Content) -> Self {
        match content {
            Content::Bits(bits) if !kind.is_recorded_as_text() => Self::Bits(*bits),
            _ => Self::text(&kind.show(content).to_string()),
        }
    }

    /// The value as it is shown; `None` if there is none.
    pub fn shown(&self, kind: &Kind) -> Option<Shown> {
        match self {
            Self::Absent => None,
            Self::Bits(bits) => Some(kind.show(&Content::Bits(*bits))),
            Self::Text(text) => Some(Shown::Text(text.to_string())),
        }
    }

    /// The value as text; `-` if there is none.
    pub fn display<'a>(&'a self, kind: &'a Kind) -> Displayed<'a> {
        Displayed { kind, value: self }
    }

    /// The value as people read it in a message; `-` if there is none.
    pub fn readable(&self, kind: &Kind) -> String {
        self.shown(kind).map_or_else(|| "-".to_owned(), |shown| shown.readable())
    }

    /// The value as a number on a scale; `None` for what has no scale.
    pub fn number(&self, kind: &Kind) -> Option<f64> {
        match self {
            Self::Bits(bits) => kind.number(*bits),
            _ => None,
        }
    }

    /// As [`Self::number`]; words and double words without a type have a sign, as `>I` and `>D` see them.
    pub fn scale(&self, kind: &Kind) -> Option<f64> {
        match self {
            Self::Bits(bits) => kind.scale(*bits),
            _ => None,
        }
    }
}

/// A value ready to be written.
#[derive(Clone, Copy, Debug)]
pub struct Displayed<'a> {
    kind: &'a Kind,
    value: &'a Sample,
}

impl fmt::Display for Displayed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.value.shown(self.kind) {
            None => f.write_str("-"),
            Some(shown) => shown.fmt(f),
        }
    }
}

impl Name {
    /// What a recording of its value keeps.
    pub fn recorded(&self) -> Kind {
        self.kind().clone().recorded()
    }

    /// The value in a CPU, to be kept beside [`Self::recorded`].
    ///
    /// # Errors
    /// The CPU has nothing of that name.
    pub fn sample(&self, cpu: &Cpu) -> Result<Sample, NameError> {
        self.content(cpu).map(|content| Sample::of_content(self.kind(), &content))
    }
}
