//! What a program uses and the screen shows without being asked: its bits, and its timers, counters, bytes, words and double words.

use std::collections::{BTreeMap, BTreeSet};

use sieben_lang::references::target::{Extent, Memory, Target};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::block::BlockId;
use sieben_model::types::DataType;
use sieben_sim::names::Name;
use sieben_workspace::session::Session;

/// Bytes whose bits are shown at most.
const BYTES_MAX: usize = 64;
/// Values of one block that are shown at most.
const VALUES_MAX: usize = 64;

/// The bits that a program or its symbols name, in the order of their addresses.
#[derive(Debug, Default)]
pub(super) struct Bits {
    /// Bytes of inputs, outputs and bit memory.
    pub(super) bytes: Vec<(Area, u32)>,
    /// The first bit, as the index of its byte and its number there.
    pub(super) first: (usize, u8),
}

impl Bits {
    pub(super) fn of(session: &Session) -> Self {
        let build = session.build();
        let compiled = &build.compiled;
        let named = compiled.bodies.values().flat_map(|body| body.named_bits());
        let symbols = build.project.symbols.symbols().iter().filter_map(|symbol| symbol.operand());
        let located = compiled.program.names.located.values().map(|(operand, _)| *operand);
        let operands = symbols.chain(located).filter_map(|operand| match operand {
            Operand::Address(Address { area, width: Width::Bit, byte, bit }) => Some((area, byte.saturating_mul(8) + u32::from(bit))),
            _ => None,
        });
        let shown = |area: &Area| matches!(area, Area::Input | Area::Output | Area::BitMemory);
        let bits: BTreeSet<(Area, u32)> = named.chain(operands).filter(|(area, _)| shown(area)).collect();
        let bytes: BTreeSet<(Area, u32)> = bits.iter().map(|&(area, position)| (area, position / 8)).collect();
        let first = bits.first().map_or(0, |(_, position)| (position % 8) as u8);
        Self { bytes: bytes.into_iter().take(BYTES_MAX).collect(), first: (0, first) }
    }
}

/// The timers, counters and values of memory that each block names, in the order in which it names them.
#[derive(Debug, Default)]
pub(super) struct Values {
    blocks: BTreeMap<BlockId, Vec<Name>>,
}

impl Values {
    pub(super) fn of(session: &Session) -> Self {
        let compiled = &session.build().compiled;
        let own = compiled.bodies.keys().filter(|block| !compiled.is_of_library(**block));
        let named = |block: &BlockId| {
            let mut operands: Vec<Operand> = Vec::new();
            for reference in compiled.references(*block) {
                if let Some(operand) = operand(&reference.target).filter(|operand| !operands.contains(operand)) {
                    operands.push(operand);
                }
            }
            operands.into_iter().take(VALUES_MAX).map(|operand| name(session, operand)).collect()
        };
        Self { blocks: own.map(|block| (*block, named(block))).collect() }
    }

    /// Those of this block first, then the others', each once.
    pub(super) fn from(&self, block: Option<BlockId>) -> Vec<&Name> {
        let here = block.and_then(|block| self.blocks.get(&block));
        let others = self.blocks.iter().filter(|(other, _)| Some(**other) != block).map(|(_, names)| names);
        let mut all: Vec<&Name> = Vec::new();
        for name in here.into_iter().chain(others).flatten() {
            if !all.iter().any(|known| known.operand() == name.operand()) {
                all.push(name);
            }
        }
        all
    }
}

/// The timer, counter, byte, word or double word that a reference means.
fn operand(target: &Target) -> Option<Operand> {
    match target {
        Target::Timer(number) => Some(Operand::Timer(*number)),
        Target::Counter(number) => Some(Operand::Counter(*number)),
        Target::Memory(Memory { area, db, position, extent }) => {
            let width = match extent {
                Extent::Width(width @ (Width::Byte | Width::Word | Width::DoubleWord)) => *width,
                Extent::Bits(8) => Width::Byte,
                Extent::Bits(16) => Width::Word,
                Extent::Bits(32) => Width::DoubleWord,
                _ => return None,
            };
            let address = Address { area: *area, width, byte: position / 8, bit: 0 };
            match (area, db) {
                (Area::SharedData, Some(db)) => Some(Operand::InDataBlock { db: *db, address }),
                (Area::Input | Area::Output | Area::BitMemory, None) => Some(Operand::Address(address)),
                _ => None,
            }
        }
        _ => None,
    }
}

/// The name of an operand in the language of the program, with the type that a symbol gives it; a field of a data block as it is declared.
fn name(session: &Session, operand: Operand) -> Name {
    if let Some(field) = session.fields().iter().find(|field| field.operand() == Some(&operand)) {
        return field.clone();
    }
    let symbols = session.build().project.symbols.symbols();
    let symbol = symbols.iter().find(|symbol| symbol.operand() == Some(operand));
    let data_type = symbol.and_then(|symbol| DataType::from_word(symbol.data_type.trim())).filter(DataType::is_elementary);
    Name::at(operand.spell(session.listing().places().mnemonics), operand, data_type.as_ref())
}
