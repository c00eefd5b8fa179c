//! The pages of standard functions: their heads from the catalogue, their signal diagrams from their own examples, and the list of all.

use std::fmt::Write as _;

use sieben_lang::Options;
use sieben_lang::known_names::known;
use sieben_lang::st::Dialect;
use sieben_lang::st::standard::catalogue::{CHAPTERS, Chapter, Page};

use crate::generate::{between, cell, text_of};
use crate::signal_diagrams;
use crate::workspace::TextFile;

/// Where the pages lie.
pub const FOLDER: &str = "spec/functions/";
/// The list.
pub const LIST: &str = "docs/reference/st-library.md";
/// Begins the generated part of the list.
const LIST_BEGIN: &str = "<!-- generated: functions -->\n";
/// Ends the generated head of a page.
pub const HEAD_END: &str =
    "<!-- The head above is generated from crates/lang/src/st/standard/catalogue.rs; the rest is written by hand. -->\n";
/// Begins a diagram of what the example above it does; the names of what is drawn follow.
pub const DIAGRAM: &str = "<!-- generated: diagram ";

/// For each page of each chapter its names with the dialects that have them.
type Known = Vec<Vec<(&'static str, [bool; 4])>>;

/// All pages and the list as they should be.
pub fn pages(files: &[TextFile]) -> Vec<TextFile> {
    let known: Vec<Known> = dialects();
    let mut out = Vec::new();
    for (chapter, known) in CHAPTERS.iter().zip(&known) {
        for (page, names) in chapter.pages.iter().zip(known) {
            let path = format!("{FOLDER}{}.md", page.file);
            let text = text(page, names, &path, text_of(files, &path));
            out.push(TextFile { path, text });
        }
    }
    if let Some(list) = text_of(files, LIST) {
        let chapters = CHAPTERS.iter().zip(&known).map(|(chapter, known)| chapter_list(chapter, known)).collect::<String>() + "\n";
        out.push(TextFile { path: LIST.to_owned(), text: between(list, LIST_BEGIN, &chapters) });
    }
    out
}

/// Asks the compiler for all names at once.
fn dialects() -> Vec<Known> {
    let options = Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let names: Vec<&str> = CHAPTERS.iter().flat_map(|chapter| chapter.pages).flat_map(|page| page.names).copied().collect();
    let columns = Dialect::ALL.map(|dialect| known(&names, dialect, &options));
    let mut rows = names.iter().enumerate().map(|(row, &name)| (name, std::array::from_fn(|column| columns[column][row])));
    let mut page = |page: &Page| page.names.iter().filter_map(|_| rows.next()).collect();
    CHAPTERS.iter().map(|chapter| chapter.pages.iter().map(&mut page).collect()).collect()
}

/// The head from the row and the compiler, the diagrams from the examples; the rest stays, or begins with what every page has.
fn text(page: &Page, names: &[(&str, [bool; 4])], path: &str, old: Option<&str>) -> String {
    let spelled = names[0].0;
    let mut head = format!("# {spelled}: {}\n\n", page.purpose);
    for call in page.calls {
        let _ = writeln!(head, "- `{call}`");
    }
    head.push_str("\n| | iec | codesys | scl | tia |\n|---|---|---|---|---|\n");
    for (spelled, columns) in grouped(names) {
        let _ = writeln!(head, "| {spelled} | {} |", marks(columns));
    }
    let rest = old.and_then(|old| old.split_once(HEAD_END)).map(|(_, rest)| rest.to_owned());
    let rest = rest.unwrap_or_else(|| "\n## Example\n\n```st iec\n```\n```check\n```\n\n## Pitfalls\n\n## Dialects\n".to_owned());
    format!("{head}\n{HEAD_END}{}", diagrams(&rest, path))
}

/// Names with the same dialects, in the order in which they come.
fn grouped(names: &[(&str, [bool; 4])]) -> Vec<(String, [bool; 4])> {
    let mut groups: Vec<(String, [bool; 4])> = Vec::new();
    for &(name, columns) in names {
        match groups.iter_mut().find(|(_, other)| *other == columns) {
            Some((text, _)) => text.push_str(&format!(" `{name}`")),
            None => groups.push((format!("`{name}`"), columns)),
        }
    }
    groups
}

fn marks(columns: [bool; 4]) -> String {
    columns.map(|has| if has { "yes" } else { "–" }).join(" | ")
}

fn chapter_list(chapter: &Chapter, known: &Known) -> String {
    let mut text = format!("\n## {}\n\n| | for | iec | codesys | scl | tia |\n|---|---|---|---|---|---|\n", chapter.title);
    for (page, names) in chapter.pages.iter().zip(known) {
        for (index, (spelled, columns)) in grouped(names).into_iter().enumerate() {
            let purpose = if index == 0 { format!("[{}](../../{FOLDER}{}.md)", cell(page.purpose), page.file) } else { String::new() };
            let _ = writeln!(text, "| {spelled} | {purpose} | {} |", marks(columns));
        }
    }
    text
}

/// The text with each diagram drawn from the example before it.
fn diagrams(text: &str, path: &str) -> String {
    let mut out = text.to_owned();
    for (at, _) in text.match_indices(DIAGRAM) {
        let line = text[at..].lines().next().unwrap_or_default();
        let names = line.trim_start_matches(DIAGRAM).trim_end_matches(" -->");
        let (program, dialect) = fence(&text[..at], "```st ").unwrap_or_else(|| panic!("{path}: no example above `{line}`"));
        let (check, _) = fence(&text[..at], "```check").unwrap_or_else(|| panic!("{path}: no check above `{line}`"));
        let dialect = dialect.split_whitespace().next().and_then(Dialect::from_name);
        let options = Options { system_blocks: sieben_cpu::system::interfaces(), dialect, ..Options::default() };
        let names: Vec<&str> = names.split_whitespace().collect();
        let trace = signal_diagrams::record("example.st", program, path, check, &names, &options);
        let drawn = signal_diagrams::as_text(&trace, path);
        out = between(&out, &format!("{line}\n"), &format!("```text\n{drawn}```\n"));
    }
    out
}

/// The last fence that begins so: its text, and what stands behind the beginning.
fn fence<'a>(text: &'a str, begin: &str) -> Option<(&'a str, &'a str)> {
    let at = text.rfind(&format!("\n{begin}"))? + 1;
    let (info, body) = text[at..].split_once('\n')?;
    Some((body.split_once("```").map_or(body, |(body, _)| body), &info[begin.len()..]))
}
