//! Finds the blocks of the library that a program names and does not define.

use std::collections::{BTreeMap, HashSet};

use sieben_model::address::Operand as Address;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;

use super::{ALL, LibraryBlock, Selection, by_name};
use crate::scope::{Scope, key};
use crate::stl::ast;

/// The blocks that are linked, by the number that each gets.
pub(crate) type Links = BTreeMap<BlockId, &'static LibraryBlock>;

/// Looks through the blocks of a program for names of library blocks.
///
/// `needed` are blocks that something else than a name in STL calls for. `scope` takes in the names that are used without a row in the symbol table. A block that the program defines itself
/// always wins.
pub(crate) fn link<'a>(
    blocks: impl Iterator<Item = &'a ast::Block>,
    needed: &[&'static LibraryBlock],
    defined: &HashSet<BlockId>,
    scope: &mut Scope,
    selection: &Selection,
    cpu: &CpuType,
) -> Links {
    let mut search = Search { placed: placed(scope, selection, cpu), defined, scope, links: Links::new() };
    if selection.enabled {
        for block in blocks {
            search.block(block);
        }
        for block in needed {
            search.symbol(block.name);
        }
    }
    search.links
}

/// Which block of the library stands behind which number: as the project says, as its symbol table says, else as ever.
fn placed(scope: &Scope, selection: &Selection, cpu: &CpuType) -> Links {
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
    fn block(&mut self, block: &ast::Block) {
        let mut locals = HashSet::new();
        for declaration in block.sections.iter().flat_map(|section| &section.declarations) {
            locals.extend(declaration.names.iter().map(|word| key(&word.text)));
            self.type_name(&declaration.data_type);
        }
        if let Some(based_on) = &block.body_type {
            self.type_name(based_on);
        }
        // `UC` and `CC` pass no parameters, which every block of the library needs.
        for statement in &block.statements {
            if let ast::Operand::Call(call) = &statement.operand {
                self.operand(&call.callee, &locals);
            }
        }
    }

    /// `FB 41` or `"CONT_C"` as the type of an instance.
    fn type_name(&mut self, name: &ast::TypeName) {
        match &name.kind {
            ast::TypeKind::Block(kind, number) => self.absolute(*kind, *number),
            ast::TypeKind::Symbol(symbol) => self.symbol(symbol),
            ast::TypeKind::Array { element, .. } => self.type_name(element),
            _ => {}
        }
    }

    /// What is called: by number or by name.
    fn operand(&mut self, operand: &ast::Operand, locals: &HashSet<String>) {
        match operand {
            ast::Operand::Symbol { name, path } if path.is_empty() => self.symbol(&name.text),
            ast::Operand::Name { word, path } if path.is_empty() && !locals.contains(&key(&word.text)) => self.symbol(&word.text),
            ast::Operand::Absolute { letters, number, bit: None } => {
                if let Some(kind) = BlockKind::from_abbreviation(letters) {
                    self.absolute(kind, *number);
                }
            }
            _ => {}
        }
    }

    fn absolute(&mut self, kind: BlockKind, number: u64) {
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

    fn symbol(&mut self, name: &str) {
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
