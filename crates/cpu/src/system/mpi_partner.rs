//! What SFC 65 and 67 to 69 have in common: a partner on the MPI network. Nobody answers there.

use sieben_model::address::Width;

use super::Call;
use super::parameters::{Answer, NO_JOB};

/// No address of a partner: the own one, or beyond the last.
const BAD_PARTNER: u16 = 0x8090;
/// What is sent or received has no length, or too much.
const BAD_AREA: u16 = 0x8092;
/// No connection to the partner.
const NO_CONNECTION: u16 = 0x80A1;

/// The MPI address of the CPU.
pub(super) const OWN_ADDRESS: u32 = 2;
/// The highest MPI address.
const ADDRESS_MAX: u32 = 126;
/// Bytes that one job moves at most.
const BYTES_MAX: usize = 76;

/// One call: REQ is parameter 0, DEST_ID parameter `partner`; `area` is the ANY of this CPU and whether it is written.
pub(super) fn job(call: &mut Call<'_, '_>, partner: usize, busy: usize, area: Option<(usize, bool)>) -> Answer {
    call.output(busy, Width::Bit, 0)?;
    if call.input(0, Width::Bit)? == 0 {
        return Ok(NO_JOB);
    }
    let address = call.input(partner, Width::Word)?;
    if address == OWN_ADDRESS || address > ADDRESS_MAX {
        return Err(BAD_PARTNER);
    }
    match area {
        Some((index, write)) => {
            let bytes = call.any(index, write)?;
            if bytes.is_empty() || bytes.len() > BYTES_MAX {
                return Err(BAD_AREA);
            }
            Err(NO_CONNECTION)
        }
        // To close a connection that is not open is no error.
        None => Ok(0),
    }
}
