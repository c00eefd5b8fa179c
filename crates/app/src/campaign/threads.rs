//! Ranges of scenarios on threads; what comes of them is taken in by one thread, in the order of the numbers.

use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZero;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, SyncSender};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use sieben_campaign::part::Part;
use sieben_campaign::spec::Keep;
use sieben_workspace::campaign::Campaign;

use super::collected::{Collected, Collector, Encode};
use super::parts;
use crate::failure::Failure;

/// Real time that a range of scenarios shall take, so that what is around it does not matter.
const RANGE: Duration = Duration::from_millis(250);
/// Most scenarios of a range: their rows are kept until those of the ranges before it are there.
const RANGE_MAX: u64 = 4096;
/// Ranges that are under way or wait for those before them, for each thread.
const WINDOW: usize = 4;
/// Progress is told so often.
const TELL: Duration = Duration::from_millis(100);
/// One range of so many runs a second time, in the interpreter.
pub(super) const CHECKED: u64 = 256;

/// What the command line says.
pub(crate) struct Orders<'a> {
    /// How many threads.
    pub(crate) workers: NonZero<usize>,
    /// Scenarios of a range; none = as many as take a quarter of a second.
    pub(crate) range: Option<u64>,
    /// After so many scenarios that did not pass it ends.
    pub(crate) stop_after: Option<u64>,
    /// Real time after which it ends.
    pub(crate) budget: Option<Duration>,
    /// Whether the engine is another one than the interpreter, which some ranges are run in again.
    pub(crate) checked: bool,
    /// The process aborts when it begins this scenario, as if it were killed: for tests.
    pub(crate) abort: Option<u64>,
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
    /// A scenario came to something else in the interpreter.
    Differs(u64),
}

/// Runs the scenarios that the collector does not have; `tell` is told now and then what all have come to so far.
///
/// # Errors
/// What came of them cannot be written down.
pub(crate) fn run(
    campaign: &Campaign,
    orders: &Orders<'_>,
    collector: &mut Collector<'_>,
    tell: &mut dyn FnMut(&Collected),
) -> Result<Ended, Failure> {
    let enough = AtomicBool::new(false);
    let (send_job, jobs) = mpsc::sync_channel::<Job>(orders.workers.get());
    let jobs = Mutex::new(jobs);
    let encode = collector.encode();
    let keep = collector.keep();
    std::thread::scope(|scope| {
        let (send_parts, parts) = mpsc::sync_channel(orders.workers.get());
        for _ in 0..orders.workers.get() {
            let is_over = || enough.load(Ordering::Relaxed) || orders.cancelled.load(Ordering::Relaxed);
            let (jobs, send_parts, encode) = (&jobs, send_parts.clone(), encode.clone());
            scope.spawn(move || {
                Worker { campaign, keep, orders, encode, is_over: &is_over }.work(jobs, &send_parts);
            });
        }
        drop(send_parts);
        let ended = Hand::new(orders, collector).deal(&send_job, &parts, tell);
        enough.store(true, Ordering::Relaxed);
        drop(send_job);
        // A thread that has something to hand in ends as soon as it is taken.
        while parts.recv().is_ok() {}
        ended
    })
}

/// A range to be run.
struct Job {
    range: Range<u64>,
    /// Whether it is to be run in the interpreter, too.
    check: bool,
}

/// What came of a range, or of the first part of it.
struct Done {
    part: Part,
    bytes: Option<Vec<u8>>,
    /// Whether it is the last part of the range, and then how long the whole range took and how many scenarios it has.
    last: Option<(Duration, u64)>,
    /// A scenario that came to something else in the interpreter.
    differs: Option<u64>,
}

/// One thread: takes a range, runs its scenarios, hands in what came of them.
struct Worker<'a> {
    campaign: &'a Campaign,
    keep: Keep,
    orders: &'a Orders<'a>,
    encode: Option<Encode>,
    is_over: &'a dyn Fn() -> bool,
}

impl Worker<'_> {
    fn work(&self, jobs: &Mutex<Receiver<Job>>, send: &SyncSender<Done>) {
        loop {
            let next = jobs.lock().unwrap_or_else(PoisonError::into_inner).recv();
            let Ok(job) = next else { return };
            let begun = Instant::now();
            let scenarios = job.range.end - job.range.start;
            let mut start = job.range.start;
            while start < job.range.end {
                let Some(part) = self.part(start..job.range.end) else { return };
                let differs = if job.check { parts::differs(self.campaign, &part, self.is_over) } else { None };
                start = part.range.end;
                let bytes = self.encode.as_ref().map(|encode| encode(&part));
                let last = (start == job.range.end).then(|| (begun.elapsed(), scenarios));
                if send.send(Done { part, bytes, last, differs }).is_err() {
                    return;
                }
            }
        }
    }

    /// Runs the scenarios of a range. Where failures are counted, a part ends with one: then the run can end there, too.
    fn part(&self, range: Range<u64>) -> Option<Part> {
        let Self { campaign, keep, orders, .. } = *self;
        parts::run(campaign, range, &parts::How { keep, abort: orders.abort, ends_with_failure: orders.stop_after.is_some() }, self.is_over)
    }
}

/// Deals ranges out and takes in what came of them.
struct Hand<'a, 'c> {
    orders: &'a Orders<'a>,
    collector: &'a mut Collector<'c>,
    /// What is not dealt out, the last first.
    missing: Vec<Range<u64>>,
    /// Where the parts that are not taken in begin, in order of their numbers: of each dealt range the next one.
    next: BTreeSet<u64>,
    /// Ranges that are under way.
    under_way: usize,
    /// Parts that an earlier run left, by their first number.
    left: BTreeMap<u64, Part>,
    /// Ranges that were dealt out.
    dealt: u64,
    /// Parts that wait for those before them, by their first number.
    waiting: BTreeMap<u64, Done>,
    /// Scenarios of the next range.
    size: u64,
}

impl<'a, 'c> Hand<'a, 'c> {
    fn new(orders: &'a Orders<'a>, collector: &'a mut Collector<'c>) -> Self {
        let mut missing = collector.missing();
        missing.reverse();
        let size = orders.range.unwrap_or(1);
        // What an earlier run left waits for its turn as the rest does.
        let left: BTreeMap<u64, Part> = collector.before().into_iter().map(|part| (part.range.start, part)).collect();
        let next = left.keys().copied().collect();
        Self { orders, collector, missing, next, under_way: 0, dealt: 0, left, waiting: BTreeMap::new(), size }
    }

    fn deal(&mut self, send: &SyncSender<Job>, parts: &Receiver<Done>, tell: &mut dyn FnMut(&Collected)) -> Result<Ended, Failure> {
        let begun = Instant::now();
        let mut told = begun;
        let window = self.orders.workers.get() * WINDOW;
        loop {
            if self.take()? {
                return Ok(Ended::Failures);
            }
            if self.missing.is_empty() && self.next.is_empty() {
                return Ok(Ended::Whole);
            }
            if self.orders.cancelled.load(Ordering::Relaxed) {
                return Ok(Ended::Cancelled);
            }
            if self.orders.budget.is_some_and(|budget| begun.elapsed() >= budget) {
                return Ok(Ended::Budget);
            }
            while self.under_way + self.waiting.len() < window
                && let Some(gap) = self.missing.last_mut()
            {
                let end = gap.start.saturating_add(self.size).min(gap.end);
                let range = gap.start..end;
                if send.try_send(Job { range, check: self.orders.checked && self.dealt.is_multiple_of(CHECKED) }).is_err() {
                    break;
                }
                self.next.insert(gap.start);
                gap.start = end;
                if gap.is_empty() {
                    self.missing.pop();
                }
                self.under_way += 1;
                self.dealt += 1;
            }
            match parts.recv_timeout(TELL) {
                Ok(Done { differs: Some(number), .. }) => return Ok(Ended::Differs(number)),
                Ok(done) => {
                    self.adapt(&done);
                    self.waiting.insert(done.part.range.start, done);
                }
                Err(RecvTimeoutError::Timeout) => {}
                // All threads are gone: they were told to.
                Err(RecvTimeoutError::Disconnected) => return Ok(Ended::Cancelled),
            }
            if told.elapsed() >= TELL {
                told = Instant::now();
                tell(self.collector.collected());
            }
        }
    }

    /// Looks at how long a range took.
    fn adapt(&mut self, done: &Done) {
        let Some((took, scenarios)) = done.last else { return };
        self.under_way -= 1;
        if self.orders.range.is_none() {
            let each = took.as_secs_f64() / scenarios.max(1) as f64;
            let fitting = (RANGE.as_secs_f64() / each.max(1e-9)) as u64;
            // Not more than four times as many as before: the first ones may have been quick.
            self.size = fitting.clamp(1, RANGE_MAX).min(self.size.saturating_mul(4)).max(1);
        }
    }

    /// Takes in what waited for nothing but its turn; whether so many failed as were asked for.
    fn take(&mut self) -> Result<bool, Failure> {
        while !self.are_enough() {
            let Some(&next) = self.next.first() else { return Ok(false) };
            if self.missing.last().is_some_and(|gap| gap.start < next) {
                return Ok(false);
            }
            if let Some(part) = self.left.remove(&next) {
                self.collector.resume(&part);
            } else if let Some(done) = self.waiting.remove(&next) {
                if done.last.is_none() {
                    self.next.insert(done.part.range.end);
                }
                self.collector.take(&done.part, done.bytes.as_deref())?;
            } else {
                return Ok(false);
            }
            self.next.remove(&next);
        }
        Ok(true)
    }

    fn are_enough(&self) -> bool {
        self.orders.stop_after.is_some_and(|after| self.collector.collected().failures() >= after)
    }
}
