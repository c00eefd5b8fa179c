//! Whether every name means after a rename what it meant before.

use sieben_lang::source_names::key;

use super::super::{Edit, Snapshot, TextId};

/// Makes the project with the edits and compares what each use of the old and of the new name stands for; a sentence says where it is
/// something else. Other names stand in other places for the same as before: what they lead through has one of the two names.
pub(super) fn are_kept(snapshot: &Snapshot, edits: &[Edit], old_name: &str, new_name: &str) -> Result<(), String> {
    let changed = snapshot.with_edits(edits);
    let (before, after) = (snapshot.names(), changed.names());
    let keys = [key(old_name), key(new_name)];
    for index in 0..snapshot.texts().len() {
        let (Some(old), Some(new)) = (before.text(index as u32), after.text(index as u32)) else { continue };
        let text_name = &snapshot.texts()[index].name;
        if old.occurrences.len() != new.occurrences.len() || old.definitions.len() != new.definitions.len() {
            return Err(format!("`{text_name}` would be read in another way with the name `{new_name}`"));
        }
        let uses = keys.iter().flat_map(|key| old.occurrences_of(key).iter().chain(new.occurrences_of(key)));
        for &one in uses {
            if before.resolve(index as u32, one) != after.resolve(index as u32, one) {
                let start = old.occurrence(one).map_or(0, |one| one.span.start as usize);
                let line = snapshot.texts()[index].text.get(..start).map_or(0, |before| before.matches('\n').count()) + 1;
                let name = snapshot.slice(TextId(index), old.occurrence(one).map(|one| one.span.into()).unwrap_or_default());
                return Err(format!("`{name}` in line {line} of `{text_name}` would mean something else"));
            }
        }
    }
    Ok(())
}
