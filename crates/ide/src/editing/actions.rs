//! Changes that are offered for a selection.

use super::{Bytes, Edit, Snapshot, TextId};

/// What kind of change it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// It makes good what is reported at the place.
    QuickFix,
    /// It takes something out into a thing of its own.
    Extract,
    /// It writes the same in another way.
    Rewrite,
}

/// A change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Action {
    /// What it does, as the menu shows it.
    pub title: String,
    /// What kind of change it is.
    pub kind: Kind,
    /// The edits; none where it is disabled.
    pub edits: Vec<Edit>,
    /// Why it cannot be done here, as a sentence.
    pub disabled: Option<String>,
}

/// The changes that are offered for some bytes of a text; an empty range is a cursor.
pub fn actions(snapshot: &Snapshot, text: TextId, range: Bytes) -> Vec<Action> {
    let _ = (snapshot, text, range);
    Vec::new()
}
