//! `sieben campaign show`: one scenario of a campaign as a file.

use std::path::PathBuf;

use clap::Args;
use sieben_model::problems::Problem;

use super::opened::{open, wanted};
use crate::arguments::ProgramArguments;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::{files, output};

/// Print one scenario of a campaign.
#[derive(Args)]
pub(super) struct Arguments {
    /// The file of the campaign
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// The number of the scenario, from 0
    #[arg(value_name = "N")]
    number: u64,
    #[command(flatten)]
    program: ProgramArguments,
    /// Another seed than that of the file
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Prints it.
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let opened = match open(&arguments.spec, &arguments.program, arguments.seed, EngineArgument::Interpreter, false)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    let campaign = &opened.campaign;
    wanted(campaign, Some((arguments.number, arguments.number)))?;
    let scenario = campaign.scenario(arguments.number).map_err(|message| Failure::usage(Problem::P7162, message))?;
    let text = format!("// Scenario {} of the campaign `{}`, seed {}.\n{scenario}", arguments.number, opened.name, campaign.spec.seed);
    match &arguments.output {
        Some(path) => files::write_whole(path, text.as_bytes())?,
        None => output::print_data(&text)?,
    }
    Ok(Exit::Success)
}
