//! `fmt` over every source there is: its layout is final, and what is said about the source stays the same.

use std::fs;
use std::path::{Path, PathBuf};

use sieben_lang::encoding;
use sieben_lang::language::Language;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// Fewer sources than that would mean that the folders were not found.
const SOURCES_MIN: usize = 200;

fn sources_below(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.expect("the folder can be read").path();
        let is_source =
            path.extension().is_some_and(|ending| ["awl", "st", "scl", "stl", "lad", "fbd"].iter().any(|known| ending == *known));
        match path.is_dir() {
            true => sources_below(&path, found),
            false if is_source => found.push(path),
            false => {}
        }
    }
}

/// What is said about a source alone: codes and messages, without places.
fn said(name: &str, text: &str) -> Vec<(&'static str, String)> {
    let mut sources = Sources::default();
    sources.add(name, text);
    let options = sieben_lang::Options { system_blocks: sieben_cpu::system::interfaces(), ..Default::default() };
    let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &options);
    // A space that is missing behind an instruction is what `fmt` writes.
    let stays = compiled.diagnostics.into_iter().filter(|diagnostic| diagnostic.problem.code() != "P2008");
    let mut said: Vec<_> = stays.map(|diagnostic| (diagnostic.problem.code(), diagnostic.message)).collect();
    said.sort();
    said
}

#[test]
fn a_layout_is_final_and_changes_nothing_that_is_said() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut paths = Vec::new();
    for folder in ["spec/corpus", "examples", "benches/st", "crates/app/templates"] {
        sources_below(&root.join(folder), &mut paths);
    }
    paths.sort();
    let (mut formatted, mut wrong) = (0, Vec::new());
    for path in &paths {
        let name = path.file_name().and_then(|name| name.to_str()).expect("names are UTF-8");
        let Some(decoded) = encoding::read_source(&fs::read(path).expect("the source can be read")).ok() else { continue };
        let language = Language::of(name, &decoded.text, None);
        let format = |text: &str| (language.row().format)(text, language, None);
        let Ok(once) = format(&decoded.text) else { continue };
        formatted += 1;
        if Language::of(name, &once, None) != language {
            wrong.push(format!("{}: it is taken for another dialect", path.display()));
        } else if format(&once).as_deref() != Ok(once.as_str()) {
            wrong.push(format!("{}: formatted twice it is another text", path.display()));
        } else if said(name, &decoded.text) != said(name, &once) {
            let (before, after) = (said(name, &decoded.text), said(name, &once));
            wrong.push(format!("{}: before\n  {before:?}\nafter\n  {after:?}", path.display()));
        }
    }
    assert!(formatted >= SOURCES_MIN, "{formatted} sources of {}", paths.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The diagrams of the manual, each with the ending of a file that has it.
fn diagrams_of_the_manual() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/diagrams");
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("the pages of the diagrams") {
        let page = fs::read_to_string(entry.expect("an entry").path()).expect("a page");
        for ending in ["lad", "fbd"] {
            let begin = format!("```{ending}\n");
            let fences = page.split(&begin).skip(1);
            found.extend(fences.map(|fence| (format!("a.{ending}"), fence.split("```").next().unwrap_or_default().to_owned())));
        }
    }
    assert!(found.len() > 50, "{} diagrams", found.len());
    found
}

/// The statements that a source stands for, without their places.
fn statements(name: &str, text: &str) -> Vec<String> {
    use sieben_lang::stl::parser::parse_as;
    use sieben_model::source::FileId;
    let parsed = parse_as(FileId::default(), text, None, Language::of(name, text, None).drawing());
    assert!(parsed.diagnostics.is_empty(), "{text}\n{:?}", parsed.diagnostics);
    // A place is `Span { … }` in the text of a tree, and tells nothing here.
    let without_places = |text: String| {
        let mut parts = text.split("Span {");
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |text, part| text + part.split_once('}').map_or("", |(_, rest)| rest))
    };
    parsed.file.blocks.iter().flat_map(|block| &block.statements).map(|statement| without_places(format!("{statement:?}"))).collect()
}

/// Comments in their order, without the spaces around them.
fn comments(text: &str) -> Vec<String> {
    text.lines().filter_map(|line| Some(line.split_once("//")?.1.trim().to_owned())).collect()
}

#[test]
fn the_layout_of_a_diagram_keeps_statements_comments_and_line_ends() {
    let with_comments = |text: &str| -> String {
        // Each line of form A has a comment after it and one before it; a line of statements stays as it is.
        let line = |(number, line): (usize, &str)| match line.trim() {
            trimmed if trimmed.is_empty() || trimmed.contains(';') || !line.starts_with("    ") => format!("{line}\n"),
            _ => format!("// before {number}\n{line} // after {number}\n"),
        };
        text.lines().enumerate().map(line).collect()
    };
    type Change<'c> = (&'c str, &'c dyn Fn(&str) -> String);
    let changes: [Change<'_>; 5] = [
        ("as it is", &str::to_owned),
        ("with tabs", &|text| text.replace("    ", "\t")),
        ("with narrow levels and spaces after each line", &|text| text.replace("    ", " ").replace('\n', "  \n")),
        ("with CR and LF", &|text| text.replace('\n', "\r\n")),
        ("with comments", &with_comments),
    ];
    for (name, text) in diagrams_of_the_manual() {
        let language = Language::of(&name, &text, None);
        let format = |text: &str| (language.row().format)(text, language, None).unwrap_or_else(|wrong| panic!("{text}\n{wrong:?}"));
        let wanted = statements(&name, &text);
        for (how, change) in changes {
            let changed = change(&text);
            let once = format(&changed);
            assert_eq!(format(&once), once, "{name} {how}: formatted twice it is another text");
            assert_eq!(statements(&name, &changed), wanted, "{name} {how}:\n{changed}");
            assert_eq!(statements(&name, &once), wanted, "{name} {how}:\n{changed}\nbecomes\n{once}");
            assert_eq!(comments(&once), comments(&changed), "{name} {how}:\n{changed}\nbecomes\n{once}");
            assert_eq!(once.contains("\r\n"), changed.contains("\r\n"), "{name} {how}");
        }
    }
}
