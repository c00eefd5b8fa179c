//! Two runs never share retentive data: the first one holds a lock until it ends, however it ends.

use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::path::Path;

use super::disk::{folder, make_folder, with_ending};

/// Why there is no lock.
#[derive(Debug)]
pub(crate) enum NoLock {
    /// Another run has it.
    Taken,
    /// The file of the lock cannot be made; on a read-only disk nobody else can write either.
    Failed(io::Error),
}

/// Locks the data at a path; the lock ends with the file, and that at the latest with the process.
pub(crate) fn lock(path: &Path) -> Result<File, NoLock> {
    if let Some(folder) = folder(path) {
        make_folder(folder).map_err(NoLock::Failed)?;
    }
    let file = OpenOptions::new().write(true).create(true).truncate(false).open(with_ending(path, "lock")).map_err(NoLock::Failed)?;
    match file.try_lock() {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => Err(NoLock::Taken),
        Err(TryLockError::Error(error)) => Err(NoLock::Failed(error)),
    }
}
