//! The second step: all that the sources of a project declare.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use sieben_model::address::Operand;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::problems::Problem;
use sieben_model::program::DataBlock;
use sieben_model::source::Span;
use sieben_model::symbols::SymbolTable;

use super::data_blocks::{fill_data, missing_instances};
use super::headers::{Found, find_blocks};
use super::syntax::{Syntax, Tree};
use crate::declarations::data_block::DataLayout;
use crate::declarations::reuse::{Layouts, Reuse};
use crate::declarations::system::System;
use crate::declarations::types::{BlockInterface, Declares};
use crate::library::link::{Links, link};
use crate::library::{Linked, Selection};
use crate::options::Options;
use crate::scope::Scope;
use crate::st;
use crate::st::declare::{Globals, Items, Known, Needed, Own, StFile, Types, collect, library_file};
use crate::stl::ast;
use crate::stl::declare::Blocks;
use crate::stl::declare::data_block::layout;
use crate::stl::declare::path::FieldNames;
use crate::stl::extension;

/// The greatest number of an organization block.
const LAST_ORGANIZATION_BLOCK: u16 = 122;

/// What all declarations are made of.
pub(super) struct Parts<'a> {
    pub(super) symbols: &'a SymbolTable,
    pub(super) system: &'a System,
    pub(super) options: &'a Options,
    /// The sources of the user, in their order.
    pub(super) files: &'a [Arc<Syntax>],
    /// The sources of ST: the user's, then those of the library.
    pub(super) st: &'a [StFile],
    /// What of the library is needed.
    pub(super) needed: &'a Needed,
}

/// The blocks of a project and what they are called, before anything is laid out.
pub(super) struct Names<'a> {
    pub(super) scope: Scope,
    pub(super) cpu: CpuType,
    pub(super) items: Items<'a>,
    pub(super) links: Links,
    /// The blocks of STL; of a number that exists twice the first.
    pub(super) found: Vec<Found<'a>>,
    pub(super) blocks: Blocks<'a>,
    pub(super) system: &'a System,
    /// Which blocks and names there are, and all that does not belong to one block.
    pub(super) surroundings: u64,
}

impl<'a> Names<'a> {
    /// Finds the blocks of all sources and what they are called.
    pub(super) fn of(parts: &Parts<'a>, diagnostics: &mut Vec<Diagnostic>) -> Self {
        let options = parts.options;
        let mut cpu = options.cpu.copied().unwrap_or_default();
        let stl = parts.files.iter().filter_map(|syntax| match &syntax.tree {
            Tree::Stl(file) => Some((file, &**syntax)),
            _ => None,
        });
        if options.extended {
            cpu.accumulators = accumulators(&cpu, stl.clone().flat_map(|(file, _)| &file.file.blocks), diagnostics);
        }
        let mut scope = Scope::new(parts.symbols, &options.system_blocks);
        scope.tells_lost = options.tells_lost;
        scope.extended = options.extended;
        let blocks: Vec<Found<'_>> = stl.flat_map(|(file, syntax)| Found::all(file, syntax)).collect();
        if options.syntax_only {
            number_named(&blocks, &mut scope, &cpu);
        }
        let found = find_blocks(blocks.into_iter(), &scope, &cpu, options.replacing, diagnostics);
        let mut taken: HashMap<BlockId, Span> = found.iter().map(|found| (found.id, found.block.name.span())).collect();
        let items = collect(parts.st, &mut scope, &cpu, options.replacing, &mut taken, diagnostics);
        let defined: HashSet<BlockId> = taken.keys().copied().collect();
        // One file alone does not tell whether another one defines a block that STL names; what a dialect of ST brings along is always there.
        let selection = Selection { enabled: options.library.enabled || options.syntax_only, ..options.library.clone() };
        let mentions = found.iter().filter(|_| !options.syntax_only).flat_map(|found| found.mentions);
        let links = link(mentions, &parts.needed.blocks, &defined, &mut scope, &selection, &cpu);
        let mut names = Self { scope, cpu, items, links, found, blocks: HashMap::new(), system: parts.system, surroundings: 0 };
        names.surroundings = names.hash(parts);
        names
    }

    /// The linked blocks with their places among the sources, from this one on.
    pub(super) fn linked(&self, first: usize) -> Vec<Linked> {
        self.links.iter().enumerate().map(|(index, (&id, &block))| Linked { id, block, file: library_file(first, index) }).collect()
    }

    /// Takes in the linked blocks, parsed.
    pub(super) fn add_library(&mut self, library: &'a [(BlockId, Arc<Syntax>)]) {
        for (id, syntax) in library {
            if let Tree::Stl(file) = &syntax.tree {
                assert_eq!(file.file.blocks.len(), 1, "each source of the library holds one block");
                self.found.extend(Found::all(file, syntax).map(|found| Found { id: *id, ..found }));
            }
        }
        self.blocks = self.found.iter().map(|found| (found.id, (found.block, found.stamp))).collect();
    }

    /// What does not belong to one block: when this changes, every block is checked again.
    fn hash(&self, parts: &Parts<'_>) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.cpu.accumulators.hash(&mut hasher);
        for found in &self.found {
            (found.id, found.block.implicit, found.mnemonics).hash(&mut hasher);
            if let ast::BlockName::Symbol(word) = &found.block.name {
                word.text.hash(&mut hasher);
            }
        }
        // A block of the library that only its number is written of has no name.
        self.links.iter().for_each(|(id, block)| (id, self.scope.block(block.name)).hash(&mut hasher));
        parts.files.iter().for_each(|syntax| syntax.rest.hash(&mut hasher));
        parts.needed.sources.iter().for_each(|source| source.path.hash(&mut hasher));
        self.items.hash_names(&mut hasher);
        hasher.finish()
    }

    /// Lays out everything that is declared. The order of the sources does not matter, types resolve one another. What `before` says of
    /// blocks that are the same holds, unless something is wrong now: then all is laid out, so that all is said. So it is where the order matters.
    pub(super) fn declare(&self, before: &Layouts<Own>) -> Declared {
        let trusting = before.surroundings == Some(self.surroundings);
        let suggestions = self.scope.suggestions();
        let mut declared = self.lay_out(Reuse::new(before, trusting));
        if trusting && (declared.is_wrong() || declared.layouts.asked_outside != before.asked_outside) {
            // The suggestions of the first attempt are not said.
            self.scope.take_back_suggestions(suggestions);
            declared = self.lay_out(Reuse::new(before, false));
        }
        let holds = !declared.is_wrong() && !declared.layouts.depends_on_order;
        declared.layouts.surroundings = holds.then_some(self.surroundings);
        declared.layouts.version_data(before, &declared.data);
        declared
    }

    fn lay_out(&self, reuse: Reuse<'_, Own>) -> Declared {
        let Self { scope, items, found, blocks, system, .. } = self;
        let languages: [&dyn Declares<'_, _>; 2] = [items, blocks];
        let mut types = Types::new(scope, &languages, system, reuse);
        let mut interfaces: HashMap<BlockId, BlockInterface> =
            system.iter().map(|(&block, resident)| (block, resident.interface.clone())).collect();
        let mut data: HashMap<u16, DataLayout> = HashMap::new();
        for Found { id, block, .. } in found {
            match id.kind {
                BlockKind::UserDefinedType => {
                    types.udt(id.number, block.name.span());
                }
                BlockKind::DataBlock => {
                    if let Some(layout) = layout(&mut types, id.number, block) {
                        data.insert(id.number, layout);
                    }
                }
                _ => {
                    if let Some(interface) = types.interface(*id, block.name.span()) {
                        interfaces.insert(*id, interface);
                    }
                }
            }
        }
        for (&id, code) in &items.code {
            if let Some(interface) = types.interface(id, code.block.name.span) {
                interfaces.insert(id, interface);
            }
        }
        let globals = st::declare::layouts(&mut types, items, &mut data);
        st::declare::all_types(&mut types, items);
        let generated = missing_instances(found, items, scope, &interfaces, &mut data, blocks, &mut types.diagnostics);
        let field_names = FieldNames::default();
        let mut filled = BTreeMap::new();
        fill_data(&mut types, &field_names, found, items, &data, &generated, &mut filled);
        let Types { known, diagnostics, reuse, .. } = types;
        Declared { interfaces, data, filled, field_names, known, globals, diagnostics, layouts: reuse.finish() }
    }
}

/// What the sources of a project declare, laid out.
pub(super) struct Declared {
    /// Interfaces of all code and system blocks that could be laid out.
    pub(super) interfaces: HashMap<BlockId, BlockInterface>,
    /// Layouts of the data blocks.
    pub(super) data: HashMap<u16, DataLayout>,
    /// The data blocks with their bytes.
    pub(super) filled: BTreeMap<u16, DataBlock>,
    pub(super) field_names: FieldNames,
    /// What names of ST stand for.
    pub(super) known: Known,
    pub(super) globals: Globals,
    pub(super) diagnostics: Vec<Diagnostic>,
    /// What the next revision may take as it is.
    pub(super) layouts: Layouts<Own>,
}

impl Declared {
    fn is_wrong(&self) -> bool {
        self.diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error)
    }
}

/// Gives the blocks a number whose symbols stand in a table that one file alone does not have: they are looked at like any other.
fn number_named(blocks: &[Found<'_>], scope: &mut Scope, cpu: &CpuType) {
    let of_blocks = blocks.iter().filter_map(|found| match &found.block.name {
        ast::BlockName::Absolute { kind, number, .. } => Some(BlockId::new(*kind, u16::try_from(*number).ok()?)),
        ast::BlockName::Symbol(_) => None,
    });
    let of_scope = scope.operands().filter_map(|operand| match operand {
        Operand::Block(id) => Some(id),
        _ => None,
    });
    let taken: HashSet<BlockId> = of_blocks.chain(of_scope).collect();
    let free = |kind: BlockKind| -> Vec<BlockId> {
        let last = match kind {
            BlockKind::OrganizationBlock => LAST_ORGANIZATION_BLOCK,
            BlockKind::DataBlock => cpu.db_number_max,
            _ => cpu.fc_number_max,
        };
        let can_be = |id: &BlockId| !taken.contains(id) && (kind != BlockKind::OrganizationBlock || cpu.has_organization_block(id.number));
        // The lowest ones are handed out last.
        (1..=last).map(|number| BlockId::new(kind, number)).filter(can_be).collect()
    };
    let mut numbers: HashMap<BlockKind, Vec<BlockId>> = HashMap::new();
    for found in blocks {
        let ast::BlockName::Symbol(word) = &found.block.name else { continue };
        if word.text.is_empty() || scope.global(&word.text).is_some() {
            continue;
        }
        let kind = found.block.kind;
        if let Some(id) = numbers.entry(kind).or_insert_with(|| free(kind)).pop() {
            scope.define_block(&word.text, &word.text, id);
        }
    }
}

/// The accumulators of the CPU type, or those that the program asks for with `__FEATURE 0`.
///
/// Code is made for one number of them. A program that asks for both gets what its CPU type has, and the other only in the
/// same block after the statement that asks.
fn accumulators<'a>(cpu: &CpuType, blocks: impl Iterator<Item = &'a ast::Block>, diagnostics: &mut Vec<Diagnostic>) -> u8 {
    let asked = extension::accumulators_asked(blocks);
    let Some(&(first, first_span)) = asked.first() else { return cpu.accumulators };
    let Some(&(_, span)) = asked.iter().find(|&&(other, _)| other != first) else { return first };
    let message =
        "this asks for another number of accumulators than the program did before; it holds for the statements behind it in this block";
    diagnostics.push(Diagnostic::new(Problem::P2042, span, message).related(first_span, "the other one is asked for here"));
    cpu.accumulators
}
