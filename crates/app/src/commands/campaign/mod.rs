//! `sieben campaign …`: very many scenarios of a program, each from its number.

mod list;
mod merge;
mod opened;
mod progress;
mod report;
mod run;
mod show;
mod shrink;

use clap::{Args, Subcommand};

use crate::failure::{Exit, Failure};

/// Run a program through very many scenarios: every combination of its inputs, drawn values, faults.
#[derive(Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Print how many scenarios a campaign has, and the columns of its result; nothing runs
    List(list::Arguments),
    /// Run the scenarios of a campaign
    Run(run::Arguments),
    /// Print one scenario of a campaign as a *.scenario file
    Show(show::Arguments),
    /// Make a scenario that fails as small as it fails in the same way
    Shrink(shrink::Arguments),
    /// Say what a result came to
    Report(report::Arguments),
    /// Make one result of the results of parts of a campaign
    Merge(merge::Arguments),
}

/// Does what is asked for.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    match &arguments.verb {
        Verb::List(arguments) => list::run(arguments),
        Verb::Run(arguments) => run::run(arguments),
        Verb::Show(arguments) => show::run(arguments),
        Verb::Shrink(arguments) => shrink::run(arguments),
        Verb::Report(arguments) => report::run(arguments),
        Verb::Merge(arguments) => merge::run(arguments),
    }
}

/// What is said where results cannot be kept.
#[cfg(not(feature = "parquet"))]
fn without_files() -> Failure {
    let told = "this build of Sieben was made without the feature `parquet`, which results of campaigns need";
    Failure::usage(sieben_model::problems::Problem::P7178, told).help("leave `--out` out, or build with the default features")
}
