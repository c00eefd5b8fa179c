//! SFC 46 STP: sends the CPU to STOP.

use sieben_engine::{Reaction, StopReason};

use super::Call;

/// STOP by the program.
const STOP_BY_PROGRAM: u16 = 0x457F;

pub(super) fn run(_call: &mut Call<'_, '_>) -> Reaction {
    Reaction::Stop(StopReason { event: STOP_BY_PROGRAM, place: None })
}
