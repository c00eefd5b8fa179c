//! SFC 46 STP: sends the CPU to STOP.

use sieben_engine::{Reaction, StopReason};

use super::{Call, Row, Run, sfc};

/// STOP by the program.
const STOP_BY_PROGRAM: u16 = 0x457F;

pub(super) const ROW: Row = sfc(46, "STP", &[], Run::Reaction(run));

fn run(_call: &mut Call<'_, '_>) -> Reaction {
    Reaction::Stop(StopReason { event: STOP_BY_PROGRAM, place: None })
}
