//! The file of a campaign and its programs, read and compiled for a command.

use std::ops::Range;
use std::path::{Path, PathBuf};

use clap::Args;
use sieben_campaign::parse::parse;
use sieben_jit::StatusBits;
use sieben_model::diagnostic::Severity;
use sieben_model::problems::Problem;
use sieben_workspace::campaign::{self, Campaign};

use crate::arguments::ProgramArguments;
use crate::campaign::said;
use crate::commands::spec_file::{Around, SpecFile};
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};

/// Which scenario, and where what is made of it goes.
#[derive(Args)]
pub(super) struct OneScenario {
    /// The file of the campaign
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// The number of the scenario, from 0
    #[arg(value_name = "N")]
    pub(super) number: u64,
    #[command(flatten)]
    program: ProgramArguments,
    /// Another seed than that of the file
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

impl OneScenario {
    /// The campaign, which has that scenario; otherwise its findings are printed.
    pub(super) fn open(&self, engine: EngineArgument) -> Result<Result<Opened, Exit>, Failure> {
        let opened = open(&self.spec, &self.program, self.seed, engine, false)?;
        if let Ok(opened) = &opened {
            wanted(&opened.campaign, Some((self.number, self.number)))?;
        }
        Ok(opened)
    }
}

/// A campaign that was read, with what it is called.
pub(super) struct Opened {
    pub(super) campaign: Campaign,
    /// What it is called.
    pub(super) name: String,
    /// The folder that its paths count from.
    pub(super) folder: PathBuf,
    /// Its file.
    #[cfg_attr(not(feature = "parquet"), expect(dead_code))]
    pub(super) text: String,
}

/// Reads a campaign and compiles its programs; otherwise its findings are printed.
pub(super) fn open(
    path: &Path,
    program: &ProgramArguments,
    seed: Option<u64>,
    engine: EngineArgument,
    json: bool,
) -> Result<Result<Opened, Exit>, Failure> {
    let read = SpecFile::read(path, Problem::P7156, json)?;
    let (spec, mut diagnostics) = parse(read.text(), read.file());
    let has_errors = diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error);
    let Some(mut spec) = spec.filter(|_| !has_errors) else {
        read.tell(diagnostics);
        return Ok(Err(Exit::DoesNotCompile));
    };
    spec.seed = seed.unwrap_or(spec.seed);
    let name = spec.name.clone().unwrap_or_else(|| read.stem());
    let around = Around::of(path, program);
    let factory = engine.settled().factory(StatusBits::Needed);
    match campaign::open(spec, read.text(), &around, program.overrides()?, &factory) {
        Ok(campaign) => {
            diagnostics.extend(campaign.warnings.iter().cloned());
            read.tell(diagnostics);
            Ok(Ok(Opened { campaign, name, folder: around.folder, text: read.text().to_owned() }))
        }
        Err(failed) => read.tell_failed(diagnostics, failed).map(Err),
    }
}

/// The numbers that are asked for.
pub(super) fn wanted(campaign: &Campaign, only: Option<(u64, u64)>) -> Result<Range<u64>, Failure> {
    let all = campaign.scenarios();
    match only {
        None => Ok(0..all),
        Some((from, to)) if to < all => Ok(from..to + 1),
        Some((from, to)) => {
            let which = if from == to { format!("there is no scenario {from}") } else { format!("`--only {from}..{to}`") };
            let message = format!("{which}: the campaign has {}, 0 to {}", said::scenarios(all), all.saturating_sub(1));
            Err(Failure::usage(Problem::P7001, message))
        }
    }
}
