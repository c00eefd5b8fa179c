//! How fast sources are compiled and how fast the interpreter runs: `cargo bench -p sieben-app --bench speed`.
//!
//! Prints the best of several repetitions, because other work on the machine only ever adds time.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

#[path = "speed/plant.rs"]
mod plant;

use std::fmt::Write as _;
use std::sync::Arc;
use std::time::Instant;

use sieben_cpu::{Cpu, Rack, Restart, Settings};
use sieben_engine::{Interpreter, Layout, Machine, StatementEvent, Tracer};
use sieben_jit::{StatusBits, Tier, Tiers};
use sieben_lang::st::{self, Dialect};
use sieben_lang::{Options, compile};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

const REPETITIONS: usize = 15;
const SCANS: u64 = 300;
const CYCLE_US: u64 = 10_000;
const READY_REPETITIONS: usize = 5;

/// Bit logic over random addresses, the same on every run.
fn bit_logic(statements: usize) -> String {
    let mut state = 12_345_u32;
    let mut random = |below: u32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) % below
    };
    let mut text = String::new();
    for network in 0..statements / 4 {
        let mut scan = |word: &str, area: &str| {
            let _ = writeln!(text, "      {word:<5} {area} {}.{};", random(64), random(8));
        };
        scan("A", "I");
        scan("AN", "M");
        scan("O", "I");
        let _ = writeln!(text, "      =     Q {}.{};", network / 8 % 64, network % 8);
    }
    text
}

/// Counts executed statements.
#[derive(Default)]
struct Count(u64);

impl Tracer for Count {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {
        self.0 += 1;
    }
}

fn load(text: &str) -> Cpu {
    let cpu_type = &CpuType::ALL[0];
    let mut sources = Sources::default();
    sources.add("bench.awl", text);
    let options = Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let compiled = compile(&sources, &SymbolTable::default(), &options);
    let errors: Vec<_> = compiled.diagnostics.iter().map(|diagnostic| &diagnostic.message).collect();
    assert!(compiled.diagnostics.iter().all(|diagnostic| diagnostic.severity() < sieben_model::diagnostic::Severity::Error), "{errors:?}");
    let program = Arc::new(compiled.program);
    let mut cpu = Cpu::load(cpu_type, program, Interpreter::load, Rack::simulated(cpu_type), Settings::default());
    cpu.restart(Restart::Warm);
    cpu
}

fn run(name: &str, text: &str) {
    let mut cpu = load(text);
    let mut now = 0;
    let mut count = Count::default();
    cpu.scan_traced(now, &mut count);
    let mut best = f64::INFINITY;
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        for _ in 0..SCANS {
            now += CYCLE_US;
            cpu.scan(now);
        }
        best = best.min(start.elapsed().as_nanos() as f64 / SCANS as f64);
    }
    assert!(cpu.stop_cause().is_none(), "{name} keeps running: {:?}", cpu.stop_cause());
    println!("{name:<28} {:>6} statements a scan {best:>10.0} ns a scan {:>7.2} ns a statement", count.0, best / count.0 as f64);
}

fn compile_speed(statements: usize) {
    let text = bit_logic(statements);
    let mut best = f64::INFINITY;
    for _ in 0..5 {
        let mut sources = Sources::default();
        sources.add("bench.awl", text.as_str());
        let start = Instant::now();
        let compiled = compile(&sources, &SymbolTable::default(), &Options::default());
        best = best.min(start.elapsed().as_secs_f64());
        assert!(!compiled.program.code.is_empty());
    }
    println!(
        "parse, check and lower {statements} statements: {:.1} ms ({:.0} ns a statement, {:.1} MB/s)",
        best * 1e3,
        best * 1e9 / statements as f64,
        text.len() as f64 / best / 1e6
    );
}

/// From the text of a plant in Structured Text to its first scan, in parts: what somebody waits for who changed a line.
fn ready(lines: usize) {
    let text = plant::source(lines);
    let bytes = text.as_bytes();
    let cpu_type = &CpuType::ALL[0];
    let options = Options { system_blocks: sieben_cpu::system::interfaces(), dialect: Some(Dialect::Iec), ..Options::default() };
    let mut best = [f64::INFINITY; 6];
    for _ in 0..READY_REPETITIONS {
        let begin = Instant::now();
        let read = sieben_lang::encoding::read_source(bytes).expect("the plant is a text");
        let mut sources = Sources::default();
        sources.add("plant.st", read.text);
        let after_reading = Instant::now();
        let compiled = compile(&sources, &SymbolTable::default(), &options);
        let after_compiling = Instant::now();
        let errors = compiled.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error);
        let errors: Vec<&String> = errors.map(|diagnostic| &diagnostic.message).collect();
        assert!(errors.is_empty(), "{errors:?}");
        let before_loading = Instant::now();
        let program = Arc::new(compiled.program);
        let mut cpu = Cpu::load(cpu_type, Arc::clone(&program), Interpreter::load, Rack::simulated(cpu_type), Settings::default());
        cpu.restart(Restart::Warm);
        let after_loading = Instant::now();
        cpu.scan(0);
        let end = Instant::now();
        assert!(cpu.stop_cause().is_none(), "the plant keeps running: {:?}", cpu.stop_cause());
        // Parsing is part of compiling; machine code is made beside the first scans.
        let parsing = Instant::now();
        let parsed = st::parse(FileId::default(), &text, Dialect::Iec);
        let parsing = parsing.elapsed();
        assert!(parsed.diagnostics.is_empty());
        let layout = Layout::new(cpu_type, &program);
        let tiers = Tiers::load(&program, &layout, StatusBits::All);
        let code = Instant::now();
        tiers.compile(Tier::Quick).expect("the plant becomes machine code");
        let parts = [
            after_reading - begin,
            parsing,
            (after_compiling - after_reading).saturating_sub(parsing),
            after_loading - before_loading,
            end - after_loading,
            code.elapsed(),
        ];
        for (best, part) in best.iter_mut().zip(parts) {
            *best = best.min(part.as_secs_f64() * 1e3);
        }
    }
    let [reading, parsing, checking, loading, scan, code] = best;
    println!(
        "{} lines of ST: ready and through the first scan in {:.1} ms (read {reading:.1}, parse {parsing:.1}, check and lower {checking:.1}, \
         load {loading:.1}, first scan {scan:.1}); first machine code {code:.0} ms more, beside the scans",
        text.lines().count(),
        reading + parsing + checking + loading + scan
    );
}

/// What it costs to hand out the retentive data of a program with `blocks` data blocks of 8 KB, when nothing, one double word or all of it changes.
fn retentive(blocks: usize) {
    let changes: [(&str, &dyn Fn(usize) -> String); 3] = [
        ("nothing changes", &|_| String::new()),
        ("one double word changes", &|number| {
            if number == 1 { "L DB1.DBD 0; L L#1; +D; T DB1.DBD 0;\n".to_owned() } else { String::new() }
        }),
        ("everything changes", &|number| {
            format!("CALL SFC 21 (BVAL := P#M 20.0 BYTE 4, RET_VAL := MW 30, BLK := P#DB{number}.DBX 0.0 BYTE 8192);\n")
        }),
    ];
    for (name, change) in changes {
        let mut text = String::new();
        for number in 1..=blocks {
            let _ = writeln!(text, "DATA_BLOCK DB {number}\nSTRUCT\n a : ARRAY [1..2048] OF DINT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK");
        }
        let body: String = (1..=blocks).map(change).collect();
        let _ = writeln!(text, "ORGANIZATION_BLOCK OB 1\nBEGIN\nL MD 20; L L#1; +D; T MD 20;\n{body}END_ORGANIZATION_BLOCK");
        let mut cpu = load(&text);
        let (mut best, mut bytes) = (f64::INFINITY, 0);
        // Less than a second passes, or the clock alone would make a new image.
        for scan in 0..REPETITIONS as u64 * 5 {
            cpu.scan(scan * CYCLE_US / 10);
            let start = Instant::now();
            let image = cpu.retain_image();
            let elapsed = start.elapsed().as_nanos() as f64;
            let length = image.map(|image| image.bytes.len());
            if scan > 0 {
                assert_eq!(length.is_some(), !name.starts_with("nothing"), "{name}");
                best = best.min(elapsed);
            }
            bytes = bytes.max(length.unwrap_or_default());
        }
        assert!(cpu.stop_cause().is_none(), "{name} keeps running: {:?}", cpu.stop_cause());
        println!("retentive data, {:>4} KB, {name:<24} {:>9.2} µs a scan", bytes >> 10, best / 1000.0);
    }
}

fn main() {
    // `cargo bench … -- retain` measures only that.
    if std::env::args().any(|argument| argument == "retain") {
        return [1, 8, 32].into_iter().for_each(retentive);
    }
    if std::env::args().any(|argument| argument == "ready") {
        return ready(4_700);
    }
    ready(4_700);
    compile_speed(1_000);
    compile_speed(100_000);
    run("bit logic, 1,000 statements", &bit_logic(1_000));
    run("bit logic, 10,000 statements", &bit_logic(10_000));
    run("arithmetic loop", include_str!("../../../benches/arithmetic_loop.awl"));
    run("calls mix", include_str!("../../../benches/calls_mix.awl"));
    [1, 8, 32].into_iter().for_each(retentive);
}
