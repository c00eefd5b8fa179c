//! What SFC 13, 58 and 59 have in common: jobs for the data records of a module. The modules of this CPU have none, so that
//! every job ends in the call that starts it.

use sieben_model::address::Width;

use super::Call;
use super::modules::NO_RECORD;
use super::parameters::{Answer, NO_JOB};

/// The ANY is not one of BYTE.
const NOT_BYTE: u16 = 0x8092;
/// The record is longer than any.
const TOO_LONG: u16 = 0x80B1;
/// The type code of BYTE in an ANY.
const BYTE: u8 = 0x02;
/// Greatest length of a data record.
const RECORD_BYTES_MAX: usize = 240;

/// A call with REQ as parameter 0, IOID, LADDR and RECNUM behind it.
pub(super) fn job(call: &mut Call<'_, '_>, record: usize, busy: usize, write: bool) -> Answer {
    call.output(busy, Width::Bit, 0)?;
    if call.input(0, Width::Bit)? == 0 {
        return Ok(NO_JOB);
    }
    call.addressed(1)?;
    call.byte_area(record, !write)?;
    // Whatever its number, the module does not know the record.
    call.input(3, Width::Byte)?;
    Err(NO_RECORD)
}

impl Call<'_, '_> {
    /// Checks an ANY of BYTE that holds a data record.
    pub(super) fn byte_area(&self, index: usize, write: bool) -> Result<(), u16> {
        let [_, code, ..] = self.passed::<10>(index, write)?;
        let bytes = self.any(index, write)?;
        if code != BYTE {
            return Err(NOT_BYTE);
        }
        if bytes.is_empty() || bytes.len() > RECORD_BYTES_MAX {
            return Err(TOO_LONG);
        }
        Ok(())
    }
}
