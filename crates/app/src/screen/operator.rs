//! The operator of the demo: pushes buttons, exchanges containers, fills the tank again and tells the story, scan by scan.

use std::time::Duration;

use sieben_cpu::{Cpu, OperatingMode, Requester, Restart};
use sieben_model::symbols::SymbolTable;
use sieben_sim::devices::dosing::Button;
use sieben_workspace::Plant;

use super::changes::{Changes, Entry, Event};
use super::plant::DosingTank;

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
    /// Lets the flow meter fail, or work again.
    Meter,
    /// Turns the mode switch of the CPU.
    Mode,
    /// Switches the story on or off.
    Story,
}

/// How long scans took.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ScanTime {
    /// All of them.
    pub(crate) total: Duration,
    /// How many they were.
    pub(crate) scans: u32,
}

/// The operator, with what it has seen.
#[derive(Debug)]
pub(crate) struct Operator {
    /// What changed.
    pub(crate) changes: Changes,
    /// Whether the story presses START by itself.
    story: bool,
    /// The time of the plant: one cycle for each scan.
    now_us: u64,
    /// When a pushed button is released: START, STOP.
    release_us: [Option<u64>; 2],
    /// Since when the valve is closed and nothing happens.
    idle_since_us: u64,
    /// When the user last did something.
    user_us: Option<u64>,
    exchange_us: Option<u64>,
    spilling: bool,
    mode: OperatingMode,
    scan_time: ScanTime,
}

/// The tank of a CPU.
pub(crate) fn dosing(cpu: &Cpu) -> &DosingTank {
    cpu.rack().module().expect("the tank was plugged in at the start")
}

fn dosing_mut(plant: &mut Plant) -> &mut DosingTank {
    plant.cpu.rack_mut().module_mut().expect("the tank was plugged in at the start")
}

impl Operator {
    /// Watches the symbols of a CPU.
    pub(crate) fn new(symbols: &SymbolTable, cpu: &Cpu) -> Self {
        Self {
            changes: Changes::new(symbols, cpu),
            story: true,
            now_us: 0,
            release_us: [None, None],
            idle_since_us: 0,
            user_us: None,
            exchange_us: None,
            spilling: false,
            mode: OperatingMode::Run,
            scan_time: ScanTime::default(),
        }
    }

    /// The time of the plant in milliseconds.
    pub(crate) fn time_ms(&self) -> u64 {
        self.now_us / 1_000
    }

    /// A scan took so long.
    pub(crate) fn add_scan_time(&mut self, took: Duration) {
        self.scan_time.total = self.scan_time.total.saturating_add(took);
        self.scan_time.scans = self.scan_time.scans.saturating_add(1);
    }

    /// How long the scans took since this was asked last.
    pub(crate) fn take_scan_time(&mut self) -> ScanTime {
        std::mem::take(&mut self.scan_time)
    }

    /// Seconds until the story presses START; `None` if it will not.
    pub(crate) fn seconds_to_story(&self, cpu: &Cpu) -> Option<u64> {
        Some(self.story_due_us(cpu)?.saturating_sub(self.now_us).div_ceil(1_000_000))
    }

    /// A user does something.
    pub(crate) fn act(&mut self, plant: &mut Plant, action: Action) {
        self.user_us = Some(self.now_us);
        match action {
            Action::Push(button) => self.push(plant, button),
            Action::Hold(button) => {
                self.release_us[index(button)] = None;
                dosing_mut(plant).tank.toggle(button);
            }
            Action::Meter => self.switch_meter(plant),
            Action::Mode if plant.cpu.mode() == OperatingMode::Run => plant.stop(Requester::default()),
            Action::Mode => plant.ask_for_start(Restart::Warm, Requester::default()),
            Action::Story => {
                self.story = !self.story;
                self.user_us = None;
                self.idle_since_us = self.now_us;
            }
        }
        self.note_mode(plant);
    }

    /// Right before a scan, also of a CPU in STOP.
    pub(crate) fn before_scan(&mut self, plant: &mut Plant) {
        self.now_us += CYCLE_US;
        self.release_buttons(plant);
    }

    /// Right after a scan: what changed, and all that goes on around the CPU.
    pub(crate) fn after_scan(&mut self, plant: &mut Plant) {
        self.changes.observe(&plant.cpu, plant.scans, self.time_ms());
        self.note_mode(plant);
        self.look_after_plant(plant);
        self.tell_story(plant);
    }

    /// Notes a change of the mode: a key, the control socket or the program may have caused it.
    pub(crate) fn note_mode(&mut self, plant: &Plant) {
        let mode = plant.cpu.mode();
        if mode != self.mode {
            self.mode = mode;
            self.note(plant, format!("CPU in {mode}"));
        }
    }

    /// Adds a note to the changes.
    pub(crate) fn note(&mut self, plant: &Plant, text: impl Into<String>) {
        self.changes.push(Entry { scan: plant.scans, time_ms: self.time_ms(), event: Event::Note(text.into()) });
    }

    fn push(&mut self, plant: &mut Plant, button: Button) {
        self.release_us[index(button)] = Some(self.now_us + PUSH_US);
        dosing_mut(plant).tank.press(button);
    }

    fn release_buttons(&mut self, plant: &mut Plant) {
        for button in [Button::Start, Button::Stop] {
            if self.release_us[index(button)].is_some_and(|due| due <= self.now_us) {
                self.release_us[index(button)] = None;
                dosing_mut(plant).tank.release(button);
            }
        }
    }

    fn switch_meter(&mut self, plant: &mut Plant) {
        let dosing = dosing_mut(plant);
        dosing.meter_failed = !dosing.meter_failed;
        let text = match dosing.meter_failed {
            true => "flow meter fails: no pulses",
            false => "flow meter works again",
        };
        self.note(plant, text);
    }

    /// Containers are exchanged and the tank is filled again, as the world around a plant does.
    fn look_after_plant(&mut self, plant: &mut Plant) {
        let tank = &dosing(&plant.cpu).tank;
        let (open, vessel, supply, spilled) = (tank.valve_open(), tank.vessel_litres(), tank.supply_litres(), tank.spilled_litres());
        let full = vessel >= f64::from(tank.settings().vessel_litres) && open && spilled > 0.0;
        if open {
            self.exchange_us = None;
            self.idle_since_us = self.now_us;
        } else if vessel > 0.0 && self.exchange_us.is_none() {
            self.exchange_us = Some(self.now_us + EXCHANGE_US);
        }
        if full && !self.spilling {
            self.note(plant, "the container overflows!");
        }
        self.spilling = full;
        if self.exchange_us.is_some_and(|due| due <= self.now_us) {
            self.exchange_us = None;
            dosing_mut(plant).tank.exchange_vessel();
            self.note(plant, format!("container with {vessel:.1} l leaves"));
        }
        if !open && supply < REFILL_LITRES {
            dosing_mut(plant).tank.refill();
            self.note(plant, "the tank is filled again");
        }
    }

    /// When the story goes on by itself.
    fn story_due_us(&self, cpu: &Cpu) -> Option<u64> {
        let tank = &dosing(cpu).tank;
        let waits = self.story
            && cpu.mode() == OperatingMode::Run
            && !tank.valve_open()
            && !tank.is_pressed(Button::Start)
            && !tank.is_pressed(Button::Stop);
        let after_user = self.user_us.map_or(0, |user| user + USER_US);
        waits.then(|| (self.idle_since_us + STORY_US).max(after_user))
    }

    fn tell_story(&mut self, plant: &mut Plant) {
        if self.story_due_us(&plant.cpu).is_some_and(|due| due <= self.now_us) && self.exchange_us.is_none() {
            if dosing(&plant.cpu).meter_failed {
                self.switch_meter(plant);
            }
            self.note(plant, "the demo presses START");
            self.push(plant, Button::Start);
            self.idle_since_us = self.now_us;
        }
        // A user who left with a failed meter left an open valve and an empty tank.
        let left_alone = self.story && self.user_us.is_none_or(|user| user + USER_US <= self.now_us);
        let tank = &dosing(&plant.cpu).tank;
        if left_alone && tank.valve_open() && tank.supply_litres() <= 0.0 && !tank.is_pressed(Button::Stop) {
            self.note(plant, "the demo presses STOP");
            self.push(plant, Button::Stop);
        }
    }
}

fn index(button: Button) -> usize {
    match button {
        Button::Start => 0,
        Button::Stop => 1,
    }
}
