//! Documents: links and paths lead somewhere, every page of the book can be found, every problem has its page, every decision its own number.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use sieben_model::language::Language;
use sieben_model::problems::Problem;

use super::Finding;
use crate::markdown;
use crate::workspace::TextFile;

/// Where the pages of the problem codes lie.
pub const PROBLEM_PAGES: &str = "docs/problems/";
/// The page that lists them.
pub const PROBLEM_LIST: &str = "docs/reference/problems.md";
/// Where the decisions lie.
const DECISION_PAGES: &str = "docs/decisions/";
/// The page that lists them.
pub const DECISION_LIST: &str = "docs/decisions/README.md";

/// The table of contents of the book.
const CONTENTS: &str = "docs/SUMMARY.md";
/// Pages that list all pages of a kind, so that the table of contents need not.
const LISTS: &[&str] = &[PROBLEM_LIST, DECISION_LIST, "docs/explanation/optimizer/README.md"];

/// Code in a sentence that begins so is a path, and exists.
const PATH_STARTS: &[&str] = &["crates/", "docs/", "spec/", "xtask/", "examples/", "library/", ".ci/", ".cargo/"];

/// Words in a path that the reader replaces.
const PLACEHOLDERS: &[&str] = &["NNN", "VERB", "PNNNN"];

/// Checks all documents.
pub fn check(root: &Path, files: &[TextFile]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for file in files.iter().filter(|file| file.path.ends_with(".md")) {
        findings.extend(document(root, file, files));
    }
    findings.extend(unlisted(files));
    findings.extend(problem_pages(files));
    findings.extend(decisions(files));
    findings
}

/// Pages of the book that a reader does not find: neither the table of contents leads to them nor one of the lists in it.
fn unlisted(files: &[TextFile]) -> Vec<Finding> {
    let links_of = |page: &TextFile| {
        let links = markdown::read(&page.text).links;
        links.into_iter().map(|(link, _)| join(&page.path, link.split('#').next().unwrap_or_default())).collect::<Vec<_>>()
    };
    let contents: BTreeSet<String> = files.iter().filter(|file| file.path == CONTENTS).flat_map(links_of).collect();
    let lists = files.iter().filter(|file| LISTS.contains(&file.path.as_str()) && contents.contains(&file.path));
    let listed: BTreeSet<String> = lists.flat_map(links_of).collect();
    let pages = files.iter().filter(|file| file.path.starts_with("docs/") && file.path.ends_with(".md") && file.path != CONTENTS);
    pages
        .filter(|page| !contents.contains(&page.path) && !listed.contains(&page.path))
        .map(|page| Finding::file(&page.path, format!("neither `{CONTENTS}` nor a list of pages in it links to this page")))
        .collect()
}

fn document(root: &Path, file: &TextFile, files: &[TextFile]) -> Vec<Finding> {
    let page = markdown::read(&file.text);
    let mut findings = Vec::new();
    for (link, line) in &page.links {
        if link.contains("://") || link.starts_with("mailto:") {
            continue;
        }
        let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
        let target = if path.is_empty() { file.path.clone() } else { join(&file.path, path) };
        if !root.join(&target).exists() {
            findings.push(Finding::line(&file.path, *line, format!("the link `{link}` leads nowhere")));
        } else if !anchor.is_empty()
            && let Some(other) = files.iter().find(|other| other.path == target)
            && !markdown::read(&other.text).anchors.iter().any(|known| known == anchor)
        {
            findings.push(Finding::line(&file.path, *line, format!("`{target}` has no heading `#{anchor}`")));
        }
    }
    for (code, line) in &page.spans {
        let has_placeholder = code.contains(['<', '*', '{', ' ', '…']) || PLACEHOLDERS.iter().any(|word| code.contains(word));
        let is_path = !has_placeholder && PATH_STARTS.iter().any(|start| code.starts_with(start));
        let path = code.split([':', '#']).next().unwrap_or(code);
        if is_path && !root.join(path).exists() {
            findings.push(Finding::line(&file.path, *line, format!("`{code}` does not exist")));
        }
    }
    findings
}

/// A relative link from a file, as a path from the root.
fn join(from: &str, link: &str) -> String {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in link.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}

fn problem_pages(files: &[TextFile]) -> Vec<Finding> {
    let mut findings = Vec::new();
    let pages = files.iter().filter_map(|file| {
        let name = file.path.strip_prefix(PROBLEM_PAGES)?.strip_suffix(".md")?;
        Some((name, file))
    });
    for (name, file) in pages {
        if Problem::from_code(name).is_none() {
            findings.push(Finding::file(&file.path, format!("`{name}` is no code of crates/model/src/problems.rs")));
            continue;
        }
        let shown = markdown::read(&file.text).fences.iter().any(|fence| !fence.language.is_empty());
        if !shown && !file.text.contains("## How it arises") {
            findings.push(Finding::file(&file.path, "shows a source that produces it, or says so under `## How it arises`"));
        }
    }
    for pair in Problem::ALL.windows(2).filter(|pair| pair[0].code() >= pair[1].code()) {
        findings.push(Finding::file(
            "crates/model/src/problems.rs",
            format!("`{}` stands before `{}`: sorted by code", pair[0].code(), pair[1].code()),
        ));
    }
    for problem in Problem::ALL {
        let (title, help) = (problem.title(), problem.help());
        let code = problem.code();
        let message = if title.is_empty() || title.ends_with('.') || begins_with_a_capital(title) {
            "the title is a phrase: lower-case, no full stop"
        } else if !help.ends_with(['.', '?', '!']) {
            "the help is a sentence with a full stop"
        } else {
            continue;
        };
        findings.push(Finding::file("crates/model/src/problems.rs", format!("`{code}`: {message}")));
    }
    for problem in Problem::ALL {
        // A German phrase may begin with a noun.
        let (title, help) = (problem.title_in(Language::German), problem.help_in(Language::German));
        if title.is_empty() || title.ends_with('.') || !help.ends_with(['.', '?', '!']) {
            let message = format!("`{}`: in German, too, the title is a phrase and the help a sentence", problem.code());
            findings.push(Finding::file("crates/model/src/problems.rs", message));
        }
    }
    findings
}

/// A capital that is not the first letter of a short form such as MCR or CPU.
fn begins_with_a_capital(title: &str) -> bool {
    let word = title.split(' ').next().unwrap_or_default();
    word.starts_with(char::is_uppercase) && word.chars().any(char::is_lowercase)
}

/// The name of a page in the folder of decisions, but for the one that lists them.
pub fn decision(path: &str) -> Option<&str> {
    let name = path.strip_prefix(DECISION_PAGES)?.strip_suffix(".md")?;
    (path != DECISION_LIST).then_some(name)
}

fn decisions(files: &[TextFile]) -> Vec<Finding> {
    let mut numbers: BTreeMap<&str, &str> = BTreeMap::new();
    let mut findings = Vec::new();
    for file in files {
        let Some(name) = decision(&file.path) else { continue };
        let Some((number, _)) =
            name.split_once('-').filter(|(number, _)| number.len() == 3 && number.bytes().all(|digit| digit.is_ascii_digit()))
        else {
            findings.push(Finding::file(&file.path, "a decision is named NNN-title.md"));
            continue;
        };
        if let Some(other) = numbers.insert(number, name) {
            findings.push(Finding::file(&file.path, format!("the number {number} is taken by {other}.md")));
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_is_resolved_from_its_file() {
        assert_eq!(join("docs/start/a.md", "../how-to/b.md"), "docs/how-to/b.md");
        assert_eq!(join("README.md", "./docs/"), "docs");
    }

    #[test]
    fn a_page_that_nothing_lists_is_found() {
        let page = |path: &str, text: &str| TextFile { path: path.to_owned(), text: text.to_owned() };
        let files = [
            page(CONTENTS, "[a](how-to/a.md) [all](decisions/README.md)"),
            page("docs/how-to/a.md", "[b](b.md)"),
            page("docs/how-to/b.md", ""),
            page(DECISION_LIST, "[one](001-one.md#why)"),
            page("docs/decisions/001-one.md", ""),
            page(PROBLEM_LIST, "[P1001](../problems/P1001.md)"),
            page("docs/problems/P1001.md", ""),
            page("spec/page.md", ""),
        ];
        let found: Vec<String> = unlisted(&files).into_iter().map(|finding| finding.path).collect();
        assert_eq!(found, ["docs/how-to/b.md", PROBLEM_LIST, "docs/problems/P1001.md"]);
    }
}
