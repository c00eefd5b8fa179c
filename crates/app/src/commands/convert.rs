//! `sieben convert --mnemonics en|de PATH…`: sources in the other mnemonic language.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use sieben_model::mnemonics::Mnemonics;

use crate::arguments::{EncodingArgument, MnemonicsArgument};
use crate::failure::{Exit, Failure};
use crate::rewriting::{Destination, Rewriting};

/// Change STL sources from one mnemonic language to the other.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben convert --mnemonics en line4.awl              print it with A, JC, OPN\n  \
  sieben convert --mnemonics de main.awl -o deutsch.awl\n  \
  sieben convert --mnemonics en --write pump           all sources of a project in place\n\n\
Only instructions, addresses and status words change; layout, comments, encoding\n\
and line ends stay. A source with syntax errors is left alone (exit 3).")]
pub(crate) struct Arguments {
    /// Source files or a project folder
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// The language to change to
    #[arg(long, value_name = "LANGUAGE")]
    mnemonics: Target,
    /// The language that the sources are in [default: judged over each file]
    #[arg(long, value_name = "LANGUAGE")]
    from: Option<MnemonicsArgument>,
    /// Replace the files instead of printing
    #[arg(short, long, conflicts_with = "output")]
    write: bool,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write UTF-8 instead of the encoding of the file
    #[arg(long)]
    utf8: bool,
    #[command(flatten)]
    encoding: EncodingArgument,
}

/// A mnemonic language to change to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Target {
    // International: A, JC, OPN.
    En,
    // SIMATIC: U, SPB, AUF.
    De,
}

/// Converts the sources.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let destination = match &arguments.output {
        Some(path) => Destination::File(path.clone()),
        None if arguments.write => Destination::InPlace,
        None => Destination::Print,
    };
    let to = match arguments.mnemonics {
        Target::En => Mnemonics::English,
        Target::De => Mnemonics::German,
    };
    let from = arguments.from.map(MnemonicsArgument::language);
    Rewriting { destination, utf8: arguments.utf8, encoding: arguments.encoding.chosen(), done: "converted" }.run(
        &arguments.paths,
        |project, source| {
            let language = source.language(None);
            (language.row().convert)(&source.decoded.text, language, from.unwrap_or(project.settings.mnemonics), to)
        },
    )
}
