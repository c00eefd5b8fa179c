//! Operating modes and kinds of restart.

use std::fmt;

/// What the CPU is doing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum OperatingMode {
    /// No user program runs, outputs are disabled.
    #[default]
    Stop,
    /// The startup organization block runs, outputs are still disabled.
    Startup,
    /// The cycle runs.
    Run,
    /// The program is suspended between two statements and can go on.
    Hold,
}

/// How the CPU goes from STOP to RUN.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Restart {
    /// OB 100: bit memory, timers, counters and the process image are cleared, data blocks keep their values except NON_RETAIN ones.
    #[default]
    Warm,
    /// OB 101 (S7-400): everything keeps its value. A CPU type without it does a warm restart.
    Hot,
    /// OB 102: as warm, and all data blocks come from load memory.
    Cold,
}

impl fmt::Display for OperatingMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Stop => "STOP",
            Self::Startup => "STARTUP",
            Self::Run => "RUN",
            Self::Hold => "HOLD",
        })
    }
}
