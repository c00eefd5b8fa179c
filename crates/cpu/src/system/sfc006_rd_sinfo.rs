//! SFC 6 RD_SINFO: start information of the running and of the last startup organization block.

use std::sync::Arc;

use sieben_model::interface::Section;
use sieben_model::types::{DataType, Field, Structure};

use crate::start_information::StartInformation;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, made, ret_val, sfc};

pub(super) const ROW: Row = sfc(6, "RD_SINFO", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] =
    &[ret_val(), made("TOP_SI", Section::Output, start_information), made("START_UP_SI", Section::Output, start_information)];

/// The first 12 bytes of start information.
const BYTES: usize = 12;

fn start_information() -> DataType {
    let field = |name: &str, data_type, byte: u32| Field {
        name: name.to_owned(),
        data_type,
        offset: byte * 8,
        initial: Vec::new(),
        comment: String::new(),
    };
    DataType::Struct(Arc::new(Structure {
        name: None,
        fields: vec![
            field("EV_CLASS", DataType::Byte, 0),
            field("EV_NUM", DataType::Byte, 1),
            field("PRIORITY", DataType::Byte, 2),
            field("NUM", DataType::Byte, 3),
            field("TYP2_3", DataType::Byte, 4),
            field("TYP1", DataType::Byte, 5),
            field("ZI1", DataType::Word, 6),
            field("ZI2_3", DataType::DoubleWord, 8),
        ],
        size: BYTES as u32,
        index: Default::default(),
    }))
}

fn run(call: &mut Call<'_, '_>) -> Answer {
    let top = call.host.system.innermost(call.machine).unwrap_or(call.host.class);
    let startup = call.host.system.startup;
    for (index, information) in [(1, top), (2, startup)] {
        let bytes = StartInformation::bytes(&information, call.host.date_and_time());
        call.complex_output(index, &bytes[..BYTES])?;
    }
    Ok(0)
}
