//! What the code of GET_ERROR and GET_ERR_ID asks: blocks that handle their synchronous errors themselves.

use sieben_engine::{Fault, FaultPlace, Machine, Reaction};
use sieben_model::address::Width;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::extension::{FIRST_ERROR, HANDLE_ERRORS};
use sieben_model::types::DataType;

use super::declaration::RET_VAL;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, output};
use crate::system_state::{Handler, OwnError};

pub(super) static CALLED: &[Row] = &[
    Row { block: FIRST_ERROR, name: "__FIRST_ERROR", parameters: PARAMETERS, run: Run::Reaction(first_error), only: None },
    Row { block: HANDLE_ERRORS, name: "__HANDLE_ERRORS", parameters: &[], run: Run::Reaction(handle_errors), only: None },
];

/// 0 or the number of the error, and what an ErrorStruct says of it.
const PARAMETERS: &[Parameter] = &[
    output(RET_VAL, DataType::Word),
    output("REACTION", DataType::Byte),
    output("BLOCK_TYPE", DataType::Byte),
    output("CB_NUMBER", DataType::UnsignedInt),
    output("OFFSET", DataType::UnsignedDoubleInt),
];

/// A value that was to be written is lost, 0 was read instead, or the rest of the statement is left out.
const IGNORED: u8 = 0;
const REPLACED: u8 = 1;
const LEFT_OUT: u8 = 2;

fn reaction_to(fault: &Fault) -> u8 {
    match fault.event() {
        _ if !fault.is_noted() => LEFT_OUT,
        0x2522 => REPLACED,
        _ => IGNORED,
    }
}

/// Keeps the error if the running block handles its errors itself; whether it does.
pub(crate) fn keeps(handlers: &mut [Handler], machine: &Machine, fault: &Fault, place: FaultPlace) -> bool {
    let is_own = |one: &&mut Handler| one.depth == machine.frames.len() && one.block == place.block;
    let Some(handler) = handlers.iter_mut().rev().find(is_own) else { return false };
    if matches!(fault, Fault::Abort(_)) {
        return false;
    }
    handler.first.get_or_insert(OwnError { event: fault.event(), reaction: reaction_to(fault), place });
    true
}

/// The running block begins.
fn handle_errors(call: &mut Call<'_, '_>) -> Reaction {
    let depth = call.machine.frames.len();
    let handlers = &mut call.host.system.handlers;
    // What was as deep or deeper has ended.
    handlers.retain(|one| one.depth < depth);
    handlers.extend(call.machine.frames.last().map(|frame| Handler { depth, block: frame.block, first: None }));
    Reaction::Continue
}

fn first_error(call: &mut Call<'_, '_>) -> Reaction {
    let depth = call.machine.frames.len();
    let own = call.host.system.handlers.iter_mut().find(|one| one.depth == depth);
    let first = own.and_then(|one| one.first.take());
    // The places lie in the local data of the block that asks.
    let answered = tell(call, first);
    call.machine.registers.br = u8::from(answered.is_ok()).into();
    Reaction::Continue
}

fn tell(call: &mut Call<'_, '_>, first: Option<OwnError>) -> Answer {
    let kind = |block: BlockId| match block.kind {
        BlockKind::OrganizationBlock => 1,
        BlockKind::Function => 2,
        _ => 3,
    };
    let told = first.map_or([0; 5], |OwnError { event, reaction, place }| {
        [event.into(), reaction.into(), kind(place.block), place.block.number.into(), place.statement]
    });
    for (index, (parameter, value)) in PARAMETERS.iter().zip(told).enumerate() {
        call.output(index, parameter.data_type().width().unwrap_or(Width::DoubleWord), value)?;
    }
    Ok(0)
}
