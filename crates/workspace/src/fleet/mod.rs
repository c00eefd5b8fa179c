//! Fleets: very many controllers of a few programs, coupled by links that take time, so that any number of threads brings the same about.

mod endpoint;
pub mod fuzz;
mod instance;
mod metrics;
mod opening;
mod parse;
mod recording;
mod spec;
mod summary;
#[cfg(test)]
mod tests;
mod windows;
mod wiring;

use std::sync::{Mutex, PoisonError};

use sieben_cpu::{Loaded, Settings};

use crate::project::Build;
use instance::Instance;
use wiring::{Message, Wire};

pub use instance::{Counts, Stopped};
pub use metrics::text as metrics;
pub use opening::{Failed, open};
pub use parse::parse;
pub use spec::{CONTROLLERS_MAX, Controllers, LATENCY_US_MAX, LATENCY_US_MIN, LINKS_MAX, Spec};
pub use summary::{Row, Summary};
pub use windows::{Window, Windows};

/// A fleet, ready to run: any number of threads run its controllers, a window at a time.
pub struct Fleet {
    /// What it is asked for.
    pub spec: Spec,
    /// From one scan to the next, in microseconds.
    pub cycle_us: u64,
    programs: Vec<Program>,
    groups: Vec<Group>,
    wires: Vec<Wire>,
    instances: Vec<Mutex<Instance>>,
    /// What each controller has sent in windows with an even number, and in those with an odd one: while one is filled the other is read.
    outboxes: [Vec<Mutex<Vec<Message>>>; 2],
}

/// A program that controllers run.
struct Program {
    path: String,
    build: Build,
    loaded: Loaded,
    settings: Settings,
    /// Up to which byte the program writes outputs, as far as its statements say so.
    output_bytes: usize,
}

/// Controllers of one name.
struct Group {
    program: usize,
    /// The number of the first of them in the fleet.
    first: u32,
    count: u32,
    /// Wires into them.
    incoming: Vec<u32>,
}

/// Most scans of a window: Ctrl-C is seen between two, and what is under way waits for the next.
const WINDOW_SCANS_MAX: u64 = 64;

impl Fleet {
    /// How many controllers there are.
    pub fn len(&self) -> usize {
        self.instances.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.instances.is_empty()
    }

    /// The windows of a run of so many microseconds; in one that `waits` for real time a window is no longer than a cycle.
    pub fn windows(&self, for_us: u64, waits: bool) -> Windows {
        let least = self.wires.iter().map(|wire| wire.latency_us).min();
        Windows::new(self.cycle_us, for_us.div_ceil(self.cycle_us), least, if waits { 1 } else { WINDOW_SCANS_MAX })
    }

    /// Runs one controller through a window, whatever the others do meanwhile: each window once, and none before all controllers are through
    /// the one before it. `clock` shows nanoseconds of real time.
    pub fn run(&self, number: usize, window: &Window, clock: &dyn Fn() -> u64) {
        let Some(instance) = self.instances.get(number) else { return };
        let instance = &mut *instance.lock().unwrap_or_else(PoisonError::into_inner);
        let group = &self.groups[self.group_of(number)];
        let [filled, read] = if window.number.is_multiple_of(2) { [0, 1] } else { [1, 0] };
        if !group.incoming.is_empty() && instance.stop.is_none() {
            self.receive(instance, group, number as u32 - group.first, &self.outboxes[read]);
        }
        let mut outbox = self.outboxes[filled].get(number).map(|outbox| outbox.lock().unwrap_or_else(PoisonError::into_inner));
        let mut nowhere = Vec::new();
        let outbox = outbox.as_deref_mut().unwrap_or(&mut nowhere);
        outbox.clear();
        instance.run(window, &self.wires, outbox, clock);
    }

    /// Hands over what was sent to a controller in the window before.
    fn receive(&self, instance: &mut Instance, group: &Group, index: u32, outboxes: &[Mutex<Vec<Message>>]) {
        for &wire in &group.incoming {
            let of = &self.wires[wire as usize];
            let senders = &self.groups[of.from];
            for sender in of.senders_to(index, senders.count) {
                let Some(outbox) = outboxes.get((senders.first + sender) as usize) else { continue };
                let outbox = outbox.lock().unwrap_or_else(PoisonError::into_inner);
                instance.inbox.extend(outbox.iter().filter(|message| message.wire == wire));
            }
        }
        instance.sort();
    }

    fn group_of(&self, number: usize) -> usize {
        self.groups.partition_point(|group| group.first as usize <= number).saturating_sub(1)
    }

    /// What a controller is called.
    pub fn name_of(&self, number: usize) -> String {
        let group = self.group_of(number);
        self.spec.controllers[group].name_of(number as u32 - self.groups[group].first)
    }

    /// The path of its program, as the file has it.
    pub fn program_of(&self, number: usize) -> &str {
        &self.programs[self.groups[self.group_of(number)].program].path
    }

    /// The controller with this name, as [`Self::name_of`] gives it.
    pub fn by_name(&self, name: &str) -> Option<usize> {
        let (group, index) = match name.trim().split_once('[') {
            None => (name.trim(), None),
            Some((group, rest)) => (group.trim_end(), Some(rest.strip_suffix(']')?.trim().parse::<u32>().ok()?)),
        };
        let place = self.spec.controllers.iter().position(|controllers| controllers.name.text == group)?;
        let controllers = &self.spec.controllers[place];
        let index = match (controllers.count, index) {
            (Some(count), Some(index)) if index < count => index,
            (None, None) => 0,
            _ => return None,
        };
        Some((self.groups[place].first + index) as usize)
    }
}
