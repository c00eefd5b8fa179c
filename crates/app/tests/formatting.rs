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
        let is_source = path.extension().is_some_and(|ending| ["awl", "st", "scl", "stl"].iter().any(|known| ending == *known));
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
