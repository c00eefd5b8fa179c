//! Exchange between the process image and the modules.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use sieben_engine::image_writes::ANYWHERE;
use sieben_engine::{ImageWrites, Machine};
use sieben_model::address::Area;

use crate::io::Rack;
use crate::settings::ImageErrors;
use crate::start_information::StartInformation;

/// Input bits that were modified from outside and hold for one scan, by byte: mask and value.
pub(crate) type Overrides = BTreeMap<u32, (u8, u8)>;

/// Bytes that could not be exchanged: inputs or outputs, the first one, how many.
type Failure = (Area, u32, u32);
/// All of them, inputs first.
pub(crate) type Failures = Vec<Failure>;

/// What may differ between the process images and the modules.
pub(crate) struct Images {
    /// What the program writes.
    writes: Arc<ImageWrites>,
    /// Somebody else may have written any byte of an image since the last exchange.
    changed: bool,
}

impl Images {
    pub(crate) fn new(writes: Arc<ImageWrites>) -> Self {
        Self { writes, changed: true }
    }

    /// Not only instructions of the program have written an image: the next exchange is one of all bytes.
    pub(crate) fn changed(&mut self) {
        self.changed = true;
    }

    /// The cycle control point: process image of the outputs → modules, modules → process image of the inputs.
    ///
    /// Outputs go first, so that what the program of the last scan (or OB 100) has written is out before inputs are read.
    #[inline]
    pub(crate) fn exchange(&mut self, machine: &mut Machine, rack: &mut Rack, overrides: &mut Overrides) -> Failures {
        let all = std::mem::take(&mut self.changed) | rack.take_changed();
        let memory = &machine.memory;
        let as_read = !all && overrides.is_empty() && self.writes.inputs.is_empty();
        if as_read && rack.exchange_quietly(memory.area(Area::Output), self.writes.outputs.clone(), memory.area(Area::Input)) {
            return Failures::new();
        }
        let outputs_failed = rack.put_image(machine.memory.area(Area::Output), if all { ANYWHERE } else { self.writes.outputs.clone() });
        let inputs = machine.memory.area_mut(Area::Input);
        let inputs_failed = rack.get_image(inputs, all || !self.writes.inputs.is_empty());
        if !overrides.is_empty() {
            self.changed = true;
            for (byte, (mask, value)) in std::mem::take(overrides) {
                if let Some(input) = inputs.get_mut(byte as usize) {
                    *input = *input & !mask | value & mask;
                }
            }
        }
        if inputs_failed.is_empty() && outputs_failed.is_empty() {
            return Failures::new();
        }
        let of = |area, bytes: Range<usize>| (area, bytes.start as u32, bytes.len() as u32);
        let outputs = outputs_failed.into_iter().map(|bytes| of(Area::Output, bytes));
        inputs_failed.into_iter().map(|bytes| of(Area::Input, bytes)).chain(outputs).collect()
    }
}

/// What OB 85 learns about an exchange, compared with the failures before it.
pub(crate) fn errors(how: ImageErrors, before: &Failures, now: &Failures) -> Vec<StartInformation> {
    let event = |class: u16, every: bool, &(area, byte, bytes): &Failure| {
        let number = match (area, every) {
            (Area::Input, true) => 0xB1,
            (_, true) => 0xB2,
            (Area::Input, false) => 0xB3,
            (_, false) => 0xB4,
        };
        StartInformation::image_error(class | number, byte, bytes)
    };
    match how {
        ImageErrors::Ignored => Vec::new(),
        ImageErrors::EveryTime => now.iter().map(|failure| event(0x3900, true, failure)).collect(),
        ImageErrors::Changes => {
            let coming = now.iter().filter(|failure| !before.contains(failure)).map(|failure| event(0x3900, false, failure));
            let going = before.iter().filter(|failure| !now.contains(failure)).map(|failure| event(0x3800, false, failure));
            coming.chain(going).collect()
        }
    }
}
