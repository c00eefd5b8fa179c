//! Results of parts of a campaign, made one.

use std::ops::Range;
use std::path::{Path, PathBuf};

use serde_json::Value as Json;
use sieben_campaign::ranges::Ranges;
use sieben_campaign::row::Row;
use sieben_model::problems::Problem;

use super::result_file::{ResultFile, Writer};
use crate::campaign::summary;
use crate::failure::Failure;

/// What several results came to together.
pub(crate) struct Merged {
    /// Which scenarios there are.
    pub(crate) there: Ranges,
    /// How many the campaign has.
    pub(crate) scenarios: u64,
    /// What they came to, with all names.
    pub(crate) summary: Json,
}

/// Makes one result of several of the same campaign.
///
/// # Errors
/// They are of different campaigns, a scenario is in two of them, or a file cannot be read or written.
pub(crate) fn merge(paths: &[PathBuf], output: &Path) -> Result<Merged, Failure> {
    let all: Vec<ResultFile> = paths.iter().map(|path| ResultFile::open(path)).collect::<Result<_, _>>()?;
    let Some(first) = all.first() else { return Err(Failure::usage(Problem::P7001, "name the results that shall become one")) };
    let mut there = Ranges::default();
    let mut ranges: Vec<(Range<u64>, usize)> = Vec::new();
    let mut tally = first.tally.clone();
    for (index, one) in all.iter().enumerate() {
        let shown = one.path.display();
        if let Some(differs) = first.head.differs_from(&one.head) {
            let told = format!("`{shown}` is of another campaign than `{}`; what differs: {differs}", first.path.display());
            return Err(Failure::usage(Problem::P7176, told).help("merge only results of the same programs, file and seed"));
        }
        for range in one.there().iter() {
            if !there.insert(range.clone()) {
                let told = format!("scenarios {} to {} of `{shown}` are in another of the files, too", range.start, range.end - 1);
                return Err(Failure::usage(Problem::P7176, told).help("leave one of the two out: a scenario counts once"));
            }
            ranges.push((range, index));
        }
        if index > 0 {
            tally.merge(&one.tally);
        }
    }
    ranges.sort_by_key(|(range, _)| range.start);
    let summary = summary::merged(&first.summary, &tally, &there);
    Writer::write(output, &first.columns, &first.head, &first.spec, &summary, &mut |rows| {
        let mut readers = Vec::new();
        for one in &all {
            let flat = one.rows()?.flat_map(|batch| match batch {
                Ok(rows) => rows.into_iter().map(Ok).collect::<Vec<_>>(),
                Err(failure) => vec![Err(failure)],
            });
            readers.push(flat.peekable());
        }
        let is_in = |row: &Result<Row, Failure>, range: &Range<u64>| row.as_ref().map_or(true, |row| row.scenario < range.end);
        for (range, index) in &ranges {
            while let Some(row) = readers[*index].next_if(|row| is_in(row, range)) {
                rows.push(row?)?;
            }
        }
        Ok(())
    })?;
    Ok(Merged { there, scenarios: first.head.scenarios, summary })
}
