//! When scans begin in virtual time, and what changes between them.

use std::iter::Peekable;
use std::time::Duration;

use sieben_cpu::Cpu;
use sieben_sim::names::Setting;

use crate::names;
use crate::refusal::Refusal;
use crate::settings::Settings;

/// From one scan to the next, unless something else is said.
const USUAL_CYCLE: Duration = Duration::from_millis(10);

/// When a scan begins, by its number.
pub enum Schedule {
    /// At multiples of the cycle.
    Cyclic {
        /// From one to the next.
        cycle: Duration,
        /// How many.
        scans: u64,
    },
    /// At these times.
    At(Vec<Duration>),
}

impl Schedule {
    /// How many scans there are.
    pub fn scans(&self) -> u64 {
        match self {
            Self::Cyclic { scans, .. } => *scans,
            Self::At(times) => times.len() as u64,
        }
    }

    /// Microseconds at the beginning of a scan.
    pub fn begin_us(&self, scan: u64) -> u64 {
        let us = match self {
            Self::Cyclic { cycle, .. } => cycle.as_micros().saturating_mul(u128::from(scan)),
            Self::At(times) => times[scan as usize].as_micros(),
        };
        u64::try_from(us).unwrap_or(u64::MAX)
    }
}

/// What changes before the first scan and between two.
pub struct Changes {
    set: Vec<Setting>,
    at: Peekable<std::vec::IntoIter<(Duration, Setting)>>,
}

impl Changes {
    /// Those before the first scan, and those at their times, in the order of the times.
    pub fn new(set: Vec<Setting>, at: Vec<(Duration, Setting)>) -> Self {
        Self { set, at: at.into_iter().peekable() }
    }

    /// Sets what is set before the first scan.
    pub fn begin(&self, cpu: &mut Cpu) -> Result<(), Refusal> {
        self.set.iter().try_for_each(|setting| names::apply(setting, cpu))
    }

    /// Sets what the scan at this time shall see.
    pub fn apply(&mut self, cpu: &mut Cpu, now_us: u64) -> Result<(), Refusal> {
        while let Some((_, setting)) = self.at.next_if(|(time, _)| time.as_micros() <= u128::from(now_us)) {
            names::apply(&setting, cpu)?;
        }
        Ok(())
    }
}

/// Time from one scan to the next in virtual time: the one asked for, else that of the project, else 10 ms; not below the project's least.
pub fn cycle(asked: Option<Duration>, settings: &Settings) -> Duration {
    let usual = settings.cycle.filter(|cycle| !cycle.is_zero()).unwrap_or(USUAL_CYCLE);
    asked.unwrap_or(usual).max(settings.min_cycle.unwrap_or_default())
}

/// The same where time has to go on, whatever is asked for, and no least cycle time is waited for.
pub fn going_cycle(asked: Option<Duration>, settings: &Settings) -> Duration {
    asked.or(settings.cycle).filter(|cycle| !cycle.is_zero()).unwrap_or(USUAL_CYCLE)
}
