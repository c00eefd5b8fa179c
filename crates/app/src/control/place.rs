//! Where the control socket of a run lies: beside its project, or in a folder of the user's own.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};
use std::time::Duration;

use rustix::fs::{AtFlags, FileType, FlockOperation, Mode, Stat};
use rustix::io::Errno;
use rustix::net::{AddressFamily, SocketAddrUnix, SocketFlags, SocketType};
use sieben_workspace::settings;

use crate::folder::Folder;
use crate::programs::{self, Kind};

/// The folder in that of a project.
const PROJECT_FOLDER: &str = ".sieben";
/// The socket in it.
const PROJECT_SOCKET: &str = "control.sock";
/// Longest path of a socket, in bytes: systems keep 104 to 108.
const PATH_BYTES_MAX: usize = 100;
/// How often a folder is asked for that another run has locked for the moment.
const LOCK_TRIES_MAX: usize = 50;
/// How long it is waited between two of these.
const LOCK_WAIT: Duration = Duration::from_millis(10);
/// Connections that wait to be accepted.
const BACKLOG: i32 = 16;

/// What the demo is called, by `sieben top` and where its socket lies: no path, so that no program has the same.
pub(crate) const DEMO: &str = "demo";

/// A place where the socket of a run may be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    /// The folder that is there already: that of the project, or one for temporary files.
    parent: PathBuf,
    /// The folder in it.
    folder: OsString,
    /// The socket in that.
    name: OsString,
    /// Whose the folder is.
    owner: Owner,
}

/// Whose a folder is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Owner {
    /// It belongs to the project.
    Project,
    /// It belongs to the user, and no other user may look into it.
    User,
}

/// Why a socket is not there.
#[derive(Debug)]
pub(crate) enum NoSocket {
    /// Another run of the same program has it.
    Taken,
    /// It cannot be made.
    Failed(io::Error),
}

impl<E: Into<io::Error>> From<E> for NoSocket {
    fn from(error: E) -> Self {
        Self::Failed(error.into())
    }
}

/// The places for the program that these paths name, the first one first. `home` is the folder of its `sieben.toml`.
pub(crate) fn places(paths: &[PathBuf], home: Option<&Path>) -> Vec<Place> {
    let home = home.map(canonical);
    let mut places = Vec::new();
    if let Some(home) = &home {
        let names = (OsString::from(PROJECT_FOLDER), OsString::from(PROJECT_SOCKET));
        places.push(Place { parent: home.clone(), folder: names.0, name: names.1, owner: Owner::Project });
    }
    add_places_of_user(&mut places, &home.map_or_else(|| named(paths), |home| vec![home]));
    places
}

/// The places for the demo, of which each user has one: it belongs to no folder.
pub(crate) fn of_demo() -> Vec<Place> {
    let mut places = Vec::new();
    add_places_of_user(&mut places, &[PathBuf::from(DEMO)]);
    places
}

/// Adds the places in folders of the user, for a program with these paths, and leaves out what is too long.
fn add_places_of_user(places: &mut Vec<Place>, paths: &[PathBuf]) {
    let name = OsString::from(format!("sieben-{:016x}.sock", hash(paths)));
    let runtime = std::env::var_os("XDG_RUNTIME_DIR").map(PathBuf::from).filter(|folder| folder.is_absolute());
    if let Some(parent) = runtime {
        places.push(Place { parent, folder: OsString::from("sieben"), name: name.clone(), owner: Owner::User });
    }
    let user = rustix::process::geteuid().as_raw();
    places.push(Place { parent: std::env::temp_dir(), folder: OsString::from(format!("sieben-{user}")), name, owner: Owner::User });
    places.retain(|place| place.path().as_os_str().len() <= PATH_BYTES_MAX);
}

/// The folder of the `sieben.toml` that these paths lead to, as a run finds it.
pub(crate) fn home(paths: &[PathBuf]) -> Option<PathBuf> {
    let here = [PathBuf::from(".")];
    let paths = if paths.is_empty() { &here } else { paths };
    paths.iter().rev().find_map(|path| {
        if path.file_name().is_some_and(|name| name == settings::FILE_NAME) {
            return path.parent().map(Path::to_path_buf);
        }
        if path.join(settings::FILE_NAME).is_file() {
            return Some(path.clone());
        }
        let found = programs::Folder::of(path, None).ok().flatten().filter(|found| !found.has_several())?;
        let project = found.programs.into_iter().find(|program| program.kind == Kind::Project)?;
        project.paths.into_iter().next()
    })
}

fn canonical(path: &Path) -> PathBuf {
    let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf())
}

fn named(paths: &[PathBuf]) -> Vec<PathBuf> {
    match paths {
        [] => vec![canonical(Path::new("."))],
        paths => paths.iter().map(|path| canonical(path)).collect(),
    }
}

/// FNV-1a over the paths: the same in every build of Sieben.
fn hash(paths: &[PathBuf]) -> u64 {
    let bytes = paths.iter().flat_map(|path| path.as_os_str().as_bytes().iter().copied().chain([0]));
    bytes.fold(0xCBF2_9CE4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3))
}

impl Place {
    /// The path of the socket.
    pub(crate) fn path(&self) -> PathBuf {
        self.parent.join(&self.folder).join(&self.name)
    }

    /// Connects to the run that answers here.
    pub(crate) fn connect(&self) -> io::Result<OwnedFd> {
        // No other user can offer a socket in the place of ours.
        self.open()?;
        connect(&self.path(), SocketFlags::CLOEXEC)
    }

    /// The folder, if it is there and as it has to be.
    fn open(&self) -> io::Result<Folder> {
        let folder = Folder::open(&self.parent)?.inner(&self.folder)?;
        self.check(&folder)?;
        Ok(folder)
    }

    fn check(&self, folder: &Folder) -> io::Result<()> {
        let stat = rustix::fs::fstat(folder)?;
        match self.owner {
            Owner::Project => Ok(()),
            Owner::User if stat.st_uid != rustix::process::geteuid().as_raw() => {
                Err(io::Error::other("the folder belongs to someone else"))
            }
            Owner::User if stat.st_mode & 0o077 != 0 => Err(io::Error::other("others may use the folder")),
            Owner::User => Ok(()),
        }
    }

    /// The folder, made if it is missing; whether it was.
    fn make(&self) -> io::Result<(Folder, Made)> {
        let mode = match self.owner {
            Owner::Project => Mode::from_raw_mode(0o777),
            Owner::User => Mode::RWXU,
        };
        let made = match rustix::fs::mkdirat(Folder::open(&self.parent)?, &self.folder, mode) {
            Ok(()) => Made::Now,
            Err(Errno::EXIST) => Made::Before,
            Err(error) => return Err(error.into()),
        };
        Ok((self.open()?, made))
    }

    /// Makes the socket, in the place of one that a killed run has left. Only its owner can connect to it.
    pub(crate) fn bind(self) -> Result<Bound, NoSocket> {
        let (folder, made) = self.make()?;
        // Two runs that begin at once: one of them makes the socket, the other one finds it.
        lock(&folder)?;
        let bound = self.bind_in(&folder);
        rustix::fs::flock(&folder, FlockOperation::Unlock)?;
        let (listener, stat) = bound?;
        Ok(Bound { listener, folder, place: self, stat, made })
    }

    fn bind_in(&self, folder: &Folder) -> Result<(OwnedFd, Stat), NoSocket> {
        let path = self.path();
        match connect(&path, SocketFlags::CLOEXEC | SocketFlags::NONBLOCK) {
            Ok(_) => return Err(NoSocket::Taken),
            // A run listens and has not accepted for long.
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => return Err(NoSocket::Taken),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) if error.kind() == io::ErrorKind::ConnectionRefused => self.remove_left(folder)?,
            Err(error) => return Err(error.into()),
        }
        let flags = SocketFlags::CLOEXEC | SocketFlags::NONBLOCK;
        let listener = rustix::net::socket_with(AddressFamily::UNIX, SocketType::STREAM, flags, None)?;
        rustix::net::bind(&listener, &SocketAddrUnix::new(&path)?)?;
        // Connecting is not possible before it listens.
        rustix::fs::chmodat(folder, &self.name, Mode::RUSR | Mode::WUSR, AtFlags::empty())?;
        rustix::net::listen(&listener, BACKLOG)?;
        let stat = rustix::fs::statat(folder, &self.name, AtFlags::SYMLINK_NOFOLLOW)?;
        Ok((listener, stat))
    }

    /// Removes a socket without a listener; anything else of that name stays.
    fn remove_left(&self, folder: &Folder) -> io::Result<()> {
        let stat = rustix::fs::statat(folder, &self.name, AtFlags::SYMLINK_NOFOLLOW)?;
        if FileType::from_raw_mode(stat.st_mode) != FileType::Socket {
            return Err(io::Error::other(format!("`{}` is no socket", self.path().display())));
        }
        Ok(rustix::fs::unlinkat(folder, &self.name, AtFlags::empty())?)
    }
}

/// Whether a folder was there before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Made {
    Before,
    Now,
}

/// A socket that is listened to; it goes with this.
pub(crate) struct Bound {
    /// Its handle.
    pub(crate) listener: OwnedFd,
    folder: Folder,
    place: Place,
    stat: Stat,
    made: Made,
}

impl Drop for Bound {
    fn drop(&mut self) {
        // If anything fails here, the next run finds a socket without a listener, and removes it.
        if lock(&self.folder).is_err() {
            return;
        }
        let now = rustix::fs::statat(&self.folder, &self.place.name, AtFlags::SYMLINK_NOFOLLOW);
        if now.is_ok_and(|now| (now.st_dev, now.st_ino) == (self.stat.st_dev, self.stat.st_ino)) {
            let _ = rustix::fs::unlinkat(&self.folder, &self.place.name, AtFlags::empty());
        }
        if (self.made, self.place.owner) == (Made::Now, Owner::Project) {
            // It stays if something else has come into it.
            let _ = fs::remove_dir(self.place.parent.join(&self.place.folder));
        }
        let _ = rustix::fs::flock(&self.folder, FlockOperation::Unlock);
    }
}

/// Locks a folder against other runs, for as long as a socket is made or removed.
fn lock(folder: &Folder) -> io::Result<()> {
    for _ in 0..LOCK_TRIES_MAX {
        match rustix::fs::flock(folder.as_fd(), FlockOperation::NonBlockingLockExclusive) {
            Err(Errno::WOULDBLOCK) => std::thread::sleep(LOCK_WAIT),
            done => return Ok(done?),
        }
    }
    Err(io::Error::other("the folder is locked"))
}

fn connect(path: &Path, flags: SocketFlags) -> io::Result<OwnedFd> {
    let socket = rustix::net::socket_with(AddressFamily::UNIX, SocketType::STREAM, flags, None)?;
    rustix::net::connect(&socket, &SocketAddrUnix::new(path)?)?;
    Ok(socket)
}

/// The name of a place as messages show it.
pub(crate) fn shown(place: &Place) -> String {
    crate::paths::shown(&place.path())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_has_the_same_socket_whatever_it_is_called() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let of = |path: PathBuf| places(&[path], None);
        assert_eq!(of(root.join("src")), of(root.join("tests/../src")));
        assert_ne!(of(root.join("src")), of(root.join("tests")));
        assert_eq!(places(&[], Some(root)), places(&[root.join("src")], Some(&root.join("src/.."))));
        // Other builds of Sieben have to find it.
        assert_eq!(hash(&[PathBuf::from("/pump")]), 0xF755_A5AA_21D2_0CD0);
    }

    #[test]
    fn the_demo_is_the_same_from_every_folder_and_no_program() {
        assert_eq!(hash(&[PathBuf::from(DEMO)]), 0x596E_2675_EFE9_87E2);
        assert!(of_demo().iter().all(|place| place.owner == Owner::User));
        // What is there has a path from the root.
        assert!(named(&[PathBuf::from("src")]).iter().all(|path| path.is_absolute()) && !Path::new(DEMO).is_absolute());
    }

    #[test]
    fn a_long_path_is_left_out() {
        let long = PathBuf::from("/").join("a".repeat(PATH_BYTES_MAX));
        let places = places(&[], Some(&long));
        assert!(places.iter().all(|place| place.owner == Owner::User), "{places:?}");
    }
}
