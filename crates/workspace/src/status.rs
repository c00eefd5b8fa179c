//! The status of a scan: what each statement of some blocks found and left.
//!
//! The CPU never leaves machine code for it. A few times a second one scan is recorded, with all that comes in while it runs, and replayed in
//! the interpreter by another thread; where that ends differently from the real scan, the sample says so.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;

use sieben_cpu::{Cpu, EndState, NotReplayed, OperatingMode, RecordedScan, Replayer, Step};
use sieben_engine::machine::Registers;
use sieben_engine::{FaultPlace, Machine, StatementEvent, Tracer};
use sieben_model::block::BlockId;

use sieben_sim::names::Name;

use crate::diagnosed::Diagnosed;
use crate::gate::Plant;
use crate::observed::Observed;
use crate::past::Past;

/// Least distance of two recorded scans, in microseconds: 20 a second at most.
pub const DISTANCE_US: u64 = 50_000;
/// How long a block is looked at after it was asked for without waiting, in microseconds of the computer's time.
const KEPT_US: u64 = 3_000_000;
/// Blocks that are looked at in this way at once.
const KEPT_MAX: usize = 64;
/// Most statements of one sample; a block has fewer.
const STATEMENTS_MAX: usize = 200_000;

/// What one statement found and left when it was executed last in a scan.
#[derive(Clone, Debug, PartialEq)]
pub struct StatementStatus {
    /// The registers that it found.
    pub before: Registers,
    /// The registers that it left.
    pub after: Registers,
    /// How often it was executed in this scan.
    pub times: u32,
    /// The variable that it wrote, as people read it, where that was asked for.
    pub value: Option<String>,
}

/// The variables that statements of a block write, by the number of the statement from 0.
pub type Written = Arc<BTreeMap<u32, Name>>;

/// The calls of a block that are looked at: all of them, or those with one instance data block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Calls {
    /// The block.
    pub block: BlockId,
    /// The number of the instance data block.
    pub instance: Option<u16>,
}

impl From<BlockId> for Calls {
    fn from(block: BlockId) -> Self {
        Self { block, instance: None }
    }
}

/// The instance data blocks that the blocks that run were called with, outermost first: a block may open another one later.
#[derive(Clone, Debug, Default)]
pub struct Instances(Vec<u16>);

impl Instances {
    /// To be told before each statement.
    pub fn before(&mut self, machine: &Machine) {
        self.0.truncate(machine.frames.len());
        let opened = u16::try_from(machine.registers.di_number).unwrap_or_default();
        self.0.resize(machine.frames.len(), opened);
    }

    /// What a statement of the block that runs belongs to: all calls of the block, and those with its instance data block.
    pub fn calls(&self, block: BlockId) -> impl Iterator<Item = Calls> + use<> {
        let instance = self.0.last().copied().filter(|&number| number > 0);
        let own = instance.map(|number| Calls { block, instance: Some(number) });
        std::iter::once(Calls::from(block)).chain(own)
    }
}

/// What the statements of calls found and left, by their number from 0.
pub type Statements = BTreeMap<(Calls, u32), StatementStatus>;

/// The status of one scan.
#[derive(Clone, Debug, Default)]
pub struct Sample {
    /// Scans of the run up to this one.
    pub scan: u64,
    /// When it began, in the time of the CPU.
    pub time_us: u64,
    /// Whether the replay ended as the real scan did: the same memory, timers and counters.
    pub same: bool,
    /// The calls that were looked at.
    pub calls: Vec<Calls>,
    /// Their statements that were executed.
    pub statements: Statements,
}

impl Sample {
    /// The statements of some calls that were executed, in the order of their numbers.
    pub fn of(&self, calls: Calls) -> impl Iterator<Item = (u32, &StatementStatus)> {
        self.statements.range((calls, 0)..=(calls, u32::MAX)).map(|(&(_, number), status)| (number, status))
    }
}

/// What came of a look at the status.
pub type Looked = Result<Arc<Sample>, NotReplayed>;

/// Sees each scan that is replayed, in the thread that replays.
pub trait Onlooker: Send + Sync {
    /// A statement of calls that are looked at was executed; the machine is as it left it.
    fn statement(&self, calls: Calls, machine: &Machine, event: &StatementEvent) {
        let _ = (calls, machine, event);
    }
    /// The variables whose values it wants of the statements of a block that write them.
    fn written(&self, block: BlockId) -> Option<Written> {
        let _ = block;
        None
    }
    /// The scan has ended, and so the CPU stands: a copy that only this sees.
    fn ended(&self, cpu: &Cpu, sample: &Arc<Sample>);
}

/// A recording with its place in the run.
struct Recorded {
    scan: RecordedScan,
    number: u64,
    time_us: u64,
    /// What the computer's clock showed.
    real_us: u64,
    /// Which CPU of the run it is of.
    cpu: u64,
}

/// A block that is looked at for a while.
struct Kept {
    until_us: u64,
    written: Written,
}

/// The newest sample, with a number that grows with each.
#[derive(Default)]
struct Newest {
    number: u64,
    looked: Option<Looked>,
}

/// Where the status of scans is asked for.
#[derive(Default)]
pub struct Desk {
    /// Where changes are asked for.
    pub observed: Observed,
    /// In which scans entries of the diagnostic buffer came.
    pub diagnosed: Diagnosed,
    /// Blocks that are looked at for a while.
    kept: Mutex<BTreeMap<BlockId, Kept>>,
    /// Until when the last of them is, in the computer's time.
    kept_until_us: AtomicU64,
    /// How many look at which calls.
    calls: Mutex<BTreeMap<Calls, usize>>,
    /// How many look at all.
    onlookers: AtomicUsize,
    /// When the last scan was recorded.
    last_us: AtomicU64,
    recorded: Mutex<Option<Recorded>>,
    came: Condvar,
    /// How many scans were recorded.
    recordings: AtomicU64,
    /// A thread replays.
    replaying: AtomicBool,
    /// How the last recorded scan ended: the next recording shares with it what is the same.
    like: Mutex<Option<Arc<EndState>>>,
    newest: Mutex<Newest>,
    sampled: Condvar,
    /// Held while a replayed scan is shown: then no other CPU comes.
    showing: Mutex<()>,
    /// Which CPU of the run runs, from 0.
    cpu: AtomicU64,
    past: Past,
    /// Sees each scan that is replayed, if anything does.
    onlooker: OnceLock<Arc<dyn Onlooker>>,
}

/// Calls are looked at as long as this is there.
pub struct Look<'d> {
    desk: &'d Desk,
    calls: Vec<Calls>,
}

impl Drop for Look<'_> {
    fn drop(&mut self) {
        let mut known = lock(&self.desk.calls);
        for calls in &self.calls {
            if let Some(count) = known.get_mut(calls) {
                *count -= 1;
                if *count == 0 {
                    known.remove(calls);
                }
            }
        }
        self.desk.onlookers.fetch_sub(1, Ordering::Release);
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Desk {
    /// Looks at blocks, or some of their calls, from now on, until the look is dropped.
    pub fn look<C: Into<Calls>>(&self, calls: impl IntoIterator<Item = C>) -> Look<'_> {
        let calls: Vec<Calls> = calls.into_iter().map(Into::into).collect();
        let mut known = lock(&self.calls);
        for &calls in &calls {
            *known.entry(calls).or_default() += 1;
        }
        drop(known);
        self.onlookers.fetch_add(1, Ordering::Release);
        Look { desk: self, calls }
    }

    /// The past of the run.
    pub fn past(&self) -> &Past {
        &self.past
    }

    /// Looks at a block for a while; `written` are the variables that its statements write.
    pub fn keep_looking(&self, block: BlockId, written: Written, real_us: u64) {
        let until_us = real_us.saturating_add(KEPT_US);
        let mut kept = lock(&self.kept);
        kept.retain(|_, kept| kept.until_us > real_us);
        if kept.len() < KEPT_MAX || kept.contains_key(&block) {
            kept.insert(block, Kept { until_us, written });
            self.kept_until_us.fetch_max(until_us, Ordering::Release);
        }
    }

    /// The newest sample with its number; `None` before there is one.
    pub fn newest(&self) -> Option<(u64, Looked)> {
        let newest = lock(&self.newest);
        newest.looked.clone().map(|looked| (newest.number, looked))
    }

    /// One scan, recorded if there are onlookers and it is time. `real_us` is what the computer's clock shows. Of the scans that are asked for
    /// while time stands still the last one is always recorded: it is the one that they look at.
    pub(crate) fn scan(&self, plant: &mut Plant, clock: &mut dyn FnMut() -> u64, real_us: u64) {
        self.diagnosed.note(plant, plant.scans);
        // A CPU in STOP only lets its plants live on.
        let scan = plant.scans + u64::from(plant.cpu.mode() != OperatingMode::Stop);
        self.past.step(plant, Step::Scan, clock, |plant, clock| self.scan_now(plant, clock, real_us));
        self.diagnosed.note(plant, scan);
    }

    /// What comes between two scans.
    pub(crate) fn serve(&self, plant: &mut Plant, clock: &mut dyn FnMut() -> u64) {
        self.past.step(plant, Step::Serve, clock, |plant, clock| plant.cpu.serve_with(clock, None));
    }

    fn scan_now(&self, plant: &mut Plant, clock: &mut dyn FnMut() -> u64, real_us: u64) {
        let last = self.last_us.load(Ordering::Relaxed);
        let is_last_step = plant.pace.is_paused() && !plant.pace.has_steps();
        let is_due = last == 0 || is_last_step || real_us.saturating_sub(last) >= DISTANCE_US;
        let looked_at = self.onlookers.load(Ordering::Acquire) > 0 || self.kept_until_us.load(Ordering::Acquire) > real_us;
        let wanted = looked_at && is_due;
        // The last recording has not been taken for its replay yet: this scan is not needed.
        let free = wanted && self.recorded.try_lock().is_ok_and(|recorded| recorded.is_none());
        if !free {
            plant.cpu.scan_with(clock, None);
            return;
        }
        self.last_us.store(real_us.max(1), Ordering::Relaxed);
        let like = lock(&self.like).clone();
        // A CPU in STOP only lets its plants live on.
        let number = plant.scans + u64::from(plant.cpu.mode() != OperatingMode::Stop);
        let (_, scan) = plant.cpu.scan_recorded(clock, like.as_deref());
        *lock(&self.like) = Some(Arc::clone(scan.after()));
        let time_us = plant.cpu.time_us();
        let cpu = self.cpu.load(Ordering::Relaxed);
        *lock(&self.recorded) = Some(Recorded { scan, number, time_us, real_us, cpu });
        self.recordings.fetch_add(1, Ordering::Relaxed);
        self.came.notify_all();
    }

    /// Another CPU runs from now on: nothing that was seen of the one before is shown any more.
    pub(crate) fn reset(&self) {
        self.observed.reset();
        self.diagnosed.reset();
        self.past.reset();
        lock(&self.kept).clear();
        *lock(&self.like) = None;
        *lock(&self.recorded) = None;
        let _showing = lock(&self.showing);
        lock(&self.newest).looked = None;
        self.cpu.fetch_add(1, Ordering::Relaxed);
    }

    /// From now on this sees each scan that is replayed; what was said first holds.
    pub fn set_onlooker(&self, onlooker: Arc<dyn Onlooker>) {
        // The second call has nothing to add.
        let _ = self.onlooker.set(onlooker);
    }

    /// How many scans were recorded: these took longer than others.
    pub fn recordings(&self) -> u64 {
        self.recordings.load(Ordering::Relaxed)
    }

    /// Replays what is recorded until `is_over`: the body of a thread. One is enough: where another one replays already, this returns at once.
    pub fn replay(&self, is_over: impl Fn() -> bool) {
        if self.replaying.swap(true, Ordering::AcqRel) {
            return;
        }
        self.replay_until(is_over);
        self.replaying.store(false, Ordering::Release);
    }

    fn replay_until(&self, is_over: impl Fn() -> bool) {
        let mut replayer = Replayer::default();
        while !is_over() {
            let recorded = lock(&self.recorded);
            let (recorded, _) = self
                .came
                .wait_timeout_while(recorded, Duration::from_millis(200), |recorded| recorded.is_none())
                .unwrap_or_else(PoisonError::into_inner);
            let Some(recorded) = ({ recorded }).take() else { continue };
            let looked = self.sample(&recorded, &mut replayer).map(Arc::new);
            let _showing = lock(&self.showing);
            // Another CPU has come meanwhile.
            if self.cpu.load(Ordering::Relaxed) != recorded.cpu {
                continue;
            }
            if let (Ok(sample), Some(onlooker), Some(cpu)) = (&looked, self.onlooker.get(), replayer.cpu()) {
                onlooker.ended(cpu, sample);
            }
            let mut newest = lock(&self.newest);
            newest.number += 1;
            newest.looked = Some(looked);
            drop(newest);
            self.sampled.notify_all();
        }
    }

    fn sample(&self, recorded: &Recorded, replayer: &mut Replayer) -> Result<Sample, NotReplayed> {
        let mut calls: BTreeSet<Calls> = lock(&self.calls).keys().copied().collect();
        let mut written = BTreeMap::new();
        for (&block, kept) in lock(&self.kept).iter().filter(|(_, kept)| kept.until_us > recorded.real_us) {
            written.insert(block, Arc::clone(&kept.written));
            calls.insert(block.into());
        }
        let onlooker = self.onlooker.get().map(AsRef::as_ref);
        for &Calls { block, .. } in &calls {
            if let (Entry::Vacant(place), Some(onlooker)) = (written.entry(block), onlooker)
                && let Some(wanted) = onlooker.written(block)
            {
                place.insert(wanted);
            }
        }
        let mut collector = Collector { calls, written, onlooker, ..Collector::default() };
        let same = recorded.scan.replay(replayer, &mut collector)?;
        let Collector { calls, statements, .. } = collector;
        Ok(Sample { scan: recorded.number, time_us: recorded.time_us, same, calls: calls.into_iter().collect(), statements })
    }

    /// Waits for a sample that is newer than `number`, but not longer than `most`; the newest one with its number, if there is any.
    pub fn wait_for_sample(&self, number: u64, most: Duration) -> Option<(u64, Looked)> {
        let newest = lock(&self.newest);
        let (newest, _) =
            self.sampled.wait_timeout_while(newest, most, |newest| newest.number <= number).unwrap_or_else(PoisonError::into_inner);
        newest.looked.clone().filter(|_| newest.number > number).map(|looked| (newest.number, looked))
    }

    /// The number of the newest sample.
    pub fn number(&self) -> u64 {
        lock(&self.newest).number
    }
}

/// Keeps what the statements of some calls found and left.
#[derive(Default)]
struct Collector<'o> {
    calls: BTreeSet<Calls>,
    written: BTreeMap<BlockId, Written>,
    instances: Instances,
    statements: Statements,
    onlooker: Option<&'o dyn Onlooker>,
}

impl Tracer for Collector<'_> {
    fn pauses_before(&mut self, machine: &Machine, _: FaultPlace) -> bool {
        self.instances.before(machine);
        false
    }

    fn statement(&mut self, machine: &Machine, event: &StatementEvent) {
        for calls in self.instances.calls(event.place.block) {
            if self.calls.contains(&calls) {
                self.take(calls, machine, event);
            }
        }
    }
}

impl Collector<'_> {
    fn take(&mut self, calls: Calls, machine: &Machine, event: &StatementEvent) {
        if let Some(onlooker) = self.onlooker {
            onlooker.statement(calls, machine, event);
        }
        let number = event.place.statement;
        let value = self.written.get(&calls.block).and_then(|written| value_written(written, machine, event));
        keep(&mut self.statements, (calls, number), event, value);
    }
}

/// What a statement has written, as people read it; the machine is as it left it.
pub fn value_written(written: &Written, machine: &Machine, event: &StatementEvent) -> Option<String> {
    let name = written.get(&event.place.statement)?;
    name.shown_in(machine, &event.after).map(|shown| shown.readable())
}

/// Keeps what a statement found and left when it was executed last; of too many only those that came first.
pub fn keep(statements: &mut Statements, place: (Calls, u32), event: &StatementEvent, value: Option<String>) {
    let full = statements.len() >= STATEMENTS_MAX;
    match statements.entry(place) {
        Entry::Occupied(mut known) => {
            let status = known.get_mut();
            status.before.clone_from(&event.before);
            status.after.clone_from(&event.after);
            status.times = status.times.saturating_add(1);
            status.value = value;
        }
        Entry::Vacant(_) if full => {}
        Entry::Vacant(place) => {
            place.insert(StatementStatus { before: event.before.clone(), after: event.after.clone(), times: 1, value });
        }
    }
}
