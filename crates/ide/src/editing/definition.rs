//! Where something is defined, declared, and where its type is.

use super::{Bytes, Place, Position, Snapshot};

/// Where a name leads to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// The name at the position.
    pub from: Bytes,
    /// The name in the definition.
    pub name: Place,
    /// The whole definition: the declaration, the block, the row of the symbol table.
    pub whole: Place,
}

/// What defines the name: the header of a block, the declaration of a variable, the label itself; of a symbol its row and, where it names a block, that block.
pub fn definition(snapshot: &Snapshot, position: Position) -> Vec<Link> {
    let _ = (snapshot, position);
    Vec::new()
}

/// What declares the name: the row of the symbol table where it has one, otherwise its definition.
pub fn declaration(snapshot: &Snapshot, position: Position) -> Vec<Link> {
    let _ = (snapshot, position);
    Vec::new()
}

/// The type of a variable: the UDT, the function block or the TYPE.
pub fn type_definition(snapshot: &Snapshot, position: Position) -> Vec<Link> {
    let _ = (snapshot, position);
    Vec::new()
}
