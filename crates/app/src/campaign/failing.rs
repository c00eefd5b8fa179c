//! What failed, made small: the scenario as a file that `sieben test` runs from then on, with what is wrong, why, and a timing diagram.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

#[cfg(feature = "parquet")]
use serde_json::{Value as Json, json};
use sieben_campaign::row::Verdict;
use sieben_campaign::shrinking::Signature;
use sieben_campaign::spec::PropertyKind;
use sieben_sim::timing_diagram::{self, Options};
use sieben_workspace::campaign::{Campaign, Smaller};

use super::collected::Collected;
use super::said;
use crate::failure::Failure;
use crate::files;
use crate::paths::FAILURES;

/// Real time after which a scenario is as small as it gets.
pub(crate) const TIME: Duration = Duration::from_secs(10);
/// Width of a diagram in characters: that of a terminal without what stands before it.
const WIDTH: usize = 72;

/// A scenario that failed, made small.
pub(crate) struct Small {
    /// Its number in the campaign.
    pub(crate) number: u64,
    /// It, and how it breaks.
    pub(crate) smaller: Smaller,
}

impl Small {
    /// Of a number; `is_over` ends it before its time.
    ///
    /// # Errors
    /// It does not fail, or cannot be made smaller; the message says so.
    pub(crate) fn of(campaign: &Campaign, number: u64, is_over: &dyn Fn() -> bool) -> Result<Self, String> {
        let begun = Instant::now();
        let smaller = campaign.shrink(number, &|| begun.elapsed() >= TIME || is_over())?;
        Ok(Self { number, smaller })
    }

    /// What is wrong and why, for people; without the diagram.
    pub(crate) fn reasons(&self) -> String {
        let found = &self.smaller.found;
        let mut text = format!("{}\n", found.message);
        text.extend(found.reasons.iter().map(|reason| format!("  {reason}\n")));
        text
    }

    /// The timing diagram as text.
    pub(crate) fn diagram(&self) -> String {
        let Some((trace, mark)) = &self.smaller.found.diagram else { return String::new() };
        if trace.summary().scans < 2 {
            return String::new();
        }
        let options = Options { width: WIDTH, marks: vec![mark.clone()], ..Options::text() };
        timing_diagram::text(trace, &options).unwrap_or_default()
    }

    /// The timing diagram as a picture.
    #[cfg(feature = "parquet")]
    fn svg(&self) -> String {
        let Some((trace, mark)) = &self.smaller.found.diagram else { return String::new() };
        let options = Options { marks: vec![mark.clone()], ..Options::svg() };
        timing_diagram::svg(trace, &options).unwrap_or_default()
    }

    /// The file: the scenario, after what is to be said of it.
    pub(crate) fn file(&self, name: &str, seed: u64) -> String {
        let mut text = format!("// Scenario {} of the campaign `{name}`, seed {seed}, made small.\n", self.number);
        for line in self.reasons().lines().chain(self.diagram().lines()) {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{}", format!("// {line}").trim_end());
        }
        let _ = write!(text, "{}", self.smaller.scenario);
        text
    }

    /// For the file beside a result.
    #[cfg(feature = "parquet")]
    pub(crate) fn json(&self, path: Option<&Path>) -> Json {
        json!({
            "scenario": self.number,
            "what": self.signature().what,
            "place": self.signature().place,
            "reasons": self.reasons(),
            "diagram": self.diagram(),
            "svg": self.svg(),
            "file": path.map(|path| path.display().to_string()),
        })
    }

    fn signature(&self) -> &Signature {
        &self.smaller.found.broken.signature
    }

    /// What its file is called.
    fn stem(&self) -> String {
        format!("{}-{}", said::plain(&self.signature().what), self.number)
    }
}

/// Makes what failed small, one for each way to fail: the first of each property, and the first that did not pass.
pub(crate) fn all(campaign: &Campaign, collected: &Collected, is_over: &dyn Fn() -> bool) -> Vec<Small> {
    let broken = campaign.spec.properties.iter().zip(&collected.tally.properties);
    let of_one_run = broken.filter(|(property, tally)| property.kind != PropertyKind::Sometimes && tally.broken > 0);
    let first = collected.first.iter().filter(|row| row.verdict != Verdict::Error).map(|row| row.scenario);
    let mut numbers: Vec<u64> = of_one_run.filter_map(|(_, tally)| tally.first).chain(first).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let mut all: Vec<Small> = Vec::new();
    for number in numbers {
        // What differs between programs is in the result, and in no scenario of one program.
        if let Ok(small) = Small::of(campaign, number, is_over)
            && all.iter().all(|known| known.signature() != small.signature())
        {
            all.push(small);
        }
    }
    all
}

/// Writes the files of what failed into the folder `failures` beside the campaign.
///
/// # Errors
/// One cannot be written.
pub(crate) fn write(all: &[Small], folder: &Path, name: &str, seed: u64) -> Result<Vec<PathBuf>, Failure> {
    let failures = folder.join(FAILURES);
    let mut paths = Vec::new();
    for small in all {
        std::fs::create_dir_all(&failures).map_err(|error| files::unwritable(&failures, &error))?;
        let path = failures.join(format!("{}.scenario", small.stem()));
        files::write_whole(&path, small.file(name, seed).as_bytes())?;
        paths.push(path);
    }
    Ok(paths)
}
