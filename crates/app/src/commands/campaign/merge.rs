//! `sieben campaign merge`: one result of the results of parts.

use std::path::PathBuf;

use clap::Args;

use crate::failure::{Exit, Failure};

/// Make one result of the results of parts of a campaign.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben campaign merge r0.parquet r1.parquet -o r.parquet\n\n\
The result has the same bytes as that of one run over all scenarios.\n\n\
Exit codes: 0 all scenarios are there and all held, 1 a property broke, what has to come\n\
sometimes never came, or scenarios are missing, 2 usage or results of different campaigns.")]
pub(super) struct Arguments {
    /// The results of the parts
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// Write the result to this file
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Print the summary as one JSON object
    #[arg(long)]
    json: bool,
}

/// Merges them.
#[cfg(feature = "parquet")]
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    use crate::campaign::{said, summary};
    use crate::output;

    let merged = crate::campaign::files::merge(&arguments.files, &arguments.output)?;
    if arguments.json {
        output::print_json(&merged.summary, false)?;
    } else {
        let all = said::scenarios(merged.there.count());
        output::print(&format!("{}: {all}, {}\n", arguments.output.display(), summary::counts(&merged.summary)))?;
    }
    if let Some(missing) = summary::missing(&merged.there, merged.scenarios) {
        output::message(&missing);
    }
    let holds = summary::holds(&merged.summary, &merged.there, merged.scenarios);
    Ok(if holds { Exit::Success } else { Exit::CheckFailed })
}

/// Merges them.
#[cfg(not(feature = "parquet"))]
pub(super) fn run(_: &Arguments) -> Result<Exit, Failure> {
    Err(super::without_files())
}
