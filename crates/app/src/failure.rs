//! Why a command ends without its result: the exit codes and the message behind them.

use serde_json::Value;
use sieben_model::language::{Language, Text, pick};
use sieben_model::problems::Problem;
use sieben_model::visible::visible;
use sieben_workspace::finding::{self, Finding, Texts, german_help, said_in};
use sieben_workspace::refusal::Refusal;

/// How a command ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// It did what it was asked.
    Success = 0,
    /// A test or check failed.
    CheckFailed = 1,
    /// The command line is wrong, or a file cannot be read or written.
    Usage = 2,
    /// The program does not compile.
    DoesNotCompile = 3,
    /// The CPU went to STOP.
    Stopped = 4,
    /// The time that it was given is used up.
    BudgetUsedUp = 5,
    /// Our own mistake.
    Internal = 70,
    /// It was told to end by Ctrl+C before it was done.
    Interrupted = 130,
}

/// A command cannot go on.
#[derive(Clone, Debug)]
pub(crate) struct Failure {
    /// The exit code.
    pub(crate) exit: Exit,
    /// What is wrong, and what to do.
    pub(crate) refusal: Refusal,
}

/// What the workspace refuses was asked for on the command line, or in a file that it names.
impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        Self { exit: Exit::Usage, refusal }
    }
}

impl Failure {
    /// The command line, or a file that it names, is wrong.
    pub(crate) fn usage(problem: Problem, message: impl Into<String>) -> Self {
        Refusal::new(problem, message).into()
    }
    /// Adds what to do.
    pub(crate) fn help(mut self, help: impl Into<String>) -> Self {
        self.refusal.help = Some(help.into());
        self
    }
    /// As a list with one finding, which is how `--json` prints all that is wrong.
    pub(crate) fn to_json(&self) -> Value {
        finding::to_json(&[Finding::refused("", self.refusal.clone())], &Texts::default())
    }
    /// The message as it is printed when it belongs to no place in a source.
    pub(crate) fn render(&self, colour: bool, language: Language) -> String {
        let message = said_in(language, self.refusal.problem, &self.refusal.message);
        render(&self.refusal, &message, colour, language)
    }
}

/// What stands before an error.
pub(crate) const ERROR: Text = ["Error", "Fehler"];
/// What stands before a help.
pub(crate) const HELP: Text = ["Help", "Hilfe"];

/// A refusal as it is printed, with this message, and the help of its problem where it has none of its own.
pub(crate) fn render(refusal: &Refusal, message: &str, colour: bool, language: Language) -> String {
    let help = match language {
        Language::English => refusal.shown_help(),
        Language::German => german_help(refusal.problem, refusal.help.as_deref()),
    };
    let help: String = help.lines().map(visible).collect::<Vec<_>>().join("\n  ");
    let (red, green, plain) = if colour { ("\x1b[31m", "\x1b[38;5;115m", "\x1b[0m") } else { ("", "", "") };
    let (error, help_word) = (pick(language, ERROR), pick(language, HELP));
    format!("{red}[{}] {error}:{plain} {}\n  {green}{help_word}{plain}: {help}\n", refusal.problem.code(), visible(message))
}
