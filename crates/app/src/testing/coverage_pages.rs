//! The pages of coverage in a folder: nothing that is somebody else's is overwritten.

use std::ffi::OsStr;
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use sieben_model::problems::Problem;
use sieben_workspace::coverage::Coverage;
use sieben_workspace::coverage::html::{INDEX, MARK};

use crate::failure::Failure;
use crate::files;
use crate::folder::{Folder, write_named};

/// Writes all pages into a folder, which is made if need be; returns the page to open.
///
/// The page with all sources is taken away first and comes last, so that it is there only if all that it says is.
pub(crate) fn write(coverage: &Coverage, folder: &Path, tests: &str) -> Result<PathBuf, Failure> {
    if folder.exists() && !folder.is_dir() {
        let message = format!("`{}` is a file, but the pages of coverage are written into a folder", folder.display());
        return Err(Failure::usage(Problem::P6300, message));
    }
    std::fs::create_dir_all(folder).map_err(|error| files::unwritable(folder, &error))?;
    let held = Folder::open(folder).map_err(|error| files::unwritable(folder, &error))?;
    for name in coverage.page_names() {
        is_free(&held, &name, &folder.join(&name))?;
    }
    let index = folder.join(INDEX);
    held.remove(OsStr::new(INDEX)).map_err(|error| files::unwritable(&index, &error))?;
    for page in coverage.pages(tests) {
        write_named(folder, &page.name, page.text.as_bytes()).map_err(|error| files::unwritable(&folder.join(&page.name), &error))?;
    }
    Ok(index)
}

/// Whether a page may be written here: nothing else has its name.
fn is_free(folder: &Folder, name: &str, path: &Path) -> Result<(), Failure> {
    let mut begin = vec![0; MARK.len()];
    let read = folder.read(OsStr::new(name)).and_then(|mut file| file.read_exact(&mut begin));
    let why = match read {
        Ok(()) if begin == MARK.as_bytes() => return Ok(()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        Ok(()) => String::new(),
        Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => String::new(),
        Err(error) => format!(": {error}"),
    };
    let message = format!("`{}` is there already, and no page of coverage{why}", path.display());
    Err(Failure::usage(Problem::P6300, message))
}
