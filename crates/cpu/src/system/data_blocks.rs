//! What SFC 22 to 25 and 85 have in common: the data block that they name or make, and where data blocks are open.

use sieben_engine::Machine;
use sieben_engine::machine::Origin;
use sieben_model::address::Width;

use super::Call;
use crate::created_data_blocks::{insert, place, room};

/// No number of a data block.
pub(super) const BAD_NUMBER: u16 = 0x80A1;
/// There is no such data block.
pub(super) const NOT_THERE: u16 = 0x80B1;
/// The data block is only in the load memory (UNLINKED).
pub(super) const UNLINKED: u16 = 0x80B2;
/// The length is 0 or odd.
const BAD_LENGTH: u16 = 0x80A2;
/// No number of the range is free.
const NO_NUMBER: u16 = 0x80B1;

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

    /// Makes a data block from the first three parameters, LOW_LIMIT, UP_LIMIT and COUNT; its number goes to parameter `number_at`.
    pub(super) fn make_data_block(&mut self, number_at: usize) -> Result<u16, u16> {
        let low = self.input(0, Width::Word)? as u16;
        let high = self.input(1, Width::Word)? as u16;
        let length = self.input(2, Width::Word)?;
        if low == 0 || low > high || high > self.machine.memory.layout.db_number_max {
            return Err(BAD_NUMBER);
        }
        if length == 0 || !length.is_multiple_of(2) {
            return Err(BAD_LENGTH);
        }
        let program = &self.host.program.data;
        let memory = &self.machine.memory;
        let free = |number: &u16| memory.data_block(u64::from(*number)).is_none() && !program.contains_key(number);
        let number = (low..=high).find(free).ok_or(NO_NUMBER)?;
        let base = place(self.machine, room(length))?;
        // A number that cannot be delivered must not leave a block behind.
        self.output(number_at, Width::Word, u32::from(number))?;
        insert(self.machine, number, base, length, false);
        Ok(number)
    }
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
