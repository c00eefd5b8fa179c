//! SFC 43 RE_TRIGR: restarts the cycle time monitoring.

use sieben_engine::Reaction;

use super::Call;

pub(super) fn run(call: &mut Call<'_, '_>) -> Reaction {
    call.host.restart_watchdog(call.machine);
    Reaction::Continue
}
