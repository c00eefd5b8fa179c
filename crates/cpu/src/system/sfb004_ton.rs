//! SFB 4 TON: an on delay.

use super::iec_timer::{self, IecTimer, VARIABLES};
use super::{Row, sfb};

pub(super) const ROW: Row = sfb(4, "TON", VARIABLES, |call| iec_timer::call(call, step));

fn step(timer: &mut IecTimer<'_>) {
    if !timer.input {
        timer.stop();
    } else if timer.running {
        timer.update();
    } else if !timer.elapsed {
        timer.start();
    }
    timer.q = timer.elapsed;
}
