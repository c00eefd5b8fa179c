//! Changes that are offered for a selection.

mod convert;
mod declare;
mod extract;
mod label;
mod notation;
mod symbol;

use super::{Bytes, Edit, Place, Position, Role, Snapshot, TextId};

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

impl Action {
    fn new(kind: Kind, title: impl Into<String>, edits: Vec<Edit>) -> Self {
        Self { title: title.into(), kind, edits, disabled: None }
    }

    fn disabled(kind: Kind, title: impl Into<String>, reason: impl Into<String>) -> Self {
        Self { title: title.into(), kind, edits: Vec::new(), disabled: Some(reason.into()) }
    }
}

/// The changes that are offered for some bytes of a text; an empty range is a cursor.
pub fn actions(snapshot: &Snapshot, text: TextId, range: Bytes) -> Vec<Action> {
    if snapshot.text(text).is_none_or(|text| text.role != Role::Source) {
        return Vec::new();
    }
    let (Some(start), Some(end)) =
        (snapshot.offset(Position { text, offset: range.start }), snapshot.offset(Position { text, offset: range.end.max(range.start) }))
    else {
        return Vec::new();
    };
    let at = At { snapshot, text, range: Bytes { start, end } };
    let mut actions = Vec::new();
    actions.extend(declare::action(&at));
    actions.extend(symbol::actions(&at));
    actions.extend(label::action(&at));
    actions.extend(notation::actions(&at));
    actions.extend(convert::actions(&at));
    actions.extend(extract::action(&at));
    for action in &mut actions {
        let fixed = action.edits.iter().find_map(|edit| snapshot.text(edit.place.text)?.fixed.clone());
        if let Some(reason) = fixed {
            (action.edits, action.disabled) = (Vec::new(), Some(reason));
        }
        action.edits.sort_by_key(|edit| edit.place.clone());
    }
    actions
}

/// What is selected.
struct At<'s> {
    snapshot: &'s Snapshot,
    text: TextId,
    range: Bytes,
}

impl At<'_> {
    fn content(&self) -> &str {
        self.snapshot.text(self.text).map_or("", |text| &text.text)
    }

    fn position(&self) -> Position {
        Position { text: self.text, offset: self.range.start }
    }

    fn edit(&self, range: Bytes, new_text: impl Into<String>) -> Edit {
        Edit { place: Place { text: self.text, range }, new_text: new_text.into() }
    }

    /// What ends the lines of the text.
    fn line_end(&self) -> &'static str {
        line_end(self.content())
    }
}

fn line_end(text: &str) -> &'static str {
    match (text.contains("\r\n"), text.contains('\n'), text.contains('\r')) {
        (true, ..) => "\r\n",
        (_, false, true) => "\r",
        _ => "\n",
    }
}
