//! How a CPU is set up.

use std::collections::BTreeMap;
use std::time::Duration;

use crate::clock::DateAndTime;
use crate::interrupts::CyclicInterrupt;
use crate::retain::RetentiveAreas;

/// Where time comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TimeSource {
    /// The clock stands still inside a scan and the watchdog counts safe points: every run is the same.
    #[default]
    Virtual,
    /// The clock is asked inside a scan too, for the watchdog, for timers and for times of day.
    Real,
}

/// How a CPU is set up.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Greatest cycle time, in real time.
    pub watchdog: Duration,
    /// Where time comes from.
    pub time: TimeSource,
    /// Greatest number of safe points (backward jumps and block entries) in one cycle, in virtual time.
    pub virtual_safe_points: i64,
    /// The byte of bit memory that holds the clock memory.
    pub clock_memory_byte: Option<u16>,
    /// Time of day when the clock shows 0.
    pub date_and_time: DateAndTime,
    /// Cyclic interrupts by the number of their organization block, 30 to 38. A block that is loaded and not in here has its usual interval.
    pub cyclic: BTreeMap<u16, CyclicInterrupt>,
    /// Least distance of two starts of OB 1; the rest of it is for OB 90 (S7-400).
    pub min_cycle: Duration,
    /// Which bit memory, timers and counters a warm restart and a power failure leave alone.
    pub retain: RetentiveAreas,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            watchdog: Duration::from_millis(150),
            time: TimeSource::Virtual,
            virtual_safe_points: 10_000_000,
            clock_memory_byte: None,
            date_and_time: DateAndTime::DEFAULT,
            cyclic: BTreeMap::new(),
            min_cycle: Duration::ZERO,
            retain: RetentiveAreas::default(),
        }
    }
}
