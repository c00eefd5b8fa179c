//! Durations on the command line.

use std::time::Duration;

/// Reads the time from one scan to the next.
pub(crate) fn cycle_argument(text: &str) -> Result<Duration, String> {
    sieben_sim::duration::parse_cycle(text)
}

/// Reads a duration argument.
pub(crate) fn duration_argument(text: &str) -> Result<Duration, String> {
    sieben_sim::duration::parse(text)
}
