//! Which block calls which: the program structure.

use super::{Place, Position, Snapshot};

/// A block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// As it is called: `Dosing`, `FC 1`.
    pub name: String,
    /// Its number and title: `FC 1 · Dosing of water`.
    pub detail: String,
    /// The name in its header.
    pub place: Place,
    /// The whole block.
    pub whole: Place,
}

/// A block that calls or is called, with the places of the calls, which lie in the caller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// The other block.
    pub block: Block,
    /// The places.
    pub places: Vec<Place>,
}

/// The block that is named at a position, else the block around it.
pub fn prepare(snapshot: &Snapshot, position: Position) -> Option<Block> {
    let _ = (snapshot, position);
    None
}

/// The blocks that call a block, which is found by its place.
pub fn incoming(snapshot: &Snapshot, block: &Block) -> Vec<Call> {
    let _ = (snapshot, block);
    Vec::new()
}

/// The blocks that a block calls.
pub fn outgoing(snapshot: &Snapshot, block: &Block) -> Vec<Call> {
    let _ = (snapshot, block);
    Vec::new()
}
