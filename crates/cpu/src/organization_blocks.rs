//! Organization blocks: priority, what happens without them, and the 20 bytes of start information.

use sieben_engine::{Abort, Fault, FaultPlace};
use sieben_model::address::Width;
use sieben_model::block::{BlockId, BlockKind};

use crate::clock::DateAndTime;
use crate::cycle::CycleTimes;
use crate::mode::Restart;

/// Cyclic program.
pub const CYCLE: BlockId = BlockId::ob(1);
/// Time error.
pub const TIME_ERROR: BlockId = BlockId::ob(80);
/// Processing abort (S7-400).
pub const PROCESSING_ABORT: BlockId = BlockId::ob(88);
/// Programming error.
pub const PROGRAMMING_ERROR: BlockId = BlockId::ob(121);
/// I/O access error.
pub const IO_ACCESS_ERROR: BlockId = BlockId::ob(122);

/// What the CPU does with an organization block: number, priority class (0 = that of the cause), event of the STOP if it is
/// needed and not loaded (0 = the CPU goes on).
const TABLE: &[(u16, u8, u16)] =
    &[(1, 1, 0), (80, 26, 0x4568), (88, 28, 0x4570), (100, 27, 0), (101, 27, 0), (102, 27, 0), (121, 0, 0x4562), (122, 0, 0x4563)];

fn row(block: BlockId) -> Option<&'static (u16, u8, u16)> {
    TABLE.iter().find(|row| row.0 == block.number)
}

/// The priority class of an organization block; 0 if it has that of its cause.
pub fn priority(block: BlockId) -> u8 {
    row(block).map_or(0, |row| row.1)
}

/// The event with which the CPU goes to STOP if this organization block is needed and not loaded; 0 if it goes on.
pub fn missing(block: BlockId) -> u16 {
    row(block).map_or(0, |row| row.2)
}

/// The startup block of a kind of restart.
pub fn startup(restart: Restart) -> BlockId {
    BlockId::ob(match restart {
        Restart::Warm => 100,
        Restart::Hot => 101,
        Restart::Cold => 102,
    })
}

/// Start information as it lies in the local data, field by field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StartInformation {
    /// Byte 0: event class and identification; byte 1: event number.
    pub event: u16,
    /// Byte 2.
    pub priority: u8,
    /// Byte 3.
    pub block: u8,
    /// Bytes 4 and 5.
    pub data_id: u16,
    /// Bytes 6 and 7.
    pub info_1: u16,
    /// Bytes 8 to 11.
    pub info_2: u32,
}

impl StartInformation {
    /// The 20 bytes, with the time of the start behind the fields.
    pub fn bytes(&self, time: DateAndTime) -> [u8; 20] {
        let mut bytes = [0; 20];
        bytes[0..2].copy_from_slice(&self.event.to_be_bytes());
        bytes[2] = self.priority;
        bytes[3] = self.block;
        bytes[4..6].copy_from_slice(&self.data_id.to_be_bytes());
        bytes[6..8].copy_from_slice(&self.info_1.to_be_bytes());
        bytes[8..12].copy_from_slice(&self.info_2.to_be_bytes());
        bytes[12..20].copy_from_slice(&time.to_bcd());
        bytes
    }

    /// OB 1. `scan` counts from 1.
    pub fn cycle(restart: Restart, scan: u64, times: &CycleTimes) -> Self {
        let scan_1 = match (scan, restart) {
            (0 | 1, Restart::Warm) => 0x01,
            (0 | 1, Restart::Hot) => 0x02,
            (0 | 1, Restart::Cold) => 0x04,
            _ => 0x03,
        };
        let ms = |us: u64| u32::try_from(us / 1000).unwrap_or(u32::MAX).min(i16::MAX as u32);
        Self {
            event: 0x1100 | scan_1,
            priority: 1,
            block: 1,
            info_1: ms(times.last) as u16,
            info_2: ms(times.min) << 16 | ms(times.max),
            ..Self::default()
        }
    }

    /// OB 100, 101 and 102 after a start by hand. `stop_event` stopped the CPU before; `hot` = the CPU type has a hot restart.
    pub fn startup(restart: Restart, stop_event: u16, hot: bool) -> Self {
        let (startup, done) = match restart {
            Restart::Warm => (0x81, 0x04),
            Restart::Hot => (0x83, 0x0C),
            Restart::Cold => (0x85, 0x08),
        };
        // Startups allowed automatically and by hand: 0111 warm and cold, 1111 with hot.
        let allowed: u32 = if hot { 0xFF } else { 0x77 };
        Self {
            event: 0x1300 | startup,
            priority: 27,
            block: startup_number(restart),
            info_1: stop_event,
            info_2: done << 16 | allowed << 8 | done,
            ..Self::default()
        }
    }

    /// OB 80 after the cycle time was exceeded. `elapsed_us` is the time of this cycle so far.
    pub fn cycle_time_exceeded(elapsed_us: u64, interrupted: &Self) -> Self {
        Self {
            event: 0x3501,
            priority: 26,
            block: 80,
            info_1: u16::try_from(elapsed_us / 1000).unwrap_or(u16::MAX),
            info_2: u32::from(interrupted.event) << 16 | u32::from(interrupted.priority) << 8 | u32::from(interrupted.block),
            ..Self::default()
        }
    }

    /// OB 121, OB 122 or OB 88 for a fault at `place`, in an organization block of class `priority` started as `class` tells.
    pub fn fault(fault: &Fault, place: FaultPlace, class: &Self) -> Self {
        let block_type = u16::from(block_type(place.block)) << 8;
        // PRG_ADDR is the statement counted from 0: a compiled block has no MC7 addresses.
        let where_it_was = u32::from(place.block.number) << 16 | u32::from(u16::try_from(place.statement).unwrap_or(u16::MAX));
        let common = Self { event: fault.event(), priority: class.priority, info_2: where_it_was, ..Self::default() };
        match *fault {
            Fault::Programming { register, access, .. } => {
                Self { block: 121, data_id: block_type | u16::from(access), info_1: register, ..common }
            }
            Fault::IoAccess { width, byte, .. } => {
                Self { block: 122, data_id: block_type | memory_area(width), info_1: u16::try_from(byte).unwrap_or(u16::MAX), ..common }
            }
            Fault::Abort(_) => Self {
                priority: 28,
                block: 88,
                data_id: block_type,
                info_1: u16::from(class.priority) << 8 | u16::from(class.block),
                ..common
            },
        }
    }
}

fn startup_number(restart: Restart) -> u8 {
    match restart {
        Restart::Warm => 100,
        Restart::Hot => 101,
        Restart::Cold => 102,
    }
}

/// The code of a block kind in start information.
fn block_type(block: BlockId) -> u8 {
    match block.kind {
        BlockKind::OrganizationBlock => 0x88,
        BlockKind::DataBlock => 0x8A,
        BlockKind::Function => 0x8C,
        BlockKind::FunctionBlock => 0x8E,
        _ => 0,
    }
}

/// OB122_MEM_AREA: the width of the access; the area I/O is 0.
fn memory_area(width: Width) -> u16 {
    match width {
        Width::Bit => 0x00,
        Width::Byte => 0x10,
        Width::Word => 0x20,
        Width::DoubleWord => 0x30,
    }
}

/// The event with which a CPU without OB 88 stops after an abort.
pub fn abort_stop_event(abort: Abort) -> u16 {
    match abort {
        Abort::NestingStack => 0x4571,
        Abort::McrStack => 0x4572,
        Abort::BlockStack => 0x4575,
        Abort::LocalData => 0x4576,
    }
}
