//! The demo at work: the dosing example on a CPU behind a gate, the thread that scans it, and the operator who goes along.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use sieben_cpu::Restart;
use sieben_jit::Jit;
use sieben_model::cpu_type::CpuType;
use sieben_model::symbols::SymbolTable;
use sieben_workspace::control::{CurrentFacts, Facts, watched};
use sieben_workspace::finding;
use sieben_workspace::gate::Clock;
use sieben_workspace::observed::{Entry, Event, Observer};
use sieben_workspace::pace::Missed;
use sieben_workspace::project::{Build, Overrides, Project};
use sieben_workspace::status::Desk;
use sieben_workspace::{Closed, Driver, Gate, Pace, Plant, Speed, Surroundings, controller, duration};

use super::operator::{CYCLE_US, Operator, litres};
use super::state::Story;
use crate::examples::Example;

/// The example that the demo runs.
const EXAMPLE: &str = "dosing";
/// What those who come in from outside see as the name of the project.
const NAME: &str = "demo";

/// The demo.
pub(crate) struct Demo {
    /// The way in to the CPU.
    pub(crate) gate: Arc<Gate>,
    /// Where the status of scans and what changed is asked for.
    pub(crate) desk: Arc<Desk>,
    /// What those who come in from outside know of the program.
    pub(crate) facts: Arc<CurrentFacts>,
    /// What the CPU is.
    pub(crate) cpu_type: &'static CpuType,
    /// The assignment table of the plant.
    pub(crate) symbols: SymbolTable,
    /// The story that the operator follows.
    pub(crate) story: Arc<Story>,
    /// Only looked at inside of the gate, so that a scan never waits for it.
    operator: Mutex<Operator>,
    is_ended: AtomicBool,
}

/// The end of a demo: how much was done.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    /// Scans of the program.
    pub(crate) scans: u64,
    /// The time of the plant in milliseconds.
    pub(crate) time_ms: u64,
    /// What has run through the valve.
    pub(crate) litres: f64,
}

/// The project of an example, compiled. It is a part of Sieben: one that does not compile is our own mistake.
pub(crate) fn example(name: &str) -> Build {
    let example = Example::by_name(name).expect("the examples come with Sieben");
    let mut project = Project::new(None);
    for (path, content) in example.files {
        let path = Path::new(path);
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("toml") => project.add_settings(path, content.as_bytes()),
            Some("csv") => project.add_symbols(path, content.as_bytes()).expect("an example has a small table"),
            Some("awl" | "scl" | "st") if !path.to_string_lossy().contains(".test.") => project.add_source(path, content.as_bytes()),
            _ => {}
        }
    }
    let build = project.compile(Overrides::default(), false);
    assert!(!finding::has_errors(&build.findings), "the example `{name}` compiles");
    build
}

impl Demo {
    /// Compiles the program and plugs the plant into its CPU. It ends after this time of the plant.
    pub(crate) fn new(speed: Speed, time: Option<Duration>) -> Self {
        let begin = Instant::now();
        let clock = move || begin.elapsed().as_micros() as u64;
        let mut pace = Pace::new(speed, CYCLE_US, time.map_or(u64::MAX, duration::micros), clock());
        pace.missed = Missed::MadeUp;
        Self::with(pace, Box::new(clock))
    }

    fn with(pace: Pace, clock: Clock) -> Self {
        let build = example(EXAMPLE);
        let cpu = controller::load(&build, Jit::load, controller::settings(&build));
        let facts = Facts { project: Some(NAME.to_owned()), ..Facts::of(&build, cpu.program()) };
        let story = Arc::new(Story::default());
        let mut plant = Plant::new(cpu, pace);
        plant.stay_in_stop();
        Self {
            operator: Mutex::new(Operator::new(Arc::clone(&story))),
            gate: Arc::new(Gate::new(plant, clock)),
            desk: Arc::default(),
            facts: Arc::new(CurrentFacts::new(facts)),
            cpu_type: build.cpu,
            symbols: build.project.symbols,
            story,
            is_ended: AtomicBool::new(false),
        }
    }

    /// Starts the CPU and scans until the time is up or [`Self::end`]; where `tell` wants it, each change is told after the scan that made it. Then
    /// the gate is closed.
    pub(crate) fn scan<'s>(&'s self, tell: Option<Tell<'s>>) {
        Driver::new(&self.gate, &self.desk, &mut Around::new(self, tell)).run(Restart::Warm);
        self.gate.close();
    }

    /// Ends the scans soon.
    pub(crate) fn end(&self) {
        self.is_ended.store(true, Ordering::Relaxed);
        self.gate.wake();
    }

    /// Adds a note to what changed.
    ///
    /// # Errors
    /// The demo is over.
    pub(crate) fn note(&self, text: &str) -> Result<(), Closed> {
        self.gate.enter(|plant| self.desk.observed.note(plant, text))
    }

    /// What has been done, at the end.
    pub(crate) fn outcome(&self) -> Outcome {
        self.gate.finish(|plant| Outcome { scans: plant.scans, time_ms: self.operator().time_us() / 1_000, litres: litres(plant) })
    }

    fn operator(&self) -> MutexGuard<'_, Operator> {
        self.operator.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Is told of changes.
type Tell<'t> = &'t mut (dyn FnMut(&Entry) + 't);

/// What stands around the scans: the operator, and a function that is told of changes.
struct Around<'s> {
    demo: &'s Demo,
    tell: Option<(Tell<'s>, Observer)>,
    told: u64,
}

impl<'s> Around<'s> {
    fn new(demo: &'s Demo, tell: Option<Tell<'s>>) -> Self {
        Self { tell: tell.map(|tell| (tell, Observer::new(watched(&demo.facts.facts())))), demo, told: 0 }
    }

    fn tell(&mut self, plant: &Plant, time_us: u64, event: Event) {
        if let Some((tell, _)) = &mut self.tell {
            self.told += 1;
            tell(&Entry { number: self.told, scan: plant.scans, time_us, event });
        }
    }
}

impl Surroundings for Around<'_> {
    fn before_scan(&mut self, plant: &mut Plant) {
        self.demo.operator().before_scan(plant);
        // The first look is at what was before the first scan.
        if plant.scans == 0
            && let Some((_, observer)) = &mut self.tell
        {
            observer.observe(&plant.cpu, 0, &mut |_| {});
        }
    }

    fn after_scan(&mut self, plant: &mut Plant) {
        let mut operator = self.demo.operator();
        operator.after_scan(plant);
        let (time_us, notes) = (operator.time_us(), operator.take_notes());
        drop(operator);
        let mut events = Vec::new();
        if let Some((_, observer)) = &mut self.tell {
            observer.observe(&plant.cpu, time_us, &mut |event| events.push(event));
        }
        events.into_iter().for_each(|event| self.tell(plant, time_us, event));
        for note in notes {
            self.demo.desk.observed.note(plant, note.clone());
            self.tell(plant, time_us, Event::Note(note));
        }
    }

    fn is_ended(&self) -> bool {
        self.demo.is_ended.load(Ordering::Relaxed)
    }
}
