//! A folder that is held open. What is done in it cannot be led elsewhere by a link, whoever puts one there and whenever.
//!
//! Names that Sieben chooses itself, in a folder that a stranger may have filled, are opened and written only here. What a user
//! names (`-o FILE`) may be a link or a device: that is `files`.

use std::ffi::{OsStr, OsString};
use std::fmt;
use std::fs::File;
use std::io::{self, Write};
use std::os::fd::{AsFd, BorrowedFd, OwnedFd};
use std::path::{Path, PathBuf};

use rustix::fs::{self, AtFlags, FileType, Mode, OFlags, Stat};
use rustix::io::Errno;

/// What stands where a plain file, or a folder, is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Foreign {
    /// A symbolic link.
    Link,
    /// A plain file with other names, perhaps outside the folder.
    ManyNames,
    /// A folder.
    Folder,
    /// A plain file where a folder is wanted.
    File,
    /// A pipe, device or socket: reading it could wait forever.
    Device,
}

impl fmt::Display for Foreign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Link => "it is a symbolic link",
            Self::ManyNames => "it has other names (hard links)",
            Self::Folder => "it is a folder",
            Self::File => "it is a file and no folder",
            Self::Device => "it is a pipe, a device or a socket",
        })
    }
}

impl std::error::Error for Foreign {}

impl From<Foreign> for io::Error {
    fn from(foreign: Foreign) -> Self {
        Self::other(foreign)
    }
}

impl Foreign {
    /// What was refused, if that is what the error says.
    pub(crate) fn of(error: &io::Error) -> Option<Self> {
        error.get_ref().and_then(|inner| inner.downcast_ref()).copied()
    }
}

/// A folder.
pub(crate) struct Folder {
    handle: OwnedFd,
}

impl AsFd for Folder {
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.handle.as_fd()
    }
}

/// How a handle of any kind is opened: not inherited, and never waiting for the other end of a pipe.
const QUIETLY: OFlags = OFlags::CLOEXEC.union(OFlags::NONBLOCK);

impl Folder {
    /// Opens a folder that the user names; links on the way to it are the user's.
    pub(crate) fn open(path: &Path) -> io::Result<Self> {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        Ok(Self { handle: fs::open(path, QUIETLY | OFlags::DIRECTORY, Mode::empty())? })
    }

    /// Opens a folder in this one, and makes it if it is missing.
    pub(crate) fn make(&self, name: &OsStr) -> io::Result<Self> {
        match fs::mkdirat(&self.handle, name, Mode::from_raw_mode(0o777)) {
            // What is synced in a folder that a power failure takes away would be lost with it.
            Ok(()) => self.sync()?,
            Err(Errno::EXIST) => {}
            Err(error) => return Err(error.into()),
        }
        self.inner(name)
    }

    /// Opens a folder in this one.
    pub(crate) fn inner(&self, name: &OsStr) -> io::Result<Self> {
        match fs::openat(&self.handle, name, QUIETLY | OFlags::DIRECTORY | OFlags::NOFOLLOW, Mode::empty()) {
            Ok(handle) => Ok(Self { handle }),
            Err(error) => Err(self.stat(name)?.and_then(|stat| not_a_folder(&stat)).map_or_else(|| error.into(), io::Error::from)),
        }
    }

    fn stat(&self, name: &OsStr) -> io::Result<Option<Stat>> {
        match fs::statat(&self.handle, name, AtFlags::SYMLINK_NOFOLLOW) {
            Ok(stat) => Ok(Some(stat)),
            Err(Errno::NOENT) => Ok(None),
            Err(error) => Err(error.into()),
        }
    }

    /// Whether there is a plain file of this name; refuses what is none.
    pub(crate) fn holds(&self, name: &OsStr) -> io::Result<bool> {
        match self.stat(name)? {
            None => Ok(false),
            Some(stat) => not_a_file(&stat).map_or(Ok(true), |foreign| Err(foreign.into())),
        }
    }

    /// Whether a name still stands for a file that was opened by it.
    pub(crate) fn names(&self, name: &OsStr, file: &File) -> bool {
        let opened = fs::fstat(file);
        self.stat(name).ok().flatten().zip(opened.ok()).is_some_and(|(a, b)| (a.st_dev, a.st_ino) == (b.st_dev, b.st_ino))
    }

    /// Opens a plain file to be read.
    pub(crate) fn read(&self, name: &OsStr) -> io::Result<File> {
        self.open_file(name, OFlags::RDONLY)
    }

    /// Opens a plain file to be written, and makes an empty one if there is none.
    pub(crate) fn write(&self, name: &OsStr) -> io::Result<File> {
        self.open_file(name, OFlags::WRONLY | OFlags::CREATE)
    }

    /// Makes a file that only this user reads and writes; there must be none of this name.
    pub(crate) fn new_private(&self, name: &OsStr) -> io::Result<File> {
        let flags = OFlags::WRONLY | OFlags::CREATE | OFlags::EXCL | OFlags::NOFOLLOW | QUIETLY;
        let file = fs::openat(&self.handle, name, flags, Mode::from_raw_mode(0o600))?;
        self.sync()?;
        Ok(File::from(file))
    }

    fn open_file(&self, name: &OsStr, flags: OFlags) -> io::Result<File> {
        // A look before: opening a device may already do something. A look after: what was opened may have come in between.
        self.holds(name)?;
        let handle = fs::openat(&self.handle, name, flags | QUIETLY | OFlags::NOFOLLOW | OFlags::NOCTTY, Mode::from_raw_mode(0o666))
            .map_err(|error| if error == Errno::LOOP { Foreign::Link.into() } else { io::Error::from(error) })?;
        match not_a_file(&fs::fstat(&handle)?) {
            Some(foreign) => Err(foreign.into()),
            None => Ok(File::from(handle)),
        }
    }

    /// Replaces a file as a whole: after a crash there is the old one or the new one, and when this returns the new one is on the disk.
    /// `ready` sees the new file before it gets its name.
    pub(crate) fn replace(&self, name: &OsStr, temporary: &OsStr, content: &[u8], ready: impl Fn(&File)) -> io::Result<File> {
        self.holds(name)?;
        if self.holds(temporary)? {
            // Left by a run that was killed.
            fs::unlinkat(&self.handle, temporary, AtFlags::empty())?;
        }
        let flags = OFlags::WRONLY | OFlags::CREATE | OFlags::EXCL | OFlags::NOFOLLOW | QUIETLY;
        let mut file = File::from(fs::openat(&self.handle, temporary, flags, Mode::from_raw_mode(0o666))?);
        let written = file.write_all(content).and_then(|()| file.sync_all()).and_then(|()| {
            ready(&file);
            Ok(fs::renameat(&self.handle, temporary, &self.handle, name)?)
        });
        written.inspect_err(|_| {
            // The first error matters more.
            let _ = fs::unlinkat(&self.handle, temporary, AtFlags::empty());
        })?;
        self.sync()?;
        Ok(file)
    }

    /// Removes a plain file, if it is there.
    pub(crate) fn remove(&self, name: &OsStr) -> io::Result<()> {
        if self.holds(name)? {
            fs::unlinkat(&self.handle, name, AtFlags::empty())?;
        }
        Ok(())
    }

    /// A new name is on the disk when its folder is.
    fn sync(&self) -> io::Result<()> {
        match fs::fsync(&self.handle) {
            // Some file systems have nothing to sync in a folder.
            Ok(()) | Err(Errno::INVAL) => Ok(()),
            Err(error) => Err(error.into()),
        }
    }
}

fn not_a_file(stat: &Stat) -> Option<Foreign> {
    match FileType::from_raw_mode(stat.st_mode) {
        // A file without any name was removed after it was opened, which harms nothing.
        FileType::RegularFile if stat.st_nlink <= 1 => None,
        FileType::RegularFile => Some(Foreign::ManyNames),
        FileType::Symlink => Some(Foreign::Link),
        FileType::Directory => Some(Foreign::Folder),
        _ => Some(Foreign::Device),
    }
}

fn not_a_folder(stat: &Stat) -> Option<Foreign> {
    match FileType::from_raw_mode(stat.st_mode) {
        FileType::Directory => None,
        FileType::RegularFile => Some(Foreign::File),
        FileType::Symlink => Some(Foreign::Link),
        _ => Some(Foreign::Device),
    }
}

/// Writes a file whose name Sieben chooses into a folder that the user names, as a whole; the folder is made if need be.
pub(crate) fn write_named(folder: &Path, name: &str, content: &[u8]) -> io::Result<()> {
    std::fs::create_dir_all(folder)?;
    let temporary = OsString::from(format!(".{name}.{}.tmp", std::process::id()));
    Folder::open(folder)?.replace(OsStr::new(name), &temporary, content, |_| {}).map(drop)
}

/// The folder and the name of a path.
pub(crate) fn parts(path: &Path) -> io::Result<(PathBuf, &OsStr)> {
    let name = path.file_name().ok_or_else(|| io::Error::other("the path does not end with the name of a file"))?;
    Ok((path.parent().map(Path::to_path_buf).unwrap_or_default(), name))
}
