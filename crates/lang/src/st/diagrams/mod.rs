//! Bodies that are diagrams: where one stands in a source, and what its networks are as statements of ST.

mod boxes;
pub mod drawn;
pub(in crate::st) mod layout;
pub(in crate::st) mod lower;
pub mod pins;
pub(in crate::st) mod read;
pub(in crate::st) mod text;

use sieben_model::source::Span;

use super::ast;

/// A language that a body is drawn in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Language {
    /// Ladder diagram: the line of a branch goes on from the line to its left.
    Ladder,
    /// Function block diagram: the branches of OR are inputs of a box.
    FunctionBlocks,
}

impl Language {
    /// All languages by the words that a body begins with.
    pub const WORDS: [(&'static str, Self); 3] = [("LD", Self::Ladder), ("LAD", Self::Ladder), ("FBD", Self::FunctionBlocks)];

    /// The language that a word names, without regard to case.
    pub fn of(word: &str) -> Option<Self> {
        Self::WORDS.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)).map(|&(_, language)| language)
    }

    /// Its name in messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ladder => "LD",
            Self::FunctionBlocks => "FBD",
        }
    }
}

/// Where the edges of a body remember what their line was in the last scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::st) enum Memory<'n> {
    /// In the instance of this block.
    Instance(&'n str),
    /// Nowhere: nothing of the block lasts longer than a call.
    None,
}

/// What is known of a body before its networks are read.
#[derive(Clone, Copy, Debug)]
pub(in crate::st) struct Bodies<'n> {
    /// What it is drawn in.
    pub(in crate::st) language: Language,
    /// Where its edges remember.
    pub(in crate::st) memory: Memory<'n>,
    /// How many edge memories the block has already.
    pub(in crate::st) edges: usize,
}

/// What a body of diagrams comes to.
#[derive(Debug, Default)]
pub(in crate::st) struct Lowered {
    /// Its statements.
    pub(in crate::st) statements: Vec<ast::Statement>,
    /// The edge memories that it needs: their names, whether they begin with TRUE, the places of the edges.
    pub(in crate::st) edges: Vec<EdgeMemory>,
    /// The labels of its networks.
    pub(in crate::st) labels: Vec<ast::Name>,
}

/// What an edge remembers.
#[derive(Debug)]
pub(in crate::st) struct EdgeMemory {
    /// The name that no source has.
    pub(in crate::st) name: String,
    /// What it holds before the first scan.
    pub(in crate::st) begins_true: bool,
    /// The place of the edge.
    pub(in crate::st) span: Span,
}
