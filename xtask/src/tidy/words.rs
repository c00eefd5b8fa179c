//! Words that do not belong into the project: places of one machine, hosts of package registries.

use super::Finding;
use crate::workspace::TextFile;

/// Files that a tool writes.
const EXEMPT: &[&str] = &["Cargo.lock"];

/// Written in two parts, or this file would break its own rule.
const FORBIDDEN: &[(&str, &str)] = &[
    (concat!("/wo", "rk/"), "a path of one machine"),
    (concat!("/ho", "me/"), "a path of one machine"),
    (concat!("/ro", "ot/"), "a path of one machine"),
    (concat!("C:\\Us", "ers\\"), "a path of one machine"),
    (concat!("#include \"", "/"), "a path of one machine"),
    (concat!("static.crates", ".io"), "a host of a package registry"),
    (concat!("index.crates", ".io"), "a host of a package registry"),
    (concat!("pypi", ".org"), "a host of a package registry"),
    (concat!("pythonhosted", ".org"), "a host of a package registry"),
    (concat!("registry.npmjs", ".org"), "a host of a package registry"),
    (concat!("deb.debian", ".org"), "a host of a package registry"),
    // A lock file names what is installed by its hash, not by where it lies.
    (concat!("\"resolved\": \"", "http"), "an address of a package registry"),
    (concat!("<<<<", "<<<"), "a merge that was not finished"),
    (concat!(">>>>", ">>>"), "a merge that was not finished"),
];

/// Checks every text file.
pub fn check(files: &[TextFile]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for file in files.iter().filter(|file| !EXEMPT.contains(&file.path.as_str())) {
        for (word, reason) in FORBIDDEN.iter().filter(|(word, _)| file.text.contains(word)) {
            let line = file.text.lines().position(|line| line.contains(word)).map_or(0, |index| index + 1);
            findings.push(Finding::line(&file.path, line, format!("`{word}` is {reason}")));
        }
    }
    findings
}
