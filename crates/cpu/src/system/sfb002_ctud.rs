//! SFB 2 CTUD: counts up and down.

use sieben_model::types::DataType;

use super::instance::Instance;
use super::{Call, Parameter, Row, input, output, sfb, stored};

pub(super) const ROW: Row = sfb(2, "CTUD", VARIABLES, run);

const VARIABLES: &[Parameter] = &[
    input("CU", DataType::Bool),
    input("CD", DataType::Bool),
    input("R", DataType::Bool),
    input("LOAD", DataType::Bool),
    input("PV", DataType::Int),
    output("QU", DataType::Bool),
    output("QD", DataType::Bool),
    output("CV", DataType::Int),
    stored("CUO", DataType::Bool),
    stored("CDO", DataType::Bool),
];

fn run(call: &mut Call<'_, '_>) -> bool {
    let Some(mut instance) = Instance::open(call.machine, 10) else { return false };
    let up = instance.rising(8, 0, instance.bit(0, 0));
    let down = instance.rising(8, 1, instance.bit(0, 1));
    let preset = instance.int(2);
    let mut count = instance.int(6);
    if instance.bit(0, 2) {
        count = 0;
    } else if instance.bit(0, 3) {
        count = preset;
    } else if up && !down {
        count = count.saturating_add(1);
    } else if down && !up {
        count = count.saturating_sub(1);
    }
    instance.set_int(6, count);
    instance.set_bit(4, 0, count >= preset);
    instance.set_bit(4, 1, count <= 0);
    true
}
