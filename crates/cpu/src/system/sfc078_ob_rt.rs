//! SFC 78 OB_RT: how long an organization block ran.

use sieben_model::address::Width;
use sieben_model::block::BlockId;
use sieben_model::types::DataType;

use crate::organization_blocks as ob;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(78, "OB_RT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("OB_NR", DataType::Int),
    ret_val(),
    output("PRIO", DataType::Int),
    output("LAST_RT", DataType::DoubleInt),
    output("LAST_ET", DataType::DoubleInt),
    output("CUR_T", DataType::DoubleInt),
    output("CUR_RT", DataType::DoubleInt),
    output("CUR_ET", DataType::DoubleInt),
    output("NEXT_ET", DataType::DoubleInt),
];

/// OB_NR is no organization block that is loaded.
const BAD_BLOCK: u16 = 0x8080;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let asked = call.input(0, Width::Word)? as u16;
    call.host.read_time(call.machine);
    let now_us = call.host.now(call.machine).now_us;
    let interrupts = &call.host.interrupts;
    // 0 asks about the block that runs.
    let number = if asked == 0 { interrupts.run_times.innermost().map_or(0, |one| one.number) } else { asked };
    if !interrupts.is_available(number) {
        return Err(BAD_BLOCK);
    }
    let last = interrupts.run_times.last(number).unwrap_or_default();
    let running = interrupts.run_times.running(number);
    let since = |us: Option<u64>| us.map_or(0, |us| now_us.saturating_sub(us));
    let values = [
        last.run_us,
        last.elapsed_us,
        running.map_or(0, |one| one.requested_us),
        since(running.map(|one| one.started_us)),
        since(running.map(|one| one.requested_us)),
        since(interrupts.waits_since(number)),
    ];
    call.output(2, Width::Word, u32::from(ob::priority(BlockId::ob(number))))?;
    for (index, us) in values.into_iter().enumerate() {
        // A DINT of microseconds counts a little over half an hour and begins again.
        call.output(3 + index, Width::DoubleWord, (us % (1 << 31)) as u32)?;
    }
    Ok(u32::from(number))
}
