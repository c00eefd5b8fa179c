//! What the names of all texts of a project stand for.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::block::BlockId;

use super::{Access, Definition, DefinitionKind, NameId, SourceNames, TypeRef, Written};
use crate::scope::key;

/// Blocks that extend one another, types of types, members of members: more of them is a circle.
const STEPS_MAX: u32 = 32;

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DefId {
    /// A definition of a text: a variable, a label, a type, a block without a number, a symbol with an address.
    Definition {
        /// The text.
        text: u32,
        /// The definition there.
        index: u32,
    },
    /// A block with a number, whatever its names are.
    Block(BlockId),
    /// An address, a timer or a counter.
    Operand(Operand),
}

/// Where something is defined: the text, and the definition there.
pub type At = (u32, u32);

/// The names of a project.
#[derive(Clone, Debug, Default)]
pub struct Names {
    texts: Vec<Arc<SourceNames>>,
    /// Everything global but symbols, by its name.
    globals: HashMap<Box<str>, Vec<At>>,
    /// Symbols by their names.
    symbols: HashMap<Box<str>, At>,
    /// Symbols by their addresses.
    addressed: HashMap<Operand, Vec<At>>,
    /// Blocks by their numbers: headers first, then symbols.
    blocks: HashMap<BlockId, Vec<At>>,
}

/// How a use is come by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Through {
    /// By the name.
    Name,
    /// By the address.
    Address,
    /// By an address that has bits in common with it.
    Overlap,
    /// By a pointer that may lead to it.
    Pointer,
}

/// A use of something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Found {
    /// The text.
    pub text: u32,
    /// The occurrence there.
    pub occurrence: u32,
    /// How it is come by.
    pub through: Through,
}

impl Names {
    /// The names of these texts.
    pub fn new(texts: Vec<Arc<SourceNames>>) -> Self {
        let mut names = Self::default();
        for (text, source) in texts.iter().enumerate() {
            for (index, definition) in source.definitions.iter().enumerate() {
                let at = (text as u32, index as u32);
                if definition.kind == DefinitionKind::Symbol {
                    names.symbols.entry(source.name(definition.id).into()).or_insert(at);
                    if let Some(operand) = definition.operand {
                        names.addressed.entry(operand).or_default().push(at);
                    }
                    continue;
                }
                let is_global = !source.is_test
                    && match definition.parent.and_then(|parent| source.definition(parent)) {
                        None => !matches!(definition.kind, DefinitionKind::Label | DefinitionKind::Test),
                        Some(parent) => parent.kind == DefinitionKind::Group || definition.kind == DefinitionKind::EnumValue,
                    };
                if is_global {
                    names.globals.entry(source.name(definition.id).into()).or_default().push(at);
                    if let Some(Operand::Block(block)) = definition.operand {
                        names.blocks.entry(block).or_default().push(at);
                    }
                }
            }
        }
        names.texts = texts;
        // A block whose header has a symbol has the number that the table gives it.
        for (name, at) in &names.symbols {
            let Some(Operand::Block(block)) = names.definition_at(*at).and_then(|row| row.operand) else { continue };
            let headers = names.globals.get(name).into_iter().flatten().filter(|at| names.is_block(**at)).copied().collect::<Vec<_>>();
            names.blocks.entry(block).or_default().extend(headers);
        }
        for (operand, rows) in &names.addressed {
            if let Operand::Block(block) = operand {
                names.blocks.entry(*block).or_default().extend(rows);
            }
        }
        names
    }

    fn is_block(&self, at: At) -> bool {
        use DefinitionKind::*;
        self.definition_at(at).is_some_and(|one| {
            one.operand.is_none() && matches!(one.kind, OrganizationBlock | Program | Function | FunctionBlock | DataBlock | Type)
        })
    }

    /// The texts.
    pub fn texts(&self) -> &[Arc<SourceNames>] {
        &self.texts
    }

    /// A text.
    pub fn text(&self, text: u32) -> Option<&SourceNames> {
        self.texts.get(text as usize).map(|text| &**text)
    }

    /// A definition.
    pub fn definition_at(&self, (text, index): At) -> Option<&Definition> {
        self.text(text)?.definition(index)
    }

    /// All global names that are no symbols, with where they are defined.
    pub fn globals(&self) -> impl Iterator<Item = (&str, &[At])> {
        self.globals.iter().map(|(name, at)| (&**name, at.as_slice()))
    }

    /// All symbols, with their rows.
    pub fn symbols(&self) -> impl Iterator<Item = (&str, At)> {
        self.symbols.iter().map(|(name, at)| (&**name, *at))
    }

    /// All blocks with a number.
    pub fn blocks(&self) -> impl Iterator<Item = (BlockId, &[At])> {
        self.blocks.iter().map(|(block, at)| (*block, at.as_slice()))
    }

    /// The symbol of an address or block.
    pub fn symbol_of(&self, operand: Operand) -> Option<&Definition> {
        self.addressed.get(&operand)?.first().and_then(|at| self.definition_at(*at))
    }

    /// The row of a symbol.
    pub fn symbol(&self, name: &str) -> Option<At> {
        self.symbols.get(key(name).as_str()).copied()
    }

    /// What a definition is, whatever else defines the same.
    pub fn of_definition(&self, (text, index): At) -> Option<DefId> {
        let source = self.text(text)?;
        let definition = source.definition(index)?;
        if let Some(Operand::Block(block)) = definition.operand {
            return Some(DefId::Block(block));
        }
        if self.is_block((text, index))
            && !source.is_test
            && definition.parent.is_none()
            && let Some(Operand::Block(block)) =
                self.symbols.get(source.name(definition.id)).and_then(|at| self.definition_at(*at)).and_then(|row| row.operand)
        {
            return Some(DefId::Block(block));
        }
        Some(DefId::Definition { text, index })
    }

    /// What a global name stands for.
    pub fn global(&self, name: &str) -> Option<DefId> {
        let name = key(name);
        let at = self.symbols.get(name.as_str()).or_else(|| self.globals.get(name.as_str())?.first())?;
        self.of_definition(*at)
    }

    /// All that the user's texts define globally under a name.
    pub fn all_global(&self, name: &str) -> Vec<DefId> {
        let name = key(name);
        let all = self.globals.get(name.as_str()).into_iter().flatten().chain(self.symbols.get(name.as_str()));
        let own = all.filter(|at| self.text(at.0).is_some_and(|text| !text.is_built_in));
        let mut found: Vec<DefId> = own.filter_map(|at| self.of_definition(*at)).collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// What an occurrence stands for.
    pub fn resolve(&self, text: u32, occurrence: u32) -> Option<DefId> {
        self.resolved(text, occurrence, 0)
    }

    fn resolved(&self, text: u32, occurrence: u32, steps: u32) -> Option<DefId> {
        let source = self.text(text)?;
        let one = source.occurrence(occurrence)?;
        if steps > STEPS_MAX {
            return None;
        }
        match one.written {
            Written::Definition(index) => self.of_definition((text, index)),
            Written::Local(id) => self.local(text, one.scope, id),
            Written::Plain(id) => self.local(text, one.scope, id).or_else(|| self.own_or_global(text, id)),
            Written::Global(id) => self.own_or_global(text, id),
            Written::Label(id) => {
                let is_label = |&&member: &&u32| {
                    source.definition(member).is_some_and(|member| member.id == id && member.kind == DefinitionKind::Label)
                };
                let index = *source.definition(one.scope?)?.members.iter().find(is_label)?;
                Some(DefId::Definition { text, index })
            }
            Written::Member(of, id) => self.member(self.resolved(text, of, steps + 1)?, source.name(id)),
            Written::Parameter(of, id) => self.member(self.resolved(text, of, steps + 1)?, source.name(id)),
            Written::Operand(Operand::Block(block)) => Some(DefId::Block(block)),
            Written::Operand(operand) => Some(DefId::Operand(operand)),
            Written::InBlock(of, address) => match self.resolved(text, of, steps + 1)? {
                DefId::Block(BlockId { number, .. }) => {
                    Some(DefId::Operand(Operand::InDataBlock { db: number, address: Address { area: Area::SharedData, ..address } }))
                }
                _ => None,
            },
            Written::Range(area, db, position, 1) => {
                let address = Address { area, width: Width::Bit, byte: position / 8, bit: (position % 8) as u8 };
                Some(DefId::Operand(match db {
                    Some(db) => Operand::InDataBlock { db, address },
                    None => Operand::Address(address),
                }))
            }
            Written::Range(..) | Written::Indirect(_) => None,
        }
    }

    /// What a test file declares itself, or else something global.
    fn own_or_global(&self, text: u32, id: NameId) -> Option<DefId> {
        let source = self.text(text)?;
        if source.is_test {
            let own = source.defined.get(id as usize).into_iter().flatten();
            let mut own =
                own.filter(|&&index| source.definition(index).is_some_and(|one| one.parent.is_none() && one.kind != DefinitionKind::Test));
            if let Some(&index) = own.next() {
                return Some(DefId::Definition { text, index });
            }
        }
        self.global(source.name(id))
    }

    /// What a block declares under a name, or what it belongs to or extends.
    pub fn local(&self, text: u32, scope: Option<u32>, id: NameId) -> Option<DefId> {
        let source = self.text(text)?;
        let mut scope = scope;
        while let Some(index) = scope {
            let block = source.definition(index)?;
            let is_meant =
                |&&member: &&u32| source.definition(member).is_some_and(|member| member.id == id && member.kind != DefinitionKind::Label);
            if let Some(&member) = block.members.iter().find(is_meant) {
                return Some(DefId::Definition { text, index: member });
            }
            if block.id == id && matches!(block.kind, DefinitionKind::Function | DefinitionKind::Method | DefinitionKind::Property) {
                return self.of_definition((text, index));
            }
            if (block.kind == DefinitionKind::DataBlock || !block.extends.is_empty())
                && let Some(found) = self.member_of((text, index), source.name(id), 0)
            {
                return Some(found);
            }
            scope = block.parent;
        }
        None
    }

    /// A member of something, by its name.
    pub fn member(&self, of: DefId, name: &str) -> Option<DefId> {
        self.heads(of).into_iter().find_map(|at| self.member_of(at, name, 0))
    }

    /// The definitions of something that may have members.
    pub fn heads(&self, of: DefId) -> Vec<At> {
        match of {
            DefId::Definition { text, index } => vec![(text, index)],
            DefId::Block(block) => {
                let mut heads = self.blocks.get(&block).cloned().unwrap_or_default();
                // A block of the project takes the place of one of the library with its number.
                let is_own = |at: &At| {
                    self.text(at.0).is_some_and(|text| !text.is_built_in)
                        && self.definition_at(*at).is_some_and(|one| one.kind != DefinitionKind::Symbol)
                };
                if heads.iter().any(is_own) {
                    heads.retain(|at| self.text(at.0).is_some_and(|text| !text.is_built_in));
                }
                heads
            }
            DefId::Operand(operand) => self.addressed.get(&operand).cloned().unwrap_or_default(),
        }
    }

    fn member_of(&self, at: At, name: &str, steps: u32) -> Option<DefId> {
        let source = self.text(at.0)?;
        let definition = source.definition(at.1)?;
        if steps > STEPS_MAX {
            return None;
        }
        if let Some(id) = source.id(name) {
            let is_meant =
                |&&member: &&u32| source.definition(member).is_some_and(|member| member.id == id && member.kind != DefinitionKind::Label);
            // Members of a function's result are those of its type.
            if let Some(&index) = definition.members.iter().find(is_meant) {
                return self.of_definition((at.0, index));
            }
        }
        let extended = definition.extends.iter().filter_map(|&id| self.global(source.name(id)));
        let heads = |of: DefId| self.heads(of).into_iter().filter(|head| *head != at).collect::<Vec<_>>();
        self.type_of(at).into_iter().chain(extended).flat_map(heads).find_map(|head| self.member_of(head, name, steps + 1))
    }

    /// The type that a definition has by its name or number.
    pub fn type_of(&self, (text, index): At) -> Option<DefId> {
        let source = self.text(text)?;
        match source.definition(index)?.of {
            TypeRef::None | TypeRef::Inline => None,
            TypeRef::Block(block) => Some(DefId::Block(block)),
            TypeRef::Named(id) => self.global(source.name(id)),
        }
    }

    /// All members of something: its own, those of its type and of what it extends.
    pub fn members(&self, of: DefId) -> Vec<At> {
        let mut found = Vec::new();
        let mut heads = self.heads(of);
        let mut seen = Vec::new();
        while let Some(at) = heads.pop() {
            if seen.contains(&at) || seen.len() > STEPS_MAX as usize {
                continue;
            }
            seen.push(at);
            let Some(source) = self.text(at.0) else { continue };
            let Some(definition) = source.definition(at.1) else { continue };
            found.extend(definition.members.iter().map(|&member| (at.0, member)));
            let extended = definition.extends.iter().filter_map(|&id| self.global(source.name(id)));
            heads.extend(self.type_of(at).into_iter().chain(extended).flat_map(|of| self.heads(of)));
        }
        found
    }

    /// How an occurrence is used: an actual parameter as its parameter says.
    pub fn access(&self, text: u32, occurrence: u32) -> Access {
        let Some(source) = self.text(text) else { return Access::Read };
        let Some(one) = source.occurrence(occurrence) else { return Access::Read };
        if one.access != Access::Argument {
            return one.access;
        }
        // The parameter stands before it.
        let before = (0..occurrence)
            .rev()
            .take(64)
            .find(|&index| source.occurrence(index).is_some_and(|one| matches!(one.written, Written::Parameter(..))));
        let Some(DefId::Definition { text, index }) = before.and_then(|parameter| self.resolve(text, parameter)) else {
            return Access::Read;
        };
        match self.definition_at((text, index)).map(|parameter| parameter.kind) {
            Some(DefinitionKind::Output | DefinitionKind::Result) => Access::Write,
            Some(DefinitionKind::InOut) => Access::ReadWrite,
            _ => Access::Read,
        }
    }

    /// The address that something has.
    pub fn operand(&self, of: DefId) -> Option<Operand> {
        match of {
            DefId::Operand(operand) => Some(operand),
            DefId::Block(block) => Some(Operand::Block(block)),
            DefId::Definition { text, index } => self.definition_at((text, index))?.operand,
        }
    }

    /// The names that something is written by, as keys.
    pub fn names_of(&self, of: DefId) -> Vec<&str> {
        let mut names: Vec<&str> = self
            .heads(of)
            .into_iter()
            .filter_map(|(text, index)| Some(self.text(text)?.name(self.definition_at((text, index))?.id)))
            .collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    /// All uses of something by its names; those in one text alone if it is given.
    pub fn named_uses(&self, of: DefId, only: Option<u32>) -> Vec<Found> {
        let names = self.names_of(of);
        let mut found = Vec::new();
        for (text, source) in self.texts_of(of, only) {
            for name in &names {
                for &occurrence in source.occurrences_of(name) {
                    if self.resolve(text, occurrence) == Some(of) {
                        found.push(Found { text, occurrence, through: Through::Name });
                    }
                }
            }
        }
        found
    }

    /// The texts that can use something.
    fn texts_of(&self, of: DefId, only: Option<u32>) -> impl Iterator<Item = (u32, &SourceNames)> {
        let own = match of {
            DefId::Definition { text, index } => self
                .definition_at((text, index))
                .filter(|one| matches!(one.kind, DefinitionKind::Label | DefinitionKind::Temp))
                .map(|_| text),
            _ => None,
        };
        let all = self.texts.iter().enumerate().map(|(text, source)| (text as u32, &**source));
        all.filter(move |(text, source)| !source.is_built_in && only.or(own).is_none_or(|only| only == *text))
    }

    /// All uses of something, also by its address, by what overlaps it, and by pointers that may lead to it.
    pub fn uses(&self, of: DefId, only: Option<u32>) -> Vec<Found> {
        // A symbol stands for its address: what else does is the same.
        let mut found = self.named_uses(of, only);
        let Some(operand) = self.operand(of) else {
            found.sort_unstable();
            return found;
        };
        if let DefId::Operand(operand) = of {
            let rows = self.addressed.get(&operand).into_iter().flatten();
            let symbols = rows.filter_map(|at| self.of_definition(*at)).filter(|symbol| *symbol != of);
            found.extend(symbols.flat_map(|symbol| self.named_uses(symbol, only)));
        }
        let named: HashSet<(u32, u32)> = found.iter().map(|found| (found.text, found.occurrence)).collect();
        let memory = memory_of(operand);
        for (text, source) in self.texts_of(of, only) {
            for &occurrence in source.addresses() {
                let Some(one) = source.occurrence(occurrence) else { continue };
                let through = match one.written {
                    Written::Operand(other) if other == operand => Some(Through::Address),
                    Written::Operand(other) => overlap(memory, memory_of(other)),
                    Written::InBlock(..) => match self.resolve(text, occurrence) {
                        Some(DefId::Operand(other)) if other == operand => Some(Through::Address),
                        Some(DefId::Operand(other)) => overlap(memory, memory_of(other)),
                        _ => None,
                    },
                    Written::Range(area, db, position, bits) => overlap(memory, Some((area, db, position, bits))),
                    Written::Indirect(Some(area)) => memory.filter(|&(own, db, ..)| own == area && db.is_none()).map(|_| Through::Pointer),
                    Written::Indirect(None) => memory.map(|_| Through::Pointer),
                    Written::Definition(index) => match source.definition(index).and_then(|one| one.operand) {
                        Some(other) if other == operand => Some(Through::Address),
                        Some(other) => overlap(memory, memory_of(other)),
                        None => None,
                    },
                    _ => None,
                };
                let is_there = || named.contains(&(text, occurrence));
                if let Some(through) = through.filter(|&through| through == Through::Pointer || !is_there()) {
                    found.push(Found { text, occurrence, through });
                }
            }
        }
        found.sort_unstable();
        found.dedup_by_key(|found| (found.text, found.occurrence));
        found
    }
}

/// Area, data block, first bit and number of bits.
type Memory = (Area, Option<u16>, u32, u32);

fn memory_of(operand: Operand) -> Option<Memory> {
    let (db, address) = match operand {
        Operand::Address(address) => (None, address),
        Operand::InDataBlock { db, address } => (Some(db), address),
        Operand::Timer(_) | Operand::Counter(_) | Operand::Block(_) => return None,
    };
    // Inputs and outputs of the peripheral are those of the process image.
    let area = match address.area {
        Area::PeripheralInput => Area::Input,
        Area::PeripheralOutput => Area::Output,
        other => other,
    };
    // Local data is each block's own.
    if matches!(area, Area::Local | Area::CallerLocal | Area::InstanceData) || (area == Area::SharedData && db.is_none()) {
        return None;
    }
    Some((area, db, address.byte.saturating_mul(8).saturating_add(u32::from(address.bit)), address.width.bits()))
}

fn overlap(one: Option<Memory>, other: Option<Memory>) -> Option<Through> {
    let ((area, db, start, bits), (other_area, other_db, other_start, other_bits)) = (one?, other?);
    let shares = start < other_start.saturating_add(other_bits) && other_start < start.saturating_add(bits);
    ((area, db) == (other_area, other_db) && shares).then_some(Through::Overlap)
}
