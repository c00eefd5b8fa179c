//! SFC 42 EN_AIRT: takes back one SFC 41.

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, ret_val, sfc};

pub(super) const ROW: Row = sfc(42, "EN_AIRT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[ret_val()];

const NOT_DELAYED: u16 = 0x8080;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let class = call.host.system.class(call.machine);
    class.delayed = class.delayed.checked_sub(1).ok_or(NOT_DELAYED)?;
    Ok(u32::from(class.delayed))
}
