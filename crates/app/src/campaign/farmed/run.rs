//! The side of the run: what a queue is told is missing, and what comes back from it.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use sieben_campaign::identity::MEANING;
use sieben_campaign::packed::Packed;
use sieben_campaign::ranges::Ranges;
use sieben_farm::{Announced, Came, Finished, Ledger, Options, Server, Workers};
use sieben_workspace::campaign::{Campaign, Way};

use super::in_order::InOrder;
use super::server::failed;
use crate::campaign::Ended;
use crate::campaign::collected::{Collected, Collector};
use crate::campaign::files::{Columns, decode, digest};
use crate::failure::Failure;

/// Real time that a range shall take a worker: what is around it, a hundredth of that at most.
const RANGE: Duration = Duration::from_secs(1);
/// Most scenarios of a range.
const RANGE_MAX: u64 = 4_096;
/// The first scenario is looked at for so long.
const LOOK: Duration = Duration::from_secs(2);

/// What the command line says.
pub(crate) struct Orders<'a> {
    /// The queue.
    pub(crate) server: Server,
    /// Scenarios of a range; none = as many as take a second.
    pub(crate) range: Option<u64>,
    /// After so many scenarios that did not pass it ends.
    pub(crate) stop_after: Option<u64>,
    /// Real time after which it ends.
    pub(crate) budget: Option<Duration>,
    /// Whether it shall end.
    pub(crate) cancelled: &'a AtomicBool,
}

/// Runs what a collector does not have on whatever workers there are; `digests` tells the bytes of what an earlier run left.
///
/// # Errors
/// The server cannot be used, or what comes cannot be written down.
pub(crate) fn run(
    campaign: &Campaign,
    text: &str,
    orders: &Orders<'_>,
    collector: &mut Collector<'_>,
    digests: Vec<(Range<u64>, String)>,
    tell: &mut dyn FnMut(&Collected),
    alive: &mut dyn FnMut(&Workers),
) -> Result<(Ended, Finished), Failure> {
    let missing = collector.missing();
    let left = collector.before();
    let mut there = Ranges::default();
    for part in &left {
        there.insert(part.range.clone());
    }
    let in_order = match orders.stop_after {
        Some(stop_after) => {
            let mut in_order = InOrder::new(stop_after, left);
            if in_order.take(campaign, collector)? {
                return Ok((Ended::Failures, Finished::default()));
            }
            Some(in_order)
        }
        None => {
            left.iter().for_each(|part| collector.resume(part));
            None
        }
    };
    if missing.is_empty() {
        return Ok((Ended::Whole, Finished::default()));
    }
    let packed = Packed { spec: text.to_owned(), seed: campaign.spec.seed, bundle: campaign.bundle.clone() };
    let announced = Announced { campaign: campaign.identity.campaign.clone(), meaning: MEANING, bundle: packed.bytes() };
    let size = orders.range.unwrap_or_else(|| fitting(campaign, missing[0].start));
    let known = digests.into_iter().map(|(range, digest)| (range.start, (range.end, digest))).collect();
    let begun = Instant::now();
    let mut farmed = Farmed {
        columns: Columns::of(campaign),
        unsent: missing.iter().rev().cloned().collect(),
        missing,
        there,
        size,
        known,
        campaign,
        in_order,
        collector,
        failed: None,
        ended: Cell::new(None),
        orders,
        begun,
        tell,
    };
    let finished = sieben_farm::run(&orders.server, &Options::default(), &announced, &mut farmed, alive);
    if let Some(failure) = farmed.failed.take() {
        return Err(failure);
    }
    let finished = finished.map_err(|error| failed(&error))?;
    let ended = farmed.ended.get().unwrap_or(Ended::Whole);
    collector.count_duplicates(finished.duplicates);
    Ok((ended, finished))
}

/// How many scenarios take about a second, by the first one.
fn fitting(campaign: &Campaign, number: u64) -> u64 {
    let begun = Instant::now();
    if campaign.run(number, Way::Chosen, &|| begun.elapsed() < LOOK).is_err() {
        return 1;
    }
    // Conversions of floats saturate.
    ((RANGE.as_secs_f64() / begun.elapsed().as_secs_f64().max(1e-9)) as u64).clamp(1, RANGE_MAX)
}

/// What the queue is told.
struct Farmed<'a, 'c> {
    columns: Columns,
    campaign: &'a Campaign,
    /// Where failures are counted.
    in_order: Option<InOrder>,
    collector: &'a mut Collector<'c>,
    /// What was missing at the beginning.
    missing: Vec<Range<u64>>,
    /// What came, and what was there before.
    there: Ranges,
    /// What was not sent, the last first.
    unsent: Vec<Range<u64>>,
    size: u64,
    /// The end of each range that is there, with what tells its bytes, by its first number.
    known: BTreeMap<u64, (u64, String)>,
    failed: Option<Failure>,
    ended: Cell<Option<Ended>>,
    orders: &'a Orders<'a>,
    begun: Instant,
    tell: &'a mut dyn FnMut(&Collected),
}

impl Ledger for Farmed<'_, '_> {
    fn next(&mut self) -> Option<Range<u64>> {
        let gap = self.unsent.last_mut()?;
        let end = gap.start.saturating_add(self.size).min(gap.end);
        let range = gap.start..end;
        gap.start = end;
        if gap.is_empty() {
            self.unsent.pop();
        }
        Some(range)
    }

    fn missing(&mut self) -> Vec<Range<u64>> {
        let there = &self.there;
        let mut all = Vec::new();
        for gap in self.missing.iter().flat_map(|range| there.missing(range.clone())) {
            let mut start = gap.start;
            while start < gap.end {
                let end = (start + self.size).min(gap.end);
                // What was not sent is no answer to wait for.
                if !self.unsent.iter().any(|unsent| unsent.start < end && start < unsent.end) {
                    all.push(start..end);
                }
                start = end;
            }
        }
        all
    }

    fn came(&mut self, range: Range<u64>, result: &[u8]) -> Came {
        let Ok(part) = decode(result, &self.columns, self.collector.keep()) else { return Came::Unreadable };
        let is_asked_for = self.missing.iter().any(|missing| missing.start <= range.start && range.end <= missing.end);
        if part.range != range || (!is_asked_for && !self.known.contains_key(&range.start)) {
            return Came::Unreadable;
        }
        let tells = digest(result);
        if self.there.overlaps(&range) {
            let same = self.known.get(&range.start).filter(|(end, _)| *end == range.end);
            // Of a range that was cut in another way the scenarios that are not there are sent again.
            return if same.is_none_or(|(_, known)| *known == tells) { Came::Same } else { Came::Other };
        }
        let taken = match &mut self.in_order {
            None => self.collector.take(&part, Some(result)).map(|()| false),
            Some(in_order) => {
                in_order.add(part, result.to_vec());
                in_order.take(self.campaign, self.collector)
            }
        };
        match taken {
            Ok(true) => self.ended.set(Some(Ended::Failures)),
            Ok(false) => {}
            Err(failure) => {
                self.failed = Some(failure);
                return Came::Unreadable;
            }
        }
        self.there.insert(range.clone());
        self.known.insert(range.start, (range.end, tells));
        (self.tell)(self.collector.collected());
        Came::New
    }

    fn is_whole(&self) -> bool {
        self.missing.iter().all(|range| self.there.missing(range.clone()).next().is_none())
    }

    fn is_over(&self) -> bool {
        if self.ended.get() == Some(Ended::Failures) {
            return true;
        }
        let ended = match () {
            () if self.orders.cancelled.load(Ordering::Relaxed) => Some(Ended::Cancelled),
            () if self.orders.budget.is_some_and(|budget| self.begun.elapsed() >= budget) => Some(Ended::Budget),
            () => None,
        };
        if ended.is_some() && !self.is_whole() {
            self.ended.set(ended);
        }
        ended.is_some() || self.failed.is_some()
    }
}
