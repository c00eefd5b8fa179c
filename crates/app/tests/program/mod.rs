//! From a source text to CPUs: what the executable pages, the vectors and the tests of whole programs share.

use std::sync::Arc;

use sieben_cpu::{Cpu, CyclicInterrupt, IoModule, Rack, Settings, SimulatedModule};
use sieben_engine::{Engine, Interpreter, Layout, Program};
use sieben_jit::{Jit, StatusBits};
use sieben_lang::language::Language;
use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Compiled, Options};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// Loads a program into an engine.
pub(crate) type Load = fn(&Program, &Layout) -> Arc<dyn Engine>;

/// All engines that a program runs on.
#[allow(dead_code)] // Not every test that shares this file runs what it compiles.
pub(crate) const ENGINES: &[(&str, Load)] = &[("interpreter", Interpreter::load), ("jit", machine_code)];

/// Machine code and nothing else: a program of a page or vector that stays in the interpreter would be tested twice there.
fn machine_code(program: &Program, layout: &Layout) -> Arc<dyn Engine> {
    Jit::compiled(program, layout, StatusBits::All).unwrap_or_else(|reason| panic!("the program becomes machine code: {reason}"))
}

/// A text and its translation into the other mnemonic language, with the language's name.
#[allow(dead_code)] // Only the pages are in both languages.
pub(crate) fn both_languages(english: &str) -> Result<[(&'static str, Mnemonics, String); 2], String> {
    both_languages_of("page.awl", english)
}

/// The same for a source of a name.
#[allow(dead_code)] // Only the pages are in both languages.
pub(crate) fn both_languages_of(name: &str, english: &str) -> Result<[(&'static str, Mnemonics, String); 2], String> {
    let german = convert(name, english, Mnemonics::English, Mnemonics::German)?;
    let back = convert(name, &german, Mnemonics::German, Mnemonics::English)?;
    if back != english {
        return Err(format!("converted to German mnemonics and back it is another text:\n{back}"));
    }
    Ok([("English", Mnemonics::English, english.to_owned()), ("German", Mnemonics::German, german)])
}

fn convert(name: &str, text: &str, from: Mnemonics, to: Mnemonics) -> Result<String, String> {
    let drawing = Language::of(name, text, None).drawing();
    sieben_lang::stl::convert::convert_as(text, Some(from), to, drawing).map_err(|diagnostics| {
        format!("cannot be converted: {}", diagnostics.iter().map(|found| found.message.clone()).collect::<Vec<_>>().join("; "))
    })
}

/// Compiles an STL text for a CPU type.
#[allow(dead_code)] // Not every test that shares this file has programs in STL alone.
pub(crate) fn compile(text: &str, mnemonics: Mnemonics, cpu: &'static CpuType) -> Result<Compiled, String> {
    compile_sources(&[("page.awl", text)], Some(mnemonics), None, cpu)
}

/// Compiles the sources of one project, named `*.awl` or `*.st`, for a CPU type.
pub(crate) fn compile_sources(
    texts: &[(&str, &str)],
    mnemonics: Option<Mnemonics>,
    dialect: Option<Dialect>,
    cpu: &'static CpuType,
) -> Result<Compiled, String> {
    let mut sources = Sources::default();
    for (name, text) in texts {
        sources.add(*name, *text);
    }
    // Pages about extension words are extended programs.
    let extended = texts.iter().any(|(name, text)| name.ends_with(".awl") && text.contains("__"));
    let mut system_blocks = sieben_cpu::system::interfaces();
    if extended {
        system_blocks.extend(sieben_cpu::system::extension_interfaces());
    }
    let options = Options { cpu: Some(cpu), mnemonics, dialect, extended, system_blocks, ..Options::default() };
    let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &options);
    let errors: Vec<String> = compiled
        .diagnostics
        .iter()
        .filter(|diagnostic| diagnostic.severity() == Severity::Error)
        .map(|diagnostic| {
            let (line, column) = sources.line_column(diagnostic.span);
            format!("{}:{line}:{column}: {}", diagnostic.problem.code(), diagnostic.message)
        })
        .collect();
    if errors.is_empty() { Ok(compiled) } else { Err(format!("does not compile: {}", errors.join("; "))) }
}

/// A CPU in STOP with the program loaded. `modules` are the peripheral bytes that answer; `None` = all.
#[allow(dead_code)] // Some tests have settings of their own.
pub(crate) fn cpu(program: &Arc<Program>, cpu: &'static CpuType, load: Load, modules: Option<std::ops::Range<u32>>) -> Cpu {
    cpu_with(program, cpu, load, modules, Settings::default())
}

/// The same with settings.
pub(crate) fn cpu_with(
    program: &Arc<Program>,
    cpu: &'static CpuType,
    load: Load,
    modules: Option<std::ops::Range<u32>>,
    settings: Settings,
) -> Cpu {
    let rack = match modules {
        None => Rack::simulated(cpu),
        Some(bytes) => {
            let module: Box<dyn IoModule> = Box::new(SimulatedModule::new("simulated", bytes));
            Rack::with_only(cpu, vec![module]).expect("the modules of a page lie inside the peripheral area")
        }
    };
    Cpu::load(cpu, Arc::clone(program), load, rack, settings)
}

/// How a CPU is set up whose program has tasks with intervals.
#[allow(dead_code)] // Not every test that shares this file has programs with tasks.
pub(crate) fn settings(compiled: &Compiled) -> Settings {
    let tasks = compiled.intervals.iter().map(|(&number, &interval_ms)| (number, CyclicInterrupt { interval_ms, phase_ms: 0 }));
    Settings { cyclic: tasks.collect(), ..Settings::default() }
}
