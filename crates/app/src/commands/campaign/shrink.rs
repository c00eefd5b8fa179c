//! `sieben campaign shrink`: a scenario that fails, made as small as it fails in the same way.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use sieben_model::problems::Problem;

use super::opened::{open, wanted};
use crate::arguments::ProgramArguments;
use crate::campaign::failing::Small;
use crate::campaign::said;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::{files, output};

/// Make a scenario that fails as small as it fails in the same way.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben campaign shrink oven.toml 17                  print the small scenario\n  \
  sieben campaign shrink oven.toml 17 -o f.scenario    a file for `sieben test`, `trace` and `step`\n\n\
It breaks the same property, and the same statement wrote what the property says last. Faults\n\
go first, then events, then parameters; then times get shorter and numbers rounder.\n\n\
Exit codes: 0 ok, 2 usage, or the scenario does not fail, 3 does not compile.")]
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

/// Makes it smaller.
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let opened = match open(&arguments.spec, &arguments.program, arguments.seed, EngineArgument::Auto, false)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    wanted(&opened.campaign, Some((arguments.number, arguments.number)))?;
    let cancelled = Arc::new(AtomicBool::new(false));
    let cancel = Arc::clone(&cancelled);
    // Without the handler Ctrl+C ends the process; with it, it ends the search, and what was found is there.
    let _ = ctrlc::set_handler(move || cancel.store(true, Ordering::Relaxed));
    let small = Small::of(&opened.campaign, arguments.number, &|| cancelled.load(Ordering::Relaxed))
        .map_err(|message| Failure::usage(Problem::P7162, message).help("`sieben campaign run` names scenarios that fail"))?;
    let file = small.file(&opened.name, opened.campaign.spec.seed);
    match &arguments.output {
        Some(path) => {
            files::write_whole(path, file.as_bytes())?;
            output::message(&format!("{}{}", small.reasons(), small.diagram()));
        }
        None => output::print_data(&file)?,
    }
    output::message(&format!("{} tried\n", said::several(small.smaller.runs.into(), "scenario")));
    Ok(Exit::Success)
}
