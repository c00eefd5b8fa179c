//! An image as it lies in a slot: numbered, and with a checksum over all of it.
//!
//! ```text
//! sequence 8, scan 8, layout 8, length 4, checksum 4, image
//! ```

use sieben_cpu::RetainImage;

/// Bytes before the image.
pub(crate) const HEAD_BYTES: usize = 32;
/// Where the checksum stands.
const CHECKSUM: std::ops::Range<usize> = 28..32;

/// An image with its place in the order of all images.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Record {
    /// Counts every record of these files, from 1. The clock of the computer plays no part: it may run backwards.
    pub(crate) sequence: u64,
    /// What is kept.
    pub(crate) image: RetainImage,
}

/// What a slot holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Content {
    /// It was never written.
    Empty,
    /// A whole record.
    Record(Record),
    /// Something that is none: a write that was cut, or damage.
    Damaged,
}

/// Puts an image into bytes that are written as one.
pub(crate) fn write(bytes: &mut Vec<u8>, sequence: u64, image: &RetainImage) {
    bytes.clear();
    bytes.extend(sequence.to_be_bytes());
    bytes.extend(image.scan.to_be_bytes());
    bytes.extend(image.layout.to_be_bytes());
    // An image is smaller than the memory of a CPU type; one that is not would be found damaged.
    bytes.extend(u32::try_from(image.bytes.len()).unwrap_or(u32::MAX).to_be_bytes());
    bytes.extend([0; 4]);
    bytes.extend(&image.bytes);
    let sum = checksum(bytes);
    bytes[CHECKSUM].copy_from_slice(&sum.to_be_bytes());
}

/// Reads a slot.
pub(crate) fn read(slot: &[u8]) -> Content {
    match record(slot) {
        Some(record) => Content::Record(record),
        // Only a slot that was never written is all zeros.
        None if slot.iter().all(|&byte| byte == 0) => Content::Empty,
        None => Content::Damaged,
    }
}

fn record(slot: &[u8]) -> Option<Record> {
    let (head, rest) = slot.split_at_checked(HEAD_BYTES)?;
    let number = |at: usize| head[at..at + 8].iter().fold(0, |number: u64, &byte| number << 8 | u64::from(byte));
    let (length, sum) = (number(24) >> 32, number(24) as u32);
    let length = usize::try_from(length).ok().filter(|&length| length <= rest.len())?;
    let sequence = number(0);
    (sequence > 0 && checksum(&slot[..HEAD_BYTES + length]) == sum)
        .then(|| Record { sequence, image: RetainImage { bytes: rest[..length].to_vec(), layout: number(16), scan: number(8) } })
}

/// Over everything but the checksum itself.
fn checksum(record: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&record[..CHECKSUM.start]);
    hasher.update(&record[CHECKSUM.end..]);
    hasher.finalize()
}
