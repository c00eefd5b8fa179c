//! The corpus: small programs for what larger ones met, each with its twin in C.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use super::side_by_side;

/// The programs of the corpus, by name.
pub(crate) fn all() -> BTreeMap<String, PathBuf> {
    let folder = side_by_side::root().join("benches/st/corpus");
    let files = fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("a file").path());
    let programs = files.filter(|file| file.extension().is_some_and(|extension| extension == "st"));
    programs.map(|file| (file.file_stem().expect("a name").to_string_lossy().into_owned(), file)).collect()
}
