//! `cargo xtask web`: the page of the workbench is built, compared with what is committed, tried in a browser, photographed and measured.
//!
//! All of it needs Node.js; what runs the page needs Chromium too. `cargo build` needs neither: it embeds what is committed in `crates/workbench/dist`.

mod browser;
mod build;

use std::path::PathBuf;

pub use browser::{bench, screenshots, soak, tests};

use crate::workspace;

/// The sources of the page.
fn sources() -> PathBuf {
    workspace::root().join("crates/workbench/web")
}

/// The page as it was built, which the binary embeds.
fn built() -> PathBuf {
    workspace::root().join("crates/workbench/dist")
}

/// Runs the task.
pub fn run(arguments: &[String]) -> Result<(), String> {
    match arguments.split_first() {
        None => build::into_dist(),
        Some((word, [])) if word == "--check" => build::check(),
        Some((word, rest)) if word == "--test" => tests(rest),
        Some((word, rest)) if word == "--bench" => bench(rest),
        Some((unknown, _)) => Err(format!("`{unknown}` is no option of web: --check, --test or --bench")),
    }
}
