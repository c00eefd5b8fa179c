//! What SFC 83 and 84 have in common: data blocks in the load memory, and jobs over two calls.

use std::ops::Range;

use sieben_model::address::{Area, Width};

use super::Call;
use super::any::element_bytes;
use super::parameters::{Answer, NO_JOB, Refused, STARTED};

/// There is no such data block in the load memory.
const NOT_THERE: u16 = 0x80B1;
/// As many jobs as can be run already.
const BUSY: u16 = 0x80C3;
/// Jobs at the same time.
const JOBS_MAX: usize = 8;
/// The destination is longer than the source: all of the source was copied.
const DESTINATION_LONGER: u32 = 0x0081;
/// The source is longer than the destination: the rest of it was not copied.
const SOURCE_LONGER: u16 = 0x8081;

/// Bytes of a data block in the load memory.
pub(super) struct Loaded {
    pub(super) number: u16,
    pub(super) bytes: Range<usize>,
}

/// One call of function `number`, with REQ as parameter 0 and BUSY as parameter 3. The first call starts the job, the next one
/// does it with `run`, which answers the bytes of source and destination.
pub(super) fn job(call: &mut Call<'_, '_>, number: u16, run: fn(&mut Call<'_, '_>) -> Result<[usize; 2], u16>) -> Answer {
    call.output(3, Width::Bit, 0)?;
    let request = call.input(0, Width::Bit)? == 1;
    let id = (number, call.passed::<10>(1, false)?);
    if let Some(index) = call.host.system.jobs.iter().position(|job| *job == id) {
        call.host.system.jobs.remove(index);
        let [source, destination] = run(call)?;
        return match source.cmp(&destination) {
            std::cmp::Ordering::Equal => Ok(0),
            std::cmp::Ordering::Less => Ok(DESTINATION_LONGER),
            std::cmp::Ordering::Greater => Err(SOURCE_LONGER),
        };
    }
    if !request {
        return Ok(NO_JOB);
    }
    if call.host.system.jobs.len() >= JOBS_MAX {
        return Err(BUSY);
    }
    call.host.system.jobs.push(id);
    call.output(3, Width::Bit, 1)?;
    Ok(STARTED)
}

impl Call<'_, '_> {
    /// The bytes in the load memory that an ANY parameter means.
    pub(super) fn loaded(&self, index: usize, write: bool) -> Result<Loaded, u16> {
        let [syntax, code, c1, c0, d1, d0, p3, p2, p1, p0] = self.passed::<10>(index, write)?;
        let pointer = u32::from_be_bytes([p3, p2, p1, p0]);
        let number = u16::from_be_bytes([d1, d0]);
        let count = usize::from(u16::from_be_bytes([c1, c0]));
        let refuse = |refused: Refused| refused.when(write).of(index);
        let bytes = match element_bytes(code) {
            _ if syntax != 0x10 || p3 != Area::SharedData.pointer_code() => return Err(refuse(Refused::AREA)),
            Some(element) => count * element as usize,
            None if code == 0x01 && count.is_multiple_of(8) => count / 8,
            None => return Err(refuse(Refused::AREA)),
        };
        if pointer & 7 != 0 {
            return Err(refuse(Refused::BIT));
        }
        let block = self.host.program.data.get(&number).ok_or(NOT_THERE)?;
        let start = ((pointer & 0x00FF_FFFF) >> 3) as usize;
        if start + bytes > block.image.len() {
            return Err(refuse(Refused::LENGTH));
        }
        Ok(Loaded { number, bytes: start..start + bytes })
    }
}
