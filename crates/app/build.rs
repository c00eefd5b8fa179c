//! Embeds the pages of `docs/problems`, so that `sieben explain P2001` needs no files.

use std::path::{Path, PathBuf};
use std::{env, fmt::Write as _, fs};

fn main() {
    let pages = Path::new(&env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("../../docs/problems");
    println!("cargo::rerun-if-changed={}", pages.display());
    let mut files: Vec<PathBuf> =
        fs::read_dir(&pages).map(|entries| entries.filter_map(|entry| Some(entry.ok()?.path())).collect()).unwrap_or_default();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    files.sort();
    let mut table = String::from("&[\n");
    for path in files {
        let code = path.file_stem().expect("a file has a name").to_string_lossy().into_owned();
        writeln!(table, "    ({code:?}, include_str!({:?})),", fs::canonicalize(&path).expect("the file was just listed"))
            .expect("a String grows");
    }
    table.push_str("]\n");
    let target = Path::new(&env::var_os("OUT_DIR").expect("cargo sets it")).join("problem_pages.rs");
    fs::write(target, table).expect("the build folder is writable");
}
