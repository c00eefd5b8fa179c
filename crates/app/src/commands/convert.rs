//! `sieben convert`: sources in the other mnemonic language (`--mnemonics`), networks in another form (`--to`).

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use serde_json::{Value, json};
use sieben_lang::network::flavour::Drawing;
use sieben_lang::network::read::Mode;
use sieben_lang::stl::redraw::{self, AnswerKind, Form, Redrawing, RedrawnNetwork};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_workspace::finding::{self, Finding};
use sieben_workspace::project::Overrides;

use crate::arguments::{EncodingArgument, MnemonicsArgument};
use crate::diagrams;
use crate::failure::{Exit, Failure};
use crate::language;
use crate::output;
use crate::project;
use crate::report;
use crate::rewriting::{Destination, Rewriting};

/// Change sources from one mnemonic language to the other, or networks into LAD, FBD or STL.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben convert --mnemonics en line4.awl              print it with A, JC, OPN\n  \
  sieben convert --mnemonics de main.awl -o deutsch.awl\n  \
  sieben convert --mnemonics en --write pump           all sources of a project in place\n  \
  sieben convert pump --to lad                         its networks as ladder, what cannot be drawn stays STL\n  \
  sieben convert main.awl --to fbd --block \"FC 1\" --rewrite\n  \
  sieben convert main.lad --to stl -o main.awl\n\n\
With `--mnemonics` only instructions, addresses and status words change; layout, comments, encoding\n\
and line ends stay. A source with syntax errors is left alone (exit 3).\n\
With `--to` a network that cannot be drawn stays as it is and is reported (exit 0); `--rewrite` also draws\n\
those that mean the same after a rewrite (`sieben explain W2`). A program that does not compile is left alone (exit 3).")]
pub(crate) struct Arguments {
    /// Source files or a project folder [with --to default: this folder]
    #[arg(value_name = "PATH", required_unless_present = "to")]
    paths: Vec<PathBuf>,
    /// The mnemonic language to change to
    #[arg(long, value_name = "LANGUAGE", required_unless_present = "to", conflicts_with = "to")]
    mnemonics: Option<Target>,
    /// The language that the sources are in [default: judged over each file]
    #[arg(long, value_name = "LANGUAGE")]
    from: Option<MnemonicsArgument>,
    /// What networks become
    #[arg(long, value_name = "LANGUAGE")]
    to: Option<NetworkTarget>,
    /// How diagrams are written: a one element on each line, b one network on each line [default: a]
    #[arg(long, value_name = "FORM", requires = "to", conflicts_with = "mnemonics")]
    form: Option<FormArgument>,
    /// Only the networks of this block
    #[arg(long, value_name = "BLOCK", requires = "to", conflicts_with = "mnemonics")]
    block: Option<String>,
    /// Rewrite what means the same so that it can be drawn
    #[arg(long, requires = "to", conflicts_with = "mnemonics")]
    rewrite: bool,
    /// Print what came of each network as JSON
    #[arg(long, requires = "to", conflicts_with_all = ["write", "output", "mnemonics"])]
    json: bool,
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

/// What networks become.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum NetworkTarget {
    /// Ladder.
    Lad,
    /// Function block diagram.
    Fbd,
    /// Statement list.
    Stl,
}

/// A text form of diagrams.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FormArgument {
    /// One element on each line.
    A,
    /// One network on each line.
    B,
}

/// Converts the sources.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let destination = match &arguments.output {
        Some(path) => Destination::File(path.clone()),
        None if arguments.write => Destination::InPlace,
        None => Destination::Print,
    };
    let rewriting = Rewriting { destination, utf8: arguments.utf8, encoding: arguments.encoding.chosen(), done: "converted" };
    if let Some(to) = arguments.to {
        return networks(arguments, &rewriting, to);
    }
    let to = match arguments.mnemonics {
        Some(Target::De) => Mnemonics::German,
        Some(Target::En) | None => Mnemonics::English,
    };
    let from = arguments.from.map(MnemonicsArgument::language);
    rewriting.run(&arguments.paths, |project, source| {
        let language = source.language(None);
        (language.row().convert)(&source.decoded.text, language, from.unwrap_or(project.settings.mnemonics), to)
    })
}

/// Networks in another form.
fn networks(arguments: &Arguments, rewriting: &Rewriting, to: NetworkTarget) -> Result<Exit, Failure> {
    let overrides = Overrides { mnemonics: arguments.from.map(MnemonicsArgument::language), ..Overrides::default() };
    let build = project::load(&arguments.paths, arguments.encoding.chosen())?.compile(overrides, false);
    if finding::has_errors(&build.findings) {
        report::print(&build.findings, &build.project.texts, arguments.json);
        return Ok(Exit::DoesNotCompile);
    }
    let form = match arguments.form {
        None | Some(FormArgument::A) => Form::A,
        Some(FormArgument::B) => Form::B,
    };
    let redrawing = Redrawing {
        target: match to {
            NetworkTarget::Lad => redraw::Target::Diagram(Drawing::Lad, form),
            NetworkTarget::Fbd => redraw::Target::Diagram(Drawing::Fbd, form),
            NetworkTarget::Stl => redraw::Target::Statements,
        },
        block: arguments.block.as_deref().map(|name| diagrams::block_named(&build, name)).transpose()?,
        mode: if arguments.rewrite { Mode::RewritingConstants } else { Mode::Strict },
    };
    let sources = diagrams::sources(&build);
    if sources.is_empty() {
        let message = "there is no source of STL, LAD or FBD here";
        return Err(
            Failure::usage(Problem::P7001, message).help("diagrams in Structured Text are not converted; `sieben render` draws them")
        );
    }
    if sources.len() > 1 && !arguments.json && matches!(rewriting.destination, Destination::Print | Destination::File(_)) {
        let message = format!("{} sources cannot go into one place", sources.len());
        return Err(Failure::usage(Problem::P7001, message).help("give one file, or `--write` to replace each of them"));
    }
    let mut findings = Vec::new();
    let mut all = Vec::new();
    for (file, source) in sources {
        let redrawn = source.redraw(&redrawing);
        let undrawn = redrawn.networks.iter().filter(|network| network.stays && network.answer != AnswerKind::Exact);
        findings.extend(undrawn.map(|network| Finding::program(told(network, arguments.rewrite))));
        all.extend(redrawn.networks.iter().map(|network| to_json(&file.path.display().to_string(), network)));
        if !arguments.json {
            rewriting.finish(file, &redrawn.text)?;
        }
    }
    if arguments.json {
        output::print_json(&Value::Array(all), true)?;
    } else if !findings.is_empty() {
        output::message(&report::pieces(&findings, &build.project.texts, output::colour(), language::spoken()).concat());
    }
    if !findings.is_empty() {
        let (count, verb) =
            if findings.len() == 1 { ("1 network".to_owned(), "stays") } else { (format!("{} networks", findings.len()), "stay") };
        output::message(&format!("{count} {verb} as written.\n"));
    }
    Ok(Exit::Success)
}

/// The problem with a number.
fn problem(number: u16) -> Problem {
    Problem::from_code(&format!("P{number}")).expect("every reason has a problem code")
}

/// Why a network stays as it is.
fn told(network: &RedrawnNetwork, rewriting: bool) -> Diagnostic {
    let (block, number) = (network.block, network.number);
    let codes: Vec<&str> = network.codes.iter().map(|code| code.code()).collect();
    let rewrite = (!codes.is_empty() && !rewriting).then(|| format!("`--rewrite` draws it ({})", codes.join(", ")));
    match &network.refusal {
        Some(refusal) => {
            let message = format!("{block}, network {number} stays as written, {}: {}", refusal.reason, refusal.message());
            let diagnostic = Diagnostic::new(problem(refusal.reason.problem()), network.span, message);
            match (rewrite, refusal.reason.fix()) {
                (Some(rewrite), "") => diagnostic.help(rewrite),
                (Some(rewrite), fix) => diagnostic.help(format!("{fix}; {rewrite}")),
                (None, "") => diagnostic,
                (None, fix) => diagnostic.help(fix),
            }
        }
        None => {
            let message = format!("{block}, network {number} stays as written: drawn it would mean the same, but give other statements");
            Diagnostic::new(Problem::P9020, network.span, message).help(rewrite.unwrap_or_default())
        }
    }
}

fn to_json(file: &str, network: &RedrawnNetwork) -> Value {
    let mut object = json!({
        "file": file,
        "block": network.block.to_string(),
        "network": network.number,
        "answer": network.answer.word(),
        "codes": network.codes.iter().map(|code| code.code()).collect::<Vec<_>>(),
        "text": network.text,
    });
    if let (Some(refusal), Some(fields)) = (&network.refusal, object.as_object_mut()) {
        fields.insert("reason".to_owned(), json!(refusal.reason.code()));
        fields.insert("statement".to_owned(), json!(refusal.statement + 1));
        fields.insert("message".to_owned(), json!(refusal.message()));
    } else if network.answer == AnswerKind::Equivalent
        && let Some(fields) = object.as_object_mut()
    {
        fields.insert("message".to_owned(), json!(Problem::P9020.title()));
    }
    object
}
