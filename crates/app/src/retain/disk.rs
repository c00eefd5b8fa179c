//! What keeping data asks of a file system: the seam where tests put one that fails.

use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::lock::{Lock, NoLock};
use crate::folder::{Folder, Foreign, parts};

/// The folder of a project for what a run leaves there.
pub(super) const FOLDER: &str = ".sieben";
/// What keeps version control away from it.
const IGNORE: &str = ".gitignore";

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
    /// Whether a file that was created still has its name: it may have been removed or replaced.
    fn has(&self, path: &Path, file: &Self::File) -> bool;
}

/// The file system of this computer.
#[derive(Debug, Default)]
pub(crate) struct RealDisk {
    /// Keeps other runs away from what is created here.
    lock: Option<Mutex<Lock>>,
}

/// Most bytes of a file of retentive data: two slots for the largest CPU type, several times over.
const FILE_BYTES_MAX: u64 = 1 << 30;

impl RealDisk {
    /// A disk whose files at `path` no other run writes as long as this one lives.
    pub(crate) fn locked(path: &Path) -> Result<Self, NoLock> {
        Ok(Self { lock: Some(Mutex::new(Lock::take(path)?)) })
    }

    /// Whoever removed the folder removed the lock with it: it is taken again before anything is made anew.
    fn hold_lock(&self) -> io::Result<()> {
        let Some(lock) = &self.lock else { return Ok(()) };
        let mut lock = lock.lock().unwrap_or_else(PoisonError::into_inner);
        if !lock.is_held() {
            *lock = Lock::take(lock.path()).map_err(|why| match why {
                NoLock::Taken => io::Error::other("another run uses it"),
                NoLock::Failed(error) => error,
            })?;
        }
        Ok(())
    }
}

impl Disk for RealDisk {
    type File = File;

    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let (folder, name) = open_folder(path)?;
        let file = folder.read(name)?;
        if file.metadata()?.len() > FILE_BYTES_MAX {
            return Err(io::Error::other("it is larger than retentive data can be"));
        }
        let mut bytes = Vec::new();
        file.take(FILE_BYTES_MAX).read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    fn create(&self, path: &Path, content: &[u8]) -> io::Result<File> {
        self.hold_lock()?;
        let (folder, name) = make_folder(path)?;
        // Also a run that finds no lock, because somebody removed it, finds that the data itself is locked.
        let locked = |file: &File| drop(file.try_lock());
        folder.replace(name, &with_name_ending(name, "new"), content, locked)
    }

    fn has(&self, path: &Path, file: &File) -> bool {
        open_folder(path).is_ok_and(|(folder, name)| folder.names(name, file))
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

/// The file behind symbolic links that the user names: replacing a file by its path would replace the link, and two names of one file
/// would have two locks.
pub(crate) fn behind_links(path: &Path) -> PathBuf {
    /// As many links as Linux follows in one path.
    const LINKS_MAX: usize = 40;
    let mut path = path.to_path_buf();
    for _ in 0..LINKS_MAX {
        match fs::read_link(&path) {
            Ok(target) => path = path.parent().map(|folder| folder.join(&target)).unwrap_or(target),
            Err(_) => break,
        }
    }
    path
}

/// Opens the folder of a file and gives the name of the file in it. The folder for the data of a project is no link.
pub(crate) fn open_folder(path: &Path) -> io::Result<(Folder, &OsStr)> {
    let (folder, name) = parts(path)?;
    match folder.file_name() {
        Some(own) if own == FOLDER => Ok((Folder::open(&parts(&folder)?.0)?.inner(own)?, name)),
        _ => Ok((Folder::open(&folder)?, name)),
    }
}

/// As [`open_folder`], and makes the folder; version control leaves the data of a project alone.
pub(crate) fn make_folder(path: &Path) -> io::Result<(Folder, &OsStr)> {
    let (folder, name) = parts(path)?;
    let above = if folder.file_name().is_some_and(|own| own == FOLDER) { parts(&folder)?.0 } else { folder.clone() };
    if !above.as_os_str().is_empty() {
        fs::create_dir_all(&above)?;
    }
    let Some(own) = folder.file_name().filter(|own| *own == FOLDER) else { return Ok((Folder::open(&folder)?, name)) };
    let folder = Folder::open(&above)?.make(own)?;
    if !folder.holds(OsStr::new(IGNORE))? {
        // On a full disk there is none: it is made the next time, and the data matters more.
        let _ = folder.replace(OsStr::new(IGNORE), &with_name_ending(OsStr::new(IGNORE), "new"), b"*\n", |_| {});
    }
    Ok((folder, name))
}

/// Finds a link, a pipe or the like in the place of a file that is read or written for the data at a path.
pub(crate) fn foreign(path: &Path) -> Option<(PathBuf, Foreign)> {
    let folder = match open_folder(path) {
        Ok((folder, _)) => folder,
        Err(error) => return Foreign::of(&error).map(|foreign| (path.parent().map(Path::to_path_buf).unwrap_or_default(), foreign)),
    };
    let endings = ["synced", "lock", "old"].map(|ending| with_ending(path, ending));
    let own = path.parent().filter(|parent| parent.ends_with(FOLDER)).map(|parent| parent.join(IGNORE));
    let files: Vec<PathBuf> = [path.to_path_buf()].into_iter().chain(endings).chain(own).collect();
    files.iter().flat_map(|path| [path.clone(), with_ending(path, "new")]).find_map(|path| {
        let error = folder.holds(path.file_name()?).err()?;
        Foreign::of(&error).map(|foreign| (path.clone(), foreign))
    })
}

/// A file beside another: `retain.bin.synced`.
pub(crate) fn with_ending(path: &Path, ending: &str) -> PathBuf {
    PathBuf::from(with_name_ending(path.as_os_str(), ending))
}

fn with_name_ending(name: &OsStr, ending: &str) -> OsString {
    let mut name = name.to_owned();
    name.push(".");
    name.push(ending);
    name
}
