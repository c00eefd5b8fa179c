//! The verbs, one file each.

pub(crate) mod assignments;
pub(crate) mod bench;
pub(crate) mod campaign;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod convert;
pub(crate) mod demo;
pub(crate) mod exec;
pub(crate) mod explain;
pub(crate) mod fleet;
pub(crate) mod fmt;
pub(crate) mod lsp;
pub(crate) mod new;
pub(crate) mod record;
pub(crate) mod refs;
pub(crate) mod render;
pub(crate) mod run;
pub(crate) mod serve;
pub(crate) mod step;
pub(crate) mod structure;
pub(crate) mod symbols;
pub(crate) mod tags;
pub(crate) mod test;
pub(crate) mod top;
pub(crate) mod trace;
pub(crate) mod worker;

mod spec_file;

use sieben_workspace::finding;
use sieben_workspace::project::Build;

use std::path::PathBuf;

use crate::arguments::{ProgramArguments, ReportArguments};
use crate::failure::{Exit, Failure};
use crate::report;

/// The build if it may run; else its diagnostics are printed and the exit code is that of a program that does not compile.
fn or_report(build: Build, json: bool) -> Result<Build, Exit> {
    if !build.findings.is_empty() {
        report::print(&build.findings, &build.project.texts, json);
    }
    if finding::has_errors(&build.findings) { Err(Exit::DoesNotCompile) } else { Ok(build) }
}

/// The program of a verb that only reports on it: warnings are no matter of its, `check` tells them.
fn build_for_report(paths: &[PathBuf], program: &ProgramArguments, report: &ReportArguments) -> Result<Result<Build, Exit>, Failure> {
    let build = program.load(paths)?.compile(program.overrides()?, false);
    Ok(if finding::has_errors(&build.findings) { or_report(build, report.json()) } else { Ok(build) })
}
