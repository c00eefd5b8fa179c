//! What every Rust file has, and what none has.

use super::Finding;
use crate::workspace::TextFile;

/// Longer files are split; the aim in STYLE.md is half of it. The tests at the end of a file do not count.
const LINES_MAX: usize = 1_200;

/// Checks every Rust file.
pub fn check(files: &[TextFile]) -> Vec<Finding> {
    files.iter().filter(|file| file.path.ends_with(".rs")).flat_map(source).collect()
}

fn source(file: &TextFile) -> Vec<Finding> {
    let mut findings = Vec::new();
    if !file.text.starts_with("//! ") {
        findings.push(Finding::line(&file.path, 1, "the first line says what the file is: `//! One sentence.`"));
    } else if !first_sentence(&file.text).ends_with(['.', ':']) {
        findings.push(Finding::line(&file.path, 1, "the first `//!` paragraph is a sentence with a full stop"));
    }
    let lines = file.text.lines().take_while(|line| *line != "#[cfg(test)]").count();
    if lines > LINES_MAX {
        findings.push(Finding::file(&file.path, format!("{lines} lines, and {LINES_MAX} are the most: split it")));
    }
    // Written in two parts, or this file would break its own rule.
    let unfinished = [concat!("todo", "!("), concat!("unimplemented", "!("), concat!("#[ig", "nore"), concat!("dbg", "!(")];
    for (index, line) in file.text.lines().enumerate() {
        if let Some(word) = unfinished.iter().find(|word| line.contains(**word)) {
            findings.push(Finding::line(
                &file.path,
                index + 1,
                format!("`{word}` means unfinished: finish it, or write the gap down as a known gap"),
            ));
        }
    }
    findings
}

/// The first paragraph of the doc comment at the top.
fn first_sentence(text: &str) -> &str {
    let end = text
        .split_inclusive('\n')
        .take_while(|line| line.trim_end().strip_prefix("//!").is_some_and(|words| !words.trim().is_empty()))
        .map(str::len)
        .sum();
    text[..end].trim_end()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_without_a_sentence_is_found() {
        let file = |text: &str| TextFile { path: "x.rs".to_owned(), text: text.to_owned() };
        assert!(source(&file("//! What it is.\nfn f() {}\n")).is_empty());
        assert!(source(&file("//! What it is, in\n//! two lines.\n")).is_empty());
        assert_eq!(source(&file("fn f() {}\n")).len(), 1);
        assert_eq!(source(&file("//! No full stop\n")).len(), 1);
        assert_eq!(source(&file(concat!("//! It.\nfn f() { tod", "o!() }\n"))).len(), 1);
    }
}
