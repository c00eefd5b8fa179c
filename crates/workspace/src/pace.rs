//! How the time of a CPU relates to that of the computer.

/// How fast the time of the CPU goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// So many times as fast as real time.
    Factor(f64),
    /// As fast as the computer goes, in virtual time.
    Max,
}

/// Least and greatest factor that users can ask for.
const FACTORS: std::ops::RangeInclusive<f64> = 0.001..=10_000.0;
/// The speeds that the keys of a screen step through.
const STEPS: [Speed; 11] = [
    Speed::Factor(0.1),
    Speed::Factor(0.25),
    Speed::Factor(0.5),
    Speed::Factor(1.0),
    Speed::Factor(2.0),
    Speed::Factor(5.0),
    Speed::Factor(10.0),
    Speed::Factor(20.0),
    Speed::Factor(50.0),
    Speed::Factor(100.0),
    Speed::Max,
];
/// What a computer is late and makes up for, in microseconds; what it is later than that, time waits for.
const LATE_US_MAX: u64 = 100_000;

impl Speed {
    /// Reads `1x`, `0.5x`, `10` or `max`.
    ///
    /// # Errors
    /// The text is no speed; the message says how to write one.
    pub fn parse(text: &str) -> Result<Self, String> {
        if text.eq_ignore_ascii_case("max") {
            return Ok(Self::Max);
        }
        let number = text.strip_suffix(['x', 'X']).unwrap_or(text);
        match number.parse::<f64>() {
            Ok(factor) if FACTORS.contains(&factor) => Ok(Self::Factor(factor)),
            _ => Err(format!("`{text}` is no speed; write `1x`, `0.5x`, `10x` (0.001x to 10000x) or `max`")),
        }
    }

    /// The next faster one that a key sets; the fastest one stays.
    #[must_use]
    pub fn faster(self) -> Self {
        STEPS.into_iter().find(|step| step.times() > self.times()).unwrap_or(self)
    }

    /// The next slower one that a key sets; the slowest one stays.
    #[must_use]
    pub fn slower(self) -> Self {
        STEPS.into_iter().rev().find(|step| step.times() < self.times()).unwrap_or(self)
    }

    /// How many times as fast as real time; without end for [`Self::Max`].
    fn times(self) -> f64 {
        if let Self::Factor(factor) = self { factor } else { f64::INFINITY }
    }

    /// Whether the CPU has the time of the computer.
    pub fn is_real(self) -> bool {
        self == Self::Factor(1.0)
    }
}

impl std::fmt::Display for Speed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Factor(factor) => write!(f, "{factor}x"),
            Self::Max => f.write_str("max"),
        }
    }
}

/// What becomes of the cycles that a computer was too late for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Missed {
    /// They are left out: a late scan begins at once, the next one a whole cycle after it.
    #[default]
    LeftOut,
    /// Each is scanned, at its own time, as in virtual time: every run is the same, at any speed. Time waits where the computer cannot keep up.
    MadeUp,
}

/// The time of the CPU: how fast it goes, when scans begin, when the run ends. All in microseconds.
#[derive(Clone, Debug)]
pub struct Pace {
    /// From one scan to the next; 0 = one scan after another.
    pub cycle_us: u64,
    /// When the run ends.
    pub end_us: u64,
    /// What becomes of the cycles that the computer was too late for.
    pub missed: Missed,
    /// When the next scan begins.
    pub(crate) due_us: u64,
    speed: Speed,
    paused: bool,
    /// Scans that are still to be run while time stands still.
    steps: u64,
    /// A moment in both times, from which on the speed holds.
    since: (u64, u64),
}

impl Pace {
    /// Time that begins at 0 when the computer's shows `real_us`.
    pub fn new(speed: Speed, cycle_us: u64, end_us: u64, real_us: u64) -> Self {
        Self { cycle_us, end_us, missed: Missed::default(), due_us: 0, speed, paused: false, steps: 0, since: (real_us, 0) }
    }

    /// How fast it goes.
    pub fn speed(&self) -> Speed {
        self.speed
    }

    /// Whether time stands still.
    pub fn is_paused(&self) -> bool {
        self.paused
    }

    /// The time of the CPU when the computer's shows `real_us`. In virtual time it only goes from scan to scan ([`Self::pass`]).
    pub fn time_us(&self, real_us: u64) -> u64 {
        let (real, own) = self.since;
        match self.speed {
            Speed::Factor(factor) if !self.paused => own.saturating_add((real_us.saturating_sub(real) as f64 * factor) as u64),
            _ => own,
        }
    }

    /// How long the computer takes until the CPU has this time; `None` if it does not come by itself.
    pub fn real_until(&self, time_us: u64, real_us: u64) -> Option<u64> {
        let left = time_us.saturating_sub(self.time_us(real_us));
        match self.speed {
            _ if left == 0 => Some(0),
            Speed::Factor(factor) if !self.paused => Some((left as f64 / factor).ceil() as u64),
            _ => None,
        }
    }

    /// Sets how fast time goes from now on.
    pub fn set_speed(&mut self, speed: Speed, real_us: u64) {
        self.since = (real_us, self.time_us(real_us));
        self.speed = speed;
    }

    /// Time stands still from now on.
    pub fn pause(&mut self, real_us: u64) {
        self.since = (real_us, self.time_us(real_us));
        self.paused = true;
    }

    /// Time goes on from now on.
    pub fn go(&mut self, real_us: u64) {
        if self.paused {
            self.since = (real_us, self.since.1);
            (self.paused, self.steps) = (false, 0);
        }
    }

    /// So many scans more while time stands still; it stands still from now on if it did not.
    pub fn step(&mut self, scans: u64, real_us: u64) {
        if !self.paused {
            self.pause(real_us);
        }
        self.steps = self.steps.saturating_add(scans);
    }

    /// Takes one of the scans that [`Self::step`] wants; `false` if there is none.
    pub(crate) fn take_step(&mut self) -> bool {
        let any = self.paused && self.steps > 0;
        if any {
            self.steps -= 1;
        }
        any
    }

    /// Whether a scan is wanted although time stands still.
    pub fn has_steps(&self) -> bool {
        self.paused && self.steps > 0
    }

    /// Scans that are still to be run while time stands still.
    pub fn steps_left(&self) -> u64 {
        if self.paused { self.steps } else { 0 }
    }

    /// Whether the clock of the CPU is that of the computer.
    pub(crate) fn is_real(&self) -> bool {
        !self.paused && self.speed.is_real() && self.missed == Missed::LeftOut
    }

    /// The time of the CPU, which waits for a computer that is too late for scans to make up for all of it.
    pub(crate) fn wait_for_scans(&mut self, real_us: u64) -> u64 {
        let late_us = match self.speed {
            Speed::Factor(factor) => (LATE_US_MAX as f64 * factor) as u64,
            Speed::Max => 0,
        };
        let (now_us, latest_us) = (self.time_us(real_us), self.due_us.saturating_add(late_us));
        if now_us > latest_us {
            self.since = (real_us, latest_us);
        }
        now_us.min(latest_us)
    }

    /// Time that stands still goes to the next scan, and no further.
    pub(crate) fn jump_to_scan(&mut self) {
        self.since.1 = self.due_us;
    }

    /// Lets time pass at once: from scan to scan in virtual time, or in steps.
    pub(crate) fn pass(&mut self, us: u64) {
        self.since.1 = self.since.1.saturating_add(us);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_are_read_and_written() {
        for (text, expected) in
            [("1x", Some(1.0)), ("0.5x", Some(0.5)), ("10", Some(10.0)), ("0x", None), ("-1x", None), ("nanx", None), ("fast", None)]
        {
            assert_eq!(Speed::parse(text).ok(), expected.map(Speed::Factor), "{text}");
        }
        assert_eq!(Speed::parse("MAX"), Ok(Speed::Max));
        for speed in [Speed::Factor(1.0), Speed::Factor(0.25), Speed::Max] {
            assert_eq!(Speed::parse(&speed.to_string()), Ok(speed));
        }
    }

    #[test]
    fn keys_step_through_the_speeds() {
        let (mut speed, mut seen) = (Speed::Factor(0.001), Vec::new());
        while speed != speed.faster() {
            speed = speed.faster();
            seen.push(speed);
        }
        assert_eq!(seen, STEPS);
        assert_eq!(Speed::Factor(3.0).slower(), Speed::Factor(2.0));
        assert_eq!(Speed::Factor(3.0).faster(), Speed::Factor(5.0));
        assert_eq!(Speed::Max.slower(), Speed::Factor(100.0));
        assert_eq!(Speed::Factor(0.1).slower(), Speed::Factor(0.1));
    }

    #[test]
    fn time_waits_for_a_computer_that_is_far_too_late() {
        let mut pace = Pace::new(Speed::Factor(10.0), 10_000, u64::MAX, 0);
        pace.due_us = 30_000;
        assert_eq!(pace.wait_for_scans(50_000), 500_000, "50 ms late are made up for");
        assert_eq!(pace.wait_for_scans(900_000), 1_030_000);
        assert_eq!(pace.time_us(900_100), 1_031_000, "it goes on from there");
        pace.set_speed(Speed::Factor(10_000.0), 900_100);
        assert_eq!(pace.wait_for_scans(u64::MAX), 1_000_030_000);
    }

    #[test]
    fn time_goes_as_fast_as_it_is_set_and_never_back() {
        let mut pace = Pace::new(Speed::Factor(1.0), 10_000, u64::MAX, 500);
        assert_eq!((pace.time_us(500), pace.time_us(1_500), pace.real_until(2_000, 1_500)), (0, 1_000, Some(1_000)));
        pace.set_speed(Speed::Factor(10.0), 1_500);
        assert_eq!((pace.time_us(1_500), pace.time_us(1_600), pace.real_until(2_005, 1_600)), (1_000, 2_000, Some(1)));
        pace.pause(1_600);
        assert_eq!((pace.time_us(9_000), pace.real_until(3_000, 9_000), pace.real_until(2_000, 9_000)), (2_000, None, Some(0)));
        pace.step(2, 9_000);
        assert!(pace.take_step());
        pace.pass(10_000);
        assert_eq!(pace.time_us(9_500), 12_000);
        assert!(pace.take_step() && !pace.take_step());
        pace.go(10_000);
        assert_eq!(pace.time_us(10_010), 12_100);
        pace.set_speed(Speed::Max, 10_010);
        assert_eq!((pace.time_us(20_000), pace.real_until(13_000, 20_000)), (12_100, None));
        assert_eq!(pace.time_us(0), 12_100, "a clock that goes back does not take the CPU along");
    }
}
