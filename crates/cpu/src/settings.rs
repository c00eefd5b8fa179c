//! How a CPU is set up.

use std::time::Duration;

use crate::clock::DateAndTime;
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
            retain: RetentiveAreas::default(),
        }
    }
}
