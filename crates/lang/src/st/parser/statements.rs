//! Statements.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::super::ast::{AssignOperator, Branch, CaseArm, CaseLabel, Expression, ExpressionKind, ForLoop, Statement, StatementKind};
use super::super::dialect::{Construct, Judgement};
use super::super::keywords::Keyword;
use super::super::lexer::Raw;
use super::{Parser, SyntaxKind};

/// What a list of statements stands in, as far as it tells where the list ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Inside {
    /// A block, a branch, a loop.
    Body,
    /// An arm of CASE: the next label ends it.
    Case,
}

impl Parser<'_> {
    /// Statements up to a keyword that ends them, as the body of another one.
    fn body(&mut self, inside: Inside) -> Vec<Statement> {
        self.start(SyntaxKind::Body);
        let mut statements = Vec::new();
        while !(self.at_body_end() || inside == Inside::Case && self.at_case_label() || self.at_label_of_outer_case()) {
            self.statement_into(&mut statements);
        }
        self.finish();
        statements
    }

    /// Whether the current token ends a list of statements.
    pub(super) fn at_body_end(&self) -> bool {
        match self.keyword() {
            _ if self.raw() == Raw::End => true,
            Some(keyword) => {
                keyword.is_end()
                    || keyword.begins_block()
                    || keyword.begins_section()
                    || matches!(keyword, Keyword::Elsif | Keyword::Else | Keyword::Until | Keyword::Catch | Keyword::Finally)
                    || matches!(keyword, Keyword::Begin | Keyword::Method | Keyword::Property | Keyword::Action)
            }
            None => false,
        }
    }

    /// One statement with its `;`; it always takes something.
    pub(super) fn statement_into(&mut self, statements: &mut Vec<Statement>) {
        let start = self.here();
        let first = self.at;
        self.too_high = false;
        let checkpoint = self.checkpoint();
        let kind = self.statement_kind();
        let span = self.since(start);
        if let Some(kind) = kind {
            let ended = matches!(kind, StatementKind::Label(_) | StatementKind::Empty);
            // Labels of the block end with their colon, regions with their keyword.
            let free = matches!(kind, StatementKind::Region { .. });
            let compound = matches!(
                kind,
                StatementKind::If { .. }
                    | StatementKind::Case { .. }
                    | StatementKind::For(_)
                    | StatementKind::While { .. }
                    | StatementKind::Repeat { .. }
                    | StatementKind::Try { .. }
            );
            statements.push(Statement { kind, span });
            if free {
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            } else if !ended {
                self.statement_end(compound);
            }
        }
        self.start_at(checkpoint, SyntaxKind::Statement);
        self.finish();
        if self.at == first && self.raw() != Raw::End {
            let told = self.keyword().is_some_and(|keyword| self.refused.contains(&keyword));
            if !told {
                let shown = self.shown();
                self.unexpected(Problem::P6054, format!("{shown} begins no statement"));
            }
            self.bump_unexpected();
            if told || self.raw() == Raw::Becomes {
                self.skip_statement();
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            }
        }
    }

    /// Takes the `;` of a statement, or says where it is missing.
    fn statement_end(&mut self, compound: bool) {
        if self.eat(Raw::Semicolon, SyntaxKind::Semicolon) {
            return;
        }
        let behind = self.previous_text();
        if compound && self.dialect.judge(Construct::EndWithoutSemicolon) != Judgement::Reject {
            return;
        }
        let next_statement = self.on_new_line() || self.raw() == Raw::End || self.at_body_end();
        let begins = self.keyword().is_some_and(|keyword| keyword.begins_statement());
        if next_statement || begins {
            self.missing(Problem::P6053, ";", format!("`;` is missing behind {behind}"));
            return;
        }
        if self.told_decimal_comma() {
            self.skip_statement();
            self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            return;
        }
        let shown = self.shown();
        let message = match self.raw() {
            Raw::ParenClose | Raw::BracketClose => format!("{shown} closes a bracket that is not open"),
            _ if self.at_name() => format!("`;` or an operator is missing between {behind} and {shown}"),
            _ => format!("{shown} does not belong here: an operator or `;` is wanted behind {behind}"),
        };
        self.unexpected(Problem::P6054, message);
        self.skip_statement();
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
    }

    /// Skips to the `;` of the statement, or to a keyword that begins or ends one.
    pub(super) fn skip_statement(&mut self) {
        let mut open = 0_usize;
        loop {
            match self.raw() {
                Raw::End | Raw::Semicolon => return,
                Raw::ParenOpen | Raw::BracketOpen => open += 1,
                Raw::ParenClose | Raw::BracketClose => open = open.saturating_sub(1),
                Raw::Word => {
                    let begins = self.keyword().is_some_and(|keyword| keyword.begins_statement());
                    if begins || self.at_body_end() {
                        return;
                    }
                    // A line that begins with an assignment or a call is the next statement.
                    if open == 0 && self.on_new_line() && matches!(self.next_raw(), Raw::Becomes | Raw::ParenOpen) {
                        return;
                    }
                }
                _ => {}
            }
            self.bump_unexpected();
        }
    }

    fn statement_kind(&mut self) -> Option<StatementKind> {
        if self.told_increment() {
            return Some(StatementKind::Missing);
        }
        if let Some(keyword) = self.keyword() {
            match keyword {
                Keyword::If | Keyword::Case | Keyword::For | Keyword::While | Keyword::Repeat | Keyword::Region | Keyword::Try => {
                    if !self.deeper() {
                        self.skip_nested();
                        return Some(StatementKind::Missing);
                    }
                    let kind = match keyword {
                        Keyword::If => self.if_statement(),
                        Keyword::Case => self.case_statement(),
                        Keyword::For => self.for_statement(),
                        Keyword::While => self.while_statement(),
                        Keyword::Repeat => self.repeat_statement(),
                        Keyword::Region => self.region(),
                        _ => self.try_statement(),
                    };
                    self.depth -= 1;
                    return Some(kind);
                }
                Keyword::Exit | Keyword::Continue => {
                    self.bump(SyntaxKind::Keyword);
                    return Some(if keyword == Keyword::Exit { StatementKind::Exit } else { StatementKind::Continue });
                }
                Keyword::Return => {
                    self.bump(SyntaxKind::Keyword);
                    if self.raw() != Raw::Semicolon && !self.on_new_line() && !self.at_body_end() {
                        let token = self.token();
                        self.expression();
                        let help = "assign the value to the name of the function, then write `RETURN;`";
                        let span = self.since(token.start);
                        self.push(Diagnostic::new(Problem::P6064, span, "RETURN has no value in ST").help(help));
                    }
                    return Some(StatementKind::Return);
                }
                Keyword::Goto | Keyword::Jmp => return Some(self.jump()),
                Keyword::Then | Keyword::Do | Keyword::Of | Keyword::To | Keyword::By => return None,
                _ => {}
            }
        }
        match self.raw() {
            Raw::Semicolon => {
                self.bump(SyntaxKind::Semicolon);
                Some(StatementKind::Empty)
            }
            Raw::Word if self.at_word("GOTO") || self.at_word("JMP") => match self.is_name(self.behind(self.at)) {
                true => Some(self.jump()),
                false => self.simple_statement(),
            },
            Raw::Word
                if self.at_word("REGION") && !matches!(self.next_raw(), Raw::Becomes | Raw::ParenOpen | Raw::Point | Raw::BracketOpen) =>
            {
                Some(self.region())
            }
            _ => self.simple_statement(),
        }
    }

    fn jump(&mut self) -> StatementKind {
        let token = self.token();
        let construct = if self.at_word("GOTO") { Construct::Goto } else { Construct::Jmp };
        self.judge(construct, token.start, token.end);
        self.bump(SyntaxKind::Keyword);
        match self.declared_name("a label") {
            Some(label) => StatementKind::Goto(label),
            None => StatementKind::Missing,
        }
    }

    /// An assignment, a call, or a label.
    fn simple_statement(&mut self) -> Option<StatementKind> {
        let start = self.here();
        if let Some(mock) = self.mock() {
            return Some(mock);
        }
        if self.callee_is_lost(false) {
            self.without_callee();
            return Some(StatementKind::Missing);
        }
        if self.at_name() && self.next_raw() == Raw::Colon && !self.colon_is_slip() {
            let label = self.name(SyntaxKind::Declared);
            self.bump(SyntaxKind::Punctuation);
            return Some(StatementKind::Label(label));
        }
        let reported = self.reported;
        let target = self.target();
        if matches!(target.kind, ExpressionKind::Missing) && self.reported == self.at && reported != self.at {
            // The message about the missing operand says it all; what follows up to `;` belongs to it.
            if !self.at_body_end() {
                self.skip_statement();
            }
            return (self.previous > start).then_some(StatementKind::Missing);
        }
        let condition = self.at_lost_condition();
        if !condition && let Some(operator) = self.assign_operator() {
            return Some(self.assignment(target, operator));
        }
        let parameter = self.at_name() && !self.on_new_line() && matches!(self.next_raw(), Raw::Becomes | Raw::Delivers);
        if parameter && self.bracket_is_lost() {
            return Some(self.without_bracket(&target));
        }
        // The first keyword of a statement may be what is missing.
        match self.keyword() {
            Some(Keyword::Then) => {
                self.without_first(Keyword::If, &target);
                return Some(self.if_branches(target));
            }
            Some(Keyword::Do) => {
                self.without_first(Keyword::While, &target);
                return Some(self.while_body(target));
            }
            Some(Keyword::Of) => {
                self.without_first(Keyword::Case, &target);
                return Some(self.case_arms(target));
            }
            _ => {}
        }
        let equal = condition.then(|| (1, self.here()));
        if let Some((sign, start)) = equal.or_else(|| self.operator_here()) {
            // `a < b THEN`, or a comparison that stands alone.
            let left = target.span;
            let rest = self.rest_of_expression(target);
            if self.at_keyword(Keyword::Then) {
                self.without_first(Keyword::If, &rest);
                return Some(self.if_branches(rest));
            }
            if self.at_keyword(Keyword::Do) {
                self.without_first(Keyword::While, &rest);
                return Some(self.while_body(rest));
            }
            let message = "an expression alone does nothing; an assignment is written `:=`";
            let span = left.to(self.span(start, start + sign as u32));
            self.push(Diagnostic::new(Problem::P6054, span, message));
            return Some(StatementKind::Missing);
        }
        if !matches!(target.kind, ExpressionKind::Call(_) | ExpressionKind::Missing) && self.raw() == Raw::Semicolon {
            let message = format!("{} alone does nothing: a call has brackets `()`, an assignment `:=`", self.previous_text());
            // Calls without brackets are told from other expressions by who knows the names.
            let element =
                matches!(target.kind, ExpressionKind::Index(..)) && self.dialect.judge(Construct::ValueStatement) != Judgement::Reject;
            if !element && !matches!(target.kind, ExpressionKind::Name(_) | ExpressionKind::Member(..) | ExpressionKind::Dereference(_)) {
                self.push(Diagnostic::new(Problem::P6054, target.span, message));
                return Some(StatementKind::Missing);
            }
        }
        Some(StatementKind::Expression(target))
    }

    /// `a : = 5`: the colon belongs to an assignment.
    fn colon_is_slip(&self) -> bool {
        let colon = self.behind(self.at);
        self.tokens[self.behind(colon)].raw == Raw::Equal
    }

    fn without_first(&mut self, keyword: Keyword, condition: &Expression) {
        let word = keyword.word();
        let at = self.span(condition.span.start, condition.span.start);
        let message = format!("`{word}` is missing before this expression");
        self.report(Diagnostic::new(Problem::P6056, condition.span, message).fix(at, format!("{word} "), format!("write `{word}`")));
    }

    /// The width and place of an operator at the current token.
    fn operator_here(&self) -> Option<(usize, u32)> {
        use Raw::{Ampersand, Foreign, Greater, GreaterEqual, Less, LessEqual, Minus, NotEqual, Plus, Power, Slash, Star};
        let token = self.token();
        let sign = matches!(
            token.raw,
            Power | Star | Slash | Plus | Minus | Less | LessEqual | Greater | GreaterEqual | NotEqual | Ampersand | Foreign
        );
        let word = matches!(token.keyword, Some(Keyword::And | Keyword::Or | Keyword::Xor | Keyword::Mod | Keyword::Div));
        ((sign || word) && !(self.on_new_line() && token.raw == Raw::Minus)).then(|| ((token.end - token.start) as usize, token.start))
    }

    /// An assignment operator, or a slip for one.
    fn assign_operator(&mut self) -> Option<AssignOperator> {
        let token = self.token();
        let whole = self.span(token.start, token.end);
        let construct = |operator, construct| Some((operator, Some(construct)));
        let found = match token.raw {
            Raw::Becomes => {
                if self.joined_with(Raw::Greater) {
                    let span = self.span(token.start, token.end + 1);
                    self.slip(Problem::P2007, span, ":=", "`:=>` is no assignment sign; an assignment is written `:=`");
                    self.bump(SyntaxKind::Operator);
                } else if self.joined_with(Raw::Equal) {
                    let span = self.span(token.start, token.end + 1);
                    self.slip(Problem::P2007, span, ":=", "`:==` is no assignment sign; an assignment is written `:=`");
                    self.bump(SyntaxKind::Operator);
                }
                Some((AssignOperator::Becomes, None))
            }
            Raw::Combined => construct(
                match self.current().as_bytes()[0] {
                    b'+' => AssignOperator::Add,
                    b'-' => AssignOperator::Subtract,
                    b'*' => AssignOperator::Multiply,
                    _ => AssignOperator::Divide,
                },
                Construct::CombinedAssignment,
            ),
            Raw::Attempt => construct(AssignOperator::Attempt, Construct::AttemptAssignment),
            Raw::Word if self.joined_with(Raw::Equal) => {
                let operator = match self.current() {
                    word if word.eq_ignore_ascii_case("S") => AssignOperator::Set,
                    word if word.eq_ignore_ascii_case("R") => AssignOperator::Reset,
                    word if word.eq_ignore_ascii_case("REF") => AssignOperator::Refer,
                    _ => return None,
                };
                self.judge(Construct::SetAssignment, token.start, token.end + 1);
                self.bump(SyntaxKind::Operator);
                Some((operator, None))
            }
            Raw::Equal if self.joined_with(Raw::Colon) => {
                let span = self.span(token.start, token.end + 1);
                self.slip(Problem::P2007, span, ":=", "`=:` is no assignment sign; an assignment is written `:=`");
                self.bump(SyntaxKind::Operator);
                Some((AssignOperator::Becomes, None))
            }
            Raw::Equal | Raw::Delivers => {
                let message = format!("{} is no assignment sign; an assignment is written `:=`", self.shown());
                self.slip(Problem::P2007, whole, ":=", message);
                Some((AssignOperator::Becomes, None))
            }
            Raw::Foreign if self.current() == "==" => {
                self.slip(Problem::P2007, whole, ":=", "`==` is no assignment sign; an assignment is written `:=`");
                Some((AssignOperator::Becomes, None))
            }
            // `a : = 5`.
            Raw::Colon if self.next_raw() == Raw::Equal => {
                let end = self.tokens[self.behind(self.at)].end;
                let span = self.span(token.start, end);
                self.slip(Problem::P2007, span, ":=", "the two characters of `:=` stand together");
                self.bump(SyntaxKind::Operator);
                Some((AssignOperator::Becomes, None))
            }
            _ => None,
        };
        let (operator, construct) = found?;
        if let Some(construct) = construct {
            self.judge(construct, token.start, token.end);
        }
        self.bump(SyntaxKind::Operator);
        Some(operator)
    }

    fn assignment(&mut self, target: Expression, operator: AssignOperator) -> StatementKind {
        if self.bracket_is_lost() {
            return self.without_bracket(&target);
        }
        let mut targets = vec![target];
        let mut value = self.expression();
        while self.raw() == Raw::Becomes && operator == AssignOperator::Becomes {
            let token = self.token();
            self.judge(Construct::ChainedAssignment, token.start, token.end);
            self.bump(SyntaxKind::Operator);
            targets.push(value);
            value = self.expression();
        }
        // `i := 1 TO 5 DO` without its FOR.
        if self.at_keyword(Keyword::To) && targets.len() == 1 {
            let variable = targets.remove(0);
            self.without_first(Keyword::For, &variable);
            return self.for_rest(variable, value);
        }
        StatementKind::Assign { targets, operator, value }
    }

    /// An expression that decides, up to its keyword.
    fn condition(&mut self, keyword: Keyword) -> Expression {
        let mut condition = self.expression();
        if self.raw() == Raw::Becomes {
            let token = self.token();
            let span = self.span(token.start, token.end);
            let message = "`:=` assigns; a comparison is written `=`";
            self.push(Diagnostic::new(Problem::P6052, span, message).fix(span, "=", "write `=`"));
            self.bump(SyntaxKind::Operator);
            let value = self.expression();
            condition.span = condition.span.to(value.span);
            condition.kind = ExpressionKind::Missing;
        }
        let line = self.previous;
        if self.at_keyword(keyword) {
            self.bump(SyntaxKind::Keyword);
            // `THEN;` is an empty statement, and a slip more often than not; it does no harm.
            return condition;
        }
        let other = [Keyword::Then, Keyword::Do, Keyword::Of].into_iter().find(|&other| self.at_keyword(other));
        if let Some(other) = other {
            let token = self.token();
            let span = self.span(token.start, token.end);
            let message = format!("`{}` stands where `{}` is wanted", other.word(), keyword.word());
            self.slip(Problem::P6056, span, keyword.word(), message);
            self.bump(SyntaxKind::Keyword);
            return condition;
        }
        if self.skipped_to(keyword) {
            return condition;
        }
        debug_assert!(line == self.previous, "nothing was taken");
        let word = keyword.word();
        self.missing(Problem::P6056, &format!(" {word}"), format!("`{word}` is missing behind {}", self.previous_text()));
        condition
    }

    fn if_statement(&mut self) -> StatementKind {
        self.bump(SyntaxKind::Keyword);
        self.awaited.push(Keyword::EndIf);
        let condition = self.condition(Keyword::Then);
        let kind = self.if_rest(condition);
        self.awaited.pop();
        kind
    }

    /// IF whose keyword is missing; the current token is THEN.
    fn if_branches(&mut self, condition: Expression) -> StatementKind {
        self.bump(SyntaxKind::Keyword);
        self.awaited.push(Keyword::EndIf);
        let kind = self.if_rest(condition);
        self.awaited.pop();
        kind
    }

    /// What stands behind the first THEN.
    fn if_rest(&mut self, condition: Expression) -> StatementKind {
        let start = condition.span.start;
        let mut branches = vec![Branch { condition, body: self.body(Inside::Body) }];
        let mut otherwise = None;
        loop {
            if self.at_keyword(Keyword::Elsif) && otherwise.is_none() {
                self.bump(SyntaxKind::Keyword);
                let condition = self.condition(Keyword::Then);
                branches.push(Branch { condition, body: self.body(Inside::Body) });
            } else if self.at_word("ELSEIF") || self.at_word("ELIF") {
                let token = self.token();
                let span = self.span(token.start, token.end);
                self.slip(Problem::P6061, span, "ELSIF", format!("{} is written `ELSIF`", self.shown()));
                self.bump(SyntaxKind::Keyword);
                let condition = self.condition(Keyword::Then);
                branches.push(Branch { condition, body: self.body(Inside::Body) });
            } else if self.at_keyword(Keyword::Else) && otherwise.is_none() {
                let token = self.token();
                let next = self.tokens[self.behind(self.at)];
                let same_line = !self.text[token.end as usize..next.start as usize].contains(['\n', '\r']);
                if next.keyword == Some(Keyword::If) && same_line {
                    self.else_ifs.push((token.start, next.end));
                }
                self.bump(SyntaxKind::Keyword);
                self.else_colon();
                otherwise = Some(self.body(Inside::Body));
            } else if self.at_keyword(Keyword::Elsif) || (self.at_keyword(Keyword::Else) && self.awaited.len() == 1) {
                let shown = self.shown();
                self.unexpected(Problem::P6054, format!("{shown} behind ELSE is never reached: ELSE is the last branch"));
                self.bump_unexpected();
                otherwise.get_or_insert_default().extend(self.body(Inside::Body));
            } else {
                break;
            }
        }
        self.end_statement(Keyword::EndIf, start);
        StatementKind::If { branches, otherwise }
    }

    fn else_colon(&mut self) {
        if self.raw() == Raw::Colon {
            let token = self.token();
            self.judge(Construct::ElseColon, token.start, token.end);
            self.bump(SyntaxKind::Punctuation);
        }
    }

    /// Takes the end keyword of a statement that began at `start`, or says what is wrong.
    fn end_statement(&mut self, wanted: Keyword, start: u32) {
        if self.eat_keyword(wanted) {
            return;
        }
        let word = wanted.word();
        let outer = &self.awaited[..self.awaited.len() - 1];
        if let Some(keyword) = self.keyword().filter(|keyword| keyword.ends_statement() && !outer.contains(keyword)) {
            let token = self.token();
            let span = self.span(token.start, token.end);
            let message = format!("`{}` stands where the statement ends with `{word}`", keyword.word());
            self.slip(Problem::P6058, span, word, message);
            self.bump(SyntaxKind::Keyword);
            return;
        }
        // An `ELSE IF` inside this statement is the likely reason.
        if wanted == Keyword::EndIf
            && let Some(found) = self.else_ifs.iter().position(|&(place, _)| place >= start)
        {
            let (from, to) = self.else_ifs[found];
            self.else_ifs.truncate(found);
            let span = self.span(from, to);
            let message = "`ELSE IF` begins another IF, which needs its own `END_IF`: did you mean `ELSIF`?";
            self.report(Diagnostic::new(Problem::P6061, span, message).fix(span, "ELSIF", "write `ELSIF`"));
            return;
        }
        let begun = self.span(start, start);
        let shown = self.shown();
        let place = self.last_character();
        let message = format!("`{word}` is missing before {shown}");
        self.report(
            Diagnostic::new(Problem::P6057, place, message)
                .related(begun, "the statement begins here")
                .help(format!("write `{word};` behind the last statement of the body")),
        );
    }

    fn case_statement(&mut self) -> StatementKind {
        self.bump(SyntaxKind::Keyword);
        let selector = self.condition(Keyword::Of);
        self.awaited.push(Keyword::EndCase);
        let kind = self.case_rest(selector);
        self.awaited.pop();
        kind
    }

    /// CASE whose keyword is missing; the current token is OF.
    fn case_arms(&mut self, selector: Expression) -> StatementKind {
        self.bump(SyntaxKind::Keyword);
        self.awaited.push(Keyword::EndCase);
        let kind = self.case_rest(selector);
        self.awaited.pop();
        kind
    }

    fn case_rest(&mut self, selector: Expression) -> StatementKind {
        let start = selector.span.start;
        let mut arms = Vec::new();
        let mut otherwise = None;
        self.start(SyntaxKind::Body);
        loop {
            if self.at_keyword(Keyword::Else) && otherwise.is_none() {
                self.start(SyntaxKind::CaseArm);
                self.bump(SyntaxKind::Keyword);
                self.else_colon();
                otherwise = Some(self.body(Inside::Case));
                self.finish();
            } else if self.at_case_label() {
                let before = self.at;
                self.start(SyntaxKind::CaseArm);
                let arm = self.case_arm();
                self.finish();
                arms.push(arm);
                if self.at == before {
                    self.bump_unexpected();
                }
            } else if self.at_body_end() {
                break;
            } else {
                // Statements without a label.
                let shown = self.shown();
                self.unexpected(
                    Problem::P6071,
                    format!("{shown} is no label of CASE: a label is a constant or a range, with `:` behind it"),
                );
                let mut lost = Vec::new();
                self.skip_statement();
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
                while !self.at_body_end() && !self.at_case_label() {
                    self.statement_into(&mut lost);
                }
            }
        }
        self.finish();
        self.end_statement(Keyword::EndCase, start);
        StatementKind::Case { selector, arms, otherwise }
    }

    fn case_arm(&mut self) -> CaseArm {
        let mut labels = Vec::new();
        loop {
            let low = self.expression();
            labels.push(match self.eat(Raw::Range, SyntaxKind::Operator) {
                true => CaseLabel::Range(low, self.expression()),
                false => CaseLabel::Value(low),
            });
            if !self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                break;
            }
        }
        if !self.eat(Raw::Colon, SyntaxKind::Punctuation) {
            self.missing(Problem::P6071, ":", format!("`:` is missing behind the label {}", self.previous_text()));
        }
        CaseArm { labels, body: self.body(Inside::Case) }
    }

    /// Whether a list of constants with a colon behind it begins here.
    pub(super) fn at_case_label(&self) -> bool {
        let mut index = self.at;
        let mut first = true;
        let mut open = 0_usize;
        loop {
            let token = self.tokens[index];
            match token.raw {
                Raw::Colon => return !first && self.tokens[self.behind(index)].raw != Raw::Equal && !self.is_goto_label(index),
                Raw::Number | Raw::Literal | Raw::EnumValue | Raw::Characters | Raw::Minus | Raw::Plus | Raw::Range | Raw::Star => {}
                Raw::Word if token.keyword.is_none() => {}
                Raw::Word if matches!(token.keyword, Some(Keyword::True | Keyword::False)) => {}
                Raw::Local | Raw::Quoted | Raw::Backquoted => {}
                Raw::Point | Raw::Comma if !first => {}
                Raw::ParenOpen => open += 1,
                Raw::ParenClose if open > 0 => open -= 1,
                _ => return false,
            }
            first = false;
            index = self.behind(index);
        }
    }

    /// Whether the colon belongs to a label of GOTO that the block declares.
    fn is_goto_label(&self, colon: usize) -> bool {
        let alone = self.behind(self.at) == colon && self.is_name(self.at);
        alone && !self.labels.is_empty() && self.labels.contains(&self.current().to_uppercase())
    }

    fn for_statement(&mut self) -> StatementKind {
        self.bump(SyntaxKind::Keyword);
        let variable = self.target();
        if self.assign_operator().is_none() {
            self.missing(Problem::P2007, " :=", format!("`:=` is missing behind {}", self.previous_text()));
        }
        let from = self.expression();
        self.for_rest(variable, from)
    }

    /// What stands behind the first value.
    fn for_rest(&mut self, variable: Expression, from: Expression) -> StatementKind {
        let start = variable.span.start;
        self.awaited.push(Keyword::EndFor);
        if !self.eat_keyword(Keyword::To) {
            self.missing(Problem::P6056, " TO", format!("`TO` is missing behind {}", self.previous_text()));
        }
        let mut by = None;
        let to = if self.at_keyword(Keyword::Do) && self.reported == self.at {
            self.bump(SyntaxKind::Keyword);
            Expression { kind: ExpressionKind::Missing, span: self.since(start) }
        } else {
            let mut to = self.expression();
            if self.eat_keyword(Keyword::By) {
                by = Some(self.condition(Keyword::Do));
            } else {
                to = self.after_to(to);
            }
            to
        };
        let body = self.body(Inside::Body);
        let end = self.token();
        self.end_statement(Keyword::EndFor, start);
        let end = self.span(end.start.min(self.previous), self.previous);
        self.awaited.pop();
        StatementKind::For(Box::new(ForLoop { variable, from, to, by, body, end }))
    }

    /// DO behind the last value.
    fn after_to(&mut self, to: Expression) -> Expression {
        if self.eat_keyword(Keyword::Do) {
            return to;
        }
        match self.keyword() {
            Some(Keyword::Then | Keyword::Of) => {
                let token = self.token();
                let span = self.span(token.start, token.end);
                self.slip(Problem::P6056, span, "DO", format!("{} stands where `DO` is wanted", self.shown()));
                self.bump(SyntaxKind::Keyword);
            }
            _ if self.skipped_to(Keyword::Do) => {}
            _ => self.expect_keyword(Keyword::Do, &self.previous_text()),
        }
        to
    }

    /// What stands between an expression and its keyword on the same line does not belong there; `false` if there is no such keyword.
    fn skipped_to(&mut self, keyword: Keyword) -> bool {
        let mut ahead = self.at;
        while !matches!(self.tokens[ahead].raw, Raw::End | Raw::Semicolon | Raw::Newline) && self.tokens[ahead].keyword != Some(keyword) {
            ahead += 1;
        }
        if self.tokens[ahead].keyword != Some(keyword) {
            return false;
        }
        let shown = self.shown();
        let word = keyword.word();
        self.unexpected(Problem::P6055, format!("{shown} does not belong here: an operator or `{word}` is wanted"));
        while !self.at_keyword(keyword) && self.raw() != Raw::End {
            self.bump_unexpected();
        }
        self.eat_keyword(keyword)
    }

    fn while_statement(&mut self) -> StatementKind {
        self.bump(SyntaxKind::Keyword);
        let condition = self.condition(Keyword::Do);
        self.loop_rest(condition)
    }

    /// WHILE whose keyword is missing; the current token is DO.
    fn while_body(&mut self, condition: Expression) -> StatementKind {
        self.bump(SyntaxKind::Keyword);
        self.loop_rest(condition)
    }

    fn loop_rest(&mut self, condition: Expression) -> StatementKind {
        let start = condition.span.start;
        self.awaited.push(Keyword::EndWhile);
        let body = self.body(Inside::Body);
        self.end_statement(Keyword::EndWhile, start);
        self.awaited.pop();
        StatementKind::While { condition, body }
    }

    fn repeat_statement(&mut self) -> StatementKind {
        let start = self.here();
        self.bump(SyntaxKind::Keyword);
        self.awaited.push(Keyword::EndRepeat);
        let body = self.body(Inside::Body);
        let until = if self.eat_keyword(Keyword::Until) {
            let until = self.expression();
            self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            if !self.at_keyword(Keyword::EndRepeat) && !self.at_body_end() {
                let shown = self.shown();
                self.unexpected(Problem::P6055, format!("{shown} does not belong here: `END_REPEAT` is wanted behind the condition"));
                self.skip_statement();
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            }
            until
        } else {
            self.missing(Problem::P6056, " UNTIL", "`UNTIL` with its condition is missing behind the body of REPEAT");
            Expression { kind: ExpressionKind::Missing, span: self.since(start) }
        };
        self.end_statement(Keyword::EndRepeat, start);
        self.awaited.pop();
        StatementKind::Repeat { body, until }
    }

    /// `REGION name … END_REGION`.
    fn region(&mut self) -> StatementKind {
        let token = self.token();
        self.judge(Construct::Region, token.start, token.end);
        self.bump(SyntaxKind::Keyword);
        let name = self.rest_of_line(token.end);
        self.awaited.push(Keyword::EndRegion);
        let body = self.body(Inside::Body);
        self.end_statement(Keyword::EndRegion, token.start);
        // Some write the name behind the end too.
        if !self.on_new_line() && self.raw() != Raw::Semicolon && !self.at_body_end() && self.raw() != Raw::End {
            self.rest_of_line(self.previous);
        }
        self.awaited.pop();
        StatementKind::Region { name, body }
    }

    /// Takes the tokens up to the end of the line as free text.
    pub(super) fn rest_of_line(&mut self, from: u32) -> String {
        let rest = &self.text[from as usize..];
        let end = from as usize + rest.find(['\n', '\r']).unwrap_or(rest.len());
        while (self.token().start as usize) < end && self.raw() != Raw::End {
            self.flush();
            self.bump_text();
        }
        self.text[from as usize..end].split("//").next().unwrap_or_default().trim().to_owned()
    }

    fn try_statement(&mut self) -> StatementKind {
        let start = self.here();
        self.bump(SyntaxKind::Keyword);
        self.awaited.push(Keyword::EndTry);
        let body = self.body(Inside::Body);
        let (mut exception, mut catch, mut finally) = (None, Vec::new(), Vec::new());
        if self.eat_keyword(Keyword::Catch) {
            if self.eat(Raw::ParenOpen, SyntaxKind::Punctuation) {
                exception = Some(self.expression());
                self.close(Raw::ParenClose, ")");
            }
            catch = self.body(Inside::Body);
        }
        if self.eat_keyword(Keyword::Finally) {
            finally = self.body(Inside::Body);
        }
        self.end_statement(Keyword::EndTry, start);
        self.awaited.pop();
        StatementKind::Try { body, exception, catch, finally }
    }

    /// Skips a statement that is nested too deeply, with all that is inside it.
    fn skip_nested(&mut self) {
        let mut open = 0_usize;
        loop {
            match self.keyword() {
                _ if self.raw() == Raw::End => return,
                Some(Keyword::If | Keyword::Case | Keyword::For | Keyword::While | Keyword::Repeat | Keyword::Try) => open += 1,
                Some(keyword) if keyword.ends_statement() => open = open.saturating_sub(1),
                Some(keyword) if keyword.is_end() || keyword.begins_block() => return,
                _ => {}
            }
            self.bump_unexpected();
            if open == 0 {
                return;
            }
        }
    }
}
