//! The demo at work: a CPU with the dosing tank behind a gate, the thread that scans it, and the operator who goes along.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use sieben_cpu::{Cpu, Rack, Restart, Settings};
use sieben_jit::Jit;
use sieben_lang::symbols::{self, Format};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;
use sieben_workspace::control::{CurrentFacts, Facts};
use sieben_workspace::gate::Clock;
use sieben_workspace::pace::Missed;
use sieben_workspace::status::Desk;
use sieben_workspace::{Closed, Driver, Gate, Pace, Plant, Speed, Surroundings, duration};

use super::changes::Entry;
use super::listing::{self, Line};
use super::operator::{Action, CYCLE_US, Operator, dosing};
use super::plant::DosingTank;

/// The program that controls the plant.
const PROGRAM: &str = include_str!("../../../../examples/dosing/dosing.awl");
/// Its assignment table.
const SYMBOLS: &str = include_str!("../../../../examples/dosing/symbols.csv");
/// What those who come in from outside see as the name of the project.
const NAME: &str = "demo";

/// The demo.
pub(crate) struct Session {
    /// The way in to the CPU.
    pub(crate) gate: Arc<Gate>,
    /// Where the status of scans is asked for.
    pub(crate) desk: Arc<Desk>,
    /// What those who come in from outside know of the program.
    pub(crate) facts: Arc<CurrentFacts>,
    /// What the CPU is.
    pub(crate) cpu_type: &'static CpuType,
    /// The assignment table of the plant.
    pub(crate) symbols: SymbolTable,
    /// The statements of OB 1.
    pub(crate) lines: Vec<Line>,
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

impl Session {
    /// Compiles the program and plugs the plant into its CPU. It ends after this time of the plant.
    ///
    /// The program is a part of Sieben: one that does not compile is our own mistake.
    pub(crate) fn new(speed: Speed, time: Option<Duration>) -> Self {
        let begin = Instant::now();
        let clock = move || begin.elapsed().as_micros() as u64;
        let mut pace = Pace::new(speed, CYCLE_US, time.map_or(u64::MAX, duration::micros), clock());
        pace.missed = Missed::MadeUp;
        Self::with(pace, Box::new(clock))
    }

    fn with(pace: Pace, clock: Clock) -> Self {
        let mut sources = Sources::default();
        sources.add("dosing.awl", PROGRAM);
        let symbols = symbols::read(FileId(0), SYMBOLS, Format::Csv).table;
        let cpu_type = &CpuType::ALL[0];
        let options = sieben_lang::Options { cpu: Some(cpu_type), ..Default::default() };
        let compiled = sieben_lang::compile(&sources, &symbols, &options);
        let error = compiled.diagnostics.iter().find(|diagnostic| diagnostic.severity() == Severity::Error);
        assert!(error.is_none(), "the program of the demo compiles: {error:?}");
        let program = Arc::new(compiled.program);
        let lines = listing::lines(&sources, &program, &symbols);
        let rack = Rack::with_background(cpu_type, vec![Box::new(DosingTank::new())]).expect("one module at byte 0 fits every CPU type");
        let cpu = Cpu::load(cpu_type, Arc::clone(&program), Jit::load, rack, Settings::default());
        let operator = Mutex::new(Operator::new(&symbols, &cpu));
        let mut plant = Plant::new(cpu, pace);
        plant.stay_in_stop();
        let facts = Facts { project: Some(NAME.to_owned()), symbols: symbols.clone(), sources, program, ..Facts::default() };
        Self {
            operator,
            gate: Arc::new(Gate::new(plant, clock)),
            desk: Arc::default(),
            facts: Arc::new(CurrentFacts::new(facts)),
            cpu_type,
            symbols,
            lines,
            is_ended: AtomicBool::new(false),
        }
    }

    /// Starts the CPU and scans until the time is up or [`Self::end`]; each entry is told after the scan that made it. Then the gate is closed.
    pub(crate) fn scan(&self, tell: &mut dyn FnMut(&Entry)) {
        Driver::new(&self.gate, &self.desk, &mut Around::new(self, tell)).run(Restart::Warm);
        self.gate.close();
    }

    /// Ends the scans soon.
    pub(crate) fn end(&self) {
        self.is_ended.store(true, Ordering::Relaxed);
        self.gate.wake();
    }

    /// A user does something.
    ///
    /// # Errors
    /// The demo is over.
    pub(crate) fn act(&self, action: Action) -> Result<(), Closed> {
        self.gate.command(|plant| self.operator().act(plant, action))
    }

    /// Adds a note to what changed.
    ///
    /// # Errors
    /// The demo is over.
    pub(crate) fn note(&self, text: &str) -> Result<(), Closed> {
        self.gate.enter(|plant| self.operator().note(plant, text))
    }

    /// Comes in between two scans, to look at the CPU and at the operator.
    ///
    /// # Errors
    /// The demo is over.
    pub(crate) fn look<R>(&self, look: impl FnOnce(&Plant, &mut Operator) -> R) -> Result<R, Closed> {
        self.gate.enter(|plant| look(plant, &mut self.operator()))
    }

    /// What has been done, at the end.
    pub(crate) fn outcome(&self) -> Outcome {
        self.gate.finish(|plant| Outcome {
            scans: plant.scans,
            time_ms: self.operator().time_ms(),
            litres: dosing(&plant.cpu).tank.litres_delivered(),
        })
    }

    fn operator(&self) -> MutexGuard<'_, Operator> {
        self.operator.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// What stands around the scans: the operator, and a function that is told of entries.
struct Around<'s> {
    session: &'s Session,
    tell: &'s mut dyn FnMut(&Entry),
    /// Entries that were told.
    told: u64,
    /// When the scan began, and how many were recorded before.
    began: (Instant, u64),
}

impl<'s> Around<'s> {
    fn new(session: &'s Session, tell: &'s mut dyn FnMut(&Entry)) -> Self {
        Self { session, tell, told: 0, began: (Instant::now(), 0) }
    }
}

impl Surroundings for Around<'_> {
    fn before_scan(&mut self, plant: &mut Plant) {
        self.session.operator().before_scan(plant);
        self.began = (Instant::now(), self.session.desk.recordings());
    }

    fn after_scan(&mut self, plant: &mut Plant) {
        let (began, recordings) = self.began;
        let took = began.elapsed();
        let mut operator = self.session.operator();
        if self.session.desk.recordings() == recordings {
            operator.add_scan_time(took);
        }
        operator.after_scan(plant);
        let new = operator.changes.count - std::mem::replace(&mut self.told, operator.changes.count);
        operator.changes.newest(new as usize).for_each(|entry| (self.tell)(entry));
    }

    /// While time stands still the mode may change as well.
    fn at_point(&mut self, plant: &mut Plant) {
        self.session.operator().note_mode(plant);
    }

    fn is_ended(&self) -> bool {
        self.session.is_ended.load(Ordering::Relaxed)
    }
}

/// The demo in virtual time, scan by scan.
#[cfg(test)]
pub(crate) mod tests {
    use sieben_cpu::OperatingMode;
    use sieben_sim::devices::dosing::Button;
    use sieben_workspace::End;

    use super::super::changes::{Event, KEPT};
    use super::*;

    /// Ends the demo after so many scans.
    struct Counted<'s> {
        around: Around<'s>,
        left: u64,
    }

    impl Surroundings for Counted<'_> {
        fn before_scan(&mut self, plant: &mut Plant) {
            self.left -= 1;
            self.around.before_scan(plant);
        }
        fn after_scan(&mut self, plant: &mut Plant) {
            self.around.after_scan(plant);
        }
        fn at_point(&mut self, plant: &mut Plant) {
            self.around.at_point(plant);
        }
        fn is_ended(&self) -> bool {
            self.left == 0
        }
    }

    impl Session {
        /// A demo whose time stands still but for scans that are asked for.
        pub(crate) fn in_steps() -> Self {
            let mut pace = Pace::new(Speed::Factor(1.0), CYCLE_US, u64::MAX, 0);
            pace.missed = Missed::MadeUp;
            pace.pause(0);
            let session = Self::with(pace, Box::new(|| 0));
            session.drive(0, |driver| driver.run(Restart::Warm));
            session
        }

        fn drive(&self, scans: u64, drive: impl FnOnce(&mut Driver<'_>) -> End) {
            let tell = &mut |_: &Entry| {};
            let mut counted = Counted { around: Around::new(self, tell), left: scans };
            assert_eq!(drive(&mut Driver::new(&self.gate, &self.desk, &mut counted)), End::Ended);
            assert_eq!(counted.left, 0);
        }

        /// So many scans, in this thread.
        pub(crate) fn steps(&self, scans: u64) {
            self.gate.enter(|plant| plant.pace.step(scans, 0)).expect("the gate is open");
            self.drive(scans, |driver| driver.go_on());
        }

        pub(crate) fn seconds(&self, seconds: u64) {
            self.steps(seconds * 1_000_000 / CYCLE_US);
        }

        fn of<R>(&self, look: impl FnOnce(&Plant, &mut Operator) -> R) -> R {
            self.look(look).expect("the gate is open")
        }

        fn tank<R>(&self, look: impl FnOnce(&DosingTank) -> R) -> R {
            self.of(|plant, _| look(dosing(&plant.cpu)))
        }

        fn notes(&self) -> Vec<String> {
            let note = |entry: &Arc<Entry>| match &entry.event {
                Event::Note(text) => Some(text.clone()),
                Event::Change { .. } => None,
            };
            self.of(|_, operator| operator.changes.newest(KEPT).filter_map(note).collect())
        }
    }

    #[test]
    fn the_assignment_table_of_the_plant_is_without_fault() {
        assert_eq!(symbols::read(FileId(0), SYMBOLS, Format::Csv).diagnostics, []);
    }

    #[test]
    fn the_story_doses_25_litres_without_a_key() {
        let session = Session::in_steps();
        session.seconds(4);
        assert!(session.tank(|dosing| dosing.tank.valve_open()));
        let valve = |operator: &Operator| {
            let at = operator.changes.watched.iter().position(|watched| watched.address == "Q 0.0");
            at.map(|at| operator.changes.values[at])
        };
        assert_eq!(session.of(|_, operator| valve(operator)), Some(1));
        session.seconds(10);
        assert!(!session.tank(|dosing| dosing.tank.valve_open()));
        let delivered = session.tank(|dosing| dosing.tank.litres_delivered());
        assert!((25.0..25.2).contains(&delivered), "{delivered}");
        assert_eq!(session.notes()[0], "the demo presses START");
    }

    #[test]
    fn an_hour_of_the_plant_needs_no_more_memory_than_a_minute() {
        let session = Session::in_steps();
        session.seconds(3_600);
        session.of(|plant, operator| {
            assert_eq!(plant.scans, 360_000);
            assert_eq!(operator.changes.newest(usize::MAX).count(), KEPT);
            assert!(operator.changes.room() <= 2 * KEPT);
            assert!(operator.changes.count > 10_000, "{}", operator.changes.count);
            assert!(plant.cpu.diagnostic_buffer().entries().len() <= 100);
            assert_eq!(plant.cpu.mode(), OperatingMode::Run);
        });
    }

    #[test]
    fn stop_closes_the_valve_and_clears_the_display() {
        let session = Session::in_steps();
        session.act(Action::Push(Button::Start)).expect("the gate is open");
        session.seconds(2);
        assert!(session.tank(|dosing| dosing.tank.valve_open() && dosing.tank.display() > 0));
        session.act(Action::Push(Button::Stop)).expect("the gate is open");
        session.seconds(1);
        assert!(!session.tank(|dosing| dosing.tank.valve_open()));
        assert_eq!(session.tank(|dosing| dosing.tank.display()), 0);
    }

    #[test]
    fn without_the_flow_meter_the_container_overflows_and_the_demo_recovers() {
        let session = Session::in_steps();
        session.act(Action::Meter).expect("the gate is open");
        session.act(Action::Push(Button::Start)).expect("the gate is open");
        session.seconds(15);
        assert!(session.tank(|dosing| dosing.tank.spilled_litres()) > 0.0);
        assert!(session.notes().contains(&"the container overflows!".to_owned()));
        session.seconds(120);
        assert!(!session.tank(|dosing| dosing.meter_failed));
    }

    #[test]
    fn a_cpu_in_stop_closes_the_valve_and_its_plant_lives_on() {
        let session = Session::in_steps();
        session.seconds(5);
        let before = session.of(|plant, operator| (plant.scans, operator.time_ms()));
        session.act(Action::Mode).expect("the gate is open");
        session.seconds(5);
        let (mode, scans, time_ms) = session.of(|plant, operator| (plant.cpu.mode(), plant.scans, operator.time_ms()));
        assert_eq!((mode, scans, time_ms), (OperatingMode::Stop, before.0, before.1 + 5_000));
        assert!(!session.tank(|dosing| dosing.tank.valve_open()));
        assert!(session.notes().iter().any(|note| note.ends_with("l leaves")), "{:?}", session.notes());
        session.act(Action::Mode).expect("the gate is open");
        session.seconds(1);
        assert_eq!(session.of(|plant, _| plant.cpu.mode()), OperatingMode::Run);
        let notes = session.notes();
        let modes: Vec<&str> = notes.iter().map(String::as_str).filter(|note| note.starts_with("CPU")).collect();
        assert_eq!(modes, ["CPU in STOP", "CPU in RUN"]);
    }

    #[test]
    fn the_same_keys_at_the_same_scans_make_the_same_demo() {
        let run = || {
            let session = Session::in_steps();
            for (seconds, action) in
                [(2, Action::Push(Button::Start)), (7, Action::Meter), (30, Action::Mode), (1, Action::Mode), (40, Action::Story)]
            {
                session.seconds(seconds);
                session.act(action).expect("the gate is open");
            }
            session.seconds(60);
            session.of(|_, operator| operator.changes.newest(KEPT).map(|entry| (**entry).clone()).collect::<Vec<_>>())
        };
        assert_eq!(run(), run());
    }
}
