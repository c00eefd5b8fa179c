//! Embeds the pages of `docs/problems` and of `spec/functions`, so that `sieben explain P2001` and `sieben explain TON` need no files.

use std::path::{Path, PathBuf};
use std::{env, fmt::Write as _, fs};

fn main() {
    embed("docs/problems", "problem_pages.rs");
    embed("spec/functions", "function_pages.rs");
}

/// Writes a table of the pages of a folder: the name of each file without its ending, and its text.
fn embed(folder: &str, table_file: &str) {
    let pages = Path::new(&env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("../..").join(folder);
    println!("cargo::rerun-if-changed={}", pages.display());
    let mut files: Vec<PathBuf> =
        fs::read_dir(&pages).map(|entries| entries.filter_map(|entry| Some(entry.ok()?.path())).collect()).unwrap_or_default();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    files.sort();
    let mut table = String::from("&[\n");
    for path in files {
        let name = path.file_stem().expect("a file has a name").to_string_lossy().into_owned();
        writeln!(table, "    ({name:?}, include_str!({:?})),", fs::canonicalize(&path).expect("the file was just listed"))
            .expect("a String grows");
    }
    table.push_str("]\n");
    let target = Path::new(&env::var_os("OUT_DIR").expect("cargo sets it")).join(table_file);
    fs::write(target, table).expect("the build folder is writable");
}
