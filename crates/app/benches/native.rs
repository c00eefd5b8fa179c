//! Machine code beside C: `cargo bench -p sieben-app --bench native [NAME [listing]]`; with `listing` the machine code of these programs is
//! printed instead. A name that is an absolute path stands for two files of one's own, `PATH.awl` and `PATH.c`. With `first` it is how long
//! programs take to become machine code that is measured.
//!
//! The same programs in STL and, by hand, in C (`benches/*.c`), compiled by the system's `cc -O3`, take turns in one run. A figure is the
//! best of all turns, as CPU time of the thread, because other work on the machine only ever adds time.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

use std::collections::BTreeMap;
use std::env;
use std::process::Command;

use cases::{Case, DENSE, from_files};
use side_by_side::{CProgram, Loaded, TURNS, c_program, compiled, load, mean, now_ns};
use sieben_engine::{Interpreter, Machine, StatementEvent, Tracer};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::Area;

#[path = "native/cases.rs"]
mod cases;
#[path = "native/dense.rs"]
mod dense;
#[path = "native/first_tier.rs"]
mod first_tier;
mod side_by_side;

/// The allocator of the command line.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Scans after which the memory of both is compared.
const COMPARED_SCANS: u64 = 5;

/// Counts executed statements.
#[derive(Default)]
struct Count(u64);

impl Tracer for Count {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {
        self.0 += 1;
    }
}

/// Holds outputs and bit memory after some scans against those of the C program.
fn compare_memory(case: &Case, c: &CProgram, native: &mut Loaded) {
    (0..COMPARED_SCANS).for_each(|_| native.scan(None));
    let memory = &native.machine.memory;
    let areas = [(Area::Output, dense::PROCESS_BYTES), (Area::BitMemory, dense::MEMORY_BYTES)];
    let bytes = areas.iter().flat_map(|&(area, count)| &memory.area(area)[..count as usize]);
    let ours: String = bytes.map(|byte| format!("{byte:02x}")).collect();
    let output = Command::new(c.path()).args([COMPARED_SCANS.to_string().as_str(), "1", "memory"]).output().expect("the C program runs");
    let theirs = String::from_utf8_lossy(&output.stdout);
    assert_eq!(ours, theirs.trim(), "{}: the program in C does something else", case.name);
}

fn c_ns(program: &CProgram, scans: u64) -> f64 {
    let output = Command::new(program.path()).args([scans.to_string(), "5".to_owned()]).output().expect("the C program runs");
    String::from_utf8_lossy(&output.stdout).trim().parse().expect("nanoseconds")
}

fn best_ns(loaded: &mut Loaded, scans: u64) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..5 {
        let start = now_ns();
        (0..scans).for_each(|_| loaded.scan(None));
        best = best.min((now_ns() - start) / scans as f64);
    }
    best
}

fn main() {
    let wanted = env::args().nth(1).filter(|word| !word.starts_with('-')).unwrap_or_default();
    if wanted == "first" {
        return first_tier::print();
    }
    let mut cases = cases::all();
    if wanted.starts_with('/') {
        cases = vec![from_files(&wanted, &wanted, 1_000_000)];
    }
    println!(
        "{:<28} {:>6} {:>9} {:>9} {:>9} {:>7} {:>9} {:>10} {:>8}",
        "ns a statement", "count", "interp.", "machine", "cc -O3", "ratio", "native cc", "compile ms", "bytes"
    );
    let mut ratios: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for (index, case) in cases.iter().enumerate() {
        if !case.name.contains(&wanted) {
            continue;
        }
        let program = compiled("bench.awl", &case.stl).expect("it compiles");
        if env::args().nth(2).is_some_and(|word| word == "listing") {
            println!("{}", Jit::listing(&program, &load(&program, Interpreter::load).machine.memory.layout).expect("machine code"));
            continue;
        }
        let [c, tuned] = [&[][..], &["-march=native"]]
            .map(|flags: &[&str]| c_program(&case.name, &case.c, "main.c", flags, index).expect("it compiles"));
        let mut interpreted = load(&program, Interpreter::load);
        let mut count = Count::default();
        interpreted.scan(Some(&mut count));
        let start = now_ns();
        let mut native = load(&program, |program, layout| Jit::compiled(program, layout, StatusBits::Needed).expect("machine code"));
        let compile_ms = (now_ns() - start) / 1e6;
        if case.name.starts_with(DENSE) {
            compare_memory(case, &c, &mut native);
        }
        let (mut machine_ns, mut c_best, mut tuned_best) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
        for _ in 0..TURNS {
            machine_ns = machine_ns.min(best_ns(&mut native, case.scans / 10));
            c_best = c_best.min(c_ns(&c, case.scans / 10));
            tuned_best = tuned_best.min(c_ns(&tuned, case.scans / 10));
        }
        let interpreted_ns = best_ns(&mut interpreted, case.scans / 100);
        let each = |ns: f64| ns / count.0 as f64;
        // The smallest one is the way into machine code and out of it, and no program.
        if count.0 > 10 {
            let kind = case.name.split(',').next().unwrap_or_default();
            ratios.entry(kind).or_default().push(machine_ns / c_best);
        }
        println!(
            "{:<28} {:>6} {:>9.3} {:>9.3} {:>9.3} {:>7.2} {:>9.3} {:>10.2} {:>8}",
            case.name,
            count.0,
            each(interpreted_ns),
            each(machine_ns),
            each(c_best),
            machine_ns / c_best,
            each(tuned_best),
            compile_ms,
            native.engine.code_bytes()
        );
    }
    let kinds = |with_dense: bool| -> Vec<f64> {
        ratios.iter().filter(|(kind, _)| with_dense || **kind != DENSE).map(|(_, ratios)| mean(ratios)).collect()
    };
    if !ratios.is_empty() {
        println!("geometric mean of the kinds, each the mean of its programs: {:.2}", mean(&kinds(true)));
        println!("without {DENSE}: {:.2}", mean(&kinds(false)));
    }
}
