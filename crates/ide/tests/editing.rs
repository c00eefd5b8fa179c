//! Projects with a mark beside what the editor services answer there: the files of `editing/`, and what holds at every byte.
//!
//! A case is `=== title`, its texts, each after `[name]`, and questions `--- service` with their answers. The mark is `‸`; in answers a place
//! is `name:line:column`. `SIEBEN_GENERATE=1` writes the answers as they are.

#![allow(clippy::disallowed_methods)] // The cases and sources lie in folders; `SIEBEN_GENERATE` writes the answers.

#[path = "editing/services.rs"]
mod services;

use std::fs;
use std::path::Path;
use std::sync::Arc;

use services::{answer, everything};
use sieben_ide::editing::rename::{prepare, rename};
use sieben_ide::editing::{Edit, Position, Role, Snapshot, Text, TextId};
use sieben_lang::{Options, compile, symbols};
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

const MARK: char = '‸';

/// A project with a mark.
struct Case {
    title: String,
    texts: Vec<Text>,
    mark: Position,
    questions: Vec<(String, String)>,
}

fn role(name: &str) -> Role {
    match name.rsplit_once('.').map(|(_, ending)| ending) {
        Some("csv" | "sdf" | "asc" | "dif" | "seq") => Role::Symbols,
        Some("md" | "txt" | "toml") => Role::Other,
        _ => Role::Source,
    }
}

fn text(name: &str, text: &str) -> Text {
    Text { name: name.to_owned(), text: Arc::from(text), role: role(name), fixed: None }
}

fn cases(file: &str) -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    enum In {
        Nothing,
        Text(String, String),
        Answer,
    }
    fn close(state: &mut In, cases: &mut [Case]) {
        if let (In::Text(name, content), Some(case)) = (std::mem::replace(state, In::Nothing), cases.last_mut()) {
            if let Some(offset) = content.find(MARK) {
                case.mark = Position { text: TextId(case.texts.len()), offset };
            }
            case.texts.push(text(&name, &content.replace(MARK, "")));
        }
    }
    let mut state = In::Nothing;
    for line in file.split_inclusive('\n') {
        let content = line.trim_end();
        if let Some(title) = content.strip_prefix("=== ") {
            close(&mut state, &mut cases);
            let mark = Position { text: TextId(0), offset: 0 };
            cases.push(Case { title: title.to_owned(), texts: Vec::new(), mark, questions: Vec::new() });
        } else if let Some(question) = content.strip_prefix("--- ") {
            close(&mut state, &mut cases);
            state = In::Answer;
            if let Some(case) = cases.last_mut() {
                case.questions.push((question.to_owned(), String::new()));
            }
        } else if let (Some(name), false) = (content.strip_prefix('[').and_then(|name| name.strip_suffix(']')), matches!(state, In::Answer))
        {
            close(&mut state, &mut cases);
            state = In::Text(name.to_owned(), String::new());
        } else {
            match &mut state {
                In::Text(_, text) => text.push_str(line),
                In::Answer => {
                    if let Some((_, answer)) = cases.last_mut().and_then(|case| case.questions.last_mut()) {
                        answer.push_str(line);
                    }
                }
                In::Nothing => {}
            }
        }
    }
    close(&mut state, &mut cases);
    cases
}

fn options() -> Options {
    Options { system_blocks: Vec::new(), ..Options::default() }
}

#[test]
fn every_service_answers_as_the_files_say() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/editing");
    let mut wrong = String::new();
    let mut paths: Vec<_> = fs::read_dir(&folder).expect("the folder is there").flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths.iter().filter(|path| path.extension().is_some_and(|ending| ending == "txt")) {
        let file = fs::read_to_string(path).expect("a case is text");
        let mut right = file.clone();
        for case in cases(&file) {
            let snapshot = Snapshot::new(case.texts, &options());
            for (question, expected) in &case.questions {
                let given = answer(&snapshot, case.mark, question);
                if given.trim_end() != expected.trim_end() {
                    wrong.push_str(&format!("{}: {}: {question}\n{given}\n", path.display(), case.title));
                    let from = right.find(&format!("=== {}\n", case.title)).unwrap_or(0);
                    let head = format!("--- {question}\n");
                    let at = from + right[from..].find(&head).expect("the question is there") + head.len();
                    let end =
                        ["\n--- ", "\n=== "].iter().filter_map(|next| right[at - 1..].find(next)).min().map_or(right.len(), |end| at + end);
                    let gap = if right[end..].starts_with("===") { "\n" } else { "" };
                    right.replace_range(at..end, &format!("{}{}{gap}", given.trim_end(), if given.is_empty() { "" } else { "\n" }));
                }
            }
        }
        if std::env::var_os("SIEBEN_GENERATE").is_some() {
            fs::write(path, right).expect("the folder can be written");
        }
    }
    assert!(wrong.is_empty() || std::env::var_os("SIEBEN_GENERATE").is_some(), "{wrong}");
}

/// All sources of the repository that a project may have, folder by folder.
fn projects() -> Vec<Vec<Text>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut folders = vec![root.join("examples"), root.join("spec/corpus"), root.join("library")];
    let mut projects = Vec::new();
    while let Some(folder) = folders.pop() {
        let mut texts = Vec::new();
        let mut entries: Vec<_> = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
        entries.sort();
        for path in entries {
            let name = path.display().to_string();
            match path.extension().and_then(|ending| ending.to_str()) {
                _ if path.is_dir() => folders.push(path),
                Some("awl" | "stl" | "st" | "scl" | "lad" | "fbd" | "udt" | "db" | "csv" | "sdf" | "asc" | "seq" | "dif") => {
                    if let Ok(content) = fs::read_to_string(&path) {
                        texts.push(text(&name, &content));
                    }
                }
                _ => {}
            }
        }
        // Folders of many sources that have nothing to do with one another are cut up.
        projects.extend(texts.chunks(12).map(<[Text]>::to_vec));
    }
    projects.retain(|texts| !texts.is_empty());
    projects
}

/// Steps through numbers that look random, so that a failure can be had again.
struct Steps(u64);

impl Steps {
    fn next(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % below.max(1)
    }
}

#[test]
fn no_service_panics_at_any_byte_of_any_source() {
    let mut steps = Steps(48);
    for texts in projects() {
        let snapshot = Snapshot::new(texts, &options());
        for index in 0..snapshot.texts().len() {
            for _ in 0..12 {
                let length = snapshot.texts()[index].text.len();
                let position = Position { text: TextId(index), offset: steps.next(length + 3) };
                everything(&snapshot, position);
            }
        }
        everything(&snapshot, Position { text: TextId(usize::MAX), offset: usize::MAX });
    }
}

#[test]
fn no_service_panics_in_a_source_that_is_half_typed() {
    let mut steps = Steps(7);
    for texts in projects() {
        let index = steps.next(texts.len());
        let mut texts = texts;
        let content = Arc::clone(&texts[index].text);
        let mut snapshot = Snapshot::new(texts.clone(), &options());
        for _ in 0..3 {
            let mut cut = steps.next(content.len() + 1);
            while !content.is_char_boundary(cut) {
                cut -= 1;
            }
            texts[index].text = Arc::from(&content[..cut]);
            snapshot = snapshot.changed(texts.clone(), &options());
            everything(&snapshot, Position { text: TextId(index), offset: cut });
            everything(&snapshot, Position { text: TextId(index), offset: steps.next(cut + 1) });
        }
    }
}

/// The texts after some edits.
fn edited(snapshot: &Snapshot, edits: &[Edit]) -> Vec<Text> {
    let mut texts = snapshot.texts().to_vec();
    for edit in edits.iter().rev() {
        let text = &mut texts[edit.place.text.0];
        let mut content = text.text.to_string();
        content.replace_range(edit.place.range.start..edit.place.range.end, &edit.new_text);
        text.text = Arc::from(content);
    }
    texts
}

#[test]
fn a_rename_there_and_back_gives_the_same_bytes() {
    let mut steps = Steps(11);
    let mut renamed = 0;
    // The library has the names of its own sources.
    let is_own = |texts: &Vec<Text>| !texts.iter().any(|text| text.name.contains("/library/"));
    for texts in projects().into_iter().filter(is_own) {
        let snapshot = Snapshot::new(texts, &options());
        for _ in 0..60 {
            let index = steps.next(snapshot.texts().len());
            let position = Position { text: TextId(index), offset: steps.next(snapshot.texts()[index].text.len()) };
            let Ok(old) = prepare(&snapshot, position) else { continue };
            let other = if old.name.len() > 4 { "Zz9_other" } else { "zq7" };
            let Ok(edits) = rename(&snapshot, position, other) else { continue };
            let there = snapshot.changed(edited(&snapshot, &edits), &options());
            // The place moves with what is before it in its text.
            let moved: isize = edits
                .iter()
                .filter(|edit| edit.place.text == position.text && edit.place.range.start < old.range.start)
                .map(|edit| edit.new_text.len() as isize - (edit.place.range.end - edit.place.range.start) as isize)
                .sum();
            let position = Position { offset: (old.range.start as isize + moved) as usize, ..position };
            let back = match rename(&there, position, &old.name) {
                // A word of the language that stands as a name, such as `tod` of IEC 61131-3, is given to nothing else.
                Err(refusal) if refusal.contains("no word of the language") => continue,
                back => back.unwrap_or_else(|refusal| panic!("{}: {refusal}", old.name)),
            };
            assert_eq!(back.len(), edits.len(), "{} in {}", old.name, snapshot.texts()[index].name);
            for (before, after) in snapshot.texts().iter().zip(edited(&there, &back)) {
                let same = before.text == after.text;
                assert!(same || before.text.to_lowercase() == after.text.to_lowercase(), "{} in {}", old.name, before.name);
            }
            renamed += 1;
        }
    }
    assert!(renamed > 100, "{renamed} names were renamed");
}

/// The problems of a project, as numbers in order.
fn problems(texts: &[Text]) -> Vec<String> {
    let mut sources = Sources::default();
    let mut symbols = SymbolTable::default();
    for text in texts {
        match text.role {
            Role::Source if !text.name.ends_with(".test.st") => drop(sources.add(&*text.name, &*text.text)),
            Role::Symbols => {
                let format = symbols::detect(&text.name, &text.text).expect("the table has a format");
                symbols::read(FileId::default(), &text.text, format).table.symbols().iter().for_each(|row| symbols.push(row.clone()));
            }
            _ => {}
        }
    }
    let found = compile(&sources, &symbols, &options()).diagnostics;
    let mut codes: Vec<String> = found.iter().map(|one| format!("{:?}", one.problem)).collect();
    codes.sort();
    codes
}

#[test]
fn a_program_has_the_same_problems_after_a_rename() {
    let mut steps = Steps(5);
    let mut renamed = 0;
    let is_example = |texts: &Vec<Text>| texts.iter().any(|text| text.name.contains("/examples/"));
    for texts in projects().into_iter().filter(is_example) {
        let snapshot = Snapshot::new(texts, &options());
        let before = problems(snapshot.texts());
        for _ in 0..12 {
            let index = steps.next(snapshot.texts().len());
            let position = Position { text: TextId(index), offset: steps.next(snapshot.texts()[index].text.len()) };
            let Ok(old) = prepare(&snapshot, position) else { continue };
            let other = if old.name.len() > 4 { "Zz9_other" } else { "zq7" };
            let Ok(edits) = rename(&snapshot, position, other) else { continue };
            let after = problems(&edited(&snapshot, &edits));
            assert_eq!(before, after, "{} in {}", old.name, snapshot.texts()[index].name);
            renamed += 1;
        }
    }
    assert!(renamed > 20, "{renamed} names were renamed");
}
