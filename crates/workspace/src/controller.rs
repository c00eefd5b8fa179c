//! From a compiled project to a CPU that can be started.

use std::sync::Arc;

use serde_json::{Value, json};
use sieben_cpu::{Cpu, CyclicInterrupt, Loaded, Rack, Settings, StopCause};
use sieben_engine::{Engine, FaultPlace, Layout, Program};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Span;

use crate::project::Build;
use crate::settings::modules;

/// How the project sets up its CPU; what is not said is as usual.
pub fn settings(build: &Build) -> Settings {
    let project = &build.project.settings;
    let usual = Settings::default();
    // The project file has the last word about how often the tasks of a CONFIGURATION run.
    let tasks = build.compiled.intervals.iter().map(|(&number, &interval_ms)| (number, CyclicInterrupt { interval_ms, phase_ms: 0 }));
    let cyclic = tasks.chain(project.cyclic.iter().map(|(&number, &cyclic)| (number, cyclic))).collect();
    Settings {
        watchdog: project.watchdog.unwrap_or(usual.watchdog),
        clock_memory_byte: project.clock_memory_byte,
        retain: project.retain.areas(),
        cyclic,
        min_cycle: project.min_cycle.unwrap_or_default(),
        image_errors: project.image_errors.unwrap_or(usual.image_errors),
        ..usual
    }
}

/// The modules of the project, and a simulated one at every address that they leave free.
pub fn rack(build: &Build) -> Rack {
    modules::rack(&build.project.settings.modules, build.cpu)
}

/// The program as CPUs take it, any number of them. `engine` makes it run: the interpreter, or machine code, which is not known here.
pub fn loaded(build: &Build, engine: impl FnOnce(&Program, &Layout) -> Arc<dyn Engine>) -> Loaded {
    let program = Arc::new(build.compiled.program.clone());
    Loaded::new(build.cpu, program, engine)
}

/// Bytes of local data that blocks of tests and campaigns have beside those of the CPU type: what they need must not fail a program that
/// fits.
const LOCAL_DATA: u32 = 32 * 1024;
/// Levels of nesting that they take: the one that the CPU starts, and SETUP or the test itself.
const NESTING: u8 = 2;

/// The CPU type with room for the blocks of a test or a campaign beside the program.
pub fn with_room(cpu: &CpuType) -> &'static CpuType {
    // A CPU type lives as long as the process; there are no more of them than test files and programs of a campaign.
    Box::leak(Box::new(CpuType {
        local_data: cpu.local_data.saturating_add(LOCAL_DATA),
        nesting_depth: cpu.nesting_depth.saturating_add(NESTING),
        ..*cpu
    }))
}

/// A CPU in STOP with the program loaded and the rack of the project.
pub fn load(build: &Build, engine: impl FnOnce(&Program, &Layout) -> Arc<dyn Engine>, settings: Settings) -> Cpu {
    Cpu::new(loaded(build, engine), rack(build), settings)
}

/// Why the CPU stopped, with the line of the source that did it.
pub fn stop_text(build: &Build, cause: &StopCause) -> String {
    let mut text = format!("The CPU went to STOP: {}\n", named(build, &cause.text, cause.place));
    if let Some(Line { file, number, statement }) = stop_line(build, cause) {
        text.push_str(&format!("  {file}:{number}:  {statement}\n"));
    }
    text.push_str(&format!("  event 16#{:04X}", cause.event));
    if cause.first_event != cause.event {
        text.push_str(&format!(", first cause 16#{:04X}", cause.first_event));
    }
    text.push('\n');
    text
}

/// A line of a source with its statement.
pub struct Line {
    /// The name of the source.
    pub file: String,
    /// The line, counted from 1.
    pub number: usize,
    /// The statement that caused something.
    pub statement: String,
}

/// The line that stopped the CPU.
pub fn stop_line(build: &Build, cause: &StopCause) -> Option<Line> {
    line_at(build, cause.place?)
}

/// The place of a statement in the sources; `None` for one that the compiler made.
pub fn span_at(build: &Build, place: FaultPlace) -> Option<Span> {
    let span = *build.compiled.program.code.get(&place.block)?.spans.get(place.statement as usize)?;
    build.project.texts.program.iter().any(|(id, _)| id == span.file).then_some(span)
}

/// What people call a block of ST: it has a name, and mostly a number that only the compiler gave it. Nothing for blocks of STL.
pub fn name_in_source(build: &Build, block: BlockId) -> Option<&str> {
    let is_called_by_name = build.compiled.bodies.get(&block).is_some_and(|body| body.is_called_by_name());
    build.compiled.block_names.get(&block).filter(|_| is_called_by_name).map(String::as_str)
}

/// What people call a block.
pub fn block_text(build: &Build, block: BlockId) -> String {
    name_in_source(build, block).map_or_else(|| block.to_string(), |name| format!("`{name}`"))
}

/// What people call the place of a statement.
pub fn place_text(build: &Build, place: FaultPlace) -> String {
    let named = name_in_source(build, place.block);
    named.map_or_else(|| sieben_cpu::diagnostic_buffer::place_text(place), |name| format!("in `{name}`"))
}

/// What the CPU tells of something that happened at a statement, with the place as people call it: the CPU knows no names.
pub fn named(build: &Build, text: &str, place: Option<FaultPlace>) -> String {
    let Some(place) = place.filter(|place| name_in_source(build, place.block).is_some()) else { return text.to_owned() };
    text.replace(&sieben_cpu::diagnostic_buffer::place_text(place), &place_text(build, place))
}

/// The line of a statement.
pub fn line_at(build: &Build, place: FaultPlace) -> Option<Line> {
    let span = span_at(build, place)?;
    let sources = &build.project.texts.program;
    let (line, _) = sources.line_column(span);
    let statement = sources.slice(span).split_whitespace().collect::<Vec<_>>().join(" ");
    Some(Line { file: sources.file(span.file).name.clone(), number: line, statement })
}

/// The stop with its first cause; statements are counted from 1, as people do.
pub fn stop_json(cause: &StopCause) -> Value {
    json!({
        "event": format!("16#{:04X}", cause.first_event),
        "block": cause.place.map(|place| place.block.to_string()),
        "statement": cause.place.map(|place| u64::from(place.statement) + 1),
        "text": cause.text,
    })
}
