//! Commands in documents: the verbs, tasks and files they name exist.

use std::path::Path;

use super::Finding;
use super::pages::PROBLEM_PAGES;
use crate::markdown;
use crate::workspace::TextFile;

/// Tasks of `cargo xtask`.
const TASKS: &[&str] = &["aarch64", "ablate", "clients", "test", "tidy", "generate", "fuzz", "soak", "vsix", "web", "screenshots", "help"];

/// Where each verb of `sieben` has its file.
const VERBS: &str = "crates/app/src/commands/";

/// Checks the `sh` and `console` fences of all documents but the pages of problems, whose commands fail on purpose.
pub fn check(root: &Path, files: &[TextFile]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for file in files.iter().filter(|file| file.path.ends_with(".md") && !file.path.starts_with(PROBLEM_PAGES)) {
        for fence in markdown::read(&file.text).fences.iter().filter(|fence| matches!(fence.language.as_str(), "sh" | "console")) {
            for (index, line) in fence.text.lines().enumerate() {
                let command = if fence.language == "console" {
                    let Some(command) = line.strip_prefix("$ ") else { continue };
                    command
                } else {
                    line
                };
                if let Err(message) = judge(root, files, command) {
                    findings.push(Finding::line(&file.path, fence.line + index + 1, message));
                }
            }
        }
    }
    findings
}

fn judge(root: &Path, files: &[TextFile], command: &str) -> Result<(), String> {
    let command = command.split(" #").next().unwrap_or(command);
    let words: Vec<&str> = command.split_whitespace().collect();
    match words.as_slice() {
        ["cargo", "xtask", task, ..] if !TASKS.contains(task) => Err(format!("`cargo xtask {task}` is no task of xtask/src/main.rs")),
        ["cargo", "run", rest @ ..] => match rest.iter().position(|word| *word == "--") {
            Some(index) => verb(root, files, &rest[index + 1..]),
            None => Ok(()),
        },
        ["sieben", rest @ ..] => verb(root, files, rest),
        _ => Ok(()),
    }
}

fn verb(root: &Path, files: &[TextFile], words: &[&str]) -> Result<(), String> {
    let Some((verb, arguments)) = words.split_first() else { return Ok(()) };
    let name = verb.replace('-', "_");
    let places = [format!("{VERBS}{name}.rs"), format!("{VERBS}{name}/mod.rs")];
    let known = verb.starts_with('-') || *verb == "help" || files.iter().any(|file| places.contains(&file.path));
    if !known {
        return Err(format!("`sieben {verb}` is no verb: there is no {VERBS}{verb}.rs"));
    }
    let missing = arguments
        .iter()
        .find(|word| ["examples/", "spec/", "docs/", "crates/"].iter().any(|start| word.starts_with(start)) && !root.join(word).exists());
    match missing {
        Some(path) => Err(format!("`{path}` does not exist")),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workspace;

    #[test]
    fn a_command_that_does_not_exist_is_found() {
        let root = workspace::root();
        assert!(judge(&root, &[], "cargo xtask test").is_ok());
        assert!(judge(&root, &[], "cargo xtask tset").is_err());
        assert!(judge(&root, &[], "sieben chekc x.awl").is_err());
        assert!(judge(&root, &[], "cargo build").is_ok());
    }
}
