//! `sieben fmt PATH…`: sources in one layout.

use std::path::PathBuf;

use clap::Args;
use sieben_lang::st::dialect::Dialect;

use crate::arguments::{EncodingArgument, MnemonicsArgument, dialect_argument};
use crate::failure::{Exit, Failure};
use crate::rewriting::{Destination, Rewriting};

/// Bring STL, ST and SCL sources into one layout.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben fmt main.awl           print the formatted source\n  \
  sieben fmt --write pump       format all sources of a project in place\n  \
  sieben fmt --check pump       exit 1 if a source is not formatted\n\n\
Encoding and line ends of a file stay as they are; comments and everything else are kept.\n\
A source with syntax errors is left alone (exit 3).")]
pub(crate) struct Arguments {
    /// Source files or a project folder
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Replace the files instead of printing
    #[arg(short, long, conflicts_with = "check")]
    write: bool,
    /// Change nothing; exit 1 if something would change
    #[arg(long)]
    check: bool,
    /// Write UTF-8 instead of the encoding of the file
    #[arg(long)]
    utf8: bool,
    /// Mnemonic language of the sources [default: the project's, else judged over each file]
    #[arg(long, value_name = "LANGUAGE")]
    mnemonics: Option<MnemonicsArgument>,
    /// Dialect of the sources of ST and SCL [default: the project's, else judged over each file]
    #[arg(long, value_name = "DIALECT", value_parser = dialect_argument)]
    dialect: Option<Dialect>,
    #[command(flatten)]
    encoding: EncodingArgument,
}

/// Formats the sources.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let destination = match (arguments.write, arguments.check) {
        (true, _) => Destination::InPlace,
        (_, true) => Destination::Check,
        _ => Destination::Print,
    };
    let mnemonics = arguments.mnemonics.map(MnemonicsArgument::language);
    Rewriting { destination, utf8: arguments.utf8, encoding: arguments.encoding.chosen(), done: "formatted" }.run(
        &arguments.paths,
        |project, source| {
            let language = source.language(arguments.dialect.or(project.settings.dialect));
            (language.row().format)(&source.decoded.text, language, mnemonics.unwrap_or(project.settings.mnemonics))
        },
    )
}
