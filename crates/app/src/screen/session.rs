//! The demo without its screen: CPU, plant, operator and story, driven by time and actions.

use std::sync::Arc;

use sieben_cpu::{Cpu, OperatingMode, Rack, Restart, Settings, Station};
use sieben_engine::Program;
use sieben_jit::Jit;
use sieben_lang::symbols::{self, Format};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;
use sieben_sim::devices::dosing::Button;

use super::changes::{Changes, Entry, Event};
use super::listing::{self, Line, Seen, Watch};
use super::plant::Plant;

/// The program that controls the plant.
const PROGRAM: &str = include_str!("../../../../examples/dosing/dosing.awl");
/// Its assignment table.
const SYMBOLS: &str = include_str!("../../../../examples/dosing/symbols.csv");

/// Time from one start of OB 1 to the next.
pub(crate) const CYCLE_US: u64 = 10_000;
/// How long a pushed button stays pressed.
const PUSH_US: u64 = 400_000;
/// A full container is exchanged this long after the valve has closed.
const EXCHANGE_US: u64 = 1_500_000;
/// The story presses START when nothing has moved for this long.
const STORY_US: u64 = 3_000_000;
/// After a key of the user, the story waits this long before it goes on by itself.
const USER_US: u64 = 20_000_000;
/// The tank is filled again below this level, while the valve is closed.
const REFILL_LITRES: f64 = 30.0;

/// What a user or the story does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Action {
    /// Pushes a button and lets it go.
    Push(Button),
    /// Presses a button until the same action releases it.
    Hold(Button),
    /// Lets the flow meter fail, or mends it.
    Meter,
    /// Turns the mode switch of the CPU.
    Mode,
    /// Switches the story on or off.
    Story,
}

/// The running demo.
pub(crate) struct Session {
    cpu: Cpu,
    symbols: SymbolTable,
    /// The statements of OB 1.
    pub(crate) lines: Vec<Line>,
    /// What they saw in the last traced scan.
    watch: Watch,
    /// What changed.
    pub(crate) changes: Changes,
    /// Whether the story presses START by itself.
    pub(crate) story: bool,
    now_us: u64,
    scans: u64,
    /// When a pushed button is released: START, STOP.
    release_us: [Option<u64>; 2],
    /// Since when the valve is closed and nothing happens.
    idle_since_us: u64,
    /// When the user last did something.
    user_us: Option<u64>,
    exchange_us: Option<u64>,
    spilling: bool,
    mode: OperatingMode,
}

impl Session {
    /// Compiles the program and starts the CPU with the plant.
    ///
    /// The program is a part of Sieben: one that does not compile is our own mistake.
    pub(crate) fn new() -> Self {
        let mut sources = Sources::default();
        sources.add("dosing.awl", PROGRAM);
        let symbols = symbols::read(FileId(0), SYMBOLS, Format::Csv).table;
        let cpu_type = &CpuType::ALL[0];
        let options = sieben_lang::Options { cpu: Some(cpu_type), ..Default::default() };
        let compiled = sieben_lang::compile(&sources, &symbols, &options);
        let error = compiled.diagnostics.iter().find(|diagnostic| diagnostic.severity() == Severity::Error);
        assert!(error.is_none(), "the program of the demo compiles: {error:?}");
        Self::start(cpu_type, compiled.program, symbols, &sources)
    }

    fn start(cpu_type: &'static CpuType, program: Program, symbols: SymbolTable, sources: &Sources) -> Self {
        let program = Arc::new(program);
        let rack = Rack::with_background(cpu_type, vec![Box::new(Plant::new())]).expect("one module at byte 0 fits every CPU type");
        let mut cpu = Cpu::load(cpu_type, Arc::clone(&program), Jit::load, rack, Settings::default());
        cpu.restart(Restart::Warm);
        Self {
            lines: listing::lines(sources, &program, &symbols),
            changes: Changes::new(&symbols, &cpu),
            mode: cpu.mode(),
            cpu,
            symbols,
            watch: Watch::default(),
            story: true,
            now_us: 0,
            scans: 0,
            release_us: [None, None],
            idle_since_us: 0,
            user_us: None,
            exchange_us: None,
            spilling: false,
        }
    }

    /// The assignment table of the plant.
    pub(crate) fn symbols(&self) -> &SymbolTable {
        &self.symbols
    }

    /// The CPU.
    pub(crate) fn cpu(&self) -> &Cpu {
        &self.cpu
    }

    /// The plant.
    pub(crate) fn plant(&self) -> &Plant {
        self.cpu.rack().module().expect("the plant was plugged in at the start")
    }

    /// Scans since the beginning.
    pub(crate) fn scans(&self) -> u64 {
        self.scans
    }

    /// The time of the plant in milliseconds.
    pub(crate) fn time_ms(&self) -> u64 {
        self.now_us / 1_000
    }

    /// What a statement saw in the last traced scan.
    pub(crate) fn seen(&self, statement: u32) -> Option<Seen> {
        self.watch.seen.get(statement as usize).copied().flatten()
    }

    /// Seconds until the story presses START; `None` if it will not.
    pub(crate) fn seconds_to_story(&self) -> Option<u64> {
        Some(self.story_due_us()?.saturating_sub(self.now_us).div_ceil(1_000_000))
    }

    /// A user does something.
    pub(crate) fn act(&mut self, action: Action) {
        self.user_us = Some(self.now_us);
        match action {
            Action::Push(button) => self.push(button),
            Action::Hold(button) => {
                self.release_us[index(button)] = None;
                self.plant_mut().tank.toggle(button);
            }
            Action::Meter => self.switch_meter(),
            Action::Mode if self.cpu.mode() == OperatingMode::Run => Station::stop(&mut self.cpu),
            Action::Mode => {
                Station::restart(&mut self.cpu, Restart::Warm);
            }
            Action::Story => {
                self.story = !self.story;
                self.user_us = None;
                self.idle_since_us = self.now_us;
            }
        }
        self.note_mode();
    }

    /// One scan, and everything around it. With `traced`, what each statement sees is noted.
    pub(crate) fn scan(&mut self, traced: bool) {
        self.now_us += CYCLE_US;
        self.release_buttons();
        if traced {
            self.watch.seen.fill(None);
            self.cpu.scan_traced(self.now_us, &mut self.watch);
        } else {
            self.cpu.scan(self.now_us);
        }
        // In STOP no scan runs, but the plant lives on.
        if self.cpu.mode() == OperatingMode::Run {
            self.scans += 1;
        }
        self.changes.observe(&self.cpu, self.scans, self.now_us / 1_000);
        self.note_mode();
        self.look_after_plant();
        self.tell_story();
    }

    fn plant_mut(&mut self) -> &mut Plant {
        self.cpu.rack_mut().module_mut().expect("the plant was plugged in at the start")
    }

    fn note(&mut self, text: impl Into<String>) {
        self.changes.push(Entry { scan: self.scans, time_ms: self.now_us / 1_000, event: Event::Note(text.into()) });
    }

    fn note_mode(&mut self) {
        let mode = self.cpu.mode();
        if mode != self.mode {
            self.mode = mode;
            self.note(format!("CPU in {mode}"));
        }
    }

    fn push(&mut self, button: Button) {
        self.release_us[index(button)] = Some(self.now_us + PUSH_US);
        self.plant_mut().tank.press(button);
    }

    fn release_buttons(&mut self) {
        for button in [Button::Start, Button::Stop] {
            if self.release_us[index(button)].is_some_and(|due| due <= self.now_us) {
                self.release_us[index(button)] = None;
                self.plant_mut().tank.release(button);
            }
        }
    }

    fn switch_meter(&mut self) {
        let plant = self.plant_mut();
        plant.meter_failed = !plant.meter_failed;
        let text = match plant.meter_failed {
            true => "flow meter fails: no pulses",
            false => "flow meter works again",
        };
        self.note(text);
    }

    /// Containers are exchanged and the tank is refilled, as the world around a plant does.
    fn look_after_plant(&mut self) {
        let tank = &self.plant().tank;
        let (open, vessel, supply, spilled) = (tank.valve_open(), tank.vessel_litres(), tank.supply_litres(), tank.spilled_litres());
        let full = vessel >= f64::from(tank.settings().vessel_litres) && open && spilled > 0.0;
        if open {
            self.exchange_us = None;
            self.idle_since_us = self.now_us;
        } else if vessel > 0.0 && self.exchange_us.is_none() {
            self.exchange_us = Some(self.now_us + EXCHANGE_US);
        }
        if full && !self.spilling {
            self.note("the container overflows!");
        }
        self.spilling = full;
        if self.exchange_us.is_some_and(|due| due <= self.now_us) {
            self.exchange_us = None;
            self.plant_mut().tank.exchange_vessel();
            self.note(format!("container with {vessel:.1} l leaves"));
        }
        if !open && supply < REFILL_LITRES {
            self.plant_mut().tank.refill();
            self.note("the tank is filled again");
        }
    }

    /// When the story goes on by itself.
    fn story_due_us(&self) -> Option<u64> {
        let tank = &self.plant().tank;
        let waits = self.story
            && self.cpu.mode() == OperatingMode::Run
            && !tank.valve_open()
            && !tank.is_pressed(Button::Start)
            && !tank.is_pressed(Button::Stop);
        let after_user = self.user_us.map_or(0, |user| user + USER_US);
        waits.then(|| (self.idle_since_us + STORY_US).max(after_user))
    }

    fn tell_story(&mut self) {
        if self.story_due_us().is_some_and(|due| due <= self.now_us) && self.exchange_us.is_none() {
            if self.plant().meter_failed {
                self.switch_meter();
            }
            self.note("the demo presses START");
            self.push(Button::Start);
            self.idle_since_us = self.now_us;
        }
        // A user who left with a failed meter left an open valve and an empty tank.
        let left_alone = self.story && self.user_us.is_none_or(|user| user + USER_US <= self.now_us);
        let plant = self.plant();
        if left_alone && plant.tank.valve_open() && plant.tank.supply_litres() <= 0.0 && !plant.tank.is_pressed(Button::Stop) {
            self.note("the demo presses STOP");
            self.push(Button::Stop);
        }
    }
}

fn index(button: Button) -> usize {
    match button {
        Button::Start => 0,
        Button::Stop => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::super::changes::KEPT;
    use super::*;

    fn run(session: &mut Session, seconds: u64) {
        for _ in 0..seconds * 1_000_000 / CYCLE_US {
            session.scan(false);
        }
    }

    fn notes(session: &Session) -> Vec<String> {
        let note = |entry: &Entry| match &entry.event {
            Event::Note(text) => Some(text.clone()),
            Event::Change { .. } => None,
        };
        session.changes.entries.iter().filter_map(note).collect()
    }

    #[test]
    fn the_assignment_table_of_the_plant_is_without_fault() {
        assert_eq!(symbols::read(FileId(0), SYMBOLS, Format::Csv).diagnostics, []);
    }

    #[test]
    fn the_story_doses_25_litres_without_a_key() {
        let mut session = Session::new();
        run(&mut session, 4);
        assert!(session.plant().tank.valve_open());
        assert_eq!(session.changes.watched("Q 0.0").map(|watched| watched.value), Some(1));
        run(&mut session, 10);
        assert!(!session.plant().tank.valve_open());
        let delivered = session.plant().tank.litres_delivered();
        assert!((25.0..25.2).contains(&delivered), "{delivered}");
        assert_eq!(notes(&session)[0], "the demo presses START");
    }

    #[test]
    fn an_hour_of_the_plant_needs_no_more_memory_than_a_minute() {
        let mut session = Session::new();
        run(&mut session, 3_600);
        assert_eq!(session.scans(), 360_000);
        assert_eq!(session.changes.entries.len(), KEPT);
        assert!(session.changes.entries.capacity() <= 2 * KEPT);
        assert!(session.changes.count > 10_000, "{}", session.changes.count);
        assert!(session.cpu().diagnostic_buffer().entries().len() <= 100);
        assert_eq!(session.cpu().mode(), OperatingMode::Run);
    }

    #[test]
    fn stop_closes_the_valve_and_clears_the_display() {
        let mut session = Session::new();
        session.act(Action::Push(Button::Start));
        run(&mut session, 2);
        assert!(session.plant().tank.valve_open());
        assert!(session.plant().tank.display() > 0);
        session.act(Action::Push(Button::Stop));
        run(&mut session, 1);
        assert!(!session.plant().tank.valve_open());
        assert_eq!(session.plant().tank.display(), 0);
    }

    #[test]
    fn without_the_flow_meter_the_container_overflows_and_the_demo_recovers() {
        let mut session = Session::new();
        session.act(Action::Meter);
        session.act(Action::Push(Button::Start));
        run(&mut session, 15);
        assert!(session.plant().tank.spilled_litres() > 0.0);
        assert!(notes(&session).contains(&"the container overflows!".to_owned()));
        run(&mut session, 120);
        assert!(!session.plant().meter_failed);
    }

    #[test]
    fn a_cpu_in_stop_closes_the_valve() {
        let mut session = Session::new();
        run(&mut session, 5);
        let scans = session.scans();
        session.act(Action::Mode);
        run(&mut session, 5);
        assert_eq!((session.cpu().mode(), session.scans()), (OperatingMode::Stop, scans));
        assert!(!session.plant().tank.valve_open());
        session.act(Action::Mode);
        run(&mut session, 1);
        assert_eq!(session.cpu().mode(), OperatingMode::Run);
    }

    #[test]
    fn every_statement_is_listed_and_seen() {
        let mut session = Session::new();
        session.scan(true);
        let statements: Vec<u32> =
            session.lines.iter().filter_map(|line| if let Line::Statement { index, .. } = line { Some(*index) } else { None }).collect();
        assert_eq!(statements.len(), 15);
        assert_eq!(session.lines.len(), 20);
        assert!(statements.iter().all(|&index| session.seen(index).is_some()));
    }
}
