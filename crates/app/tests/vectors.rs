//! Runs spec/vectors/vectors.csv: a state, some STL, the state after it; in both mnemonic languages, on every engine.
//! And the rows of the table of diagrams that say what a diagram does, drawn and as the statements beside it.

#[path = "../../lang/tests/diagrams/blocks.rs"]
mod blocks;
mod program;

use std::fs;
use std::path::Path;
use std::sync::Arc;

use blocks::blocks_of;
use sieben_cpu::{Cpu, OperatingMode, Restart};
use sieben_engine::{Machine, Program, StatementEvent, Tracer};
use sieben_lang::reason::{Language, Moment, Reasons};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Name;

/// One row, by column.
struct Row(std::collections::HashMap<String, String>);

impl Row {
    fn get(&self, column: &str) -> &str {
        self.0.get(column).map_or("", |value| value.trim())
    }
}

/// Column and name of everything that is given before and checked after.
const REGISTERS: &[(&str, &str)] =
    &[("accu1", "ACCU1"), ("accu2", "ACCU2"), ("accu3", "ACCU3"), ("accu4", "ACCU4"), ("ar1", "AR1"), ("ar2", "AR2"), ("stw", "STW")];

fn rows() -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/vectors/vectors.csv");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.deserialize().map(|row| Row(row.expect("a row of the vectors"))).collect()
}

/// What is wrong with a row: the state after it differs, or it does not compile.
fn run(row: &Row) -> Vec<String> {
    let cpu_type = match row.get("accus") {
        "4" => CpuType::by_name("416-3").expect("a CPU type with four accumulators"),
        _ => &CpuType::ALL[0],
    };
    let Some((_, note)) = row.get("note").split_once("sync error 16#") else { return run_source(row, &source(row), cpu_type, None) };
    // The state after it is that with OB 121; without it the CPU stops.
    let event = note.get(..4).and_then(|digits| u16::from_str_radix(digits, 16).ok());
    let body = source(row);
    let handled = format!(
        "ORGANIZATION_BLOCK OB 121\nBEGIN\nNOP 0;\nEND_ORGANIZATION_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n{body}END_ORGANIZATION_BLOCK\n"
    );
    let mut out = run_source(row, &handled, cpu_type, None);
    out.extend(run_source(row, &body, cpu_type, event));
    out
}

/// Runs one form of a row; `stop` is the first cause of the STOP that it must end in.
fn run_source(row: &Row, source: &str, cpu_type: &'static CpuType, stop: Option<u16>) -> Vec<String> {
    let languages = match program::both_languages(source) {
        Ok(languages) => languages,
        Err(message) => return vec![message],
    };
    let mut out = Vec::new();
    for (language, mnemonics, text) in &languages {
        let program = match program::compile(text, *mnemonics, cpu_type) {
            Ok(compiled) => Arc::new(compiled.program),
            Err(message) => {
                out.push(format!("[{language}] {message}"));
                continue;
            }
        };
        for (engine, load) in program::ENGINES {
            let mut cpu = program::cpu(&program, cpu_type, *load, None);
            cpu.restart(Restart::Warm);
            let wrong = match row.get("group") {
                "timer-trace" => trace(row, &mut cpu, &program),
                "iec-trace" => iec_trace(row, &mut cpu, &program),
                _ => once(row, &mut cpu, &program, stop),
            };
            out.extend(wrong.into_iter().map(|message| format!("[{language}, {engine}] {message}")));
        }
    }
    out
}

/// The blocks of the note and the code as OB 1; the program that a trace describes.
fn source(row: &Row) -> String {
    let code = row.get("code");
    if row.get("group") == "timer-trace" {
        let start =
            ["SP", "SE", "SD", "SS", "SF"].into_iter().find(|start| code.contains(&format!("{start} T 1"))).expect("a start instruction");
        let time = code.split("L W#16#").nth(1).and_then(|rest| rest.get(..4)).expect("a time");
        return format!(
            "A I 0.2;\nFR T 1;\nA I 0.0;\nL W#16#{time};\n{start} T 1;\nA I 0.1;\nR T 1;\nA T 1;\n= Q 0.0;\nL T 1;\nT MW 10;\n"
        );
    }
    if let Some((sfb, _)) = code.strip_prefix("CALL SFB ").and_then(|rest| rest.split_once(' ')) {
        return format!(
            "DATA_BLOCK DB 1 SFB {sfb}\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nCALL SFB {sfb}, DB 1;\nEND_ORGANIZATION_BLOCK\n"
        );
    }
    let mut body = code.replace("; ", ";\n");
    if code.contains("JU ZZZZ") && !code.contains("ZZZZ:") {
        body.push_str(";\nZZZZ: NOP 0");
    }
    match row.get("note").strip_prefix("with ").and_then(|note| note.split_once(" ::")) {
        Some((blocks, _)) => format!("{blocks}\nORGANIZATION_BLOCK OB 1\nBEGIN\n{body};\nEND_ORGANIZATION_BLOCK\n"),
        None => format!("{body};\n"),
    }
}

/// `MB10=09 IB0=01` as names and values.
fn memory(text: &str) -> impl Iterator<Item = (String, String)> + '_ {
    text.split_whitespace().filter_map(|pair| pair.split_once('=')).map(|(name, hex)| (name.to_owned(), format!("16#{hex}")))
}

/// One scan from the state before to the state after.
fn once(row: &Row, cpu: &mut Cpu, program: &Program, stop: Option<u16>) -> Vec<String> {
    let given = REGISTERS.iter().map(|&(column, name)| (name.to_owned(), row.get(&format!("in_{column}")).to_owned()));
    for (name, value) in given.filter(|(_, value)| !value.is_empty()).chain(memory(row.get("in_mem"))) {
        if let Err(error) = name_of(&name, program).write(cpu, &value) {
            return vec![error.to_string()];
        }
    }
    cpu.scan(0);
    let event = row.get("out_mem").strip_prefix("event 16#").and_then(|event| event.get(..4));
    let expected = stop.or_else(|| event.and_then(|digits| u16::from_str_radix(digits, 16).ok()));
    if expected.is_some() {
        let got = cpu.stop_cause().map(|cause| cause.first_event);
        return if got == expected { Vec::new() } else { vec![format!("expected STOP with {expected:04X?}, got {got:04X?}")] };
    }
    if cpu.mode() != OperatingMode::Run {
        return vec![cpu.stop_cause().map_or_else(|| "the CPU does not run".to_owned(), |cause| cause.text.clone())];
    }
    let checked = REGISTERS.iter().map(|&(column, name)| (name.to_owned(), row.get(&format!("out_{column}")).to_owned()));
    checked
        .filter(|(_, value)| !value.is_empty())
        .chain(memory(row.get("out_mem")))
        .filter_map(|(name, value)| differs(&name, &value, cpu, program))
        .collect()
}

/// Scans at the times of the trace.
fn trace(row: &Row, cpu: &mut Cpu, program: &Program) -> Vec<String> {
    let mut out = Vec::new();
    for (before, after) in row.get("in_mem").split('|').zip(row.get("out_mem").split('|')) {
        let mut words = before.split_whitespace();
        let ms: u64 = words.next().and_then(|time| time.strip_suffix("ms")).and_then(|time| time.parse().ok()).expect("a time");
        for (name, value) in words.filter_map(|word| word.split_once('=')) {
            let input = match name {
                "S" => "I 0.0",
                "R" => "I 0.1",
                _ => "I 0.2",
            };
            out.extend(name_of(input, program).write(cpu, value).err().map(|error| error.to_string()));
        }
        cpu.scan(ms * 1000);
        for (name, value) in after.split_whitespace().filter_map(|word| word.split_once('=')) {
            let place = if name == "Q" { "Q 0.0" } else { "MW 10" };
            out.extend(differs(place, value, cpu, program).map(|message| format!("at {ms}ms {name}: {message}")));
        }
    }
    out
}

/// Scans with the inputs written to the instance, DB 1. A trace of a timer begins each step with a time, one of a counter has the
/// inputs for all steps in front and a scan every 10 ms.
fn iec_trace(row: &Row, cpu: &mut Cpu, program: &Program) -> Vec<String> {
    let mut out = Vec::new();
    let in_instance = |name: &str| name_of(&format!("DB1.{name}"), program);
    let mut steps: Vec<&str> = row.get("in_mem").split('|').map(str::trim).collect();
    let results: Vec<&str> = row.get("out_mem").split('|').collect();
    if steps.len() == results.len() + 1 {
        let (name, value) = steps.remove(0).split_once('=').expect("an input for all steps");
        out.extend(in_instance(name).write(cpu, value).err().map(|error| error.to_string()));
    }
    assert_eq!(steps.len(), results.len(), "{}: a result for every step", row.get("id"));
    for (index, (before, after)) in steps.into_iter().zip(results).enumerate() {
        let mut ms = index as u64 * 10;
        for word in before.split_whitespace() {
            let Some((name, value)) = word.split_once('=') else {
                ms = word.strip_suffix("ms").and_then(|time| time.parse().ok()).expect("a time");
                continue;
            };
            let value = match value.strip_suffix("ms") {
                Some(time) if time.starts_with('-') => format!("T#-{}MS", &time[1..]),
                Some(time) => format!("T#{time}MS"),
                None => value.to_owned(),
            };
            out.extend(in_instance(name).write(cpu, &value).err().map(|error| error.to_string()));
        }
        cpu.scan(ms * 1000);
        for (name, value) in after.split_whitespace().filter_map(|word| word.split_once('=')) {
            let value = if name == "ET" { format!("T#{value}MS") } else { value.to_owned() };
            out.extend(differs(&format!("DB1.{name}"), &value, cpu, program).map(|message| format!("at {ms}ms: {message}")));
        }
    }
    out
}

fn name_of(name: &str, program: &Program) -> Name {
    Name::parse(name, &SymbolTable::default(), program).unwrap_or_else(|error| panic!("{error}"))
}

fn differs(name: &str, expected: &str, cpu: &Cpu, program: &Program) -> Option<String> {
    let parsed = name_of(name, program);
    match parsed.holds(cpu, expected) {
        Ok(true) => None,
        Ok(false) => {
            let got = parsed.read(cpu).map_or_else(|error| error.to_string(), |shown| shown.to_string());
            Some(format!("expected {name} = {expected}, got {got}"))
        }
        Err(error) => Some(error.to_string()),
    }
}

#[test]
fn every_vector_comes_true() {
    let mut report = Vec::new();
    let rows = rows();
    assert!(rows.len() > 600, "{} rows", rows.len());
    for row in &rows {
        let wrong = run(row);
        if !wrong.is_empty() {
            report.push(format!(
                "{} ({}, {}): {}\n    {}",
                row.get("id"),
                row.get("group"),
                row.get("source"),
                wrong.join("\n    "),
                row.get("code")
            ));
        }
    }
    assert!(report.is_empty(), "{} vectors do not come true:\n{}", report.len(), report.join("\n"));
}

/// Looks at the reason of every statement, without and with the machine before it.
struct Judge<'a> {
    reasons: Reasons<'a>,
    /// Whether the machine is kept from one statement to the next: it is large, and only timers and counters need it.
    keeps: bool,
    before: Option<Machine>,
    statements: usize,
    wrong: Vec<String>,
}

impl Tracer for Judge<'_> {
    fn statement(&mut self, machine: &Machine, event: &StatementEvent) {
        for before in std::iter::once(None).chain(self.before.as_ref().map(Some)) {
            let moment = Moment { event, before, after: machine, fault: None };
            let [english, german] = Language::ALL.map(|language| self.reasons.sentence(&moment, language));
            for text in [&english, &german] {
                if text.is_empty() || text.contains(['{', '}']) {
                    self.wrong.push(format!("`{}`: {text:?}", self.reasons.statement(event.place)));
                }
            }
            let lies = untrue(&english, ["the RLO was ", "RLO becomes ", "RLO stays "], event, machine)
                .or_else(|| untrue(&german, ["das VKE war ", "wird das VKE ", "bleibt das VKE "], event, machine));
            if let Some(lie) = lies {
                let status = (event.before.status(), event.after.status());
                self.wrong.push(format!("`{}` {status:?}: {lie}: {english}", self.reasons.statement(event.place)));
            }
        }
        self.statements += 1;
        self.before = self.keeps.then(|| machine.clone());
    }
}

/// The number behind some words of a sentence.
fn said(text: &str, words: &str) -> Option<i64> {
    let behind = text.split_once(words)?.1;
    let end = behind.char_indices().find(|(at, c)| !(c.is_ascii_digit() || *at == 0 && *c == '-')).map_or(behind.len(), |(at, _)| at);
    behind[..end].parse().ok()
}

/// What a sentence says that is not so.
fn untrue(text: &str, [was, becomes, stays]: [&str; 3], event: &StatementEvent, machine: &Machine) -> Option<String> {
    let (before, after) = (&event.before, &event.after);
    // A failed statement has called OB 121, which has registers of its own.
    if event.place.block.number != 121 && machine.frames.last().is_some_and(|frame| frame.block.number == 121) {
        return None;
    }
    let number = |value: u64| i64::try_from(value).expect("a bit");
    if said(text, was).is_some_and(|rlo| rlo != number(before.rlo)) {
        return Some(format!("the RLO before was {}", before.rlo));
    }
    if said(text, becomes).is_some_and(|rlo| rlo != number(after.rlo)) {
        return Some(format!("the RLO is {}", after.rlo));
    }
    if said(text, stays).is_some_and(|rlo| rlo != number(after.rlo) || after.rlo != before.rlo) {
        return Some(format!("the RLO went from {} to {}", before.rlo, after.rlo));
    }
    if text.contains("OV and OS become 1") && (after.ov, after.os) != (1, 1) {
        return Some("OV and OS are not both 1".to_owned());
    }
    if text.contains("so CC 1 is 1 and CC 0 is 0") && (after.cc1, after.cc0) != (1, 0) {
        return Some("CC 1 and CC 0 are not 1 and 0".to_owned());
    }
    if let Some((_, rest)) = text.split_once(", so ")
        && let Some((name, rest)) = rest.split_once(" becomes ")
        && let Some(operand) = sieben_model::address::Operand::parse(name)
        && let Some(bits) = machine.memory.read(&operand)
        && !rest.starts_with(&bits.to_string())
    {
        return Some(format!("{name} is {bits}"));
    }
    None
}

#[test]
fn the_reasons_of_all_statements_of_the_vectors_are_true() {
    let mut wrong = Vec::new();
    let mut statements = 0;
    for row in &rows() {
        let body = source(row);
        let text = match row.get("note").contains("sync error 16#") {
            true => format!(
                "ORGANIZATION_BLOCK OB 121\nBEGIN\nNOP 0;\nEND_ORGANIZATION_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n{body}END_ORGANIZATION_BLOCK\n"
            ),
            false => body,
        };
        let cpu_type = if row.get("accus") == "4" { CpuType::by_name("416-3").expect("a CPU type") } else { &CpuType::ALL[0] };
        let compiled = program::compile(&text, Mnemonics::English, cpu_type).unwrap_or_else(|message| panic!("{message}"));
        let mut sources = Sources::default();
        sources.add("page.awl", text);
        compiled.add_library_sources(&mut sources);
        let symbols = SymbolTable::default();
        let loaded = Arc::new(compiled.program.clone());
        let mut cpu = program::cpu(&loaded, cpu_type, program::ENGINES[0].1, None);
        cpu.restart(Restart::Warm);
        let given = REGISTERS.iter().map(|&(column, name)| (name.to_owned(), row.get(&format!("in_{column}")).to_owned()));
        for (name, value) in given.filter(|(_, value)| !value.is_empty()).chain(memory(row.get("in_mem"))) {
            // The traces have times and names of their own: they run from a cleared state here.
            if let Ok(name) = Name::parse(&name, &symbols, &loaded) {
                let _ = name.write(&mut cpu, &value);
            }
        }
        let keeps = ["timer", "counter"].iter().any(|group| row.get("group").contains(group));
        let reasons = Reasons::new(&compiled, &sources, &symbols);
        let mut judge = Judge { reasons, keeps, before: None, statements: 0, wrong: Vec::new() };
        cpu.scan_traced(0, &mut judge);
        cpu.scan_traced(10_000, &mut judge);
        statements += judge.statements;
        wrong.extend(judge.wrong.into_iter().map(|message| format!("{}: {message}", row.get("id"))));
    }
    assert!(statements > 2_000, "{statements} statements");
    wrong.truncate(40);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A source of blocks whose networks are lines of a diagram or rows of statements.
fn source_of(blocks: &[(String, Vec<String>)], others: &[(String, Vec<String>)], language: &str) -> String {
    let mut out = String::new();
    let more = others.iter().filter(|(name, _)| !blocks.iter().any(|(own, _)| own == name)).map(|block| (block, ""));
    for ((name, networks), language) in blocks.iter().map(|block| (block, language)).chain(more) {
        let (kind, head) = match name.as_str() {
            "OB1" => ("ORGANIZATION_BLOCK", "ORGANIZATION_BLOCK OB 1\n".to_owned()),
            _ => {
                let uses = networks.iter().any(|network| network.contains("#IN"));
                let input = if uses { "VAR_INPUT\nIN : BOOL;\nEND_VAR\n" } else { "" };
                ("FUNCTION", format!("FUNCTION FC 1 : VOID\n{input}"))
            }
        };
        let body = networks.iter().map(|network| match language {
            "" => format!("NETWORK\n{};\n", network.replace("(; ", "(;\n").replace("; ", ";\n")),
            drawing => format!("NETWORK {drawing}\n{network}\n"),
        });
        out = format!("{head}BEGIN\n{}END_{kind}\n{out}", body.collect::<String>());
    }
    out
}

/// Scans at the times of a row, and its values after each of them.
fn run_diagram(cpu: &mut Cpu, program: &Program, times: &str, values: &str) -> Vec<String> {
    let mut out = Vec::new();
    let steps: Vec<(u64, &str)> = times
        .split(';')
        .filter_map(|step| step.trim().split_once("ms:"))
        .map(|(ms, inputs)| (ms.parse().expect("a time"), inputs))
        .collect();
    for (index, (ms, inputs)) in steps.iter().enumerate() {
        for (name, value) in inputs.split_whitespace().filter_map(|pair| pair.split_once('=')) {
            out.extend(name_of(name, program).write(cpu, value).err().map(|error| error.to_string()));
        }
        cpu.scan(ms * 1000);
        for (name, expected) in values.split(", ").filter_map(|value| value.split_once(" = ")) {
            let expected: Vec<&str> = expected.split_whitespace().collect();
            // One value for all scans, one for each, or those of the last ones.
            let skipped = if expected.len() == 1 { 0 } else { steps.len().saturating_sub(expected.len()) };
            if let Some(value) = index.checked_sub(skipped).and_then(|at| expected.get(if expected.len() == 1 { 0 } else { at })) {
                out.extend(differs(name, value, cpu, program).map(|message| format!("at {ms}ms: {message}")));
            }
        }
    }
    out
}

#[test]
fn diagrams_do_what_their_table_says_as_the_statements_beside_them_do() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../lang/tests/diagrams/vectors.csv");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let rows: Vec<Row> = csv::Reader::from_reader(text.as_bytes()).deserialize().map(|row| Row(row.expect("a row"))).collect();
    let cpu_type = &CpuType::ALL[0];
    let (mut ran, mut wrong) = (0, Vec::new());
    for row in rows.iter().filter(|row| row.get("kind").ends_with("-meaning")) {
        let drawing = if row.get("kind").starts_with("lad") { "LAD" } else { "FBD" };
        let (diagrams, times) = row.get("input").split_once(" || ").expect("a diagram and its times");
        let expected = row.get("expected").strip_prefix("STL: ").expect("statements");
        let (statements, values) = expected.split_once(" || ").expect("statements and values");
        let (diagrams, statements) = (blocks_of(diagrams), blocks_of(statements));
        let sources = [("drawn", source_of(&diagrams, &statements, drawing)), ("as STL", source_of(&statements, &[], ""))];
        for (form, source) in &sources {
            let program = match program::compile(source, Mnemonics::English, cpu_type) {
                Ok(compiled) => Arc::new(compiled.program),
                Err(message) => {
                    wrong.push(format!("{} {form}: {message}\n{source}", row.get("id")));
                    continue;
                }
            };
            for (engine, load) in program::ENGINES {
                let mut cpu = program::cpu(&program, cpu_type, *load, None);
                cpu.restart(Restart::Warm);
                let found = run_diagram(&mut cpu, &program, times, values);
                ran += 1;
                wrong.extend(found.into_iter().map(|message| format!("{} {form} [{engine}] {message}\n{source}", row.get("id"))));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(ran > 200, "{ran} runs");
}
