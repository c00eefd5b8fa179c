//! The files of the project.

use std::fs;
use std::path::{Path, PathBuf};

/// A text file of the project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextFile {
    /// The path from the root, with `/` on every system.
    pub path: String,
    /// What is in it.
    pub text: String,
}

/// Folders that are not ours to judge (`.git` is a file in a linked work tree).
const SKIPPED: &[&str] = &[".git", "target", "node_modules", "dist"];

/// Larger files hold data, not text that a person wrote.
const TEXT_BYTES_MAX: u64 = 4 << 20;

/// The root of the project.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lies in the root").to_path_buf()
}

/// All text files, sorted by path. A file that is not UTF-8 is no text file.
pub fn text_files(root: &Path) -> Vec<TextFile> {
    let mut files = Vec::new();
    collect(root, root, &mut files);
    files.sort_by(|a, b| a.path.cmp(&b.path));
    files
}

fn collect(root: &Path, folder: &Path, files: &mut Vec<TextFile>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let path = entry.path();
        let Ok(kind) = entry.file_type() else { continue };
        if SKIPPED.iter().any(|skipped| entry.file_name() == *skipped) {
            continue;
        }
        if kind.is_dir() {
            collect(root, &path, files);
        } else if kind.is_file()
            && entry.metadata().is_ok_and(|metadata| metadata.len() <= TEXT_BYTES_MAX)
            && let Ok(text) = fs::read_to_string(&path)
        {
            files.push(TextFile { path: relative(root, &path), text });
        }
    }
}

/// The path from the root, with `/` on every system.
pub fn relative(root: &Path, path: &Path) -> String {
    path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/")
}
