//! The demo at work: the dosing example on a CPU behind a gate, the thread that scans it, and its operator.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use sieben_cpu::Restart;
use sieben_jit::Jit;
use sieben_model::cpu_type::CpuType;
use sieben_model::symbols::SymbolTable;
use sieben_workspace::control::{CurrentFacts, Facts, watched};
use sieben_workspace::exchange::{Next, exchange};
use sieben_workspace::finding;
use sieben_workspace::gate::Clock;
use sieben_workspace::observed::{Event, Observer};
use sieben_workspace::pace::Missed;
use sieben_workspace::project::{Build, Overrides};
use sieben_workspace::status::Desk;
use sieben_workspace::{Closed, Driver, Gate, Pace, Plant, Refusal, Speed, Surroundings, controller, duration};

use super::operator::{CYCLE_US, Operator, litres};
use super::plain;
use super::state::Story;
use crate::chosen::{self, Change, Choice, Chosen};
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
    /// The example that runs, which the page may change.
    pub(crate) chosen: Arc<Chosen>,
    /// Only looked at inside of the gate, so that a scan never waits for it.
    operator: Mutex<Operator>,
    is_ended: AtomicBool,
}

/// The end of a demo: how much was done.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    /// The example that ran last.
    pub(crate) example: &'static str,
    /// Scans of the program.
    pub(crate) scans: u64,
    /// The time of the plant in milliseconds.
    pub(crate) time_ms: u64,
    /// What has run through the valve, where the plant has one.
    pub(crate) litres: Option<f64>,
}

/// The project of an example, compiled. It is a part of Sieben: one that does not compile is our own mistake.
pub(crate) fn example(name: &str) -> Build {
    let example = Example::by_name(name).expect("the examples come with Sieben");
    let build = example.project().compile(Overrides::default(), false);
    assert!(!finding::has_errors(&build.findings), "the example `{name}` compiles");
    build
}

/// The CPU of another example, as the demo has it.
fn prepare(example: &'static Example) -> Result<Change, Refusal> {
    let build = chosen::build(example, Overrides::default())?;
    let cpu = controller::load(&build, Jit::load, controller::settings(&build));
    let facts = Facts::of(&build, cpu.program());
    Ok(Change { example, build, next: Next { cpu, facts, cycle_us: CYCLE_US } })
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
        // A demo that ends by itself is one of this plant.
        let ends = plant.pace.end_us != u64::MAX;
        plant.stay_in_stop();
        plant.switch_on(Restart::Warm);
        let gate = Arc::new(Gate::new(plant, clock));
        let choice = match Example::by_name(EXAMPLE) {
            Some(example) if !ends => Choice::Examples(example),
            _ => Choice::Alone(NAME.to_owned()),
        };
        Self {
            operator: Mutex::new(Operator::new(Arc::clone(&story))),
            chosen: Arc::new(Chosen::new(choice, None, &gate, Box::new(prepare))),
            gate,
            desk: Arc::default(),
            facts: Arc::new(CurrentFacts::new(facts)),
            cpu_type: build.cpu,
            symbols: build.project.symbols,
            story,
            is_ended: AtomicBool::new(false),
        }
    }

    /// Starts the CPU and scans until the time is up or [`Self::end`]; `print` gets a line for each change after the scan that made it. Then the
    /// gate is closed.
    pub(crate) fn scan<'s>(&'s self, print: Option<Print<'s>>) {
        Driver::new(&self.gate, &self.desk, &mut Around::new(self, print)).go_on();
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
        let example = self.chosen.example().map_or(EXAMPLE, |example| example.name);
        self.gate.finish(|plant| Outcome { example, scans: plant.scans, time_ms: self.operator().time_us() / 1_000, litres: litres(plant) })
    }

    fn operator(&self) -> MutexGuard<'_, Operator> {
        self.operator.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Prints a line.
type Print<'p> = &'p mut (dyn FnMut(&str) + 'p);

/// What stands around the scans: the operator, and what prints the changes that it finds.
struct Around<'s> {
    demo: &'s Demo,
    changes: Option<(Print<'s>, Observer)>,
}

impl<'s> Around<'s> {
    fn new(demo: &'s Demo, print: Option<Print<'s>>) -> Self {
        Self { changes: print.map(|print| (print, Observer::new(watched(&demo.facts.facts())))), demo }
    }
}

impl Surroundings for Around<'_> {
    fn exchange(&mut self, plant: &mut Plant) {
        let Some(Change { example, next, .. }) = self.demo.chosen.take() else { return };
        let Demo { gate, desk, facts, story, .. } = self.demo;
        exchange(plant, next, (desk, facts), gate.now_us());
        plant.cpu.measure_blocks();
        story.user_acted.store(false, Ordering::Relaxed);
        *self.demo.operator() = Operator::new(Arc::clone(story));
        if let Some((_, observer)) = &mut self.changes {
            *observer = Observer::new(watched(&facts.facts()));
        }
        desk.observed.note(plant, format!("the example `{}` runs now", example.name));
        self.demo.chosen.took(example);
    }

    fn before_scan(&mut self, plant: &mut Plant) {
        self.demo.operator().before_scan(plant);
        // The first look is at what was before the first scan.
        if plant.scans == 0
            && let Some((_, observer)) = &mut self.changes
        {
            observer.observe(&plant.cpu, 0, &mut |_| {});
        }
    }

    fn after_scan(&mut self, plant: &mut Plant) {
        let mut operator = self.demo.operator();
        operator.after_scan(plant);
        let (time_us, notes) = (operator.time_us(), operator.take_notes());
        drop(operator);
        if let Some((print, observer)) = &mut self.changes {
            let notes = notes.iter().map(|note| plain::line(plant, time_us, &Event::Note(note.clone())));
            plain::changed(observer, plant, time_us).into_iter().chain(notes).for_each(|line| print(&line));
        }
        notes.into_iter().for_each(|note| self.demo.desk.observed.note(plant, note));
    }

    fn is_ended(&self) -> bool {
        self.demo.is_ended.load(Ordering::Relaxed)
    }
}

/// The demo in virtual time, scan by scan.
#[cfg(test)]
mod tests {
    use std::thread;

    use sieben_cpu::{OperatingMode, Station};
    use sieben_model::address::Area;
    use sieben_model::item::Item;
    use sieben_model::value::Value;
    use sieben_sim::wrap::{self, Fault};
    use sieben_workspace::End;
    use sieben_workspace::observed::{ENTRIES_MAX, Entry};

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
        fn is_ended(&self) -> bool {
            self.left == 0
        }
    }

    impl Demo {
        /// A demo whose time stands still but for scans that are asked for; what changes is kept.
        fn in_steps() -> Self {
            let mut pace = Pace::new(Speed::Factor(1.0), CYCLE_US, u64::MAX, 0);
            pace.missed = Missed::MadeUp;
            pace.pause(0);
            let demo = Self::with(pace, Box::new(|| 0));
            demo.desk.observed.look(0, || watched(&demo.facts.facts()), 0);
            demo.drive(0, |driver| driver.go_on());
            demo
        }

        fn drive(&self, scans: u64, drive: impl FnOnce(&mut Driver<'_>) -> End) {
            let mut counted = Counted { around: Around::new(self, None), left: scans };
            assert_eq!(drive(&mut Driver::new(&self.gate, &self.desk, &mut counted)), End::Ended);
            assert_eq!(counted.left, 0);
        }

        /// So many seconds of scans, in this thread.
        fn seconds(&self, seconds: u64) {
            let scans = seconds * 1_000_000 / CYCLE_US;
            self.of(|plant| plant.pace.step(scans, 0));
            self.drive(scans, |driver| driver.go_on());
        }

        fn of<R>(&self, look: impl FnOnce(&mut Plant) -> R) -> R {
            self.gate.enter(look).expect("the gate is open")
        }

        fn value(&self, name: &str) -> f64 {
            self.of(|plant| wrap::plants(plant.cpu.rack()).next().and_then(|plant| plant.device().value(name)).expect("it is there"))
        }

        fn is_open(&self) -> bool {
            self.of(|plant| wrap::plants(plant.cpu.rack()).any(|plant| plant.commands()[0] & 1 != 0))
        }

        /// Sets an input of the buttons.
        fn set(&self, mask: u8, value: u8) {
            self.story.user_acted.store(true, Ordering::Relaxed);
            assert!(self.of(|plant| plant.cpu.rack_mut().set_input(0, mask, value)));
        }

        fn notes(&self) -> Vec<String> {
            let note = |entry: Entry| match entry.event {
                Event::Note(text) => Some(text),
                Event::Change { .. } => None,
            };
            self.desk.observed.newer_than(0).1.into_iter().filter_map(note).collect()
        }
    }

    #[test]
    fn the_story_doses_25_litres_without_a_key() {
        let demo = Demo::in_steps();
        demo.seconds(4);
        assert!(demo.is_open());
        demo.seconds(10);
        assert!(!demo.is_open());
        let delivered = demo.value("delivered");
        assert!((25.0..25.2).contains(&delivered), "{delivered}");
        assert_eq!(demo.notes()[0], "the demo presses START");
    }

    #[test]
    fn an_hour_of_the_plant_needs_no_more_memory_than_a_minute() {
        let demo = Demo::in_steps();
        demo.seconds(3_600);
        let (count, kept) = demo.desk.observed.newer_than(0);
        assert!(kept.len() == ENTRIES_MAX && count > 10_000, "{count}");
        demo.of(|plant| {
            assert_eq!((plant.scans, plant.cpu.mode()), (360_000, OperatingMode::Run));
            assert!(plant.cpu.diagnostic_buffer().entries().len() <= 100);
        });
    }

    #[test]
    fn without_the_flow_meter_the_container_overflows_and_the_demo_recovers() {
        let demo = Demo::in_steps();
        let fault = Fault::parse("plant.flow stuck=0").expect("a fault");
        demo.of(|plant| wrap::inject(plant.cpu.rack_mut(), &fault)).expect("it fits");
        demo.set(1, 1);
        demo.seconds(1);
        demo.set(1, 0);
        demo.seconds(14);
        assert!(demo.value("spilled") > 0.0);
        assert!(demo.notes().contains(&"the container overflows!".to_owned()));
        demo.seconds(130);
        assert_eq!(demo.of(|plant| wrap::plants(plant.cpu.rack()).map(|plant| plant.faults().count()).sum::<usize>()), 0);
    }

    #[test]
    fn a_cpu_in_stop_closes_the_valve_and_its_plant_lives_on() {
        let demo = Demo::in_steps();
        demo.seconds(5);
        let scans = demo.of(|plant| plant.scans);
        demo.of(|plant| plant.stop(sieben_cpu::Requester::default()));
        demo.seconds(5);
        assert_eq!(demo.of(|plant| (plant.cpu.mode(), plant.scans)), (OperatingMode::Stop, scans));
        assert!(!demo.is_open());
        assert!(demo.notes().iter().any(|note| note.ends_with("l leaves")), "{:?}", demo.notes());
        demo.of(|plant| plant.ask_for_start(Restart::Warm, sieben_cpu::Requester::default()));
        demo.seconds(1);
        let notes = demo.notes();
        let modes: Vec<&str> = notes.iter().map(String::as_str).filter(|note| note.starts_with("CPU")).collect();
        assert_eq!(modes, ["CPU in STOP", "CPU in RUN"]);
    }

    #[test]
    fn a_user_is_left_alone_and_a_story_that_is_off_stays_so() {
        let demo = Demo::in_steps();
        demo.seconds(1);
        demo.set(0, 0);
        demo.seconds(15);
        assert!(demo.notes().is_empty(), "{:?}", demo.notes());
        demo.seconds(8);
        assert_eq!(demo.notes()[0], "the demo presses START");
        demo.story.is_on.store(false, Ordering::Relaxed);
        demo.seconds(60);
        assert_eq!(demo.notes().iter().filter(|note| note.contains("presses")).count(), 1);
    }

    #[test]
    fn who_comes_before_the_first_scan_waits_for_it() {
        let demo = Demo::new(Speed::Factor(1.0), None);
        let stop = Item::area(Area::Input, 0, 1);
        thread::scope(|scope| {
            let early =
                scope.spawn(|| demo.gate.look(|plant| (plant.scans > 0, plant.cpu.read_items(std::slice::from_ref(&stop)).remove(0))));
            // Time for it to come to the gate; if it comes later, it finds the same.
            thread::sleep(Duration::from_millis(30));
            scope.spawn(|| demo.scan(None));
            let seen = early.join().expect("it comes in");
            demo.end();
            assert_eq!(seen, Ok((true, Ok(Value::bytes([2])))), "STOP is a contact that opens");
        });
    }

    #[test]
    fn the_same_keys_at_the_same_scans_make_the_same_demo() {
        let run = || {
            let demo = Demo::in_steps();
            for (seconds, (mask, value)) in [(2, (1, 1)), (1, (1, 0)), (7, (2, 0)), (1, (2, 2)), (40, (1, 1))] {
                demo.seconds(seconds);
                demo.set(mask, value);
            }
            demo.seconds(60);
            demo.desk.observed.newer_than(0).1
        };
        assert_eq!(run(), run());
    }
}
