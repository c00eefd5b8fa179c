//! `sieben campaign shrink`: a scenario that fails, made as small as it fails in the same way.

use std::sync::atomic::Ordering;

use clap::Args;
use sieben_model::problems::Problem;

use super::opened::OneScenario;
use crate::campaign::failing::Small;
use crate::campaign::said;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::{files, output, terminal};

/// Make a scenario that fails as small as it fails in the same way.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben campaign shrink oven.toml 17                  print the small scenario\n  \
  sieben campaign shrink oven.toml 17 -o f.scenario    a file for `sieben test`, `trace` and `step`\n\n\
It breaks the same property, and the same statement wrote what the property says last. Faults\n\
go first, then events, then parameters; then times get shorter and numbers rounder.\n\n\
Exit codes: 0 ok, 2 usage, or the scenario does not fail, 3 does not compile.")]
pub(super) struct Arguments {
    #[command(flatten)]
    one: OneScenario,
}

/// Makes it smaller.
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let OneScenario { number, output, .. } = &arguments.one;
    let opened = match arguments.one.open(EngineArgument::Auto)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    let cancelled = terminal::interrupted();
    let small = Small::of(&opened.campaign, *number, &|| cancelled.load(Ordering::Relaxed))
        .map_err(|message| Failure::usage(Problem::P7162, message).help("`sieben campaign run` names scenarios that fail"))?;
    let file = small.file(&opened.name, opened.campaign.spec.seed);
    match output {
        Some(path) => {
            files::write_whole(path, file.as_bytes())?;
            output::message(&format!("{}{}", small.reasons(), small.diagram()));
        }
        None => output::print_data(&file)?,
    }
    output::message(&format!("{} tried\n", said::several(small.smaller.runs.into(), "scenario")));
    Ok(Exit::Success)
}
