//! `sieben campaign show`: one scenario of a campaign as a file.

use clap::Args;
use sieben_model::problems::Problem;

use super::opened::OneScenario;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::{files, output};

/// Print one scenario of a campaign.
#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    one: OneScenario,
}

/// Prints it.
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let OneScenario { number, output, .. } = &arguments.one;
    let opened = match arguments.one.open(EngineArgument::Interpreter)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    let campaign = &opened.campaign;
    let scenario = campaign.scenario(*number).map_err(|message| Failure::usage(Problem::P7162, message))?;
    let text = format!("// Scenario {} of the campaign `{}`, seed {}.\n{scenario}", *number, opened.name, campaign.spec.seed);
    match output {
        Some(path) => files::write_whole(path, text.as_bytes())?,
        None => output::print_data(&text)?,
    }
    Ok(Exit::Success)
}
