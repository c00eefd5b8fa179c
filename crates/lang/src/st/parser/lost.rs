//! What a lost bracket or name leaves behind: it is told once, and what stands around it is not taken for something else.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::Parser;
use crate::st::ast::{Expression, StatementKind};
use crate::st::lexer::Raw;

impl Parser<'_> {
    /// `x := LEFT IN := s, L := 2);`, behind the first sign: parameters up to a bracket that is not open.
    pub(super) fn bracket_is_lost(&self) -> bool {
        let (mut index, mut open, mut parameters) = (self.at, 0_usize, false);
        loop {
            let token = self.tokens[index];
            match token.raw {
                Raw::End | Raw::Semicolon => return false,
                _ if token.keyword.is_some_and(|keyword| keyword.is_end() || keyword.begins_statement()) => return false,
                Raw::ParenOpen => open += 1,
                Raw::ParenClose if open == 0 => return parameters,
                Raw::ParenClose => open -= 1,
                Raw::Becomes | Raw::Delivers | Raw::Comma if open == 0 => parameters = true,
                _ => {}
            }
            index = self.behind(index);
        }
    }

    /// Tells the bracket of a call that is lost; the statement means nothing else.
    pub(super) fn without_bracket(&mut self, target: &Expression) -> StatementKind {
        // `LEFTIN := s` or `LEFT IN := s` behind the sign, else what stands before it.
        let next = self.behind(self.at);
        let called = self.at_name() && (self.is_name(next) || self.tokens[next].raw == Raw::Becomes);
        let token = self.token();
        let span = if called { self.span(token.start, token.end) } else { target.span };
        let message = "`(` is missing: these are the parameters of a call";
        self.push(Diagnostic::new(Problem::P2030, span, message).help("Write `(` behind the name of what is called."));
        self.skip_statement();
        StatementKind::Missing
    }

    /// `(IN := a, Q => b)`: parameters without the name of what they are for.
    pub(super) fn callee_is_lost(&self, several: bool) -> bool {
        let name = self.behind(self.at);
        let sign = self.tokens[self.behind(name)].raw;
        if self.raw() != Raw::ParenOpen || !self.is_name(name) || !matches!(sign, Raw::Becomes | Raw::Delivers) {
            return false;
        }
        let (mut index, mut open, mut comma) = (name, 1_usize, false);
        while open > 0 {
            match self.tokens[index].raw {
                Raw::End | Raw::Semicolon => return false,
                Raw::ParenOpen => open += 1,
                Raw::ParenClose => open -= 1,
                Raw::Comma => comma |= open == 1,
                _ => {}
            }
            index = self.behind(index);
        }
        comma || !several
    }

    /// Tells the name that is lost, and takes the brackets.
    pub(super) fn without_callee(&mut self) {
        self.unexpected(Problem::P6055, "the name of what is called is missing in front of `(`");
        self.skip_brackets();
    }
}
