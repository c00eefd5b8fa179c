//! `sieben bench FILE…`: how long a scan takes.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use clap::Args;
use rustix::time::{ClockId, clock_gettime};
use serde_json::{Value, json};
use sieben_cpu::{Cpu, Loaded, OperatingMode, Restart};
use sieben_engine::{Layout, Machine, Program, StatementEvent, Tracer};
use sieben_jit::{Pass, PassSet, StatusBits, Tier, Tiers};
use sieben_model::problems::Problem;
use sieben_sim::names::Name;
use sieben_workspace::controller;
use sieben_workspace::duration;
use sieben_workspace::names;
use sieben_workspace::schedule;

use crate::arguments::ProgramArguments;
use crate::duration::cycle_argument;
use crate::engines::{self, EngineArgument};
use crate::failure::{Exit, Failure};
use crate::instances::{self, Instances};
use crate::output;

/// Bytes that are walked through before each scan of the cold figure: more than the caches of a core hold.
const CACHES_BYTES: usize = 32 << 20;
/// Bytes of a cache line.
const LINE_BYTES: usize = 64;
/// Scans of the cold figure, whose median it is.
const COLD_SCANS: usize = 15;

/// Measure how long a scan takes.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben bench plant.awl\n  \
  sieben bench plant.awl --engine interpreter --json\n  \
  sieben bench plant.awl --engine quick  the machine code of the first scans\n  \
  sieben bench plant --without inlining  the same machine code without one of its optimizations\n  \
  sieben bench plant --warmup-scans 1000 --show MW20\n  \
  sieben bench plant --instances 10000   ten thousand controllers in one process\n\n\
Time is virtual; what is measured is the CPU time of the thread, process images and\n\
cycle included. Figures of one machine do not carry over to another.\n\n\
Exit codes: 0 ok, 2 usage, 3 does not compile, 4 the CPU went to STOP.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables, or a project folder
    #[arg(required = true, value_name = "FILE")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// Virtual time from one scan to the next [default: the project's, else 10ms]
    #[arg(long, value_name = "DURATION", allow_hyphen_values = true, value_parser = cycle_argument)]
    cycle: Option<Duration>,
    /// How often to measure
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    reps: u32,
    /// Shortest time of one measurement, in milliseconds
    #[arg(long, value_name = "MS", default_value_t = 50, value_parser = clap::value_parser!(u32).range(1..=60_000))]
    min_ms: u32,
    /// Scans before anything is measured
    #[arg(long, value_name = "N", default_value_t = 500, value_parser = clap::value_parser!(u64).range(1..))]
    warmup_scans: u64,
    /// Print these as they are after the scans of the warm-up
    #[arg(long, value_name = "NAME,…")]
    show: Vec<String>,
    /// Also let so many controllers of this program run in turn, which share one copy of its code
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    instances: Option<u32>,
    /// Which engine runs the program
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Leave these optimizations of the machine code out
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    without: Vec<Pass>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

/// CPU time of this thread.
fn now() -> Duration {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    Duration::new(u64::try_from(time.tv_sec).unwrap_or(0), u32::try_from(time.tv_nsec).unwrap_or(0))
}

/// Counts executed statements.
#[derive(Default)]
struct Count(u64);

impl Tracer for Count {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {
        self.0 += 1;
    }
}

/// A CPU whose scans follow one another at the same distance.
struct Bench {
    cpu: Cpu,
    cycle_us: u64,
    now_us: u64,
}

impl Bench {
    fn scan(&mut self) {
        self.cpu.scan(self.now_us);
        self.now_us = self.now_us.saturating_add(self.cycle_us);
    }
    fn runs(&self) -> bool {
        self.cpu.mode() == OperatingMode::Run
    }
}

/// The quickly compiled machine code, that of the first scans of a run.
struct Quick {
    time: Duration,
    statements: usize,
}

/// What it took to make the code.
struct Compile {
    /// From the command to a loaded CPU.
    whole: Duration,
    /// `None` = the program is interpreted.
    quick: Option<Quick>,
    code_bytes: usize,
}

/// What was measured, in nanoseconds.
struct Figures {
    compile: Compile,
    ns_per_scan: Vec<f64>,
    ns_per_statement: Option<f64>,
    cold_ns_per_scan: f64,
}

/// How long the program takes to become the machine code that a run begins with, and how many statements it has.
fn time_of_quick(program: &Program, layout: &Layout) -> Quick {
    let tiers = Tiers::load(program, layout, StatusBits::Needed);
    let started = now();
    // Code that cannot be compiled quickly took its time all the same.
    let _ = tiers.compile(Tier::Quick);
    let time = now().saturating_sub(started);
    Quick { time, statements: program.code.values().map(|block| block.code.statement_count()).sum() }
}

/// Compiles, warms up, measures.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let started = now();
    let overrides = arguments.program.overrides_at_speed()?;
    let project = arguments.program.load(&arguments.paths)?;
    let build = match super::or_report(project.compile(overrides, false), arguments.json) {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    let engine = arguments.engine.settled();
    if !arguments.without.is_empty() && engine != EngineArgument::Jit {
        let told = "`--without` leaves optimizations of machine code out, and this engine has none";
        return Err(Failure::usage(Problem::P7001, told).help("leave `--engine` out"));
    }
    let passes = PassSet::default().without_all(&arguments.without);
    let load = |program: &_, layout: &_| match engine {
        EngineArgument::Jit => engines::machine_code(program, layout, StatusBits::Needed, passes),
        engine => engine.load(program, layout, StatusBits::Needed),
    };
    let program = Arc::new(build.compiled.program.clone());
    let settings = controller::settings(&build);
    let loaded = Loaded::new(build.cpu, Arc::clone(&program), load);
    let cpu = Cpu::new(loaded.clone(), controller::rack(&build), settings.clone());
    let compile = now().saturating_sub(started);
    let quick = (loaded.code_bytes() > 0).then(|| time_of_quick(&program, &cpu.machine().memory.layout));
    let symbols = &build.project.symbols;
    let shown = names::resolve_lists(&arguments.show, symbols, &cpu)?;
    let cycle = schedule::going_cycle(arguments.cycle, &build.project.settings);
    let mut bench = Bench { cpu, cycle_us: duration::micros(cycle), now_us: 0 };

    bench.cpu.restart(Restart::Warm);
    let mut count = Count::default();
    for scan in 1..=arguments.warmup_scans {
        if scan < arguments.warmup_scans {
            bench.scan();
        } else {
            bench.cpu.scan_traced(bench.now_us, &mut count);
            bench.now_us = bench.now_us.saturating_add(bench.cycle_us);
        }
        if !bench.runs() {
            break;
        }
    }
    let values: Vec<(String, String, Value)> =
        shown.iter().map(|name: &Name| (name.text().to_owned(), names::text(name, &bench.cpu), names::to_json(name, &bench.cpu))).collect();
    let compile = Compile { whole: compile, quick, code_bytes: loaded.code_bytes() };
    let figures = bench.runs().then(|| measure(arguments, &mut bench, compile, count.0));
    let least = Duration::from_millis(u64::from(arguments.min_ms));
    let instances = |count: u32| instances::measure(&loaded, build.cpu, &settings, count as usize, least, now);
    match figures {
        Some(figures) if bench.runs() => {
            let many = arguments.instances.map(instances);
            if many.as_ref().is_some_and(Option::is_none) {
                output::message("One of the instances went to STOP: each has a module at the first 128 peripheral bytes only.\n");
                return Ok(Exit::Stopped);
            }
            let instances = many.flatten();
            print(arguments, &figures, &values, instances.as_ref())?;
            Ok(Exit::Success)
        }
        _ => {
            match bench.cpu.stop_cause() {
                Some(cause) if arguments.json => {
                    output::print_json(&json!({ "mode": "STOP", "stop": controller::stop_json(cause) }), false)?;
                }
                Some(cause) => output::message(&controller::stop_text(&build, cause)),
                None => {}
            }
            Ok(Exit::Stopped)
        }
    }
}

fn measure(arguments: &Arguments, bench: &mut Bench, compile: Compile, statements: u64) -> Figures {
    let least = Duration::from_millis(u64::from(arguments.min_ms));
    let ns_per_scan: Vec<f64> = (0..arguments.reps)
        .map(|_| {
            let started = now();
            let (mut scans, mut batch) = (0_u64, 1_u64);
            loop {
                (0..batch).for_each(|_| bench.scan());
                scans += batch;
                let time = now().saturating_sub(started);
                if time >= least || !bench.runs() {
                    return time.as_nanos() as f64 / scans as f64;
                }
                batch = (batch * 2).min(1 << 20);
            }
        })
        .collect();
    let best = ns_per_scan.iter().copied().fold(f64::INFINITY, f64::min);
    let mut caches = vec![1_u8; CACHES_BYTES];
    let mut cold: Vec<f64> = (0..COLD_SCANS)
        .map(|turn| {
            caches.iter_mut().step_by(LINE_BYTES).for_each(|byte| *byte = byte.wrapping_add(turn as u8));
            std::hint::black_box(&mut caches);
            let started = now();
            bench.scan();
            now().saturating_sub(started).as_nanos() as f64
        })
        .collect();
    cold.sort_by(f64::total_cmp);
    Figures {
        compile,
        ns_per_scan,
        ns_per_statement: (statements > 0).then(|| best / statements as f64),
        cold_ns_per_scan: cold[COLD_SCANS / 2],
    }
}

fn print(
    arguments: &Arguments,
    figures: &Figures,
    values: &[(String, String, Value)],
    instances: Option<&Instances>,
) -> Result<(), Failure> {
    if arguments.json {
        let values: serde_json::Map<String, Value> = values.iter().map(|(name, _, value)| (name.clone(), value.clone())).collect();
        let mut object = json!({
            "compile_s": figures.compile.whole.as_secs_f64(),
            "compile_quick_s": figures.compile.quick.as_ref().map(|quick| quick.time.as_secs_f64()),
            "ns_per_scan": figures.ns_per_scan,
            "ns_per_statement": figures.ns_per_statement,
            "cold_ns_per_scan": figures.cold_ns_per_scan,
            "code_bytes": figures.compile.code_bytes,
            "values": values,
        });
        if let Some(instances) = instances {
            object["instances"] = instances.json();
        }
        return output::print_json(&object, false);
    }
    let best = figures.ns_per_scan.iter().copied().fold(f64::INFINITY, f64::min);
    let all = figures.ns_per_scan.iter().map(|ns| format!("{ns:.0}")).collect::<Vec<_>>().join(", ");
    let mut text = format!("compiled in      {:.1} ms\n", figures.compile.whole.as_secs_f64() * 1e3);
    if let Some(Quick { time, statements }) = &figures.compile.quick {
        let ms = time.as_secs_f64() * 1e3;
        let each =
            if *statements < 1000 { String::new() } else { format!(", {:.1} ms for 1,000 statements", ms * 1e3 / *statements as f64) };
        text.push_str(&format!("first tier in    {ms:.1} ms{each}\n"));
    }
    text.push_str(&format!("a scan           {best:.0} ns (best of {all})\n"));
    if let Some(ns) = figures.ns_per_statement {
        text.push_str(&format!("a statement      {ns:.2} ns\n"));
    }
    text.push_str(&format!("a cold scan      {:.0} ns, with nothing in the caches\n", figures.cold_ns_per_scan));
    text.push_str(&match figures.compile.code_bytes {
        0 => "machine code     none: the program is interpreted\n".to_owned(),
        bytes => format!("machine code     {bytes} bytes\n"),
    });
    if let Some(instances) = instances {
        text.push_str(&instances.text());
    }
    for (name, value, _) in values {
        text.push_str(&format!("{name} = {value}\n"));
    }
    output::print(&text)
}
