//! Forced operands: values that hold whatever modules and program say, until somebody ends it.
//!
//! They are enforced where the process image is exchanged, as an S7-300 does it, and nowhere else: a CPU without forced operands pays
//! one comparison in a scan, and machine code knows nothing of them.

use std::collections::BTreeMap;

use sieben_engine::Machine;
use sieben_model::address::{Address, Area, Width};

/// Forced bits of a byte and their values.
type Bits = (u8, u8);

/// All forced operands of a CPU.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Forced {
    inputs: BTreeMap<u32, Bits>,
    outputs: BTreeMap<u32, Bits>,
    bit_memory: BTreeMap<u32, Bits>,
}

/// Whether anything is forced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forces {
    /// Nothing: the light FRCE is off.
    None,
    /// Something: the light FRCE is on.
    Some,
}

impl Forced {
    /// Whether anything is forced.
    pub fn forces(&self) -> Forces {
        if self.is_empty() { Forces::None } else { Forces::Some }
    }

    /// Whether nothing is forced.
    pub fn is_empty(&self) -> bool {
        self.inputs.is_empty() && self.outputs.is_empty() && self.bit_memory.is_empty()
    }

    /// Forced bits by area and byte: which they are, and their values.
    pub fn bytes(&self) -> impl Iterator<Item = (Area, u32, u8, u8)> {
        let of = |area, bytes: &BTreeMap<u32, Bits>| {
            bytes.iter().map(move |(&byte, &(mask, value))| (area, byte, mask, value)).collect::<Vec<_>>()
        };
        [of(Area::Input, &self.inputs), of(Area::Output, &self.outputs), of(Area::BitMemory, &self.bit_memory)].into_iter().flatten()
    }

    fn area(&mut self, area: Area) -> Option<&mut BTreeMap<u32, Bits>> {
        match area {
            Area::Input => Some(&mut self.inputs),
            Area::Output => Some(&mut self.outputs),
            Area::BitMemory => Some(&mut self.bit_memory),
            _ => None,
        }
    }

    /// Forces an address that lies inside its area; `false` if its area cannot be forced.
    pub(crate) fn set(&mut self, address: &Address, value: u32) -> bool {
        let Some(bytes) = self.area(address.area) else { return false };
        for (byte, mask, value) in bits_of(address, value) {
            let (forced, old) = bytes.entry(byte).or_default();
            *forced |= mask;
            *old = *old & !mask | value;
        }
        true
    }

    /// Ends the forcing of an address; `false` if none of it was forced.
    pub(crate) fn clear(&mut self, address: &Address) -> bool {
        let Some(bytes) = self.area(address.area) else { return false };
        let mut any = false;
        for (byte, mask, _) in bits_of(address, 0) {
            if let Some((forced, _)) = bytes.get_mut(&byte) {
                any |= *forced & mask != 0;
                *forced &= !mask;
            }
        }
        bytes.retain(|_, (mask, _)| *mask != 0);
        any
    }

    /// Before the outputs go to the modules.
    pub(crate) fn put_outputs(&self, machine: &mut Machine) {
        put(&self.outputs, machine.memory.area_mut(Area::Output));
    }

    /// When the inputs have come.
    pub(crate) fn put_inputs(&self, machine: &mut Machine) {
        put(&self.inputs, machine.memory.area_mut(Area::Input));
        put(&self.bit_memory, machine.memory.area_mut(Area::BitMemory));
    }
}

/// Byte, bits and value of each byte of an address, the highest value first.
fn bits_of(address: &Address, value: u32) -> impl Iterator<Item = (u32, u8, u8)> + use<> {
    let (first, length) = (address.byte, address.width.bytes());
    let bit = (address.width == Width::Bit).then_some(1_u8 << (address.bit & 7));
    (0..length).map(move |index| match bit {
        Some(mask) => (first, mask, if value & 1 == 1 { mask } else { 0 }),
        None => (first + index, 0xFF, (value >> (8 * (length - 1 - index))) as u8),
    })
}

fn put(forced: &BTreeMap<u32, Bits>, area: &mut [u8]) {
    for (&byte, &(mask, value)) in forced {
        if let Some(to) = area.get_mut(byte as usize) {
            *to = *to & !mask | value;
        }
    }
}
