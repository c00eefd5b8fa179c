//! Controllers of a fleet on threads, one time window after the other: between two windows no thread runs any of them.

use std::num::NonZero;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Barrier, Mutex, PoisonError};
use std::time::{Duration, Instant};

use sieben_workspace::fleet::{Fleet, Window, Windows};

/// Controllers that a thread takes at once: few enough that all threads end together.
const TAKEN: usize = 16;
/// Longest sleep without a look at Ctrl-C.
const NAP: Duration = Duration::from_millis(50);

/// What the command line says.
pub(crate) struct Orders<'a> {
    /// The windows of the run.
    pub(crate) windows: Windows,
    /// How many threads.
    pub(crate) threads: NonZero<usize>,
    /// How many times as fast as real time; none = as fast as it goes.
    pub(crate) factor: Option<f64>,
    /// Whether it shall end.
    pub(crate) cancelled: &'a AtomicBool,
}

/// How a run went.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Ran {
    /// How long it took.
    pub(crate) took: Duration,
    /// It was told to end before its time.
    pub(crate) interrupted: bool,
    /// It was told to end while some controllers were through a window and others not.
    pub(crate) torn: bool,
    /// By how much the latest window began too late for real time.
    pub(crate) late: Duration,
}

/// What all threads see.
struct Shared {
    /// The window that they are in; none = it is over.
    window: Option<Window>,
    ran: Ran,
    /// When the fleet's time was 0, later by what the computer was late.
    began: Instant,
}

/// Runs a fleet.
pub(crate) fn run(fleet: &Fleet, orders: &Orders<'_>) -> Ran {
    let begun = Instant::now();
    let threads = orders.threads.get().min(fleet.len().max(1));
    let barrier = Barrier::new(threads);
    let next = AtomicUsize::new(0);
    let shared = Mutex::new(Shared { window: None, ran: Ran::default(), began: begun });
    let windows = AtomicUsize::new(0);
    let over = || orders.cancelled.load(Ordering::Relaxed);
    let work = || {
        let clock = || u64::try_from(begun.elapsed().as_nanos()).unwrap_or(u64::MAX);
        loop {
            if barrier.wait().is_leader() {
                let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
                begin(&mut shared, orders, windows.fetch_add(1, Ordering::Relaxed) as u64, &over);
                next.store(0, Ordering::Relaxed);
            }
            barrier.wait();
            let Some(window) = shared.lock().unwrap_or_else(PoisonError::into_inner).window else { return };
            if !through(fleet, &window, &next, &over, &clock) {
                shared.lock().unwrap_or_else(PoisonError::into_inner).ran.torn = true;
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
    let ran = shared.into_inner().unwrap_or_else(PoisonError::into_inner).ran;
    Ran { took: begun.elapsed(), interrupted: ran.interrupted || ran.torn, ..ran }
}

/// Begins the next window, when it is due.
fn begin(shared: &mut Shared, orders: &Orders<'_>, number: u64, over: &dyn Fn() -> bool) {
    shared.window = orders.windows.get(number);
    if let (Some(window), Some(factor)) = (shared.window, orders.factor) {
        let due = shared.began + Duration::from_secs_f64(window.begin_us(window.from) as f64 / 1e6 / factor);
        while let Some(left) = due.checked_duration_since(Instant::now()).filter(|left| !left.is_zero() && !over()) {
            std::thread::sleep(left.min(NAP));
        }
        // What comes too late is not made up for: all that follows is as much later.
        let late = Instant::now().saturating_duration_since(due);
        shared.began += late;
        shared.ran.late = shared.ran.late.max(late);
    }
    if shared.window.is_some() && over() {
        shared.ran.interrupted = true;
        shared.window = None;
    }
}

/// Takes controllers through a window until none is left; `false` if it was told to end before.
fn through(fleet: &Fleet, window: &Window, next: &AtomicUsize, over: &dyn Fn() -> bool, clock: &dyn Fn() -> u64) -> bool {
    loop {
        let first = next.fetch_add(TAKEN, Ordering::Relaxed);
        if first >= fleet.len() {
            return true;
        }
        for number in first..(first + TAKEN).min(fleet.len()) {
            if over() {
                return false;
            }
            fleet.run(number, window, clock);
        }
    }
}
