//! The image of the retentive data and how it is written.
//!
//! Numbers are big endian, as all data of the CPU:
//!
//! ```text
//! version           1 byte, 2
//! CPU clock         8 bytes, microseconds in STARTUP and RUN
//! run-time meters   8 × 8 bytes, microseconds
//! parts             until the end:
//!   'M' first 2, length 2, bytes                          bit memory
//!   'T' number 2, kind 1, flags 1, value 2, base 1, start 8    a timer; when it was started, by the CPU clock
//!   'C' number 2, count 2, flags 1                        a counter
//!   'D' number 2, declaration 8, length 4, bytes          a data block of the program
//!   'G' number 2                                          a data block of the program that was changed from outside: not kept
//!   'N' number 2, flags 1, length 4, bytes                a data block that the program made (SFC 22, SFC 85)
//!   'L' number 2, initial values 8, length 4, bytes       a data block in the load memory that the program wrote (SFC 84)
//! ```

use sieben_engine::machine::counters::COUNT_MAX;
use sieben_engine::machine::{Counter, Timer, TimerKind};

use crate::created_data_blocks::Attributes;

/// The first byte of an image.
pub(super) const VERSION: u8 = 2;
/// Run-time meters of a CPU.
pub(super) const METERS: usize = 8;
/// Bytes before the first part.
pub(super) const HEAD_BYTES: usize = 1 + 8 + 8 * METERS;
/// Bytes of a timer behind its letter and number.
pub(super) const TIMER_BYTES: usize = 13;
/// Bytes of a counter behind its letter and number.
pub(super) const COUNTER_BYTES: usize = 3;
/// Where the CPU clock stands.
pub(super) const CLOCK: std::ops::Range<usize> = 1..9;
/// More than any CPU can have run; a clock beyond it was never one.
const CLOCK_US_MAX: u64 = 1 << 62;
/// Most that a timer value and its base amount to.
const VALUE_MAX: u16 = 999;

/// The retentive data of one whole scan.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RetainImage {
    /// The data; what [`RetainImage::is_sound`] does not refuse can be read.
    pub bytes: Vec<u8>,
    /// What the declarations of the retentive data blocks amount to. A program with another one gives the bytes another meaning.
    pub layout: u64,
    /// The scan that the data is from, counted from 1 since the restart; 0 = the startup.
    pub scan: u64,
}

impl RetainImage {
    /// Whether the bytes can be read at all; those that a CPU handed out always can.
    pub fn is_sound(&self) -> bool {
        parse(&self.bytes).is_some()
    }
}

/// One part of an image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Part<'a> {
    BitMemory {
        first: u16,
        bytes: &'a [u8],
    },
    Timer {
        number: u16,
        timer: Timer,
    },
    Counter {
        number: u16,
        counter: Counter,
    },
    DataBlock {
        number: u16,
        declaration: u64,
        bytes: &'a [u8],
    },
    Created {
        number: u16,
        attributes: Attributes,
        bytes: &'a [u8],
    },
    Loaded {
        number: u16,
        initial: u64,
        bytes: &'a [u8],
    },
    /// A data block of the program that was changed from outside, and is not kept.
    Gone {
        number: u16,
    },
}

/// An image that was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Parsed<'a> {
    pub(super) clock_us: u64,
    pub(super) meters_us: [u64; METERS],
    pub(super) parts: Vec<Part<'a>>,
}

/// Reads an image; `None` if it is none.
pub(super) fn parse(bytes: &[u8]) -> Option<Parsed<'_>> {
    let mut reader = Reader(bytes);
    if reader.u8()? != VERSION {
        return None;
    }
    let clock_us = reader.u64().filter(|&clock| clock <= CLOCK_US_MAX)?;
    let mut meters_us = [0; METERS];
    for meter in &mut meters_us {
        // Any number: SFC 101 presets up to 2^31 hours.
        *meter = reader.u64()?;
    }
    let mut parts = Vec::new();
    while !reader.0.is_empty() {
        parts.push(part(&mut reader, clock_us)?);
    }
    Some(Parsed { clock_us, meters_us, parts })
}

fn part<'a>(reader: &mut Reader<'a>, clock_us: u64) -> Option<Part<'a>> {
    let letter = reader.u8()?;
    let number = reader.u16()?;
    Some(match letter {
        b'M' => {
            let length = usize::from(reader.u16()?);
            Part::BitMemory { first: number, bytes: reader.bytes(length)? }
        }
        b'T' => Part::Timer { number, timer: timer(reader, clock_us)? },
        b'C' => Part::Counter { number, counter: counter(reader)? },
        b'D' => {
            let declaration = reader.u64()?;
            let length = reader.u32()? as usize;
            Part::DataBlock { number, declaration, bytes: reader.bytes(length)? }
        }
        b'N' => {
            let [read_only, non_retain, false, false] = flags(reader.u8()?)? else { return None };
            let length = reader.u32()? as usize;
            Part::Created { number, attributes: Attributes { read_only, non_retain }, bytes: reader.bytes(length)? }
        }
        b'L' => {
            let initial = reader.u64()?;
            let length = reader.u32()? as usize;
            Part::Loaded { number, initial, bytes: reader.bytes(length)? }
        }
        b'G' => Part::Gone { number },
        _ => return None,
    })
}

fn timer(reader: &mut Reader<'_>, clock_us: u64) -> Option<Timer> {
    let kind = *KINDS.get(usize::from(reader.u8()?))?;
    let [running, status, start_edge, enable_edge] = flags(reader.u8()?)?;
    let value = reader.u16().filter(|&value| value <= VALUE_MAX)?;
    let base = reader.u8().filter(|&base| base <= 3)?;
    // No timer is started in the future.
    let started_us = reader.u64().filter(|&started| started <= clock_us)?;
    Some(Timer { kind, running, status, value, base, started_us, start_edge, enable_edge })
}

fn counter(reader: &mut Reader<'_>) -> Option<Counter> {
    let count = reader.u16().filter(|&count| count <= COUNT_MAX)?;
    let [set_edge, up_edge, down_edge, enable_edge] = flags(reader.u8()?)?;
    Some(Counter { count, set_edge, up_edge, down_edge, enable_edge })
}

/// The kinds of timers by their number in an image.
const KINDS: [TimerKind; 5] =
    [TimerKind::Pulse, TimerKind::ExtendedPulse, TimerKind::OnDelay, TimerKind::RetentiveOnDelay, TimerKind::OffDelay];

/// A timer as an image has it.
pub(super) fn timer_bytes(timer: &Timer) -> [u8; TIMER_BYTES] {
    let mut bytes = [0; TIMER_BYTES];
    bytes[0] = KINDS.iter().position(|&kind| kind == timer.kind).unwrap_or_default() as u8;
    bytes[1] = flag_byte([timer.running, timer.status, timer.start_edge, timer.enable_edge]);
    bytes[2..4].copy_from_slice(&timer.value.min(VALUE_MAX).to_be_bytes());
    bytes[4] = timer.base & 3;
    // When one that stands was started is nothing that could be read.
    let started_us = if timer.running { timer.started_us } else { 0 };
    bytes[5..].copy_from_slice(&started_us.to_be_bytes());
    bytes
}

/// A counter as an image has it.
pub(super) fn counter_bytes(counter: &Counter) -> [u8; COUNTER_BYTES] {
    let [high, low] = counter.count.min(COUNT_MAX).to_be_bytes();
    [high, low, flag_byte([counter.set_edge, counter.up_edge, counter.down_edge, counter.enable_edge])]
}

/// The attributes of a created data block as an image has them.
pub(super) fn attribute_byte(attributes: Attributes) -> u8 {
    flag_byte([attributes.read_only, attributes.non_retain, false, false])
}

fn flag_byte(flags: [bool; 4]) -> u8 {
    flags.iter().enumerate().fold(0, |byte, (bit, &flag)| byte | u8::from(flag) << bit)
}

fn flags(byte: u8) -> Option<[bool; 4]> {
    (byte < 16).then(|| [0, 1, 2, 3].map(|bit| byte >> bit & 1 == 1))
}

/// Reads any bytes as an image; what is read without the clock is written as it was.
pub fn fuzz(bytes: &[u8]) {
    let Some(parsed) = parse(bytes) else { return };
    for part in &parsed.parts {
        match part {
            Part::Timer { timer, .. } => {
                let again = timer_bytes(timer);
                assert_eq!(self::timer(&mut Reader(&again), parsed.clock_us).map(|timer| timer_bytes(&timer)), Some(again));
            }
            Part::Counter { counter, .. } => {
                assert_eq!(self::counter(&mut Reader(&counter_bytes(counter))).as_ref(), Some(counter));
            }
            Part::BitMemory { .. } | Part::DataBlock { .. } | Part::Created { .. } | Part::Loaded { .. } | Part::Gone { .. } => {}
        }
    }
}

struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn bytes(&mut self, length: usize) -> Option<&'a [u8]> {
        let (bytes, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        Some(bytes)
    }
    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.bytes(N)?.try_into().ok()
    }
    fn u8(&mut self) -> Option<u8> {
        self.array().map(u8::from_be_bytes)
    }
    fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_be_bytes)
    }
    fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_be_bytes)
    }
    fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_be_bytes)
    }
}
