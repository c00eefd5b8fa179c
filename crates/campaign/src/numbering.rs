//! The numbers of the scenarios: what each stands for.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use crate::spec::Spec;

/// Most bits of which every combination is tried, one by one: a million a second take two weeks for them.
pub const BITS_MAX: usize = 40;
/// Most scenarios of a campaign.
pub const SCENARIOS_MAX: u64 = 1 << 62;

/// How the scenarios of a campaign are numbered: the combination of bits runs fastest, then the sample, then the sweeps, the last one first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbering {
    bits: u32,
    samples: u64,
    sweeps: Vec<u64>,
    count: u64,
}

/// What a number stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    /// The bits of `[exhaustive]`, the first one in bit 0.
    pub combination: u64,
    /// Of each sweep the place of its value.
    pub sweep: Vec<usize>,
    /// The sample at this point of the grid, from 0.
    pub sample: u64,
}

impl Numbering {
    /// Of a campaign whose `[exhaustive]` has so many bits.
    ///
    /// # Errors
    /// There are more scenarios than can be numbered.
    pub fn new(spec: &Spec, bits: usize) -> Result<Self, Box<Diagnostic>> {
        let place = |span: Option<Span>| span.unwrap_or_else(|| spec.span());
        if bits > BITS_MAX {
            let first = spec.exhaustive.as_ref().and_then(|exhaustive| exhaustive.inputs.first()).map(|input| input.span);
            let message = format!("{bits} bits have 2^{bits} combinations; {BITS_MAX} bits are the limit");
            let told = Diagnostic::new(Problem::P7158, place(first), message);
            return Err(Box::new(told.help("leave out inputs that do not matter here, or draw them")));
        }
        let sweeps: Vec<u64> = spec.sweep.iter().map(|sweep| sweep.values.len().max(1) as u64).collect();
        let all = sweeps.iter().copied().chain([spec.samples.max(1)]);
        let count = all.map(u128::from).try_fold(1_u128 << bits, u128::checked_mul).filter(|&count| count <= u128::from(SCENARIOS_MAX));
        let Some(count) = count else {
            let message = "there are more than 2^62 scenarios: combinations, values of sweeps and samples are multiplied".to_owned();
            let first = spec.sweep.first().map(|sweep| sweep.name.span);
            let told = Diagnostic::new(Problem::P7158, place(first), message);
            return Err(Box::new(told.help("draw values instead of trying all of them: `samples` says how many")));
        };
        Ok(Self { bits: bits as u32, samples: spec.samples.max(1), sweeps, count: count as u64 })
    }

    /// How many scenarios there are.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// What a number stands for.
    pub fn point(&self, number: u64) -> Point {
        let combination = number & ((1 << self.bits) - 1);
        let mut rest = number >> self.bits;
        let mut digit = |base: u64| {
            let digit = rest % base;
            rest /= base;
            digit
        };
        let sample = digit(self.samples);
        let mut sweep: Vec<usize> = self.sweeps.iter().rev().map(|&base| digit(base) as usize).collect();
        sweep.reverse();
        Point { combination, sweep, sample }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use sieben_model::source::FileId;

    use super::*;
    use crate::spec::{Placed, Sweep, Value};

    fn spec(samples: u64, sweeps: &[usize]) -> Spec {
        let name = Placed { text: String::new(), span: Span::new(FileId(0), 0, 0) };
        let sweep = |&count: &usize| Sweep { name: name.clone(), values: vec![Value::Number(0.0); count], unit: None };
        Spec { samples, sweep: sweeps.iter().map(sweep).collect(), ..Spec::default() }
    }

    #[test]
    fn every_number_is_another_point_and_the_last_sweep_runs_fastest() {
        let numbering = Numbering::new(&spec(3, &[2, 4]), 2).expect("few scenarios");
        assert_eq!(numbering.count(), 4 * 3 * 2 * 4);
        let points: Vec<Point> = (0..numbering.count()).map(|number| numbering.point(number)).collect();
        let all: HashSet<(u64, Vec<usize>, u64)> = points.iter().map(|p| (p.combination, p.sweep.clone(), p.sample)).collect();
        assert_eq!(all.len() as u64, numbering.count());
        assert_eq!(points[1], Point { combination: 1, sweep: vec![0, 0], sample: 0 });
        assert_eq!(points[4], Point { combination: 0, sweep: vec![0, 0], sample: 1 });
        assert_eq!(points[12], Point { combination: 0, sweep: vec![0, 1], sample: 0 });
        assert_eq!(points[48], Point { combination: 0, sweep: vec![1, 0], sample: 0 });
        assert!(points.iter().all(|point| point.combination < 4 && point.sample < 3 && point.sweep[0] < 2 && point.sweep[1] < 4));
    }

    #[test]
    fn what_cannot_be_numbered_is_refused() {
        let of = |samples, sweeps: &[usize], bits| Numbering::new(&spec(samples, sweeps), bits).map(|numbering| numbering.count());
        assert_eq!(of(1, &[], 40), Ok(1 << 40));
        assert!(of(1, &[], 41).is_err_and(|error| error.problem == Problem::P7158 && error.message.contains("2^41")));
        assert_eq!(of(1 << 62, &[], 0), Ok(1 << 62));
        assert!(of(u64::MAX, &[1000, 1000], 40).is_err_and(|error| error.problem == Problem::P7158));
    }
}
