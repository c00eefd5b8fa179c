//! The bytes of a block: scans as changes, numbers in groups of seven bits.
//!
//! ```text
//! block  := all row*
//! all    := 0  scan time step change*         the first scan: every channel that has a value
//! row    := 1  count                          so many scans, each `step` behind the one before, nothing changed
//!         | 2  changes change*                a scan `step` behind the one before
//!         | 3  step changes change*           a scan with a new step
//!         | 4  scan time step changes change* a scan anywhere behind
//! change := channel value                      in the order of the channels
//! value  := 0 absent | 1 bits 0 | 2 bits 1 | 3 number | 4 eight bytes | 5 length bytes
//! ```

use super::{Channel, Moment, SCANS_MAX, Scans, TraceError};
use crate::names::{Kind, Sample, TEXT_BYTES_MAX};

const ALL: u8 = 0;
const REPEAT: u8 = 1;
const NEXT: u8 = 2;
const STEP: u8 = 3;
const ANYWHERE: u8 = 4;

/// Writes blocks.
#[derive(Debug, Default)]
pub(super) struct Encoder {
    bytes: Vec<u8>,
    first_scan: u64,
    /// The last scan, if the block has begun.
    last: Option<Moment>,
    step_us: u64,
    /// Scans behind `last` that are not written yet.
    repeated: u64,
}

impl Encoder {
    /// Bytes of the block so far.
    pub(super) fn len(&self) -> usize {
        self.bytes.len()
    }

    /// Adds a scan whose number is above and whose time is not below those of the one before. `values` are those of all channels behind
    /// the scan, `changed` the numbers of those that differ from the scan before, in rising order.
    pub(super) fn scan(&mut self, moment: Moment, values: &[Sample], changed: &[usize]) {
        let Some(last) = self.last else {
            self.first_scan = moment.scan;
            self.bytes.push(ALL);
            self.numbers([moment.scan, moment.time_us, self.step_us]);
            for value in values {
                encode(&mut self.bytes, value);
            }
            self.last = Some(moment);
            return;
        };
        let next = moment.scan == last.scan.wrapping_add(1);
        let step_us = moment.time_us.saturating_sub(last.time_us);
        self.last = Some(moment);
        if next && step_us == self.step_us && changed.is_empty() {
            self.repeated += 1;
            return;
        }
        self.flush();
        if !next {
            self.bytes.push(ANYWHERE);
            self.numbers([moment.scan, moment.time_us, step_us]);
        } else if step_us == self.step_us {
            self.bytes.push(NEXT);
        } else {
            self.bytes.push(STEP);
            self.numbers([step_us]);
        }
        self.step_us = step_us;
        self.numbers([changed.len() as u64]);
        for &channel in changed {
            self.numbers([channel as u64]);
            encode(&mut self.bytes, &values[channel]);
        }
    }

    /// The block, and the number of its first scan; `None` if no scan was added. The next block begins.
    pub(super) fn take(&mut self) -> Option<(u64, Vec<u8>)> {
        self.flush();
        self.last.take().map(|_| (self.first_scan, std::mem::take(&mut self.bytes)))
    }

    fn flush(&mut self) {
        if self.repeated > 0 {
            self.bytes.push(REPEAT);
            number(&mut self.bytes, std::mem::take(&mut self.repeated));
        }
    }

    fn numbers<const N: usize>(&mut self, numbers: [u64; N]) {
        for value in numbers {
            number(&mut self.bytes, value);
        }
    }
}

/// Writes a number in groups of seven bits, the lowest first.
pub(super) fn number(bytes: &mut Vec<u8>, mut value: u64) {
    while value >= 0x80 {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8);
}

/// Writes a length and the bytes of a text.
pub(super) fn text(bytes: &mut Vec<u8>, text: &str) {
    number(bytes, text.len() as u64);
    bytes.extend_from_slice(text.as_bytes());
}

fn encode(bytes: &mut Vec<u8>, value: &Sample) {
    match value {
        Sample::Absent => bytes.push(0),
        Sample::Bits(0) => bytes.push(1),
        Sample::Bits(1) => bytes.push(2),
        // A negative or REAL number is shorter as it is than in groups of seven bits.
        Sample::Bits(bits) if *bits >> 48 != 0 => {
            bytes.push(4);
            bytes.extend_from_slice(&bits.to_le_bytes());
        }
        Sample::Bits(bits) => {
            bytes.push(3);
            number(bytes, *bits);
        }
        Sample::Text(value) => {
            bytes.push(5);
            text(bytes, value);
        }
    }
}

/// Reads bytes that may be anything.
pub(super) struct Reader<'a> {
    rest: &'a [u8],
}

impl<'a> Reader<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    pub(super) fn byte(&mut self) -> Option<u8> {
        let (&byte, rest) = self.rest.split_first()?;
        self.rest = rest;
        Some(byte)
    }

    pub(super) fn bytes(&mut self, count: usize) -> Option<&'a [u8]> {
        let (bytes, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        Some(bytes)
    }

    pub(super) fn number(&mut self) -> Option<u64> {
        let mut value = 0_u64;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            let group = u64::from(byte & 0x7F);
            if shift == 63 && group > 1 {
                return None;
            }
            value |= group << shift;
            if byte & 0x80 == 0 {
                return Some(value);
            }
        }
        None
    }

    pub(super) fn text(&mut self, bytes_max: usize) -> Option<&'a str> {
        let length = usize::try_from(self.number()?).ok().filter(|&length| length <= bytes_max)?;
        std::str::from_utf8(self.bytes(length)?).ok()
    }
}

/// What a decoder tells of: rows of scans.
pub(super) type See<'a> = dyn FnMut(Scans<'_>) -> Result<(), TraceError> + 'a;

/// Reads blocks, one behind the other.
pub(super) struct Decoder<'a> {
    channels: &'a [Channel],
    values: Vec<Sample>,
    changed: Vec<usize>,
    last: Option<Moment>,
    step_us: u64,
    scans: u64,
}

impl<'a> Decoder<'a> {
    pub(super) fn new(channels: &'a [Channel]) -> Self {
        Self { channels, values: vec![Sample::Absent; channels.len()], changed: Vec::new(), last: None, step_us: 0, scans: 0 }
    }

    /// Shows the scans of a block, which stands behind the one before.
    pub(super) fn block(&mut self, bytes: &[u8], see: &mut See<'_>) -> Result<(), TraceError> {
        let mut reader = Reader::new(bytes);
        if bytes.first() != Some(&ALL) {
            return Err(damaged());
        }
        while !reader.is_empty() {
            let count = self.row(&mut reader).ok_or_else(damaged)?;
            self.scans = self.scans.saturating_add(count);
            if self.scans > SCANS_MAX {
                return Err(TraceError::TooLong);
            }
            let last = self.last.unwrap_or(Moment { scan: 0, time_us: 0 });
            let back = count - 1;
            let first = Moment { scan: last.scan - back, time_us: last.time_us - back * self.step_us };
            see(Scans { first, count, step_us: self.step_us, values: &self.values, changed: &self.changed })?;
        }
        Ok(())
    }

    /// Reads a row and says how many scans it has; `None` if it is none.
    fn row(&mut self, reader: &mut Reader<'_>) -> Option<u64> {
        self.changed.clear();
        let tag = reader.byte()?;
        let last = self.last;
        let moment = match tag {
            ALL | ANYWHERE => {
                let moment = Moment { scan: reader.number()?, time_us: reader.number()? };
                self.step_us = reader.number()?;
                moment
            }
            REPEAT => {
                let (last, count) = (last?, reader.number()?);
                if count == 0 {
                    return None;
                }
                let time_us = last.time_us.checked_add(self.step_us.checked_mul(count)?)?;
                self.last = Some(Moment { scan: last.scan.checked_add(count)?, time_us });
                return Some(count);
            }
            NEXT | STEP => {
                if tag == STEP {
                    self.step_us = reader.number()?;
                }
                let last = last?;
                Moment { scan: last.scan.checked_add(1)?, time_us: last.time_us.checked_add(self.step_us)? }
            }
            _ => return None,
        };
        if last.is_some_and(|last| moment.scan <= last.scan || moment.time_us < last.time_us) {
            return None;
        }
        self.last = Some(moment);
        if tag == ALL {
            for channel in 0..self.channels.len() {
                self.set(channel, reader)?;
            }
        } else {
            let mut free = 0;
            for _ in 0..reader.number()? {
                let channel = usize::try_from(reader.number()?).ok().filter(|channel| (free..self.channels.len()).contains(channel))?;
                self.set(channel, reader)?;
                free = channel + 1;
            }
        }
        Some(1)
    }

    fn set(&mut self, channel: usize, reader: &mut Reader<'_>) -> Option<()> {
        let is_text = self.channels[channel].kind == Kind::Text;
        let value = match reader.byte()? {
            0 => Sample::Absent,
            tag @ (1 | 2) if !is_text => Sample::Bits(u64::from(tag - 1)),
            3 if !is_text => Sample::Bits(reader.number()?),
            4 if !is_text => Sample::Bits(u64::from_le_bytes(reader.bytes(8)?.try_into().ok()?)),
            5 if is_text => Sample::Text(reader.text(TEXT_BYTES_MAX)?.into()),
            _ => return None,
        };
        // The first scan of a block repeats what did not change.
        if self.values[channel] != value {
            self.values[channel] = value;
            self.changed.push(channel);
        }
        Some(())
    }
}

fn damaged() -> TraceError {
    TraceError::Damaged("the recording is damaged: a block does not hold what its checksum promises".to_owned())
}
