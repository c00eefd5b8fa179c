//! SFC 47 WAIT: holds the program up.

use sieben_engine::Reaction;
use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::{Call, Parameter, Row, Run, input, sfc};

pub(super) const ROW: Row = sfc(47, "WAIT", PARAMETERS, Run::Reaction(run));

const PARAMETERS: &[Parameter] = &[input("WT", DataType::Int)];

fn run(call: &mut Call<'_, '_>) -> Reaction {
    let microseconds = call.input(0, Width::Word);
    call.machine.registers.br = u64::from(microseconds.is_ok());
    let wait = microseconds.map_or(0, |word| i64::from(word as u16 as i16)).max(0);
    call.host.wait(call.machine, wait as u64);
    Reaction::Continue
}
