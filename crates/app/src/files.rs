//! Reading and writing files, with the limits and messages that a user deserves.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use sieben_lang::encoding::MAX_SOURCE_BYTES;
use sieben_model::nearest::nearest;
use sieben_model::problems::Problem;
use sieben_model::visible;

use crate::failure::Failure;

/// Lets a write beyond the limit on the size of files (`ulimit -f`) fail as one on a full disk does. By itself the system ends the
/// process, and with it the control of a plant.
pub(crate) fn outlive_limits() {
    // Nobody asks the flag: that a handler is there makes the write return.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

/// Largest file that is read: the limit of the sources holds for every file, before it is read.
const FILE_SIZE_MAX: u64 = MAX_SOURCE_BYTES as u64;

/// Texts that an editor has open, by the path of their file with links resolved.
pub(crate) type OpenTexts = BTreeMap<PathBuf, Arc<str>>;

thread_local! {
    /// The texts that this thread reads in the place of files: see [`with_open`].
    static OPEN: RefCell<OpenTexts> = const { RefCell::new(OpenTexts::new()) };
}

/// Does work that reads files, and finds these texts in the place of theirs.
pub(crate) fn with_open<T>(texts: OpenTexts, work: impl FnOnce() -> T) -> T {
    /// Takes the texts away when the work ends, however that is.
    struct Ends;
    impl Drop for Ends {
        fn drop(&mut self) {
            OPEN.take();
        }
    }
    OPEN.set(texts);
    let _ends = Ends;
    work()
}

/// The open text of a file.
fn open_text(path: &Path) -> Option<Arc<str>> {
    OPEN.with_borrow(|open| match open.is_empty() {
        true => None,
        false => open.get(path).or_else(|| open.get(&fs::canonicalize(path).ok()?)).cloned(),
    })
}

/// The bytes of a file, or those of the text that is open in its place; refuses what is missing, no file, unreadable or too large,
/// without reading it.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    match open_text(path) {
        Some(text) => Ok(text.as_bytes().to_vec()),
        None => read_saved(path),
    }
}

/// The bytes of a file as it lies on the disk.
pub(crate) fn read_saved(path: &Path) -> Result<Vec<u8>, Failure> {
    let shown = path.display();
    let metadata = fs::metadata(path).map_err(|error| unreadable(path, &error))?;
    if metadata.is_dir() {
        return Err(Failure::usage(Problem::P6006, format!("`{shown}` is a folder, but a file is wanted here")));
    }
    if metadata.len() > FILE_SIZE_MAX {
        return Err(too_large(path));
    }
    let mut bytes = Vec::with_capacity(usize::try_from(metadata.len()).unwrap_or(0));
    // A pipe or device has no length: the limit holds while reading, too.
    File::open(path).and_then(|file| file.take(FILE_SIZE_MAX + 1).read_to_end(&mut bytes)).map_err(|error| unreadable(path, &error))?;
    if bytes.len() as u64 > FILE_SIZE_MAX {
        return Err(too_large(path));
    }
    Ok(bytes)
}

fn too_large(path: &Path) -> Failure {
    Failure::usage(Problem::P1104, format!("`{}` is larger than {} MiB", path.display(), FILE_SIZE_MAX >> 20))
}

/// The open texts in a folder that have no file.
pub(crate) fn open_without_file(folder: &Path) -> Vec<PathBuf> {
    OPEN.with_borrow(|open| {
        let Some(folder) = (!open.is_empty()).then(|| fs::canonicalize(folder).ok()).flatten() else { return Vec::new() };
        let is_hidden = |path: &Path| path.iter().any(|part| part.to_string_lossy().starts_with('.'));
        let here = open.keys().filter_map(|path| path.strip_prefix(&folder).ok().filter(|inner| !is_hidden(inner) && !path.exists()));
        here.map(Path::to_path_buf).collect()
    })
}

/// Opens a file of any size to be read in pieces.
pub(crate) fn open(path: &Path) -> Result<File, Failure> {
    let file = File::open(path).map_err(|error| unreadable(path, &error))?;
    match file.metadata() {
        Ok(metadata) if !metadata.is_file() => {
            Err(Failure::usage(Problem::P6006, format!("`{}` is no file, but one is wanted here", path.display())))
        }
        Ok(_) => Ok(file),
        Err(error) => Err(unreadable(path, &error)),
    }
}

/// A message about a file that cannot be read.
pub(crate) fn unreadable(path: &Path, error: &io::Error) -> Failure {
    let shown = visible::name(&path.display().to_string());
    match error.kind() {
        io::ErrorKind::NotFound => {
            Failure::usage(Problem::P6001, format!("there is no file or folder `{shown}`")).help(similar(path).map_or_else(
                || match path.as_os_str() == "-" {
                    true => "for standard input write `/dev/stdin`".to_owned(),
                    false => "check the spelling of the path".to_owned(),
                },
                |name| format!("did you mean `{}`?", path.with_file_name(name).display()),
            ))
        }
        io::ErrorKind::PermissionDenied => Failure::usage(Problem::P6001, format!("`{shown}` may not be read by this user")),
        _ => Failure::usage(Problem::P6001, format!("`{shown}` cannot be read: {error}")),
    }
}

/// A file beside the missing one whose name is nearly the same.
fn similar(path: &Path) -> Option<String> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let wanted = path.file_name()?.to_str()?;
    // A folder may be huge; the suggestion is a kindness, not a search.
    let names: Vec<String> = fs::read_dir(folder).ok()?.take(1000).filter_map(|entry| entry.ok()?.file_name().into_string().ok()).collect();
    nearest(wanted, names.iter().map(String::as_str)).map(str::to_owned)
}

/// Replaces a file as a whole: writes a new one beside it and renames it, so that a full disk or a power cut loses nothing.
pub(crate) fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    write_with(path, &mut |file| file.write_all(bytes))
}

/// As [`write_whole`], for what is too large to be held: `write` writes it piece by piece.
pub(crate) fn write_with(path: &Path, write: &mut dyn FnMut(&mut (dyn Write + Send)) -> io::Result<()>) -> Result<(), Failure> {
    let mut buffered = |file: &File| {
        let mut buffer = BufWriter::new(file);
        write(&mut buffer).and_then(|()| buffer.flush())
    };
    // Follow a link to what it means; renaming would replace the link itself.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    if target.is_dir() {
        return Err(Failure::usage(Problem::P6013, format!("`{}` is a folder, so no file can be written there", path.display())));
    }
    // A device or pipe (`/dev/stdout`) is written to, not replaced.
    if fs::metadata(&target).is_ok_and(|metadata| !metadata.is_file()) {
        return fs::OpenOptions::new().write(true).open(&target).and_then(|file| buffered(&file)).map_err(|error| unwritable(path, &error));
    }
    // Renaming asks only the folder, not the file.
    if fs::metadata(&target).is_ok_and(|metadata| metadata.permissions().readonly()) {
        return Err(Failure::usage(Problem::P6013, format!("`{}` is read-only", path.display())));
    }
    let temporary = temporary_beside(&target);
    let written = File::create_new(&temporary).and_then(|file| {
        buffered(&file)?;
        if let Ok(metadata) = fs::metadata(&target) {
            file.set_permissions(metadata.permissions())?;
        }
        file.sync_all()?;
        drop(file);
        fs::rename(&temporary, &target)
    });
    written.map_err(|error| {
        // Best effort: the message about the first error matters more.
        let _ = fs::remove_file(&temporary);
        unwritable(path, &error)
    })
}

fn temporary_beside(target: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from(".");
    name.push(target.file_name().unwrap_or_default());
    name.push(format!(".{}.tmp", std::process::id()));
    target.with_file_name(name)
}

/// A message about a file that cannot be written.
pub(crate) fn unwritable(path: &Path, error: &io::Error) -> Failure {
    Failure::usage(Problem::P6013, format!("`{}` cannot be written: {error}", path.display()))
}
