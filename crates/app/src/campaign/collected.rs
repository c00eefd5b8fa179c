//! What came of the scenarios so far, from wherever it comes; where there is a ledger it is written down there.

use std::ops::Range;
use std::sync::Arc;

use sieben_campaign::part::{self, Part};
use sieben_campaign::ranges::Ranges;
use sieben_campaign::row::Row;
use sieben_campaign::spec::Keep;
use sieben_campaign::tally::Tally;
use sieben_workspace::campaign::Campaign;

use crate::failure::Failure;

/// Makes bytes of what came of a range, as a ledger keeps them.
pub(crate) type Encode = Arc<dyn Fn(&Part) -> Vec<u8> + Send + Sync>;

/// Where what came of ranges is kept.
pub(crate) trait Store {
    /// What makes bytes of a part.
    fn encode(&self) -> Encode;
    /// Keeps the bytes of a part.
    ///
    /// # Errors
    /// They cannot be written.
    fn keep(&mut self, part: &Part, bytes: &[u8]) -> Result<(), Failure>;
}

/// What all came to.
#[derive(Clone, Debug, Default)]
pub(crate) struct Collected {
    /// Counts and extremes.
    pub(crate) tally: Tally,
    /// The first scenario that did not pass.
    pub(crate) first: Option<Row>,
    /// Which scenarios there are.
    pub(crate) there: Ranges,
    /// How many of them an earlier run left.
    pub(crate) resumed: u64,
    /// Ranges that came twice.
    pub(crate) duplicates: u64,
}

impl Collected {
    /// Scenarios that did not pass.
    pub(crate) fn failures(&self) -> u64 {
        self.tally.failures()
    }

    /// Takes in what came of a range that is not there yet.
    pub(crate) fn add(&mut self, part: &Part) {
        self.there.insert(part.range.clone());
        self.tally.merge(&part.tally);
        if let Some(row) = part.first()
            && self.first.as_ref().is_none_or(|first| row.scenario < first.scenario)
        {
            self.first = Some(row.clone());
        }
    }
}

/// Takes in what came of the scenarios of a run.
pub(crate) struct Collector<'s> {
    numbers: Range<u64>,
    keep: Keep,
    collected: Collected,
    before: Vec<Part>,
    store: Option<&'s mut dyn Store>,
}

impl<'s> Collector<'s> {
    /// Nothing has come of these scenarios, but for what an earlier run left.
    pub(crate) fn new(campaign: &Campaign, numbers: Range<u64>, before: Vec<Part>, store: Option<&'s mut dyn Store>) -> Self {
        let resumed = before.iter().map(|part| part.range.end - part.range.start).sum();
        let collected = Collected { tally: Tally::new(&campaign.spec), resumed, ..Collected::default() };
        Self { keep: part::keep(&campaign.spec, campaign.scenarios()), numbers, collected, before, store }
    }

    /// Which rows are kept.
    pub(crate) fn keep(&self) -> Keep {
        self.keep
    }

    /// What makes bytes of a part, where they are wanted.
    pub(crate) fn encode(&self) -> Option<Encode> {
        self.store.as_ref().map(|store| store.encode())
    }

    /// What an earlier run left, to be taken in when its time has come.
    pub(crate) fn before(&mut self) -> Vec<Part> {
        std::mem::take(&mut self.before)
    }

    /// What there is neither now nor from an earlier run.
    pub(crate) fn missing(&self) -> Vec<Range<u64>> {
        let mut there = self.collected.there.clone();
        for part in &self.before {
            there.insert(part.range.clone());
        }
        there.missing(self.numbers.clone()).collect()
    }

    /// The first scenario that was not taken in yet.
    #[cfg(feature = "nats")]
    pub(crate) fn first_missing(&self) -> Option<u64> {
        self.collected.there.missing(self.numbers.clone()).next().map(|range| range.start)
    }

    /// Takes in what an earlier run left of a range.
    pub(crate) fn resume(&mut self, part: &Part) {
        self.collected.add(part);
    }

    /// Takes in what came of a range, and keeps its bytes.
    ///
    /// # Errors
    /// They cannot be written.
    pub(crate) fn take(&mut self, part: &Part, bytes: Option<&[u8]>) -> Result<(), Failure> {
        if let (Some(store), Some(bytes)) = (&mut self.store, bytes) {
            store.keep(part, bytes)?;
        }
        self.collected.add(part);
        Ok(())
    }

    /// So many ranges came once more.
    #[cfg(feature = "nats")]
    pub(crate) fn count_duplicates(&mut self, count: u64) {
        self.collected.duplicates += count;
    }

    /// What all came to so far.
    pub(crate) fn collected(&self) -> &Collected {
        &self.collected
    }

    /// What all came to.
    pub(crate) fn into_collected(self) -> Collected {
        self.collected
    }
}
