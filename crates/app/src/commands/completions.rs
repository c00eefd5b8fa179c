//! `sieben completions SHELL`: completions for a shell.

use clap::{Args, Command};
use clap_complete::Shell;

use crate::failure::{Exit, Failure};
use crate::output;

/// Print the completions for a shell.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Which shell
    shell: Shell,
}

/// Prints the completions of a command line.
pub(crate) fn run(arguments: &Arguments, line: &mut Command) -> Result<Exit, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, line, "sieben", &mut script);
    output::print_data(&String::from_utf8_lossy(&script))?;
    Ok(Exit::Success)
}
