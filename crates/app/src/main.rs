//! The command line of Sieben: one binary, one file per verb.
#![forbid(unsafe_code)]

mod arguments;
mod campaign;
mod chosen;
mod commands;
mod control;
mod diagrams;
mod document;
mod duration;
mod engines;
mod examples;
mod failure;
mod files;
mod fixing;
mod fleet;
mod folder;
mod glob;
mod help;
mod instances;
mod language;
mod linking;
mod lsp;
mod output;
mod page;
mod palette;
mod panics;
mod paths;
mod problem_pages;
mod programs;
mod project;
mod report;
mod retain;
mod rewriting;
mod schedule;
mod screen;
mod servers;
mod stepping;
mod symbol_files;
mod terminal;
mod testing;
mod top;
mod tracing;
mod watch;

use std::io::Write as _;
use std::path::Path;
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use sieben_model::language::{Language, Text, fill};
use sieben_model::problems::Problem;
use sieben_model::visible;

use crate::failure::{Exit, Failure};

/// Machine code is compiled out of many short-lived lists: memory that is given back and taken again costs a fifth of the time.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Sieben: an open soft PLC. It runs STEP 7 programs in STL, SCL and Structured Text exactly as an S7-300/400 CPU does.
#[derive(Parser)]
#[command(
    name = "sieben",
    version,
    disable_help_subcommand = false,
    max_term_width = 110,
    after_help = "Without a command Sieben starts the demo plant; where no terminal shows it, it prints this help.\n\n\
Examples:\n  \
  sieben                                      a dosing plant, live in the terminal\n  \
  sieben new pump                             a project that runs and checks at once\n  \
  sieben check pump                           all errors and warnings\n  \
  sieben run pump --for 10s                   run it\n  \
  sieben top pump                             watch it run, from another terminal\n  \
  sieben exec add.awl --set MW0=2 --show MW4  a few scans, then print values\n  \
  sieben step lamp.awl --set I0.0=1           why is it 0? Statement by statement, and back\n  \
  sieben trace lamp.awl --at 1s I0.0=1        what happens when, as a timing diagram\n  \
  sieben test pump                            its unit tests, in virtual time\n  \
  sieben explain SPB                          what an instruction does\n\n\
Exit codes: 0 ok, 1 a check failed, 2 usage, 3 does not compile, 4 the CPU went to STOP, 70 our own error."
)]
struct CommandLine {
    /// Language of help, messages and reasons, en or de [default: that of the environment, else en]
    #[arg(long, global = true, value_name = "LANGUAGE", value_parser = language::argument)]
    lang: Option<Language>,
    #[command(subcommand)]
    verb: Option<Verb>,
}

#[derive(Subcommand)]
enum Verb {
    /// A dosing plant with its controller, live in the terminal
    Demo(commands::demo::Arguments),
    /// Run a project
    Run(commands::run::Arguments),
    /// Run a project with its servers, for clients over the network, until it is told to end
    Serve(commands::serve::Arguments),
    /// Watch a program that runs, and start, stop or pause it
    Top(commands::top::Arguments),
    /// Report everything that is wrong with a program
    Check(commands::check::Arguments),
    /// Run a few scans in virtual time and print values
    Exec(commands::exec::Arguments),
    /// Step through a program, one statement at a time, forwards and back
    Step(commands::step::Arguments),
    /// Measure how long a scan takes
    Bench(commands::bench::Arguments),
    /// Run unit tests, scenarios, and programs that check themselves
    Test(commands::test::Arguments),
    /// Run a program through very many scenarios: every combination of its inputs, drawn values, faults
    Campaign(Box<commands::campaign::Arguments>),
    /// Run very many controllers at once, coupled by links
    Fleet(Box<commands::fleet::Arguments>),
    /// Take scenarios of campaigns that other machines run, through a NATS server
    Worker(Box<commands::worker::Arguments>),
    /// Record values over many scans and draw them as a timing diagram
    Trace(Box<commands::trace::Arguments>),
    /// Write down what goes into a program and what comes out, to hold another program against it
    Record(Box<commands::record::Arguments>),
    /// Explain an instruction, a problem code, a CPU type, a system function or an event
    Explain(commands::explain::Arguments),
    /// Bring sources of STL, LAD, FBD, ST and SCL into one layout
    Fmt(commands::fmt::Arguments),
    /// Change sources from one mnemonic language to the other, or networks into LAD, FBD or STL
    Convert(commands::convert::Arguments),
    /// Print the assignment table, or convert symbol tables
    Symbols(commands::symbols::Arguments),
    /// Print what a client can read and write, and where it lies
    Tags(commands::tags::Arguments),
    /// Print where every address, timer, counter and block is used
    Refs(commands::refs::Arguments),
    /// Draw networks as ladder or function block diagrams
    Render(commands::render::Arguments),
    /// Print which block calls which, and the local data of every path
    Structure(commands::structure::Arguments),
    /// Print which inputs, outputs, bit memory, timers and counters are used
    Assignments(commands::assignments::Arguments),
    /// Make a project that runs and checks at once
    New(commands::new::Arguments),
    /// Serve an editor over standard input and output: what is wrong, what a word means, where it is used
    Lsp(commands::lsp::Arguments),
    /// Print the completions for a shell
    #[command(hide = true)]
    Completions(commands::completions::Arguments),
}

fn main() -> ExitCode {
    panics::install();
    files::outlive_limits();
    let exit = match command_line() {
        Ok(line) => run(line),
        Err(exit) => exit,
    };
    ExitCode::from(exit as u8)
}

fn run(mut line: CommandLine) -> Exit {
    let among_words = match &mut line.verb {
        Some(Verb::Explain(arguments)) => arguments.take_language(),
        _ => None,
    };
    language::choose(line.lang.or(among_words));
    let result = match line.verb {
        None if terminal::shows_results() => commands::demo::run(&commands::demo::Arguments::default()),
        None => {
            output::print(&help::in_language(CommandLine::command(), language::spoken()).render_help().to_string()).map(|()| Exit::Success)
        }
        Some(Verb::Demo(arguments)) => commands::demo::run(&arguments),
        Some(Verb::Run(arguments)) => commands::run::run(arguments),
        Some(Verb::Serve(arguments)) => commands::serve::run(arguments),
        Some(Verb::Top(arguments)) => commands::top::run(&arguments),
        Some(Verb::Check(arguments)) => commands::check::run(&arguments),
        Some(Verb::Exec(arguments)) => commands::exec::run(&arguments),
        Some(Verb::Step(arguments)) => commands::step::run(&arguments),
        Some(Verb::Bench(arguments)) => commands::bench::run(&arguments),
        Some(Verb::Test(arguments)) => commands::test::run(&arguments),
        Some(Verb::Campaign(arguments)) => commands::campaign::run(&arguments),
        Some(Verb::Fleet(arguments)) => commands::fleet::run(&arguments),
        Some(Verb::Worker(arguments)) => commands::worker::run(&arguments),
        Some(Verb::Trace(arguments)) => commands::trace::run(&arguments),
        Some(Verb::Record(arguments)) => commands::record::run(&arguments),
        Some(Verb::Explain(arguments)) => commands::explain::run(&arguments),
        Some(Verb::Fmt(arguments)) => commands::fmt::run(&arguments),
        Some(Verb::Convert(arguments)) => commands::convert::run(&arguments),
        Some(Verb::Symbols(arguments)) => commands::symbols::run(&arguments),
        Some(Verb::Tags(arguments)) => commands::tags::run(&arguments),
        Some(Verb::Refs(arguments)) => commands::refs::run(&arguments),
        Some(Verb::Render(arguments)) => commands::render::run(&arguments),
        Some(Verb::Structure(arguments)) => commands::structure::run(&arguments),
        Some(Verb::Assignments(arguments)) => commands::assignments::run(&arguments),
        Some(Verb::New(arguments)) => commands::new::run(&arguments),
        Some(Verb::Lsp(arguments)) => commands::lsp::run(&arguments),
        Some(Verb::Completions(arguments)) => commands::completions::run(&arguments, &mut CommandLine::command()),
    };
    result.unwrap_or_else(|failure: Failure| {
        match wants_json() {
            true => output::message(&format!("{:#}\n", failure.to_json())),
            false => output::styled(&failure.render(output::colour(), language::spoken())),
        }
        failure.exit
    })
}

/// Whether the command line asks for JSON, as far as that can be said of one that may be wrong.
fn wants_json() -> bool {
    let arguments: Vec<_> = std::env::args_os().skip(1).take_while(|argument| argument != "--").collect();
    let format = arguments.windows(2).any(|pair| (pair[0] == "--output-format" || pair[0] == "--format") && pair[1] == "json");
    let words = ["--json", "--output-format=json", "--format=json"];
    format || arguments.iter().any(|argument| words.iter().any(|word| argument == word))
}

/// A command line that is not understood, as JSON: on standard output where the list is the result, else where messages go.
fn wrong_command_line(error: &clap::Error) {
    let text = error.to_string();
    // What is missing, or what would be possible, stands on the lines below the first.
    let paragraph: Vec<&str> =
        text.lines().take_while(|line| !line.starts_with("Usage:")).map(str::trim).filter(|line| !line.is_empty()).collect();
    let message = paragraph.join(" ").trim_start_matches("error: ").to_owned();
    let mut failure = Failure::usage(Problem::P7001, message);
    failure.refusal.help = hint(error, Language::English).map(|hint| hint.trim().to_owned());
    let list = failure.to_json();
    if std::env::args_os().nth(1).is_some_and(|verb| verb == "check") {
        // Nobody can be told if printing fails.
        let _ = output::print_json(&list, true);
    } else {
        output::message(&format!("{list:#}\n"));
    }
}

/// The command line, or the exit code after its help or its mistake was printed.
fn command_line() -> Result<CommandLine, Exit> {
    let language = language::before_parsing(std::env::args_os().skip(1));
    let matches = help::in_language(CommandLine::command(), language).try_get_matches();
    matches.and_then(|matches| CommandLine::from_arg_matches(&matches)).map_err(|error| {
        if error.use_stderr() && wants_json() {
            wrong_command_line(&error);
            return Exit::Usage;
        }
        let printed = print_about_the_line(&error, language);
        if let Some(hint) = hint(&error, language) {
            output::message(&hint);
        }
        match error.kind() {
            ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => match printed {
                Ok(()) => Exit::Success,
                Err(failure) => {
                    output::styled(&failure.render(output::colour(), language::spoken()));
                    failure.exit
                }
            },
            _ => Exit::Usage,
        }
    })
}

/// Prints help, version, or what is wrong with the command line, which may hold the name of a file that a pattern of the shell found.
fn print_about_the_line(error: &clap::Error, language: Language) -> Result<(), Failure> {
    let plain = error.render().to_string();
    if visible::hidden(&plain).next().is_some() {
        output::message(&help::error_in(language, &plain));
        return Ok(());
    }
    if language != Language::English && error.use_stderr() {
        let text = if output::colour() { error.render().ansi().to_string() } else { plain };
        output::styled(&help::error_in(language, &text));
        return Ok(());
    }
    output::printed(error.print().and_then(|()| std::io::stdout().flush()))
}

const FILE_AS_VERB: Text = [
    "\n`{0}` is a file or folder. Did you mean `sieben run {0}`?\n",
    "\n`{0}` ist eine Datei oder ein Ordner. War `sieben run {0}` gemeint?\n",
];

/// A file where a verb belongs: people try `sieben main.awl` first.
fn hint(error: &clap::Error, language: Language) -> Option<String> {
    if error.kind() != ErrorKind::InvalidSubcommand {
        return None;
    }
    let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidSubcommand) else { return None };
    Path::new(word).exists().then(|| fill(language, FILE_AS_VERB, &[word]))
}
