//! A token that is missing in a program of Structured Text has few messages, and a program that is cut off has no panic: over all
//! programs of the pages and of the corpus, with all that the compiler says.

use std::path::{Path, PathBuf};
use std::{env, fs};

use sieben_lang::st::syntax::SyntaxKind;
use sieben_lang::st::{self, Dialect};
use sieben_lang::{Options, compile, encoding};
use sieben_model::diagnostic::Severity;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

/// Most messages that a lost token may have, but in one of a hundred cases.
const MESSAGES_MAX: usize = 3;

/// Of so many tokens of the pages one is left out: all of them would take minutes. `cargo xtask soak programs` takes them.
const STEP_PAGES: usize = 8;

/// Of so many tokens of the corpus, whose programs are longer.
const STEP_CORPUS: usize = 5;

struct Program {
    page: String,
    dialect: Dialect,
    text: String,
}

/// The programs of the pages of a folder, each in the first of its dialects.
fn programs(folder: &str) -> Vec<Program> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec");
    let mut pages: Vec<PathBuf> = fs::read_dir(root.join(folder))
        .expect("the folder is there")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|ending| ending == "md"))
        .collect();
    pages.sort();
    let mut programs = Vec::new();
    for path in pages {
        let text = fs::read_to_string(&path).expect("a page is a text");
        for (at, _) in text.match_indices("\n```st ") {
            let (info, body) = text[at + 1..].split_once('\n').expect("a fence has lines");
            let dialect = info.split(' ').nth(1).and_then(Dialect::from_name).expect("a fence names its dialects");
            let text = body.split("\n```").next().unwrap_or_default().to_owned() + "\n";
            let page = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            programs.push(Program { page, dialect, text });
        }
    }
    programs
}

/// The programs of the corpus in a dialect.
fn corpus(dialect: Dialect) -> Vec<Program> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/corpus/st");
    let files = fs::read_dir(root.join(dialect.name())).expect("the corpus is there");
    let mut paths: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    paths.sort();
    let programs = paths.iter().filter(|path| path.extension().is_some_and(|ending| ending != "txt")).map(|path| {
        let text = encoding::read_source(&fs::read(path).expect("a source can be read")).expect("a source is a text").text;
        let page = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        Program { page, dialect, text }
    });
    programs.collect()
}

/// The codes of all errors.
fn errors(text: &str, dialect: Dialect, options: &Options) -> Vec<&'static str> {
    let mut sources = Sources::default();
    sources.add("program.st", text);
    let compiled = compile(&sources, &SymbolTable::default(), &Options { dialect: Some(dialect), ..options.clone() });
    let errors = compiled.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error);
    errors.map(|diagnostic| diagnostic.problem.code()).collect()
}

/// Leaves out one of so many tokens, at least so many times.
fn lose(programs: Vec<Program>, step: usize, tokens_min: usize) {
    let times = env::var("SIEBEN_TIMES").ok().and_then(|times| times.parse().ok()).unwrap_or(1);
    let step = (step / times).max(1);
    let options = Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let mut counts: Vec<(usize, String)> = Vec::new();
    let mut seen = 0;
    for Program { page, dialect, text } in programs {
        // Pages about mistakes, and programs with parts in STL.
        if !errors(&text, dialect, &options).is_empty() {
            continue;
        }
        let tree = st::parse(FileId::default(), &text, dialect).syntax(&text);
        let tokens = tree.descendants_with_tokens().filter_map(|element| element.into_token());
        for token in tokens.filter(|token| token.kind() > SyntaxKind::Inactive) {
            seen += 1;
            if seen % step != 0 {
                continue;
            }
            // A diagram without the words before it is read as statements or declarations, of which each is wrong.
            let range = token.text_range();
            let next = text[usize::from(range.end())..].split_whitespace().next().unwrap_or_default();
            let is_word = |word: &str| matches!(word, "LD" | "FBD");
            if token.kind() == SyntaxKind::Keyword && (is_word(token.text()) || (token.text() == "END_VAR" && is_word(next))) {
                continue;
            }
            let (start, end) = (usize::from(range.start()), usize::from(range.end()));
            let found = errors(&format!("{} {}", &text[..start], &text[end..]), dialect, &options);
            let line = text[..start].lines().last().unwrap_or_default();
            counts.push((found.len(), format!("{page} {}: `{line}` without `{}`: {}", dialect.name(), token.text(), found.join(" "))));
            // A program that ends there is asked for every second time: nothing is said of its messages.
            if seen % (2 * step) == 0 {
                errors(&text[..start], dialect, &options);
            }
        }
    }
    counts.sort();
    let share = |part: usize| &counts[counts.len() * part / 100];
    let worst: Vec<&str> = counts.iter().rev().take(150).map(|(_, which)| which.as_str()).collect();
    assert!(counts.len() > tokens_min, "{} tokens", counts.len());
    assert!(share(50).0 <= 1, "the median is {}\n{}", share(50).0, worst.join("\n"));
    assert!(share(99).0 <= MESSAGES_MAX, "of {} tokens one of a hundred has {} messages\n{}", counts.len(), share(99).0, worst.join("\n"));
}

#[test]
fn a_lost_token_of_a_page_of_the_language_has_few_messages() {
    lose(programs("st"), STEP_PAGES, 600);
}

#[test]
fn a_lost_token_of_a_page_of_a_function_has_few_messages() {
    lose(programs("functions"), STEP_PAGES, 600);
}

#[test]
fn a_lost_token_of_the_course_has_few_messages() {
    lose(programs("course"), STEP_PAGES, 60);
}

#[test]
fn a_lost_token_of_a_program_of_the_corpus_has_few_messages() {
    lose([Dialect::Iec, Dialect::Codesys].map(corpus).into_iter().flatten().collect(), STEP_CORPUS, 250);
}

#[test]
fn a_lost_token_of_a_program_of_the_corpus_in_scl_has_few_messages() {
    lose([Dialect::Scl, Dialect::Tia].map(corpus).into_iter().flatten().collect(), STEP_CORPUS, 250);
}
