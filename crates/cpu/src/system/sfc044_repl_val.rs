//! SFC 44 REPL_VAL: the value that a failed load delivers.

use sieben_engine::machine::Origin;
use sieben_model::address::Width;
use sieben_model::types::DataType;

use crate::organization_blocks as ob;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(44, "REPL_VAL", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("VAL", DataType::DoubleWord), ret_val()];

/// Called outside OB 121 and OB 122.
const NOT_HERE: u16 = 0x8080;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let value = call.input(0, Width::DoubleWord)?;
    let innermost = call.machine.frames.iter_mut().rev().find(|frame| !matches!(frame.origin, Origin::Call(_))).ok_or(NOT_HERE)?;
    if !matches!(innermost.block, ob::PROGRAMMING_ERROR | ob::IO_ACCESS_ERROR) {
        return Err(NOT_HERE);
    }
    // After a failed transfer there is nothing to deliver.
    if let Origin::Interrupt { deliver: Some((_, delivered)), .. } = &mut innermost.origin {
        *delivered = value;
    }
    Ok(0)
}
