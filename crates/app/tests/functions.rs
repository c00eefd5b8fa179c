//! The catalogue of standard functions and blocks: its calls compile, its pages are whole, and no name of the compiler is missing.

mod program;

use std::fs;
use std::path::{Path, PathBuf};

use sieben_lang::Options;
use sieben_lang::known_names::known;
use sieben_lang::st::Dialect;
use sieben_lang::st::standard::catalogue::{CHAPTERS, page};
use sieben_lang::st::standard::library::SOURCES;
use sieben_model::cpu_type::CpuType;
use sieben_model::types::DataType;

/// Types that stand for several, and the one that the calls here give.
const GENERIC: [(&str, &str); 5] = [("ANY_NUM", "INT"), ("ANY_INT", "INT"), ("ANY_REAL", "REAL"), ("ANY_BIT", "WORD"), ("ANY", "INT")];

/// Blocks of the library in ST that only its other blocks and the compiler call, by a part of their names.
const INNER: [&str; 9] = ["IEC_", "TIA_", "CODESYS_", "_IN_TEXT", "DIGITS_OF_", "_OF_DATE", "_STRING_", "X_STRING", "_WSTRING_"];

/// Words of the language and addresses that stand in quotes beside names of functions.
const OTHER_WORDS: [&str; 5] = ["TRUE", "FALSE", "NULL", "THIS", "T1"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn text(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn options() -> Options {
    Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() }
}

/// A source that calls a function or block as a line of the catalogue says.
fn source(call: &str, dialect: Dialect) -> Option<String> {
    let (head, outputs) = call.split_once(" → ").unwrap_or((call, ""));
    let (name, rest) = head.split_once('(')?;
    let (inputs, result) = rest.split_once(')')?;
    let (mut variables, mut arguments) = (String::new(), Vec::new());
    let mut argument = |name: &str, arrow: &str, word: &str| {
        let place = arguments.len();
        let word = GENERIC.iter().find(|(generic, _)| *generic == word).map_or(word, |(_, word)| word);
        match word {
            "TIMER" => arguments.push(format!("{name} := T1")),
            "COUNTER" => arguments.push(format!("{name} := C1")),
            _ => {
                variables.push_str(&format!("a{place} : {word};\n"));
                arguments.push(format!("{name} {arrow} a{place}"));
            }
        }
    };
    for parameter in inputs.split("; ").filter(|parameter| !parameter.is_empty() && *parameter != "…") {
        match parameter.split_once(" => ") {
            Some((name, word)) => argument(name, "=>", word),
            None => {
                let (name, word) = parameter.split_once(": ")?;
                argument(name, ":=", word);
            }
        }
    }
    for output in outputs.split("; ").filter(|output| !output.is_empty()) {
        let (name, word) = output.split_once(": ")?;
        argument(name, "=>", word);
    }
    let arguments = arguments.join(", ");
    let statement = if !outputs.is_empty() {
        variables.push_str(&format!("instance : {name};\n"));
        format!("instance({arguments});")
    } else if let Some(word) = result.strip_prefix(": ") {
        let word = GENERIC.iter().find(|(generic, _)| *generic == word).map_or(word, |(_, word)| word);
        variables.push_str(&format!("result : {word};\n"));
        format!("result := {name}({arguments});")
    } else {
        format!("{name}({arguments});")
    };
    let begin = if matches!(dialect, Dialect::Scl | Dialect::Tia) { "BEGIN\n" } else { "" };
    Some(format!("FUNCTION_BLOCK Caller\nVAR\n{variables}END_VAR\n{begin}{statement}\nEND_FUNCTION_BLOCK\n"))
}

#[test]
fn functions_are_called_as_the_catalogue_says() {
    let (mut wrong, mut tried) = (Vec::new(), 0);
    for call in CHAPTERS.iter().flat_map(|chapter| chapter.pages).flat_map(|page| page.calls) {
        let (dialects, call) = match call.split_once(": ") {
            Some((words, rest)) if Dialect::from_name(words.split(' ').next().unwrap_or_default()).is_some() => {
                (words.split(' ').filter_map(Dialect::from_name).collect(), rest)
            }
            _ => (Dialect::ALL.to_vec(), *call),
        };
        let name = call.split('(').next().unwrap_or_default();
        let whose: Vec<Dialect> = dialects.into_iter().filter(|&dialect| known(&[name], dialect, &options()) == [true]).collect();
        if whose.is_empty() {
            wrong.push(format!("{call}: no dialect knows it"));
        }
        for dialect in whose {
            let Some(source) = source(call, dialect) else { continue };
            tried += 1;
            if let Err(message) = program::compile_sources(&[("call.st", &source)], None, Some(dialect), &CpuType::ALL[0]) {
                wrong.push(format!("{call} in {}: {message}", dialect.name()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(tried > 200, "only {tried} calls were tried");
}

#[test]
fn every_page_tells_pitfalls_and_dialects_and_shows_signals_where_there_are_any() {
    let mut wrong = Vec::new();
    for chapter in CHAPTERS {
        for page in chapter.pages {
            let path = format!("spec/functions/{}.md", page.file);
            let text = text(&path);
            let mut parts = vec!["\n## Example\n", "\n## Pitfalls\n\n- ", "\n## Dialects\n\n- "];
            parts.extend(chapter.signals.then_some("<!-- generated: diagram "));
            wrong.extend(parts.into_iter().filter(|part| !text.contains(part)).map(|part| format!("{path} has no {part:?}")));
        }
    }
    let files = fs::read_dir(root().join("spec/functions")).expect("the folder is there");
    for file in files.filter_map(|entry| Some(entry.ok()?.path())) {
        let name = file.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        if !CHAPTERS.iter().flat_map(|chapter| chapter.pages).any(|page| page.file == name) {
            wrong.push(format!("spec/functions/{name}.md has no row in the catalogue"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Words in capital letters that stand in quotes in the sources of the compiler where it looks for names of functions.
fn quoted_words() -> Vec<String> {
    let folders = ["crates/lang/src/st/standard", "crates/lang/src/st/check"];
    let files = folders.iter().flat_map(|folder| fs::read_dir(root().join(folder)).expect("the folder is there"));
    let paths = files.filter_map(|entry| Some(entry.ok()?.path())).filter(|path| path.extension().is_some_and(|ending| ending == "rs"));
    let texts = paths.map(|path| fs::read_to_string(path).expect("a source is a text"));
    let is_name =
        |word: &&str| word.len() > 1 && word.bytes().all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'_');
    let mut words: Vec<String> = texts.flat_map(|text| text.split('"').filter(is_name).map(str::to_owned).collect::<Vec<_>>()).collect();
    for source in SOURCES {
        let heads = source.text.lines().filter_map(|line| line.strip_prefix("FUNCTION_BLOCK ").or_else(|| line.strip_prefix("FUNCTION ")));
        words.extend(heads.filter_map(|rest| rest.split([' ', ':']).next()).map(|name| name.trim_matches('"').to_owned()));
    }
    words.sort();
    words.dedup();
    words.retain(|word| DataType::from_any_word(word).is_none() && !INNER.iter().any(|part| format!("{word}_").contains(part)));
    words.retain(|word| !OTHER_WORDS.contains(&word.as_str()));
    words
}

#[test]
fn every_function_of_the_compiler_has_a_page() {
    let words = quoted_words();
    assert!(words.len() > 200, "only {} words were found", words.len());
    let words: Vec<&str> = words.iter().map(String::as_str).filter(|word| page(word).is_none()).collect();
    // What the S7 library and the CPU have is told by their own lists.
    let elsewhere = |word: &str| {
        let named = |name: &str| name.eq_ignore_ascii_case(word);
        sieben_lang::library::by_name(word).is_some() || sieben_cpu::system::interfaces().iter().any(|block| named(block.name))
    };
    let mut missing = Vec::new();
    for dialect in Dialect::ALL {
        let found = known(&words, dialect, &options());
        missing.extend(words.iter().zip(found).filter(|(word, found)| *found && !elsewhere(word)).map(|(word, _)| *word));
    }
    missing.sort_unstable();
    missing.dedup();
    assert!(missing.is_empty(), "without a row in crates/lang/src/st/standard/catalogue.rs and a page: {}", missing.join(", "));
}
