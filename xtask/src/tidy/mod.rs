//! `cargo xtask tidy`: the rules of the house that the compiler does not know.

pub mod arrows;
pub mod commands;
pub mod contract;
pub mod pages;
pub mod rooms;
pub mod sources;
pub mod tables;
pub mod words;

use std::fmt;

use crate::generate;
use crate::workspace::{self, TextFile};

/// One broken rule.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Finding {
    /// The file, from the root.
    pub path: String,
    /// The line, counted from 1; 0 = the whole file.
    pub line: usize,
    /// What is wrong and what to do.
    pub message: String,
}

impl Finding {
    /// A finding about a whole file.
    pub fn file(path: &str, message: impl Into<String>) -> Self {
        Self { path: path.to_owned(), line: 0, message: message.into() }
    }
    /// A finding about a line.
    pub fn line(path: &str, line: usize, message: impl Into<String>) -> Self {
        Self { path: path.to_owned(), line, message: message.into() }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.line == 0 {
            write!(f, "{}: {}", self.path, self.message)
        } else {
            write!(f, "{}:{}: {}", self.path, self.line, self.message)
        }
    }
}

/// All rules over all files of the project.
pub fn findings() -> Vec<Finding> {
    let root = workspace::root();
    let files = workspace::text_files(&root);
    let mut findings = [
        arrows::check(&files),
        rooms::check(&files),
        sources::check(&files),
        tables::check(&files),
        words::check(&files),
        pages::check(&root, &files),
        commands::check(&root, &files),
        contract::check(&files),
        stale_pages(&files),
    ]
    .concat();
    findings.sort();
    findings.dedup();
    findings
}

/// Pages that `cargo xtask generate` would write differently.
fn stale_pages(files: &[TextFile]) -> Vec<Finding> {
    generate::pages(files)
        .into_iter()
        .filter(|page| generate::text_of(files, &page.path) != Some(page.text.as_str()))
        .map(|page| Finding::file(&page.path, "stale: run `cargo xtask generate`"))
        .collect()
}

/// Prints what is not tidy.
pub fn run() -> Result<(), String> {
    let findings = findings();
    if findings.is_empty() {
        println!("tidy: all rules hold");
        return Ok(());
    }
    for finding in &findings {
        println!("{finding}");
    }
    Err(format!("tidy: {} rules are broken", findings.len()))
}
