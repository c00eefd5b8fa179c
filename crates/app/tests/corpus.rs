//! The corpus of sources as they are found in the wild: `spec/corpus/legal` is taken, `spec/corpus/broken` is answered with messages that help.
//!
//! Beside each source lies a text: what is odd about it, what it should do (`=== check`, a scenario), and what comes of it
//! (`=== found`). `BLESS_CORPUS=1 cargo test --test corpus` writes the last part; a symbol table has the name of its source.

#[allow(dead_code)] // Pages and vectors use the rest of it.
mod program;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use sieben_lang::encoding::{self, Encoding};
use sieben_lang::symbols::{self, Format};
use sieben_lang::{Compiled, stl};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;
use sieben_sim::scenario::Scenario;

/// Most diagnostics that one mistake may have.
const DIAGNOSTICS_MAX: usize = 3;
/// Endings of symbol tables beside a source.
const TABLES: [&str; 5] = ["csv", "sdf", "asc", "dif", "seq"];

/// A source with what lies beside it.
struct Case {
    name: String,
    /// Where its text lies.
    page: PathBuf,
    bytes: Vec<u8>,
    symbols: SymbolTable,
    /// The format of the table.
    format: Option<Format>,
    /// What is odd about it.
    why: String,
    /// The scenario, if it runs.
    check: String,
    /// What should come of it.
    found: String,
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/corpus").join(name)
}

fn cases(name: &str) -> Vec<Case> {
    let folder = folder(name);
    let mut paths: Vec<PathBuf> = fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|ending| ending == "awl"))
        .collect();
    paths.sort();
    paths.into_iter().map(|path| case(&path)).collect()
}

fn case(path: &Path) -> Case {
    let name = path.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let page = path.with_extension("txt");
    let text = fs::read_to_string(&page).unwrap_or_else(|error| panic!("{}: {error}", page.display())).replace("\r\n", "\n");
    let (before, found) = text.split_once("=== found\n").unwrap_or((&text, ""));
    let (why, check) = before.split_once("=== check\n").unwrap_or((before, ""));
    let table = TABLES.iter().map(|ending| path.with_extension(ending)).find(|table| table.is_file());
    let read = table.map(|table| {
        let decoded = encoding::read_source(&fs::read(&table).expect("the table can be read")).expect("the table is a text");
        let format = symbols::by_content(&decoded.text).unwrap_or_else(|| panic!("{} shows its format", table.display()));
        let read = symbols::read(FileId::default(), &decoded.text, format);
        assert_eq!(read.diagnostics, [], "{}", table.display());
        (read.table, format)
    });
    let format = read.as_ref().map(|(_, format)| *format);
    let symbols = read.map(|(table, _)| table).unwrap_or_default();
    let bytes = fs::read(path).expect("the source can be read");
    Case { name, page, bytes, symbols, format, why: why.trim().to_owned(), check: check.to_owned(), found: found.to_owned() }
}

/// Compares what came of a case with its text, or writes it there.
fn compare(case: &Case, found: &str, failures: &mut Vec<String>) {
    if std::env::var_os("BLESS_CORPUS").is_some() {
        let check = if case.check.is_empty() { String::new() } else { format!("=== check\n{}", case.check) };
        fs::write(&case.page, format!("{}\n\n{check}=== found\n{found}", case.why)).expect("the text can be written");
    } else if found.trim_end() != case.found.trim_end() {
        failures.push(format!("{}: its text says\n{}\nbut found is\n{found}", case.name, case.found));
    }
}

fn compile(case: &Case, text: &str, cpu: &'static CpuType, mnemonics: Option<Mnemonics>) -> (Sources, Compiled) {
    let mut sources = Sources::default();
    sources.add(format!("{}.awl", case.name), text);
    let options = sieben_lang::Options { cpu: Some(cpu), mnemonics, system_blocks: sieben_cpu::system::interfaces(), ..Default::default() };
    let compiled = sieben_lang::compile(&sources, &case.symbols, &options);
    (sources, compiled)
}

/// What the program is, without the places of the source: equal for sources that mean the same.
fn meaning(compiled: &Compiled) -> BTreeMap<String, String> {
    let code = compiled.program.code.iter().map(|(id, block)| (id.to_string(), format!("{:?}", block.code)));
    let data = compiled.program.data.iter().map(|(number, block)| (format!("DB {number}"), format!("{:?}", block.image)));
    code.chain(data).collect()
}

fn line_ends(text: &str) -> &'static str {
    let (both, newlines) = (text.matches("\r\n").count(), text.matches('\n').count());
    let returns = text.matches('\r').count();
    match (both, newlines, returns) {
        (0, 0, 0) => "no line end",
        (0, _, 0) => "LF",
        (both, newlines, returns) if both == newlines && both == returns => "CR LF",
        _ => "mixed line ends",
    }
}

/// A summary for readers: encoding, language, blocks with their interfaces and data, warnings.
fn summary(case: &Case, text: &str, encoding: Encoding, sources: &Sources, compiled: &Compiled) -> String {
    let language = compiled.mnemonics.values().next().copied().unwrap_or_default();
    let mut out = format!("{}, {}, {language:?} mnemonics", encoding.name(), line_ends(text));
    let _ = match case.format {
        None => writeln!(out),
        Some(format) => writeln!(out, ", {} symbols from .{}", case.symbols.symbols().len(), format.extension()),
    };
    let parsed = stl::parse(FileId::default(), text, Some(language));
    for block in &parsed.file.blocks {
        let name = text[block.name.span().start as usize..block.name.span().end as usize].trim();
        let kind = block.kind.abbreviation();
        let _ = write!(out, "{kind} {}", if block.implicit { "(implicit)" } else { name });
        if !block.statements.is_empty() {
            let _ = write!(out, ": {} statements in {} networks", block.statements.len(), block.networks.len());
        }
        let header = &block.header;
        let fields = [
            ("title", &header.title),
            ("author", &header.author),
            ("family", &header.family),
            ("name", &header.name),
            ("version", &header.version),
        ];
        for (field, word) in fields {
            if let Some(word) = word {
                let _ = write!(out, ", {field} `{}`", word.text);
            }
        }
        if !header.comment.is_empty() {
            let _ = write!(out, ", comment {:?}", header.comment);
        }
        for flag in &header.flags {
            let _ = write!(out, ", {}", flag.text);
        }
        for (name, value) in &header.attributes {
            let _ = write!(out, ", {} = {}", name.text, value.text);
        }
        out.push('\n');
        for network in block.networks.iter().filter(|network| !network.title.is_empty() || !network.comment.is_empty()) {
            let _ = writeln!(out, "  network at statement {}: {:?} {:?}", network.first_statement, network.title, network.comment);
        }
    }
    for (id, block) in &compiled.program.code {
        for variable in &block.interface.variables {
            let bits = variable.data_type.bits();
            let _ = writeln!(out, "  {id} {:?} {} at {}: {bits} bits", variable.section, variable.name, variable.offset);
        }
    }
    for block in compiled.program.data.values() {
        let hex: Vec<String> = block.image.iter().take(64).map(|byte| format!("{byte:02X}")).collect();
        let _ = writeln!(out, "  DB {}, {} bytes: {}", block.number, block.image.len(), hex.join(" "));
    }
    for diagnostic in compiled.diagnostics.iter().filter(|diagnostic| diagnostic.problem.code() != "P3013") {
        let (line, column) = sources.line_column(diagnostic.span);
        let _ = writeln!(out, "{line}:{column} {} {}", diagnostic.problem.code(), diagnostic.message);
    }
    out
}

fn errors(diagnostics: &[Diagnostic], text: &str) -> Vec<String> {
    let errors = diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error);
    errors
        .map(|error| {
            let before = &text[..error.span.start as usize];
            format!("line {}: {} {}", before.matches('\n').count() + 1, error.problem.code(), error.message)
        })
        .collect()
}

/// Everything that must hold for a source that STEP 7 would take.
fn legal(case: &Case, failures: &mut Vec<String>) {
    let mut fail = |what: String| failures.push(format!("{} ({}): {what}", case.name, case.why));
    let decoded = match encoding::read_source(&case.bytes) {
        Ok(decoded) if !decoded.had_errors => decoded,
        other => return fail(format!("cannot be read: {other:?}")),
    };
    let text = decoded.text.as_str();
    if encoding::encode(text, decoded.encoding).as_deref() != Ok(&case.bytes) {
        fail("is not the same bytes when it is written back".to_owned());
    }
    let scenario = match Scenario::parse(&case.check) {
        Ok(scenario) => scenario,
        Err(errors) => return fail(format!("its scenario: {errors:?}")),
    };
    let cpu = scenario.cpu.unwrap_or(&CpuType::ALL[0]);
    let (sources, compiled) = compile(case, text, cpu, None);
    let wrong = errors(&compiled.diagnostics, text);
    if !wrong.is_empty() {
        return fail(format!("is refused:\n  {}", wrong.join("\n  ")));
    }
    let language = compiled.mnemonics.values().next().copied().unwrap_or_default();
    let wanted = meaning(&compiled);

    let tree = stl::parse(FileId::default(), text, None).syntax().text().to_string();
    if tree != text {
        fail("the tree does not hold every character".to_owned());
    }
    match stl::format(text, Some(language)) {
        Ok(formatted) => {
            if stl::format(&formatted, Some(language)).as_deref() != Ok(formatted.as_str()) {
                fail(format!("formatting twice is another text than formatting once:\n{formatted}"));
            }
            let (_, again) = compile(case, &formatted, cpu, Some(language));
            if meaning(&again) != wanted {
                fail(format!("formatted it means something else: {:?}\n{formatted}", errors(&again.diagnostics, &formatted)));
            }
        }
        Err(diagnostics) => fail(format!("cannot be formatted: {:?}", errors(&diagnostics, text))),
    }
    let mut texts = vec![(language, text.to_owned())];
    match stl::convert(text, Some(language), language.other()) {
        Ok(other) => {
            let (_, again) = compile(case, &other, cpu, Some(language.other()));
            if meaning(&again) != wanted {
                fail(format!("converted it means something else: {:?}\n{other}", errors(&again.diagnostics, &other)));
            }
            if stl::convert(&other, Some(language.other()), language).as_deref() != Ok(text) {
                fail("converted there and back it is another text".to_owned());
            }
            texts.push((language.other(), other));
        }
        Err(diagnostics) => fail(format!("cannot be converted: {:?}", errors(&diagnostics, text))),
    }
    if !case.check.is_empty() {
        if !scenario.expects() {
            fail("its scenario expects nothing".to_owned());
        }
        for (language, text) in &texts {
            let program = Arc::new(compile(case, text, cpu, Some(*language)).1.program);
            for (engine, load) in program::ENGINES {
                let failed = scenario.run(&case.symbols, &mut || program::cpu(&program, cpu, *load, scenario.modules.clone()));
                for failure in failed {
                    fail(format!("[{language:?}, {engine}] line {} of the check: {}", failure.line, failure.message));
                }
            }
        }
    }
    compare(case, &summary(case, text, decoded.encoding, &sources, &compiled), failures);
}

/// The message, the line with a mark below the place, what to do.
fn shown(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let (line, column) = sources.line_column(diagnostic.span);
    let text = &sources.file(diagnostic.span.file).text;
    let source = text.lines().nth(line - 1).unwrap_or_default();
    let length = text[diagnostic.span.start as usize..diagnostic.span.end as usize].lines().next().unwrap_or_default().chars().count();
    let mut out = format!("{line}:{column} {} {}\n", diagnostic.problem.code(), diagnostic.message);
    let before: String = source.chars().take(column - 1).map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
    let _ = writeln!(out, "    | {source}\n    | {before}{}", "^".repeat(length.max(1)));
    if let Some(help) = &diagnostic.help {
        let _ = writeln!(out, "    help: {help}");
    }
    if let Some(fix) = &diagnostic.fix {
        let _ = writeln!(out, "    fix: {}", fix.title);
    }
    out
}

/// The line on which the mistake of a broken source stands: its text ends in `Line N.`
fn line_of_mistake(case: &Case) -> Option<usize> {
    case.why.rsplit_once("Line ")?.1.trim_end_matches('.').parse().ok()
}

#[test]
fn sources_of_the_wild_are_taken_and_mean_the_same_in_both_languages() {
    let cases = cases("legal");
    let mut failures = Vec::new();
    cases.iter().for_each(|case| legal(case, &mut failures));
    assert!(failures.is_empty(), "{} sources:\n\n{}", failures.len(), failures.join("\n\n"));
    assert!(cases.len() >= 45, "{} sources", cases.len());
    let running = cases.iter().filter(|case| !case.check.is_empty()).count();
    assert!(running * 2 > cases.len(), "{running} of {} run", cases.len());
}

#[test]
fn mistakes_of_real_life_are_answered_at_their_place_and_not_too_often() {
    let cases = cases("broken");
    let mut failures = Vec::new();
    for case in &cases {
        let decoded = encoding::read_source(&case.bytes).expect("the mistake is in the text, not in its bytes");
        let (sources, compiled) = compile(case, &decoded.text, &CpuType::ALL[0], None);
        let found: Vec<&Diagnostic> = compiled.diagnostics.iter().filter(|diagnostic| diagnostic.problem.code() != "P3013").collect();
        if found.is_empty() || found.len() > DIAGNOSTICS_MAX {
            failures.push(format!("{}: one mistake has {} diagnostics", case.name, found.len()));
        }
        match line_of_mistake(case) {
            None => failures.push(format!("{}: its text does not end in `Line N.`", case.name)),
            Some(line) if found.iter().any(|diagnostic| sources.line_column(diagnostic.span).0 == line) => {}
            Some(line) => failures.push(format!("{}: nothing is said about line {line}", case.name)),
        }
        let text: String = found.iter().map(|diagnostic| shown(diagnostic, &sources)).collect();
        compare(case, &text, &mut failures);
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
    assert!(cases.len() >= 20, "{} sources", cases.len());
}
