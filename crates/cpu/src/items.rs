//! Where items lie at a moment of a run, and what they hold there.

mod local;

use std::ops::Range;

use sieben_engine::machine::{Registers, Timer};
use sieben_engine::{Machine, Stored};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::bcd;
use sieben_model::item::{Bytes, Item, Local, Place};
use sieben_model::types::DataType;
use sieben_model::value::{Content, Kind};

pub use local::Spot;

/// A machine between any two statements, with the registers of that moment.
#[derive(Clone, Copy)]
pub struct Moment<'m> {
    /// The machine.
    pub machine: &'m Machine,
    /// The registers that the next statement finds.
    pub registers: &'m Registers,
}

/// How a value lies in bytes: as one number, or as what it is.
pub(crate) fn content_of(kind: &Kind, bytes: &[u8]) -> Content {
    match kind.plain() {
        Kind::Bytes(_) | Kind::Text => Content::Bytes(bytes.into()),
        Kind::Typed(data_type) if data_type.stands_in_bytes() => Content::Bytes(bytes.into()),
        _ => Content::Bits(bytes.iter().fold(0, |bits, &byte| bits << 8 | u64::from(byte))),
    }
}

/// A timer as it stands at this moment.
pub(crate) fn timer_of(machine: &Machine, number: u16) -> Option<Timer> {
    let mut timer = machine.timers.get(usize::from(number))?.clone();
    timer.refresh(machine.clock_us);
    Some(timer)
}

/// The word of S5TIME that a timer of this base has with so much left, as `LC` loads it.
pub(crate) fn s5time_of(base: u8, count: u16) -> u16 {
    u16::from(base & 3) << 12 | bcd::encode(u32::from(count)) as u16 & 0xFFF
}

/// The range of the arena that bytes of an area or of a data block are; `None` if they lie outside.
pub(crate) fn range_of(machine: &Machine, bytes: &Bytes) -> Option<Range<usize>> {
    let within = match bytes.db {
        Some(db) => machine.memory.data_block(u64::from(db)).map(|entry| entry.base as usize..(entry.base + entry.length) as usize)?,
        None => machine.memory.layout.area(bytes.area)?,
    };
    let first = within.start.checked_add(bytes.byte as usize)?;
    let end = first.checked_add(bytes.length as usize)?;
    (end <= within.end).then_some(first..end)
}

impl<'m> Moment<'m> {
    /// Where a variable of a block lies; `None` if the block does not run.
    pub fn spot(self, local: &Local) -> Option<Spot> {
        local::spot(local, self.machine, self.registers)
    }

    /// What an item holds; `None` if nothing: a data block that is not loaded, a block that does not run. A peripheral input has the value of
    /// the process image, an output likewise.
    pub fn content(self, item: &Item) -> Option<Content> {
        if let Place::Constant(content) = &item.place {
            return Some(content.clone());
        }
        self.bits(item).map(Content::Bits).or_else(|| self.bytes(item).map(|bytes| Content::Bytes(bytes.into())))
    }

    /// The bits that an item of at most 64 bits holds; `None` if it has more, or nothing.
    pub fn bits(self, item: &Item) -> Option<u64> {
        let Self { machine, registers } = self;
        match &item.place {
            Place::Operand(Operand::Timer(number)) => {
                let timer = timer_of(machine, *number)?;
                let count = timer.remaining(machine.clock_us);
                Some(u64::from(if item.is_time_of_timer() { s5time_of(timer.base, count) } else { count }))
            }
            Place::Operand(Operand::Counter(number)) => Some(u64::from(machine.counters.get(usize::from(*number))?.count)),
            Place::Operand(operand) => {
                let address = operand_in_image(operand);
                let at = machine.memory.locate(&address)?;
                let (Operand::Address(Address { width, bit, .. }) | Operand::InDataBlock { address: Address { width, bit, .. }, .. }) =
                    address
                else {
                    return None;
                };
                Some(machine.memory.read_wide(at, bit & 7, width))
            }
            Place::TimerStatus(number) => Some(u64::from(timer_of(machine, *number)?.status)),
            Place::Bytes(bytes) => {
                let range = range_of(machine, bytes).filter(|range| range.len() <= 8)?;
                content_of(&item.kind, machine.memory.arena.get(range)?).bits()
            }
            Place::Local(local) => match (self.spot(local)?, local.width()) {
                (Spot::Number(number), _) => Some(u64::from(number)),
                (Spot::Arena(at, bit), Some(width)) => {
                    let inside = at.checked_add(width.bytes() as usize)? <= machine.memory.arena.len();
                    inside.then(|| machine.memory.read_wide(at, bit, width))
                }
                (Spot::Arena(..), None) => None,
            },
            Place::Register(register) => Some(registers.get(*register)),
            Place::Status => Some(u64::from(registers.status().0)),
            Place::Constant(content) => content.bits(),
        }
    }

    /// The bytes of an item that is no number.
    fn bytes(self, item: &Item) -> Option<&'m [u8]> {
        let arena = &self.machine.memory.arena;
        match &item.place {
            Place::Bytes(bytes) => arena.get(range_of(self.machine, bytes)?),
            Place::Local(local) if local.width().is_none() => match self.spot(local)? {
                Spot::Arena(at, _) => arena.get(at..at.checked_add(length_of(&local.data_type)?)?),
                Spot::Number(_) => None,
            },
            _ => None,
        }
    }

    /// The bytes of the arena where an item lies, and which bits of them; `None` if it lies elsewhere.
    pub fn extent(self, item: &Item) -> Option<(Range<usize>, u8)> {
        let at = |first: usize, width: Width, bit: u8| {
            let mask = if width == Width::Bit { 1 << (bit & 7) } else { 0xFF };
            (first..first + width.bytes() as usize, mask)
        };
        match &item.place {
            Place::Operand(operand @ (Operand::Address(address) | Operand::InDataBlock { address, .. })) => {
                self.machine.memory.locate(operand).map(|first| at(first, address.width, address.bit))
            }
            Place::Bytes(bytes) => range_of(self.machine, bytes).map(|range| (range, 0xFF)),
            Place::Local(local) => match (self.spot(local)?, local.width()) {
                (Spot::Arena(first, bit), Some(width)) => Some(at(first, width, bit)),
                (Spot::Arena(first, _), None) => Some((first..first.checked_add(length_of(&local.data_type)?)?, 0xFF)),
                (Spot::Number(_), _) => None,
            },
            Place::Operand(_) | Place::TimerStatus(_) | Place::Register(_) | Place::Status | Place::Constant(_) => None,
        }
    }

    /// Whether what is stored lies where an item does. Registers are no place.
    pub fn is_stored(self, item: &Item, stored: &Stored) -> bool {
        match (&item.place, *stored) {
            (Place::Operand(Operand::Timer(number)) | Place::TimerStatus(number), Stored::Timer(other)) => *number == other,
            (Place::Operand(Operand::Counter(number)), Stored::Counter(other)) => *number == other,
            // `T PQW` writes the process image as well.
            (Place::Operand(Operand::Address(address)), Stored::Peripheral { first, bytes }) => {
                matches!(address.area, Area::Output | Area::PeripheralOutput)
                    && address.byte < first + bytes
                    && first < address.byte + address.width.bytes()
            }
            (_, Stored::Memory { first, bytes, mask }) => {
                self.extent(item).is_some_and(|(own, own_mask)| own.start < first + bytes && first < own.end && own_mask & mask != 0)
            }
            _ => false,
        }
    }

    /// What setting an item from outside stores, at once: an input only comes with the next process image.
    pub fn stores(self, item: &Item) -> Option<Stored> {
        match &item.place {
            Place::Operand(Operand::Timer(number)) => Some(Stored::Timer(*number)),
            Place::Operand(Operand::Counter(number)) => Some(Stored::Counter(*number)),
            Place::Operand(Operand::Address(Address { area: Area::Input | Area::PeripheralInput, .. })) => None,
            Place::Operand(Operand::Address(address @ Address { area: Area::PeripheralOutput, .. })) => {
                Some(Stored::Peripheral { first: address.byte, bytes: address.width.bytes() })
            }
            _ => {
                let (range, mask) = self.extent(item)?;
                Some(Stored::Memory { first: range.start, bytes: range.len(), mask })
            }
        }
    }
}

/// A peripheral address as that of the process image.
fn operand_in_image(operand: &Operand) -> Operand {
    match *operand {
        Operand::Address(address) => Operand::Address(Address {
            area: match address.area {
                Area::PeripheralInput => Area::Input,
                Area::PeripheralOutput => Area::Output,
                area => area,
            },
            ..address
        }),
        other => other,
    }
}

fn length_of(data_type: &DataType) -> Option<usize> {
    usize::try_from(data_type.bits().div_ceil(8)).ok()
}
