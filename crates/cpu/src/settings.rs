//! How a CPU is set up.

use std::collections::BTreeMap;
use std::time::Duration;

use crate::clock::{DateAndTime, TimeSource};
use crate::interrupts::CyclicInterrupt;
use crate::retain::RetentiveAreas;

/// What the CPU does when a module does not answer while the process image is exchanged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ImageErrors {
    /// Nothing; its inputs read 0.
    #[default]
    Ignored,
    /// OB 85 at every exchange, 16#39B1 and 16#39B2.
    EveryTime,
    /// OB 85 when it begins and when it is over, 16#39B3, 16#39B4, 16#38B3 and 16#38B4.
    Changes,
}

impl ImageErrors {
    /// The words for all of them in project files and scenarios.
    pub const NAMES: [(&'static str, Self); 3] = [("off", Self::Ignored), ("every", Self::EveryTime), ("coming", Self::Changes)];

    /// The setting with this word: `off`, `every` or `coming` (coming and going).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(word, _)| *word == name).map(|&(_, setting)| setting)
    }

    /// Its word.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, setting)| *setting == self).map_or("off", |(word, _)| word)
    }
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
    /// What happens when the process image cannot be exchanged with a module.
    pub image_errors: ImageErrors,
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
            image_errors: ImageErrors::Ignored,
            min_cycle: Duration::ZERO,
            retain: RetentiveAreas::default(),
        }
    }
}
