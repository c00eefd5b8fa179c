//! The page in a real browser: its tests, its pictures in the book, its benchmark and its soak.

use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

use super::sources;
use crate::node;
use crate::programs::{self, Build};

/// Runs the tests of the page (Playwright, Chromium, the real binary); further arguments go to Playwright.
pub fn tests(arguments: &[String]) -> Result<(), String> {
    match ready() {
        Ok(chromium) => playwright(&chromium, named().as_ref(), Build::Debug, arguments, &[]),
        Err(missing) => programs::skip("page-tests", &format!("the tests of the page: {missing}")),
    }
}

/// Takes the pictures of `docs/reference/workbench/` again; further arguments go to Playwright.
pub fn screenshots(arguments: &[String]) -> Result<(), String> {
    let only = [&["screenshots.spec.ts".to_owned(), "--workers=1".to_owned()], arguments].concat();
    playwright(&ready()?, named().as_ref(), Build::Debug, &only, &[("SCREENSHOTS", "write".to_owned())])
}

/// Measures the page; further arguments go to Playwright.
pub fn bench(arguments: &[String]) -> Result<(), String> {
    let only = [&["page.spec.ts".to_owned()], arguments].concat();
    playwright(&ready()?, named().as_ref(), Build::Release, &only, &[])
}

/// Leaves a page open for so long and watches its memory and what it is sent.
pub fn soak(binary: Option<PathBuf>, time: Duration) -> Result<(), String> {
    let minutes = (time.as_secs() / 60).to_string();
    playwright(&ready()?, binary.or_else(named).as_ref(), Build::Release, &["soak.spec.ts".to_owned()], &[("SOAK_MINUTES", minutes)])
}

/// Installs what is missing, and finds Chromium.
fn ready() -> Result<String, String> {
    node::packages(&sources())?;
    node::chromium()
}

/// The binary that `SIEBEN` names.
fn named() -> Option<PathBuf> {
    std::env::var_os("SIEBEN").map(PathBuf::from)
}

/// Starts Playwright with a binary, or with a fresh one.
fn playwright(
    chromium: &str,
    binary: Option<&PathBuf>,
    build: Build,
    arguments: &[String],
    environment: &[(&str, String)],
) -> Result<(), String> {
    let binary = programs::sieben(binary, build)?;
    let config = if build == Build::Release { "bench/playwright.config.ts" } else { "playwright.config.ts" };
    let mut command: Command = node::package_command(&sources(), "playwright");
    command.args(["test", "--config", config]).args(arguments).env("SIEBEN", binary).env("CHROMIUM", chromium);
    command.envs(environment.iter().map(|(name, value)| (name, value.as_str())));
    let status = command.status().map_err(|error| format!("cannot start npx: {error}"))?;
    if status.success() { Ok(()) } else { Err("the page in Chromium: a check failed, see above".to_owned()) }
}
