//! Where a body that is a diagram stands: the word LD or FBD alone on its line, as the first word after the declarations.

use std::ops::Range;

use super::Language;
use crate::st::dialect::Dialect;
use crate::st::keywords::Keyword;
use crate::st::lexer::{Raw, Token};

/// What the tokens before one tell: whether the first word of a body may stand here.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::st) enum BodyBegins {
    /// Statements have begun, or nothing has.
    #[default]
    No,
    /// In the head of a block, a method or an action, where its name or a type comes next.
    InHead,
    /// In the head of an action: its name, and a colon that no type follows.
    InAction,
    /// Inside of a section of declarations.
    InSection,
    /// After the head, or after declarations.
    Here,
}

impl BodyBegins {
    /// Takes notice of a token.
    pub(in crate::st) fn see(&mut self, token: Token) {
        if token.raw.is_trivia() {
            return;
        }
        *self = match token.keyword {
            Some(keyword) if keyword.begins_section() => Self::InSection,
            Some(Keyword::EndVar | Keyword::EndConst | Keyword::EndLabel | Keyword::Begin) => Self::Here,
            // The body of a block may stand after its members.
            Some(Keyword::EndMethod | Keyword::EndAction | Keyword::EndProperty) => Self::Here,
            Some(Keyword::Action) => Self::InAction,
            Some(keyword) if keyword.begins_block() || matches!(keyword, Keyword::Method | Keyword::Property) => Self::InHead,
            // SET may follow, which is no keyword.
            Some(Keyword::EndGet | Keyword::EndSet) => Self::InHead,
            Some(keyword) if *self != Self::InSection && (keyword.begins_statement() || keyword.is_end()) => Self::No,
            _ => match (*self, token.raw) {
                (Self::InSection | Self::No, _) => *self,
                (_, Raw::Becomes | Raw::ParenOpen) => Self::No,
                (Self::InAction, _) => Self::InAction,
                (_, Raw::Colon | Raw::Comma | Raw::Equal | Raw::Point) => Self::InHead,
                _ => Self::Here,
            },
        };
    }

    /// The bytes of the networks of a diagram whose first word is at these bytes.
    pub(in crate::st) fn diagram(self, text: &str, word: Range<usize>, dialect: Dialect) -> Option<Range<usize>> {
        if !matches!(self, Self::Here | Self::InAction) || Language::of(text.get(word.clone())?).is_none() {
            return None;
        }
        let line = text[..word.start].rfind(['\n', '\r']).map_or(0, |end| end + 1);
        let rest = text[word.end..].trim_start_matches([' ', '\t']);
        let alone = rest.is_empty() || rest.starts_with(['\n', '\r']) || rest.starts_with("//") || is_word(rest, "NETWORK");
        if !text[line..word.start].trim_start_matches('\u{feff}').trim().is_empty() || !alone || goes_on(rest) {
            return None;
        }
        let end = end(text, word.end, dialect);
        let networks = text[word.end..end].trim();
        let start = word.end + text[word.end..end].len() - text[word.end..end].trim_start().len();
        Some(start..start + networks.len())
    }
}

/// Whether what follows a word makes it a part of a statement or a declaration: a name that is used, and no first word of a body.
fn goes_on(rest: &str) -> bool {
    let mut rest = rest.trim_start();
    while rest.starts_with("//") {
        rest = rest.find(['\n', '\r']).map_or("", |end| rest[end..].trim_start());
    }
    // An index, and no comparison of form B.
    let index = || !rest.lines().next().is_some_and(|line| line.contains("->"));
    rest.starts_with([':', ';', ',', '.', ')', '^', '=', '+', '*', '<', '>', '&']) || rest.starts_with('[') && index()
}

fn is_word(text: &str, word: &str) -> bool {
    text.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word))
        && !text[word.len()..].starts_with(|sign: char| sign.is_alphanumeric() || sign == '_')
}

/// Where the diagram that begins at a byte ends: before the first line that begins with the end of a block, or with another one.
fn end(text: &str, from: usize, dialect: Dialect) -> usize {
    let mut start = from;
    for (number, line) in text[from..].split_inclusive(['\n', '\r']).enumerate() {
        let content = line.trim_start();
        let word = content.find(|sign: char| !(sign.is_alphanumeric() || sign == '_')).map_or(content, |end| &content[..end]);
        let ends = |keyword: Keyword| {
            keyword.is_end() && !keyword.ends_statement()
                || keyword.begins_block()
                || matches!(keyword, Keyword::Method | Keyword::Property | Keyword::Action)
        };
        // The first line is the rest of that of the word.
        if number > 0 && Keyword::of(word, dialect).is_some_and(ends) {
            return start;
        }
        start += line.len();
    }
    text.len()
}
