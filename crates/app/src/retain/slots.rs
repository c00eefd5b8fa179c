//! A file with two slots that are written in turn.
//!
//! ```text
//! name 16, bytes of a slot 8, checksum 4      at 0
//! first slot                                  at 4096
//! second slot                                 at 4096 + bytes of a slot
//! ```

use std::io;
use std::path::Path;

use super::disk::{Disk, Slotted};
use super::record::{self, Content, Record};

/// How a file begins.
const NAME: &[u8; 16] = b"sieben retain 1\n";
/// Slots begin and end where pages do, so that no page belongs to both.
const PAGE: usize = 4096;
/// Most bytes of a slot that a file may claim.
const CAPACITY_MAX: u64 = 1 << 28;

/// Whether a write waits for the disk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sync {
    /// Never: the operating system writes when it likes, also after the process has ended.
    Never,
    /// After every write.
    EveryWrite,
}

/// A file that is open for writing.
pub(crate) struct Slots<F> {
    file: F,
    capacity: usize,
    /// The slot that the next record goes to.
    next: usize,
}

/// What a file holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Contents {
    /// The slots.
    Slots([Content; 2]),
    /// It is no file of retentive data.
    Foreign,
}

impl<F: Slotted> Slots<F> {
    /// Makes a file for records of at most so many bytes, with a first record or none; an older file is replaced.
    pub(crate) fn create<D: Disk<File = F>>(disk: &D, path: &Path, bytes: usize, first: &[u8]) -> io::Result<Self> {
        let capacity = bytes.max(first.len()).next_multiple_of(PAGE);
        let mut content = vec![0; PAGE + 2 * capacity];
        content[..16].copy_from_slice(NAME);
        content[16..24].copy_from_slice(&(capacity as u64).to_be_bytes());
        let sum = crc32fast::hash(&content[..24]);
        content[24..28].copy_from_slice(&sum.to_be_bytes());
        content[PAGE..PAGE + first.len()].copy_from_slice(first);
        let file = disk.create(path, &content)?;
        Ok(Self { file, capacity, next: usize::from(!first.is_empty()) })
    }

    /// The file itself.
    pub(crate) fn file(&self) -> &F {
        &self.file
    }

    /// Whether a record has its place here.
    pub(crate) fn takes(&self, record: &[u8]) -> bool {
        record.len() <= self.capacity
    }

    /// Writes a record over the older one, and waits for the disk if told to. Only what succeeded makes the other slot the older one.
    pub(crate) fn write(&mut self, record: &[u8], sync: Sync) -> io::Result<()> {
        self.file.write_at((PAGE + self.next * self.capacity) as u64, record)?;
        if sync == Sync::EveryWrite {
            self.file.sync()?;
        }
        self.next = 1 - self.next;
        Ok(())
    }
}

/// Reads the bytes of a file.
pub(crate) fn read(bytes: &[u8]) -> Contents {
    let Some(head) = bytes.get(..28) else { return Contents::Foreign };
    let sum = head[24..].iter().fold(0, |number: u32, &byte| number << 8 | u32::from(byte));
    let capacity = head[16..24].iter().fold(0, |number: u64, &byte| number << 8 | u64::from(byte));
    if &head[..16] != NAME || sum != crc32fast::hash(&head[..24]) || capacity > CAPACITY_MAX {
        return Contents::Foreign;
    }
    let capacity = capacity as usize;
    let slot = |index: usize| {
        let start = (PAGE + index * capacity).min(bytes.len());
        let end = (start + capacity).min(bytes.len());
        match record::read(&bytes[start..end]) {
            // Nobody knows what was in a slot that the file does not reach: files are made in their full length.
            Content::Empty if end - start < capacity => Content::Damaged,
            content => content,
        }
    };
    Contents::Slots([slot(0), slot(1)])
}

impl Contents {
    /// The newest whole record.
    pub(crate) fn newest(&self) -> Option<&Record> {
        let Self::Slots(slots) = self else { return None };
        let records = slots.iter().filter_map(|content| if let Content::Record(record) = content { Some(record) } else { None });
        records.max_by_key(|record| record.sequence)
    }

    /// Whether anything in it was written and cannot be read.
    pub(crate) fn damaged(&self) -> bool {
        match self {
            Self::Slots(slots) => slots.contains(&Content::Damaged),
            Self::Foreign => true,
        }
    }
}
