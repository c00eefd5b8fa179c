//! Where something is defined, declared, and where its type is.

use sieben_lang::names::{At, DefId, DefinitionKind};
use sieben_model::address::Operand;

use super::{Bytes, Place, Position, Snapshot};

/// Where a name leads to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// The name at the position.
    pub from: Bytes,
    /// The name in the definition.
    pub name: Place,
    /// The whole definition: the declaration, the block, the row of the symbol table.
    pub whole: Place,
}

/// What defines the name: the header of a block, the declaration of a variable, the label itself; of a symbol its row and, where it names a block, that block.
pub fn definition(snapshot: &Snapshot, position: Position) -> Vec<Link> {
    let Some((_, one, target)) = snapshot.named(position) else { return Vec::new() };
    let heads = heads(snapshot, target);
    let is_row = |at: &At| is_row(snapshot, *at);
    let has_header = heads.iter().any(|at| !is_row(at) && snapshot.places_of(*at).is_some());
    links(snapshot, one.span.into(), heads.iter().copied().filter(|at| !(has_header && is_row(at))))
}

/// What declares the name: the row of the symbol table where it has one, otherwise its definition.
pub fn declaration(snapshot: &Snapshot, position: Position) -> Vec<Link> {
    let Some((_, one, target)) = snapshot.named(position) else { return Vec::new() };
    let heads = heads(snapshot, target);
    let has_row = heads.iter().any(|at| is_row(snapshot, *at));
    links(snapshot, one.span.into(), heads.iter().copied().filter(|at| !has_row || is_row(snapshot, *at)))
}

/// The type of a variable: the UDT, the function block or the TYPE.
pub fn type_definition(snapshot: &Snapshot, position: Position) -> Vec<Link> {
    let Some((_, one, target)) = snapshot.named(position) else { return Vec::new() };
    let names = snapshot.names();
    let types = names.heads(target).into_iter().filter_map(|at| names.type_of(at));
    let heads = types.flat_map(|of| names.heads(of)).filter(|at| !is_row(snapshot, *at));
    links(snapshot, one.span.into(), heads)
}

/// The definitions of something; an address has those of its symbol.
fn heads(snapshot: &Snapshot, target: DefId) -> Vec<At> {
    let names = snapshot.names();
    let mut heads = names.heads(target);
    if let DefId::Operand(Operand::InDataBlock { db, .. }) = target
        && heads.is_empty()
    {
        // The data block that the address lies in.
        heads = names.heads(DefId::Block(sieben_model::block::BlockId::db(db)));
    }
    heads
}

fn is_row(snapshot: &Snapshot, at: At) -> bool {
    snapshot.names().definition_at(at).is_some_and(|one| one.kind == DefinitionKind::Symbol)
}

fn links(snapshot: &Snapshot, from: Bytes, heads: impl Iterator<Item = At>) -> Vec<Link> {
    let mut links: Vec<Link> = Vec::new();
    for (name, whole) in heads.filter_map(|at| snapshot.places_of(at)) {
        if !links.iter().any(|known| known.name == name) {
            links.push(Link { from, name, whole });
        }
    }
    links
}
