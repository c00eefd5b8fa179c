//! What an editor asks of one source alone, right or wrong: its outline, its tokens, what folds, what a selection grows to.
//!
//! Places are bytes of the text. Nothing here knows of other sources.

pub mod folding;
pub mod outline;
mod outline_st;
pub mod selection;
pub mod tokens;

use std::borrow::Cow;

use sieben_lang::codesys_files;
use sieben_lang::language::Language;
use sieben_lang::{st, stl};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Span};

/// Bytes of a text, from and to.
pub type Place = (usize, usize);

/// A source as its parser understood it.
pub struct Text<'t> {
    /// The text that was parsed. In a file of CODESYS or TwinCAT it is that of its Structured Text, each byte in its place.
    text: Cow<'t, str>,
    tree: Tree,
}

enum Tree {
    Stl(stl::Parsed),
    St(st::Parsed),
}

impl<'t> Text<'t> {
    /// Parses a source.
    pub fn parse(name: &str, text: &'t str, language: Language, mnemonics: Option<Mnemonics>) -> Self {
        let file = FileId(0);
        match language {
            Language::Stl | Language::Diagram(_) => {
                let parsed = stl::parser::parse_as(file, text, mnemonics, language.drawing());
                Self { text: text.into(), tree: Tree::Stl(parsed) }
            }
            Language::St(dialect) => {
                let text = codesys_files::read(file, name, text).map_or(Cow::Borrowed(text), |read| read.text.into());
                let parsed = st::parse(file, &text, dialect);
                Self { text, tree: Tree::St(parsed) }
            }
        }
    }

    /// The text of a place.
    fn slice(&self, place: Place) -> &str {
        self.text.get(place.0..place.1).unwrap_or_default()
    }
}

fn place(span: Span) -> Place {
    (span.start as usize, span.end as usize)
}

fn place_of(range: rowan::TextRange) -> Place {
    (range.start().into(), range.end().into())
}
