//! The past of a run: any scan of the last minutes once more, statement by statement, while the run goes on.
//!
//! A run is a row of stretches. Each begins with a snapshot of the CPU; what follows is what the clock showed and what modules said that
//! cannot be copied, a few bytes a scan. Whatever comes in through the gate to change something begins a new stretch, so that nothing of it has to be known.
//! A scan is reached by replaying its stretch in the interpreter, on the thread of whoever looks.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use sieben_cpu::{Cpu, NotReplayed, OperatingMode, Recording, Replayer, Step};
use sieben_engine::{FaultPlace, Machine, StatementEvent, Stored, Tracer};
use sieben_sim::names::Name;

use crate::gate::Plant;

/// How far back the past goes, in microseconds of the CPU's time.
pub const TIME_US_MAX: u64 = 600_000_000;
/// Most memory that it takes, by its own estimate.
pub const BYTES_MAX: usize = 64 << 20;
/// Most steps of a stretch: so many are replayed at most to come to a scan.
const STEPS_MAX: usize = 100;
/// Longest stretch, in microseconds of the CPU's time.
const STRETCH_US: u64 = 1_000_000;

/// The end of a step, and of a scan that is seen again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Visited {
    /// Scans of the run up to it.
    pub scan: u64,
    /// The time of the CPU.
    pub time_us: u64,
}

/// A part of the past that is replayed from one snapshot on.
#[derive(Clone, Debug)]
struct Stretch {
    /// Before the first step.
    begins: Visited,
    recording: Recording,
    /// After each step.
    marks: Vec<Visited>,
}

impl Stretch {
    fn ends(&self) -> Visited {
        self.marks.last().copied().unwrap_or(self.begins)
    }

    /// Where the CPU is after so many steps.
    fn mark(&self, steps: usize) -> Visited {
        steps.checked_sub(1).and_then(|last| self.marks.get(last)).copied().unwrap_or(self.begins)
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

/// The past of a run. It is kept from [`Self::switch_on`] on.
#[derive(Default)]
pub struct Past {
    is_kept: AtomicBool,
    kept: Mutex<Kept>,
}

/// Why a scan of the past cannot be seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotKept {
    /// It is older or newer than what is kept.
    Outside,
    /// It cannot be replayed.
    NotReplayed(NotReplayed),
}

impl std::fmt::Display for NotKept {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Outside => f.write_str("the past does not reach to this scan"),
            Self::NotReplayed(why) => why.fmt(f),
        }
    }
}

impl std::error::Error for NotKept {}

impl From<NotReplayed> for NotKept {
    fn from(why: NotReplayed) -> Self {
        Self::NotReplayed(why)
    }
}

/// Whether a visit goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Goes {
    /// To the next scan.
    On,
    /// No further.
    No,
}

/// Who sees scans of the past.
pub trait Visitor {
    /// What is told the statements of the next step.
    fn tracer(&mut self) -> &mut dyn Tracer;
    /// A scan has ended, and so the CPU stands.
    fn ended(&mut self, cpu: &Cpu, visited: Visited) -> Goes;
}

impl Past {
    /// From now on the past is kept.
    pub fn switch_on(&self) {
        self.is_kept.store(true, Ordering::Relaxed);
    }

    /// Whether it is kept.
    pub fn is_on(&self) -> bool {
        self.is_kept.load(Ordering::Relaxed)
    }

    /// Forgets it; from now on it is not kept.
    pub fn switch_off(&self) {
        self.is_kept.store(false, Ordering::Relaxed);
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
        let mut stretch = self.take_open(plant);
        // The thread that scans counts afterwards.
        let scan = plant.scans + u64::from(step == Step::Scan && plant.cpu.mode() != OperatingMode::Stop);
        let done = stretch.recording.step(plant, (|plant: &mut Plant| &mut plant.cpu, step), clock, run);
        stretch.marks.push(Visited { scan, time_us: plant.cpu.time_us() });
        if self.is_kept.load(Ordering::Relaxed) {
            self.lock().open = Some(stretch);
        }
        done
    }

    /// The stretch that goes on, or a new one.
    fn take_open(&self, plant: &mut Plant) -> Stretch {
        let touched = std::mem::take(&mut plant.touched);
        let open = self.lock().open.take();
        let like = match open {
            Some(open) if !touched && open.goes_on(plant) => return open,
            open => open.map(Arc::new),
        };
        let recording = Recording::new(&plant.cpu, like.as_ref().map(|like| &like.recording));
        if let Some(like) = like {
            self.lock().close(like);
        }
        Stretch { begins: Visited { scan: plant.scans, time_us: plant.cpu.time_us() }, recording, marks: Vec::new() }
    }

    fn lock(&self) -> MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The oldest and the newest scan that are kept.
    pub fn extent(&self) -> Option<(Visited, Visited)> {
        let kept = self.lock();
        let first = kept.closed.front().map(|stretch| &**stretch).or(kept.open.as_ref())?;
        let last = kept.open.as_ref().or(kept.closed.back().map(|stretch| &**stretch))?;
        Some((first.mark(1), last.ends()))
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

    /// Replays the scans from one to another that are kept, in order; the visitor is told of the end of each, and its tracer of their statements and
    /// of what interrupted between them.
    ///
    /// # Errors
    /// None of them is kept, or one cannot be replayed.
    pub fn visit(&self, from: u64, to: u64, replayer: &mut Replayer, visitor: &mut dyn Visitor) -> Result<(), NotKept> {
        let stretches = self.stretches(from, to);
        let mut is_seen = false;
        for stretch in stretches {
            // The first step that ends a wanted scan; those before it are replayed without being told.
            let first = stretch.marks.partition_point(|mark| mark.scan < from);
            for (index, &visited) in stretch.marks.iter().enumerate().skip(first) {
                if visited.scan > to {
                    return Ok(());
                }
                let cpu = replayer.play(&stretch.recording, index + 1, Some(visitor.tracer()))?;
                // A step in STOP, and one between two scans, ends none.
                if visited.scan == stretch.mark(index).scan {
                    continue;
                }
                is_seen = true;
                if visitor.ended(cpu, visited) == Goes::No {
                    return Ok(());
                }
            }
        }
        if is_seen { Ok(()) } else { Err(NotKept::Outside) }
    }

    /// The stretches that have something of these scans.
    fn stretches(&self, from: u64, to: u64) -> Vec<Arc<Stretch>> {
        let kept = self.lock();
        let has = |stretch: &Stretch| stretch.begins.scan < to && from <= stretch.ends().scan;
        let first = kept.closed.partition_point(|stretch| stretch.ends().scan < from);
        let closed = kept.closed.iter().skip(first).take_while(|stretch| stretch.begins.scan < to).map(Arc::clone);
        closed.chain(kept.open.iter().filter(|open| has(open)).map(|open| Arc::new(open.clone()))).collect()
    }
}

impl Stretch {
    fn goes_on(&self, plant: &Plant) -> bool {
        self.marks.len() < STEPS_MAX
            && !self.recording.is_full()
            && self.recording.is_of(plant.cpu.program())
            && plant.cpu.time_us().saturating_sub(self.begins.time_us) < STRETCH_US
    }
}

impl Kept {
    fn close(&mut self, stretch: Arc<Stretch>) {
        self.bytes += stretch.recording.bytes();
        let now_us = stretch.ends().time_us;
        self.closed.push_back(stretch);
        while self.closed.len() > 1
            && (self.bytes > BYTES_MAX
                || self.closed.front().is_some_and(|oldest| oldest.ends().time_us.saturating_add(TIME_US_MAX) < now_us))
        {
            if let Some(oldest) = self.closed.pop_front() {
                self.bytes -= oldest.recording.bytes().min(self.bytes);
            }
        }
    }
}

/// What stored to a place last.
#[derive(Clone, Debug)]
pub struct Writer {
    /// The statement.
    pub place: FaultPlace,
    /// The scan.
    pub scan: u64,
}

/// Finds the last statement that stored to a name.
pub struct LastWriter<'n> {
    name: &'n Name,
    /// The statement since the end of the last scan that stored.
    stores: Option<FaultPlace>,
    /// One stores that has not ended yet.
    pending: bool,
    /// The last one of all scans so far.
    pub found: Option<Writer>,
}

impl<'n> LastWriter<'n> {
    /// For this name.
    pub fn of(name: &'n Name) -> Self {
        Self { name, stores: None, pending: false, found: None }
    }
}

impl Tracer for LastWriter<'_> {
    fn statement(&mut self, _: &Machine, event: &StatementEvent) {
        // What stores is told before the statement has ended.
        if std::mem::take(&mut self.pending) {
            self.stores = Some(event.place);
        }
    }

    fn stores(&mut self, machine: &Machine, stored: Stored) {
        self.pending |= self.name.is_stored(machine, &machine.registers, &stored);
    }
}

impl Visitor for LastWriter<'_> {
    fn tracer(&mut self) -> &mut dyn Tracer {
        self
    }

    fn ended(&mut self, _: &Cpu, visited: Visited) -> Goes {
        if let Some(place) = self.stores.take() {
            self.found = Some(Writer { place, scan: visited.scan });
        }
        self.pending = false;
        Goes::On
    }
}
