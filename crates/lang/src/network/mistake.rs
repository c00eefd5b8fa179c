//! What is wrong with a diagram: which kind of mistake, where, and a sentence.

use sieben_model::problems::Problem;

/// A mistake in a diagram.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// Which kind.
    pub kind: MistakeKind,
    /// Its first byte in the text.
    pub start: usize,
    /// The byte after its last one.
    pub end: usize,
    /// What is wrong, in a sentence that begins in lower case.
    pub message: String,
    /// What to do, if it is known.
    pub help: Option<String>,
}

impl Mistake {
    /// A mistake without help.
    pub fn new(kind: MistakeKind, start: usize, end: usize, message: impl Into<String>) -> Self {
        Self { kind, start, end, message: message.into(), help: None }
    }

    /// A mistake whose message says after `; ` what to do.
    pub fn told(kind: MistakeKind, start: usize, end: usize, message: &str) -> Self {
        match message.split_once("; ") {
            Some((message, help)) => Self::new(kind, start, end, message).help(help),
            None => Self::new(kind, start, end, message),
        }
    }

    /// With what to do.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

/// Kinds of mistakes; each is a problem code of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MistakeKind {
    /// A word that names no element.
    Word,
    /// An operand that is missing, or one too many.
    Operand,
    /// A pin that the box does not have, has twice, or that nothing is wired to.
    Pin,
    /// A wire that leads nowhere: logic without a coil, a branch without its end.
    Open,
    /// A branch without an element: a short circuit.
    Short,
    /// An element that may not stand where it stands.
    Position,
    /// An element that only FBD has, in LAD.
    OnlyFbd,
    /// A diagram on one line that is not understood.
    Line,
    /// Too many elements, or nested too deep.
    Size,
}

impl MistakeKind {
    /// Its problem code.
    pub fn problem(self) -> Problem {
        match self {
            Self::Word => Problem::P2401,
            Self::Operand => Problem::P2402,
            Self::Pin => Problem::P2403,
            Self::Open => Problem::P2404,
            Self::Short => Problem::P2405,
            Self::Position => Problem::P2406,
            Self::OnlyFbd => Problem::P2407,
            Self::Size => Problem::P2408,
            Self::Line => Problem::P2409,
        }
    }
}
