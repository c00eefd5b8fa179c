//! SFC 23 DEL_DB: deletes a data block that the program made.

use sieben_engine::{Fault, Reaction};
use sieben_model::types::DataType;

use super::data_blocks::for_each_open;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(23, "DEL_DB", PARAMETERS, Run::Reaction(run));

const PARAMETERS: &[Parameter] = &[input("DB_NUMBER", DataType::Word), ret_val()];

/// The data block comes from the load memory, where the program cannot delete it.
const IN_LOAD_MEMORY: u16 = 0x80B3;
/// Write errors of OB 121: the data block is open as a shared one, or as an instance.
const OPEN_SHARED: u8 = 0x30;
const OPEN_INSTANCE: u8 = 0x31;

fn run(call: &mut Call<'_, '_>) -> Reaction {
    let number = match call.db_number() {
        Ok(number) if call.host.program.data.contains_key(&number) => Err(IN_LOAD_MEMORY),
        other => other,
    };
    let answer = match number {
        Ok(number) => {
            if let Some(code) = open(call, number) {
                return Reaction::Fail(Fault::Programming { code, register: number, access: 0 });
            }
            call.machine.memory.data_blocks[usize::from(number)] = None;
            call.host.system.non_retain.remove(&number);
            Ok(0)
        }
        Err(code) => Err(code),
    };
    call.answer(PARAMETERS, answer);
    Reaction::Continue
}

/// The error of a data block that a running block, of whatever priority class, has open.
fn open(call: &mut Call<'_, '_>, number: u16) -> Option<u8> {
    let number = u64::from(number);
    let mut anywhere = false;
    for_each_open(call.machine, |other, _| anywhere |= other == number);
    let instance = call.machine.registers.di_number == number && call.machine.registers.db_number != number;
    anywhere.then_some(if instance { OPEN_INSTANCE } else { OPEN_SHARED })
}
