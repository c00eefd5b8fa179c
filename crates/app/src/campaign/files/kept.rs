//! What a run keeps: from a result, a ledger, or nothing to a result.

use std::ops::Range;
use std::path::{Path, PathBuf};

use serde_json::Value as Json;
use sieben_campaign::part::{self, Part};
use sieben_campaign::ranges::Ranges;
use sieben_campaign::row::Verdict;
use sieben_model::problems::Problem;
use sieben_workspace::campaign::Campaign;

use super::columns::Columns;
use super::head::Head;
use super::ledger::{self, Ledger};
use super::result_file::ResultFile;
use crate::campaign::collected::{Collected, Store};
use crate::campaign::summary;
use crate::failure::Failure;
use crate::files;

/// What is asked for.
pub(crate) struct Wanted<'a> {
    /// Where the result goes.
    pub(crate) result: &'a Path,
    /// Whether what an earlier run left is to be used.
    pub(crate) resume: bool,
    /// The scenarios.
    pub(crate) numbers: Range<u64>,
    /// Whether the run ends after some failures.
    pub(crate) counts_failures: bool,
}

/// A run that keeps what comes of it.
pub(crate) struct Kept {
    result: PathBuf,
    ledger: Ledger,
}

/// How a run begins.
pub(crate) enum Start {
    /// With what an earlier run left, if it did.
    Run(Box<Kept>, Vec<Part>),
    /// There is nothing left to do.
    Whole(Box<Collected>),
}

impl Kept {
    /// Begins a run, or goes on with one.
    ///
    /// # Errors
    /// What is there is of something else, is not to be used, or cannot be read or written.
    pub(crate) fn open(wanted: &Wanted<'_>, campaign: &Campaign) -> Result<Start, Failure> {
        let head = Head::of(campaign);
        if wanted.result.is_dir() {
            let told = format!("`{}` is a folder, so no file can be written there", wanted.result.display());
            return Err(Failure::usage(Problem::P6013, told));
        }
        if wanted.resume && wanted.result.exists() && !ledger::folder_of(wanted.result).exists() {
            return whole(wanted, campaign, &head).map(|collected| Start::Whole(Box::new(collected)));
        }
        let columns = Columns::of(campaign);
        let (ledger, left) = Ledger::open(wanted.result, &head, columns, &wanted.numbers, wanted.resume, wanted.counts_failures)?;
        Ok(Start::Run(Box::new(Self { result: wanted.result.to_path_buf(), ledger }), left))
    }

    /// What tells the bytes of each range that is there.
    pub(crate) fn digests(&self) -> Vec<(Range<u64>, String)> {
        self.ledger.digests()
    }

    /// Where what comes of ranges is kept.
    pub(crate) fn store(&mut self) -> &mut dyn Store {
        &mut self.ledger
    }

    /// Writes the result, and beside it what does not belong to it: how it was run. The ledger is removed.
    ///
    /// # Errors
    /// A file cannot be written; the ledger stays.
    pub(crate) fn finish(self, campaign: &Campaign, name: &str, spec: &str, collected: &Collected, run: &Json) -> Result<(), Failure> {
        let keep = part::keep(&campaign.spec, campaign.scenarios());
        let summary = summary::of(campaign, name, keep, &collected.tally, &collected.there);
        self.ledger.finish(&self.result, spec, collected, &summary)?;
        files::write_whole(&beside(&self.result), format!("{run:#}\n").as_bytes())
    }
}

/// Where it stands how a result was run.
pub(crate) fn beside(result: &Path) -> PathBuf {
    let mut name = result.file_name().unwrap_or_default().to_owned();
    name.push(".run.json");
    result.with_file_name(name)
}

/// A result that is there already.
fn whole(wanted: &Wanted<'_>, campaign: &Campaign, head: &Head) -> Result<Collected, Failure> {
    let file = ResultFile::open(wanted.result)?;
    let shown = wanted.result.display();
    let refused = |told: String| {
        Failure::usage(Problem::P7176, told).help(format!("to begin again, leave `--resume` out: `{shown}` is replaced then"))
    };
    if let Some(differs) = head.differs_from(&file.head) {
        return Err(refused(format!("`{shown}` is of another campaign; what changed: {differs}")));
    }
    let mut there = Ranges::default();
    there.insert(wanted.numbers.clone());
    if file.there() != there {
        return Err(refused(format!("`{shown}` has other scenarios than those that are asked for")));
    }
    let mut first = None;
    for rows in file.rows()? {
        if let Some(mut row) = rows?.into_iter().find(|row| row.verdict != Verdict::Pass) {
            // The bits of the number are columns of the file, and no parameters of the scenario.
            row.parameters.drain(..campaign.bits().count().min(row.parameters.len()));
            first = Some(row);
            break;
        }
    }
    Ok(Collected { resumed: file.tally.run(), tally: file.tally, first, there, duplicates: 0 })
}
