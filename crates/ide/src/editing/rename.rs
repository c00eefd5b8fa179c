//! Another name for something, in all blocks, languages, symbol tables and tests.

use super::{Bytes, Edit, Position, Snapshot};

/// A name that can be another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Renamable {
    /// The name, without quotes and `#`.
    pub range: Bytes,
    /// The name as it is.
    pub name: String,
}

/// What would be renamed at a position, or a sentence that says why not.
pub fn prepare(snapshot: &Snapshot, position: Position) -> Result<Renamable, String> {
    let _ = (snapshot, position);
    Err("nothing here has a name".to_owned())
}

/// The edits that give it the new name everywhere, by text and place, or a sentence that says why not.
pub fn rename(snapshot: &Snapshot, position: Position, new_name: &str) -> Result<Vec<Edit>, String> {
    let _ = (snapshot, position, new_name);
    Err("nothing here has a name".to_owned())
}
