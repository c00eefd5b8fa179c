//! What is shown between the words of a text: the address of a symbol, the symbol of an address, names of parameters.

use sieben_model::address::Operand;

use super::{Bytes, Snapshot, TextId};

/// What a hint says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The address of a symbol.
    Address,
    /// The symbol of an address.
    Symbol,
    /// The name of a parameter that is given by position.
    Parameter,
}

/// A hint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The byte that it is shown at.
    pub offset: usize,
    /// What is shown.
    pub label: String,
    /// What it says.
    pub kind: Kind,
    /// What the name or address stands for, if it has a value that a running controller can be asked for.
    pub operand: Option<Operand>,
}

/// The hints of some bytes of a text.
pub fn hints(snapshot: &Snapshot, text: TextId, range: Bytes) -> Vec<Hint> {
    let _ = (snapshot, text, range);
    Vec::new()
}
