//! SFB 54 RALRM: why the running organization block was started, and by which module.

use sieben_model::types::DataType;

use crate::start_information::StartInformation;

use super::instance::Instance;
use super::{Call, Parameter, Row, in_out, input, output, sfb};

pub(super) const ROW: Row = sfb(54, "RALRM", VARIABLES, run);

const VARIABLES: &[Parameter] = &[
    input("MODE", DataType::Int),
    input("F_ID", DataType::DoubleWord),
    input("MLEN", DataType::Int),
    output("NEW", DataType::Bool),
    output("STATUS", DataType::DoubleWord),
    output("ID", DataType::DoubleWord),
    output("LEN", DataType::Int),
    in_out("TINFO", DataType::Any),
    in_out("AINFO", DataType::Any),
];

const MODE: usize = 0;
const F_ID: usize = 2;
const MLEN: usize = 6;
const NEW: usize = 8;
const STATUS: usize = 10;
const ID: usize = 14;
const LEN: usize = 18;
const TINFO: usize = 20;
const AINFO: usize = 30;
const BYTES: u32 = 40;

/// IO_FLAG of a module with outputs only, and the bit of ID that tells its address from one of inputs.
const OUTPUT_MODULE: u16 = 0x55;
const OUTPUT_ADDRESS: u32 = 0x8000;

/// STATUS: MODE has no such value; TINFO or AINFO is no area.
const BAD_MODE: u32 = 0xC080_C300;
const BAD_AREA: u32 = 0xC080_9200;

/// Start information and what tells the station, which is 0: the central rack.
const TINFO_BYTES: usize = 28;

fn run(call: &mut Call<'_, '_>) -> bool {
    let Some(instance) = Instance::open(call.machine, BYTES) else { return false };
    let mode = instance.int(MODE);
    let wanted = instance.double_word(F_ID);
    let room = usize::try_from(instance.int(MLEN)).unwrap_or(0);
    let any = |at: usize| -> [u8; 10] { std::array::from_fn(|index| instance.byte(at + index)) };
    let (task, alarm) = (any(TINFO), any(AINFO));
    let running = call.host.system.innermost(call.machine).unwrap_or(call.host.class);
    let cause = cause(&running);
    let answer = match mode {
        // Only who it was.
        0 => Ok((cause.is_some(), 0)),
        1 => deliver(call, &running, cause.map(|(_, info)| info), room, task, alarm).map(|length| (cause.is_some(), length)),
        2 if cause.is_some_and(|(id, _)| id == wanted) => {
            deliver(call, &running, cause.map(|(_, info)| info), room, task, alarm).map(|length| (true, length))
        }
        2 => Ok((false, 0)),
        _ => Err(BAD_MODE),
    };
    let Some(mut instance) = Instance::open(call.machine, BYTES) else { return false };
    let (new, length) = answer.unwrap_or_default();
    instance.set_bit(NEW, 0, new);
    instance.set_double_word(STATUS, answer.err().unwrap_or(0));
    instance.set_int(LEN, length);
    if answer.is_ok() {
        instance.set_double_word(ID, cause.map_or(0, |(id, _)| id));
    }
    answer.is_ok()
}

/// The address of the module that caused an interrupt, and four bytes about it.
fn cause(running: &StartInformation) -> Option<(u32, [u8; 4])> {
    // Hardware, diagnostic and insert/remove interrupts name their module.
    let output = if running.data_id & 0xFF == OUTPUT_MODULE { OUTPUT_ADDRESS } else { 0 };
    matches!(running.block, 40..=47 | 55..=57 | 82 | 83).then(|| (u32::from(running.info_1) | output, running.info_2.to_be_bytes()))
}

/// Fills TINFO and AINFO as far as they are given; the length of the interrupt information.
fn deliver(
    call: &mut Call<'_, '_>,
    running: &StartInformation,
    cause: Option<[u8; 4]>,
    room: usize,
    task: [u8; 10],
    alarm: [u8; 10],
) -> Result<i16, u32> {
    let mut information = [0; TINFO_BYTES];
    information[..20].copy_from_slice(&running.bytes(call.host.date_and_time()));
    fill(call, task, &information)?;
    let Some(cause) = cause else { return Ok(0) };
    let room = if room == 0 { cause.len() } else { room.min(cause.len()) };
    fill(call, alarm, &cause[..room])?;
    Ok(room as i16)
}

/// Copies as much as the area takes; an area that was not given takes nothing.
fn fill(call: &mut Call<'_, '_>, any: [u8; 10], bytes: &[u8]) -> Result<(), u32> {
    if any[1] == 0 {
        return Ok(());
    }
    let area = call.area(any, true).map_err(|_| BAD_AREA)?;
    for (at, &byte) in area.clone().zip(bytes) {
        call.machine.memory.arena[at] = byte;
    }
    call.wrote(area.start..area.end.min(area.start + bytes.len()));
    Ok(())
}
