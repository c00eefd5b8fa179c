//! Editor services on a snapshot of a project, as plain data: places are bytes of texts, and nothing here knows a protocol.
//!
//! A [`Snapshot`] holds the texts of a project and the names in each of them. A new one is made of the one before ([`Snapshot::changed`]):
//! what is known of a text is kept while the text is the same. Every service is one function of a snapshot and a position; a position
//! that is outside of its text is its end, and one inside of a character is the beginning of that character.

pub mod actions;
pub mod calls;
pub mod completion;
mod context;
pub mod definition;
pub mod fuzz;
pub mod highlight;
pub mod hints;
pub mod hover;
pub mod linked;
pub mod references;
pub mod rename;
pub mod signature;
mod snapshot;
pub mod symbols;

use std::ops::Range;

pub use snapshot::{Role, Snapshot, Text};

/// A text of a snapshot, by its position there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TextId(pub usize);

/// A byte of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position {
    /// Which text.
    pub text: TextId,
    /// The byte.
    pub offset: usize,
}

/// Some bytes of a text.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Which text.
    pub text: TextId,
    /// From the first byte to one after the last.
    pub range: Bytes,
}

/// A range of bytes that can be compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Bytes {
    /// The first byte.
    pub start: usize,
    /// One after the last byte.
    pub end: usize,
}

impl From<Range<usize>> for Bytes {
    fn from(range: Range<usize>) -> Self {
        Self { start: range.start, end: range.end }
    }
}

impl From<Bytes> for Range<usize> {
    fn from(range: Bytes) -> Self {
        range.start..range.end
    }
}

/// A replacement in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// What is replaced; empty where something is put in.
    pub place: Place,
    /// What stands there then.
    pub new_text: String,
}
