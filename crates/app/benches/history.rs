//! What a history costs: the same run without one, with one, and the time to go back. Prints a table; no assertion depends on a time.
#![allow(clippy::print_stdout)] // The table is what it is for.

use std::sync::Arc;
use std::time::{Duration, Instant};

use sieben_cpu::{Cpu, Rack, Restart, Settings};
use sieben_engine::{Interpreter, Machine, StatementEvent, Tracer};
use sieben_lang::Options;
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_sim::history::{History, Plan, Until, Unwatched};

/// Bit logic, arithmetic, a timer and calls, some 300 statements in a scan; or the same in a loop of some 600,000.
fn program(turns: u32) -> String {
    let bits: String =
        (0..20).map(|bit| format!("A I {}.{}; AN M {}.0; = Q {}.{};\n", bit / 8, bit % 8, bit + 50, bit / 8, bit % 8)).collect();
    format!(
        "FUNCTION FC 1 : VOID\nBEGIN\nL MW 10; + 1; T MW 10; L MW 12; +I; T MW 14;\nEND_FUNCTION\n\
         ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY[1..20] OF BYTE;\n i : INT;\nEND_VAR\nBEGIN\n\
         L {turns};\nnext: T #i;\n{bits}UC FC 1;\nA I 0.0; L S5T#1S; SD T 1; A T 1; = Q 5.0;\nL #i; LOOP next;\nEND_ORGANIZATION_BLOCK\n"
    )
}

struct Count(u64);

impl Tracer for Count {
    fn statement(&mut self, _machine: &Machine, _event: &StatementEvent) {
        self.0 += 1;
    }
}

fn load(text: &str, cpu_type: &'static CpuType) -> Cpu {
    let mut sources = Sources::default();
    sources.add("bench.awl", text);
    let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &Options { cpu: Some(cpu_type), ..Options::default() });
    assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics);
    Cpu::load(cpu_type, Arc::new(compiled.program), Interpreter::load, Rack::simulated(cpu_type), Settings::default())
}

fn timed<T>(work: impl FnOnce() -> T) -> (Duration, T) {
    let begin = Instant::now();
    let value = work();
    (begin.elapsed(), value)
}

fn main() {
    println!("| program | CPU | statements | without history | counted | with history | snapshots | back, median | back, longest |");
    println!("|---|---|---|---|---|---|---|---|---|");
    for (name, turns, scans) in [("short scans", 4, 4000), ("one long scan", 15_000, 1)] {
        for cpu_type in ["315-2PN/DP", "416-3"].map(|name| CpuType::by_name(name).expect("a CPU type")) {
            let text = program(turns);
            let run = |cpu: &mut Cpu, tracer: Option<&mut dyn Tracer>| {
                cpu.restart(Restart::Warm);
                let mut tracer = tracer;
                for scan in 0..scans {
                    match &mut tracer {
                        Some(tracer) => cpu.scan_traced(scan * 10_000, &mut **tracer),
                        None => cpu.scan(scan * 10_000),
                    };
                }
            };
            let mut cpu = load(&text, cpu_type);
            let (plain, ()) = timed(|| run(&mut cpu, None));
            let mut count = Count(0);
            let mut cpu = load(&text, cpu_type);
            let (counted, ()) = timed(|| run(&mut cpu, Some(&mut count)));
            let mut history = History::new(load(&text, cpu_type), Plan::new(10_000, Some(scans), Vec::new()));
            let (kept, _) = timed(|| history.run(Until { statements: u64::MAX, scans: u64::MAX }, &mut Unwatched));
            assert_eq!(history.end(), count.0, "the same run");
            let end = history.end();
            let span = end.min(1_000_000);
            let mut back: Vec<Duration> = (0..200_u64)
                .map(|index| {
                    let at = end - (index * 7919 * 613 % span);
                    timed(|| history.go_to(at)).0
                })
                .collect();
            back.sort_unstable();
            let ms = |time: Duration| format!("{:.1} ms", time.as_secs_f64() * 1e3);
            println!(
                "| {name} | {} | {end} | {} | {} | {} | {} KiB | {} | {} |",
                cpu_type.name,
                ms(plain),
                ms(counted),
                ms(kept),
                history.bytes() / 1024,
                ms(back[back.len() / 2]),
                ms(back[back.len() - 1])
            );
        }
    }
}
