//! Standard functions and blocks of Structured Text: their pages, and the list of all.

use sieben_lang::Options;
use sieben_lang::known_names::known;
use sieben_lang::st::Dialect;
#[cfg(test)]
use sieben_lang::st::standard::catalogue::names;
use sieben_lang::st::standard::catalogue::{CHAPTERS, page};

/// The pages of all functions by file.
const PAGES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/function_pages.rs"));

/// The page of a function, also of a conversion that stands for others there.
pub(super) fn function(word: &str) -> Option<String> {
    let page = page(word)?;
    let (_, text) = PAGES.iter().find(|(file, _)| *file == page.file)?;
    let name = word.to_ascii_uppercase();
    let mut out = String::new();
    if !page.names.contains(&name.as_str()) {
        let options = Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
        let has = |dialect: &Dialect| known(&[&name], *dialect, &options) == [true];
        let dialects: Vec<&str> = Dialect::ALL.iter().filter(|dialect| has(dialect)).map(|dialect| dialect.name()).collect();
        if dialects.is_empty() {
            return None;
        }
        out.push_str(&format!("{name} ({}) is explained together with others.\n\n", dialects.join(", ")));
    }
    // Marks of what is generated say nothing to the reader.
    let lines = text.lines().filter(|line| !line.starts_with("<!--"));
    let mut empty = false;
    for line in lines {
        if !(empty && line.is_empty()) {
            out.push_str(line);
            out.push('\n');
        }
        empty = line.is_empty();
    }
    Some(out)
}

/// A line for each page: its names and what they are for.
pub(super) fn functions() -> String {
    let mut text = String::new();
    for chapter in CHAPTERS {
        text.push_str(&format!("{}\n", chapter.title));
        for page in chapter.pages {
            let mut purpose = page.purpose;
            for names in lines(page.names) {
                text.push_str(format!("  {names:<NAMES$} {purpose}").trim_end());
                text.push('\n');
                purpose = "";
            }
        }
    }
    text
}

/// Columns that the names of a page have: with what they are for behind them a line has less than 80.
const NAMES: usize = 42;

/// Names with blanks between them, as many as a line has room for.
fn lines(names: &[&str]) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for name in names {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + name.len() <= NAMES => {
                line.push(' ');
                line.push_str(name);
            }
            _ => lines.push((*name).to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_of_the_list_is_longer_than_a_terminal() {
        let text = functions();
        assert!(text.lines().all(|line| line.chars().count() < 80), "{text}");
        let words: Vec<&str> = text.split_whitespace().collect();
        assert!(names().all(|name| words.contains(&name)), "{text}");
    }
}
