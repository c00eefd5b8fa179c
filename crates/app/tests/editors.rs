//! Editors that others wrote, with the profiles of the book: each starts the language server, shows what is wrong and what a word means.
//!
//! `cargo xtask clients` installs them. Without its editor a test is skipped and says so in `target/skipped/`; with `SIEBEN_NO_SKIP=1` that is a
//! failure.
#![cfg(unix)]

mod command;
mod installed;

use std::path::Path;
use std::process::Command;

use command::Folder;
use installed::{finished, is_there, root};

const PROGRAM: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\n  A I 0.0;\n  = \"Lost\";\nEND_ORGANIZATION_BLOCK\n";

/// What an editor shows of the program.
const SHOWN: &str = "line 4: P3020\nhover: **A** (`U` in the other mnemonics)";

/// The profile of the book for an editor that is set up in this language.
fn profile(language: &str) -> String {
    let page = std::fs::read_to_string(root().join("docs/how-to/editors.md")).expect("the page is there");
    let fence = page.split(&format!("```{language}\n")).nth(1).and_then(|rest| rest.split("```").next());
    fence.unwrap_or_else(|| panic!("the page has a profile in {language}")).to_owned()
}

fn project() -> Folder {
    Folder::with(&[("main.awl", PROGRAM), ("sieben.toml", "[project]\nname = \"plant\"\n")])
}

/// An editor that finds our binary in the search path writes what it shows.
fn shows(editor: &mut Command, folder: &Folder) {
    let binary = Path::new(env!("CARGO_BIN_EXE_sieben")).parent().expect("it lies in a folder");
    let before = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(std::iter::once(binary.to_owned()).chain(std::env::split_paths(&before))).expect("a search path");
    let output = finished(editor.current_dir(folder.path()).env("HOME", folder.path()).env("PATH", path));
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), SHOWN, "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn neovim_shows_what_the_server_says() {
    if !is_there("neovim", false) {
        return;
    }
    let folder = project();
    folder.write("profile.lua", profile("lua").as_bytes());
    let mut neovim = Command::new(root().join("target/clients/neovim/bin/nvim"));
    neovim.args(["--headless", "-i", "NONE", "-u", "profile.lua", "-l"]).arg(root().join("crates/app/tests/editors/try.lua"));
    shows(&mut neovim, &folder);
}

#[test]
fn emacs_shows_what_the_server_says() {
    if !is_there("emacs", true) {
        return;
    }
    let folder = project();
    folder.write("profile.el", profile("lisp").as_bytes());
    let mut emacs = Command::new("emacs");
    emacs.args(["--batch", "-l"]).arg(root().join("crates/app/tests/editors/try.el"));
    shows(&mut emacs, &folder);
}
