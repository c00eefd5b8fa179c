//! What is not said because it may follow from a declaration that cannot be read (decisions 229 and 270).

use std::collections::HashSet;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Sources};

use super::keywords::Keyword;
use super::lexer::{Raw, Token};
use super::parser::{Parsed, name_is_lost};
use crate::scope::key;

/// Mistakes that leave it open where a block of ST begins and ends: what is declared in it is not known.
#[rustfmt::skip] // A table.
const LOSES_BLOCKS: &[Problem] = &[
    Problem::P2010, Problem::P2011, Problem::P2012, Problem::P2013, Problem::P2019, Problem::P2023,
];

/// What is said of names that may well be declared there: nothing, until the block can be read.
#[rustfmt::skip] // A table.
const OF_LOST_BLOCKS: &[Problem] = &[
    Problem::P3001, Problem::P3007, Problem::P3008, Problem::P3009, Problem::P3010, Problem::P3015, Problem::P6217, Problem::P6218, Problem::P6219,
    Problem::P6280, Problem::P6281, Problem::P6282, Problem::P6283, Problem::P6286, Problem::P6310, Problem::P6311, Problem::P6312,
];

/// Mistakes of a declaration whose block is understood.
const LOSES_DECLARATIONS: &[Problem] = &[Problem::P2020, Problem::P2021];

/// What is said of data blocks, parameters and paths that such a declaration may declare: nothing, until it can be read.
const OF_LOST_DECLARATIONS: &[Problem] = &[Problem::P3008, Problem::P3009, Problem::P6219, Problem::P6310, Problem::P6311];

/// What is said of a name, a field or a type: nothing, if its word stands in the section of that declaration.
const OF_LOST_NAMES: &[Problem] = &[Problem::P3001, Problem::P3007, Problem::P3015];

/// What is not known because the sources of ST have mistakes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Untold {
    /// The sources of ST.
    files: HashSet<FileId>,
    blocks: bool,
    declarations: bool,
    /// The name itself is missing in a declaration: it may be any.
    any_name: bool,
    /// Words of the sections with such declarations.
    words: HashSet<String>,
}

impl Untold {
    /// What is not known because of the mistakes of a source.
    pub(crate) fn of(file: FileId, parsed: &Parsed, text: &str) -> Self {
        let mut untold = Self { files: HashSet::from([file]), ..Self::default() };
        untold.look(parsed, text);
        untold
    }

    /// Takes in what is not known because of another source.
    pub(crate) fn add(&mut self, other: &Self) {
        self.files.extend(&other.files);
        self.blocks |= other.blocks;
        self.declarations |= other.declarations;
        self.any_name |= other.any_name;
        self.words.extend(other.words.iter().cloned());
    }

    fn look(&mut self, parsed: &Parsed, text: &str) {
        self.blocks |= parsed.diagnostics.iter().any(|one| LOSES_BLOCKS.contains(&one.problem));
        for lost in parsed.diagnostics.iter().filter(|one| LOSES_DECLARATIONS.contains(&one.problem)) {
            self.declarations = true;
            self.any_name |= name_is_lost(lost);
            for token in section_around(parsed.tokens(), lost.span.start) {
                if let Some(word) = text.get(token.start as usize..token.end as usize) {
                    self.words.insert(word_of(word));
                }
            }
        }
    }

    /// Whether a message may be no consequence of those mistakes.
    pub(crate) fn lets_through(&self, diagnostic: &Diagnostic, sources: &Sources) -> bool {
        let problem = diagnostic.problem;
        if !self.files.contains(&diagnostic.span.file) {
            return true;
        }
        if self.blocks {
            return !OF_LOST_BLOCKS.contains(&problem);
        }
        if !self.declarations {
            return true;
        }
        if !OF_LOST_NAMES.contains(&problem) {
            return !OF_LOST_DECLARATIONS.contains(&problem);
        }
        let path = sources.slice(diagnostic.span);
        !self.any_name && !path.split('.').any(|word| self.words.contains(&word_of(word)))
    }
}

/// A name without its marks, as names are compared.
fn word_of(written: &str) -> String {
    key(written.trim().trim_matches(['"', '#', '`']))
}

/// The words of the section, or of the header, that has a mistake at this place.
fn section_around(tokens: &[Token], place: u32) -> impl Iterator<Item = &Token> {
    let at = tokens.partition_point(|token| token.start < place);
    let begins = |token: &Token| token.keyword.is_some_and(|keyword| keyword.begins_section() || keyword.begins_block());
    let ends = |token: &Token| {
        let of_declarations = [Keyword::EndVar, Keyword::EndConst, Keyword::EndType];
        token.keyword.is_some_and(|keyword| of_declarations.contains(&keyword) || keyword.begins_block())
    };
    let first = tokens[..at].iter().rposition(begins).unwrap_or_default();
    let last = tokens[at..].iter().position(ends).map_or(tokens.len(), |behind| at + behind);
    tokens[first..last].iter().filter(|token| matches!(token.raw, Raw::Word | Raw::Local | Raw::Quoted | Raw::Backquoted))
}
