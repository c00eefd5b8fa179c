//! Ranges of scenarios on threads; what comes of them is taken in by one thread, in the order of the numbers.

use std::collections::BTreeMap;
use std::num::NonZero;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, SyncSender};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use sieben_campaign::row::{Row, Verdict};
use sieben_campaign::tally::Tally;
use sieben_workspace::campaign::Campaign;

/// Real time that a range of scenarios shall take, so that what is around it does not matter.
const RANGE: Duration = Duration::from_millis(250);
/// Most scenarios of a range: their rows are kept until those of the ranges before it are there.
const RANGE_MAX: u64 = 4096;
/// Ranges that are under way or wait for those before them, for each thread.
const WINDOW: usize = 4;
/// Progress is told so often.
const TELL: Duration = Duration::from_millis(100);

/// What the command line says.
pub(crate) struct Orders<'a> {
    /// The numbers of the scenarios.
    pub(crate) numbers: Range<u64>,
    /// How many threads.
    pub(crate) workers: NonZero<usize>,
    /// Scenarios of a range; none = as many as take a quarter of a second.
    pub(crate) range: Option<u64>,
    /// After so many scenarios that did not pass it ends.
    pub(crate) stop_after: Option<u64>,
    /// Real time after which it ends.
    pub(crate) budget: Option<Duration>,
    /// Whether it shall end.
    pub(crate) cancelled: &'a AtomicBool,
}

/// How a run of a campaign ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ended {
    /// All scenarios were run.
    Whole,
    /// So many failed as were asked for.
    Failures,
    /// Its time was used up.
    Budget,
    /// It was told to.
    Cancelled,
}

/// Runs scenarios; `tell` is told now and then what they have come to so far, and what is missing to say so of more.
pub(crate) fn run(campaign: &Campaign, orders: &Orders<'_>, tell: &mut dyn FnMut(&Tally)) -> (Tally, Ended) {
    let enough = AtomicBool::new(false);
    let (send_range, ranges) = mpsc::sync_channel::<Range<u64>>(orders.workers.get());
    let ranges = Mutex::new(ranges);
    std::thread::scope(|scope| {
        let (send_rows, rows) = mpsc::sync_channel(orders.workers.get());
        for _ in 0..orders.workers.get() {
            let send_rows = send_rows.clone();
            let (ranges, enough) = (&ranges, &enough);
            scope.spawn(move || {
                work(campaign, ranges, &send_rows, &|| enough.load(Ordering::Relaxed) || orders.cancelled.load(Ordering::Relaxed))
            });
        }
        drop(send_rows);
        let mut hand = Hand::new(campaign, orders);
        let ended = hand.deal(&send_range, &rows, tell);
        enough.store(true, Ordering::Relaxed);
        drop(send_range);
        // A thread that has rows to hand in ends as soon as they are taken.
        while rows.recv().is_ok() {}
        (hand.tally, ended)
    })
}

/// A range with what came of it and how long that took.
struct Done {
    range: Range<u64>,
    rows: Vec<Row>,
    took: Duration,
}

/// One thread: takes a range, runs its scenarios, hands in their rows.
fn work(campaign: &Campaign, ranges: &Mutex<Receiver<Range<u64>>>, send: &SyncSender<Done>, is_over: &dyn Fn() -> bool) {
    loop {
        let next = ranges.lock().unwrap_or_else(PoisonError::into_inner).recv();
        let Ok(range) = next else { return };
        let begun = Instant::now();
        let mut rows = Vec::with_capacity((range.end - range.start).min(RANGE_MAX) as usize);
        for number in range.clone() {
            if is_over() {
                return;
            }
            let Ok(row) = campaign.run(number, &|| !is_over()) else { return };
            rows.push(row);
        }
        if send.send(Done { range, rows, took: begun.elapsed() }).is_err() {
            return;
        }
    }
}

/// Deals ranges out and takes rows in.
struct Hand<'a> {
    orders: &'a Orders<'a>,
    tally: Tally,
    /// The first scenario that is not dealt out.
    next: u64,
    /// The first scenario that is not taken in.
    taken: u64,
    /// Ranges that are under way.
    under_way: usize,
    /// Ranges that wait for those before them, by their first number.
    waiting: BTreeMap<u64, Vec<Row>>,
    /// Scenarios of the next range.
    size: u64,
    failures: u64,
}

impl<'a> Hand<'a> {
    fn new(campaign: &Campaign, orders: &'a Orders<'a>) -> Self {
        Self {
            orders,
            tally: Tally::new(&campaign.spec),
            next: orders.numbers.start,
            taken: orders.numbers.start,
            under_way: 0,
            waiting: BTreeMap::new(),
            size: orders.range.unwrap_or(1),
            failures: 0,
        }
    }

    fn deal(&mut self, send: &SyncSender<Range<u64>>, rows: &Receiver<Done>, tell: &mut dyn FnMut(&Tally)) -> Ended {
        let begun = Instant::now();
        let mut told = begun;
        let window = self.orders.workers.get() * WINDOW;
        while self.taken < self.orders.numbers.end {
            if self.orders.cancelled.load(Ordering::Relaxed) {
                return Ended::Cancelled;
            }
            if self.orders.budget.is_some_and(|budget| begun.elapsed() >= budget) {
                return Ended::Budget;
            }
            while self.next < self.orders.numbers.end && self.under_way + self.waiting.len() < window {
                let end = self.next.saturating_add(self.size).min(self.orders.numbers.end);
                if send.try_send(self.next..end).is_err() {
                    break;
                }
                self.next = end;
                self.under_way += 1;
            }
            match rows.recv_timeout(TELL) {
                Ok(done) => {
                    if self.take(done) {
                        return Ended::Failures;
                    }
                }
                Err(RecvTimeoutError::Timeout) => {}
                // All threads are gone: they were told to.
                Err(RecvTimeoutError::Disconnected) => return Ended::Cancelled,
            }
            if told.elapsed() >= TELL {
                told = Instant::now();
                tell(&self.tally);
            }
        }
        Ended::Whole
    }

    /// Takes a range in, and those that waited for it; whether so many failed as were asked for.
    fn take(&mut self, done: Done) -> bool {
        self.under_way -= 1;
        if self.orders.range.is_none() {
            let each = done.took.as_secs_f64() / done.rows.len().max(1) as f64;
            let fitting = (RANGE.as_secs_f64() / each.max(1e-9)) as u64;
            // Not more than four times as many as before: the first ones may have been quick.
            self.size = fitting.clamp(1, RANGE_MAX).min(self.size.saturating_mul(4)).max(1);
        }
        self.waiting.insert(done.range.start, done.rows);
        while let Some(rows) = self.waiting.remove(&self.taken) {
            for row in rows {
                self.taken = row.scenario + 1;
                self.tally.add(&row);
                self.failures += u64::from(row.verdict != Verdict::Pass);
                if self.orders.stop_after.is_some_and(|after| self.failures >= after) {
                    return true;
                }
            }
        }
        false
    }
}
