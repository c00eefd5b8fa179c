//! `cargo xtask vsix`: the extension for VS Code is built, packed, and tried in VS Code itself.
//!
//! All of it needs Node.js; what runs the editor needs Chromium too. `cargo build` needs neither.

mod editor;
mod package;
mod zip;

use std::path::PathBuf;

pub use editor::tests;

use crate::workspace;

/// The sources of the extension.
fn sources() -> PathBuf {
    workspace::root().join("editors/vscode")
}

/// Runs the task.
pub fn run(arguments: &[String]) -> Result<(), String> {
    match arguments.split_first() {
        None => package::build(None).map(drop),
        Some((word, [binary])) if word == "--bundle" => package::build(Some(binary.as_ref())).map(drop),
        Some((word, rest)) if word == "--test" => tests(rest),
        Some((unknown, _)) => Err(format!("`{unknown}` is no option of vsix: --bundle FILE or --test")),
    }
}
