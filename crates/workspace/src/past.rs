//! The past of a run: what came in while its last scans ran, so that any of them can be run again and looked at.
//!
//! A scan is noted by what its clock showed and by what modules said that cannot be copied. Now and then, and whenever something else than
//! scans has changed the CPU, one is recorded whole; from there those after it are run again, in the interpreter, by other threads.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use sieben_cpu::{Cpu, Modules, NotReplayed, NotedScan, OperatingMode, RecordedScan, Replayer};
use sieben_engine::{Machine, Program, StatementEvent, Stored, Tracer};

use crate::gate::Plant;

/// For how long the past is kept, in microseconds of the CPU's time.
pub const KEPT_US_MAX: u64 = 600_000_000;
/// Bytes that it takes at most.
pub const KEPT_BYTES_MAX: usize = 64 * 1024 * 1024;
/// Scans between two that are recorded whole: so many are run again at most to see one.
const APART: u64 = 100;

/// A scan of the past.
enum Kept {
    /// It is run again after the one before it.
    Noted(NotedScan),
    /// It is run again by itself; with the bytes that it takes.
    Whole(SharedScan, usize),
}

/// A recorded scan that several threads run again, one after another: copies of modules stay with one thread at a time.
pub(crate) type SharedScan = Arc<Mutex<RecordedScan>>;

impl Kept {
    fn bytes(&self) -> usize {
        size_of::<Entry>()
            + match self {
                Self::Noted(scan) => scan.bytes(),
                Self::Whole(_, bytes) => *bytes,
            }
    }
}

struct Entry {
    /// The number of the scan in the run.
    number: u64,
    /// The time of the CPU after it.
    time_us: u64,
    kept: Arc<Kept>,
}

#[derive(Default)]
struct Ring {
    entries: VecDeque<Entry>,
    bytes: usize,
}

impl Ring {
    fn push(&mut self, entry: Entry) {
        self.bytes += entry.kept.bytes();
        let oldest_us = entry.time_us.saturating_sub(KEPT_US_MAX);
        self.entries.push_back(entry);
        while self.bytes > KEPT_BYTES_MAX || self.entries.front().is_some_and(|first| first.time_us < oldest_us) {
            self.forget_first();
            if self.entries.is_empty() {
                break;
            }
        }
    }

    /// Forgets the oldest scan that is kept whole, and all that need it.
    fn forget_first(&mut self) {
        let mut is_first = true;
        while let Some(entry) = self.entries.front()
            && (is_first || matches!(*entry.kept, Kept::Noted(_)))
        {
            is_first = false;
            self.bytes = self.bytes.saturating_sub(entry.kept.bytes());
            self.entries.pop_front();
        }
    }
}

/// What the thread that scans knows of the scan before.
#[derive(Default)]
struct Before {
    program: Option<Arc<Program>>,
    number: u64,
    noted: u64,
    modules: Option<Modules>,
}

/// How a scan is to be kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Keep {
    /// Not at all.
    Nothing,
    /// What comes in.
    Noted(Modules),
    /// All that it begins with.
    Whole,
}

/// The past of a run; nothing is kept until it is switched on.
#[derive(Default)]
pub struct Past {
    is_on: AtomicBool,
    ring: Mutex<Ring>,
    before: Mutex<Before>,
}

/// Why a scan of the past cannot be seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotKept {
    /// It is older or newer than what is kept.
    Outside,
    /// It cannot be run again.
    NotReplayed(NotReplayed),
}

impl std::fmt::Display for NotKept {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Outside => f.write_str("this scan is not kept"),
            Self::NotReplayed(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for NotKept {}

/// A scan that was run again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Visited {
    /// Its number.
    pub scan: u64,
    /// The time of the CPU after it.
    pub time_us: u64,
}

/// Does nothing with what it hears.
struct Deaf;

impl Tracer for Deaf {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {}
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Past {
    /// From now on scans are kept.
    pub fn switch_on(&self) {
        self.is_on.store(true, Ordering::Release);
    }

    /// From now on none is, and those that were kept are forgotten.
    pub fn switch_off(&self) {
        self.is_on.store(false, Ordering::Release);
        *lock(&self.ring) = Ring::default();
    }

    /// Whether scans are kept.
    pub fn is_on(&self) -> bool {
        self.is_on.load(Ordering::Acquire)
    }

    /// The oldest and the newest scan that are kept, with their times.
    pub fn extent(&self) -> Option<(Visited, Visited)> {
        let ring = lock(&self.ring);
        let visited = |entry: &Entry| Visited { scan: entry.number, time_us: entry.time_us };
        Some((visited(ring.entries.front()?), visited(ring.entries.back()?)))
    }

    /// Bytes that are kept; an estimate.
    pub fn bytes(&self) -> usize {
        lock(&self.ring).bytes
    }

    /// How the next scan is kept. One that something came before which is no scan is kept whole.
    pub(crate) fn next(&self, plant: &mut Plant) -> Keep {
        let touched = plant.take_touch();
        if !self.is_on() {
            return Keep::Nothing;
        }
        let mut before = lock(&self.before);
        let same = before.program.as_ref().is_some_and(|program| Arc::ptr_eq(program, plant.cpu.program()));
        // In STOP time passes for the plants alone, and no scan is counted.
        let follows = before.number == plant.scans && plant.cpu.mode() == OperatingMode::Run;
        match before.modules {
            Some(modules) if same && follows && !touched && before.noted < APART => Keep::Noted(modules),
            _ => {
                before.program = Some(Arc::clone(plant.cpu.program()));
                before.modules = None;
                Keep::Whole
            }
        }
    }

    /// A scan was noted.
    pub(crate) fn noted(&self, scan: NotedScan, number: u64, time_us: u64) {
        let mut before = lock(&self.before);
        before.number = number;
        before.noted += 1;
        drop(before);
        lock(&self.ring).push(Entry { number, time_us, kept: Arc::new(Kept::Noted(scan)) });
    }

    /// A scan was recorded whole.
    pub(crate) fn whole(&self, scan: &SharedScan, number: u64, time_us: u64) {
        if !self.is_on() {
            return;
        }
        let (has_modules, bytes) = {
            let scan = lock(scan);
            // Where it ended is kept too, with what it shares with the next one.
            (scan.has_modules(), 2 * scan.bytes())
        };
        let mut before = lock(&self.before);
        before.number = number;
        before.noted = 0;
        before.modules = Some(if has_modules { Modules::Copied } else { Modules::Heard });
        drop(before);
        let mut ring = lock(&self.ring);
        // A scan in STOP has the number of the one before: the newest one counts.
        if ring.entries.back().is_some_and(|last| last.number == number) {
            let last = ring.entries.pop_back();
            ring.bytes = ring.bytes.saturating_sub(last.map_or(0, |last| last.kept.bytes()));
        }
        ring.push(Entry { number, time_us, kept: Arc::new(Kept::Whole(Arc::clone(scan), bytes)) });
    }

    /// Runs the scans from one to another again, and those before them that they need; `seen` is told after each of them that is wanted, and its
    /// tracer hears their statements. The scans that are kept may be fewer.
    ///
    /// # Errors
    /// None of them is kept, or one cannot be run again.
    pub fn visit(&self, from: u64, to: u64, replayer: &mut Replayer, visitor: &mut dyn Visitor) -> Result<(), NotKept> {
        let row = self.row(from, to).ok_or(NotKept::Outside)?;
        for (visited, kept) in row {
            let is_wanted = (from..=to).contains(&visited.scan);
            let mut deaf = Deaf;
            let tracer: &mut dyn Tracer = if is_wanted { visitor.tracer() } else { &mut deaf };
            match &*kept {
                Kept::Whole(scan, _) => drop(lock(scan).replay(replayer, tracer).map_err(NotKept::NotReplayed)?),
                Kept::Noted(scan) => scan.replay(replayer, tracer).map_err(NotKept::NotReplayed)?,
            }
            if let Some(cpu) = replayer.cpu().filter(|_| is_wanted)
                && visitor.ended(cpu, visited) == Goes::No
            {
                return Ok(());
            }
        }
        Ok(())
    }

    /// The scans that are run for some, from one that is kept whole.
    fn row(&self, from: u64, to: u64) -> Option<Vec<(Visited, Arc<Kept>)>> {
        let ring = lock(&self.ring);
        let at = |number: u64| ring.entries.partition_point(|entry| entry.number < number);
        let (first, last) = (at(from), at(to.saturating_add(1)));
        if first >= last {
            return None;
        }
        let begin = (0..=first).rev().find(|&index| ring.entries.get(index).is_some_and(|entry| matches!(*entry.kept, Kept::Whole(..))))?;
        let row = ring.entries.range(begin..last);
        Some(row.map(|entry| (Visited { scan: entry.number, time_us: entry.time_us }, Arc::clone(&entry.kept))).collect())
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

/// Sees scans of the past.
pub trait Visitor {
    /// What hears the statements of the next scan.
    fn tracer(&mut self) -> &mut dyn Tracer;
    /// A scan has ended, and so the CPU stands.
    fn ended(&mut self, cpu: &Cpu, visited: Visited) -> Goes;
}

/// What stored to a place last.
#[derive(Clone, Debug)]
pub struct Writer {
    /// The statement.
    pub place: sieben_engine::FaultPlace,
    /// The scan.
    pub scan: u64,
}

/// Finds the last statement that stored to a name.
pub struct LastWriter<'n> {
    name: &'n sieben_sim::names::Name,
    /// The statement of this scan that stored.
    stores: Option<sieben_engine::FaultPlace>,
    pending: bool,
    /// The last one of all scans so far.
    pub found: Option<Writer>,
}

impl<'n> LastWriter<'n> {
    /// For this name.
    pub fn of(name: &'n sieben_sim::names::Name) -> Self {
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

#[cfg(test)]
mod tests;
