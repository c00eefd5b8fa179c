//! `sieben serve [PATH]`: runs a project with its servers, until it is told to end.

use clap::Args;

use super::run::{self, RunArguments, Verb};
use crate::failure::{Exit, Failure};

/// Run a project with its servers, for clients over the network.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben serve pump                               the servers of pump/sieben.toml; without any, S7 at 127.0.0.1:1102\n  \
  sieben serve pump --expose s7=0.0.0.0:1102      other computers reach it too\n  \
  sieben serve pump --json                        says as JSON where it listens, as soon as it does\n\n\
It stays up while the CPU is in STOP, and ends in order at Ctrl-C or SIGTERM: connections are closed, retentive data is kept.\n\
Exit codes: 0 ended, 1 a statement failed (--strict), 2 usage, 3 does not compile; with --for 4 if the CPU went to STOP.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    common: RunArguments,
}

/// Runs the project with its servers.
pub(crate) fn run(arguments: Arguments) -> Result<Exit, Failure> {
    run::run_as(Verb::Serve, arguments.common)
}
