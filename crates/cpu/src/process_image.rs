//! Exchange between the process image and the modules.

use std::collections::BTreeMap;

use sieben_engine::Machine;
use sieben_model::address::Area;

use crate::io::Rack;

/// Input bits that were modified from outside and hold for one scan, by byte: mask and value.
pub(crate) type Overrides = BTreeMap<u32, (u8, u8)>;

/// The cycle control point: process image of the outputs → modules, modules → process image of the inputs.
///
/// Outputs go first, so that what the program of the last scan (or OB 100) has written is out before inputs are read.
pub(crate) fn exchange(machine: &mut Machine, rack: &mut Rack, overrides: &mut Overrides) {
    rack.put_image(machine.memory.area(Area::Output));
    let inputs = machine.memory.area_mut(Area::Input);
    rack.get_image(inputs);
    for (byte, (mask, value)) in std::mem::take(overrides) {
        if let Some(input) = inputs.get_mut(byte as usize) {
            *input = *input & !mask | value & mask;
        }
    }
}
