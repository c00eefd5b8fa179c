//! Where failures are counted: what comes back in any order is taken in by its numbers, up to the last failure that is asked for.

use std::collections::BTreeMap;

use sieben_campaign::part::Part;
use sieben_workspace::campaign::Campaign;

use crate::campaign::collected::Collector;
use crate::campaign::parts;
use crate::failure::Failure;

/// Parts that wait for those before them.
pub(super) struct InOrder {
    /// After so many failures it is enough.
    stop_after: u64,
    waiting: BTreeMap<u64, Waiting>,
}

/// A part; one that an earlier run left has no bytes.
struct Waiting {
    part: Part,
    bytes: Option<Vec<u8>>,
}

impl InOrder {
    /// With what an earlier run left.
    pub(super) fn new(stop_after: u64, left: Vec<Part>) -> Self {
        let waiting = left.into_iter().map(|part| (part.range.start, Waiting { part, bytes: None })).collect();
        Self { stop_after, waiting }
    }

    /// A part came.
    pub(super) fn add(&mut self, part: Part, bytes: Vec<u8>) {
        self.waiting.insert(part.range.start, Waiting { part, bytes: Some(bytes) });
    }

    /// Takes in what waits for nothing; whether so many failed as were asked for.
    ///
    /// # Errors
    /// What came cannot be written down.
    pub(super) fn take(&mut self, campaign: &Campaign, collector: &mut Collector<'_>) -> Result<bool, Failure> {
        loop {
            let wanted = self.stop_after.saturating_sub(collector.collected().failures());
            if wanted == 0 {
                return Ok(true);
            }
            let next = collector.first_missing().and_then(|next| self.waiting.remove(&next));
            let Some(Waiting { part, bytes }) = next else { return Ok(false) };
            if part.range.end - part.range.start > 1 && part.tally.failures() >= wanted {
                up_to_failures(campaign, &part, wanted, collector)?;
            } else if let Some(bytes) = bytes {
                collector.take(&part, Some(&bytes))?;
            } else {
                collector.resume(&part);
            }
        }
    }
}

/// Runs the scenarios of a part here once more, up to so many failures: what is after them is none of the result.
fn up_to_failures(campaign: &Campaign, part: &Part, wanted: u64, collector: &mut Collector<'_>) -> Result<(), Failure> {
    let how = parts::How { keep: collector.keep(), abort: None, ends_with_failure: true };
    let encode = collector.encode();
    let mut start = part.range.start;
    for _ in 0..wanted {
        // It ends by itself: these scenarios have ended before.
        let Some(cut) = parts::run(campaign, start..part.range.end, &how, &|| false) else { return Ok(()) };
        start = cut.range.end;
        collector.take(&cut, encode.as_ref().map(|encode| encode(&cut)).as_deref())?;
    }
    Ok(())
}
