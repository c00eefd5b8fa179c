//! Parameters of system functions: values and places behind pointers, and the general error codes.

use std::ops::Range;

use sieben_engine::machine::{CALLS_MASK, CALLS_SHIFT};
use sieben_engine::{Host, Machine};
use sieben_model::address::{Area, Width};
use sieben_model::types::DataType;

use super::{Call, Parameter, RET_VAL, Type};

/// RET_VAL of a call: a value of at least 0, or an error code (bit 15 set).
pub(super) type Answer = Result<u32, u16>;

/// RET_VAL of a function that runs over several calls: REQ = 0, and no job runs.
pub(super) const NO_JOB: u32 = 0x7000;
/// RET_VAL of the call that starts a job.
pub(super) const STARTED: u32 = 0x7001;

/// A general error code without the number of the parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Refused(u8);

impl Refused {
    pub(super) const LENGTH: Self = Self(0x22);
    pub(super) const AREA: Self = Self(0x24);
    pub(super) const BIT: Self = Self(0x28);
    const SHARED_PROTECTED: Self = Self(0x30);
    const INSTANCE_PROTECTED: Self = Self(0x31);
    const DB_NUMBER: Self = Self(0x32);
    pub(super) const DB_NOT_LOADED: Self = Self(0x3A);
    pub(super) const PERIPHERAL: Self = Self(0x42);

    /// Codes that come in pairs are one higher for a write.
    pub(super) fn when(self, write: bool) -> Self {
        Self(self.0 + u8::from(write))
    }

    /// The code for parameter `index`, counted from 0.
    pub(super) fn of(self, index: usize) -> u16 {
        0x8000 | (index as u16 + 1) << 8 | u16::from(self.0)
    }
}

/// What a pointer means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// A byte of the arena.
    Arena(usize),
    /// A byte of the modules.
    Peripheral(u32),
}

/// The place of `bytes` bytes behind an area-crossing pointer; `db` = 0 means the data block that is open.
pub(super) fn locate(machine: &Machine, db: u16, pointer: u32, bytes: u32, write: bool) -> Result<Place, Refused> {
    let address = pointer & 0x00FF_FFFF;
    let byte = if pointer >> 24 == u32::from(Area::CallerLocal.pointer_code()) { address & CALLS_MASK } else { address } >> 3;
    let block = |open: u64, protected: Refused| {
        let number = if db == 0 { open } else { u64::from(db) };
        if number > u64::from(machine.memory.layout.db_number_max) {
            return Err(Refused::DB_NUMBER);
        }
        let entry = machine.memory.data_block(number).ok_or(Refused::DB_NOT_LOADED)?;
        if write && entry.read_only {
            return Err(protected);
        }
        Ok(entry.base as usize..(entry.base + entry.length) as usize)
    };
    let area = |area: Area| machine.memory.layout.area(area).unwrap_or(0..0);
    let range = match pointer >> 24 {
        0x80 => {
            let end = byte.checked_add(bytes).ok_or(Refused::LENGTH.when(write))?;
            return if end > machine.memory.layout.peripheral { Err(Refused::LENGTH.when(write)) } else { Ok(Place::Peripheral(byte)) };
        }
        0x81 => area(Area::Input),
        0x82 => area(Area::Output),
        0x83 => area(Area::BitMemory),
        0x84 => block(machine.registers.db_number, Refused::SHARED_PROTECTED)?,
        0x85 => block(machine.registers.di_number, Refused::INSTANCE_PROTECTED)?,
        // A system function has no local data of its own: L and V are those of the block that calls it.
        0x86 => machine.local_data(0),
        0x87 => machine.local_data((address >> CALLS_SHIFT) as usize),
        _ => return Err(Refused::AREA.when(write)),
    };
    if u64::from(byte) + u64::from(bytes) > range.len() as u64 {
        return Err(Refused::LENGTH.when(write));
    }
    Ok(Place::Arena(range.start + byte as usize))
}

impl Call<'_, '_> {
    /// The pointer passed for parameter `index`.
    fn pointer(&self, index: usize, write: bool) -> Result<u32, u16> {
        // `UC` passes none.
        self.machine.parameters.get(self.first + index).copied().ok_or(Refused::AREA.when(write).of(index))
    }

    /// The number of a block, timer or counter: what is passed is the number itself.
    pub(super) fn block_number(&self, index: usize) -> Result<u16, u16> {
        Ok(self.pointer(index, false)? as u16)
    }

    fn place(&self, index: usize, width: Width, write: bool) -> Result<(Place, u8), u16> {
        let pointer = self.pointer(index, write)?;
        let bit = (pointer & 7) as u8;
        if width != Width::Bit && bit != 0 {
            return Err(Refused::BIT.when(write).of(index));
        }
        let place = locate(self.machine, 0, pointer, width.bytes(), write).map_err(|refused| refused.of(index))?;
        Ok((place, bit))
    }

    /// The value of an elementary input.
    pub(super) fn input(&mut self, index: usize, width: Width) -> Result<u32, u16> {
        match self.place(index, width, false)? {
            (Place::Arena(at), bit) => Ok(self.machine.memory.read_at(at, bit, width)),
            (Place::Peripheral(byte), bit) => match self.host.peripheral_read(self.machine, byte, width) {
                Some(value) if width == Width::Bit => Ok(value >> bit & 1),
                Some(value) => Ok(value),
                None => Err(Refused::PERIPHERAL.of(index)),
            },
        }
    }

    /// Writes an elementary output.
    pub(super) fn output(&mut self, index: usize, width: Width, value: u32) -> Result<(), u16> {
        match self.place(index, width, true)? {
            (Place::Arena(at), bit) => {
                self.machine.memory.write_at(at, bit, width, value);
                self.wrote(at..at + width.bytes() as usize);
            }
            // No bit of the peripheral can be an actual parameter.
            (Place::Peripheral(byte), _) if width != Width::Bit => {
                if !self.host.peripheral_write(self.machine, byte, width, value) {
                    return Err(Refused::PERIPHERAL.when(true).of(index));
                }
            }
            (Place::Peripheral(_), _) => return Err(Refused::AREA.when(true).of(index)),
        }
        Ok(())
    }

    /// Notes that these bytes of the arena have been written, for whoever watches.
    pub(super) fn wrote(&mut self, bytes: Range<usize>) {
        self.host.written.push(bytes);
    }

    /// The bytes passed behind a parameter: a POINTER or an ANY itself.
    pub(super) fn passed<const BYTES: usize>(&self, index: usize, write: bool) -> Result<[u8; BYTES], u16> {
        let pointer = self.pointer(index, write)?;
        match locate(self.machine, 0, pointer, BYTES as u32, false) {
            Ok(Place::Arena(at)) if pointer & 7 == 0 => {
                let mut bytes = [0; BYTES];
                bytes.copy_from_slice(&self.machine.memory.arena[at..at + BYTES]);
                Ok(bytes)
            }
            _ => Err(Refused::AREA.when(write).of(index)),
        }
    }

    /// The arena place of a complex parameter (DATE_AND_TIME, STRUCT), which is passed by a POINTER.
    fn complex(&self, index: usize, bytes: usize, write: bool) -> Result<usize, u16> {
        let [d1, d0, p3, p2, p1, p0] = self.passed::<6>(index, write)?;
        let pointer = u32::from_be_bytes([p3, p2, p1, p0]);
        if pointer & 7 != 0 {
            return Err(Refused::BIT.when(write).of(index));
        }
        match locate(self.machine, u16::from_be_bytes([d1, d0]), pointer, bytes as u32, write) {
            Ok(Place::Arena(at)) => Ok(at),
            Ok(Place::Peripheral(_)) => Err(Refused::AREA.when(write).of(index)),
            Err(refused) => Err(refused.of(index)),
        }
    }

    /// The bytes of a complex input.
    pub(super) fn complex_input<const BYTES: usize>(&self, index: usize) -> Result<[u8; BYTES], u16> {
        let at = self.complex(index, BYTES, false)?;
        let mut bytes = [0; BYTES];
        bytes.copy_from_slice(&self.machine.memory.arena[at..at + BYTES]);
        Ok(bytes)
    }

    /// The characters of a STRING.
    pub(super) fn text(&self, index: usize) -> Result<Vec<u8>, u16> {
        let at = self.complex(index, 2, false)?;
        let arena = &self.machine.memory.arena;
        let length = usize::from(arena[at + 1]);
        Ok(arena.get(at + 2..at + 2 + length).unwrap_or_default().to_vec())
    }

    /// Writes a complex output.
    pub(super) fn complex_output(&mut self, index: usize, bytes: &[u8]) -> Result<(), u16> {
        let at = self.complex(index, bytes.len(), true)?;
        self.machine.memory.arena[at..at + bytes.len()].copy_from_slice(bytes);
        self.wrote(at..at + bytes.len());
        Ok(())
    }

    /// Writes RET_VAL and sets BR.
    pub(super) fn answer(&mut self, parameters: &[Parameter], answer: Answer) {
        let (value, good) = match answer {
            Ok(value) => (value, true),
            Err(code) => (u32::from(code), false),
        };
        let result = parameters.iter().enumerate().find(|(_, parameter)| parameter.name == RET_VAL);
        let written = result.is_none_or(|(index, parameter)| {
            let width = if matches!(parameter.data_type, Type::Plain(DataType::Time)) { Width::DoubleWord } else { Width::Word };
            self.output(index, width, value).is_ok()
        });
        self.machine.registers.br = u64::from(good && written);
    }
}
