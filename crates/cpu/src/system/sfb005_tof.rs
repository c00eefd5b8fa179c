//! SFB 5 TOF: an off delay.

use super::iec_timer::{self, IecTimer, VARIABLES};
use super::{Row, sfb};

pub(super) const ROW: Row = sfb(5, "TOF", VARIABLES, |call| iec_timer::call(call, step));

fn step(timer: &mut IecTimer<'_>) {
    if timer.input {
        timer.stop();
    } else if timer.before {
        timer.start();
    } else {
        timer.update();
    }
    timer.q = timer.input || timer.running;
}
