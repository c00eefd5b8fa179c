//! DTL in expressions, and the instructions of tia whose result has the type of what it is assigned to: T_CONV, T_COMBINE, S_CONV.

use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, STRING_LENGTH_MAX};

use super::Checker;
use super::calls::Called;
use super::expressions::same_type;
use super::places::Reached;
use super::statements::moment;
use super::typed::Typed;
use super::types::{Class, Implicit, Kind, implicit};
use crate::st::ast::{self, BinaryOperator, Expression, ExpressionKind, Name, Quoting};
use crate::st::dialect::Construct;
use crate::st::dtl;
use crate::st::standard::{self, library};
use crate::st::tree::{Place, Scalar, Statement, StatementKind, Value, ValueKind};

/// Instructions whose result has the type of what it is assigned to.
const BY_TARGET: [&str; 3] = ["T_CONV", "T_COMBINE", "S_CONV"];

/// Instructions that deliver a DTL, and the block of the library that does it.
const DTL_FUNCTIONS: [(&str, &str); 3] = [("T_COMBINE", "TIA_COMBINE_DTL"), ("T_ADD", "TIA_ADD_DTL"), ("T_SUB", "TIA_SUB_DTL")];

/// The word of a type in the names of conversions of tia.
fn word(data_type: &DataType) -> Option<&'static str> {
    match data_type.base() {
        DataType::DateAndTime => Some("DT"),
        DataType::TimeOfDay => Some("TOD"),
        DataType::String(_) => Some("STRING"),
        DataType::WideString(_) => Some("WSTRING"),
        other if dtl::is_dtl(other) => Some(dtl::WORD),
        other => other.word(),
    }
}

impl Checker<'_> {
    /// The statements that write a constant of type DTL.
    pub(super) fn write_dtl(target: &Place, bytes: [u8; dtl::BYTES], span: Span) -> Vec<Statement> {
        let [a, b, c, d, e, f, g, h, i, j, k, l] = bytes;
        let mut all = moment(target, [a, b, c, d, e, f, g, h], span);
        let value = Value { kind: ValueKind::Constant(u64::from(u32::from_be_bytes([i, j, k, l]))), scalar: Scalar::U32, span };
        let target = Place { offset: target.offset + 64, ..target.clone() };
        all.push(Statement { kind: StatementKind::Assign { target, value }, span });
        all
    }

    /// A DTL as an LDT, which can be compared and computed with; anything else as it is.
    pub(super) fn dtl_as_number(&mut self, typed: Typed, span: Span) -> Typed {
        match typed {
            Typed::Structured(nanoseconds, _) => {
                let value = Value { kind: ValueKind::Constant(nanoseconds), scalar: Scalar::U64, span };
                Typed::Scalar { value, data_type: DataType::LongDateAndTime }
            }
            dtl @ (Typed::Aggregate(_) | Typed::Delivered(..)) if Self::is_dtl(&dtl) => {
                self.by_block("DTL_TO_LDT", vec![(dtl, span)], span)
            }
            other => other,
        }
    }

    /// Whether something is a DTL.
    pub(super) fn is_dtl(typed: &Typed) -> bool {
        match typed {
            Typed::Structured(..) => true,
            Typed::Aggregate(target) | Typed::Delivered(_, target) => dtl::is_dtl(&target.data_type),
            _ => false,
        }
    }

    /// T_ADD, T_SUB and T_DIFF. `long`: a difference of two DTL is to be an LTIME, because that is what it is assigned to.
    pub(super) fn sum(&mut self, name: &str, call: &ast::Call, long: bool, span: Span) -> Option<Typed> {
        let given = self.named(name, call, &["IN1", "IN2"], span)?;
        let (a, b) = (self.expression(given[0]), self.expression(given[1]));
        if a == Typed::Poison || b == Typed::Poison {
            return None;
        }
        let (first, second) = (given[0].span, given[1].span);
        if Self::is_dtl(&a) || name == "T_DIFF" && Self::is_dtl(&b) {
            return self.sum_of_dtl(name, (a, first), (b, second), long, span);
        }
        let class = |typed: &Typed| match typed {
            Typed::Scalar { data_type, .. } => Kind::of(data_type).map(|kind| kind.class),
            _ => None,
        };
        let is_time = |class| matches!(class, Class::Duration | Class::Date | Class::TimeOfDay | Class::DateAndTime);
        let Some(of_first) = class(&a).filter(|&class| is_time(class)) else {
            let what = self.what(&a);
            let message = format!("`{name}` takes a time, a time of day or a date first, not {what}");
            let moment =
                matches!(a, Typed::Moment(_)) || matches!(&a, Typed::Aggregate(target) if target.data_type == DataType::DateAndTime);
            self.report(Problem::P4011, first, message).help = Some(
                match moment {
                    true => "Call AD_DT_TM, SB_DT_TM or SB_DT_DT for a DATE_AND_TIME.",
                    false => "Write `+` and `-` for numbers.",
                }
                .to_owned(),
            );
            return None;
        };
        let wanted = if name == "T_DIFF" { of_first } else { Class::Duration };
        if class(&b) != Some(wanted) {
            let wanted = match wanted {
                Class::Duration => "a duration",
                Class::TimeOfDay => "a time of day, as the first value is",
                Class::Date => "a date, as the first value is",
                _ => "an LDT, as the first value is",
            };
            let what = self.what(&b);
            self.report(Problem::P4011, second, format!("`{name}` takes {wanted}, not {what}")).help = Some(
                match name {
                    "T_DIFF" => "Convert one of the two to the type of the other one.",
                    _ => "Write a duration such as `T#5s`; the difference of two dates is T_DIFF.",
                }
                .to_owned(),
            );
            return None;
        }
        let operator = if name == "T_ADD" { BinaryOperator::Add } else { BinaryOperator::Subtract };
        Some(self.arithmetic(operator, span, (a, first), (b, second)))
    }

    /// The same with a DTL.
    fn sum_of_dtl(&mut self, name: &str, a: (Typed, Span), b: (Typed, Span), long: bool, span: Span) -> Option<Typed> {
        if name != "T_DIFF" {
            let function = if name == "T_ADD" { "TIA_ADD_DTL" } else { "TIA_SUB_DTL" };
            return Some(self.by_block(function, vec![a, b], span));
        }
        if let Some((other, at)) = [&a, &b].into_iter().find(|(typed, _)| !Self::is_dtl(typed)) {
            let (what, at) = (self.what(other), *at);
            let message = format!("`T_DIFF` takes two values of one type: one is a DTL, and this is {what}");
            self.report(Problem::P4011, at, message).help =
                Some("Convert the DTL, for example with `DTL_TO_DATE`, `DTL_TO_TOD` or `DTL_TO_LDT`.".to_owned());
            return None;
        }
        let difference = self.by_block("TIA_DIFF_DTL", vec![a, b], span);
        Some(if long { difference } else { self.converted_by("LTIME_TO_TIME", difference, span) })
    }

    /// What a conversion with this name makes of a value.
    pub(super) fn converted_by(&mut self, conversion: &str, typed: Typed, span: Span) -> Typed {
        let given = [standard::Given { name: None, kind: super::functions::kind_of(&typed) }];
        let Some(Ok(resolved)) = standard::resolve(conversion, self.dialect, &given) else { return typed };
        let argument = ast::Argument { name: None, direction: ast::Direction::Assigned, value: None, span };
        let call = ast::Call { callee: Expression { kind: ExpressionKind::Missing, span }, arguments: vec![argument] };
        self.composed(conversion, resolved, &call, vec![(typed, span)], span)
    }

    /// T_DIFF where an LTIME is wanted: the difference of two DTL has all its digits.
    pub(super) fn long_difference(&mut self, expression: &Expression, wanted: &DataType) -> Option<Typed> {
        if let ExpressionKind::Parenthesized(inner) = &expression.kind {
            return self.long_difference(inner, wanted);
        }
        let ExpressionKind::Call(call) = &expression.kind else { return None };
        let ExpressionKind::Name(name) = &call.callee.kind else { return None };
        if *wanted != DataType::LongTime || !name.is("T_DIFF") || !self.has_memory_functions() {
            return None;
        }
        matches!(self.quietly(|checker| checker.called(&call.callee)), Called::Standard(_)).then_some(())?;
        Some(self.sum("T_DIFF", call, true, expression.span).unwrap_or(Typed::Poison))
    }

    /// Where an LTIME is wanted, differences of dates have all their nanoseconds and no end after 24 days.
    pub(super) fn want_long(&mut self, expression: &Expression) {
        match &expression.kind {
            ExpressionKind::Parenthesized(inner) => self.want_long(inner),
            ExpressionKind::Binary(ast::BinaryOperator::Subtract, sign, left, right) => {
                self.long_signs.insert(sign.start);
                self.want_long(left);
                self.want_long(right);
            }
            ExpressionKind::Binary(ast::BinaryOperator::Add, _, left, right) => {
                self.want_long(left);
                self.want_long(right);
            }
            ExpressionKind::Binary(ast::BinaryOperator::Multiply | ast::BinaryOperator::Divide, _, left, _) => self.want_long(left),
            _ => {}
        }
    }

    /// Says that a DTL is not compared or computed with what it is not.
    pub(super) fn dtl_beside(&mut self, sign: &str, other: &Typed, at: Span) -> Typed {
        let what = self.what(other);
        self.report(Problem::P6202, at, format!("`{sign}` compares a DTL with a DTL, not with {what}")).help =
            Some("Convert the DTL, for example with `DTL_TO_DATE`, `DTL_TO_TOD` or `DTL_TO_LDT`, or write `DTL#…`.".to_owned());
        Typed::Poison
    }

    /// What a function of the library that is written in ST makes of arguments by position.
    pub(super) fn by_block(&mut self, function: &str, arguments: Vec<(Typed, Span)>, span: Span) -> Typed {
        let Some(block) = self.of_library(function) else { return self.not_built(span, "this instruction") };
        let Some(interface) = self.interface(block, span) else { return Typed::Poison };
        let unnamed =
            |(_, span): &(Typed, Span)| ast::Argument { name: None, direction: ast::Direction::Assigned, value: None, span: *span };
        let call =
            ast::Call { callee: Expression { kind: ExpressionKind::Missing, span }, arguments: arguments.iter().map(unnamed).collect() };
        self.block_function((block, None), &interface, &call, arguments, span)
    }

    /// A function of the library by its name.
    pub(super) fn of_library(&mut self, function: &str) -> Option<BlockId> {
        let provided = library::function(function, self.dialect)?;
        self.names.provided(&provided)
    }

    /// The block that delivers a structure where a standard function is assigned to one.
    pub(super) fn structured_function(&mut self, name: &Name, wanted: &DataType) -> Option<BlockId> {
        if name.quoting == Quoting::Global || self.is_inner(&name.text) {
            return None;
        }
        let by_type = DTL_FUNCTIONS.iter().find(|(one, _)| name.is(one) && dtl::is_dtl(wanted) && self.has_memory_functions());
        let provided = library::function(by_type.map_or(&name.text, |(_, block)| block), self.dialect)?;
        matches!(provided, standard::Provided::Source { .. }).then_some(())?;
        self.names.provided(&provided)
    }

    /// A call of T_CONV and its like as the call of the conversion that the wanted type asks for; `None` for anything else, and `Some(None)`
    /// where there is no such conversion, which is said.
    pub(super) fn by_target(&mut self, expression: &Expression, wanted: &DataType) -> Option<Option<Expression>> {
        if let Some(truncated) = self.truncated(expression, wanted) {
            return Some(Some(truncated));
        }
        if !self.has_memory_functions() || *wanted == DataType::Void {
            return None;
        }
        let (name, call) = called_by_target(expression)?;
        if !matches!(self.quietly(|checker| checker.called(&call.callee)), Called::Standard(_)) {
            return None;
        }
        let upper = name.text.to_ascii_uppercase();
        if upper == "T_COMBINE" {
            let function = match wanted {
                DataType::LongDateAndTime => "CONCAT_DATE_LTOD",
                DataType::DateAndTime => "CONCAT_DATE_TOD",
                wanted if dtl::is_dtl(wanted) => return None,
                wanted => {
                    let message = format!("`T_COMBINE` makes a DTL, an LDT or a DATE_AND_TIME, and {} is wanted here", self.words(wanted));
                    self.report(Problem::P6322, expression.span, message).help =
                        Some("Assign it to a variable of one of these types.".to_owned());
                    return Some(None);
                }
            };
            return Some(Some(renamed(name, function.to_owned(), call, expression.span)));
        }
        let [ast::Argument { value: Some(value), .. }] = call.arguments.as_slice() else {
            self.look_at(&call.arguments);
            self.one_value(&upper, expression.span);
            return Some(None);
        };
        let Some(given) = self.quietly(|checker| checker.type_of(value)) else {
            let typed = self.expression(value);
            if typed != Typed::Poison {
                let what = self.what(&typed);
                self.report(Problem::P6322, value.span, format!("`{upper}` converts a value, and this is {what}"));
            }
            return Some(None);
        };
        if same_type(&given, wanted) {
            return Some(Some(value.clone()));
        }
        let function = word(&given).zip(word(wanted)).map(|(from, to)| format!("{from}_TO_{to}"));
        match function.filter(|function| self.converts(function, &given)) {
            Some(function) => Some(Some(renamed(name, function, call, expression.span))),
            None => {
                let message = format!("`{upper}` makes no {} of {}", self.words(wanted), self.words(&given));
                self.report(Problem::P6322, expression.span, message).help = Some(
                    "T_CONV makes times, dates and integers of each other, S_CONV texts and numbers; convert in two steps where that leads there."
                        .to_owned(),
                );
                Some(None)
            }
        }
    }

    /// Whether there is a conversion with this name from this type; a WSTRING goes the way of a STRING.
    fn converts(&self, function: &str, given: &DataType) -> bool {
        let narrow = function.replace("WSTRING", "STRING");
        let given = match given {
            DataType::WideString(_) => DataType::String(STRING_LENGTH_MAX),
            other => other.clone(),
        };
        let given = [standard::Given { name: None, kind: standard::GivenKind::Typed(given) }];
        narrow == "STRING_TO_STRING" || matches!(standard::resolve(&narrow, self.dialect, &given), Some(Ok(_)))
    }

    fn one_value(&mut self, name: &str, span: Span) {
        self.report(Problem::P6219, span, format!("`{name}` takes one value, and its result goes to what it is assigned to")).help =
            Some(format!("Write `x := {name}(y);`, or name the output, `{name}(IN := y, OUT => x);`."));
    }

    /// The type of an expression that has one.
    fn type_of(&mut self, expression: &Expression) -> Option<DataType> {
        match self.reach(expression) {
            Reached::Target(target) => Some(target.data_type),
            Reached::Other(typed) => match super::functions::kind_of(&typed) {
                standard::GivenKind::Typed(data_type) => Some(data_type),
                standard::GivenKind::Integer { .. } => Some(DataType::DoubleInt),
                standard::GivenKind::Real => Some(DataType::Real),
                standard::GivenKind::Unknown => None,
            },
        }
    }

    /// TRUNC of the standard delivers any integer: that of the place where it goes.
    fn truncated(&mut self, expression: &Expression, wanted: &DataType) -> Option<Expression> {
        let ExpressionKind::Call(call) = &expression.kind else { return None };
        let ExpressionKind::Name(name) = &call.callee.kind else { return None };
        let narrow = Kind::of(wanted).filter(|kind| kind.is_integer() && *wanted != DataType::DoubleInt)?;
        let strict = !self.dialect.switches().numbered_blocks && implicit(Kind::DINT, narrow, self.dialect) == Implicit::No;
        if !name.is("TRUNC") || !strict || !matches!(self.quietly(|checker| checker.called(&call.callee)), Called::Standard(_)) {
            return None;
        }
        Some(renamed(name, format!("TRUNC_{}", wanted.base().word()?), call, expression.span))
    }

    /// An expression whose place was not understood: what is wrong with that place is no mistake of T_CONV and its like.
    pub(super) fn for_nothing(&mut self, expression: &Expression) {
        match called_by_target(expression).filter(|_| self.has_memory_functions()) {
            Some((_, call)) => self.look_at(&call.arguments),
            None => drop(self.expression(expression)),
        }
    }

    /// T_CONV and its like where nothing says what their result is.
    pub(super) fn without_target(&mut self, name: &str, call: &ast::Call, span: Span) -> Option<Typed> {
        if !BY_TARGET.contains(&name) {
            return None;
        }
        self.look_at(&call.arguments);
        if name != "T_COMBINE" && call.arguments.len() > 1 && call.arguments.iter().all(|argument| argument.name.is_none()) {
            self.one_value(name, span);
            return Some(Typed::Poison);
        }
        let message = format!("`{name}` has the type of what it is assigned to, and here nothing says what that is");
        self.report(Problem::P6320, span, message).help =
            Some("Assign it to a variable first, or write the conversion by its name, such as `DTL_TO_LDT`.".to_owned());
        Some(Typed::Poison)
    }

    /// A call of T_CONV and its like with OUT, as the assignment that it is; `None` for anything else.
    pub(super) fn by_output(&mut self, name: &Name, call: &ast::Call, span: Span) -> Option<Option<StatementKind>> {
        if !BY_TARGET.iter().any(|one| name.is(one)) || !self.has_memory_functions() {
            return None;
        }
        let is_output = |argument: &&ast::Argument| argument.name.as_ref().is_some_and(|name| name.is("OUT"));
        let output = call.arguments.iter().find(is_output)?;
        let target = output.value.clone()?;
        if output.direction == ast::Direction::Assigned && !self.judge(Construct::AssignedOutput, output.span) {
            self.look_at(&call.arguments);
            return Some(None);
        }
        let arguments = call.arguments.iter().filter(|argument| !is_output(argument)).cloned().collect();
        let kind = ExpressionKind::Call(Box::new(ast::Call { callee: call.callee.clone(), arguments }));
        Some(self.assign(&target, &Expression { kind, span }, span))
    }
}

/// The same call of another function.
fn renamed(name: &Name, function: String, call: &ast::Call, span: Span) -> Expression {
    let callee = Name { text: function, ..name.clone() };
    let callee = Expression { kind: ExpressionKind::Name(callee), span: call.callee.span };
    let kind = ExpressionKind::Call(Box::new(ast::Call { callee, arguments: call.arguments.clone() }));
    Expression { kind, span }
}

/// The name and the call, if an expression calls T_CONV or its like.
fn called_by_target(expression: &Expression) -> Option<(&Name, &ast::Call)> {
    let ExpressionKind::Call(call) = &expression.kind else { return None };
    let ExpressionKind::Name(name) = &call.callee.kind else { return None };
    (name.quoting != Quoting::Global && BY_TARGET.iter().any(|one| name.is(one))).then_some((name, call))
}
