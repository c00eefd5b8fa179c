//! The 20 bytes of start information that an organization block finds at the beginning of its local data.

use sieben_engine::{Fault, FaultPlace};
use sieben_model::address::Width;
use sieben_model::block::{BlockId, BlockKind};

use crate::clock::DateAndTime;
use crate::cycle::CycleTimes;
use crate::mode::Restart;
use crate::organization_blocks as ob;

/// The priority class that the start information of OB 90 shows: 29 stands for 0.29, below OB 1.
const BELOW_THE_CYCLE: u8 = 29;

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
        self.bytes_with(time.to_bcd())
    }

    /// The same with the time as DATE_AND_TIME.
    pub(crate) fn bytes_with(&self, time: [u8; 8]) -> [u8; 20] {
        let mut bytes = [0; 20];
        bytes[0..2].copy_from_slice(&self.event.to_be_bytes());
        bytes[2] = self.priority;
        bytes[3] = self.block;
        bytes[4..6].copy_from_slice(&self.data_id.to_be_bytes());
        bytes[6..8].copy_from_slice(&self.info_1.to_be_bytes());
        bytes[8..12].copy_from_slice(&self.info_2.to_be_bytes());
        bytes[12..20].copy_from_slice(&time);
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
            block: ob::startup(restart).number as u8,
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

    /// OB 80 for a reason other than the cycle time: `event` 16#3502 (still running) or 16#3507 (too many requests); `request` is what it concerns.
    pub(crate) fn time_error(event: u16, request: &Self) -> Self {
        Self {
            event,
            // Too many requests is the one time error that nothing may hold up.
            priority: if event == 0x3507 { 28 } else { 26 },
            block: 80,
            info_2: u32::from(request.event) << 16 | u32::from(request.priority) << 8 | u32::from(request.block),
            ..Self::default()
        }
    }

    /// OB 80 for time-of-day interrupts whose time was skipped, one bit each: 16#3505 by setting the clock, 16#3506 in HOLD or STOP.
    pub(crate) fn times_skipped(event: u16, which: u16) -> Self {
        Self { event, priority: 26, block: 80, info_1: which, ..Self::default() }
    }

    /// OB 85 because the organization block for `request` is not loaded, while `active` ran.
    pub(crate) fn block_not_loaded(request: &Self, active: &Self) -> Self {
        Self {
            event: 0x35A1,
            priority: 26,
            block: 85,
            info_2: u32::from(request.event) << 16 | u32::from(active.priority) << 8 | u32::from(active.block),
            ..Self::default()
        }
    }

    /// OB 85 because the process image could not be exchanged with a module: its first byte and how many.
    pub(crate) fn image_error(event: u16, byte: u32, bytes: u32) -> Self {
        // The data ID 16#57 says that a range of bytes follows.
        Self { event, priority: 26, block: 85, data_id: 0x5700, info_1: byte as u16, info_2: bytes }
    }

    fn interrupt(number: u16, event: u16) -> Self {
        let priority = ob::priority(BlockId::ob(number));
        Self { event, priority, block: number as u8, ..Self::default() }
    }

    /// OB 30 to OB 38.
    pub(crate) fn cyclic_interrupt(number: u16, phase_ms: u16, interval_ms: u16) -> Self {
        Self { info_1: phase_ms, info_2: u32::from(interval_ms), ..Self::interrupt(number, 0x1131 + (number - 30)) }
    }

    /// OB 20 to OB 23.
    pub(crate) fn delay_interrupt(number: u16, sign: u16, dtime_ms: u32) -> Self {
        Self { info_1: sign, info_2: dtime_ms, ..Self::interrupt(number, 0x1121 + (number - 20)) }
    }

    /// OB 10 to OB 17.
    pub(crate) fn time_of_day_interrupt(number: u16, period: u16) -> Self {
        Self { info_1: period, ..Self::interrupt(number, 0x1111 + (number - 10)) }
    }

    /// OB 90, for the first time since the start or from its beginning again.
    pub(crate) fn background(first: bool) -> Self {
        Self { event: if first { 0x1191 } else { 0x1195 }, priority: BELOW_THE_CYCLE, block: 90, ..Self::default() }
    }

    /// The priority class that others have to be above to interrupt this block.
    pub(crate) fn rank(&self) -> u8 {
        if self.priority == BELOW_THE_CYCLE { 0 } else { self.priority }
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
        Width::DoubleWord | Width::QuadWord => 0x30,
    }
}
