//! SFC 5 GADR_LGC: the logical address of a slot.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::modules::IOID_INPUT;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};
use crate::slots::{FIRST_SLOT, plugged};

pub(super) const ROW: Row = sfc(5, "GADR_LGC", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("SUBNETID", DataType::Byte),
    input("RACK", DataType::Word),
    input("SLOT", DataType::Word),
    input("SUBSLOT", DataType::Byte),
    input("SUBADDR", DataType::Word),
    ret_val(),
    output("IOID", DataType::Byte),
    output("LADDR", DataType::Word),
];

const NO_SUBNET: u16 = 0x8094;
const BAD_RACK: u16 = 0x8095;
const BAD_SLOT: u16 = 0x8096;
const BAD_SUBSLOT: u16 = 0x8097;
const BAD_OFFSET: u16 = 0x8098;
const NOT_CONFIGURED: u16 = 0x8099;

/// Greatest number of a rack.
const RACK_MAX: u32 = 21;
/// Greatest number of a slot.
const SLOT_MAX: u32 = 18;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let subnet = call.input(0, Width::Byte)?;
    let rack = call.input(1, Width::Word)?;
    let slot = call.input(2, Width::Word)?;
    let subslot = call.input(3, Width::Byte)?;
    let offset = call.input(4, Width::Word)?;
    if subnet != 0 {
        return Err(NO_SUBNET);
    }
    if rack > RACK_MAX {
        return Err(BAD_RACK);
    }
    if slot == 0 || slot > SLOT_MAX + u32::from(FIRST_SLOT) {
        return Err(BAD_SLOT);
    }
    if subslot != 0 {
        return Err(BAD_SUBSLOT);
    }
    let found = plugged(call.host.rack).find(|plugged| rack == 0 && u32::from(plugged.slot) == slot).ok_or(NOT_CONFIGURED)?;
    // A module with inputs and outputs is named by its inputs.
    let output = found.bytes(false).is_empty();
    let bytes = found.bytes(output);
    let address = bytes.start + offset;
    if !bytes.contains(&address) {
        return Err(BAD_OFFSET);
    }
    call.output(6, Width::Byte, u32::from(IOID_INPUT) + u32::from(output))?;
    call.output(7, Width::Word, address)?;
    Ok(0)
}
