//! Expressions: operators by rank, what follows an operand, calls, constants.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::literal::written_milliseconds;
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use super::super::ast::{Argument, BinaryOperator, Call, Direction, Expression, ExpressionKind, Literal, LiteralKind, Name, Path};
use super::super::ast::{Quoting, UnaryOperator};
use super::super::dialect::{Construct, PowerRank};
use super::super::keywords::Keyword;
use super::super::lexer::{Raw, quotes_names, straightened};
use super::super::literals;
use super::{EXPRESSION_HEIGHT_MAX, Parser, SyntaxKind, unquoted};
use crate::declarations::values::shortened_s5time;

/// An expression with its height.
pub(super) type Tall = (Expression, u32);

/// The rank of `**`.
const POWER: u8 = 8;

impl<'t> Parser<'t> {
    /// An expression; something is reported if none begins here.
    pub(super) fn expression(&mut self) -> Expression {
        self.start(SyntaxKind::Expression);
        let (expression, _) = self.binary(1);
        self.finish();
        expression
    }

    /// What can be assigned to or called: an operand with what follows it.
    pub(super) fn target(&mut self) -> Expression {
        self.start(SyntaxKind::Expression);
        let (expression, _) = self.unary();
        self.finish();
        expression
    }

    /// An operator at the current token, its rank, and how many tokens it has.
    fn operator(&self) -> Option<(BinaryOperator, u8)> {
        use BinaryOperator as Operator;
        Some(match self.raw() {
            Raw::Power => (Operator::Power, POWER),
            Raw::Star => (Operator::Multiply, 7),
            Raw::Slash => (Operator::Divide, 7),
            Raw::Plus => (Operator::Add, 6),
            Raw::Minus => (Operator::Subtract, 6),
            Raw::Less => (Operator::Less, 5),
            Raw::LessEqual => (Operator::LessEqual, 5),
            Raw::Greater => (Operator::Greater, 5),
            Raw::GreaterEqual => (Operator::GreaterEqual, 5),
            Raw::Equal if self.joined_with(Raw::Less) => (Operator::LessEqual, 5),
            Raw::Equal => (Operator::Equal, 4),
            Raw::NotEqual => (Operator::NotEqual, 4),
            Raw::Foreign if self.current() == "!=" => (Operator::NotEqual, 4),
            Raw::Foreign => (Operator::Equal, 4),
            Raw::Ampersand => (Operator::And, 3),
            Raw::Unknown if self.text[self.here() as usize..].starts_with("||") => (Operator::Or, 1),
            Raw::Delivers => (Operator::GreaterEqual, 5),
            Raw::Word => {
                // Words that are operators in other dialects cannot be anything else here.
                let word = self.current();
                let is = |operator: &str| word.eq_ignore_ascii_case(operator);
                match word.len() {
                    2 if is("OR") => (Operator::Or, 1),
                    3 if is("XOR") => (Operator::Xor, 2),
                    3 if is("AND") => (Operator::And, 3),
                    3 if is("MOD") => (Operator::Modulo, 7),
                    3 if is("DIV") && !self.on_new_line() => (Operator::IntegerDivide, 7),
                    7 if is("OR_ELSE") => (Operator::OrElse, 1),
                    8 if is("AND_THEN") => (Operator::AndThen, 3),
                    _ => return None,
                }
            }
            _ => return None,
        })
    }

    /// Takes an operator and says what the dialect thinks of it.
    fn take_operator(&mut self, operator: BinaryOperator) -> Span {
        let token = self.token();
        let whole = self.span(token.start, token.end);
        let two = |end| self.span(token.start, end);
        match token.raw {
            Raw::Foreign => {
                let message = format!("`{}` is no comparison of ST: `{}` compares", self.current(), operator.sign());
                self.slip(Problem::P6052, whole, operator.sign(), message);
            }
            Raw::Delivers => self.slip(Problem::P6052, whole, ">=", "`=>` delivers an output; `>=` compares"),
            Raw::Equal if operator == BinaryOperator::LessEqual => {
                self.slip(Problem::P6052, two(token.end + 1), "<=", "`=<` is no comparison of ST: `<=` compares");
                self.bump(SyntaxKind::Operator);
            }
            Raw::Unknown => {
                self.slip(Problem::P6052, two(token.end + 1), "OR", "`||` is no operator of ST: did you mean `OR`?");
                self.bump(SyntaxKind::Operator);
            }
            Raw::Ampersand if self.joined_with(Raw::Ampersand) => {
                self.slip(Problem::P6052, two(token.end + 1), "AND", "`&&` is no operator of ST: did you mean `AND`?");
                self.bump(SyntaxKind::Operator);
            }
            _ => {
                let construct = match operator {
                    BinaryOperator::Power => Some(Construct::PowerOperator),
                    BinaryOperator::IntegerDivide => Some(Construct::DivOperator),
                    BinaryOperator::AndThen | BinaryOperator::OrElse => Some(Construct::ShortCircuit),
                    _ => None,
                };
                if let Some(construct) = construct {
                    self.judge(construct, token.start, token.end);
                }
            }
        }
        self.bump(SyntaxKind::Operator);
        self.since(token.start)
    }

    /// What follows an operand that has been taken already.
    pub(super) fn rest_of_expression(&mut self, left: Expression) -> Expression {
        self.start(SyntaxKind::Expression);
        let (expression, _) = self.binary_from(left, 0, 1);
        self.finish();
        expression
    }

    /// Operands with operators of this rank or a higher one between them, from left to right.
    fn binary(&mut self, rank_min: u8) -> Tall {
        let (left, height) = self.unary();
        self.binary_from(left, height, rank_min)
    }

    fn binary_from(&mut self, mut left: Expression, mut height: u32, rank_min: u8) -> Tall {
        let start = left.span.start;
        while let Some((operator, rank)) = self.operator().filter(|&(_, rank)| rank >= rank_min) {
            let place = self.take_operator(operator);
            let (right, right_height) = self.binary(rank + 1);
            if is_logical(operator) {
                let mut parts = vec![(left, height), (right, right_height)];
                let mut places = vec![place];
                while self.operator() == Some((operator, rank)) {
                    places.push(self.take_operator(operator));
                    parts.push(self.binary(rank + 1));
                }
                (left, height) = balanced(operator, parts, &places);
            } else {
                height = height.max(right_height) + 1;
                let span = self.since(start);
                left = Expression { kind: ExpressionKind::Binary(operator, place, Box::new(left), Box::new(right)), span };
            }
            (left, height) = self.limited(left, height);
        }
        (left, height)
    }

    /// An expression that is too high is reported and forgotten.
    fn limited(&mut self, expression: Expression, height: u32) -> Tall {
        if height <= EXPRESSION_HEIGHT_MAX {
            return (expression, height);
        }
        let span = expression.span;
        if !std::mem::replace(&mut self.too_high, true) {
            let message = format!("this expression has more than {EXPRESSION_HEIGHT_MAX} operators one behind the other");
            self.push(Diagnostic::new(Problem::P6063, span, message).help("assign a part of it to a variable first"));
        }
        (Expression { kind: ExpressionKind::Missing, span }, 0)
    }

    /// Signs and NOT before an operand.
    fn unary(&mut self) -> Tall {
        let mut signs = Vec::new();
        loop {
            let operator = match self.raw() {
                Raw::Minus => UnaryOperator::Minus,
                Raw::Plus => UnaryOperator::Plus,
                Raw::Word if self.at_keyword(Keyword::Not) => UnaryOperator::Not,
                Raw::Unknown if self.current() == "!" => {
                    let token = self.token();
                    let span = self.span(token.start, token.end);
                    self.slip(Problem::P6052, span, "NOT ", "`!` is no operator of ST: did you mean `NOT`?");
                    UnaryOperator::Not
                }
                _ => break,
            };
            signs.push((operator, self.here()));
            self.bump(SyntaxKind::Operator);
        }
        if signs.is_empty() {
            return self.postfix();
        }
        if !self.deeper() {
            while !matches!(self.raw(), Raw::End | Raw::Semicolon) && !self.at_body_end() {
                self.bump_unexpected();
            }
            return self.nothing(signs[0].1);
        }
        let (mut operand, mut height) = match self.dialect.switches().power {
            PowerRank::BehindSign => self.postfix(),
            PowerRank::BeforeSign => self.binary(POWER),
        };
        self.depth -= 1;
        for (operator, start) in signs.into_iter().rev() {
            let expression = Expression { kind: ExpressionKind::Unary(operator, Box::new(operand)), span: self.since(start) };
            (operand, height) = self.limited(expression, height + 1);
        }
        (operand, height)
    }

    pub(super) fn nothing(&self, start: u32) -> Tall {
        (Expression { kind: ExpressionKind::Missing, span: self.since(start) }, 0)
    }

    /// An operand with fields, indexes, calls and the like behind it.
    fn postfix(&mut self) -> Tall {
        let start = self.here();
        let (mut left, mut height) = self.primary();
        if matches!(left.kind, ExpressionKind::Missing | ExpressionKind::Literal(_)) {
            return (left, height);
        }
        loop {
            let (kind, other) = match self.raw() {
                Raw::Point => match self.behind_point(left) {
                    Ok(kind) => (kind, 0),
                    Err(same) => return (same, height),
                },
                Raw::BracketOpen => {
                    let (indices, other) = self.indices();
                    (ExpressionKind::Index(Box::new(left), indices), other)
                }
                Raw::Caret => {
                    self.bump(SyntaxKind::Operator);
                    (ExpressionKind::Dereference(Box::new(left)), 0)
                }
                Raw::ParenOpen if !matches!(left.kind, ExpressionKind::Address(_) | ExpressionKind::Parenthesized(_)) => {
                    let reported = self.diagnostics.len();
                    let (arguments, other) = self.arguments();
                    let shapes = [Problem::P2030, Problem::P2031, Problem::P6055];
                    let lost = self.diagnostics.iter().skip(reported).any(|one| shapes.contains(&one.problem));
                    // Which argument is which, nobody knows: what is called has nothing to say to them.
                    let callee = if lost { Expression { kind: ExpressionKind::Missing, ..left } } else { left };
                    (ExpressionKind::Call(Box::new(Call { callee, arguments })), other)
                }
                _ => return (left, height),
            };
            let expression = Expression { kind, span: self.since(start) };
            (left, height) = self.limited(expression, height.max(other) + 1);
        }
    }

    /// What stands behind a point; without it, a message and the operand as it was.
    fn behind_point(&mut self, left: Expression) -> Result<ExpressionKind, Expression> {
        let next = self.behind(self.at);
        let token = self.tokens[next];
        match token.raw {
            Raw::Number if self.slice(token).bytes().all(|byte| byte.is_ascii_digit()) => {
                self.bump(SyntaxKind::Punctuation);
                self.judge(Construct::BitByNumber, token.start, token.end);
                let index = self.current().parse().unwrap_or(u64::MAX);
                let span = self.bump(SyntaxKind::Number);
                Ok(ExpressionKind::Slice(Box::new(left), super::super::ast::Slice { bits: 1, index, percent: false, span }))
            }
            Raw::Percent => {
                self.bump(SyntaxKind::Punctuation);
                match self.percent_data_address(left) {
                    Ok(kind) => Ok(kind),
                    Err(left) => Ok(self.slice_of(left)),
                }
            }
            Raw::Word | Raw::Quoted | Raw::Local | Raw::Backquoted => {
                self.bump(SyntaxKind::Punctuation);
                if let Some(kind) = self.data_address(&left) {
                    return Ok(kind(left));
                }
                let name = self.name(SyntaxKind::Name);
                Ok(ExpressionKind::Member(Box::new(left), name))
            }
            // `Plant.State#open`: the type lies in a namespace.
            Raw::EnumValue if names_of(&left).is_some() => {
                self.bump(SyntaxKind::Punctuation);
                let ExpressionKind::EnumValue { of, value } = self.enum_value() else { return Err(left) };
                let names = names_of(&left).unwrap_or_default().into_iter().chain(of.names).collect();
                Ok(ExpressionKind::EnumValue { of: Path { names, span: left.span.to(of.span) }, value })
            }
            _ => {
                self.bump(SyntaxKind::Punctuation);
                let shown = self.shown();
                self.unexpected(Problem::P2018, format!("a name is wanted behind `.`, not {shown}"));
                Err(left)
            }
        }
    }

    /// `[i, j]`, and the height of the highest.
    pub(super) fn indices(&mut self) -> (Vec<Expression>, u32) {
        if !self.deeper() {
            self.skip_brackets();
            return (Vec::new(), 0);
        }
        self.bump(SyntaxKind::Punctuation);
        let (mut indices, mut highest) = (Vec::new(), 0);
        loop {
            let (index, height) = self.binary(1);
            highest = highest.max(height);
            indices.push(index);
            if !self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                break;
            }
        }
        self.close(Raw::BracketClose, "]");
        self.depth -= 1;
        (indices, highest)
    }

    /// A closing bracket; its absence is reported where it should stand.
    pub(super) fn close(&mut self, raw: Raw, text: &str) {
        if self.eat(raw, SyntaxKind::Punctuation) {
            return;
        }
        let problem = if raw == Raw::BracketClose { Problem::P2016 } else { Problem::P6065 };
        let goes_on = matches!(self.raw(), Raw::End | Raw::Semicolon) || self.on_new_line() || self.keyword().is_some();
        if goes_on || self.raw() == Raw::Becomes {
            self.missing(problem, text, format!("`{text}` is missing here"));
            return;
        }
        let shown = self.shown();
        self.unexpected(problem, format!("`{text}` or an operator is wanted here, not {shown}"));
        // The bracket may still come on this line, behind others that are whole.
        let (mut ahead, mut open) = (self.at, 0_usize);
        while !matches!(self.tokens[ahead].raw, Raw::End | Raw::Semicolon | Raw::Newline) && (open > 0 || self.tokens[ahead].raw != raw) {
            match self.tokens[ahead].raw {
                Raw::ParenOpen | Raw::BracketOpen => open += 1,
                Raw::ParenClose | Raw::BracketClose => open = open.saturating_sub(1),
                _ => {}
            }
            ahead += 1;
        }
        if self.tokens[ahead].raw == raw {
            while self.at < ahead && self.raw() != Raw::End {
                self.bump_unexpected();
            }
            self.eat(raw, SyntaxKind::Punctuation);
        }
    }

    fn primary(&mut self) -> Tall {
        let start = self.here();
        let token = self.token();
        let kind = match token.raw {
            Raw::Number | Raw::Literal | Raw::Characters => self.literal().map_or(ExpressionKind::Missing, ExpressionKind::Literal),
            Raw::Quoted if !quotes_names(self.dialect) => self.literal().map_or(ExpressionKind::Missing, ExpressionKind::Literal),
            Raw::Percent => return (self.percent_address(), 0),
            Raw::EnumValue => self.enum_value(),
            Raw::ParenOpen => return self.parenthesized(),
            Raw::Point if self.is_name(self.behind(self.at)) => {
                self.bump(SyntaxKind::Punctuation);
                ExpressionKind::Global(self.name(SyntaxKind::Name))
            }
            Raw::Word if token.keyword.is_some() => match token.keyword {
                Some(Keyword::True | Keyword::False) => {
                    let value = self.at_keyword(Keyword::True);
                    self.bump(SyntaxKind::Constant);
                    ExpressionKind::Literal(Literal { kind: LiteralKind::Bool(value), prefix: None })
                }
                Some(Keyword::Null | Keyword::Nil) => {
                    self.bump(SyntaxKind::Constant);
                    ExpressionKind::Literal(Literal { kind: LiteralKind::Null, prefix: None })
                }
                Some(Keyword::This) => {
                    self.bump(SyntaxKind::Keyword);
                    ExpressionKind::This
                }
                Some(Keyword::Super) => {
                    self.bump(SyntaxKind::Keyword);
                    ExpressionKind::Super
                }
                Some(Keyword::And | Keyword::Or | Keyword::Xor | Keyword::Mod | Keyword::Div | Keyword::AndThen | Keyword::OrElse)
                    if self.next_raw() == Raw::ParenOpen && self.dialect.switches().operators_as_functions =>
                {
                    let text = self.current().to_owned();
                    let span = self.bump(SyntaxKind::Name);
                    ExpressionKind::Name(Name { text, quoting: Quoting::Bare, span })
                }
                _ => return self.no_operand(),
            },
            Raw::Word | Raw::Local | Raw::Backquoted | Raw::Quoted => match self.bare_address().or_else(|| self.address_with_blank()) {
                Some(address) => return (address, 1),
                None => ExpressionKind::Name(self.name(SyntaxKind::Name)),
            },
            _ => return self.no_operand(),
        };
        (Expression { kind, span: self.since(start) }, 0)
    }

    fn no_operand(&mut self) -> Tall {
        let start = self.previous;
        if self.keyword().is_some_and(|keyword| self.refused.contains(&keyword)) {
            // As the name of a variable it was refused where it is declared.
            self.bump_unexpected();
            return self.nothing(start);
        }
        let shown = self.shown();
        let behind = self.previous_text();
        let message = match self.keyword() {
            Some(keyword) if !(keyword.is_end() || keyword.begins_statement() || keyword.begins_block()) => {
                format!("a variable or a value is wanted here, not the keyword {shown}")
            }
            _ => format!("a variable or a value is missing behind {behind}: {shown} is none"),
        };
        self.unexpected(Problem::P6055, message);
        self.nothing(start)
    }

    /// The last token that was taken, for messages.
    pub(super) fn previous_text(&self) -> String {
        let before = &self.text[..self.previous as usize];
        let short: Vec<char> = before.chars().rev().take_while(|c| !c.is_whitespace()).take(20).collect();
        format!("`{}`", short.iter().rev().collect::<String>())
    }

    fn parenthesized(&mut self) -> Tall {
        let start = self.here();
        if self.callee_is_lost(true) {
            self.without_callee();
            return self.nothing(start);
        }
        if !self.deeper() {
            self.skip_brackets();
            return self.nothing(start);
        }
        self.bump(SyntaxKind::Punctuation);
        let (mut inner, mut height) = self.binary(1);
        if self.raw() == Raw::Becomes {
            let token = self.token();
            self.judge(Construct::AssignmentExpression, token.start, token.end);
            self.bump(SyntaxKind::Operator);
            let (value, other) = self.binary(1);
            height = height.max(other) + 1;
            let span = inner.span.to(value.span);
            inner = Expression { kind: ExpressionKind::Assign(Box::new(inner), Box::new(value)), span };
        }
        self.close(Raw::ParenClose, ")");
        self.depth -= 1;
        let expression = Expression { kind: ExpressionKind::Parenthesized(Box::new(inner)), span: self.since(start) };
        self.limited(expression, height + 1)
    }

    /// `Color#red`.
    fn enum_value(&mut self) -> ExpressionKind {
        let token = self.token();
        let text = self.current();
        let (of, value) = text.split_once('#').unwrap_or((text, ""));
        let behind = token.start + of.len() as u32 + 1;
        let of = Name { text: of.to_owned(), quoting: Quoting::Bare, span: self.span(token.start, behind - 1) };
        let value = Name { text: value.to_owned(), quoting: Quoting::Bare, span: self.span(behind, token.end) };
        if value.text.starts_with(|c: char| c.is_ascii_digit()) {
            let message = format!("`{}` is no type whose literals are written with `#`", of.text);
            self.error(Problem::P4205, token.start, token.end, message);
        }
        self.bump(SyntaxKind::Constant);
        let span = of.span;
        ExpressionKind::EnumValue { of: Path { names: vec![of], span }, value }
    }

    /// A constant without a sign; the current token is one.
    pub(super) fn literal(&mut self) -> Option<Literal> {
        let token = self.token();
        let straight = straightened(self.current());
        let text = straight.as_ref();
        let mut kind = SyntaxKind::Constant;
        let decoded = match token.raw {
            Raw::Number => {
                kind = SyntaxKind::Number;
                literals::number(text)
            }
            Raw::Literal => literals::prefixed(text, self.dialect),
            Raw::Quoted => {
                kind = SyntaxKind::Characters;
                literals::wide_characters(text, self.dialect).map(|kind| (Literal { kind, prefix: None }, None))
            }
            _ => {
                kind = SyntaxKind::Characters;
                literals::characters(text, self.dialect).map(|kind| (Literal { kind, prefix: None }, None))
            }
        };
        let terminated = super::is_terminated(token.raw, text);
        self.bump(kind);
        match decoded {
            Ok((literal, note)) => {
                if let Some(construct) = note {
                    self.judge(construct, token.start, token.end);
                }
                if let LiteralKind::S5Time(_) = literal.kind
                    && let Some(message) = written_milliseconds(text).and_then(|time| shortened_s5time(text, time))
                {
                    self.error(Problem::P5029, token.start, token.end, message);
                }
                Some(literal)
            }
            Err((problem, message)) => {
                if terminated {
                    self.error(problem, token.start, token.end, message);
                }
                None
            }
        }
    }

    /// `(a, IN := b, Q => c)`, and the height of the highest.
    pub(super) fn arguments(&mut self) -> (Vec<Argument>, u32) {
        if !self.deeper() {
            self.skip_brackets();
            return (Vec::new(), 0);
        }
        self.start(SyntaxKind::Arguments);
        self.bump(SyntaxKind::Punctuation);
        let (mut arguments, mut highest) = (Vec::new(), 0);
        while !matches!(self.raw(), Raw::ParenClose | Raw::End | Raw::Semicolon) {
            let before = self.at;
            if matches!(self.raw(), Raw::Becomes | Raw::Delivers) {
                let shown = self.shown();
                self.unexpected(Problem::P6055, format!("the name of a parameter is wanted in front of {shown}"));
                self.bump_unexpected();
                self.binary(1);
                if self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                    continue;
                }
                break;
            }
            let (argument, height) = self.argument();
            arguments.push(argument);
            highest = highest.max(height);
            if self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                continue;
            }
            let named = self.at_name() && matches!(self.next_raw(), Raw::Becomes | Raw::Delivers);
            if named && self.at > before {
                self.missing(Problem::P2030, ",", "a comma is missing between two parameters");
                continue;
            }
            let value = self.at_name() || matches!(self.raw(), Raw::Number | Raw::Literal | Raw::Characters);
            let by_position = arguments.iter().all(|argument: &Argument| argument.name.is_none());
            if value && by_position && self.at > before && self.reported != self.at && !self.on_new_line() {
                let (behind, shown) = (self.previous_text(), self.shown());
                self.unexpected(Problem::P2030, format!("a comma or an operator is missing between {behind} and {shown}"));
                continue;
            }
            break;
        }
        if self.raw() == Raw::ParenClose {
            self.bump(SyntaxKind::Punctuation);
        } else if self.reported == self.at || !matches!(self.raw(), Raw::End | Raw::Semicolon) {
            self.close(Raw::ParenClose, ")");
        } else {
            self.missing(Problem::P2031, ")", "`)` is missing behind the last parameter");
        }
        self.compared_names(&mut arguments);
        self.finish();
        self.depth -= 1;
        (arguments, highest)
    }

    /// `t(IN = x, PT := y)`: beside named parameters, a comparison of a name that is no variable is a slip for `:=`.
    fn compared_names(&mut self, arguments: &mut [Argument]) {
        if arguments.iter().all(|argument| argument.name.is_none()) {
            return;
        }
        for argument in arguments.iter_mut().filter(|argument| argument.name.is_none()) {
            let Some(Expression { kind: ExpressionKind::Binary(BinaryOperator::Equal, sign, left, right), .. }) = &argument.value else {
                continue;
            };
            let ExpressionKind::Name(name) = &left.kind else { continue };
            if self.declared.contains(&key(&name.text)) {
                continue;
            }
            let (name, sign, value) = (name.clone(), *sign, (**right).clone());
            self.slip(Problem::P2007, sign, ":=", "`=` compares; a parameter is given with `:=`");
            (argument.name, argument.value) = (Some(name), Some(value));
        }
    }

    fn argument(&mut self) -> (Argument, u32) {
        let start = self.here();
        let next = self.behind(self.at);
        let behind = self.tokens[next];
        // `=:` is a slip for `:=`.
        let exchanged = behind.raw == Raw::Equal && self.tokens.get(next + 1).is_some_and(|token| token.raw == Raw::Colon);
        let word = matches!(self.raw(), Raw::Word | Raw::Local | Raw::Quoted | Raw::Backquoted);
        // `PT T#5s`: a sign between two values can only be missing.
        let begins_value = matches!(
            behind.raw,
            Raw::Word | Raw::Number | Raw::Literal | Raw::Characters | Raw::Quoted | Raw::Local | Raw::Backquoted | Raw::Percent
        );
        let is_value = matches!(behind.keyword, None | Some(Keyword::True | Keyword::False | Keyword::Not));
        let absent = self.at_name() && begins_value && is_value;
        let named = word && (matches!(behind.raw, Raw::Becomes | Raw::Delivers) || exchanged || absent);
        if !named {
            let (value, height) = self.binary(1);
            return (Argument { name: None, direction: Direction::Assigned, value: Some(value), span: self.since(start) }, height);
        }
        let name = self.name(SyntaxKind::Name);
        let sign = self.token();
        let mut direction = match sign.raw {
            Raw::Delivers => Direction::Delivered,
            _ => Direction::Assigned,
        };
        if absent {
            self.missing(Problem::P2030, " :=", format!("`:=` is missing between {} and {}", self.previous_text(), self.shown()));
            let (value, height) = self.binary(1);
            return (Argument { name: Some(name), direction, value: Some(value), span: self.since(start) }, height);
        }
        if exchanged {
            let span = self.span(sign.start, sign.end + 1);
            self.slip(Problem::P2007, span, ":=", "`=:` is no assignment sign; a parameter is given with `:=`");
            self.bump(SyntaxKind::Operator);
        } else if sign.raw == Raw::Becomes && self.joined_with(Raw::Greater) {
            let span = self.span(sign.start, sign.end + 1);
            let message = "`:=>` is neither `:=`, which gives an input, nor `=>`, which takes an output";
            self.push(Diagnostic::new(Problem::P2007, span, message).guess(span, ":=", "write `:=`"));
            direction = Direction::Unclear(span);
            self.bump(SyntaxKind::Operator);
        }
        self.bump(SyntaxKind::Operator);
        let (value, height) = match self.raw() {
            Raw::Comma | Raw::ParenClose => (None, 0),
            _ => {
                let (value, height) = self.binary(1);
                (Some(value), height)
            }
        };
        (Argument { name: Some(name), direction, value, span: self.since(start) }, height)
    }
}

/// Operators whose chains may be bracketed in any way: order of evaluation and result stay the same.
fn is_logical(operator: BinaryOperator) -> bool {
    matches!(operator, BinaryOperator::And | BinaryOperator::Or | BinaryOperator::Xor)
}

/// A chain of one operator as a tree: leaning to the left as it is written if it is short, else of little height.
fn balanced(operator: BinaryOperator, parts: Vec<Tall>, places: &[Span]) -> Tall {
    /// Chains up to this length are left as they are written.
    const SHORT: usize = 16;
    let join = |(left, a): Tall, (right, b): Tall, place: Span| {
        let span = left.span.to(right.span);
        let kind = ExpressionKind::Binary(operator, place, Box::new(left), Box::new(right));
        (Expression { kind, span }, a.max(b) + 1)
    };
    let mut level = parts;
    let mut places = places.to_vec();
    while level.len() > SHORT {
        let mut next = Vec::with_capacity(level.len() / 2 + 1);
        let mut between = Vec::with_capacity(level.len() / 2);
        let mut pairs = level.into_iter();
        let mut signs = places.into_iter();
        while let Some(left) = pairs.next() {
            match (pairs.next(), signs.next()) {
                (Some(right), Some(place)) => next.push(join(left, right, place)),
                _ => next.push(left),
            }
            between.extend(signs.next());
        }
        (level, places) = (next, between);
    }
    let mut rest = level.into_iter();
    let first = rest.next().expect("a chain has two operands");
    rest.zip(places).fold(first, |left, (right, place)| join(left, right, place))
}

/// The text of a quoted or plain name, for tables.
pub(super) fn key(text: &str) -> String {
    unquoted(unquoted(text.trim_start_matches('#'), '"'), '`').to_uppercase()
}

/// The names of `a.b`, if there is nothing else in it.
fn names_of(expression: &Expression) -> Option<Vec<Name>> {
    match &expression.kind {
        ExpressionKind::Name(name) => Some(vec![name.clone()]),
        ExpressionKind::Member(base, name) => {
            let mut names = names_of(base)?;
            names.push(name.clone());
            Some(names)
        }
        _ => None,
    }
}
