//! The operator of the demo: exchanges containers, fills the tank again and tells the story, scan by scan.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use sieben_cpu::OperatingMode;
use sieben_sim::devices::Attention;
use sieben_sim::wrap;
use sieben_workspace::Plant;

use super::state::Story;

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
/// The kind of the plant that the story is about.
const KIND: &str = "dosing";
/// The flow meter, as faults call it.
const METER: &str = "flow";

/// A button of the plant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Button {
    /// START, which makes.
    Start,
    /// STOP, which breaks.
    Stop,
}

impl Button {
    /// Its bit in input byte 0.
    fn mask(self) -> u8 {
        match self {
            Self::Start => 1,
            Self::Stop => 2,
        }
    }

    fn set(self, plant: &mut Plant, is_pressed: bool) {
        let value = if is_pressed == (self == Self::Start) { self.mask() } else { 0 };
        plant.cpu.rack_mut().set_input(0, self.mask(), value);
    }

    fn is_pressed(self, plant: &Plant) -> bool {
        let byte = plant.cpu.rack().peripheral_read(0, sieben_model::address::Width::Byte).unwrap_or_default() as u8;
        (byte & self.mask() != 0) == (self == Self::Start)
    }
}

/// What is seen of the plant.
struct Seen {
    open: bool,
    vessel: f64,
    supply: f64,
    spilled: f64,
    meter_failed: bool,
}

/// The operator, with what it has seen.
#[derive(Debug)]
pub(crate) struct Operator {
    story: Arc<Story>,
    /// What was noted since this was asked last.
    notes: Vec<String>,
    /// The time of the plant: one cycle for each scan.
    now_us: u64,
    /// Which button the story has pressed, and when it is released.
    pressed: Option<(Button, u64)>,
    /// Since when the valve is closed and nothing happens.
    idle_since_us: u64,
    /// When the user last did something.
    user_us: Option<u64>,
    exchange_us: Option<u64>,
    /// What had been spilled at the last look.
    spilled: f64,
    was_on: bool,
}

/// The plant of the demo.
fn dosing(plant: &Plant) -> Option<&wrap::Plant> {
    wrap::plants(plant.cpu.rack()).next().filter(|plant| plant.kind().name == KIND)
}

/// What has run through the valve of the demo; `None` where the plant is another one.
pub(crate) fn litres(plant: &Plant) -> Option<f64> {
    dosing(plant)?.device().value("delivered")
}

impl Operator {
    /// An operator who follows this story.
    pub(crate) fn new(story: Arc<Story>) -> Self {
        Self {
            story,
            notes: Vec::new(),
            now_us: 0,
            pressed: None,
            idle_since_us: 0,
            user_us: None,
            exchange_us: None,
            spilled: 0.0,
            was_on: true,
        }
    }

    /// The time of the plant in microseconds.
    pub(crate) fn time_us(&self) -> u64 {
        self.now_us
    }

    /// What was noted since this was asked last.
    pub(crate) fn take_notes(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notes)
    }

    /// Right before a scan, also of a CPU in STOP.
    pub(crate) fn before_scan(&mut self, plant: &mut Plant) {
        self.now_us += CYCLE_US;
        if let Some((button, _)) = self.pressed.take_if(|(_, until)| *until <= self.now_us) {
            button.set(plant, false);
        }
    }

    /// Right after a scan: all that goes on around the CPU.
    pub(crate) fn after_scan(&mut self, plant: &mut Plant) {
        if self.story.user_acted.swap(false, Ordering::Relaxed) {
            self.user_us = Some(self.now_us);
        }
        let is_on = self.story.is_on.load(Ordering::Relaxed);
        if std::mem::replace(&mut self.was_on, is_on) != is_on {
            (self.user_us, self.idle_since_us) = (None, self.now_us);
        }
        let seen = Self::look(plant);
        self.story.has_plant.store(seen.is_some(), Ordering::Relaxed);
        let Some(seen) = seen else {
            self.story.seconds.store(u64::MAX, Ordering::Relaxed);
            return;
        };
        self.look_after_plant(plant, &seen);
        self.tell_story(plant, &seen);
        let seconds = self.story_due_us(plant, &seen).map_or(u64::MAX, |due| due.saturating_sub(self.now_us).div_ceil(1_000_000));
        self.story.seconds.store(seconds, Ordering::Relaxed);
    }

    fn look(plant: &Plant) -> Option<Seen> {
        let dosing = dosing(plant)?;
        let value = |name| dosing.device().value(name).unwrap_or_default();
        Some(Seen {
            open: dosing.commands().first().is_some_and(|byte| byte & 1 != 0),
            vessel: value("vessel"),
            supply: value("supply"),
            spilled: value("spilled"),
            meter_failed: dosing.faults().any(|fault| fault.signal == METER),
        })
    }

    fn attend(plant: &mut Plant, attention: Attention) {
        plant.cpu.rack_mut().modules_mut::<wrap::Plant>().take(1).for_each(|dosing| dosing.attend(attention));
    }

    fn push(&mut self, plant: &mut Plant, button: Button) {
        self.pressed = Some((button, self.now_us + PUSH_US));
        button.set(plant, true);
    }

    /// Containers are exchanged and the tank is filled again, as the world around a plant does.
    fn look_after_plant(&mut self, plant: &mut Plant, seen: &Seen) {
        if seen.open {
            self.exchange_us = None;
            self.idle_since_us = self.now_us;
        } else if seen.vessel > 0.0 && self.exchange_us.is_none() {
            self.exchange_us = Some(self.now_us + EXCHANGE_US);
        }
        if seen.spilled > 0.0 && self.spilled == 0.0 {
            self.notes.push("the container overflows!".to_owned());
        }
        self.spilled = seen.spilled;
        if self.exchange_us.is_some_and(|due| due <= self.now_us) {
            self.exchange_us = None;
            Self::attend(plant, Attention::ExchangeVessel);
            self.spilled = 0.0;
            self.notes.push(format!("container with {:.1} l leaves", seen.vessel));
        }
        if !seen.open && seen.supply < REFILL_LITRES {
            Self::attend(plant, Attention::Refill);
            self.notes.push("the tank is filled again".to_owned());
        }
    }

    /// When the story goes on by itself.
    fn story_due_us(&self, plant: &Plant, seen: &Seen) -> Option<u64> {
        let waits = self.was_on
            && plant.cpu.mode() == OperatingMode::Run
            && !seen.open
            && !Button::Start.is_pressed(plant)
            && !Button::Stop.is_pressed(plant);
        let after_user = self.user_us.map_or(0, |user| user + USER_US);
        waits.then(|| (self.idle_since_us + STORY_US).max(after_user))
    }

    fn tell_story(&mut self, plant: &mut Plant, seen: &Seen) {
        if self.story_due_us(plant, seen).is_some_and(|due| due <= self.now_us) && self.exchange_us.is_none() {
            if seen.meter_failed {
                plant.cpu.rack_mut().modules_mut::<wrap::Plant>().take(1).for_each(|dosing| {
                    dosing.mend(Some(METER));
                });
                self.notes.push("flow meter works again".to_owned());
            }
            self.notes.push("the demo presses START".to_owned());
            self.push(plant, Button::Start);
            self.idle_since_us = self.now_us;
        }
        // A user who left with a failed meter left an open valve and an empty tank.
        let left_alone = self.was_on && self.user_us.is_none_or(|user| user + USER_US <= self.now_us);
        if left_alone && seen.open && seen.supply <= 0.0 && !Button::Stop.is_pressed(plant) {
            self.notes.push("the demo presses STOP".to_owned());
            self.push(plant, Button::Stop);
        }
    }
}
