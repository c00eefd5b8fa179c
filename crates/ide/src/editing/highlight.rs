//! The uses of a name in the text that it stands in.

use super::references::{Use, uses};
use super::{Position, Snapshot};

/// The uses in the same text of what stands at a position.
pub fn highlight(snapshot: &Snapshot, position: Position) -> Vec<Use> {
    let Some((_, _, target)) = snapshot.named(position) else { return Vec::new() };
    uses(snapshot, &snapshot.names().uses(target, Some(position.text.0 as u32)))
}
