//! Machine code beside C: `cargo bench -p sieben-app --bench native`.
//!
//! The same programs in STL and, by hand, in C (`benches/*.c`), compiled by the system's `cc -O3`, take turns in one run. A figure is the
//! best of all turns, as CPU time of the thread, because other work on the machine only ever adds time.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::{env, fs};

use rustix::time::{ClockId, clock_gettime};
use sieben_engine::{
    Context, Engine, Entry, Exit, Fault, FaultPlace, Host, Interpreter, Layout, Machine, Program, Reaction, StatementEvent, Tracer,
};
use sieben_jit::{Jit, StatusBits};
use sieben_lang::{Options, compile};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

const TURNS: usize = 7;
/// Statements of one function of generated C.
const C_FUNCTION_STATEMENTS: usize = 200;

/// CPU time of this thread in nanoseconds.
fn now_ns() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e9 + time.tv_nsec as f64
}

/// A Host for programs that ask nothing but for a new budget.
struct Quiet;

impl Host for Quiet {
    fn fault(&mut self, _: &mut Machine, fault: &Fault, place: FaultPlace) -> Reaction {
        panic!("{fault:?} at {place:?}")
    }
    fn peripheral_read(&mut self, _: &mut Machine, _: u32, _: Width) -> Option<u32> {
        None
    }
    fn peripheral_write(&mut self, _: &mut Machine, _: u32, _: Width, _: u32) -> bool {
        false
    }
    fn safe_point(&mut self, machine: &mut Machine, _: FaultPlace) -> Reaction {
        machine.budget = 1024;
        Reaction::Continue
    }
    fn system_function(&mut self, _: &mut Machine, _: BlockId, _: usize) -> Reaction {
        Reaction::Continue
    }
}

/// Counts executed statements.
#[derive(Default)]
struct Count(u64);

impl Tracer for Count {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {
        self.0 += 1;
    }
}

/// A program in both languages.
struct Case {
    name: String,
    stl: String,
    c: String,
    scans: u64,
}

/// Networks of bit logic over random addresses, the same in both languages.
fn bit_logic(statements: usize) -> Case {
    let mut state = 12_345_u32;
    let mut random = |below: u32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) % below
    };
    let mut stl = String::new();
    let mut c = String::from("#include \"plc.h\"\n");
    let mut functions = 0;
    for network in 0..statements / 4 {
        // A function of 10,000 statements would keep the C compiler for minutes.
        if network % (C_FUNCTION_STATEMENTS / 4) == 0 {
            let end = if functions > 0 { "}\n" } else { "" };
            let _ = write!(c, "{end}\nstatic __attribute__((noinline)) void part_{functions}(void)\n{{\n");
            functions += 1;
        }
        let mut place = || (random(64), random(8));
        let [a, b, o] = [place(), place(), place()];
        let (byte, bit) = (network / 8 % 64, network % 8);
        let _ = write!(stl, "A I {}.{};\nAN M {}.{};\nO I {}.{};\n= Q {byte}.{bit};\n", a.0, a.1, b.0, b.1, o.0, o.1);
        let _ = writeln!(
            c,
            "    put_bit(Q, {byte}, {bit}, (get_bit(I, {}, {}) & !get_bit(M, {}, {})) | get_bit(I, {}, {}));",
            a.0, a.1, b.0, b.1, o.0, o.1
        );
    }
    c.push_str("}\n\nvoid scan(void)\n{\n");
    for part in 0..functions {
        let _ = writeln!(c, "    part_{part}();");
    }
    c.push_str("}\n");
    Case { name: format!("bit logic, {statements} statements"), stl, c, scans: 4_000_000 / statements as u64 }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn from_files(name: &str, file: &str, scans: u64) -> Case {
    let read = |extension: &str| {
        fs::read_to_string(root().join("benches").join(file).with_extension(extension)).expect("a program of the benches")
    };
    Case { name: name.to_owned(), stl: read("awl"), c: read("c"), scans }
}

/// Compiles the C program; the executable.
fn c_program(case: &Case, flags: &[&str], index: usize) -> PathBuf {
    let folder = env::temp_dir().join(format!("sieben-bench-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a temporary folder");
    let source = folder.join(format!("{index}.c"));
    fs::write(&source, &case.c).expect("a temporary file");
    let program = folder.join(format!("{index}-{}", flags.len()));
    let benches = root().join("benches");
    let status = Command::new("cc")
        .arg("-O3")
        .args(flags)
        .arg("-I")
        .arg(&benches)
        .arg(&source)
        .arg(benches.join("main.c"))
        .arg("-o")
        .arg(&program)
        .status();
    assert!(status.is_ok_and(|status| status.success()), "the system's C compiler compiles {}", case.name);
    program
}

fn c_ns(program: &Path, scans: u64) -> f64 {
    let output = Command::new(program).args([scans.to_string(), "5".to_owned()]).output().expect("the C program runs");
    String::from_utf8_lossy(&output.stdout).trim().parse().expect("nanoseconds")
}

struct Loaded {
    engine: Arc<dyn Engine>,
    machine: Machine,
}

fn load(program: &Program, engine: impl FnOnce(&Program, &Layout) -> Arc<dyn Engine>) -> Loaded {
    let layout = Arc::new(Layout::new(&CpuType::ALL[0], program));
    let engine = engine(program, &layout);
    let mut machine = Machine::new(layout);
    for (&number, range) in &machine.memory.layout.data_blocks.clone() {
        machine.memory.arena[range.clone()].copy_from_slice(&program.data[&number].image);
    }
    let mut state = 99_u32;
    for byte in machine.memory.area_mut(Area::Input) {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        *byte = (state >> 16) as u8;
    }
    Loaded { engine, machine }
}

impl Loaded {
    fn scan(&mut self, tracer: Option<&mut Count>) {
        self.machine.budget = 1024;
        self.machine.clock_us += 10_000;
        let entry = Entry { block: BlockId::ob(1), start_information: [0; 20], registers: None };
        let (mut host, tracer) = (Quiet, tracer.map(|count| count as &mut dyn Tracer));
        let exit = self.engine.run(&mut Context { machine: &mut self.machine, host: &mut host, tracer }, &entry);
        assert_eq!(exit, Exit::Finished);
    }
    fn ns(&mut self, scans: u64) -> f64 {
        let mut best = f64::INFINITY;
        for _ in 0..5 {
            let start = now_ns();
            (0..scans).for_each(|_| self.scan(None));
            best = best.min((now_ns() - start) / scans as f64);
        }
        best
    }
}

fn compiled(text: &str) -> Program {
    let mut sources = Sources::default();
    sources.add("bench.awl", text);
    let compiled = compile(&sources, &SymbolTable::default(), &Options::default());
    let errors: Vec<_> =
        compiled.diagnostics.iter().filter(|found| found.severity() == Severity::Error).map(|found| &found.message).collect();
    assert!(errors.is_empty(), "{errors:?}");
    compiled.program
}

fn main() {
    let cases = [
        bit_logic(4),
        bit_logic(1_000),
        bit_logic(10_000),
        from_files("arithmetic loop", "arithmetic_loop", 20_000),
        from_files("calls mix", "calls_mix", 200_000),
    ];
    println!(
        "{:<28} {:>6} {:>9} {:>9} {:>9} {:>7} {:>9} {:>10} {:>8}",
        "ns a statement", "count", "interp.", "machine", "cc -O3", "ratio", "native cc", "compile ms", "bytes"
    );
    let mut ratios = Vec::new();
    let wanted = env::args().nth(1).filter(|word| !word.starts_with('-')).unwrap_or_default();
    for (index, case) in cases.iter().enumerate() {
        if !case.name.contains(&wanted) {
            continue;
        }
        let program = compiled(&case.stl);
        let [c, tuned] = [&[][..], &["-march=native"]].map(|flags: &[&str]| c_program(case, flags, index));
        let mut interpreted = load(&program, Interpreter::load);
        let mut count = Count::default();
        interpreted.scan(Some(&mut count));
        let start = now_ns();
        let mut native = load(&program, |program, layout| Jit::compiled(program, layout, StatusBits::Needed).expect("machine code"));
        let compile_ms = (now_ns() - start) / 1e6;
        let (mut machine_ns, mut c_best, mut tuned_best) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
        for _ in 0..TURNS {
            machine_ns = machine_ns.min(native.ns(case.scans / 10));
            c_best = c_best.min(c_ns(&c, case.scans / 10));
            tuned_best = tuned_best.min(c_ns(&tuned, case.scans / 10));
        }
        let interpreted_ns = interpreted.ns(case.scans / 100);
        let each = |ns: f64| ns / count.0 as f64;
        ratios.push(machine_ns / c_best);
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
    let mean = ratios.iter().product::<f64>().powf(1.0 / ratios.len() as f64);
    println!("geometric mean of the ratios: {mean:.2}");
}
