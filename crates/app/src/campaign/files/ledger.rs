//! The ledger of a run: a folder beside the result with a file for each range that is done, so that nothing is lost with the process.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs::{self, File, TryLockError};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use sieben_campaign::part::Part;
use sieben_campaign::ranges::Ranges;
use sieben_campaign::row::Verdict;
use sieben_model::problems::Problem;

use super::columns::Columns;
use super::head::Head;
use super::part_file;
use super::result_file::Writer;
use crate::campaign::collected::{Collected, Encode, Store};
use crate::failure::Failure;
use crate::{files, output};

/// What the ledger is of.
const HEAD: &str = "head.json";
/// The file whose lock says that a run writes the ledger.
const LOCK: &str = "lock";
/// How the files of ranges end.
const ENDING: &str = "arrow";

/// The ledger of a run.
pub(crate) struct Ledger {
    folder: PathBuf,
    head: Head,
    columns: Arc<Columns>,
    /// The files of ranges, by their first number.
    parts: BTreeMap<u64, PathBuf>,
    /// Held as long as the run lasts.
    _lock: File,
}

/// Where the ledger of a result is.
pub(crate) fn folder_of(result: &Path) -> PathBuf {
    let mut name = result.file_name().unwrap_or_default().to_owned();
    name.push(".part");
    result.with_file_name(name)
}

impl Ledger {
    /// Opens the ledger of a result, with what an earlier run left in it: of these scenarios, whole, and each once. Where failures are
    /// counted, what is left has to end with them.
    ///
    /// # Errors
    /// It is there although none is to be resumed, it is of something else, another run writes it, or it cannot be written.
    pub(crate) fn open(
        result: &Path,
        head: &Head,
        columns: Columns,
        numbers: &Range<u64>,
        resume: bool,
        counts_failures: bool,
    ) -> Result<(Self, Vec<Part>), Failure> {
        let folder = folder_of(result);
        let shown = folder.display();
        if folder.exists() && !resume {
            let told = Failure::usage(Problem::P7175, format!("`{shown}` is what a run left that did not end"));
            return Err(told.help(format!("go on with it by `--resume`, or remove `{shown}`")));
        }
        fs::create_dir_all(&folder).map_err(|error| files::unwritable(&folder, &error))?;
        let lock = File::create(folder.join(LOCK)).map_err(|error| files::unwritable(&folder, &error))?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                let told = Failure::usage(Problem::P7177, format!("another run is writing `{shown}`"));
                return Err(told.help("wait until it has ended, or give this one another `--out`"));
            }
            Err(TryLockError::Error(error)) => return Err(files::unwritable(&folder, &error)),
        }
        let path = folder.join(HEAD);
        // A head that was not written whole has no ranges yet.
        let before = fs::read(&path).ok().and_then(|bytes| Head::from_json(&serde_json::from_slice(&bytes).ok()?));
        if let Some(differs) = before.and_then(|before| head.differs_from(&before)) {
            let told = Failure::usage(Problem::P7176, format!("`{shown}` is of another campaign; what changed: {differs}"));
            return Err(told.help(format!("to begin again, remove `{shown}`, or give another `--out`")));
        }
        files::write_whole(&path, format!("{:#}\n", head.to_json()).as_bytes())?;
        let mut ledger = Self { folder, head: head.clone(), columns: Arc::new(columns), parts: BTreeMap::new(), _lock: lock };
        let left = ledger.left(numbers, counts_failures)?;
        Ok((ledger, left))
    }

    /// What is there and whole. What is torn is removed; it runs again.
    fn left(&mut self, numbers: &Range<u64>, counts_failures: bool) -> Result<Vec<Part>, Failure> {
        let unreadable = |error| files::unreadable(&self.folder, &error);
        let entries = fs::read_dir(&self.folder).map_err(unreadable)?;
        let mut names: Vec<PathBuf> = entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<_, _>>().map_err(unreadable)?;
        names.sort();
        let mut left = Vec::new();
        let mut there = Ranges::default();
        let mut torn = 0;
        for path in names {
            if path.extension() != Some(OsStr::new(ENDING)) {
                // What was being written when the process ended.
                if path.extension() == Some(OsStr::new("tmp")) {
                    let _ = fs::remove_file(&path);
                }
                continue;
            }
            let Some(mut part) = self.read(&path) else {
                torn += 1;
                let _ = fs::remove_file(&path);
                continue;
            };
            let is_asked_for = numbers.start <= part.range.start && part.range.end <= numbers.end;
            if !is_asked_for || there.overlaps(&part.range) || (counts_failures && !ends_with_its_failure(&part)) {
                if !is_asked_for {
                    let told = format!("`{}` has scenarios that are not asked for here", self.folder.display());
                    return Err(Failure::usage(Problem::P7176, told).help("give the same `--only` as before, or another `--out`"));
                }
                let _ = fs::remove_file(&path);
                continue;
            }
            there.insert(part.range.clone());
            self.parts.insert(part.range.start, path);
            let first = part.rows.iter().position(|row| row.verdict != Verdict::Pass);
            part.rows = first.map(|first| part.rows.swap_remove(first)).into_iter().collect();
            left.push(part);
        }
        if torn > 0 {
            output::message(&format!("{torn} of the files in `{}` were not whole: their scenarios run again\n", self.folder.display()));
        }
        Ok(left)
    }

    /// What tells the bytes of each range that is there.
    pub(super) fn digests(&self) -> Vec<(Range<u64>, String)> {
        let of = |path: &PathBuf| {
            let mut parts = path.file_stem()?.to_str()?.split('-');
            let (from, last) = (parts.next()?.parse().ok()?, parts.next()?.parse::<u64>().ok()?);
            Some((from..last + 1, parts.next()?.to_owned()))
        };
        self.parts.values().filter_map(of).collect()
    }

    /// A file of a range, if it is whole.
    fn read(&self, path: &Path) -> Option<Part> {
        let name = path.file_stem()?.to_str()?;
        let bytes = fs::read(path).ok()?;
        let part = part_file::decode(&bytes, &self.columns, self.head.keep).ok()?;
        (name == stem(&part, &bytes)).then_some(part)
    }

    /// Writes the result, and removes the ledger.
    ///
    /// # Errors
    /// A file cannot be read or written; the ledger stays.
    pub(crate) fn finish(self, result: &Path, spec: &str, collected: &Collected, summary: &serde_json::Value) -> Result<(), Failure> {
        let parts = self.parts.range(..).filter(|(start, _)| collected.there.overlaps(&(**start..**start + 1)));
        Writer::write(result, &self.columns, &self.head, spec, summary, &mut |rows| {
            for path in parts.clone().map(|(_, path)| path) {
                let part = self.read(path).ok_or_else(|| {
                    let told = format!("`{}` is not what was written there", path.display());
                    Failure::usage(Problem::P7178, told).help("something else changes the files; run again with `--resume`")
                })?;
                for row in part.rows {
                    rows.push(row)?;
                }
            }
            Ok(())
        })?;
        fs::remove_dir_all(&self.folder).map_err(|error| files::unwritable(&self.folder, &error))
    }
}

/// Whether no scenario but the last one failed.
fn ends_with_its_failure(part: &Part) -> bool {
    let failures = part.tally.failures();
    failures == 0 || (failures == 1 && part.first().is_some_and(|row| row.scenario + 1 == part.range.end))
}

/// What the file of a part is called: its numbers, and what tells whether it is whole.
fn stem(part: &Part, bytes: &[u8]) -> String {
    format!("{:019}-{:019}-{}", part.range.start, part.range.end - 1, part_file::digest(bytes))
}

impl Store for Ledger {
    fn encode(&self) -> Encode {
        let columns = Arc::clone(&self.columns);
        Arc::new(move |part| part_file::encode(part, &columns))
    }

    fn keep(&mut self, part: &Part, bytes: &[u8]) -> Result<(), Failure> {
        let path = self.folder.join(format!("{}.{ENDING}", stem(part, bytes)));
        files::write_whole(&path, bytes)?;
        self.parts.insert(part.range.start, path);
        Ok(())
    }
}
