//! Paths behind a name: `.field[1, 2]`.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::Parser;
use crate::stl::ast::PathElement;
use crate::stl::lexer::{Raw, token};
use crate::stl::syntax::SyntaxKind;

impl Parser<'_> {
    /// `.field[1, 2]` as often as it comes, without blanks.
    pub(super) fn path(&mut self, path: &mut Vec<PathElement>) {
        loop {
            match self.raw {
                Raw::Point => {
                    let (raw, _) = token(self.text, self.end);
                    if !matches!(raw, Raw::Word | Raw::Symbol | Raw::Local | Raw::Number) {
                        let message = "a field name stands behind the point".to_owned();
                        self.error(Problem::P2018, self.position, self.end, message);
                        self.bump(SyntaxKind::Unexpected);
                        return;
                    }
                    self.bump(SyntaxKind::Punctuation);
                    path.push(PathElement::Field(self.name_word(SyntaxKind::Name)));
                }
                Raw::BracketOpen => {
                    let start = self.position;
                    self.bump(SyntaxKind::Punctuation);
                    let mut indices = Vec::new();
                    loop {
                        self.blanks();
                        match self.integer() {
                            Some(index) => indices.push(index),
                            None => {
                                self.no_index();
                                break;
                            }
                        }
                        self.blanks();
                        if self.raw != Raw::Comma {
                            break;
                        }
                        self.bump(SyntaxKind::Punctuation);
                    }
                    self.close_bracket();
                    path.push(PathElement::Index(indices, self.span(start, self.position)));
                }
                _ => return,
            }
        }
    }

    /// Something else than a whole number where an index stands, up to the end of the bracket.
    fn no_index(&mut self) {
        let message = format!("{} is no index; an index is a whole number", self.shown());
        let mut diagnostic = Diagnostic::new(Problem::P2018, self.span(self.position, self.end), message);
        if matches!(self.raw, Raw::Local | Raw::Symbol | Raw::Word) {
            diagnostic =
                diagnostic.help("STL has no variable indices: compute the address, load it with `LAR1`, and access with `[AR1,P#0.0]`");
        }
        self.report(diagnostic);
        while !self.at_statement_end() && !matches!(self.raw, Raw::BracketClose | Raw::Comma | Raw::ParenClose) {
            self.bump_unexpected();
        }
    }
}
