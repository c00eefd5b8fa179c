//! SFC 52 WR_USMSG: an entry of the program in the diagnostic buffer.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use crate::diagnostic_buffer::DiagnosticEntry;
use crate::start_information::StartInformation;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(52, "WR_USMSG", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("SEND", DataType::Bool),
    input("EVENTN", DataType::Word),
    input("INFO1", DataType::Any),
    input("INFO2", DataType::Any),
    ret_val(),
];

/// The type of INFO1, of INFO2.
const BAD_TYPE: [u16; 2] = [0x8083, 0x8084];
const BAD_EVENT: u16 = 0x8085;
/// The length of INFO1, of INFO2.
const BAD_LENGTH: [u16; 2] = [0x8086, 0x8087];
/// The entry is made, but no station has asked to be told.
const NO_STATION: u16 = 0x8091;

/// Type codes in an ANY: CHAR, WORD, INT, DATE, S5TIME fill one word, DWORD, DINT, REAL, TIME_OF_DAY and TIME two.
const TYPES: [&[u8]; 2] = [&[0x03, 0x04, 0x05, 0x09, 0x0C], &[0x03, 0x04, 0x05, 0x06, 0x07, 0x08, 0x0A, 0x0B]];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let send = call.input(0, Width::Bit)? == 1;
    let event = call.input(1, Width::Word)? as u16;
    // The program may use the event classes 8 to B; the bits behind the class tell coming from going and internal from external.
    if !(0x8000..=0xBFFF).contains(&event) {
        return Err(BAD_EVENT);
    }
    let mut infos = [0_u32; 2];
    for (index, info) in infos.iter_mut().enumerate() {
        let parameter = 2 + index;
        let [_, code, ..] = call.passed::<10>(parameter, false)?;
        if !TYPES[index].contains(&code) {
            return Err(BAD_TYPE[index]);
        }
        let bytes = call.any(parameter, false)?;
        if bytes.len() != 2 << index {
            return Err(BAD_LENGTH[index]);
        }
        *info = call.machine.memory.arena[bytes].iter().fold(0, |value, &byte| value << 8 | u32::from(byte));
    }
    call.host.read_time(call.machine);
    let running = call.host.system.innermost(call.machine).unwrap_or(call.host.class);
    let fields = StartInformation { event, info_1: infos[0] as u16, info_2: infos[1], data_id: 0, ..running };
    let time = call.host.date_and_time();
    call.host.diagnostics.push(DiagnosticEntry { fields, time, place: None });
    if send { Err(NO_STATION) } else { Ok(0) }
}
