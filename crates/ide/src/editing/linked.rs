//! Places that change together while they are typed: a label and its jumps.

use sieben_lang::names::{DefId, DefinitionKind};

use super::{Bytes, Position, Snapshot};

/// The label at a position and its jumps; nothing elsewhere.
pub fn linked(snapshot: &Snapshot, position: Position) -> Vec<Bytes> {
    let Some((_, _, target @ DefId::Definition { text, index })) = snapshot.named(position) else { return Vec::new() };
    let names = snapshot.names();
    if names.definition_at((text, index)).is_none_or(|one| one.kind != DefinitionKind::Label) {
        return Vec::new();
    }
    let uses = names.named_uses(target, Some(text));
    let mut places: Vec<Bytes> = uses.into_iter().filter_map(|found| snapshot.place_of(found)).map(|place| place.range).collect();
    places.sort_unstable();
    places
}
