//! What the modules of one scan said, for a run that hears it instead of them.

use std::ops::Range;

use sieben_model::cpu_type::CpuType;

use super::plugging::is_simulated;
use super::{IoModule, Rack, SimulatedModule};
use crate::tape::{Reading, Tape};

/// The addresses of a module.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    inputs: Range<u32>,
    outputs: Range<u32>,
    is_simulated: bool,
}

/// A module that says nothing.
struct Silent {
    inputs: Range<u32>,
    outputs: Range<u32>,
}

impl IoModule for Silent {
    fn name(&self) -> &str {
        "silent"
    }
    fn inputs(&self) -> Range<u32> {
        self.inputs.clone()
    }
    fn outputs(&self) -> Range<u32> {
        self.outputs.clone()
    }
    fn read(&self, _: u32, into: &mut [u8]) {
        into.fill(0);
    }
    fn write(&mut self, _: u32, _: &[u8]) {}
}

impl Rack {
    /// A rack with modules in the places of these, which know nothing but their addresses: whoever runs with it takes back a snapshot, or
    /// hears a tape.
    pub(crate) fn of_places(cpu: &CpuType, places: &[Place]) -> Self {
        let module = |place: &Place| -> Box<dyn IoModule> {
            match place.is_simulated {
                true => Box::new(SimulatedModule::new("silent", place.inputs.clone())),
                false => Box::new(Silent { inputs: place.inputs.clone(), outputs: place.outputs.clone() }),
            }
        };
        Self::of(cpu, places.iter().map(module).collect())
    }

    /// Where the modules are.
    pub(crate) fn places(&self) -> Vec<Place> {
        let place =
            |module: &dyn IoModule| Place { inputs: module.inputs(), outputs: module.outputs(), is_simulated: is_simulated(module) };
        self.modules().map(place).collect()
    }

    /// Begins to record what modules say that cannot be copied; what [`Self::end_record`] wants to know.
    pub(crate) fn begin_record(&mut self) -> (u64, bool) {
        let was_on = self.tape.is_on();
        let position = self.tape.position();
        self.record();
        (position, was_on)
    }

    /// What modules have said since.
    pub(crate) fn end_record(&mut self, (position, was_on): (u64, bool)) -> Vec<Reading> {
        self.changed |= self.tape.is_on() && !was_on;
        self.tape.cut(position, was_on)
    }

    /// From now on a run hears this instead of its modules.
    pub(crate) fn play(&mut self, readings: Vec<Reading>) {
        self.tape = Tape::of(readings);
    }

    /// A run that hears this goes on where it stands; what was recorded may have become more.
    pub(crate) fn play_on(&mut self, readings: &[Reading]) {
        let position = self.tape.position();
        self.play(readings.to_vec());
        self.tape.go_to(position);
    }
}
