//! Finds the blocks of the library that a program names and does not define.

use std::collections::{BTreeMap, HashSet};

use sieben_model::address::Operand as Address;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;

use super::{ALL, LibraryBlock, Selection, by_name};
use crate::scope::Scope;

/// The blocks that are linked, by the number that each gets.
pub(crate) type Links = BTreeMap<BlockId, &'static LibraryBlock>;

/// What may be a block of the library, as a source names it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Mention {
    /// `FC 2`; the number unchecked.
    Number(BlockKind, u64),
    /// `CONCAT`.
    Name(String),
}

/// Finds the blocks of the library among those that a program mentions.
///
/// `needed` are blocks that something else than a name calls for. `scope` takes in the names that are used without a row in the symbol table. A block that the program defines itself
/// always wins.
pub(crate) fn link<'a>(
    mentions: impl Iterator<Item = &'a Mention>,
    needed: &[&'static LibraryBlock],
    defined: &HashSet<BlockId>,
    scope: &mut Scope,
    selection: &Selection,
    cpu: &CpuType,
) -> Links {
    let mut search = Search { placed: placed(scope, needed, selection, cpu), defined, scope, links: Links::new() };
    if selection.enabled {
        for mention in mentions {
            match mention {
                Mention::Number(kind, number) => search.number(*kind, *number),
                Mention::Name(name) => search.name(name),
            }
        }
        for block in needed {
            search.name(block.name);
        }
    }
    search.links
}

/// Which block of the library stands behind which number: as the project says, as its symbol table says, else as ever.
fn placed(scope: &Scope, needed: &[&LibraryBlock], selection: &Selection, cpu: &CpuType) -> Links {
    let mut placed = Links::new();
    let mut as_ever = Vec::new();
    for block in ALL {
        let in_table = || match scope.global(block.name)?.operand? {
            Address::Block(id) if id.kind == block.block.kind && !scope.global(block.name)?.ambiguous => Some(id),
            _ => None,
        };
        match selection.number(block).or_else(in_table) {
            Some(id) if id.number <= cpu.fc_number_max => {
                placed.entry(id).or_insert(block);
            }
            Some(_) => {}
            None if selection.only_chosen && !needed.contains(&block) => {}
            None => as_ever.push(block),
        }
    }
    for block in as_ever {
        placed.entry(block.block).or_insert(block);
    }
    placed
}

struct Search<'s> {
    placed: Links,
    defined: &'s HashSet<BlockId>,
    scope: &'s mut Scope,
    links: Links,
}

impl Search<'_> {
    fn number(&mut self, kind: BlockKind, number: u64) {
        if let Ok(number) = u16::try_from(number) {
            self.id(BlockId::new(kind, number));
        }
    }

    fn id(&mut self, id: BlockId) {
        if !self.defined.contains(&id)
            && let Some(block) = self.placed.get(&id)
        {
            self.links.insert(id, block);
        }
    }

    fn name(&mut self, name: &str) {
        if let Some(global) = self.scope.global(name) {
            if let Some(Address::Block(id)) = global.operand {
                self.id(id);
            }
            return;
        }
        let Some(block) = by_name(name) else { return };
        // Without a place its number belongs to another block of the library.
        let Some((&id, _)) = self.placed.iter().find(|(_, placed)| **placed == block) else { return };
        if !self.defined.contains(&id) {
            self.scope.add_block(block.name, id);
            self.id(id);
        }
    }
}
