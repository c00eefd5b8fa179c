//! What stands at a position, in a few lines of Markdown.

use super::{Bytes, Position, Snapshot};

/// What is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// What it is about, without quotes and `#`.
    pub range: Bytes,
    /// The lines, in Markdown.
    pub markdown: String,
}

/// An instruction with its status row; a name with its address, type, comment and uses; a timer with its signal diagram.
pub fn hover(snapshot: &Snapshot, position: Position) -> Option<Hover> {
    let _ = (snapshot, position);
    None
}
