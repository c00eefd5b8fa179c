//! The past of a run: any scan of the last minutes once more, statement by statement, while the run goes on.
//!
//! A run is a row of stretches. Each begins with a snapshot of the CPU; what follows is what the clock showed and what modules said that
//! cannot be copied, a few bytes a scan. Whatever comes in through the gate to change something begins a new stretch, so that nothing of it has to be known.
//! A scan is reached by replaying its stretch in the interpreter, on the thread that looks.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use sieben_cpu::{Cpu, NotReplayed, OperatingMode, RecordedStep, Recording, Replayer, Step};
use sieben_engine::Tracer;

use crate::gate::Plant;

/// How far back the past goes, in microseconds of the CPU's time.
pub const TIME_US_MAX: u64 = 600_000_000;
/// Most memory that it takes, by its own estimate.
pub const BYTES_MAX: usize = 64 << 20;
/// Most steps of a stretch: so many are replayed at most to come to a scan.
const STEPS_MAX: usize = 100;
/// Longest stretch, in microseconds of the CPU's time.
const STRETCH_US: u64 = 1_000_000;

/// The end of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mark {
    /// Scans of the run up to it.
    pub scan: u64,
    /// The time of the CPU.
    pub time_us: u64,
}

/// A part of the past that is replayed from one snapshot on.
#[derive(Clone, Debug)]
struct Stretch {
    /// Before the first step.
    begins: Mark,
    recording: Recording,
    /// After each step.
    marks: Vec<Mark>,
}

impl Stretch {
    fn ends(&self) -> Mark {
        self.marks.last().copied().unwrap_or(self.begins)
    }

    /// How many steps lead to the end of a scan, without what came between it and the next one.
    fn steps_to(&self, scan: u64) -> usize {
        if scan <= self.begins.scan { 0 } else { (self.marks.partition_point(|mark| mark.scan < scan) + 1).min(self.marks.len()) }
    }

    /// Where the CPU is after so many steps.
    fn mark(&self, steps: usize) -> Mark {
        steps.checked_sub(1).and_then(|last| self.marks.get(last)).copied().unwrap_or(self.begins)
    }

    /// Whether the next step of a CPU belongs to it.
    fn goes_on(&self, plant: &Plant) -> bool {
        self.marks.len() < STEPS_MAX
            && !self.recording.is_full()
            && self.recording.is_of(plant.cpu.program())
            && plant.cpu.time_us().saturating_sub(self.begins.time_us) < STRETCH_US
    }
}

/// What is kept.
#[derive(Default)]
struct Kept {
    closed: VecDeque<Arc<Stretch>>,
    open: Option<Stretch>,
    /// Of the closed ones.
    bytes: usize,
}

/// The past of a run. It is kept from [`Self::keep`] on.
#[derive(Default)]
pub struct Past {
    is_kept: AtomicBool,
    kept: Mutex<Kept>,
}

/// Why a scan of the past cannot be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gone {
    /// It is not kept any more, or not yet.
    NotKept,
    /// It cannot be replayed.
    NotReplayed(NotReplayed),
}

impl std::fmt::Display for Gone {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NotKept => f.write_str("the past does not reach to this scan"),
            Self::NotReplayed(why) => why.fmt(f),
        }
    }
}

impl std::error::Error for Gone {}

impl From<NotReplayed> for Gone {
    fn from(why: NotReplayed) -> Self {
        Self::NotReplayed(why)
    }
}

/// A CPU at the end of a scan of the past.
pub struct Seen<'v> {
    /// Which scan, and when it ended.
    pub mark: Mark,
    /// The CPU, in the interpreter.
    pub cpu: &'v Cpu,
}

impl Past {
    /// From now on the past is kept.
    pub fn keep(&self) {
        self.is_kept.store(true, Ordering::Relaxed);
    }

    /// Forgets it; from now on it is not kept.
    pub fn forget(&self) {
        self.is_kept.store(false, Ordering::Relaxed);
        *self.lock() = Kept::default();
    }

    /// Another CPU runs from now on: what was has nothing to do with it.
    pub(crate) fn reset(&self) {
        *self.lock() = Kept::default();
    }

    /// Lets a CPU take one step, which is recorded if the past is kept.
    pub(crate) fn step<R>(
        &self,
        plant: &mut Plant,
        step: Step,
        clock: &mut dyn FnMut() -> u64,
        run: impl FnOnce(&mut Plant, &mut dyn FnMut() -> u64) -> R,
    ) -> R {
        if !self.is_kept.load(Ordering::Relaxed) {
            return run(plant, clock);
        }
        self.go_on_or_begin(plant);
        // The thread that scans counts afterwards.
        let scan = plant.scans + u64::from(step == Step::Scan && plant.cpu.mode() != OperatingMode::Stop);
        let (done, step) = RecordedStep::of(plant, (|plant: &mut Plant| &mut plant.cpu, step), clock, run);
        // What was forgotten in the meantime stays so.
        if let Some(open) = &mut self.lock().open {
            open.recording.push(step);
            open.marks.push(Mark { scan, time_us: plant.cpu.time_us() });
        }
        done
    }

    /// Sees to it that a stretch is open to which the next step of a CPU belongs. Others look at it while the step runs.
    fn go_on_or_begin(&self, plant: &mut Plant) {
        let touched = std::mem::take(&mut plant.touched);
        let like = {
            let mut kept = self.lock();
            if !touched && kept.open.as_ref().is_some_and(|open| open.goes_on(plant)) {
                return;
            }
            kept.open.take().map(|ended| kept.close(ended))
        };
        let recording = Recording::new(&plant.cpu, like.as_ref().map(|like| &like.recording));
        let begins = Mark { scan: plant.scans, time_us: plant.cpu.time_us() };
        self.lock().open = Some(Stretch { begins, recording, marks: Vec::new() });
    }

    fn lock(&self) -> MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The ends of the oldest and of the newest scan that are kept.
    pub fn range(&self) -> Option<(Mark, Mark)> {
        let kept = self.lock();
        let first = kept.closed.front().map(|stretch| &**stretch).or(kept.open.as_ref())?;
        let last = kept.open.as_ref().or(kept.closed.back().map(|stretch| &**stretch))?;
        Some((first.begins, last.ends()))
    }

    /// The memory that it takes, by an estimate.
    pub fn bytes(&self) -> usize {
        let kept = self.lock();
        kept.bytes + kept.open.as_ref().map_or(0, |open| open.recording.bytes())
    }

    /// The scan that was the last one at a time of the CPU.
    pub fn scan_at(&self, time_us: u64) -> Option<u64> {
        let kept = self.lock();
        let all = kept.closed.iter().map(|stretch| &**stretch).chain(&kept.open);
        let stretch = all.take_while(|stretch| stretch.begins.time_us <= time_us).last()?;
        Some(stretch.mark(stretch.marks.partition_point(|mark| mark.time_us <= time_us)).scan)
    }

    /// The stretch in which a scan ended.
    fn stretch(&self, scan: u64) -> Option<Arc<Stretch>> {
        let kept = self.lock();
        // One that begins with the scan has what was changed after it already; only the very first one has nothing before.
        let after = kept.closed.partition_point(|stretch| stretch.begins.scan < scan);
        if let Some(open) = kept.open.as_ref().filter(|open| open.begins.scan < scan || after == 0 && kept.closed.is_empty()) {
            return (open.begins.scan <= scan && scan <= open.ends().scan).then(|| Arc::new(open.clone()));
        }
        let stretch = kept.closed.get(after.saturating_sub(1))?;
        (stretch.begins.scan <= scan && scan <= stretch.ends().scan).then(|| Arc::clone(stretch))
    }
}

impl Kept {
    fn close(&mut self, stretch: Stretch) -> Arc<Stretch> {
        let stretch = Arc::new(stretch);
        self.bytes += stretch.recording.bytes();
        let now_us = stretch.ends().time_us;
        self.closed.push_back(Arc::clone(&stretch));
        while self.closed.len() > 1
            && (self.bytes > BYTES_MAX
                || self.closed.front().is_some_and(|oldest| oldest.ends().time_us.saturating_add(TIME_US_MAX) < now_us))
        {
            if let Some(oldest) = self.closed.pop_front() {
                self.bytes -= oldest.recording.bytes().min(self.bytes);
            }
        }
        stretch
    }
}

/// Who looks at the past; a look at a later scan of the same stretch goes on from the last one.
#[derive(Default)]
pub struct Viewer {
    replayer: Replayer,
}

impl Viewer {
    /// The CPU at the end of a scan, before anything that came between it and the next one.
    ///
    /// # Errors
    /// The scan is not kept, or cannot be replayed.
    pub fn at(&mut self, past: &Past, scan: u64) -> Result<Seen<'_>, Gone> {
        self.look(past, scan, None)
    }

    /// As [`Self::at`], with a tracer that gets each statement of the scan.
    ///
    /// # Errors
    /// The scan is not kept, or cannot be replayed.
    pub fn traced(&mut self, past: &Past, scan: u64, tracer: &mut dyn Tracer) -> Result<Seen<'_>, Gone> {
        self.look(past, scan, Some(tracer))
    }

    fn look(&mut self, past: &Past, scan: u64, tracer: Option<&mut dyn Tracer>) -> Result<Seen<'_>, Gone> {
        let stretch = past.stretch(scan).ok_or(Gone::NotKept)?;
        let steps = stretch.steps_to(scan);
        let cpu = self.replayer.play(&stretch.recording, steps, tracer)?;
        Ok(Seen { mark: stretch.mark(steps), cpu })
    }

    /// Looks at the ends of all scans from one to another that are kept, in order; ends when `look` answers `false`.
    ///
    /// # Errors
    /// One of them cannot be replayed.
    pub fn each(&mut self, past: &Past, (from, to): (u64, u64), mut look: impl FnMut(Seen<'_>) -> bool) -> Result<(), Gone> {
        let Some((oldest, newest)) = past.range() else { return Ok(()) };
        let mut scan = from.max(oldest.scan);
        while scan <= to.min(newest.scan) {
            let Some(stretch) = past.stretch(scan) else { return Ok(()) };
            for scan in scan..=to.min(stretch.ends().scan) {
                let steps = stretch.steps_to(scan);
                if !look(Seen { mark: stretch.mark(steps), cpu: self.replayer.play(&stretch.recording, steps, None)? }) {
                    return Ok(());
                }
            }
            scan = stretch.ends().scan + 1;
        }
        Ok(())
    }
}
