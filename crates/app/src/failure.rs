//! Why a command ends without its result: the exit codes and the message behind them.

use serde_json::Value;
use sieben_model::problems::Problem;
use sieben_model::visible::visible;
use sieben_workspace::finding::{self, Finding, Texts};
use sieben_workspace::refusal::{Refusal, capitalized};

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
    /// Our own mistake.
    Internal = 70,
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
    pub(crate) fn render(&self, colour: bool) -> String {
        render(&self.refusal, colour, "Error", "Help", self.refusal.problem.help())
    }
}

/// A refusal as it is printed, with these words for what it is and what to do, and this help where it has none of its own.
pub(crate) fn render(refusal: &Refusal, colour: bool, error: &str, help_word: &str, help: &str) -> String {
    let help = capitalized(refusal.help.as_deref().unwrap_or(help));
    let (message, help) = (visible(&refusal.message), visible(&help));
    let (red, green, plain) = if colour { ("\x1b[31m", "\x1b[38;5;115m", "\x1b[0m") } else { ("", "", "") };
    format!("{red}[{}] {error}:{plain} {message}\n  {green}{help_word}{plain}: {help}\n", refusal.problem.code())
}
