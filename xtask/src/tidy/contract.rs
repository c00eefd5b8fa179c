//! The contract of the page: each number of it has a test in the browser, and each number of a test is in it.

use std::collections::{BTreeMap, BTreeSet};

use super::Finding;
use crate::workspace::TextFile;

/// The page that lists the checks.
const CONTRACT: &str = "docs/reference/workbench-contract.md";
/// Where the tests are.
const TESTS: &str = "crates/workbench/web/tests/";

/// Compares the numbers of the contract with those that titles of tests begin with.
pub fn check(files: &[TextFile]) -> Vec<Finding> {
    let Some(contract) = files.iter().find(|file| file.path == CONTRACT) else {
        return vec![Finding::file(CONTRACT, "the contract of the page is missing")];
    };
    let mut findings = Vec::new();
    let mut wanted = BTreeMap::new();
    for (index, line) in contract.text.lines().enumerate() {
        let Some(number) = line.strip_prefix("| ").and_then(|rest| rest.split(' ').next()?.parse::<u32>().ok()) else { continue };
        if wanted.insert(number, index + 1).is_some() {
            findings.push(Finding::line(CONTRACT, index + 1, format!("check {number} is listed twice")));
        }
    }
    let mut tested = BTreeSet::new();
    for file in files.iter().filter(|file| file.path.starts_with(TESTS) && file.path.ends_with(".spec.ts")) {
        for (index, line) in file.text.lines().enumerate() {
            for number in title(line).map(numbers).unwrap_or_default() {
                if !wanted.contains_key(&number) {
                    findings.push(Finding::line(&file.path, index + 1, format!("check {number} is not in {CONTRACT}")));
                }
                tested.insert(number);
            }
        }
    }
    for (number, line) in wanted.iter().filter(|(number, _)| !tested.contains(number)) {
        findings.push(Finding::line(CONTRACT, *line, format!("no test in {TESTS} has a title that begins with check {number}")));
    }
    findings
}

/// The title of the test that begins in a line.
fn title(line: &str) -> Option<&str> {
    let rest = line.trim_start().strip_prefix("test(")?;
    let quote = rest.chars().next().filter(|quote| matches!(quote, '\'' | '"' | '`'))?;
    rest[1..].split(quote).next()
}

/// The numbers before the colon: `21–23, 26: …`.
fn numbers(title: &str) -> Vec<u32> {
    let Some((list, _)) = title.split_once(':') else { return Vec::new() };
    let parts = list.split(", ").map(|part| {
        let (first, last) = part.split_once('–').unwrap_or((part, part));
        Some(first.parse().ok()?..=last.parse().ok()?)
    });
    parts.collect::<Option<Vec<_>>>().unwrap_or_default().into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_of_a_title_are_lists_and_spans() {
        assert_eq!(title("  test('21–23, 26: pause', async () => {"), Some("21–23, 26: pause"));
        assert_eq!(title("  test.describe('21: x', () => {"), None);
        assert_eq!(numbers("21–23, 26: pause"), [21, 22, 23, 26]);
        assert_eq!(numbers("a scan of six seconds: the page says so"), [0; 0]);
    }

    #[test]
    fn a_check_without_a_test_and_a_test_without_a_check_are_found() {
        let file = |path: &str, text: &str| TextFile { path: path.to_owned(), text: text.to_owned() };
        let files = [
            file(CONTRACT, "| check | what |\n|---|---|\n| 1 | it opens |\n| 2 | it goes on |\n| 1 | it opens |\n"),
            file("crates/workbench/web/tests/a.spec.ts", "test('1, 3: it opens', f);\n"),
        ];
        let found: Vec<String> = check(&files).iter().map(ToString::to_string).collect();
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(found[0].ends_with("check 1 is listed twice") && found[1].contains("check 3 is not in") && found[2].contains("check 2"));
    }
}
