//! SFB 3 TP: a pulse.

use super::iec_timer::{self, IecTimer, VARIABLES};
use super::{Row, sfb};

pub(super) const ROW: Row = sfb(3, "TP", VARIABLES, |call| iec_timer::call(call, step));

fn step(timer: &mut IecTimer<'_>) {
    timer.update();
    if timer.input && !timer.before && !timer.running {
        timer.start();
    } else if !timer.input && !timer.running {
        timer.stop();
    }
    timer.q = timer.running;
}
