//! Programs beside the same work in C: what the measurements and their tests share.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::{env, fs};

use rustix::time::{ClockId, clock_gettime};
use sieben_cpu::BUDGET_MAX;
use sieben_engine::{Context, Engine, Entry, Exit, Fault, FaultPlace, Host, Layout, Machine, Program, Reaction, Tracer};
use sieben_lang::{Options, compile};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// Turns that machine code and C take; the best one of each counts.
pub(crate) const TURNS: usize = 7;

/// The CPU that programs are laid out for: one with room for the largest.
pub(crate) fn cpu_type() -> &'static CpuType {
    CpuType::by_name("416-3").expect("a CPU type")
}

/// CPU time of this thread in nanoseconds.
pub(crate) fn now_ns() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e9 + time.tv_nsec as f64
}

/// A Host for programs that ask nothing but for a new budget.
pub(crate) struct Quiet;

impl Host for Quiet {
    fn fault(&mut self, _: &mut Machine, fault: &Fault, place: FaultPlace) -> Reaction {
        // What is noted only, such as an index outside its array, ends nothing.
        assert!(fault.is_noted(), "{fault:?} at {place:?}");
        Reaction::Continue
    }
    fn peripheral_read(&mut self, _: &mut Machine, _: u32, _: Width) -> Option<u32> {
        None
    }
    fn peripheral_write(&mut self, _: &mut Machine, _: u32, _: Width, _: u32) -> bool {
        false
    }
    fn safe_point(&mut self, machine: &mut Machine, _: FaultPlace) -> Reaction {
        machine.budget = BUDGET_MAX;
        Reaction::Continue
    }
    fn system_function(&mut self, _: &mut Machine, _: BlockId, _: usize) -> Reaction {
        Reaction::Continue
    }
}

/// The folder of the project.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The geometric mean.
pub(crate) fn mean(ratios: &[f64]) -> f64 {
    ratios.iter().product::<f64>().powf(1.0 / ratios.len() as f64)
}

/// A file of the folder `benches`.
pub(crate) fn read(file: &str) -> String {
    let path = root().join("benches").join(file);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A compiled C program, in a temporary folder that goes with it.
pub(crate) struct CProgram(PathBuf);

impl CProgram {
    /// The executable.
    pub(crate) fn path(&self) -> PathBuf {
        self.0.join("program")
    }
}

impl Drop for CProgram {
    fn drop(&mut self) {
        // What cannot be removed is left to whoever cleans the folder of temporary files.
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Compiles a C program together with a `main` and its header, both in a folder below `benches`; `Err` = what is wrong with it.
pub(crate) fn c_program(name: &str, text: &str, main: &str, flags: &[&str], index: usize) -> Result<CProgram, String> {
    let compiled = CProgram(env::temp_dir().join(format!("sieben-bench-{}-{index}-{}", std::process::id(), flags.len())));
    fs::create_dir_all(&compiled.0).expect("a temporary folder");
    let source = compiled.0.join("program.c");
    fs::write(&source, text).expect("a temporary file");
    let main = root().join("benches").join(main);
    let status = Command::new("cc")
        .arg("-O3")
        .args(flags)
        .arg("-I")
        .arg(main.parent().expect("a folder"))
        .arg(&source)
        .arg(&main)
        .arg("-o")
        .arg(compiled.path())
        .arg("-lm")
        .status();
    match status {
        Ok(status) if status.success() => Ok(compiled),
        Ok(_) => Err(format!("{name}: the C compiler says above what is wrong with the program in C")),
        Err(error) => Err(format!("{name}: `cc` does not start: {error}")),
    }
}

/// A program in an engine, and the memory that it works on.
pub(crate) struct Loaded {
    /// The engine.
    pub(crate) engine: Arc<dyn Engine>,
    /// The memory.
    pub(crate) machine: Machine,
}

/// Loads a program; inputs have arbitrary values.
pub(crate) fn load(program: &Program, engine: impl FnOnce(&Program, &Layout) -> Arc<dyn Engine>) -> Loaded {
    let layout = Arc::new(Layout::new(cpu_type(), program));
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
    /// One run of OB 1, 10 ms later.
    pub(crate) fn scan(&mut self, tracer: Option<&mut dyn Tracer>) {
        self.machine.budget = BUDGET_MAX;
        self.machine.clock_us += 10_000;
        let entry = Entry { block: BlockId::ob(1), start_information: [0; 20], registers: None };
        let (mut host, tracer) = (Quiet, tracer.map(|tracer| tracer as &mut dyn Tracer));
        let exit = self.engine.run(&mut Context { machine: &mut self.machine, host: &mut host, tracer }, &entry);
        assert_eq!(exit, Exit::Finished);
    }
}

/// Compiles one source; its name says the language.
pub(crate) fn compiled(name: &str, text: &str) -> Result<Program, String> {
    let mut sources = Sources::default();
    sources.add(name, text);
    let options = Options { cpu: Some(cpu_type()), system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let compiled = compile(&sources, &SymbolTable::default(), &options);
    let error = |found: &Diagnostic| {
        let (line, column) = sources.line_column(found.span);
        let fix = found.fix.as_ref().map_or_else(String::new, |fix| format!(" ({})", fix.title));
        format!("{name}:{line}:{column}: {}{fix}. {}", found.message, found.help.as_deref().unwrap_or(found.problem.help()))
    };
    let errors: Vec<_> = compiled.diagnostics.iter().filter(|found| found.severity() == Severity::Error).map(error).collect();
    if errors.is_empty() { Ok(compiled.program) } else { Err(errors.join("\n")) }
}
