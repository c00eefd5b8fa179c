//! What SFB 52 and 53 have in common: jobs for data records, with a STATUS of four bytes. The modules have no records.

use super::Call;
use super::instance::Instance;
use super::modules::{NO_MODULE, NO_RECORD};
use crate::slots;

/// RECORD is no area, or shorter than the data.
const BAD_RECORD: u16 = 0x8092;
/// More bytes than a data record has.
const BAD_LENGTH: u16 = 0x80B1;
/// Greatest length of a data record.
const RECORD_BYTES_MAX: i16 = 240;

const REQ: usize = 0;
const ID: usize = 2;
/// MLEN or LEN.
const LENGTH: usize = 8;
/// VALID or DONE, BUSY, ERROR.
const OUTPUTS: usize = 10;
const STATUS: usize = 12;

/// Where the variables lie in which the two differ.
pub(super) struct Block {
    /// First byte of STATUS after an error.
    pub(super) function: u8,
    pub(super) record: usize,
    /// The length that was read.
    pub(super) length: Option<usize>,
    pub(super) reads: bool,
}

/// One call. REQ is a level: as long as it is 1, each call is a job that ends at once. The answer is BR.
pub(super) fn call(call: &mut Call<'_, '_>, block: &Block) -> bool {
    let bytes = block.record as u32 + 10;
    let Some(instance) = Instance::open(call.machine, bytes) else { return false };
    let request = instance.bit(REQ, 0);
    let id = instance.double_word(ID);
    let length = instance.int(LENGTH);
    let record: [u8; 10] = std::array::from_fn(|index| instance.byte(block.record + index));
    let code = if request { Some(refusal(call, block, id, length, record)) } else { None };
    let Some(mut instance) = Instance::open(call.machine, bytes) else { return false };
    instance.set_bit(OUTPUTS, 0, false);
    instance.set_bit(OUTPUTS, 1, false);
    instance.set_bit(OUTPUTS, 2, request);
    instance.set_double_word(STATUS, code.map_or(0, |code| u32::from(block.function) << 24 | u32::from(code) << 8));
    if let Some(at) = block.length {
        instance.set_word(at, 0);
    }
    !request
}

/// Why there is no such record.
fn refusal(call: &Call<'_, '_>, block: &Block, id: u32, length: i16, record: [u8; 10]) -> u16 {
    // Bit 15 of ID tells the outputs of a module from its inputs.
    let (address, output) = (id & 0x7FFF, id & 0x8000 != 0);
    if id > 0xFFFF || slots::at(call.host.rack, address, output).is_none() {
        return NO_MODULE;
    }
    if !(0..=RECORD_BYTES_MAX).contains(&length) {
        return BAD_LENGTH;
    }
    match call.area(record, block.reads) {
        Ok(bytes) if bytes.len() >= length as usize => NO_RECORD,
        _ => BAD_RECORD,
    }
}
