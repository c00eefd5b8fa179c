//! The gate: how other threads come to the CPU between two scans.
//!
//! The thread that scans holds the lock exactly while it scans, so any other thread that holds it stands at the cycle control point: what is
//! read belongs to one scan, what is written falls between two. There is no queue of requests and no copy of an area. The scan has right of
//! way: no thread comes in that could delay it, and one that is in lets go after a portion.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, ThreadId};
use std::time::Duration;

use sieben_cpu::{AccessError, Cpu, OperatingMode, Requester, Restart, Station, StopRequest};
use sieben_model::item::Item;
use sieben_model::value::Value;

use crate::pace::Pace;
use crate::scan_times::ScanTimes;

/// No thread comes in when the next scan begins sooner than this, in microseconds.
pub const NEAR_US: u64 = 50;
/// How long a thread stays inside at a time, in microseconds.
pub const PORTION_US: u64 = 200;
/// Most jobs that are done at a time.
pub const PORTION_JOBS: usize = 64;
/// Most items of one list: all of them are read or written at one cycle control point.
pub const ITEMS_MAX: usize = 1_000;
/// Longest wait for a sign of the scan before a waiting thread looks again.
const LOOK_AGAIN: Duration = Duration::from_millis(20);
/// Longest wait for the start of a run that has not begun.
const START_MAX: Duration = Duration::from_secs(5);
/// No scan is expected.
const NEVER: u64 = u64::MAX;

/// What is on the other side of the gate.
pub struct Plant {
    /// The CPU.
    pub cpu: Cpu,
    /// Its time.
    pub pace: Pace,
    /// Scans since the beginning of the run, over all restarts.
    pub scans: u64,
    /// How long they took.
    pub scan_times: ScanTimes,
    /// The start that the run begins with, as long as it is still to come.
    pub(crate) power_on: Option<Restart>,
    /// A start that has been asked for from outside.
    pub(crate) start: Option<(Restart, Requester)>,
    /// Whether a CPU in STOP waits for a start instead of ending the run.
    pub(crate) waits_in_stop: bool,
    /// Whether it does so after every STOP, whatever caused it.
    pub(crate) stays_in_stop: bool,
    /// Whether something was changed since the last step of the CPU.
    pub(crate) touched: bool,
    /// Input bits that clients have pressed, by byte and number, and until when in the CPU's time.
    pub(crate) pressed: BTreeMap<(u32, u8), u64>,
}

impl Plant {
    /// A CPU that has not started yet.
    pub fn new(cpu: Cpu, pace: Pace) -> Self {
        Self {
            cpu,
            pace,
            scans: 0,
            scan_times: ScanTimes::default(),
            power_on: None,
            start: None,
            waits_in_stop: false,
            stays_in_stop: false,
            touched: false,
            pressed: BTreeMap::new(),
        }
    }

    /// Power comes on: the run begins with this start. A STOP that is asked for before leaves it out.
    pub fn switch_on(&mut self, restart: Restart) {
        self.power_on = Some(restart);
    }

    /// Sends the CPU to STOP on behalf of a client: the run goes on, and the CPU waits there for a start. One that was still to come does not.
    pub fn stop(&mut self, by: Requester) {
        self.waits_in_stop = true;
        self.power_on = None;
        self.start = None;
        Station::stop_by(&mut self.cpu, by);
    }

    /// Asks for a start; the thread that scans carries it out in its next iteration.
    pub fn ask_for_start(&mut self, restart: Restart, by: Requester) {
        self.start = Some((restart, by));
    }

    /// From now on no STOP ends the run: there are others who start the CPU again.
    pub fn stay_in_stop(&mut self) {
        self.stays_in_stop = true;
    }

    /// Another CPU takes the place of this one, and starts in the next iteration: it has scans and a time of its own, at the same speed.
    pub(crate) fn exchange(&mut self, mut cpu: Cpu, cycle_us: u64, real_us: u64) {
        cpu.take_requests_of(&self.cpu);
        let mut pace = Pace::new(self.pace.speed(), cycle_us, self.pace.end_us, real_us);
        pace.missed = self.pace.missed;
        *self = Self {
            start: Some((Restart::Warm, Requester::default())),
            stays_in_stop: self.stays_in_stop,
            touched: true,
            ..Self::new(cpu, pace)
        };
    }

    /// Says that something was changed that the CPU did not do itself: its past is kept from there anew.
    pub fn touch(&mut self) {
        self.touched = true;
    }

    /// Whether the CPU is in STOP, and no start is still to come.
    pub fn is_stopped(&self) -> bool {
        self.cpu.mode() == OperatingMode::Stop && self.power_on.is_none() && self.start.is_none()
    }

    /// Whether a start that was asked for is still to come.
    pub fn is_about_to_start(&self) -> bool {
        self.start.is_some()
    }

    /// Whether a CPU in STOP waits for a start instead of ending the run.
    pub fn wait_in_stop(&mut self, waits: bool) {
        self.waits_in_stop = waits;
    }
}

/// The run is over: the gate is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Closed;

impl std::fmt::Display for Closed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("the run is over")
    }
}

impl std::error::Error for Closed {}

/// Why a list of items is not read or written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListError {
    /// The run is over.
    Closed,
    /// The list is longer than [`ITEMS_MAX`].
    TooLong(usize),
}

impl std::fmt::Display for ListError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Closed => Closed.fmt(f),
            Self::TooLong(length) => write!(f, "{length} items are too many for one list; {ITEMS_MAX} are read or written at once"),
        }
    }
}

impl std::error::Error for ListError {}

impl From<Closed> for ListError {
    fn from(Closed: Closed) -> Self {
        Self::Closed
    }
}

/// The time of the computer in microseconds, from any beginning; it never goes back.
pub type Clock = Box<dyn Fn() -> u64 + Send + Sync>;

/// The gate.
pub struct Gate {
    plant: Mutex<Plant>,
    /// Where threads from outside queue: only the first of them waits for the lock, so that the scan waits for one portion at most.
    queue: Mutex<()>,
    clock: Clock,
    /// When the next scan begins.
    due_us: AtomicU64,
    /// The scan stands before the lock.
    scan_waits: AtomicBool,
    /// How many are outside and want in.
    waiting: AtomicU32,
    /// How many want to be told of the end of a scan.
    listening: AtomicU32,
    /// How many scans have ended.
    points: AtomicU64,
    closed: AtomicBool,
    /// The CPU is switched on, and its start is still to come.
    before_start: AtomicBool,
    /// The thread that made the gate and prepares the run: it does not wait for the start, which it leads to itself.
    made_by: ThreadId,
    /// OB 90 runs, which is interrupted for every thread that wants in.
    background: AtomicBool,
    requests: StopRequest,
    /// Whether the thread that scans is to look up from its pause.
    pause: Mutex<bool>,
    woken: Condvar,
    point: Mutex<()>,
    passed: Condvar,
}

/// A lock whose holder may have panicked: what it protects is plain data, and the next scan finds whatever it finds.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A thread that is counted as long as this is there.
struct Counted<'g>(&'g AtomicU32);

impl<'g> Counted<'g> {
    fn at(count: &'g AtomicU32) -> Self {
        count.fetch_add(1, Ordering::SeqCst);
        Self(count)
    }
}

impl Drop for Counted<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Release);
    }
}

impl Gate {
    /// A gate before a plant. The clock is the computer's. If the plant is switched on, all other threads come in after its
    /// start.
    pub fn new(plant: Plant, clock: Clock) -> Self {
        Self {
            requests: plant.cpu.stop_request(),
            before_start: AtomicBool::new(plant.power_on.is_some()),
            made_by: thread::current().id(),
            plant: Mutex::new(plant),
            queue: Mutex::default(),
            clock,
            due_us: AtomicU64::new(NEVER),
            scan_waits: AtomicBool::default(),
            waiting: AtomicU32::default(),
            listening: AtomicU32::default(),
            points: AtomicU64::default(),
            closed: AtomicBool::default(),
            background: AtomicBool::default(),
            pause: Mutex::default(),
            woken: Condvar::new(),
            point: Mutex::default(),
            passed: Condvar::new(),
        }
    }

    /// What the computer's clock shows, in microseconds.
    pub fn now_us(&self) -> u64 {
        (self.clock)()
    }

    /// Comes in between two scans to change something. The work has to be short: [`PORTION_US`], or [`PORTION_JOBS`] jobs.
    ///
    /// # Errors
    /// The run is over.
    pub fn enter<R>(&self, work: impl FnOnce(&mut Plant) -> R) -> Result<R, Closed> {
        self.serve(|plant| {
            plant.touch();
            work(plant)
        })
    }

    /// As [`Self::enter`], only to look.
    ///
    /// # Errors
    /// The run is over.
    pub fn look<R>(&self, look: impl FnOnce(&Plant) -> R) -> Result<R, Closed> {
        self.serve(|plant| look(plant))
    }

    /// As [`Self::enter`], for work that only changes something now and then and says so ([`Plant::touch`]).
    ///
    /// # Errors
    /// The run is over.
    pub fn serve<R>(&self, work: impl FnOnce(&mut Plant) -> R) -> Result<R, Closed> {
        if self.is_prepared_here() {
            return Ok(work(&mut lock(&self.plant)));
        }
        let _waiting = Counted::at(&self.waiting);
        let _first = lock(&self.queue);
        if self.background.load(Ordering::Acquire) {
            self.requests.let_in();
        }
        self.give_way();
        let mut plant = lock(&self.plant);
        if self.is_closed() {
            return Err(Closed);
        }
        let done = work(&mut plant);
        let starts = plant.start.is_some();
        drop(plant);
        // In STOP the thread that scans may rest for long.
        if starts {
            self.wake();
        }
        Ok(done)
    }

    /// Comes in to look as often as the jobs take, a portion at a time.
    ///
    /// # Errors
    /// The run is over; what was done until then is lost.
    pub fn look_for_each<J, R>(&self, jobs: impl IntoIterator<Item = J>, mut work: impl FnMut(&Plant, J) -> R) -> Result<Vec<R>, Closed> {
        let mut jobs = jobs.into_iter().peekable();
        let mut done = Vec::new();
        while jobs.peek().is_some() {
            self.look(|plant| {
                let end = self.now_us().saturating_add(PORTION_US);
                for job in jobs.by_ref().take(PORTION_JOBS) {
                    done.push(work(plant, job));
                    if self.now_us() >= end {
                        break;
                    }
                }
            })?;
        }
        Ok(done)
    }

    /// Reads a list of items, all at one cycle control point; which scan was the last before it.
    ///
    /// # Errors
    /// The run is over, or the list is too long.
    pub fn read(&self, items: &[Item]) -> Result<(u64, Vec<Result<Value, AccessError>>), ListError> {
        if items.len() > ITEMS_MAX {
            return Err(ListError::TooLong(items.len()));
        }
        Ok(self.look(|plant| (plant.scans, plant.cpu.read_items(items)))?)
    }

    /// Writes a list of items, all between the same two scans.
    ///
    /// # Errors
    /// The run is over, or the list is too long: then nothing is written.
    pub fn write(&self, values: &[(Item, Value)]) -> Result<(u64, Vec<Result<(), AccessError>>), ListError> {
        if values.len() > ITEMS_MAX {
            return Err(ListError::TooLong(values.len()));
        }
        Ok(self.enter(|plant| (plant.scans, plant.cpu.write_items(values)))?)
    }

    /// Changes something about the run, and wakes the thread that scans from its pause.
    ///
    /// # Errors
    /// The run is over.
    pub fn command<R>(&self, work: impl FnOnce(&mut Plant) -> R) -> Result<R, Closed> {
        let done = self.enter(work)?;
        self.wake();
        Ok(done)
    }

    /// Wakes the thread that scans from its pause.
    pub fn wake(&self) {
        *lock(&self.pause) = true;
        self.woken.notify_all();
    }

    /// Waits until more than `points` scans have ended, but not longer than `most`; how many have ended.
    pub fn wait_for_point(&self, points: u64, most: Duration) -> u64 {
        let _listening = Counted::at(&self.listening);
        let point = lock(&self.point);
        let waits = |(): &mut ()| self.points.load(Ordering::SeqCst) <= points && !self.is_closed();
        drop(self.passed.wait_timeout_while(point, most, waits));
        self.points()
    }

    /// How many scans and services have ended.
    pub fn points(&self) -> u64 {
        self.points.load(Ordering::SeqCst)
    }

    /// Whether the run is over.
    pub fn is_closed(&self) -> bool {
        self.closed.load(Ordering::Acquire)
    }

    /// Whether the run has not begun, and this thread prepares it.
    fn is_prepared_here(&self) -> bool {
        self.before_start.load(Ordering::Acquire) && !self.is_closed() && thread::current().id() == self.made_by
    }

    /// Waits while the scan is inside or near, and for the start of a run that has not begun.
    fn give_way(&self) {
        let came_us = self.now_us();
        let before_start = || {
            let waited_us = self.now_us().saturating_sub(came_us);
            self.before_start.load(Ordering::Acquire) && u128::from(waited_us) < START_MAX.as_micros()
        };
        loop {
            let points = self.points();
            let due = self.due_us.load(Ordering::Acquire);
            let near = due != NEVER && due.saturating_sub(self.now_us()) < NEAR_US;
            if self.is_closed() || !(near || self.scan_waits.load(Ordering::Acquire) || before_start()) {
                return;
            }
            let point = lock(&self.point);
            let waits = |(): &mut ()| self.points.load(Ordering::SeqCst) == points && !self.is_closed();
            let (point, time_out) = self.passed.wait_timeout_while(point, LOOK_AGAIN, waits).unwrap_or_else(PoisonError::into_inner);
            drop(point);
            // A thread that should have scanned long ago does something else: it is not waited for.
            if time_out.timed_out() && !self.scan_waits.load(Ordering::Acquire) && !before_start() {
                return;
            }
        }
    }

    /// The thread that scans comes in: all others stay outside until it has done its work, whose end is told.
    pub(crate) fn scan<R>(&self, work: impl FnOnce(&mut Plant) -> R) -> R {
        self.scan_waits.store(true, Ordering::Release);
        let mut plant = lock(&self.plant);
        self.scan_waits.store(false, Ordering::Release);
        self.due_us.store(NEVER, Ordering::Release);
        let done = work(&mut plant);
        if plant.power_on.is_none() {
            self.before_start.store(false, Ordering::Release);
        }
        drop(plant);
        self.points.fetch_add(1, Ordering::SeqCst);
        if self.is_wanted() || self.listening.load(Ordering::SeqCst) > 0 {
            drop(lock(&self.point));
            self.passed.notify_all();
        }
        done
    }

    /// OB 90 runs, until a thread wants in.
    pub(crate) fn in_background(&self, run: impl FnOnce()) {
        self.background.store(true, Ordering::SeqCst);
        if self.is_wanted() {
            self.requests.let_in();
        }
        run();
        self.background.store(false, Ordering::Release);
    }

    /// Whether a thread wants in.
    pub(crate) fn is_wanted(&self) -> bool {
        self.waiting.load(Ordering::SeqCst) > 0
    }

    /// Waits for the next scan, in `us` microseconds, with the gate open; sooner if it is woken, `true` then.
    pub(crate) fn rest(&self, us: u64) -> bool {
        self.due_us.store(self.now_us().saturating_add(us), Ordering::Release);
        let pause = lock(&self.pause);
        let (mut pause, _) =
            self.woken.wait_timeout_while(pause, Duration::from_micros(us), |woken| !*woken).unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut *pause)
    }

    /// The run is over: the threads that wait are told, and the gate is closed.
    pub fn close(&self) {
        self.closed.store(true, Ordering::Release);
        drop(lock(&self.point));
        self.passed.notify_all();
        self.wake();
    }

    /// The run is over: what is done with the plant at the end, with the gate closed.
    pub fn finish<R>(&self, work: impl FnOnce(&mut Plant) -> R) -> R {
        self.close();
        work(&mut lock(&self.plant))
    }
}
