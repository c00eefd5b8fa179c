//! SFC 35 MP_ALM: a multicomputing interrupt on all CPUs of the rack. This one is alone in its rack.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(35, "MP_ALM", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("JOB", DataType::Byte), ret_val()];

const BAD_JOB: u16 = 0x8090;
const NOT_MULTICOMPUTING: u16 = 0x80A1;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let job = call.input(0, Width::Byte)?;
    Err(if (1..=15).contains(&job) { NOT_MULTICOMPUTING } else { BAD_JOB })
}
