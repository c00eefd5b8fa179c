//! Random numbers that programs nobody wrote are made with: the same ones in each run.

use std::ops::Range;

/// The numbers that random programs are made from. `cargo xtask soak programs` asks for so many times as many.
#[allow(clippy::disallowed_methods)] // Only how many there are is said from outside.
pub(crate) fn seeds(programs: u64) -> Range<u64> {
    let times = std::env::var("SIEBEN_TIMES").ok().and_then(|times| times.parse().ok());
    0..programs * times.unwrap_or(1)
}

/// Numbers that follow one another in no order.
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn roll(&mut self, sides: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % sides
    }

    pub(crate) fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.roll(all.len() as u64) as usize]
    }
}
