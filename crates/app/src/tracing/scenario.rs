//! Scenarios in files.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use sieben_model::problems::Problem;
use sieben_sim::scenario::Scenario;
use sieben_workspace::Refusal;
use sieben_workspace::finding::{Finding, Texts};
use sieben_workspace::tracing::scenario;

use crate::failure::{Exit, Failure};
use crate::report;
use crate::schedule::ScheduleArguments;
use crate::{files, language, output, paths};

/// Bytes of a scenario at most: a day of a busy plant, and what a computer can hold beside its lines.
const BYTES_MAX: u64 = 1 << 30;

/// A scenario says itself what happens when.
fn takes_no_schedule(schedule: &ScheduleArguments) -> Result<(), Failure> {
    if schedule.is_empty() {
        return Ok(());
    }
    let message = "a scenario says itself what is set and when scans begin, and takes no `--set`, `--at`, `--scans`, `--for`, `--cycle` or `--scan-at`";
    Err(Failure::usage(Problem::P7001, message).help("write it into the scenario, or leave the scenario out"))
}

/// A scenario with its file, if a verb was given one.
pub(crate) type Given<'a> = Option<(&'a PathBuf, Scenario)>;

/// The one scenario that a verb runs; what is wrong in it is printed.
pub(crate) fn only<'a>(paths: &'a [PathBuf], schedule: &ScheduleArguments) -> Result<Result<Given<'a>, Exit>, Failure> {
    match paths {
        [] => Ok(Ok(None)),
        [path] => {
            takes_no_schedule(schedule)?;
            Ok(read_or_report(path)?.map(|scenario| Some((path, scenario))))
        }
        _ => Err(Failure::usage(Problem::P7001, "one scenario at a time can be run")),
    }
}

/// Tells the user that a recording ends before its end.
pub(crate) fn warn_if_cut_off(path: &Path, scenario: &Scenario) {
    if let Some(message) = scenario::cut_off(&paths::shown(path), scenario) {
        report::print(&[Finding::file(Problem::P6263, paths::shown(path), message)], &Texts::default(), false);
    }
}

/// Reads a scenario; what is wrong in it is printed.
fn read_or_report(path: &Path) -> Result<Result<Scenario, Exit>, Failure> {
    match read(path) {
        Ok(scenario) => {
            warn_if_cut_off(path, &scenario);
            Ok(Ok(scenario))
        }
        Err(Unusable::File(failure)) => Err(failure),
        Err(Unusable::Lines(refusals)) => {
            refusals.into_iter().for_each(|refusal| output::styled(&Failure::from(refusal).render(output::colour(), language::spoken())));
            Ok(Err(Exit::Usage))
        }
    }
}

/// Why a scenario is of no use.
pub(crate) enum Unusable {
    /// It cannot be read.
    File(Failure),
    /// Some of its lines are not understood.
    Lines(Vec<Refusal>),
}

/// Reads a scenario.
pub(crate) fn read(path: &Path) -> Result<Scenario, Unusable> {
    let text = text(path).map_err(Unusable::File)?;
    scenario::read(&paths::shown(path), &text).map_err(Unusable::Lines)
}

fn text(path: &Path) -> Result<String, Failure> {
    if path.is_dir() {
        return Err(Failure::usage(Problem::P6006, format!("`{}` is a folder, but a file is wanted here", path.display())));
    }
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(BYTES_MAX + 1).read_to_end(&mut bytes));
    read.map_err(|error| files::unreadable(path, &error))?;
    if bytes.len() as u64 > BYTES_MAX {
        return Err(Failure::usage(Problem::P1104, format!("`{}` is larger than {} MiB", path.display(), BYTES_MAX >> 20)));
    }
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
