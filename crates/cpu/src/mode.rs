//! Operating modes, kinds of restart, and why the CPU is in STOP.

use std::fmt;

use sieben_engine::FaultPlace;

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

impl Restart {
    /// All kinds.
    pub const ALL: [Self; 3] = [Self::Warm, Self::Cold, Self::Hot];

    /// Its word: `warm`, `cold`, `hot`.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Warm => "warm",
            Self::Cold => "cold",
            Self::Hot => "hot",
        }
    }

    /// The kind of a word, in any case.
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.word().eq_ignore_ascii_case(word))
    }
}

/// Why the CPU is in STOP.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StopCause {
    /// The event of the STOP itself, such as 16#4562.
    pub event: u16,
    /// The first cause, such as 16#2528; the same as `event` if nothing came before.
    pub first_event: u16,
    /// The statement that caused it, counted from 0, if one did.
    pub place: Option<FaultPlace>,
    /// Cause, place and consequence in words.
    pub text: String,
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

/// Why a CPU is not started from outside. Nothing has changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StartRefused {
    /// It starts or runs already.
    Running,
    /// The program is suspended: it goes on, or the CPU goes to STOP first.
    Held,
}

impl fmt::Display for StartRefused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Running => "the CPU is in RUN already",
            Self::Held => "the CPU is in HOLD: its program goes on, or it goes to STOP before it starts again",
        })
    }
}

impl std::error::Error for StartRefused {}

/// The CPU is not in STOP, where alone this can be done. Nothing has changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotInStop(pub OperatingMode);

impl fmt::Display for NotInStop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the CPU is in {}; this needs STOP", self.0)
    }
}

impl std::error::Error for NotInStop {}
