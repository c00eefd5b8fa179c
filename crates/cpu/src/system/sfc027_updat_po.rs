//! SFC 27 UPDAT_PO: writes the process image of the outputs now.

use sieben_engine::image_writes::ANYWHERE;
use sieben_model::address::Area;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(27, "UPDAT_PO", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("PART", DataType::Byte), ret_val(), output("FLADDR", DataType::Word)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    call.partition()?;
    let failed = call.host.rack.put_image(call.machine.memory.area(Area::Output), ANYWHERE);
    call.exchanged(&failed)
}
