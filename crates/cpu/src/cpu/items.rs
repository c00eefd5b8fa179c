//! Reads and writes items between two scans, and while the CPU is paused between two statements.

use sieben_engine::machine::{Register, StatusWord};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::item::{Bytes, Item, Place};
use sieben_model::value::{Content, Kind, Value};

use super::Cpu;
use crate::items::{Moment, Spot, content_of, range_of, s5time_of};
use crate::station::{AccessError, Station};

/// Accumulators that only a CPU with four of them has.
const FAR_ACCUMULATORS: [Register; 2] = [Register::Accu3, Register::Accu4];
/// Registers that only an open data block sets.
const SET_BY_OPENING: [Register; 4] = [Register::DbNumber, Register::DbLength, Register::DiNumber, Register::DiLength];

impl Cpu {
    /// This moment: between two scans the registers are those after the last statement of OB 1.
    pub fn moment(&self) -> Moment<'_> {
        Moment { machine: self.machine(), registers: self.registers() }
    }

    /// What an item holds, as [`Station::read_items`] reads it.
    ///
    /// # Errors
    /// Nothing is there to be read.
    pub fn content(&self, item: &Item) -> Result<Content, AccessError> {
        match &item.place {
            Place::Operand(operand) if operand.width() == Some(Width::QuadWord) => {
                let bytes = as_bytes(operand).ok_or(AccessError::NotAccessible)?;
                self.range(&bytes).map(|bytes| content_of(&item.kind, &bytes))
            }
            Place::Operand(Operand::Timer(number)) if item.is_time_of_timer() => match self.timer(*number) {
                Some(timer) => Ok(Content::Bits(u64::from(s5time_of(timer.base, timer.value)))),
                None => Err(AccessError::Outside),
            },
            Place::Operand(operand) => self.read(operand).map(|bits| Content::Bits(u64::from(bits))),
            Place::TimerStatus(number) => match self.timer(*number) {
                Some(reading) => Ok(Content::Bits(u64::from(reading.status))),
                None => Err(AccessError::Outside),
            },
            Place::Bytes(bytes) => self.range(bytes).map(|bytes| content_of(&item.kind, &bytes)),
            Place::Local(local) => self.moment().content(item).ok_or(AccessError::NotRunning(local.block)),
            Place::Register(register) => {
                self.has_register(*register)?;
                Ok(Content::Bits(self.registers().get(*register)))
            }
            Place::Status => Ok(Content::Bits(u64::from(self.registers().status().0))),
            Place::Constant(content) => Ok(content.clone()),
        }
    }

    /// Bytes of an area or of a data block, in one copy; peripheral ones from their modules.
    pub(super) fn range(&self, bytes: &Bytes) -> Result<Box<[u8]>, AccessError> {
        if let Area::PeripheralInput | Area::PeripheralOutput = bytes.area {
            let end = bytes.byte.checked_add(bytes.length).filter(|&end| end <= self.cpu_type.peripheral).ok_or(AccessError::Outside)?;
            let byte = |at: u32| match bytes.area {
                Area::PeripheralInput => self.rack.peripheral_read(at, Width::Byte),
                _ => self.rack.peripheral_output(at, Width::Byte),
            };
            return (bytes.byte..end).map(|at| byte(at).map(|byte| byte as u8).ok_or(AccessError::NoModule)).collect();
        }
        match range_of(&self.machine, bytes) {
            Some(range) => Ok(self.machine.memory.arena[range].into()),
            None => Err(self.why_no_bytes(bytes)),
        }
    }

    fn why_no_bytes(&self, bytes: &Bytes) -> AccessError {
        let byte = Address { area: bytes.area, width: Width::Byte, byte: bytes.byte, bit: 0 };
        self.why_not(&match bytes.db {
            Some(db) => Operand::InDataBlock { db, address: byte },
            None => Operand::Address(byte),
        })
    }

    /// Gives an item a value, as [`Station::write_items`] does: an input in its module, a register for the beginning of OB 1 in the next scan,
    /// anything else in place. What is tried out (a scenario, a test, a step) may write a READ_ONLY data block too.
    ///
    /// # Errors
    /// Nothing is there to be set, or the value does not fit.
    pub fn set(&mut self, item: &Item, content: &Content) -> Result<(), AccessError> {
        match (&item.place, content) {
            (Place::Operand(operand), Content::Bits(bits)) if operand.width() == Some(Width::QuadWord) => {
                let bytes = as_bytes(operand).ok_or(AccessError::NotAccessible)?;
                self.set_range(&bytes, &bits.to_be_bytes())
            }
            (Place::Operand(operand), Content::Bits(bits)) => {
                self.modify_operand(operand, u32::try_from(*bits).map_err(|_| AccessError::Value)?)
            }
            (Place::TimerStatus(_) | Place::Constant(_), _) => Err(AccessError::ReadOnly),
            (Place::Bytes(bytes), Content::Bytes(values)) => self.set_range(bytes, values),
            (Place::Bytes(bytes), Content::Bits(bits)) if bytes.length <= 8 && !matches!(item.kind.plain(), Kind::Bytes(_)) => {
                let first = 8 - bytes.length as usize;
                self.set_range(bytes, &bits.to_be_bytes()[first..])
            }
            (Place::Local(local), content) => match (self.moment().spot(local), content, local.width()) {
                (None, ..) => Err(AccessError::NotRunning(local.block)),
                (Some(Spot::Number(_)), ..) => Err(AccessError::ReadOnly),
                (Some(Spot::Arena(at, bit)), Content::Bits(bits), Some(width)) => self.set_memory(at, bit, width, *bits),
                (Some(Spot::Arena(at, _)), Content::Bytes(values), None) => {
                    let length = local.data_type.bits().div_ceil(8);
                    let fits = values.len() as u64 <= length;
                    if !fits {
                        return Err(AccessError::Value);
                    }
                    self.set_arena(at, values)
                }
                _ => Err(AccessError::Value),
            },
            (Place::Status, Content::Bits(bits)) => {
                self.preset_registers_mut().set_status(StatusWord(*bits as u16));
                Ok(())
            }
            (Place::Register(register), Content::Bits(bits)) => {
                self.has_register(*register)?;
                if SET_BY_OPENING.contains(register) {
                    return Err(AccessError::ReadOnly);
                }
                self.preset_registers_mut().set(*register, *bits);
                Ok(())
            }
            _ => Err(AccessError::Value),
        }
    }

    /// Sets bytes of an area or of a data block; a STRING may have fewer than its place.
    fn set_range(&mut self, bytes: &Bytes, values: &[u8]) -> Result<(), AccessError> {
        if values.len() > bytes.length as usize {
            return Err(AccessError::Value);
        }
        match bytes.area {
            Area::Input | Area::PeripheralInput | Area::PeripheralOutput => {
                // All of them or none.
                self.range(bytes)?;
                for (byte, &value) in (bytes.byte..).zip(values) {
                    let address = Address { area: bytes.area, width: Width::Byte, byte, bit: 0 };
                    self.modify_operand(&Operand::Address(address), u32::from(value))?;
                }
                Ok(())
            }
            _ => match range_of(&self.machine, bytes) {
                Some(range) => self.set_arena(range.start, values),
                None => Err(self.why_no_bytes(bytes)),
            },
        }
    }

    fn set_arena(&mut self, at: usize, values: &[u8]) -> Result<(), AccessError> {
        let end = at.checked_add(values.len()).ok_or(AccessError::Outside)?;
        let into = self.machine.memory.arena.get_mut(at..end).ok_or(AccessError::Outside)?;
        into.copy_from_slice(values);
        self.images.changed();
        Ok(())
    }

    fn set_memory(&mut self, at: usize, bit: u8, width: Width, bits: u64) -> Result<(), AccessError> {
        let inside = at.checked_add(width.bytes() as usize).is_some_and(|end| end <= self.machine.memory.arena.len());
        if !inside {
            return Err(AccessError::Outside);
        }
        self.images.changed();
        self.machine.memory.write_wide(at, bit & 7, width, bits);
        Ok(())
    }

    fn has_register(&self, register: Register) -> Result<(), AccessError> {
        let beyond = FAR_ACCUMULATORS.contains(&register) && self.cpu_type.accumulators < 4;
        if beyond { Err(AccessError::NoRegister) } else { Ok(()) }
    }

    /// What an item holds, with what it is.
    pub(super) fn value(&self, item: &Item) -> Result<Value, AccessError> {
        self.content(item).map(|content| Value { kind: item.kind.clone(), content })
    }
}

/// An address as the bytes that it is.
fn as_bytes(operand: &Operand) -> Option<Bytes> {
    let bytes = |db: Option<u16>, address: &Address| Bytes { db, area: address.area, byte: address.byte, length: address.width.bytes() };
    match operand {
        Operand::Address(address) => Some(bytes(None, address)),
        Operand::InDataBlock { db, address } => Some(bytes(Some(*db), address)),
        Operand::Timer(_) | Operand::Counter(_) | Operand::Block(_) => None,
    }
}
