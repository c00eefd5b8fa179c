//! Bodies of blocks in the textual forms of sequential function charts and of instruction list: one message, and nothing of them is read.

use sieben_model::problems::Problem;

use super::Parser;
use super::blocks::is_end_of_block;
use crate::st::ast::{Statement, StatementKind};
use crate::st::dialect::{Construct, Judgement};
use crate::st::keywords::Keyword;
use crate::st::lexer::Raw;

/// Instructions with which an instruction list begins.
const INSTRUCTIONS: &[&str] = &["LD", "LDN", "CAL", "CALC", "CALCN", "JMP", "JMPC", "JMPCN", "RET", "RETC", "RETCN"];

impl Parser<'_> {
    /// Skips a body that is not Structured Text, and says what it is; whether there was one.
    pub(super) fn other_language(&mut self, before: &[Statement]) -> bool {
        // A label stands on the line of its instruction.
        let labelled = matches!(before.last(), Some(Statement { kind: StatementKind::Label(_), .. }));
        if self.dialect.judge(Construct::Program) != Judgement::Accept || !self.at_name() || !(labelled || self.begins_line(self.at)) {
            return false;
        }
        let what = match () {
            () if self.begins_chart() => "a sequential function chart",
            () if self.begins_list(before) => "an instruction list",
            () => return false,
        };
        let (message, help) =
            (format!("{what} is not read as text"), "Write the block in Structured Text: a CASE over the steps, or IF and assignments.");
        let token = self.token();
        let span = self.span(token.start, token.end);
        self.push(sieben_model::diagnostic::Diagnostic::new(Problem::P6331, span, message).help(help));
        while self.raw() != Raw::End {
            if self.keyword().is_some_and(|keyword| keyword.begins_block() || is_end_of_block(keyword) || keyword == Keyword::EndMethod) {
                break;
            }
            self.bump_unexpected();
        }
        true
    }

    /// `INITIAL_STEP Start:`, `STEP Fill:`, `TRANSITION FROM Start TO Fill`.
    fn begins_chart(&self) -> bool {
        let next = self.behind(self.at);
        let step = ["INITIAL_STEP", "STEP"].iter().any(|word| self.at_word(word));
        let named = self.is_name(next) && self.tokens[self.behind(next)].raw == Raw::Colon;
        let from = self.is_name(next) && self.slice(self.tokens[next]).eq_ignore_ascii_case("FROM");
        step && named || self.at_word("TRANSITION") && from
    }

    /// `LD x`, `CAL timer(IN := x)`, where nothing but labels stands before it.
    fn begins_list(&self, before: &[Statement]) -> bool {
        let next = self.tokens[self.behind(self.at)];
        let same_line = !self.text[self.token().end as usize..next.start as usize].contains(['\n', '\r']);
        let operand = matches!(next.raw, Raw::Word | Raw::Number | Raw::Literal | Raw::Percent | Raw::Characters) && same_line;
        let instruction = INSTRUCTIONS.iter().any(|word| self.at_word(word));
        let only_labels = before.iter().all(|statement| matches!(statement.kind, StatementKind::Label(_)));
        instruction && operand && only_labels && !self.declared.contains(&self.current().to_uppercase())
    }
}
