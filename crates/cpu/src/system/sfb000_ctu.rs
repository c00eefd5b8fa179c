//! SFB 0 CTU: counts up.

use sieben_model::types::DataType;

use super::instance::Instance;
use super::{Call, Parameter, Row, input, output, sfb, stored};

pub(super) const ROW: Row = sfb(0, "CTU", VARIABLES, run);

const VARIABLES: &[Parameter] = &[
    input("CU", DataType::Bool),
    input("R", DataType::Bool),
    input("PV", DataType::Int),
    output("Q", DataType::Bool),
    output("CV", DataType::Int),
    stored("CUO", DataType::Bool),
];

fn run(call: &mut Call<'_, '_>) -> bool {
    let Some(mut instance) = Instance::open(call.machine, 10) else { return false };
    let edge = instance.rising(8, 0, instance.bit(0, 0));
    let mut count = instance.int(6);
    if instance.bit(0, 1) {
        count = 0;
    } else if edge {
        count = count.saturating_add(1);
    }
    instance.set_int(6, count);
    instance.set_bit(4, 0, count >= instance.int(2));
    true
}
