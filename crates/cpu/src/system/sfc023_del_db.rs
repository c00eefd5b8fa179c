//! SFC 23 DEL_DB: deletes a data block that the program made.

use sieben_engine::{Reaction, StopReason};
use sieben_model::types::DataType;

use super::created_data_blocks::for_each_open;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(23, "DEL_DB", PARAMETERS, Run::Reaction(run));

const PARAMETERS: &[Parameter] = &[input("DB_NUMBER", DataType::Word), ret_val()];

/// The data block comes from the load memory, where the program cannot delete it.
const IN_LOAD_MEMORY: u16 = 0x80B3;
/// STOP by a programming error.
const STOP: u16 = 0x4562;

fn run(call: &mut Call<'_, '_>) -> Reaction {
    let number = match call.db_number() {
        Ok(number) if call.host.program.data.contains_key(&number) => Err(IN_LOAD_MEMORY),
        other => other,
    };
    let answer = match number {
        Ok(number) => {
            let mut open = false;
            for_each_open(call.machine, |other, _| open |= other == u64::from(number));
            if open {
                return Reaction::Stop(StopReason { event: STOP, place: None });
            }
            call.machine.memory.data_blocks[usize::from(number)] = None;
            Ok(0)
        }
        Err(code) => Err(code),
    };
    call.answer(PARAMETERS, answer);
    Reaction::Continue
}
