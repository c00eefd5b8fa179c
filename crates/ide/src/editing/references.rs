//! Every use of what a name or an address stands for.

use super::{Place, Position, Snapshot};

/// How something is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Access {
    /// Its definition or declaration.
    Definition,
    /// It is read.
    Read,
    /// It is written.
    Write,
    /// Both.
    ReadWrite,
    /// It is called.
    Call,
    /// The data block is opened.
    Open,
    /// It is the instance of a call.
    Instance,
    /// Its address or number is taken.
    Address,
    /// A label is jumped to.
    Jump,
    /// It is named as a type.
    Type,
    /// It is the formal parameter of a call.
    Parameter,
}

/// How a use is come by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Through {
    /// By its name.
    Name,
    /// By its address.
    Address,
    /// By an address that has bits in common with it.
    Overlap,
    /// By a pointer that may lead to it.
    Pointer,
}

/// One use.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Use {
    /// The name or the address.
    pub place: Place,
    /// How it is used.
    pub access: Access,
    /// How it is come by.
    pub through: Through,
}

/// Every use of what stands at a position, by text and place; the definitions are among them.
pub fn references(snapshot: &Snapshot, position: Position) -> Vec<Use> {
    let _ = (snapshot, position);
    Vec::new()
}
