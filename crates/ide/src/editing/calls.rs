//! Which block calls which: the program structure.

use std::collections::BTreeMap;

use sieben_lang::names::{Access, At, DefId, DefinitionKind};

use super::{Place, Position, Snapshot, TextId, context};

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
    let named = snapshot.named(position).map(|(.., target)| context::block_of(snapshot, target));
    let named = named.and_then(|target| block(snapshot, target));
    named.or_else(|| {
        let offset = snapshot.offset(position)?;
        let scope = snapshot.of_text(position.text)?.scope_at(offset)?;
        block(snapshot, snapshot.names().of_definition((position.text.0 as u32, scope))?)
    })
}

/// The blocks that call a block, which is found by its place.
pub fn incoming(snapshot: &Snapshot, block: &Block) -> Vec<Call> {
    let Some(target) = found(snapshot, block) else { return Vec::new() };
    let names = snapshot.names();
    let mut callers: BTreeMap<At, Vec<Place>> = BTreeMap::new();
    for (text, source) in names.texts().iter().enumerate().take(snapshot.texts().len()) {
        for (index, one) in source.occurrences.iter().enumerate() {
            let is_call = matches!(one.access, Access::Call | Access::Instance);
            let Some(scope) = one.scope.filter(|_| is_call) else { continue };
            let called = names.resolve(text as u32, index as u32).map(|called| context::block_of(snapshot, called));
            // The instance of a call stands beside its block.
            let is_beside = one.access == Access::Instance && called.is_some_and(|called| called == target);
            if called == Some(target) && !is_beside {
                callers.entry((text as u32, scope)).or_default().push(Place { text: TextId(text), range: one.span.into() });
            }
        }
    }
    let call = |(at, places)| Some(Call { block: self::block(snapshot, names.of_definition(at)?)?, places });
    callers.into_iter().filter_map(call).collect()
}

/// The blocks that a block calls.
pub fn outgoing(snapshot: &Snapshot, block: &Block) -> Vec<Call> {
    let Some(source) = snapshot.of_text(block.whole.text) else { return Vec::new() };
    let names = snapshot.names();
    let text = block.whole.text;
    let mut called: BTreeMap<DefId, Vec<Place>> = BTreeMap::new();
    for (index, one) in source.occurrences.iter().enumerate() {
        let is_inside = block.whole.range.start <= one.span.start as usize && one.span.end as usize <= block.whole.range.end;
        if !is_inside || one.access != Access::Call {
            continue;
        }
        let Some(target) = names.resolve(text.0 as u32, index as u32) else { continue };
        called.entry(context::block_of(snapshot, target)).or_default().push(Place { text, range: one.span.into() });
    }
    called.into_iter().filter_map(|(target, places)| Some(Call { block: self::block(snapshot, target)?, places })).collect()
}

/// A block that stands in a text of the user.
fn block(snapshot: &Snapshot, target: DefId) -> Option<Block> {
    let names = snapshot.names();
    let heads = names.heads(target);
    let is_code = |at: &&At| names.definition_at(**at).is_some_and(|one| one.kind.is_code());
    let at = heads.iter().filter(is_code).find(|at| snapshot.places_of(**at).is_some())?;
    let definition = names.definition_at(*at)?;
    let (place, whole) = snapshot.places_of(*at)?;
    let symbol = heads.iter().filter_map(|at| names.definition_at(*at)).find(|one| one.kind == DefinitionKind::Symbol);
    let name = symbol.map_or_else(|| definition.name.clone(), |symbol| symbol.name.clone());
    let number = match target {
        DefId::Block(block) if symbol.is_some() || !definition.name.eq_ignore_ascii_case(&block.to_string()) => block.to_string(),
        _ => String::new(),
    };
    let detail: Vec<&str> = [number.as_str(), definition.comment.as_str()].into_iter().filter(|part| !part.is_empty()).collect();
    Some(Block { name, detail: detail.join(" · "), place, whole })
}

/// What a block is that was answered before.
fn found(snapshot: &Snapshot, block: &Block) -> Option<DefId> {
    let source = snapshot.of_text(block.place.text)?;
    let same = |one: &sieben_lang::names::Definition| {
        one.kind.is_code() && one.span.start as usize == block.place.range.start && one.span.end as usize == block.place.range.end
    };
    let index = source.definitions.iter().position(same)?;
    snapshot.names().of_definition((block.place.text.0 as u32, index as u32))
}
