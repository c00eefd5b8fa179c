//! What a lost bracket or name leaves behind: it is told once, and what stands around it is not taken for something else.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::Parser;
use super::blocks::is_end_of_block;
use crate::st::ast::{Expression, Statement, StatementKind, TypeKind};
use crate::st::keywords::Keyword;
use crate::st::lexer::{Raw, Token};

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
        // The parameters may stand on lines of their own.
        let mut open = 0_usize;
        while !matches!(self.raw(), Raw::End | Raw::Semicolon) && (open > 0 || self.raw() != Raw::ParenClose) {
            match self.raw() {
                Raw::ParenOpen => open += 1,
                Raw::ParenClose => open -= 1,
                _ => {}
            }
            self.bump_unexpected();
        }
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

    /// `name : INT` or `CONSTANT name : INT` with END_VAR behind it, where no statement was yet.
    pub(super) fn begins_lost_declarations(&self, body: &[Statement]) -> bool {
        let next = self.tokens[self.behind(self.at)];
        let located = next.raw == Raw::Word && self.slice(next).eq_ignore_ascii_case("AT");
        let declares = self.at_name() && (matches!(self.next_raw(), Raw::Colon | Raw::Comma) || located);
        if !body.is_empty() || !declares && !self.at_lost_qualifier() {
            return false;
        }
        let of_types = [
            Keyword::Array,
            Keyword::Of,
            Keyword::True,
            Keyword::False,
            Keyword::Struct,
            Keyword::EndStruct,
            Keyword::Union,
            Keyword::EndUnion,
        ];
        let mut keywords = self.tokens[self.at..].iter().filter_map(|token| token.keyword).filter(|keyword| !of_types.contains(keyword));
        keywords.find(|keyword| keyword.is_end() || keyword.begins_statement() || keyword.begins_section()) == Some(Keyword::EndVar)
    }

    /// METHOD, PROPERTY or ACTION that is missing before the current name: its end comes before the beginning of anything else.
    pub(super) fn lost_member(&mut self) -> Option<Keyword> {
        let next = self.behind(self.at);
        let line_ends = self.begins_line(next) && (self.is_name(next) || self.tokens[next].keyword.is_some());
        if !self.at_name() || !self.begins_line(self.at) || self.tokens[next].raw != Raw::Colon && !line_ends {
            return None;
        }
        let found = self.member_ended_next()?;
        let token = self.token();
        let (word, at) = (found.word(), self.span(token.start, token.start));
        let span = self.span(token.start, token.end);
        let message = format!("`{word}` is missing before {}", self.shown());
        self.report(Diagnostic::new(Problem::P6056, span, message).fix(at, format!("{word} "), format!("write `{word}`")));
        Some(found)
    }

    /// The member whose end comes before the beginning of anything else. What was found holds for every token before it.
    fn member_ended_next(&mut self) -> Option<Keyword> {
        if let Some((seen, found)) = &self.member_end
            && seen.contains(&self.at)
        {
            return *found;
        }
        let mut from_here = self.tokens[self.at..].iter().zip(self.at..);
        let found = from_here.find_map(|(token, at)| match token.keyword? {
            Keyword::EndMethod => Some((at, Some(Keyword::Method))),
            Keyword::EndProperty => Some((at, Some(Keyword::Property))),
            Keyword::EndAction => Some((at, Some(Keyword::Action))),
            Keyword::Method | Keyword::Property | Keyword::Action | Keyword::EndInterface => Some((at, None)),
            keyword if keyword.begins_block() || is_end_of_block(keyword) => Some((at, None)),
            _ => None,
        });
        let (end, found) = found.unwrap_or((self.tokens.len(), None));
        self.member_end = Some((self.at..end, found));
        found
    }

    /// GET or SET of a property that is missing before the current token, by its end; that is said.
    pub(super) fn lost_accessor(&mut self) -> Option<Keyword> {
        let keywords = self.tokens[self.at..].iter().filter_map(|token| token.keyword);
        let end = keywords.into_iter().find(|keyword| {
            matches!(keyword, Keyword::EndGet | Keyword::EndSet | Keyword::EndProperty | Keyword::Property | Keyword::Method)
                || is_end_of_block(*keyword)
        });
        let end = end.filter(|end| matches!(end, Keyword::EndGet | Keyword::EndSet) && !self.at_keyword(*end))?;
        let word = if end == Keyword::EndGet { "GET" } else { "SET" };
        let token = self.token();
        let (at, span) = (self.span(token.start, token.start), self.span(token.start, token.end));
        let message = format!("`{word}` is missing before {}", self.shown());
        self.report(Diagnostic::new(Problem::P6056, span, message).fix(at, format!("{word} "), format!("write `{word}`")));
        Some(end)
    }

    /// `5,3` where an expression ends: a number of another language, which is told.
    pub(super) fn told_decimal_comma(&mut self) -> bool {
        let comma = self.token();
        let digits = |token: Token| token.raw == Raw::Number && self.slice(token).bytes().all(|byte| byte.is_ascii_digit());
        let joined = |first: Token, second: Token| first.end == second.start;
        let around = self.at.checked_sub(1).and_then(|before| Some((self.tokens[before], *self.tokens.get(self.at + 1)?)));
        let Some((whole, parts)) = around.filter(|_| comma.raw == Raw::Comma) else { return false };
        if !(digits(whole) && digits(parts) && joined(whole, comma) && joined(comma, parts)) {
            return false;
        }
        let span = self.span(whole.start, parts.end);
        let number = format!("{}.{}", self.slice(whole), self.slice(parts));
        let message = format!("a number has a decimal point: `{number}`");
        self.report(Diagnostic::new(Problem::P6054, span, message).fix(span, number.clone(), format!("write `{number}`")));
        true
    }

    /// `count++;` of other languages; whether it stands here, which is told.
    pub(super) fn told_increment(&mut self) -> bool {
        let mut index = self.at;
        while !matches!(self.tokens[index].raw, Raw::End | Raw::Semicolon | Raw::Becomes | Raw::ParenOpen | Raw::Newline) {
            index += 1;
        }
        let signs = index.checked_sub(2).map(|first| (self.tokens[first], self.tokens[first + 1]));
        let Some((first, second)) = signs.filter(|_| self.at_name() && self.tokens[index].raw == Raw::Semicolon && index > self.at + 2)
        else {
            return false;
        };
        let sign = match (first.raw, second.raw) {
            (Raw::Plus, Raw::Plus) => "+",
            (Raw::Minus, Raw::Minus) => "-",
            _ => return false,
        };
        let name = self.text[self.token().start as usize..first.start as usize].trim().to_owned();
        let (span, whole) = (self.span(first.start, second.end), self.span(self.token().start, second.end));
        let mended = format!("{name} := {name} {sign} 1");
        let message = format!("`{sign}{sign}` is no operator of ST: did you mean `{mended}`?");
        self.report(Diagnostic::new(Problem::P6052, span, message).fix(whole, mended.clone(), format!("write `{mended}`")));
        self.skip_statement();
        true
    }

    /// Whether nothing but blanks and comments stands before a token on its line.
    pub(super) fn begins_line(&self, index: usize) -> bool {
        let before = self.tokens[..index].iter().rev().find(|token| token.raw == Raw::Newline || !token.raw.is_trivia());
        before.is_none_or(|token| token.raw == Raw::Newline)
    }

    /// Fields of a structure whose STRUCT is missing where a type should stand.
    pub(super) fn structure_is_lost(&self) -> bool {
        let overlap = self.at_word("OVERLAP") && self.is_name(self.behind(self.at));
        let name = if overlap { self.behind(self.at) } else { self.at };
        let next = self.tokens[self.behind(name)];
        let located = next.raw == Raw::Word && self.slice(next).eq_ignore_ascii_case("AT");
        if !self.is_name(name) || !(matches!(next.raw, Raw::Colon | Raw::Comma) || located) {
            return false;
        }
        let mut open = 0_usize;
        for token in &self.tokens[self.at..] {
            match token.keyword {
                Some(Keyword::Struct | Keyword::Union) => open += 1,
                Some(Keyword::EndStruct) if open == 0 => return true,
                Some(Keyword::EndStruct | Keyword::EndUnion) => open = open.saturating_sub(1),
                Some(keyword) if keyword.is_end() || keyword.begins_section() || keyword.begins_block() => return false,
                _ => {}
            }
        }
        false
    }

    /// Tells the STRUCT that is lost, and takes the fields.
    pub(super) fn without_struct(&mut self) -> TypeKind {
        let start = self.here();
        let at = self.span(start, start);
        let span = self.span(start, self.token().end);
        let message = "`STRUCT` is missing before the first field";
        self.report(Diagnostic::new(Problem::P2020, span, message).fix(at, "STRUCT ", "write `STRUCT`"));
        self.lost_structure(start).kind
    }

    /// Whether a label of the CASE around the statements stands here: one of them has lost its end.
    pub(super) fn at_label_of_outer_case(&self) -> bool {
        if !self.awaited.contains(&Keyword::EndCase) || !self.begins_line(self.at) || !self.at_case_label() {
            return false;
        }
        // `name:` may be the label of a jump, where there are any.
        let alone = self.raw() == Raw::Word && self.next_raw() == Raw::Colon;
        let is_jump = |word: &str| word.eq_ignore_ascii_case("GOTO") || word.eq_ignore_ascii_case("JMP");
        !alone || !self.tokens.iter().any(|token| token.raw == Raw::Word && is_jump(self.slice(*token)))
    }

    /// `a = b THEN`: a condition whose IF is missing, and no assignment with a slip.
    pub(super) fn at_lost_condition(&self) -> bool {
        let mut index = self.at;
        while !matches!(self.tokens[index].raw, Raw::End | Raw::Semicolon | Raw::Becomes) {
            if matches!(self.tokens[index].keyword, Some(Keyword::Then | Keyword::Do)) {
                return self.raw() == Raw::Equal;
            }
            index = self.behind(index);
        }
        false
    }
}
