//! SFC 43 RE_TRIGR: restarts the cycle time monitoring.

use sieben_engine::Reaction;

use super::{Call, Row, Run, sfc};

pub(super) const ROW: Row = sfc(43, "RE_TRIGR", &[], Run::Reaction(run));

fn run(call: &mut Call<'_, '_>) -> Reaction {
    call.host.restart_watchdog(call.machine);
    Reaction::Continue
}
