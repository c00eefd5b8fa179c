//! `sieben lsp`: the language server.

use clap::Args;

use crate::failure::{Exit, Failure};
use crate::lsp;

/// Serve an editor: what is wrong, what a word means, where it is used.
#[derive(Args)]
#[command(after_help = "An editor starts it and speaks with it over standard input and output (Language Server Protocol).\n\
docs/how-to/editors.md says how to set up Neovim, Emacs and Helix; for VS Code there is an extension.\n\n\
Exit codes: 0 the editor has ended it, 1 the editor is gone, 2 usage.")]
pub(crate) struct Arguments {
    /// Speak over standard input and output, which is what it always does: some editors say so
    #[arg(long)]
    stdio: bool,
}

/// Serves.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    // The only way there is.
    let Arguments { stdio: _ } = arguments;
    lsp::run()
}
