//! `sieben check [PATH…]`: everything that is wrong with a program.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde_json::json;
use sieben_cpu::OnlineChange;
use sieben_lang::TemporaryReads;
use sieben_model::problems::Problem;
use sieben_model::visible;
use sieben_workspace::finding::several::Several;
use sieben_workspace::finding::{self, Finding, Texts};
use sieben_workspace::online_change;
use sieben_workspace::project::{Build, Overrides};

use crate::arguments::{ProgramArguments, StrictArgument};
use crate::failure::{Exit, Failure};
use crate::programs::{Chosen, Folder, Program};
use crate::testing::checked;
use crate::{fixing, output, paths, report};

/// Report everything that is wrong with a program.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben check                        the project in this folder\n  \
  sieben check exercises              each program of a folder of exercises\n  \
  sieben check line4.awl symbols.sdf  a source with its symbol table\n  \
  sieben check pump --json            for an editor or a script\n  \
  sieben check pump --output-format github  annotations in a workflow of GitHub Actions\n  \
  sieben check --fix line4.awl        mend what can mean only one thing\n  \
  sieben check pump --against backup  what an online change from `backup` would do\n\n\
Exit codes: 0 no errors, 3 errors.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables, or a folder with one program or several [default: this folder]
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
    #[command(flatten)]
    strict: StrictArgument,
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
    /// A JSON list on standard output; with --against, and for a folder with several programs, an object
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
/// Programs with errors that the last line names.
const NAMED_MAX: usize = 8;

/// Checks the program. Who reads another form than text gets that whatever happens.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    check(arguments).or_else(|failure| {
        if arguments.format() == Format::Text {
            return Err(failure);
        }
        let finding = Finding::refused(String::new(), failure.refusal);
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
    let overrides = Overrides { temporaries, ..arguments.strict.overrides(arguments.program.overrides()?) };
    let chosen = match arguments.syntax_only {
        true => Chosen::files(&arguments.paths, arguments.program.encoding())?,
        false => Chosen::of(&arguments.paths, arguments.program.encoding())?,
    };
    if arguments.fix {
        fix(arguments, &chosen, overrides)?;
    }
    match chosen.programs.as_slice() {
        [program] => check_one(arguments, &compile(arguments, program, overrides)?, overrides),
        _ => check_several(arguments, &chosen, overrides),
    }
}

fn compile(arguments: &Arguments, program: &Program, overrides: Overrides) -> Result<Build, Failure> {
    let project = match arguments.syntax_only {
        true => arguments.program.load_files(&program.paths)?,
        false => arguments.program.load(&program.paths)?,
    };
    let before = project.clone();
    let mut build = project.compile(overrides, arguments.syntax_only);
    if !arguments.syntax_only && !finding::has_errors(&build.findings) {
        for test in checked::unit_tests(&before) {
            build.findings.extend(checked::findings(&before, &test, overrides, &mut build.project.texts));
        }
    }
    Ok(build)
}

/// Applies fixes until there are no more.
fn fix(arguments: &Arguments, chosen: &Chosen, overrides: Overrides) -> Result<(), Failure> {
    for _ in 0..ROUNDS_MAX {
        let mut done = Vec::new();
        // What one program changes in a shared file, the next one reads.
        for program in &chosen.programs {
            done.extend(fixing::apply(&compile(arguments, program, overrides)?)?);
        }
        if done.is_empty() {
            break;
        }
        let lines = done.join("\n") + "\n";
        match arguments.format() {
            Format::Text => output::print(&lines)?,
            _ => output::message(&lines),
        }
    }
    Ok(())
}

/// Prints findings in this form.
fn print(format: Format, findings: &[Finding], texts: &Texts) -> Result<(), Failure> {
    match format {
        Format::Text => {
            report::print(findings, texts, false);
            Ok(())
        }
        Format::Json => output::print_json(&finding::to_json(findings, texts), true),
        Format::Concise => output::print(&finding::lines::concise(findings, texts)),
        Format::Github => output::print(&finding::lines::github(findings, texts)),
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
    if let Some(old) = arguments.against.as_ref().filter(|_| !finding::has_errors(findings)) {
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
    Ok(if finding::has_errors(findings) { Exit::DoesNotCompile } else { Exit::Success })
}

/// Checks each program of a folder; what is wrong with a file that several of them share is printed once.
fn check_several(arguments: &Arguments, chosen: &Chosen, overrides: Overrides) -> Result<Exit, Failure> {
    if let (Some(_), Some(folder)) = (&arguments.against, chosen.folders.first()) {
        return Err(folder.too_many());
    }
    let format = arguments.format();
    let mut several = Several::default();
    let mut sources = BTreeSet::new();
    for program in &chosen.programs {
        let mut build = compile(arguments, program, overrides)?;
        if chosen.folders.is_empty() {
            // An empty file among others is no program without a source.
            let empty = build.findings.iter_mut().filter(|finding| finding.diagnostic.problem == Problem::P6005);
            empty.for_each(|finding| finding.diagnostic.problem = Problem::P6004);
        }
        let own: Vec<String> = build.project.sources.iter().map(|source| paths::shown(&source.path)).collect();
        sources.extend(own.iter().cloned());
        several.add(&program.name, own, &build.findings, &build.project.texts);
    }
    let (mut findings, texts, programs) = several.finish(chosen.folders.iter().flat_map(Folder::findings).collect());
    for folder in &chosen.folders {
        say(format, &format!("{}\n", folder.sentence()))?;
    }
    // Files of which each was looked at alone are no programs.
    if chosen.folders.is_empty() {
        findings.iter_mut().for_each(|finding| finding.programs.clear());
        if !findings.is_empty() || format != Format::Text {
            print(format, &findings, &texts)?;
        }
        if findings.is_empty() {
            say(format, &format!("{}, no errors, no warnings.\n", plural(sources.len(), "source")))?;
        }
    } else if format == Format::Json {
        let programs: Vec<_> = programs
            .iter()
            .map(|program| json!({ "name": program.name, "files": program.files, "errors": program.errors, "warnings": program.warnings }))
            .collect();
        output::print_json(&json!({ "programs": programs, "diagnostics": finding::to_json(&findings, &texts) }), true)?;
    } else if !findings.is_empty() {
        print(format, &findings, &texts)?;
        let wrong: Vec<&str> = programs.iter().filter(|program| program.errors > 0).map(|program| program.name.as_str()).collect();
        let names: Vec<String> = wrong.iter().take(NAMED_MAX).map(|name| format!("`{}`", visible::name(name))).collect();
        let more = if wrong.len() > names.len() { format!(" and {} more", wrong.len() - names.len()) } else { String::new() };
        output::message(&match wrong.len() {
            0 => format!("None of {} programs has errors.\n", programs.len()),
            1 => format!("1 of {} programs has errors: {}.\n", programs.len(), names[0]),
            count => format!("{count} of {} programs have errors: {}{more}.\n", programs.len(), names.join(", ")),
        });
    } else {
        let (programs, sources) = (plural(programs.len(), "program"), plural(sources.len(), "source"));
        say(format, &format!("{programs} in {sources}, no errors, no warnings.\n"))?;
    }
    Ok(if finding::has_errors(&findings) { Exit::DoesNotCompile } else { Exit::Success })
}

/// Lists what an online change from one program to another does.
fn against(arguments: &Arguments, overrides: Overrides, old: &Path, build: &Build) -> Result<Exit, Failure> {
    let paths = [old.to_path_buf()];
    let before = match arguments.program.load(&paths)?.compile(overrides, false) {
        before if finding::has_errors(&before.findings) => super::or_report(before, arguments.format() == Format::Json),
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
        let diagnostics = finding::to_json(&build.findings, &build.project.texts);
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
