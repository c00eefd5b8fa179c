//! Symbols that no statement uses, and addresses that have no symbol.

use std::collections::HashSet;

use sieben_lang::Compiled;
use sieben_model::address::{Area, Operand};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::symbols::{Symbol, SymbolTable};

use crate::cross_reference::{CrossReference, Reference};
use crate::target::{Memory, Target};

/// What a symbol table and a program do not have in common.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Unused {
    /// Symbols whose address no statement uses, in the order of the table.
    pub symbols: Vec<UnusedSymbol>,
    /// Addresses that the program uses and no symbol names, with their first use and how often.
    pub addresses: Vec<(Target, Reference, usize)>,
}

/// A symbol that no statement uses.
#[derive(Clone, Debug, PartialEq)]
pub struct UnusedSymbol {
    /// The symbol.
    pub symbol: Symbol,
    /// Addresses in use that share bits with it.
    pub overlaps: Vec<Memory>,
}

impl Unused {
    /// Compares a program with its symbol table.
    ///
    /// A block of the program counts as used by being there; user-defined types and what is no address are left out.
    pub fn new(compiled: &Compiled, references: &CrossReference, symbols: &SymbolTable) -> Self {
        let mut used: HashSet<Operand> = references.entries().filter_map(|(target, _)| target.operand()).collect();
        used.extend(compiled.program.code.keys().map(|&block| Operand::Block(block)));
        used.extend(compiled.program.data.keys().map(|&number| Operand::Block(BlockId::db(number))));
        // A data block that is only accessed with its number in front is used too.
        let named = references.entries().filter_map(|(target, _)| match target {
            Target::Memory(Memory { db: Some(db), .. }) => Some(Operand::Block(BlockId::db(*db))),
            _ => None,
        });
        used.extend(named.collect::<Vec<_>>());
        let overlaps = references.overlaps();
        let unused = symbols.symbols().iter().filter_map(|symbol| {
            let operand = symbol.operand()?;
            let skipped = matches!(operand, Operand::Block(BlockId { kind: BlockKind::UserDefinedType, .. }));
            if skipped || used.contains(&operand) {
                return None;
            }
            let overlaps = match Target::from(operand) {
                Target::Memory(memory) => overlaps.of(&memory),
                _ => Vec::new(),
            };
            Some(UnusedSymbol { symbol: symbol.clone(), overlaps })
        });
        let without = references.entries().filter(|(target, _)| wants_symbol(target));
        let without = without.filter(|(target, _)| {
            target.operand().and_then(|operand| symbols.find_operand(&operand)).is_none_or(|symbol| symbol.name.is_empty())
        });
        Self { symbols: unused.collect(), addresses: without.map(|(target, uses)| (target.clone(), uses[0].clone(), uses.len())).collect() }
    }
}

/// Whether a symbol table should name the target: global addresses and blocks of the user.
fn wants_symbol(target: &Target) -> bool {
    match target {
        Target::Memory(Memory { area, .. }) => {
            target.operand().is_some()
                && matches!(area, Area::Input | Area::Output | Area::BitMemory | Area::PeripheralInput | Area::PeripheralOutput)
        }
        Target::Timer(_) | Target::Counter(_) => true,
        Target::Block(block) => !matches!(block.kind, BlockKind::SystemFunction | BlockKind::SystemFunctionBlock),
        Target::Indirect(_) | Target::Local { .. } => false,
    }
}
