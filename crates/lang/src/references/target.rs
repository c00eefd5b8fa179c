//! What a statement refers to.

use std::collections::BTreeMap;

use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::program::DataBlock;
use sieben_model::symbols::SymbolTable;

use super::variables::field_path;
use crate::access::AddressRegister;

/// What a statement refers to, in the order of a cross reference.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Target {
    /// Memory at a constant address.
    Memory(Memory),
    /// A timer.
    Timer(u16),
    /// A counter.
    Counter(u16),
    /// A block.
    Block(BlockId),
    /// Something whose address is computed at run time.
    Indirect(Indirect),
    /// A parameter or variable of a block, or its local data by address.
    Local {
        /// The block that declares it.
        block: BlockId,
        /// `#name.path`, or an address such as `LW 4` where nothing is declared.
        name: String,
    },
}

/// Memory at a constant address.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Memory {
    /// Which area; data of a block is always [`Area::SharedData`] when the block is named.
    pub area: Area,
    /// The data block; `None` for other areas and for whatever block is open.
    pub db: Option<u16>,
    /// The first bit: byte × 8 + bit.
    pub position: u32,
    /// How much.
    pub extent: Extent,
}

/// How much memory is referred to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Extent {
    /// As much as an instruction reads or writes.
    Width(Width),
    /// A whole variable or range, in bits.
    Bits(u32),
    /// Only where it begins is known: `P#M 10.0`.
    Unknown,
}

/// Something whose address is computed at run time.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Indirect {
    /// What kind of thing.
    pub reach: Reach,
    /// Where the address or number comes from.
    pub pointer: Pointer,
}

/// What an indirect operand may reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Reach {
    /// Memory; without an area it stands in the pointer too.
    Memory(Option<Area>, Width),
    /// Timers.
    Timer,
    /// Counters.
    Counter,
    /// Blocks of a kind.
    Block(BlockKind),
    /// Data blocks, through the DI register.
    InstanceBlock,
}

/// Where an address or number comes from.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Pointer {
    /// Memory or a variable.
    In(Box<Target>),
    /// AR1, with an offset in bits.
    Register1(u32),
    /// AR2, with an offset in bits.
    Register2(u32),
}

impl Pointer {
    /// A register with its offset.
    pub(crate) fn register(register: AddressRegister, offset: u32) -> Self {
        match register {
            AddressRegister::Ar1 => Self::Register1(offset),
            AddressRegister::Ar2 => Self::Register2(offset),
        }
    }
}

impl Memory {
    /// How many bits are known to belong to it.
    pub fn bits(&self) -> u32 {
        match self.extent {
            Extent::Width(width) => width.bits(),
            Extent::Bits(bits) => bits.max(1),
            Extent::Unknown => 1,
        }
    }

    /// One behind its last bit.
    pub fn end(&self) -> u32 {
        self.position.saturating_add(self.bits())
    }

    /// Whether both have a bit in common.
    pub fn overlaps(&self, other: &Self) -> bool {
        (self.area, self.db) == (other.area, other.db) && self.position < other.end() && other.position < self.end()
    }

    /// The address as an instruction or a symbol table has it; `None` for a range.
    pub fn operand(&self) -> Option<Operand> {
        let Extent::Width(width) = self.extent else { return None };
        let address = self.address(width);
        Some(match self.db {
            Some(db) => Operand::InDataBlock { db, address },
            None => Operand::Address(address),
        })
    }

    fn address(&self, width: Width) -> Address {
        let bit = if width == Width::Bit { (self.position % 8) as u8 } else { 0 };
        Address { area: self.area, width, byte: self.position / 8, bit }
    }

    fn spell(&self, mnemonics: Mnemonics) -> String {
        if let Some(operand) = self.operand() {
            return operand.spell(mnemonics);
        }
        let peripheral = matches!(self.area, Area::PeripheralInput | Area::PeripheralOutput);
        let start = match peripheral {
            true => format!("P {}.{}", self.position / 8, self.position % 8),
            false => self.address(Width::Bit).spell(mnemonics),
        };
        let block = self.db.map_or(String::new(), |db| format!("DB{db}."));
        match self.extent {
            Extent::Bits(bits) if bits % 8 == 0 && bits > 0 => format!("P#{block}{start} BYTE {}", bits / 8),
            Extent::Bits(bits) if bits > 0 => format!("P#{block}{start} BOOL {bits}"),
            _ => format!("P#{block}{start}"),
        }
    }
}

impl Reach {
    fn letters(self, mnemonics: Mnemonics) -> String {
        match self {
            Self::Memory(area, width) => {
                let prefix = area.map_or("", |area| area.prefix(mnemonics));
                match (width, area) {
                    (Width::Bit, Some(Area::SharedData | Area::InstanceData)) => format!("{prefix}X"),
                    _ => format!("{prefix}{}", width.letter()),
                }
            }
            Self::Timer => "T".to_owned(),
            Self::Counter if mnemonics == Mnemonics::German => "Z".to_owned(),
            Self::Counter => "C".to_owned(),
            Self::Block(kind) => kind.abbreviation().to_owned(),
            Self::InstanceBlock => "DI".to_owned(),
        }
    }
}

impl Target {
    /// The target as a statement in a mnemonic language writes it.
    pub fn spell(&self, mnemonics: Mnemonics) -> String {
        match self {
            Self::Memory(memory) => memory.spell(mnemonics),
            Self::Timer(number) => Operand::Timer(*number).spell(mnemonics),
            Self::Counter(number) => Operand::Counter(*number).spell(mnemonics),
            Self::Block(block) => block.to_string(),
            Self::Indirect(Indirect { reach, pointer }) => {
                let pointer = match pointer {
                    Pointer::In(target) => target.spell(mnemonics),
                    Pointer::Register1(offset) => format!("AR1,P#{}.{}", offset / 8, offset % 8),
                    Pointer::Register2(offset) => format!("AR2,P#{}.{}", offset / 8, offset % 8),
                };
                format!("{} [{pointer}]", reach.letters(mnemonics)).trim_start().to_owned()
            }
            Self::Local { name, .. } => name.clone(),
        }
    }

    /// The symbol of the target: of the symbol table, or a field of a data block with the symbol of the block.
    pub fn symbol(&self, symbols: &SymbolTable, data: &BTreeMap<u16, DataBlock>) -> Option<String> {
        let own = self.operand().and_then(|operand| symbols.find_operand(&operand));
        if let Some(symbol) = own.filter(|symbol| !symbol.name.is_empty()) {
            return Some(symbol.name.clone());
        }
        let Self::Memory(Memory { db: Some(db), position, extent, .. }) = self else { return None };
        let structure = &data.get(db)?.structure;
        let whole = (*position, *extent) == (0, Extent::Bits(structure.size.saturating_mul(8)));
        let block = symbols.find_operand(&Operand::Block(BlockId::db(*db))).filter(|symbol| !symbol.name.is_empty());
        let block = block.map_or_else(|| format!("DB{db}"), |symbol| symbol.name.clone());
        if whole {
            return Some(block);
        }
        Some(format!("{block}.{}", field_path(structure, u64::from(*position), (*extent).into())?))
    }

    /// The operand that a symbol table may name; `None` for ranges, locals and what is computed at run time.
    pub fn operand(&self) -> Option<Operand> {
        match self {
            Self::Memory(memory) => memory.operand(),
            Self::Timer(number) => Some(Operand::Timer(*number)),
            Self::Counter(number) => Some(Operand::Counter(*number)),
            Self::Block(block) => Some(Operand::Block(*block)),
            Self::Indirect(_) | Self::Local { .. } => None,
        }
    }

    /// Whether the target belongs to one block only.
    pub fn is_local(&self) -> bool {
        let local = |area: &Area| matches!(area, Area::Local | Area::CallerLocal);
        match self {
            Self::Local { .. } => true,
            Self::Memory(memory) => local(&memory.area),
            _ => false,
        }
    }
}

impl From<Operand> for Target {
    fn from(operand: Operand) -> Self {
        let memory = |db, address: Address| {
            // A byte number that no access reaches is kept at the end of what can be counted in bits.
            let position = address.byte.saturating_mul(8).saturating_add(u32::from(address.bit));
            Self::Memory(Memory { area: address.area, db, position, extent: Extent::Width(address.width) })
        };
        match operand {
            Operand::Address(address) => memory(None, address),
            Operand::InDataBlock { db, address } => memory(Some(db), address),
            Operand::Timer(number) => Self::Timer(number),
            Operand::Counter(number) => Self::Counter(number),
            Operand::Block(block) => Self::Block(block),
        }
    }
}
