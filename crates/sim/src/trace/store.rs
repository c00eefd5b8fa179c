//! Where the blocks of a trace are kept: in memory here, in a file where there are files.

use std::fmt;

/// Why a store does not take or give bytes, in one sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StoreError(pub String);

impl fmt::Display for StoreError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for StoreError {}

/// Bytes that are written once, from the first to the last, and read anywhere.
pub trait Store: Send {
    /// Writes bytes behind those that are there.
    ///
    /// # Errors
    /// There is no room; what was written before is still there.
    fn append(&mut self, bytes: &[u8]) -> Result<(), StoreError>;

    /// Reads the bytes from a place on; fewer at the end.
    ///
    /// # Errors
    /// They cannot be read.
    fn read(&self, offset: u64, into: &mut [u8]) -> Result<usize, StoreError>;

    /// How many bytes there are.
    ///
    /// # Errors
    /// It cannot be asked.
    fn size(&self) -> Result<u64, StoreError>;
}

/// Bytes of a store in memory when nobody says otherwise: days of a few channels that change.
pub const MEMORY_BYTES_MAX: usize = 64 << 20;

/// A store in memory.
#[derive(Clone, Debug)]
pub struct Memory {
    bytes: Vec<u8>,
    bytes_max: usize,
}

impl Memory {
    /// An empty store for so many bytes.
    pub fn new(bytes_max: usize) -> Self {
        Self { bytes: Vec::new(), bytes_max }
    }

    /// A store that holds these bytes.
    pub fn of(bytes: Vec<u8>) -> Self {
        let bytes_max = bytes.len();
        Self { bytes, bytes_max }
    }

    /// What was written.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

impl Default for Memory {
    fn default() -> Self {
        Self::new(MEMORY_BYTES_MAX)
    }
}

impl Store for Memory {
    fn append(&mut self, bytes: &[u8]) -> Result<(), StoreError> {
        if self.bytes.len().saturating_add(bytes.len()) > self.bytes_max {
            return Err(StoreError(format!("the trace does not fit into {} bytes of memory", self.bytes_max)));
        }
        self.bytes.extend_from_slice(bytes);
        Ok(())
    }

    fn read(&self, offset: u64, into: &mut [u8]) -> Result<usize, StoreError> {
        let from = usize::try_from(offset).ok().and_then(|offset| self.bytes.get(offset..)).unwrap_or_default();
        let count = from.len().min(into.len());
        into[..count].copy_from_slice(&from[..count]);
        Ok(count)
    }

    fn size(&self) -> Result<u64, StoreError> {
        Ok(self.bytes.len() as u64)
    }
}
