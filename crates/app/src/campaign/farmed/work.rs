//! What a worker does with a campaign: ranges in, bytes out.

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use sieben_campaign::packed::Packed;
use sieben_campaign::parse::parse;
use sieben_campaign::part::{self, Part};
use sieben_campaign::spec::Keep;
use sieben_farm::{Offer, Work};
use sieben_jit::StatusBits;
use sieben_model::source::FileId;
use sieben_workspace::campaign::{self, Campaign, Failed};
use sieben_workspace::project::Overrides;

use super::unpacked::Unpacked;
use crate::campaign::files::{Columns, encode};
use crate::campaign::parts;
use crate::campaign::threads::CHECKED;
use crate::engines::EngineArgument;

/// A campaign that this process works for.
pub(crate) struct Working {
    campaign: Campaign,
    columns: Columns,
    keep: Keep,
    /// Ranges that were begun.
    begun: AtomicU64,
    /// The process aborts when it begins this scenario: for tests.
    abort: Option<u64>,
}

impl Working {
    /// Makes ready what a run offers.
    ///
    /// # Errors
    /// It is not what it says it is, or cannot be used; the message says so.
    pub(crate) fn open(offer: &Offer, engine: EngineArgument, abort: Option<u64>) -> Result<Arc<dyn Work>, String> {
        let packed = Packed::read(&offer.bundle).ok_or("it is no campaign of Sieben")?;
        if packed.identity().campaign != offer.campaign {
            return Err("what it brings along is not what it says it is".to_owned());
        }
        let (spec, diagnostics) = parse(&packed.spec, FileId(0));
        let mut spec = spec.ok_or_else(|| diagnostics.first().map_or_else(String::new, |diagnostic| diagnostic.message.clone()))?;
        spec.seed = packed.seed;
        let files = Unpacked::new(&packed).map_err(|error| format!("it cannot be unpacked: {error}"))?;
        let factory = engine.settled().factory(StatusBits::Needed);
        let campaign = campaign::open(spec, &packed.spec, &files, Overrides::default(), &factory).map_err(|failed| match failed {
            Failed::Spec(wrong) => wrong.first().map_or_else(String::new, |diagnostic| diagnostic.message.clone()),
            Failed::Program(_) => "a program of it does not compile here".to_owned(),
            Failed::Refused(refusal) => refusal.message,
        })?;
        let (columns, keep) = (Columns::of(&campaign), part::keep(&campaign.spec, campaign.scenarios()));
        Ok(Arc::new(Self { campaign, columns, keep, begun: AtomicU64::new(0), abort }))
    }
}

impl Work for Working {
    fn run(&self, range: Range<u64>, is_over: &dyn Fn() -> bool) -> Option<Vec<u8>> {
        let how = parts::How { keep: self.keep, abort: self.abort, ends_with_failure: false };
        let part = parts::run(&self.campaign, range.clone(), &how, is_over)?;
        let is_checked = self.begun.fetch_add(1, Ordering::Relaxed).is_multiple_of(CHECKED);
        if is_checked && parts::differs(&self.campaign, &part, is_over).is_some() {
            let message = "it comes to something else in the interpreter than in machine code; this is our mistake";
            return Some(self.not_run(range, message));
        }
        Some(encode(&part, &self.columns))
    }

    fn given_up(&self, number: u64) -> Vec<u8> {
        self.not_run(number..number + 1, "the workers that ran it ended three times")
    }
}

impl Working {
    fn not_run(&self, range: Range<u64>, message: &str) -> Vec<u8> {
        let mut part = Part::new(&self.campaign.spec, range.start);
        range.for_each(|number| part.add(self.campaign.not_run(number, message.to_owned()), self.keep));
        encode(&part, &self.columns)
    }
}
