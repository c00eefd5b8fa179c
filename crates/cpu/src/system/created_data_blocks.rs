//! What SFC 22, 23, 24 and 25 have in common: room for data blocks that the program makes, and where they are open.

use std::ops::Range;

use sieben_engine::Machine;
use sieben_engine::machine::{Origin, layout::RESERVE};
use sieben_model::address::Width;

use super::Call;

/// No number of a data block.
pub(super) const BAD_NUMBER: u16 = 0x80A1;
/// There is no such data block.
pub(super) const NOT_THERE: u16 = 0x80B1;
/// The data block is only in the load memory (UNLINKED).
pub(super) const UNLINKED: u16 = 0x80B2;

impl Call<'_, '_> {
    /// The number of a data block that is in the work memory, from parameter 0.
    pub(super) fn db_number(&mut self) -> Result<u16, u16> {
        let number = self.input(0, Width::Word)? as u16;
        if number == 0 || number > self.machine.memory.layout.db_number_max {
            return Err(BAD_NUMBER);
        }
        match self.machine.memory.data_block(u64::from(number)) {
            Some(_) => Ok(number),
            None if self.host.program.data.contains_key(&number) => Err(UNLINKED),
            None => Err(NOT_THERE),
        }
    }
}

/// The bytes that the arena keeps for data blocks made at run time.
pub(super) fn reserve(machine: &Machine) -> Range<usize> {
    let end = machine.memory.layout.size.min(machine.memory.arena.len());
    end.saturating_sub(RESERVE)..end
}

/// What created data blocks take of the reserve, in the order of their places.
pub(super) fn taken(machine: &Machine) -> Vec<(usize, u16)> {
    let reserve = reserve(machine);
    let mut taken: Vec<(usize, u16)> = machine
        .memory
        .data_blocks
        .iter()
        .enumerate()
        .filter_map(|(number, entry)| Some((entry.as_ref()?.base as usize, number as u16)))
        .filter(|(base, _)| reserve.contains(base))
        .collect();
    taken.sort_unstable();
    taken
}

/// The bytes from the beginning of a created data block to the next possible one.
pub(super) fn room(bytes: u32) -> usize {
    (bytes as usize).next_multiple_of(8)
}

/// Every place that remembers an open data block: number and base, in the registers and in what block ends restore.
pub(super) fn for_each_open(machine: &mut Machine, mut change: impl FnMut(u64, &mut u64)) {
    let mut both = |registers: &mut sieben_engine::machine::Registers| {
        change(registers.db_number, &mut registers.db_base);
        change(registers.di_number, &mut registers.di_base);
    };
    both(&mut machine.registers);
    for frame in &mut machine.frames {
        if let Origin::Interrupt { registers, .. } = &mut frame.origin {
            both(registers);
        }
    }
    for frame in &mut machine.frames {
        if let Origin::Call(caller) = &mut frame.origin {
            for [number, base, _] in [&mut caller.shared, &mut caller.instance] {
                change(*number, base);
            }
        }
    }
}
