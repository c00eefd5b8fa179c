//! The parameters of the call around a position.

use super::{Bytes, Position, Snapshot};

/// A call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// `Dosing(amount : INT, start : BOOL) : BOOL`.
    pub label: String,
    /// What the block says about itself, in Markdown; may be empty.
    pub documentation: String,
    /// The parameters in the order of the label.
    pub parameters: Vec<Parameter>,
    /// Which parameter the position belongs to.
    pub active: Option<usize>,
}

/// A parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// The bytes of the label that are the parameter.
    pub label: Bytes,
    /// Its comment; may be empty.
    pub documentation: String,
}

/// The call around a position.
pub fn signature(snapshot: &Snapshot, position: Position) -> Option<Signature> {
    let _ = (snapshot, position);
    None
}
