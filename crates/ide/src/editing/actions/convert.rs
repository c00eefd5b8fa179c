//! Mnemonics of a selection in the other language.

use sieben_lang::stl::convert::translations;
use sieben_model::mnemonics::Mnemonics;

use super::{Action, At, Bytes, Kind};

/// Writes the selection, or the whole text, in the other mnemonic language.
pub(super) fn actions(at: &At<'_>) -> Option<Action> {
    let language = at.snapshot.language(at.text)?;
    if language.dialect().is_some() {
        return None;
    }
    let from = at.snapshot.of_text(at.text)?.mnemonics?;
    let to = from.other();
    let name = match to {
        Mnemonics::English => "international",
        Mnemonics::German => "SIMATIC",
    };
    let is_all = at.range.start == at.range.end;
    // A cursor alone offers it only at the beginning, so that it is not everywhere.
    if is_all && at.range.start > 0 {
        return None;
    }
    let what = if is_all { "the whole file" } else { "the selection" };
    let title = format!("Write {what} in {name} mnemonics");
    let inside = |range: &std::ops::Range<usize>| is_all || (at.range.start <= range.start && range.end <= at.range.end);
    let (edits, others): (Vec<_>, Vec<_>) = translations(at.content(), Some(from), to, language.drawing())
        .into_iter()
        .filter(|(range, new_text)| at.content().get(range.clone()) != Some(new_text))
        .partition(|(range, _)| inside(range));
    if !edits.is_empty() && !others.is_empty() {
        let reason = "the rest of the file would keep the mnemonics it has, and a file has one kind of them; select all of it";
        return Some(Action::disabled(Kind::Rewrite, title, reason));
    }
    let edits: Vec<_> = edits.into_iter().map(|(range, new_text)| at.edit(Bytes::from(range), new_text)).collect();
    match edits.is_empty() {
        true => Some(Action::disabled(
            Kind::Rewrite,
            title,
            "nothing there is written differently in the other mnemonics, or the file has errors",
        )),
        false => Some(Action::new(Kind::Rewrite, title, edits)),
    }
}
