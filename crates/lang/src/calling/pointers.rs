//! What is passed for a parameter: pointers, POINTER and ANY.

use sieben_model::address::Width;
use sieben_model::literal::any_type_code;
use sieben_model::types::DataType;

/// Where the parameters of a called block see the local data of its caller: area V.
pub(crate) const CALLER_LOCAL: u32 = 0x8700_0000;
/// The area of data blocks in a pointer.
pub(crate) const IN_DATA_BLOCK: u32 = 0x8400_0000;
/// Where the area stands in a pointer; that of the local data of the caller is the next one after that of a block's own.
pub(crate) const AREA_SHIFT: u64 = 24;
/// The byte and bit address in a pointer.
pub(crate) const ADDRESS_MASK: u64 = 0x0007_FFFF;

/// Bytes of a POINTER.
pub(crate) const POINTER_BYTES: u32 = 6;
/// Bytes of an ANY.
pub(crate) const ANY_BYTES: u32 = 10;
/// The first word of an ANY of the S7, without the type code.
pub(crate) const ANY_OF_S7: u64 = 0x1000;
/// The two parts of a POINTER: offset in bits and width.
pub(crate) const POINTER_PARTS: [(u32, Width); 2] = [(0, Width::Word), (16, Width::DoubleWord)];
/// Parts of an ANY as it is copied: offset in bits and width.
pub(crate) const ANY_PARTS: [(u32, Width); 3] = [(0, Width::DoubleWord), (32, Width::Word), (48, Width::DoubleWord)];
/// Type code of an ANY to bytes.
const ANY_OF_BYTES: u8 = 0x02;

/// Type code and count of an ANY: complex values count as bytes.
pub(crate) fn any_type(data_type: &DataType) -> (u8, u32) {
    let single = data_type.is_elementary() || *data_type == DataType::DateAndTime;
    match data_type.word().filter(|_| single).and_then(any_type_code) {
        Some(code) => (code, 1),
        None => (ANY_OF_BYTES, bytes_of(data_type)),
    }
}

/// Bytes that a value of the type takes; bits take one.
pub(crate) fn bytes_of(data_type: &DataType) -> u32 {
    u32::try_from(data_type.bits().div_ceil(8)).unwrap_or(u32::MAX)
}
