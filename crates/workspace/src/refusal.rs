//! What is asked for cannot be done: the problem, in one sentence, and what to do about it.

use sieben_model::problems::Problem;

/// Why something that was asked for is not done. It says nothing about how the caller goes on.
#[derive(Clone, Debug)]
pub struct Refusal {
    /// The row of the table of problems.
    pub problem: Problem,
    /// One sentence, lower-case.
    pub message: String,
    /// What to do, if it is more specific than the help of the problem.
    pub help: Option<String>,
}

impl Refusal {
    /// A refusal with the help of its problem.
    pub fn new(problem: Problem, message: impl Into<String>) -> Self {
        Self { problem, message: message.into(), help: None }
    }
    /// Adds what to do.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
    /// What to do, as it is shown.
    pub fn shown_help(&self) -> String {
        capitalized(self.help.as_deref().unwrap_or(self.problem.help()))
    }
}

/// A help sentence as it is shown; a word in backticks at its start stays as it is.
pub fn capitalized(sentence: &str) -> String {
    let mut chars = sentence.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}
