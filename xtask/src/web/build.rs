//! The page from its sources: into `dist`, or into `target` to be compared with it.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{built, sources};
use crate::{node, programs, workspace};

/// What a page needs for its first view, packed: more is not there within 300 ms on a slow line.
const FIRST_BYTES_MAX: u64 = 60_000;
/// All parts of the page, packed.
const ALL_BYTES_MAX: u64 = 250_000;
/// A packed copy of a file, for browsers that unpack it.
const PACKED: &str = ".br";
/// Prints the names of packed files that do not hold what lies beside them: other versions of Node.js pack the same into other bytes.
const UNPACKED_DIFFER: &str = "const fs = require('fs'); for (const packed of process.argv.slice(1)) { let same = false; \
    try { same = require('zlib').brotliDecompressSync(fs.readFileSync(packed)).equals(fs.readFileSync(packed.slice(0, -3))); } catch {} \
    if (!same) console.log(packed); }";

/// Checks the sources and builds the page into `dist`.
pub(super) fn into_dist() -> Result<(), String> {
    node::packages(&sources())?;
    run(node::package_command(&sources(), "svelte-check").args([
        "--tsconfig",
        "./tsconfig.json",
        "--fail-on-warnings",
        "--output",
        "human",
    ]))?;
    build(&built())?;
    println!("web: {} files in crates/workbench/dist", files(&built()).len());
    sizes(&built())
}

/// Says how large the page is, and whether that is too much: packed, because so it is sent.
fn sizes(folder: &Path) -> Result<(), String> {
    let failed = |error: std::io::Error| error.to_string();
    let page = fs::read_to_string(folder.join("index.html")).map_err(failed)?;
    let (mut first, mut all) = (0, 0);
    for name in files(folder).iter().filter_map(|name| name.strip_suffix(PACKED)) {
        let size = fs::metadata(folder.join(format!("{name}{PACKED}"))).map_err(failed)?.len();
        all += size;
        if page.contains(name) && name.starts_with("assets/") {
            first += size;
        }
    }
    println!("web: {first} bytes packed for the first view (at most {FIRST_BYTES_MAX}), {all} for all (at most {ALL_BYTES_MAX})");
    if first > FIRST_BYTES_MAX || all > ALL_BYTES_MAX {
        return Err("web: the page is too large: what is seldom used goes into a part that is loaded when it is needed".to_owned());
    }
    Ok(())
}

/// Compares `dist` with what the sources build.
pub(super) fn check() -> Result<(), String> {
    if let Err(missing) = node::packages(&sources()) {
        return programs::skip("page-build", &format!("whether crates/workbench/dist is up to date: {missing}"));
    }
    let fresh = workspace::root().join("target/page");
    build(&fresh)?;
    let differences = differences(&built(), &fresh)?;
    if differences.is_empty() {
        println!("web: crates/workbench/dist is what its sources build");
        return sizes(&fresh);
    }
    for difference in &differences {
        println!("crates/workbench/dist/{difference}");
    }
    Err("web: crates/workbench/dist is not what crates/workbench/web builds: run `cargo xtask web` and commit what it writes".to_owned())
}

fn build(folder: &Path) -> Result<(), String> {
    run(node::package_command(&sources(), "vite").args(["build", "--logLevel", "warn", "--emptyOutDir", "--outDir"]).arg(folder))
}

/// Runs a command that talks to the person who started us.
fn run(command: &mut Command) -> Result<(), String> {
    let line = command.get_args().skip(1).map(|word| word.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ");
    let status = command.current_dir(sources()).status().map_err(|error| format!("cannot start `{line}`: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("`{line}` failed")) }
}

/// All files of a folder, by their paths from it.
fn files(folder: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut folders: Vec<PathBuf> = vec![folder.to_path_buf()];
    while let Some(inner) = folders.pop() {
        for entry in fs::read_dir(inner).into_iter().flatten().flatten() {
            if entry.path().is_dir() {
                folders.push(entry.path());
            } else {
                found.insert(workspace::relative(folder, &entry.path()));
            }
        }
    }
    found
}

/// What is different in a folder from a fresh one, a line for each file.
fn differences(committed: &Path, fresh: &Path) -> Result<Vec<String>, String> {
    let (ours, theirs) = (files(committed), files(fresh));
    let mut lines = Vec::new();
    let mut packed = Vec::new();
    for name in ours.union(&theirs) {
        let content = |folder: &Path| fs::read(folder.join(name)).map_err(|error| format!("{name}: {error}"));
        match (ours.contains(name), theirs.contains(name)) {
            (false, _) => lines.push(format!("{name}: is missing")),
            (_, false) => lines.push(format!("{name}: is left over")),
            _ if content(committed)? == content(fresh)? => {}
            _ if name.ends_with(PACKED) => packed.push(committed.join(name)),
            _ => lines.push(format!("{name}: differs")),
        }
    }
    if !packed.is_empty() {
        let output = Command::new("node").args(["-e", UNPACKED_DIFFER, "--"]).args(&packed).output();
        let output = output.map_err(|error| format!("cannot start node: {error}"))?;
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        lines.extend(said.lines().map(|path| format!("{}: does not hold its file", workspace::relative(committed, Path::new(path)))));
    }
    Ok(lines)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_is_missing_left_over_or_different_is_named() {
        let root = std::env::temp_dir().join(format!("sieben-web-{}", std::process::id()));
        let write = |path: &str, text: &str| {
            let path = root.join(path);
            fs::create_dir_all(path.parent().expect("a folder")).and_then(|()| fs::write(path, text)).expect("a file");
        };
        for (path, text) in [("a/index.html", "1"), ("a/assets/x.js", "1"), ("a/assets/old.js", "1")] {
            write(path, text);
        }
        for (path, text) in [("b/index.html", "1"), ("b/assets/x.js", "2"), ("b/icon.svg", "1")] {
            write(path, text);
        }
        let found = differences(&root.join("a"), &root.join("b"));
        fs::remove_dir_all(&root).expect("it was made");
        assert_eq!(
            found,
            Ok(vec!["assets/old.js: is left over".to_owned(), "assets/x.js: differs".to_owned(), "icon.svg: is missing".to_owned()])
        );
    }
}
