//! SFC 26 UPDAT_PI: reads the process image of the inputs now.

use sieben_model::address::Area;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(26, "UPDAT_PI", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("PART", DataType::Byte), ret_val(), output("FLADDR", DataType::Word)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    call.partition()?;
    let failed = call.host.rack.get_image(call.machine.memory.area_mut(Area::Input), true);
    call.wrote(call.machine.memory.layout.inputs.clone());
    call.exchanged(&failed)
}
