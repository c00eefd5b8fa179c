//! SFC 41 DIS_AIRT: delays interrupts of higher priority.

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, ret_val, sfc};

pub(super) const ROW: Row = sfc(41, "DIS_AIRT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[ret_val()];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let class = call.host.system.class(call.machine);
    class.delayed = class.delayed.saturating_add(1).min(i16::MAX as u16);
    Ok(u32::from(class.delayed))
}
