//! Structured Text beside C: `cargo bench -p sieben-app --bench structured_text -- [NAME [listing]]`; with `listing` the machine code
//! of these programs is printed instead. A path of a file `.st`, or of a folder, instead of the name takes other programs than ours,
//! each with a file `.c` beside it.
//!
//! The same programs in Structured Text and, by hand, in C, compiled by the system's `cc -O3`, take turns in one run. Both run the same
//! number of scans, 10 ms of their clock apart, and have to agree in `check` behind each of them. A figure is the best of all turns, as CPU
//! time of the thread, because other work on the machine only ever adds time.
#![allow(clippy::print_stdout, clippy::print_stderr)] // A measurement prints its figures.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::sync::Arc;
use std::{env, fs};

use programs::{CHECKED_SCANS, Case, check};
use side_by_side::{CProgram, TURNS, c_program, compiled, load, now_ns};
use sieben_engine::{Engine, Interpreter, Layout, Program};
use sieben_jit::{Jit, StatusBits};

#[path = "structured_text/programs.rs"]
mod programs;
mod side_by_side;

/// Scans of a turn: enough for timers to run out many times, few enough for sums to stay in a DINT.
const SCANS: u64 = 2000;
/// Scans of the interpreter, which is compared with nothing but itself.
const INTERPRETED_SCANS: u64 = 40;
/// C rounds each operation to REAL, as a CPU does.
const C_FLAGS: &[&str] = &["-ffp-contract=off"];

/// Nanoseconds of a scan, and `check` behind the last one.
fn c_turn(program: &CProgram, scans: u64) -> (f64, i32) {
    let output = Command::new(program.path()).arg(scans.to_string()).output().expect("the C program runs");
    let text = String::from_utf8_lossy(&output.stdout);
    let (ns, check) = text.trim().split_once(' ').expect("two figures");
    (ns.parse().expect("nanoseconds"), check.parse().expect("a number"))
}

/// The same of an engine.
fn turn(program: &Program, engine: impl FnOnce(&Program, &Layout) -> Arc<dyn Engine>, scans: u64) -> (f64, i32) {
    let mut loaded = load(program, engine);
    let start = now_ns();
    (0..scans).for_each(|_| loaded.scan(None));
    ((now_ns() - start) / scans as f64, check(program, &loaded))
}

/// Compares `check` in machine code and in C after each scan; `Err` = the first difference, in words.
fn agree(program: &Program, engine: &Arc<dyn Engine>, c: &CProgram) -> Result<(), String> {
    let output = Command::new(c.path()).args([&SCANS.to_string(), "each"]).output().expect("the C program runs");
    let text = String::from_utf8_lossy(&output.stdout);
    let of_c: Vec<i32> = text.lines().map(|line| line.parse().expect("a number")).collect();
    if !output.status.success() || of_c.len() != SCANS as usize {
        return Err(format!("the program in C ends after {} of {SCANS} scans with {}", of_c.len(), output.status));
    }
    let mut loaded = load(program, |_, _| engine.clone());
    let of_machine = std::iter::repeat_with(|| {
        loaded.scan(None);
        check(program, &loaded)
    });
    match (1_u64..).zip(of_c.into_iter().zip(of_machine)).find(|(_, (c, machine))| c != machine) {
        Some((scan, (c, machine))) => {
            Err(format!("`check` after scan {scan} is {machine} ({machine:#010X}) in machine code and {c} ({c:#010X}) in C"))
        }
        None => Ok(()),
    }
}

/// Programs in Structured Text that somebody wrote, each with a file in C beside it; `Err` = a file that cannot be read.
fn programs_at(path: &Path) -> Result<Vec<Case>, String> {
    let mut files: Vec<PathBuf> = match fs::read_dir(path) {
        Ok(entries) => entries.map(|entry| entry.expect("an entry of the folder").path()).collect(),
        Err(_) => vec![path.to_owned()],
    };
    files.retain(|file| file.extension().is_some_and(|extension| extension == "st"));
    files.sort();
    let text = |file: &Path| fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()));
    let case = |file: PathBuf| {
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Case { name: name.leak(), st: text(&file)?, c: text(&file.with_extension("c"))?, check: None })
    };
    files.into_iter().map(case).collect()
}

/// Measures a program beside its twin in C and prints a line; the ratio of both, or what is wrong.
fn measure(index: usize, case: &Case) -> Result<f64, String> {
    let program = compiled(&format!("{}.st", case.name), &case.st)?;
    let c = c_program(case.name, &case.c, "st/main.c", C_FLAGS, index)?;
    if let Some(check) = case.check {
        assert_eq!(c_turn(&c, CHECKED_SCANS).1, check, "{}: what the test of the programs compares with", case.name);
    }
    let mut engine = None;
    let start = now_ns();
    let first = turn(
        &program,
        |program, layout| engine.insert(Jit::compiled(program, layout, StatusBits::Needed).expect("machine code")).clone(),
        0,
    );
    let compile_ms = (now_ns() - start) / 1e6;
    if first.1 != 0 {
        return Err(format!("{}: `check` begins with {}, not with 0", case.name, first.1));
    }
    let engine = engine.expect("an engine was loaded");
    agree(&program, &engine, &c).map_err(|error| format!("{}: {error}", case.name))?;
    let (mut machine_best, mut c_best) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..TURNS {
        let (machine_ns, machine_check) = turn(&program, |_, _| engine.clone(), SCANS);
        let (c_ns, c_check) = c_turn(&c, SCANS);
        if machine_check != c_check {
            return Err(format!("{}: `check` differs from turn to turn", case.name));
        }
        machine_best = machine_best.min(machine_ns);
        c_best = c_best.min(c_ns);
    }
    let interpreted = turn(&program, Interpreter::load, INTERPRETED_SCANS).0;
    let ratio = machine_best / c_best;
    println!(
        "{:<12} {interpreted:>11.0} {machine_best:>11.0} {c_best:>11.0} {ratio:>7.2} {compile_ms:>11.1} {:>9}",
        case.name,
        engine.code_bytes()
    );
    Ok(ratio)
}

/// The machine code of a program.
fn listing(case: &Case) -> Result<String, String> {
    let program = compiled(&format!("{}.st", case.name), &case.st)?;
    Ok(Jit::listing(&program, &load(&program, Interpreter::load).machine.memory.layout).expect("machine code"))
}

fn main() -> ExitCode {
    let wanted = env::args().nth(1).filter(|word| !word.starts_with('-')).unwrap_or_default();
    let lists = env::args().nth(2).is_some_and(|word| word == "listing");
    let cases = match wanted.contains('/') {
        true => programs_at(&side_by_side::root().join(&wanted)),
        false => Ok(programs::all().into_iter().filter(|case| case.name.contains(&wanted)).collect()),
    };
    let cases: Vec<Case> = match cases {
        Ok(cases) => cases,
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::from(2);
        }
    };
    if cases.is_empty() {
        eprintln!("no program: `{wanted}` is part of no name, and no file `.st`, or folder of such files, of the project");
        return ExitCode::from(2);
    }
    println!("{:<12} {:>11} {:>11} {:>11} {:>7} {:>11} {:>9}", "ns a scan", "interp.", "machine", "cc -O3", "ratio", "compile ms", "bytes");
    let (mut ratios, mut failed) = (Vec::new(), false);
    for (index, case) in cases.iter().enumerate() {
        let result =
            if lists { listing(case).map(|listing| println!("{listing}")) } else { measure(index, case).map(|ratio| ratios.push(ratio)) };
        if let Err(error) = result {
            eprintln!("{error}");
            failed = true;
        }
    }
    if !ratios.is_empty() {
        println!("geometric mean of the ratios: {:.2}", side_by_side::mean(&ratios));
    }
    if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
