//! One scan once more, elsewhere: what it began with and what came in during it is copied, the scan itself is not held up.

use std::sync::Arc;

use sieben_engine::{Interpreter, Program, Tracer};
use sieben_model::cpu_type::CpuType;

use super::snapshot::EndState;
use super::{Cpu, Loaded, ScanReport, Snapshot};
use crate::io::{Place, Rack};
use crate::retain::Declarations;
use crate::tape::Reading;

/// Most readings of the clock that are kept of one scan.
const READINGS_MAX: usize = 65_536;

/// A scan with all that it began with and all that came in while it ran.
#[derive(Debug)]
pub struct RecordedScan {
    cpu_type: &'static CpuType,
    program: Arc<Program>,
    before: Snapshot,
    /// What the clock showed, in the order in which it was asked.
    clock: Vec<u64>,
    /// Where the modules are, and what those said that cannot be copied.
    places: Vec<Place>,
    readings: Vec<Reading>,
    after: Arc<EndState>,
    report: ScanReport,
}

/// A CPU that replays scans of others, in the interpreter.
#[derive(Default)]
pub struct Replayer {
    /// The CPU, for the program and the layout that it was made for.
    cpu: Option<Cpu>,
}

impl Replayer {
    /// The CPU as the last replay left it.
    pub fn cpu(&self) -> Option<&Cpu> {
        self.cpu.as_ref()
    }
}

/// What came in while a scan ran: enough to run it again after the one before it.
#[derive(Debug, Default)]
pub struct NotedScan {
    clock: Box<[u64]>,
    readings: Vec<Reading>,
}

impl NotedScan {
    /// Bytes that it takes; an estimate.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + self.clock.len() * size_of::<u64>() + self.readings.iter().map(Reading::bytes).sum::<usize>()
    }

    /// Runs the scan again on a CPU that stands at the end of the one before, and tells the tracer of its statements.
    ///
    /// # Errors
    /// It cannot be run again.
    pub fn replay(&self, replayer: &mut Replayer, tracer: &mut dyn Tracer) -> Result<(), NotReplayed> {
        let Some(cpu) = replayer.cpu.as_mut().filter(|_| self.clock.len() < READINGS_MAX) else { return Err(NotReplayed::TooLong) };
        // Copies of the modules say it themselves.
        if !self.readings.is_empty() {
            cpu.rack.play(self.readings.clone());
        }
        cpu.scan_with(&mut played(&self.clock), Some(tracer));
        Ok(())
    }
}

/// A clock that shows again what it showed; at its end it stands still.
fn played(readings: &[u64]) -> impl FnMut() -> u64 {
    let mut next = 0;
    move || {
        let reading = readings.get(next).or(readings.last()).copied().unwrap_or_default();
        next += 1;
        reading
    }
}

/// Why a scan cannot be replayed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotReplayed {
    /// It asked the clock more often than is kept.
    TooLong,
}

impl std::fmt::Display for NotReplayed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::TooLong => "the scan is too long to be replayed",
        })
    }
}

impl std::error::Error for NotReplayed {}

impl RecordedScan {
    /// What the scan did.
    pub fn report(&self) -> ScanReport {
        self.report
    }

    /// What the CPU was after the scan: the next recording shares with it what has not changed.
    pub fn after(&self) -> &Arc<EndState> {
        &self.after
    }

    /// Bytes that it takes beside those that it shares with the one before; an estimate.
    pub fn bytes(&self) -> usize {
        let readings: usize = self.readings.iter().map(Reading::bytes).sum();
        size_of::<Self>() + self.before.bytes() + self.clock.len() * size_of::<u64>() + readings + self.places.len() * size_of::<Place>()
    }

    /// Whether a CPU runs the same program and has copies of all modules in here: the scans after this one need no words of modules.
    pub fn has_modules(&self) -> bool {
        self.before.has_modules()
    }

    fn is_for(&self, cpu: &Cpu) -> bool {
        Arc::ptr_eq(&cpu.program, &self.program) && self.before.fits(cpu)
    }

    fn cpu(&self) -> Cpu {
        let layout = self.before.layout();
        let engine = Interpreter::load(&self.program, &layout);
        let loaded = Loaded {
            cpu_type: self.cpu_type,
            program: Arc::clone(&self.program),
            declarations: Arc::new(Declarations::of(&self.program)),
            image_writes: Arc::new(engine.image_writes(&self.program)),
            layout,
            engine,
        };
        Cpu::new(loaded, Rack::of_places(self.cpu_type, &self.places), self.before.settings().clone())
    }

    /// Runs the scan again and tells the tracer of its statements; whether it ended as the real one did.
    ///
    /// # Errors
    /// It cannot be run again.
    pub fn replay(&self, replayer: &mut Replayer, tracer: &mut dyn Tracer) -> Result<bool, NotReplayed> {
        if self.clock.len() >= READINGS_MAX {
            return Err(NotReplayed::TooLong);
        }
        let known = replayer.cpu.take().filter(|cpu| self.is_for(cpu));
        let cpu = replayer.cpu.insert(known.unwrap_or_else(|| self.cpu()));
        cpu.go_back_to(&self.before);
        if !self.before.has_modules() {
            cpu.rack.play(self.readings.clone());
        }
        let mut next = 0;
        let mut clock = || {
            let reading = self.clock.get(next).or(self.clock.last()).copied().unwrap_or_default();
            next += 1;
            reading
        };
        cpu.scan_with(&mut clock, Some(tracer));
        Ok(next == self.clock.len() && self.after.is_of(cpu))
    }
}

/// Whether words of modules are noted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Modules {
    /// Copies of them say the same again.
    Copied,
    /// One of them cannot be copied.
    Heard,
}

impl Cpu {
    /// As [`Self::scan_with`], with what came in for a [`Replayer`] that has run all scans before this one.
    pub fn scan_noted(&mut self, clock: &mut dyn FnMut() -> u64, modules: Modules) -> (ScanReport, NotedScan) {
        let recording = (modules == Modules::Heard).then(|| self.rack.begin_record());
        let mut readings = Vec::with_capacity(4);
        let mut reading = || {
            let now = clock();
            if readings.len() < READINGS_MAX {
                readings.push(now);
            }
            now
        };
        let report = self.scan_with(&mut reading, None);
        let words = recording.map_or_else(Vec::new, |recording| self.rack.end_record(recording));
        (report, NotedScan { clock: readings.into(), readings: words })
    }

    /// As [`Self::scan_with`], with a recording for a [`Replayer`]. What did not change since the end of the recording `like` is shared with it.
    pub fn scan_recorded(&mut self, clock: &mut dyn FnMut() -> u64, like: Option<&EndState>) -> (ScanReport, RecordedScan) {
        let recording = self.rack.begin_record();
        let before = self.snapshot_after(like);
        let mut readings = Vec::new();
        let mut reading = || {
            let now = clock();
            if readings.len() < READINGS_MAX {
                readings.push(now);
            }
            now
        };
        let report = self.scan_with(&mut reading, None);
        let after = Arc::new(EndState::of(self, &before));
        let record = RecordedScan {
            cpu_type: self.cpu_type,
            program: Arc::clone(&self.program),
            before,
            clock: readings,
            places: self.rack.places(),
            readings: self.rack.end_record(recording),
            after,
            report,
        };
        (report, record)
    }
}
