//! What the tools say about the user's source.

use crate::problems::Problem;
use crate::source::Span;

/// How bad a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The program can run; the user should know.
    Warning,
    /// The program cannot run.
    Error,
}

/// How sure a fix is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// Nothing else can have been meant: a tool may apply it unasked.
    Certain,
    /// A likely name among several; the user has to decide.
    Guess,
}

/// A replacement of text that would mend the problem.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What to replace.
    pub span: Span,
    /// The new text.
    pub replacement: String,
    /// What the fix does, as an order: "write `O`".
    pub title: String,
    /// Whether it may be applied unasked.
    pub certainty: Certainty,
}

/// One message about a place in a source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Which problem: code, severity and page.
    pub problem: Problem,
    /// One sentence about what is wrong here, lower-case, the user's words in backticks.
    pub message: String,
    /// The place.
    pub span: Span,
    /// What to do, if it is more specific than the help of the problem.
    pub help: Option<String>,
    /// A mechanical fix, if there is one.
    pub fix: Option<Fix>,
    /// Other places that belong to it, with a word each.
    pub related: Vec<(Span, String)>,
    /// Whether another file may define what is missing here: one file alone does not tell.
    pub may_be_elsewhere: bool,
}

impl Diagnostic {
    /// A diagnostic without help, fix or related places.
    pub fn new(problem: Problem, span: Span, message: impl Into<String>) -> Self {
        Self { problem, message: message.into(), span, help: None, fix: None, related: Vec::new(), may_be_elsewhere: false }
    }
    /// Adds what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
    /// Adds a fix that nothing speaks against.
    #[must_use]
    pub fn fix(mut self, span: Span, replacement: impl Into<String>, title: impl Into<String>) -> Self {
        self.fix = Some(Fix { span, replacement: replacement.into(), title: title.into(), certainty: Certainty::Certain });
        self
    }
    /// Adds what was probably meant.
    #[must_use]
    pub fn guess(mut self, span: Span, replacement: impl Into<String>, title: impl Into<String>) -> Self {
        self.fix = Some(Fix { span, replacement: replacement.into(), title: title.into(), certainty: Certainty::Guess });
        self
    }
    /// Adds another place.
    #[must_use]
    pub fn related(mut self, span: Span, word: impl Into<String>) -> Self {
        self.related.push((span, word.into()));
        self
    }
    /// Says that another file may define what is missing.
    #[must_use]
    pub fn elsewhere(mut self) -> Self {
        self.may_be_elsewhere = true;
        self
    }
    /// Error or warning.
    pub fn severity(&self) -> Severity {
        self.problem.severity()
    }
}
