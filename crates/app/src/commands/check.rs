//! `sieben check [PATH…]`: everything that is wrong with a program.

use std::path::PathBuf;

use clap::Args;
use sieben_lang::TemporaryReads;

use crate::arguments::ProgramArguments;
use crate::failure::{Exit, Failure};
use crate::project::Overrides;
use crate::report::{Finding, Texts};
use crate::{fixing, output, project, report};

/// Report everything that is wrong with a program.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben check                        the project in this folder\n  \
  sieben check line4.awl symbols.sdf  a source with its symbol table\n  \
  sieben check pump --json            for an editor or a script\n  \
  sieben check --fix line4.awl        mend what can mean only one thing\n\n\
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
    /// Print the diagnostics as a JSON list on standard output
    #[arg(long)]
    json: bool,
    /// Apply the fixes of which there is no doubt to the files, then check again
    #[arg(long, conflicts_with = "json")]
    fix: bool,
}

/// Rounds of fixes: one may uncover another, and some could undo one another for ever.
const ROUNDS_MAX: usize = 10;

/// Checks the program. Who reads JSON gets a list whatever happens.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    check(arguments).or_else(|failure| {
        if !arguments.json {
            return Err(failure);
        }
        let mut finding = Finding::file(failure.problem, String::new(), failure.message);
        finding.diagnostic.help = failure.help;
        output::print_json(&report::to_json(&[finding], &Texts::default()), true)?;
        Ok(failure.exit)
    })
}

fn check(arguments: &Arguments) -> Result<Exit, Failure> {
    let temporaries = if arguments.temp { TemporaryReads::Possible } else { TemporaryReads::Certain };
    let overrides = Overrides { temporaries, ..arguments.program.overrides()? };
    let compile = || Ok::<_, Failure>(arguments.program.load(&arguments.paths)?.compile(overrides, arguments.syntax_only));
    let mut build = compile()?;
    for _ in 0..if arguments.fix { ROUNDS_MAX } else { 0 } {
        let done = fixing::apply(&build)?;
        if done.is_empty() {
            break;
        }
        output::print(&(done.join("\n") + "\n"))?;
        build = compile()?;
    }
    let findings = &build.findings;
    if arguments.json {
        output::print_json(&report::to_json(findings, &build.project.texts), true)?;
    } else if findings.is_empty() {
        let plural = |count: usize, word: &str| if count == 1 { format!("1 {word}") } else { format!("{count} {word}s") };
        let sources = plural(build.project.sources.len(), "source");
        let program = &build.compiled.program;
        let library: Vec<&str> = build.compiled.library.iter().map(|linked| linked.block.name).collect();
        let own = program.code.len() + program.data.len() - library.len();
        let what = match (arguments.syntax_only, library.as_slice()) {
            (true, _) => sources,
            (false, []) => format!("{} in {sources}", plural(own, "block")),
            (false, names) => format!("{} in {sources}, {} of the library ({})", plural(own, "block"), names.len(), names.join(", ")),
        };
        output::print(&format!("{what}, no errors, no warnings.\n"))?;
    } else {
        project::print_findings(findings, &build.project.texts, false);
    }
    Ok(if report::has_errors(findings) { Exit::DoesNotCompile } else { Exit::Success })
}
