//! SFC 51 RDSYSST: reads a part of the system status list.

use std::sync::Arc;

use sieben_model::address::Width;
use sieben_model::interface::Section;
use sieben_model::types::{DataType, Field, Structure};

use crate::mode::OperatingMode;
use crate::system_status_list::{NoList, SystemStatus};

use super::parameters::{Answer, NO_JOB};
use super::{Call, Parameter, Row, Run, input, made, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(51, "RDSYSST", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("SZL_ID", DataType::Word),
    input("INDEX", DataType::Word),
    ret_val(),
    output("BUSY", DataType::Bool),
    made("SZL_HEADER", Section::Output, header),
    output("DR", DataType::Any),
];

/// DR takes a part of the records, or not even one.
const PARTLY: u32 = 0x0081;
const TOO_SHORT: u16 = 0x8081;
const BAD_ID: u16 = 0x8082;
const BAD_INDEX: u16 = 0x8083;

/// Entries of the diagnostic buffer that a program on an S7-300 can read.
const ENTRIES_300: usize = 10;

fn header() -> DataType {
    let field = |name: &str, byte: u32| Field {
        name: name.to_owned(),
        data_type: DataType::Word,
        offset: byte * 8,
        initial: Vec::new(),
        comment: String::new(),
    };
    DataType::Struct(Arc::new(Structure {
        name: None,
        fields: vec![field("LENTHDR", 0), field("N_DR", 2)],
        size: 4,
        index: Default::default(),
    }))
}

fn run(call: &mut Call<'_, '_>) -> Answer {
    call.output(4, Width::Bit, 0)?;
    if call.input(0, Width::Bit)? == 0 {
        return Ok(NO_JOB);
    }
    let id = call.input(1, Width::Word)? as u16;
    let index = call.input(2, Width::Word)? as u16;
    let list = status(call).read(id, index).map_err(|what| match what {
        NoList::Id => BAD_ID,
        NoList::Index => BAD_INDEX,
    })?;
    let length = usize::from(list.record_bytes);
    let mut records = list.records;
    if id & 0x00FF == 0xA0 && call.host.cpu_type.accumulators == 2 {
        records.truncate(ENTRIES_300);
    }
    let area = call.any(6, true)?;
    let room = area.len() / length.max(1);
    let fit = records.len().min(room);
    for (at, &byte) in area.clone().zip(records[..fit].iter().flatten()) {
        call.machine.memory.arena[at] = byte;
    }
    call.wrote(area.start..area.start + fit * length);
    // Who asks for the header alone is told how many there are, else how many were delivered.
    let count = if records.is_empty() { list.count } else { fit as u16 };
    let bytes = [list.record_bytes.to_be_bytes(), count.to_be_bytes()].concat();
    call.complex_output(5, &bytes)?;
    match (records.len(), fit) {
        (all, fit) if all == fit => Ok(0),
        (_, 0) => Err(TOO_SHORT),
        _ => Ok(PARTLY),
    }
}

/// The CPU as the program sees it.
fn status<'c>(call: &'c mut Call<'_, '_>) -> SystemStatus<'c> {
    call.host.read_time(call.machine);
    let host = &*call.host;
    let now = call.machine.clock_us;
    let state = &*host.system;
    SystemStatus {
        cpu_type: host.cpu_type,
        program: host.program,
        rack: host.rack,
        diagnostics: host.diagnostics,
        mode: if host.watchdog.startup { OperatingMode::Startup } else { OperatingMode::Run },
        startup: state.startup,
        started: &state.started,
        time: host.date_and_time(),
        clock_status: state.clock.word(),
        meters: state.meter_hours(now),
        meters_running: state.meters_running(),
        communication: host.communication,
        forces: host.forces,
    }
}
