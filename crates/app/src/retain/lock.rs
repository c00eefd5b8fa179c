//! Two runs never share retentive data: the first one holds a lock until it ends, however it ends.

use std::fs::{File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use super::disk::{make_folder, open_folder, with_ending};
use super::store::synced_path;

/// Why there is no lock.
#[derive(Debug)]
pub(crate) enum NoLock {
    /// Another run has it.
    Taken,
    /// The file of the lock cannot be made; on a read-only disk nobody else can write either.
    Failed(io::Error),
}

/// A lock of the data at a path; it ends with its file, and that at the latest with the process.
#[derive(Debug)]
pub(crate) struct Lock {
    path: PathBuf,
    file: File,
}

/// How often the file of the lock may be gone the moment it is locked, before that is an error.
const TRIES_MAX: usize = 10;

impl Lock {
    /// Locks the data.
    pub(crate) fn take(path: &Path) -> Result<Self, NoLock> {
        for _ in 0..TRIES_MAX {
            let file = with_ending(path, "lock");
            let (folder, name) = make_folder(&file).map_err(NoLock::Failed)?;
            let lock = Self { path: path.to_path_buf(), file: folder.write(name).map_err(NoLock::Failed)? };
            match lock.file.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Err(NoLock::Taken),
                Err(TryLockError::Error(error)) => return Err(NoLock::Failed(error)),
            }
            // Another file may have got the name between opening and locking: then the lock is one of nothing.
            if lock.is_held() {
                return if [path.to_path_buf(), synced_path(path)].iter().any(|path| in_use(path)) { Err(NoLock::Taken) } else { Ok(lock) };
            }
        }
        Err(NoLock::Failed(io::Error::other("the file of the lock is replaced again and again")))
    }

    /// Whether the file that is locked still has the name by which other runs find it.
    pub(crate) fn is_held(&self) -> bool {
        open_folder(&with_ending(&self.path, "lock")).is_ok_and(|(folder, name)| folder.names(name, &self.file))
    }

    /// The data that is locked.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }
}

/// Whether a run that lost its lock still writes a file of data: each is locked as long as it is open.
fn in_use(path: &Path) -> bool {
    let file = open_folder(path).and_then(|(folder, name)| folder.read(name));
    file.is_ok_and(|file| matches!(file.try_lock(), Err(TryLockError::WouldBlock)))
}
