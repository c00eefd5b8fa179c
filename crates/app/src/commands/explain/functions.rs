//! Standard functions and blocks of Structured Text: their pages, and the list of all.

use sieben_lang::Options;
use sieben_lang::st::Dialect;
use sieben_lang::st::standard::catalogue::{CHAPTERS, known, page};

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
            text.push_str(&format!("  {:<40} {}\n", page.names.join(" "), page.purpose));
        }
    }
    text
}

/// The names that a misspelled word is compared with.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    CHAPTERS.iter().flat_map(|chapter| chapter.pages).flat_map(|page| page.names).copied()
}
