//! Types of variables.

use sieben_model::block::BlockKind;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::types::DataType;

use super::Parser;
use super::blocks::Keyword;
use crate::stl::ast::{TypeKind, TypeName};
use crate::stl::lexer::{Raw, token};
use crate::stl::syntax::SyntaxKind;

impl Parser<'_> {
    pub(super) fn type_name(&mut self) -> TypeName {
        let start = self.position;
        self.start(SyntaxKind::TypeName);
        let kind = if self.deeper() {
            let kind = self.type_kind();
            self.depth -= 1;
            kind
        } else {
            TypeKind::Missing
        };
        self.finish();
        TypeName { kind, span: self.span(start, self.position.max(start)) }
    }

    fn type_kind(&mut self) -> TypeKind {
        match self.raw {
            Raw::Symbol => return TypeKind::Symbol(self.name_word(SyntaxKind::Symbol).text),
            Raw::Word => {}
            _ => {
                let message = format!("{} is no data type; a type such as INT, STRUCT or ARRAY [1..5] OF INT stands here", self.shown());
                self.error(Problem::P2021, self.position, self.end, message);
                return TypeKind::Missing;
            }
        }
        if self.at_word("STRUCT") {
            return self.structure();
        }
        if self.keyword().is_some() {
            let message = format!("the data type is missing before {}", self.shown());
            self.error(Problem::P2021, self.position, self.end, message);
            return TypeKind::Missing;
        }
        if self.at_word("ARRAY") {
            return self.array();
        }
        if self.at_word("STRING") {
            self.bump(SyntaxKind::Keyword);
            let bracket = self.behind_blanks(self.position);
            if token(self.text, bracket).0 != Raw::BracketOpen {
                return TypeKind::String(None);
            }
            self.blanks();
            self.bump(SyntaxKind::Punctuation);
            self.blanks();
            let length = self.integer();
            if length.is_none() {
                let message = format!("{} is no length of a STRING; write `STRING [254]`", self.shown());
                self.error(Problem::P2021, self.position, self.end, message);
            }
            self.close_bracket();
            return TypeKind::String(length);
        }
        if let Some((kind, number, ..)) = self.kind_and_number() {
            return TypeKind::Block(kind, number);
        }
        let word = self.current().to_ascii_uppercase();
        self.bump(SyntaxKind::Keyword);
        TypeKind::Word(word)
    }

    /// Whether a data type begins at the current token, and nothing that may also be a name.
    pub(super) fn at_type(&self) -> bool {
        match self.raw {
            Raw::Symbol => true,
            Raw::Word => {
                let word = self.current();
                let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
                let block = matches!(
                    BlockKind::from_abbreviation(letters),
                    Some(BlockKind::UserDefinedType | BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock)
                );
                let number = letters.len() < word.len() || self.raw_behind_blanks() == Raw::Number;
                ["STRUCT", "ARRAY", "STRING"].into_iter().any(|word| self.at_word(word)) || is_type(word) || (block && number)
            }
            _ => false,
        }
    }

    pub(super) fn close_bracket(&mut self) {
        self.blanks();
        if self.raw == Raw::BracketClose {
            self.bump(SyntaxKind::Punctuation);
            return;
        }
        let message = format!("{} where `]` closes the bracket", self.shown());
        self.error(Problem::P2016, self.position, self.end, message);
        while !self.at_statement_end() && self.raw != Raw::BracketClose {
            self.bump_unexpected();
        }
        if self.raw == Raw::BracketClose {
            self.bump(SyntaxKind::Punctuation);
        }
    }

    fn structure(&mut self) -> TypeKind {
        self.start(SyntaxKind::Struct);
        let keyword = self.bump(SyntaxKind::Keyword);
        let declarations = self.declarations(false);
        if self.keyword() == Some(Keyword::EndStruct) {
            self.bump(SyntaxKind::Keyword);
        } else {
            self.error(Problem::P2023, keyword.0, keyword.1, "this STRUCT has no `END_STRUCT`");
        }
        self.finish();
        TypeKind::Struct(declarations)
    }

    /// `ARRAY [1..5, 0..3] OF INT`.
    fn array(&mut self) -> TypeKind {
        self.bump(SyntaxKind::Keyword);
        self.trivia();
        let mut bounds = Vec::new();
        if self.raw == Raw::BracketOpen {
            self.bump(SyntaxKind::Punctuation);
            loop {
                self.trivia();
                let low = self.integer();
                self.trivia();
                let range = self.raw == Raw::Range;
                if range {
                    self.bump(SyntaxKind::Punctuation);
                }
                self.trivia();
                let high = if range { self.integer() } else { None };
                if let (Some(low), Some(high)) = (low, high) {
                    bounds.push((low, high));
                } else {
                    let message = format!("{} where the bounds of an array stand; write `ARRAY [1..5] OF INT`", self.shown());
                    self.error(Problem::P2021, self.position, self.end, message);
                    bounds.clear();
                    while !self.at_statement_end() && self.raw != Raw::BracketClose {
                        self.bump_unexpected();
                    }
                    break;
                }
                self.trivia();
                if self.raw != Raw::Comma {
                    break;
                }
                self.bump(SyntaxKind::Punctuation);
            }
            self.close_bracket();
        } else {
            let message = format!("{} where the bounds of an array stand; write `ARRAY [1..5] OF INT`", self.shown());
            self.error(Problem::P2021, self.position, self.end, message);
        }
        self.trivia();
        if self.at_word("OF") {
            self.bump(SyntaxKind::Keyword);
            self.trivia();
        } else if self.at_type() && !bounds.is_empty() {
            let (span, word) = (self.span(self.position, self.end), self.current());
            let message = format!("`OF` is missing before `{word}`, the type of the elements");
            self.report(Diagnostic::new(Problem::P2021, span, message).fix(span, format!("OF {word}"), format!("write `OF {word}`")));
        } else {
            let message = format!("{} where `OF` and the type of the elements stand", self.shown());
            self.error(Problem::P2021, self.position, self.end, message);
            if bounds.is_empty() {
                return TypeKind::Missing;
            }
        }
        let element = Box::new(self.type_name());
        if bounds.is_empty() { TypeKind::Missing } else { TypeKind::Array { bounds, element } }
    }
}

/// Whether a word is the name of a type without more behind it.
pub(super) fn is_type(word: &str) -> bool {
    DataType::from_word(&word.to_ascii_uppercase()).is_some()
}
