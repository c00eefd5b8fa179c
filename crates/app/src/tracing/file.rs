//! Stores of traces on the disk: a recording that stays, or a temporary file for what is too long for memory.

use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use sieben_model::problems::Problem;
use sieben_sim::trace::{Memory, Store, StoreError};

use crate::failure::Failure;
use crate::files;

/// Bytes that stay in memory before they go to a file: short traces never touch the disk.
const MEMORY_BYTES_MAX: u64 = 16 << 20;

/// A file that a trace is written to or read from.
pub(crate) struct Disk {
    path: PathBuf,
    file: File,
    size: u64,
    /// Nobody wants it afterwards.
    temporary: bool,
}

impl Disk {
    /// A recording that stays; what was in the file is gone.
    pub(crate) fn create(path: &Path) -> Result<Self, Failure> {
        if path.is_dir() {
            return Err(Failure::usage(Problem::P6013, format!("`{}` is a folder, so no file can be written there", path.display())));
        }
        let opened = OpenOptions::new().read(true).write(true).create(true).truncate(true).open(path);
        let file = opened.map_err(|error| files::unwritable(path, &error))?;
        Ok(Self { path: path.to_path_buf(), file, size: 0, temporary: false })
    }

    /// A recording that was written before.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let file = files::open(path)?;
        let size = file.metadata().map_err(|error| files::unreadable(path, &error))?.len();
        Ok(Self { path: path.to_path_buf(), file, size, temporary: false })
    }

    fn temporary() -> io::Result<Self> {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let name = format!("sieben-trace-{}-{}.tmp", std::process::id(), NUMBER.fetch_add(1, Ordering::Relaxed));
        let path = std::env::temp_dir().join(name);
        let file = OpenOptions::new().read(true).write(true).create_new(true).open(&path)?;
        Ok(Self { path, file, size: 0, temporary: true })
    }

    fn unwritable(&self, error: &io::Error) -> StoreError {
        let full = if error.kind() == io::ErrorKind::StorageFull { "; the scans before are in it" } else { "" };
        StoreError(format!("`{}` cannot be written: {error}{full}", self.path.display()))
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        if self.temporary {
            // A file that cannot be removed stays where temporary files are.
            let _ = std::fs::remove_file(&self.path);
        }
    }
}

impl Store for Disk {
    fn append(&mut self, bytes: &[u8]) -> Result<(), StoreError> {
        // Reading moves the place, too.
        let written = self.file.seek(SeekFrom::Start(self.size)).and_then(|_| self.file.write_all(bytes));
        written.map_err(|error| self.unwritable(&error))?;
        self.size += bytes.len() as u64;
        Ok(())
    }

    fn read(&self, offset: u64, into: &mut [u8]) -> Result<usize, StoreError> {
        let mut file = &self.file;
        file.seek(SeekFrom::Start(offset))
            .and_then(|_| file.read(into))
            .map_err(|error| StoreError(format!("`{}` cannot be read: {error}", self.path.display())))
    }

    fn size(&self) -> Result<u64, StoreError> {
        Ok(self.size)
    }
}

/// A store that stays in memory as long as it is small.
pub(crate) enum Spill {
    /// It is.
    Small(Memory),
    /// It was not.
    Large(Disk),
}

impl Default for Spill {
    fn default() -> Self {
        Self::Small(Memory::new(usize::MAX))
    }
}

impl Store for Spill {
    fn append(&mut self, bytes: &[u8]) -> Result<(), StoreError> {
        match self {
            Self::Small(memory) if memory.size()?.saturating_add(bytes.len() as u64) <= MEMORY_BYTES_MAX => memory.append(bytes),
            Self::Small(memory) => {
                let mut disk = Disk::temporary().map_err(|error| {
                    let folder = std::env::temp_dir();
                    StoreError(format!("a long trace needs a temporary file, but none can be made in `{}`: {error}", folder.display()))
                })?;
                disk.append(memory.bytes())?;
                disk.append(bytes)?;
                *self = Self::Large(disk);
                Ok(())
            }
            Self::Large(disk) => disk.append(bytes),
        }
    }

    fn read(&self, offset: u64, into: &mut [u8]) -> Result<usize, StoreError> {
        match self {
            Self::Small(memory) => memory.read(offset, into),
            Self::Large(disk) => disk.read(offset, into),
        }
    }

    fn size(&self) -> Result<u64, StoreError> {
        match self {
            Self::Small(memory) => memory.size(),
            Self::Large(disk) => disk.size(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_store_that_grows_goes_to_a_file_and_keeps_every_byte() {
        let mut store = Spill::default();
        let block: Vec<u8> = (0..=255).cycle().take(1 << 20).collect();
        for _ in 0..20 {
            store.append(&block).expect("the temporary folder has room");
        }
        let Spill::Large(disk) = &store else { panic!("20 MiB stay in memory") };
        let path = disk.path.clone();
        assert!(path.exists());
        assert_eq!(store.size(), Ok(20 << 20));
        let mut read = vec![0; 1000];
        for offset in [0, (16 << 20) - 500, (19 << 20) + 77] {
            assert_eq!(store.read(offset, &mut read), Ok(1000));
            assert!(read.iter().zip(offset..).all(|(&byte, at)| byte == (at % 256) as u8), "{offset}");
        }
        drop(store);
        assert!(!path.exists());
    }
}
