//! Numbers that look random and are the same for the same seed.

/// The generator splitmix64: one addition and a mixing of the bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Random(u64);

impl Random {
    /// A row of numbers of its own for each seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }
    /// The next 64 bits.
    #[expect(clippy::should_implement_trait, reason = "an iterator that never ends would need an Option around each number")]
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.0;
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ mixed >> 31
    }
    /// The next number from 0 up to, but not including, 1.
    pub fn fraction(&mut self) -> f64 {
        // 53 bits are what a float holds exactly.
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
    /// The next number from -1 to 1.
    pub fn around_zero(&mut self) -> f64 {
        2.0 * self.fraction() - 1.0
    }
    /// The next distance between two arrivals, in steps: between half and one and a half times the mean.
    pub fn gap(&mut self, mean_s: f64) -> u64 {
        let mean_steps = mean_s * 1e6 / super::STEP_US as f64;
        (mean_steps * (0.5 + self.fraction())) as u64
    }
}
