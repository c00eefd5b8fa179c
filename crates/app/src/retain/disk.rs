//! What keeping data asks of a file system: the seam where tests put one that fails.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The folder of a project for what a run leaves there.
pub(super) const FOLDER: &str = ".sieben";

/// A file that is written in place.
pub(crate) trait Slotted: Send {
    /// Writes at an offset inside the file.
    fn write_at(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()>;
    /// Returns when everything that was written is on the disk.
    fn sync(&mut self) -> io::Result<()>;
}

/// A file system.
pub(crate) trait Disk: Send + Sync {
    /// A file of it.
    type File: Slotted;
    /// The bytes of a file.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;
    /// Replaces a file as a whole: after a crash there is the old one or the new one. When this returns, the new one is on the disk.
    fn create(&self, path: &Path, content: &[u8]) -> io::Result<Self::File>;
}

/// The file system of this computer.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RealDisk;

/// Most bytes of a file of retentive data: two slots for the largest CPU type, several times over.
const FILE_BYTES_MAX: u64 = 1 << 30;

impl Disk for RealDisk {
    type File = File;

    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let metadata = fs::metadata(path)?;
        if !metadata.is_file() {
            return Err(io::Error::other("it is no file"));
        }
        if metadata.len() > FILE_BYTES_MAX {
            return Err(io::Error::other("it is larger than retentive data can be"));
        }
        fs::read(path)
    }

    fn create(&self, path: &Path, content: &[u8]) -> io::Result<File> {
        if let Some(folder) = folder(path) {
            make_folder(folder)?;
        }
        let temporary = with_ending(path, "new");
        let written = OpenOptions::new().write(true).create(true).truncate(true).open(&temporary).and_then(|mut file| {
            file.write_all(content)?;
            file.sync_all()?;
            fs::rename(&temporary, path)?;
            Ok(file)
        });
        let file = written.inspect_err(|_| {
            // The first error matters more.
            let _ = fs::remove_file(&temporary);
        })?;
        sync_folder(folder(path).unwrap_or(Path::new(".")))?;
        Ok(file)
    }
}

impl Slotted for File {
    fn write_at(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        use std::io::{Seek, SeekFrom};
        self.seek(SeekFrom::Start(offset))?;
        self.write_all(bytes)
    }

    fn sync(&mut self) -> io::Result<()> {
        self.sync_data()
    }
}

/// A new name is on the disk when its folder is. Where a folder cannot be opened, its system keeps names by itself.
fn sync_folder(folder: &Path) -> io::Result<()> {
    match File::open(folder) {
        Ok(folder) => folder.sync_all(),
        Err(_) => Ok(()),
    }
}

/// The file behind symbolic links: replacing a file by its path would replace the link, and two names of one file would have two locks.
pub(crate) fn behind_links(path: &Path) -> PathBuf {
    /// As many links as Linux follows in one path.
    const LINKS_MAX: usize = 40;
    let mut path = path.to_path_buf();
    for _ in 0..LINKS_MAX {
        match fs::read_link(&path) {
            Ok(target) => path = folder(&path).map(|folder| folder.join(&target)).unwrap_or(target),
            Err(_) => break,
        }
    }
    path
}

/// The folder of a path, if it names one.
pub(crate) fn folder(path: &Path) -> Option<&Path> {
    path.parent().filter(|folder| !folder.as_os_str().is_empty())
}

/// Makes the folder for the data of a project; version control leaves its content alone.
pub(crate) fn make_folder(folder: &Path) -> io::Result<()> {
    if !folder.is_dir() {
        fs::create_dir_all(folder)?;
        // What is synced in a folder that a power failure takes away would be lost with it.
        sync_folder(self::folder(folder).unwrap_or(Path::new(".")))?;
    }
    let ignore = folder.join(".gitignore");
    if folder.file_name().is_some_and(|name| name == FOLDER) && !ignore.exists() {
        fs::write(ignore, "*\n")?;
    }
    Ok(())
}

/// A file beside another: `retain.bin.synced`.
pub(crate) fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    PathBuf::from(name)
}
