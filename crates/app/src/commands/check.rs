//! `sieben check [PATH…]`: everything that is wrong with a program.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde_json::json;
use sieben_cpu::OnlineChange;
use sieben_lang::TemporaryReads;
use sieben_model::problems::Problem;

use crate::arguments::ProgramArguments;
use crate::failure::{Exit, Failure};
use crate::project::{Build, Overrides};
use crate::report::{Finding, Texts};
use crate::{fixing, online_change, output, report};

/// Report everything that is wrong with a program.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben check                        the project in this folder\n  \
  sieben check line4.awl symbols.sdf  a source with its symbol table\n  \
  sieben check pump --json            for an editor or a script\n  \
  sieben check pump --output-format github  annotations in a workflow of GitHub Actions\n  \
  sieben check --fix line4.awl        mend what can mean only one thing\n  \
  sieben check pump --against backup  what an online change from `backup` would do\n\n\
Exit codes: 0 no errors, 3 errors.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables, or a project folder [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// Report only what one file alone can tell: no missing symbols or blocks
    #[arg(long)]
    syntax_only: bool,
    /// Also report temporary variables that are read, but not written on every path to that statement
    #[arg(long)]
    temp: bool,
    /// Also list what an online change from the program in this file or folder would change, and what it could not keep
    #[arg(long, value_name = "OLD", conflicts_with_all = ["syntax_only", "fix"])]
    against: Option<PathBuf>,
    /// How the diagnostics are printed
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    output_format: Format,
    /// The same as --output-format json
    #[arg(long, conflicts_with = "output_format")]
    json: bool,
    /// Apply the fixes of which there is no doubt to the files, then check again
    #[arg(long, conflicts_with = "json")]
    fix: bool,
}

/// A form of the diagnostics.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// With the lines of the source, for people
    Text,
    /// A JSON list on standard output; with --against, an object
    Json,
    /// One line each on standard output: file:line:column: error[code]: message
    Concise,
    /// Workflow commands of GitHub Actions, which become annotations of the lines
    Github,
}

impl Arguments {
    fn format(&self) -> Format {
        if self.json { Format::Json } else { self.output_format }
    }
}

/// Rounds of fixes: one may uncover another, and some could undo one another for ever.
const ROUNDS_MAX: usize = 10;

/// Checks the program. Who reads another form than text gets that whatever happens.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    check(arguments).or_else(|failure| {
        if arguments.format() == Format::Text {
            return Err(failure);
        }
        let mut finding = Finding::file(failure.problem, String::new(), failure.message);
        finding.diagnostic.help = failure.help;
        print(arguments.format(), &[finding], &Texts::default())?;
        Ok(failure.exit)
    })
}

fn check(arguments: &Arguments) -> Result<Exit, Failure> {
    let format = arguments.format();
    if arguments.fix && format == Format::Json {
        return Err(Failure::usage(Problem::P7001, "`--fix` cannot be used with `--output-format json`")
            .help("apply the fixes first, then ask for JSON"));
    }
    if arguments.against.is_some() && matches!(format, Format::Concise | Format::Github) {
        return Err(Failure::usage(
            Problem::P7001,
            "`--against` prints more than diagnostics, which this `--output-format` has no form for",
        )
        .help("leave `--output-format` out, or write `--output-format json`"));
    }
    let temporaries = if arguments.temp { TemporaryReads::Possible } else { TemporaryReads::Certain };
    let overrides = Overrides { temporaries, ..arguments.program.overrides()? };
    let compile = || Ok::<_, Failure>(arguments.program.load(&arguments.paths)?.compile(overrides, arguments.syntax_only));
    let mut build = compile()?;
    for _ in 0..if arguments.fix { ROUNDS_MAX } else { 0 } {
        let done = fixing::apply(&build)?;
        if done.is_empty() {
            break;
        }
        let lines = done.join("\n") + "\n";
        match format {
            Format::Text => output::print(&lines)?,
            _ => output::message(&lines),
        }
        build = compile()?;
    }
    check_one(arguments, &build, overrides)
}

/// Prints findings in this form.
fn print(format: Format, findings: &[Finding], texts: &Texts) -> Result<(), Failure> {
    match format {
        Format::Text => {
            report::print(findings, texts, false);
            Ok(())
        }
        Format::Json => output::print_json(&report::to_json(findings, texts), true),
        Format::Concise => output::print(&report::lines::concise(findings, texts)),
        Format::Github => output::print(&report::lines::github(findings, texts)),
    }
}

/// A sentence that is a result for people, and a remark where lines are read by programs.
fn say(format: Format, sentence: &str) -> Result<(), Failure> {
    match format {
        Format::Text => output::print(sentence),
        Format::Json => Ok(()),
        Format::Concise | Format::Github => {
            output::message(sentence);
            Ok(())
        }
    }
}

fn plural(count: usize, word: &str) -> String {
    if count == 1 { format!("1 {word}") } else { format!("{count} {word}s") }
}

fn check_one(arguments: &Arguments, build: &Build, overrides: Overrides) -> Result<Exit, Failure> {
    let findings = &build.findings;
    let format = arguments.format();
    if let Some(old) = arguments.against.as_ref().filter(|_| !report::has_errors(findings)) {
        return against(arguments, overrides, old, build);
    }
    if !findings.is_empty() || format != Format::Text {
        print(format, findings, &build.project.texts)?;
    }
    if findings.is_empty() {
        let sources = plural(build.project.sources.len(), "source");
        let program = &build.compiled.program;
        let library: Vec<&str> = build.compiled.library.iter().map(|linked| linked.block.name).collect();
        let own = program.code.len() + program.data.len() - library.len();
        let what = match (arguments.syntax_only, library.as_slice()) {
            (true, _) => sources,
            (false, []) => format!("{} in {sources}", plural(own, "block")),
            (false, names) => format!("{} in {sources}, {} of the library ({})", plural(own, "block"), names.len(), names.join(", ")),
        };
        say(format, &format!("{what}, no errors, no warnings.\n"))?;
    }
    Ok(if report::has_errors(findings) { Exit::DoesNotCompile } else { Exit::Success })
}

/// Lists what an online change from one program to another does.
fn against(arguments: &Arguments, overrides: Overrides, old: &Path, build: &Build) -> Result<Exit, Failure> {
    let paths = [old.to_path_buf()];
    let before = match arguments.program.load(&paths)?.compile(overrides, false) {
        before if report::has_errors(&before.findings) => super::or_report(before, arguments.format() == Format::Json),
        before => Ok(before),
    };
    let before = match before {
        Ok(before) => before,
        Err(exit) => return Ok(exit),
    };
    if *before.cpu != *build.cpu {
        let message = format!("an online change from a CPU {} to a CPU {} cannot be: it needs a restart", before.cpu.name, build.cpu.name);
        return Err(Failure::usage(Problem::P7002, message).help("give both programs the same CPU type, with `--cpu`"));
    }
    let change = OnlineChange::between(&before.compiled.program, &build.compiled.program, &[]);
    if arguments.format() == Format::Json {
        let diagnostics = report::to_json(&build.findings, &build.project.texts);
        output::print_json(&json!({ "diagnostics": diagnostics, "online_change": online_change::to_json(&change) }), true)?;
        return Ok(Exit::Success);
    }
    if !build.findings.is_empty() {
        report::print(&build.findings, &build.project.texts, false);
    }
    let kept = if change.losses.is_empty() { "All values are kept.\n" } else { "All other values are kept.\n" };
    output::print(&format!("{}.\n{}{kept}", capital(&online_change::blocks(&change)), online_change::details(&change)))?;
    Ok(Exit::Success)
}

/// The text with its first letter as at the beginning of a sentence.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
