//! The scenarios of a range, one after another, wherever the range comes from.

use std::ops::Range;
use std::time::{Duration, Instant};

use sieben_campaign::part::Part;
use sieben_campaign::row::Verdict;
use sieben_campaign::spec::Keep;
use sieben_workspace::campaign::{Campaign, Way};

/// How a range is run.
pub(super) struct How {
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
        let row = campaign.run(number, Way::Chosen, &|| !is_over()).ok()?;
        let failed = row.verdict != Verdict::Pass;
        part.add(row, how.keep);
        if failed && how.ends_with_failure {
            break;
        }
    }
    Some(part)
}

/// Real time in which scenarios of a range are run a second time.
const CHECKED_FOR: Duration = Duration::from_secs(1);

/// The first scenario of a part that comes to something else in the interpreter, of those that it runs in a second.
pub(super) fn differs(campaign: &Campaign, part: &Part, is_over: &dyn Fn() -> bool) -> Option<u64> {
    let end = Instant::now() + CHECKED_FOR;
    for number in part.range.clone() {
        let interpreted = campaign.run(number, Way::Interpreted, &|| !is_over() && Instant::now() < end).ok()?;
        let kept = part.rows.iter().find(|row| row.scenario == number);
        let is_same = match kept {
            Some(row) => *row == interpreted,
            None => campaign.run(number, Way::Chosen, &|| !is_over()).ok()? == interpreted,
        };
        if !is_same {
            return Some(number);
        }
        if Instant::now() >= end {
            break;
        }
    }
    None
}
