//! The scenarios of a range, one after another, wherever the range comes from.

use std::ops::Range;

use sieben_campaign::part::Part;
use sieben_campaign::row::Verdict;
use sieben_campaign::spec::Keep;
use sieben_workspace::campaign::{Campaign, Way};

/// How a range is run.
pub(super) struct How {
    /// In which engine.
    pub(super) way: Way,
    /// Which rows are kept.
    pub(super) keep: Keep,
    /// The process aborts when it begins this scenario, as if it were killed: for tests.
    pub(super) abort: Option<u64>,
    /// Whether the part ends with the first scenario that does not pass.
    pub(super) ends_with_failure: bool,
}

/// Runs them; nothing if it was over before.
pub(super) fn run(campaign: &Campaign, range: Range<u64>, how: &How, is_over: &dyn Fn() -> bool) -> Option<Part> {
    let mut part = Part::new(&campaign.spec, range.start);
    for number in range {
        if is_over() {
            return None;
        }
        if how.abort == Some(number) {
            std::process::abort();
        }
        let row = campaign.run(number, how.way, &|| !is_over()).ok()?;
        let failed = row.verdict != Verdict::Pass;
        part.add(row, how.keep);
        if failed && how.ends_with_failure {
            break;
        }
    }
    Some(part)
}
