//! What is drawn: numbers that look random, and depend on nothing but a seed, the number of a scenario and a name.

use sieben_sim::devices::random::Random;

use crate::spec::Law;

/// The output of SplitMix64 for a state: every bit of it depends on every bit of the state.
pub fn mix(state: u64) -> u64 {
    Random::new(state).next()
}

/// The seed of a scenario.
pub fn seed_of(seed: u64, scenario: u64) -> u64 {
    mix(mix(seed) ^ scenario)
}

/// FNV-1a of a name, 64 bits.
fn fnv(name: &str) -> u64 {
    name.bytes().fold(0xCBF2_9CE4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3))
}

/// The draws of one name in one scenario: another name has others, so that one that is added changes none that are there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stream {
    state: u64,
}

impl Stream {
    /// The draws of a name in a scenario with this seed.
    pub fn new(seed_of_scenario: u64, name: &str) -> Self {
        Self { state: mix(seed_of_scenario ^ fnv(name)) }
    }

    /// The next 64 bits.
    pub fn next_u64(&mut self) -> u64 {
        let drawn = mix(self.state);
        self.state = self.state.wrapping_add(1);
        drawn
    }

    /// The next number from 0 up to, but not including, 1.
    pub fn fraction(&mut self) -> f64 {
        let fraction = Random::new(self.state).fraction();
        self.state = self.state.wrapping_add(1);
        fraction
    }

    /// The place of one of so many things; 0 if there is none.
    pub fn index(&mut self, count: usize) -> usize {
        ((u128::from(self.next_u64()) * count as u128) >> 64) as usize
    }

    /// A number of a distribution: always one draw.
    pub fn draw(&mut self, law: &Law) -> f64 {
        let fraction = self.fraction();
        match *law {
            Law::Fixed(value) => value,
            Law::Uniform(from, to) => from + (to - from) * fraction,
            Law::Normal(mean, deviation) => mean + deviation * normal(fraction),
            Law::LogUniform(from, to) => {
                let (low, high) = (libm::log(from), libm::log(to));
                libm::exp(low + (high - low) * fraction).clamp(from, to)
            }
        }
    }
}

/// The inverse of the distribution function of the normal distribution: Acklam's rational approximation (relative error 1.2e-9), with one
/// step of Halley's method, which makes it as exact as a float is. Only operations and functions that are the same on every machine.
fn normal(fraction: f64) -> f64 {
    // The upper half is the lower one with the other sign; next to 1 a float has not the room that it has next to 0.
    if fraction >= 0.5 {
        return -normal(1.0 - 1.0 / (1_u64 << 53) as f64 - fraction);
    }
    // The middle of the cell that the fraction stands for: 0 would be infinitely far away.
    let p = fraction + 0.5 / (1_u64 << 53) as f64;
    let estimate = acklam(p);
    let error = 0.5 * libm::erfc(-estimate / std::f64::consts::SQRT_2) - p;
    let step = error * libm::sqrt(2.0 * std::f64::consts::PI) * libm::exp(estimate * estimate / 2.0);
    estimate - step / (1.0 + estimate * step / 2.0)
}

fn acklam(p: f64) -> f64 {
    const A: [f64; 6] = [
        -3.969_683_028_665_376e1,
        2.209_460_984_245_205e2,
        -2.759_285_104_469_687e2,
        1.383_577_518_672_69e2,
        -3.066_479_806_614_716e1,
        2.506_628_277_459_239,
    ];
    const B: [f64; 6] = [
        -5.447_609_879_822_406e1,
        1.615_858_368_580_409e2,
        -1.556_989_798_598_866e2,
        6.680_131_188_771_972e1,
        -1.328_068_155_288_572e1,
        1.0,
    ];
    const C: [f64; 6] = [
        -7.784_894_002_430_293e-3,
        -3.223_964_580_411_365e-1,
        -2.400_758_277_161_838,
        -2.549_732_539_343_734,
        4.374_664_141_464_968,
        2.938_163_982_698_783,
    ];
    const D: [f64; 5] = [7.784_695_709_041_462e-3, 3.224_671_290_700_398e-1, 2.445_134_137_142_996, 3.754_408_661_907_416, 1.0];
    /// Below it and above its complement the tails begin.
    const TAIL: f64 = 0.02425;
    let polynomial = |coefficients: &[f64], x: f64| coefficients.iter().fold(0.0, |sum, coefficient| sum * x + coefficient);
    let tail = |p: f64| {
        let q = libm::sqrt(-2.0 * libm::log(p));
        polynomial(&C, q) / polynomial(&D, q)
    };
    if p < TAIL {
        tail(p)
    } else if p > 1.0 - TAIL {
        -tail(1.0 - p)
    } else {
        let q = p - 0.5;
        polynomial(&A, q * q) * q / polynomial(&B, q * q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_are_the_same_for_ever() {
        // The first outputs of SplitMix64 with the seed 0, by its authors' table.
        assert_eq!(mix(0), 0xE220_A839_7B1D_CDAF);
        assert_eq!(mix(0x9E37_79B9_7F4A_7C15), 0x6E78_9E6A_A1B9_65F4);
        assert_eq!(fnv(""), 0xCBF2_9CE4_8422_2325);
        assert_eq!(fnv("a"), 0xAF63_DC4C_8601_EC8C);
        assert_eq!(seed_of(7, 0), mix(mix(7)));
        let mut stream = Stream::new(seed_of(7, 123_456_789), "oven.gain");
        let first = stream.next_u64();
        assert_eq!(first, mix(mix(seed_of(7, 123_456_789) ^ fnv("oven.gain"))));
        assert_ne!(first, Stream::new(seed_of(7, 123_456_789), "oven.noise").next_u64());
    }

    #[test]
    fn the_inverse_of_the_normal_distribution_is_that_of_the_tables() {
        for (p, x) in
            [(0.5, 0.0), (0.975, 1.959_963_984_540_054), (0.84134474606854, 0.999_999_999_999_987), (0.001, -3.090_232_306_167_813)]
        {
            assert!((normal(p) - x).abs() < 1e-9, "{p}: {}", normal(p));
        }
        let ends = [normal(0.0), normal(1.0 - 1.0 / (1_u64 << 53) as f64)];
        assert!(ends.iter().all(|end| end.is_finite() && end.abs() > 8.0 && end.abs() < 9.0), "{ends:?}");
    }

    #[test]
    fn each_law_has_its_mean_and_its_limits() {
        let mean = |law: Law| {
            let mut stream = Stream::new(1, "x");
            (0..20_000).map(|_| stream.draw(&law)).sum::<f64>() / 20_000.0
        };
        assert_eq!(mean(Law::Fixed(3.0)), 3.0);
        assert!((mean(Law::Uniform(-1.0, 3.0)) - 1.0).abs() < 0.03);
        assert!((mean(Law::Normal(180.0, 8.0)) - 180.0).abs() < 0.2);
        // (b - a) / ln(b / a)
        assert!((mean(Law::LogUniform(1.0, 100.0)) - 99.0 / libm::log(100.0)).abs() < 0.6);
        let mut stream = Stream::new(1, "x");
        let counts = (0..6_000).fold([0; 3], |mut counts, _| {
            counts[stream.index(3)] += 1;
            counts
        });
        assert!(counts.iter().all(|count| (1_850..2_150).contains(count)), "{counts:?}");
        assert_eq!(stream.index(0), 0);
    }
}
