//! Variables of a block that runs: where they lie depends on who called it.

use sieben_engine::Machine;
use sieben_engine::access::{self, load_file, locate_far};
use sieben_engine::ir::{Place, Var};
use sieben_engine::machine::{Register, Registers};
use sieben_model::address::{Area, Width};
use sieben_model::item::{Local, Start};

/// Where a variable lies at a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spot {
    /// A byte of the arena, and the bit in it.
    Arena(usize, u8),
    /// A number that the caller gave.
    Number(u16),
}

/// A temporary of a register file that holds a pointer.
const POINTER: Var = Var(Register::COUNT as u8);

/// Where a variable lies in a machine with these registers; `None` if the block does not run, or if what runs is called by it and hides the
/// instance.
pub(super) fn spot(variable: &Local, machine: &Machine, registers: &Registers) -> Option<Spot> {
    let index = machine.frames.iter().rposition(|frame| frame.block == variable.block)?;
    let frame = &machine.frames[index];
    let newest = index + 1 == machine.frames.len();
    let mut file = load_file(registers);
    let local = |outwards: usize| match index.checked_sub(outwards).and_then(|index| machine.frames.get(index)) {
        Some(frame) => {
            let start = machine.memory.layout.local.start + frame.local_base as usize;
            start..start + frame.local_size as usize
        }
        None => 0..0,
    };
    let given = |index: u16| {
        let at = frame.parameters.checked_add(u32::from(index)).filter(|&at| at < frame.parameters_end)?;
        machine.parameters.get(at as usize).map(|&pointer| u64::from(pointer))
    };
    // Where a POINTER lies that leads on: number of the data block, pointer.
    let behind = |place: Place, file: &mut access::File| -> Option<()> {
        let access::Target::Arena(at, _) = locate_far(machine, file, &local, place, Width::DoubleWord, false).ok()? else {
            return None;
        };
        let bytes = machine.memory.arena.get(at..at + 6)?;
        let number = u64::from(u16::from_be_bytes([bytes[0], bytes[1]]));
        let pointer = u64::from(u32::from_be_bytes([bytes[2], bytes[3], bytes[4], bytes[5]]));
        file[usize::from(POINTER.0)] = number << 32 | pointer;
        Some(())
    };
    let instance = |position: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: position };
    let place = match variable.start {
        Start::Temp(position) => Place::Fixed { area: Area::Local, position },
        // DI and AR2 are those of the block that runs now.
        Start::Instance(_) | Start::InstancePointer { .. } if !newest => return None,
        Start::Instance(position) => instance(position),
        Start::InstancePointer { position, offset } => {
            behind(instance(position), &mut file)?;
            Place::Crossing { pointer: POINTER, offset }
        }
        Start::Parameter { index, offset } => {
            file[usize::from(POINTER.0)] = given(index)?;
            Place::Crossing { pointer: POINTER, offset }
        }
        Start::ParameterPointer { index, offset } => {
            file[usize::from(POINTER.0)] = given(index)?;
            behind(Place::Crossing { pointer: POINTER, offset: 0 }, &mut file)?;
            Place::Crossing { pointer: POINTER, offset }
        }
        Start::Number(index) => return Some(Spot::Number(given(index)? as u16)),
    };
    match locate_far(machine, &file, &local, place, variable.width().unwrap_or(Width::Byte), false).ok()? {
        access::Target::Arena(at, bit) => Some(Spot::Arena(at, bit)),
        access::Target::Peripheral(_) => None,
    }
}
