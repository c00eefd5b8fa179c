//! What the command line says about retentive data.

use std::path::PathBuf;

use clap::Args;
use sieben_cpu::{Cpu, Restart};
use sieben_workspace::project::Project;

use super::disk::behind_links;
use super::retention::{Choice, SYNC, adopt_only};
use crate::failure::Failure;

/// The options of a verb that runs a CPU.
#[derive(Args)]
pub(crate) struct RetainArguments {
    /// Keep retentive data in this file [default: .sieben/retain.bin of a project folder with a sieben.toml]
    #[arg(long, value_name = "FILE")]
    retain: Option<PathBuf>,
    /// Keep no retentive data, and leave alone what was kept
    #[arg(long, conflicts_with_all = ["retain", "adopt", "reset"])]
    no_retain: bool,
    /// Take over the retentive data in this file, also that of a changed program as far as it fits
    #[arg(long, value_name = "FILE", conflicts_with = "reset")]
    adopt: Option<PathBuf>,
    /// Begin with a memory reset (MRES): retentive data is deleted
    #[arg(long)]
    reset: bool,
    /// How the CPU starts: warm keeps retentive data, cold begins with the initial values
    #[arg(long, value_name = "KIND", default_value = "warm", value_parser = restart_argument)]
    pub(crate) restart: Restart,
}

/// Reads a kind of restart.
pub(crate) fn restart_argument(text: &str) -> Result<Restart, String> {
    match text.to_ascii_lowercase().as_str() {
        "warm" => Ok(Restart::Warm),
        "cold" => Ok(Restart::Cold),
        "hot" => Err("a hot restart goes on where a STOP interrupted the CPU, and a CPU that is switched on was not interrupted; write `warm` or `cold`".to_owned()),
        _ => Err(format!("`{text}` is no kind of restart; write `warm` or `cold`")),
    }
}

/// Whether a run takes place in real time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RunTime {
    /// The run is a plant's.
    Real,
    /// The run is an experiment, and every one of them is the same.
    Virtual,
}

impl RetainArguments {
    /// What becomes of retentive data in a run of the project; nothing is kept of a lone file or of virtual time, unless a file is named.
    pub(crate) fn choice(&self, project: &Project, time: RunTime, json: bool) -> Option<Choice> {
        let of_project = || project.home.as_deref().filter(|_| time == RunTime::Real).map(Choice::project_file);
        // A link that the user names is what the user means; one in a project may be anyone's.
        let file = self.retain.as_deref().map(behind_links).or_else(of_project).filter(|_| !self.no_retain)?;
        Some(Choice {
            file,
            named: self.retain.is_some(),
            sync: project.settings.retain.sync.unwrap_or(SYNC),
            adopt: self.adopt.clone(),
            reset: self.reset,
            json,
        })
    }
    /// Takes over the data that the user names into a run that keeps nothing, such as one in virtual time.
    pub(crate) fn adopt_only(&self, cpu: &mut Cpu, json: bool) -> Result<(), Failure> {
        self.adopt.as_deref().map_or(Ok(()), |source| adopt_only(source, cpu, json))
    }
}
