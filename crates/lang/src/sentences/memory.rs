//! Which address a location means at a moment, and what lies there.

use sieben_engine::Machine;
use sieben_engine::machine::{CALLS_MASK, CALLS_SHIFT, Frame, Register, Registers};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;

use crate::access::{AddressRegister, Location, NumberOperand};

/// An address that a location came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Found {
    pub(crate) area: Area,
    /// In bits; in V with the count of calls in its upper bits.
    pub(crate) position: u32,
    /// The data block, for areas DB and DI.
    pub(crate) db: u16,
}

impl Found {
    /// The address in the spelling of a mnemonic language: `M 13.1`, `DB10.DBW 2`.
    pub(crate) fn spell(&self, width: Width, mnemonics: Mnemonics) -> String {
        self.operand(width).spell(mnemonics)
    }

    pub(crate) fn operand(&self, width: Width) -> Operand {
        let position = if self.area == Area::CallerLocal { self.position & CALLS_MASK } else { self.position };
        let bit = if width == Width::Bit { (position & 7) as u8 } else { 0 };
        let address = Address { area: self.area, width, byte: position >> 3, bit };
        match self.area {
            Area::SharedData | Area::InstanceData if self.db != 0 => {
                Operand::InDataBlock { db: self.db, address: Address { area: Area::SharedData, ..address } }
            }
            _ => Operand::Address(address),
        }
    }
}

/// Why a location came to no address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Trouble {
    /// It cannot be told.
    Unknown,
    /// The statement failed with this event.
    Fault(u16),
}

/// What a location is read with: the registers before a statement, and a machine with its block among the frames.
pub(crate) struct Reader<'a> {
    pub(crate) machine: &'a Machine,
    pub(crate) registers: &'a Registers,
    /// Index of the frame of the block of the statement.
    pub(crate) frame: Option<usize>,
}

impl<'a> Reader<'a> {
    /// For a statement of `block`; `called` tells that the newest frame is what the statement itself called.
    pub(crate) fn new(machine: &'a Machine, registers: &'a Registers, block: BlockId, called: bool) -> Self {
        let mut frames = machine.frames.iter().enumerate().rev();
        if called {
            frames.next();
        }
        let frame = frames.find(|(_, frame)| frame.block == block).map(|(index, _)| index);
        Self { machine, registers, frame }
    }

    fn frame(&self) -> Option<&'a Frame> {
        self.machine.frames.get(self.frame?)
    }

    /// Where a location leads, and the pointer that led there.
    pub(crate) fn find(&self, location: &Location, write: bool) -> Result<Found, Trouble> {
        let registers = self.registers;
        let found = |area: Area, position: u32| Found { area, position, db: self.open_block(area) };
        match location {
            Location::Fixed { area, position } => Ok(found(*area, *position)),
            Location::InDataBlock { db, position } => Ok(Found { area: Area::SharedData, position: *position, db: *db }),
            Location::InInstanceBlock { db, position } => Ok(Found { area: Area::InstanceData, position: *position, db: *db }),
            Location::MemoryIndirect { area, pointer } => {
                let pointer = self.read(&self.find(pointer, false)?, Width::DoubleWord).ok_or(Trouble::Unknown)?;
                Ok(found(*area, moved(pointer, 0)))
            }
            Location::RegisterIndirect { area, register, offset } => {
                let pointer = registers.get(address_register(*register));
                let area = match area {
                    Some(area) => *area,
                    None => pointed(pointer, write)?,
                };
                Ok(found(area, moved(pointer, *offset)))
            }
            Location::Parameter { index, offset, complex: false } => {
                let pointer = self.parameter(*index).ok_or(Trouble::Unknown)?;
                Ok(found(pointed(pointer, write)?, moved(pointer, *offset)))
            }
            Location::Parameter { index, offset, complex: true } => {
                let pointer = self.parameter(*index).ok_or(Trouble::Unknown)?;
                let at = found(pointed(pointer, false)?, moved(pointer, 0));
                self.behind_pointer(at, *offset, write)
            }
            Location::InstancePointer { position, offset } => {
                self.behind_pointer(found(Area::InstanceData, moved(registers.ar2, *position)), *offset, write)
            }
            Location::Instance { position } => Ok(found(Area::InstanceData, moved(registers.ar2, *position))),
        }
    }

    /// Behind a POINTER that lies at an address.
    fn behind_pointer(&self, at: Found, offset: u32, write: bool) -> Result<Found, Trouble> {
        let number = self.read(&at, Width::Word).ok_or(Trouble::Unknown)?;
        let pointer = self.read(&Found { position: at.position + 16, ..at }, Width::DoubleWord).ok_or(Trouble::Unknown)?;
        let area = pointed(pointer, write)?;
        let db = if area == Area::SharedData { number as u16 } else { self.open_block(area) };
        Ok(Found { area, position: moved(pointer, offset), db })
    }

    fn open_block(&self, area: Area) -> u16 {
        match area {
            Area::SharedData => self.registers.db_number as u16,
            Area::InstanceData => self.registers.di_number as u16,
            _ => 0,
        }
    }

    /// What the caller gave for a parameter of a function.
    pub(crate) fn parameter(&self, index: u16) -> Option<u64> {
        let frame = self.frame()?;
        let at = frame.parameters.checked_add(u32::from(index)).filter(|&at| at < frame.parameters_end)?;
        self.machine.parameters.get(at as usize).map(|&pointer| u64::from(pointer))
    }

    /// What lies at an address, of at most 64 bits; `None` outside of the memory.
    pub(crate) fn read(&self, found: &Found, width: Width) -> Option<u64> {
        let memory = &self.machine.memory;
        let (range, position) = match found.area {
            Area::PeripheralInput | Area::PeripheralOutput => return None,
            Area::SharedData | Area::InstanceData => {
                let entry = memory.data_block(u64::from(found.db))?;
                (entry.base as usize..(entry.base + entry.length) as usize, found.position)
            }
            Area::Local => (self.local(0)?, found.position),
            Area::CallerLocal => (self.local(1 + (found.position >> CALLS_SHIFT) as usize)?, found.position & CALLS_MASK),
            area => (memory.layout.area(area)?, found.position),
        };
        let at = range.start + (position >> 3) as usize;
        let end = at.checked_add(width.bytes() as usize)?;
        (end <= range.end && end <= memory.arena.len()).then(|| memory.read_wide(at, (position & 7) as u8, width))
    }

    /// Whether an address lies inside of its area. What cannot be told counts as inside.
    pub(crate) fn is_inside(&self, found: &Found, width: Width) -> bool {
        match found.area {
            Area::PeripheralInput | Area::PeripheralOutput => true,
            Area::Local | Area::CallerLocal if self.frame().is_none() => true,
            _ => self.read(found, width).is_some(),
        }
    }

    fn local(&self, outwards: usize) -> Option<std::ops::Range<usize>> {
        let frame = self.machine.frames.get(self.frame?.checked_sub(outwards)?)?;
        let start = self.machine.memory.layout.local.start + frame.local_base as usize;
        Some(start..start + frame.local_size as usize)
    }

    /// The number of a timer, counter or block.
    pub(crate) fn number(&self, number: &NumberOperand) -> Option<u16> {
        match number {
            NumberOperand::Fixed(number) => Some(*number),
            NumberOperand::Indirect(location) => self.read(&self.find(location, false).ok()?, Width::Word).map(|number| number as u16),
            NumberOperand::Parameter(index) => self.parameter(*index).map(|number| number as u16),
        }
    }
}

/// A register by its name in the operand.
pub(crate) fn address_register(register: AddressRegister) -> Register {
    match register {
        AddressRegister::Ar1 => Register::Ar1,
        AddressRegister::Ar2 => Register::Ar2,
    }
}

fn moved(pointer: u64, offset: u32) -> u32 {
    ((pointer & 0x00FF_FFFF) + u64::from(offset)) as u32 & 0x00FF_FFFF
}

fn pointed(pointer: u64, write: bool) -> Result<Area, Trouble> {
    sieben_engine::access::pointed_area(pointer, write).map_err(|fault| Trouble::Fault(fault.event()))
}
