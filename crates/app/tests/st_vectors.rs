//! Runs spec/vectors/st.csv and st-traces.csv: what Structured Text means in each dialect, on every engine.

#[allow(dead_code)] // The pages need more of it.
mod program;

use std::collections::HashMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use sieben_cpu::{Cpu, OperatingMode, Restart};
use sieben_engine::Program;
use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Compiled, Options};
use sieben_model::address::Width;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Name;

/// One row, by column.
struct Row(HashMap<String, String>);

impl Row {
    fn get(&self, column: &str) -> &str {
        self.0.get(column).map_or("", |value| value.trim())
    }

    fn dialects(&self) -> impl Iterator<Item = Dialect> + '_ {
        self.get("dialects").split('|').map(|name| Dialect::from_name(name).unwrap_or_else(|| panic!("{name} is no dialect")))
    }
}

fn rows(file: &str) -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/vectors").join(file);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.deserialize().map(|row| Row(row.expect("a row of the vectors"))).collect()
}

/// A CPU with room for everything that a row declares.
fn cpu_type() -> &'static CpuType {
    CpuType::by_name("416-3").expect("a large CPU")
}

/// A program around declarations and statements; what is declared first lies at the begin of a data block.
fn source(dialect: Dialect, row: &Row, declarations: &str, code: &str, uses_ok: bool) -> String {
    let before = row.get("before");
    let declarations = if uses_ok { with_flag(declarations) } else { declarations.to_owned() };
    let flag = match (uses_ok, dialect) {
        (false, _) => "",
        (true, Dialect::Scl) => " eno_flag := OK;",
        (true, _) => " eno_flag := ENO;",
    };
    // Types of codesys and iec stand before the program; TYPE of the row is part of `before`.
    let (constants, declarations) = match declarations.split_once("CONSTANT ") {
        Some((front, constant)) => (constant.to_owned(), front.to_owned()),
        None => (String::new(), declarations),
    };
    let variables = if declarations.trim().is_empty() { String::new() } else { format!("VAR\n{declarations};\nEND_VAR\n") };
    let constants = match dialect {
        _ if constants.is_empty() => String::new(),
        Dialect::Scl => format!("CONST\n{};\nEND_CONST\n", constants.replace(": INT :=", ":=")),
        _ => format!("VAR CONSTANT\n{constants};\nEND_VAR\n"),
    };
    let label = if dialect == Dialect::Scl && code.contains("GOTO ") { "LABEL\nl1;\nEND_LABEL\n" } else { "" };
    match dialect {
        Dialect::Iec | Dialect::Codesys => format!("{before}\nPROGRAM prog\n{constants}{variables}{code}{flag}\nEND_PROGRAM\n"),
        _ => format!(
            "{before}\nFUNCTION_BLOCK FB100\n{constants}{label}{variables}BEGIN\n{code}{flag}\nEND_FUNCTION_BLOCK\n\
             DATA_BLOCK DB100 FB100\nBEGIN\nEND_DATA_BLOCK\n\
             ORGANIZATION_BLOCK OB1\nVAR_TEMP\nstart : ARRAY[1..20] OF BYTE;\nEND_VAR\nBEGIN\n{}\nEND_ORGANIZATION_BLOCK\n",
            if dialect == Dialect::Scl { "FB100.DB100();" } else { "DB100();" }
        ),
    }
}

/// The declarations with a flag for ENO behind the result.
fn with_flag(declarations: &str) -> String {
    let (first, rest) = declarations.split_once(';').unwrap_or((declarations, ""));
    format!("{first}; eno_flag : BOOL{}{rest}", if rest.is_empty() { "" } else { "; " })
}

fn compile(text: &str, dialect: Dialect) -> (Compiled, Sources) {
    let mut sources = Sources::default();
    sources.add("vector.st", text);
    let system_blocks = sieben_cpu::system::interfaces();
    let options = Options { cpu: Some(cpu_type()), dialect: Some(dialect), system_blocks, ..Options::default() };
    (sieben_lang::compile(&sources, &SymbolTable::default(), &options), sources)
}

fn messages(compiled: &Compiled, sources: &Sources, of: Severity) -> Vec<String> {
    let found = compiled.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == of);
    found
        .map(|diagnostic| {
            let (line, column) = sources.line_column(diagnostic.span);
            format!("{}:{line}:{column}: {}", diagnostic.problem.code(), diagnostic.message)
        })
        .collect()
}

/// The data block that begins with a variable of this name.
fn data_block(program: &Program, name: &str) -> Option<u16> {
    let first = |number: &&u16| program.data[*number].structure.fields.first().is_some_and(|field| field.name.eq_ignore_ascii_case(name));
    program.data.keys().find(first).copied()
}

/// The result as text in the form of the column `expected`.
fn shown(cpu: &Cpu, block: u16, data_type: &str) -> String {
    let memory = &cpu.machine().memory;
    let Some(entry) = memory.data_block(u64::from(block)) else { return format!("DB {block} does not exist") };
    let byte = |index: usize| memory.read_at(entry.base as usize + index, 0, Width::Byte) as u8;
    let number = |bytes: usize| (0..bytes).fold(0_u64, |number, index| number << 8 | u64::from(byte(index)));
    match data_type {
        "BOOL" => if byte(0) & 1 != 0 { "TRUE" } else { "FALSE" }.to_owned(),
        "SINT" => (byte(0) as i8).to_string(),
        "USINT" | "BYTE" => number(1).to_string(),
        "INT" => (number(2) as i16).to_string(),
        "UINT" | "WORD" | "S5TIME" => number(2).to_string(),
        "DINT" => (number(4) as i32).to_string(),
        "UDINT" | "DWORD" | "TOD" => number(4).to_string(),
        "TIME" => (number(4) as i32).to_string(),
        "REAL" => format!("{:?}", f32::from_bits(number(4) as u32)),
        "DT" => number(8).to_string(),
        "CHAR" => format!("'{}'", char::from(byte(0))),
        text if text.starts_with("STRING") => {
            let characters = (0..usize::from(byte(1))).map(|index| char::from(byte(index + 2))).collect::<String>();
            format!("'{characters}'")
        }
        other => panic!("{other} has no form"),
    }
}

/// Bytes in front of the flag for ENO.
fn flag_place(data_type: &str) -> (usize, u8) {
    match data_type {
        "BOOL" => (0, 1),
        "SINT" | "USINT" | "BYTE" | "CHAR" => (1, 0),
        "INT" | "UINT" | "WORD" => (2, 0),
        "DINT" | "UDINT" | "DWORD" | "REAL" | "TIME" => (4, 0),
        "STRING" => (256, 0),
        other => panic!("{other} has no flag behind it"),
    }
}

fn is_expected(got: &str, expected: &str, data_type: &str, dialect: Dialect) -> bool {
    let plain = expected.replace('_', "");
    match data_type {
        "REAL" => match (got.parse::<f32>(), plain.trim_start_matches('+').replace("Inf", "inf").parse::<f32>()) {
            // The last place of functions may differ.
            (Ok(got), Ok(expected)) => {
                got == expected || got.is_finite() && expected.is_finite() && (got - expected).abs() <= f32::EPSILON * expected.abs()
            }
            _ => false,
        },
        "BOOL" => got == plain,
        "CHAR" => got == expected,
        text if text.starts_with("STRING") => got == expected,
        // Without a sign where the dialect has none.
        "TIME" if dialect == Dialect::Codesys => got.parse::<i64>().map(|ms| i64::from(ms as u32)).ok() == plain.parse().ok(),
        _ => {
            let expected = match plain.strip_prefix("16#") {
                Some(digits) => i128::from_str_radix(digits, 16).ok(),
                None => plain.parse().ok(),
            };
            got.parse::<i128>().ok() == expected && expected.is_some()
        }
    }
}

/// What is wrong with a row in a dialect.
fn run(row: &Row, dialect: Dialect) -> Vec<String> {
    let uses_ok = !row.get("eno").is_empty();
    let text = source(dialect, row, row.get("declarations"), row.get("code"), uses_ok);
    let (compiled, sources) = compile(&text, dialect);
    let errors = messages(&compiled, &sources, Severity::Error);
    match row.get("kind") {
        "reject" if errors.is_empty() => return vec!["is accepted".to_owned()],
        "reject" => return Vec::new(),
        "note" if errors.is_empty() && messages(&compiled, &sources, Severity::Warning).is_empty() => {
            return vec!["without a warning".to_owned()];
        }
        "accept" | "note" | "value" if !errors.is_empty() => return errors,
        "accept" | "note" => return Vec::new(),
        _ => {}
    }
    let result = row.get("declarations").split(':').next().unwrap_or_default().trim();
    let program = Arc::new(compiled.program);
    let Some(block) = data_block(&program, result) else { return vec![format!("no data block begins with `{result}`")] };
    let mut out = Vec::new();
    for (engine, load) in program::ENGINES {
        let mut cpu = program::cpu(&program, cpu_type(), *load, None);
        cpu.restart(Restart::Warm);
        cpu.scan(0);
        if cpu.mode() != OperatingMode::Run {
            let cause = cpu.stop_cause().map_or_else(|| "the CPU does not run".to_owned(), |cause| cause.text.clone());
            out.push(format!("[{engine}] STOP: {cause}"));
            continue;
        }
        let got = shown(&cpu, block, row.get("type"));
        if !is_expected(&got, row.get("expected"), row.get("type"), dialect) {
            out.push(format!("[{engine}] {got}, not {}", row.get("expected")));
        }
        if uses_ok {
            let (at, bit) = flag_place(row.get("type"));
            let base = cpu.machine().memory.data_block(u64::from(block)).map_or(0, |entry| entry.base as usize);
            let flag = if cpu.machine().memory.read_at(base + at, bit, Width::Bit) != 0 { "TRUE" } else { "FALSE" };
            if flag != row.get("eno") {
                out.push(format!("[{engine}] ENO is {flag}, not {}", row.get("eno")));
            }
        }
    }
    out
}

/// The name that a dialect has for an input of the traces.
fn input(name: &str, block: &str, dialect: Dialect) -> &'static str {
    match (dialect, block, name) {
        (Dialect::Codesys, "SR", "S1") => "SET1",
        (Dialect::Codesys, "SR" | "CTU" | "CTUD", "R") => "RESET",
        (Dialect::Codesys, "RS", "S") => "SET",
        (Dialect::Codesys, "RS", "R1") => "RESET1",
        (Dialect::Codesys | Dialect::Scl, "CTD" | "CTUD", "LD") => "LOAD",
        _ => ["IN", "PT", "CU", "CD", "R", "LD", "PV", "CLK", "S1", "R1", "S", "LOAD", "CV"]
            .into_iter()
            .find(|one| *one == name)
            .unwrap_or_else(|| panic!("{name} is no input")),
    }
}

fn trace(row: &Row, dialect: Dialect) -> Vec<String> {
    let block = row.get("block");
    let text = source(dialect, row, &format!("f : {block}"), "f();", false);
    let (compiled, sources) = compile(&text, dialect);
    let errors = messages(&compiled, &sources, Severity::Error);
    if !errors.is_empty() {
        return errors;
    }
    let program = Arc::new(compiled.program);
    let Some(number) = data_block(&program, "f") else { return vec!["no data block begins with `f`".to_owned()] };
    let name_of = |name: &str| Name::parse(&format!("DB{number}.f.{name}"), &SymbolTable::default(), &program);
    let mut out = Vec::new();
    for (engine, load) in program::ENGINES {
        let mut cpu = program::cpu(&program, cpu_type(), *load, None);
        cpu.restart(Restart::Warm);
        let outputs: Vec<&str> = row.get("outputs").split('|').collect();
        let steps: Vec<&str> = row.get("inputs").split('|').collect();
        assert_eq!(steps.len(), outputs.len(), "{}: a result for every step", row.get("id"));
        for (before, after) in steps.into_iter().zip(outputs) {
            let (ms, inputs) = before.split_once(':').expect("a time");
            let ms: u64 = ms.trim().parse().expect("milliseconds");
            for (name, value) in inputs.split(';').filter_map(|pair| pair.trim().split_once('=')) {
                let value = if name == "PT" { format!("T#{value}MS") } else { value.to_owned() };
                let written = name_of(input(name, block, dialect)).and_then(|name| name.write(&mut cpu, &value));
                out.extend(written.err().map(|error| format!("[{engine}] {name}: {error}")));
            }
            cpu.scan(ms * 1000);
            for (name, value) in after.split(';').filter_map(|pair| pair.trim().split_once('=')) {
                let value = if name == "ET" { format!("T#{value}MS") } else { value.to_owned() };
                match name_of(name).and_then(|parsed| Ok((parsed.holds(&cpu, &value)?, parsed.read(&cpu)?))) {
                    Ok((true, _)) => {}
                    Ok((false, got)) => out.push(format!("[{engine}] at {ms} ms: {name} is {got}, not {value}")),
                    Err(error) => out.push(format!("[{engine}] {name}: {error}")),
                }
            }
        }
    }
    out
}

fn report(rows: &[Row], run: impl Fn(&Row, Dialect) -> Vec<String>) -> (usize, Vec<String>) {
    let only = std::env::var("ST_VECTOR").ok();
    let mut count = 0;
    let mut report = Vec::new();
    for row in rows.iter().filter(|row| only.as_deref().is_none_or(|id| id.split(',').any(|id| id == row.get("id")))) {
        for dialect in row.dialects() {
            count += 1;
            let wrong = run(row, dialect);
            if !wrong.is_empty() {
                let code = format!("{} {} | {}", row.get("declarations"), row.get("case"), row.get("code"));
                report.push(format!("{} {}: {}\n    {code}", row.get("id"), dialect.name(), wrong.join("\n    ")));
            }
        }
    }
    (count, report)
}

#[test]
fn every_vector_of_structured_text_comes_true() {
    let (count, report) = report(&rows("st.csv"), run);
    assert!(report.is_empty(), "{} of {count} vectors do not come true:\n{}", report.len(), report.join("\n"));
}

#[test]
fn every_trace_of_a_timer_or_counter_comes_true() {
    let (count, report) = report(&rows("st-traces.csv"), trace);
    assert!(report.is_empty(), "{} of {count} traces do not come true:\n{}", report.len(), report.join("\n"));
}
