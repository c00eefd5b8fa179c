//! Why a command ends without its result: the exit codes and the message behind them.

use sieben_model::problems::Problem;
use sieben_model::visible::visible;

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
    /// The row of the table of problems.
    pub(crate) problem: Problem,
    /// One sentence, lower-case.
    pub(crate) message: String,
    /// What to do, if it is more specific than the help of the problem.
    pub(crate) help: Option<String>,
}

impl Failure {
    /// The command line, or a file that it names, is wrong.
    pub(crate) fn usage(problem: Problem, message: impl Into<String>) -> Self {
        Self { exit: Exit::Usage, problem, message: message.into(), help: None }
    }
    /// Adds what to do.
    pub(crate) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
    /// The message as it is printed when it belongs to no place in a source.
    pub(crate) fn render(&self, colour: bool) -> String {
        self.render_with(colour, "Error", "Help", self.problem.help())
    }
    /// The same with other words for what it is and what to do, and this help where the failure has none of its own.
    pub(crate) fn render_with(&self, colour: bool, error: &str, help_word: &str, help: &str) -> String {
        let help = capitalized(self.help.as_deref().unwrap_or(help));
        let (message, help) = (visible(&self.message), visible(&help));
        let (red, green, plain) = if colour { ("\x1b[31m", "\x1b[38;5;115m", "\x1b[0m") } else { ("", "", "") };
        format!("{red}[{}] {error}:{plain} {message}\n  {green}{help_word}{plain}: {help}\n", self.problem.code())
    }
}

/// A help sentence as it is printed; a word in backticks at its start stays as it is.
pub(crate) fn capitalized(sentence: &str) -> String {
    let mut chars = sentence.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}
