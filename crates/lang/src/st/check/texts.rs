//! Texts: STRING and WSTRING, what becomes the other one, CASE of a text, and the functions of WSTRINGs.

use sieben_engine::ir::Op;
use sieben_model::interface::{Section, Variable};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, STRING_LENGTH_MAX};

use super::functions::{kind_of, order_of};
use super::places::unknown_length;
use super::typed::{Target, Typed};
use super::types::Kind;
use super::{Checker, operators};
use crate::st::ast::{self, CaseArm, CaseLabel, Expression, ExpressionKind, Name, Quoting};
use crate::st::dialect::{Construct, Judgement};
use crate::st::standard::texts::TextAction;
use crate::st::standard::{self, Given, Parameter, Resolved};
use crate::st::tree::{Argument, Call, Callee, Scalar, Statement, StatementKind, Text, TextFunction, TextRoom, Value, ValueKind, room_of};

/// The functions of texts that a WSTRING has too.
const FUNCTIONS: &[&str] = &["LEN", "LEFT", "RIGHT", "MID", "CONCAT", "INSERT", "DELETE", "REPLACE", "FIND"];

/// What a variable has room for; `None` if it is no text.
pub(super) fn text_room(target: &Target) -> Option<TextRoom> {
    let room = room_of(&target.data_type)?;
    Some(if unknown_length(&target.place) { room.unknown() } else { room })
}

/// The type of a text with this room.
pub(super) fn type_of_room(room: TextRoom) -> DataType {
    let most = u16::from(STRING_LENGTH_MAX);
    let characters = if room.is_unknown() { most } else { room.characters_max };
    if room.wide { DataType::WideString(characters) } else { DataType::String(characters.min(most) as u8) }
}

/// A comparison of the order of two texts with 0.
pub(super) fn compared(op: Op, a: Text, b: Text, span: Span) -> Value {
    let order = Value { kind: ValueKind::CompareTexts(Box::new(a), Box::new(b)), scalar: Scalar::I32, span };
    let zero = Value { kind: ValueKind::Constant(0), scalar: Scalar::I32, span };
    Value { span, ..operators::compute(op, vec![order, zero], Scalar::Bool) }
}

/// What a text may need where it is kept.
pub(super) fn known_room(text: &Text) -> TextRoom {
    match text.room() {
        room if room.is_unknown() => TextRoom { characters_max: STRING_LENGTH_MAX.into(), ..room },
        room => room,
    }
}

/// Whether an argument is a WSTRING.
fn is_wide(typed: &Typed) -> bool {
    matches!(typed, Typed::Text(text) if text.is_wide())
}

impl Checker<'_> {
    /// An expression as a text.
    pub(super) fn text(&mut self, typed: Typed, span: Span) -> Option<Text> {
        match typed {
            Typed::Poison => None,
            Typed::Text(text) => Some(text),
            Typed::Scalar { value, data_type: DataType::Char | DataType::WideChar } => Some(Text::Character(Box::new(value))),
            other => {
                let what = self.what(&other);
                self.report(Problem::P6200, span, format!("a text is wanted here, not {what}")).help =
                    Some("Write characters in quotes, or convert the value with a function such as `INT_TO_STRING`.".to_owned());
                None
            }
        }
    }

    /// An expression as a STRING or a WSTRING. A literal and a single character of a STRING become a WSTRING by themselves.
    pub(super) fn text_of(&mut self, typed: Typed, span: Span, wide: bool) -> Option<Text> {
        let text = self.text(typed, span)?;
        if text.is_wide() == wide {
            return Some(text);
        }
        match text {
            Text::Constant(characters) => Some(Text::WideConstant(characters.into_iter().map(u16::from).collect())),
            Text::Character(value) if wide => Some(Text::Character(Box::new(operators::convert(*value, Scalar::U16)))),
            text => {
                let [wanted, given, function] = match wide {
                    true => ["a WSTRING", "a STRING", "STRING_TO_WSTRING"],
                    false => ["a STRING", "a WSTRING", "WSTRING_TO_STRING"],
                };
                let help = match text {
                    Text::WideConstant(_) => "Write it between apostrophes, `'text'`.".to_owned(),
                    _ => format!("Convert it with `{function}`."),
                };
                self.report(Problem::P6200, span, format!("{wanted} is wanted here, and this is {given}")).help = Some(help);
                None
            }
        }
    }

    /// Two texts of one kind: one of them may be a literal or a character that becomes what the other one is.
    pub(super) fn two_texts(&mut self, (a, left): (Typed, Span), (b, right): (Typed, Span)) -> Option<(Text, Text)> {
        let (a, b) = (self.text(a, left), self.text(b, right));
        let (a, b) = (a?, b?);
        let wide = a.is_wide() || b.is_wide();
        let a = self.text_of(Typed::Text(a), left, wide);
        let b = self.text_of(Typed::Text(b), right, wide);
        a.zip(b)
    }

    /// CASE of a text: IF and ELSIF with the comparisons.
    pub(super) fn case_of_text(
        &mut self,
        text: Text,
        selector: &Expression,
        arms: &[CaseArm],
        otherwise: &[ast::Statement],
    ) -> Option<StatementKind> {
        let span = selector.span;
        let mut sound = self.judge(Construct::CaseOfString, span);
        let mut first = Vec::new();
        // A variable is read where it lies: nothing happens between the comparisons.
        let text = match text {
            Text::Call { .. } | Text::Converted(_) | Text::After(..) => {
                let room = known_room(&text);
                let target = self.temporary_place(room.bytes(), span);
                first.push(Statement { kind: StatementKind::AssignString { target: target.clone(), room, source: text }, span });
                Text::Place { place: target, room }
            }
            text => text,
        };
        let wide = text.is_wide();
        let mut taken: Vec<(Text, Span)> = Vec::new();
        let mut branches = Vec::with_capacity(arms.len());
        for arm in arms {
            let mut condition: Option<Value> = None;
            for label in &arm.labels {
                let Some(label_text) = self.text_label(label, wide, &mut taken) else {
                    sound = false;
                    continue;
                };
                let equal = compared(Op::Equal, text.clone(), label_text, label.span());
                condition = Some(match condition {
                    Some(before) => {
                        let span = before.span.to(label.span());
                        Value { kind: ValueKind::OrElse(Box::new(before), Box::new(equal)), scalar: Scalar::Bool, span }
                    }
                    None => equal,
                });
            }
            let body = self.statements(&arm.body);
            branches.extend(condition.map(|condition| (condition, body)));
        }
        let otherwise = self.statements(otherwise);
        if !sound {
            return None;
        }
        let choice = StatementKind::If { branches, otherwise };
        if first.is_empty() {
            return Some(choice);
        }
        first.push(Statement { kind: choice, span });
        Some(StatementKind::Block(first))
    }

    /// A label of CASE of a text: a constant that no earlier label has.
    fn text_label(&mut self, label: &CaseLabel, wide: bool, taken: &mut Vec<(Text, Span)>) -> Option<Text> {
        let span = label.span();
        let CaseLabel::Value(value) = label else {
            self.report(Problem::P6209, span, "texts have no ranges").help =
                Some("Write the texts one after the other, with commas.".into());
            return None;
        };
        let typed = self.expression(value);
        let text = self.text_of(typed, span, wide)?;
        if !matches!(text, Text::Constant(_) | Text::WideConstant(_)) {
            self.report(Problem::P6229, span, "a label of CASE is a constant, and this is computed at run time");
            return None;
        }
        if let Some(&(_, earlier)) = taken.iter().find(|(known, _)| *known == text) {
            let judgement = self.dialect.judge(Construct::CaseOverlap);
            let problem = if judgement == Judgement::Reject { Problem::P6207 } else { Problem::P6208 };
            self.report(problem, span, "an earlier label has this text already").related.push((earlier, "it stands here".to_owned()));
            return (judgement != Judgement::Reject).then_some(text);
        }
        taken.push((text.clone(), span));
        Some(text)
    }

    /// `STRG_VAL(IN := text, FORMAT := 0, P := 1, OUT => number)`: the number that begins at a character.
    pub(super) fn value_of_text(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("STRG_VAL", call, &["IN", "FORMAT", "P", "OUT"], span)?;
        let target = self.target(given[3])?;
        let Some(kind) = Kind::of(&target.data_type).filter(|kind| kind.is_number()) else {
            let message = format!("`STRG_VAL` writes a number, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, given[3].span, message);
            return None;
        };
        let whole = Value { kind: ValueKind::Constant(u64::from(kind.is_integer())), scalar: Scalar::Bool, span };
        let mut arguments: Vec<(Typed, Span)> = given[..3].iter().map(|value| (self.expression(value), value.span)).collect();
        arguments.push((Typed::Scalar { value: whole, data_type: DataType::Bool }, span));
        let found = self.by_block("TIA_STRG_TEXT", arguments, span);
        let word = kind.data_type().word().unwrap_or("LREAL");
        let found = self.converted_by(&format!("STRING_TO_{word}"), found, span);
        self.store(target, found, given[0].span, span)
    }

    /// `VAL_STRG(IN := number, SIZE := 8, PREC := 2, FORMAT := 0, P := 1, OUT => text)`: a number into a text from a character on.
    pub(super) fn value_in_text(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        const PARAMETERS: [&str; 6] = ["IN", "SIZE", "PREC", "FORMAT", "P", "OUT"];
        let given = self.named("VAL_STRG", call, &PARAMETERS, span)?;
        let typed = self.expression(given[0]);
        // How the digits of a whole number come into a text.
        let whole = match &typed {
            Typed::Integer { .. } => Some("LINT_TO_STRING"),
            Typed::Real { .. } => None,
            Typed::Scalar { data_type: DataType::UnsignedLongInt, .. } => Some("ULINT_TO_STRING"),
            Typed::Scalar { data_type, .. } if let Some(kind) = Kind::of(data_type).filter(|kind| kind.is_number()) => {
                kind.is_integer().then_some("LINT_TO_STRING")
            }
            Typed::Poison => return None,
            other => {
                let what = self.what(other);
                self.report(Problem::P4011, given[0].span, format!("`VAL_STRG` writes a number, not {what}"));
                return None;
            }
        };
        let target = self.target(given[5])?;
        if !matches!(target.data_type, DataType::String(_)) {
            let message = format!("`VAL_STRG` writes into a STRING, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, given[5].span, message);
            return None;
        }
        let named = |name: &str, value: Expression| ast::Argument {
            name: Some(Name { text: name.to_owned(), span: value.span, quoting: Quoting::Bare }),
            direction: ast::Direction::Assigned,
            span: value.span,
            value: Some(value),
        };
        let mut arguments: Vec<ast::Argument> = PARAMETERS.iter().zip(&given).map(|(name, value)| named(name, (*value).clone())).collect();
        let literal = |kind| Expression { kind: ExpressionKind::Literal(ast::Literal { kind, prefix: None }), span };
        let digits = match whole {
            None => literal(ast::LiteralKind::Characters(Vec::new())),
            Some(function) => {
                let nothing = named("IN", literal(ast::LiteralKind::Real { value: 0.0, single: 0.0 }));
                let number = std::mem::replace(&mut arguments[0], nothing);
                let name = Name { text: function.to_owned(), span, quoting: Quoting::Bare };
                let callee = Expression { kind: ExpressionKind::Name(name), span };
                let call = ast::Call { callee, arguments: vec![ast::Argument { name: None, ..number }] };
                Expression { kind: ExpressionKind::Call(Box::new(call)), span }
            }
        };
        arguments.push(named("WHOLE", digits));
        let call = ast::Call { callee: call.callee.clone(), arguments };
        let block = self.of_library("TIA_VAL_STRG")?;
        let interface = self.interface(block, span)?;
        let (call, mut before) = self.arguments(Callee::Function(block), &interface, &call, span)?;
        before.push(Statement { kind: StatementKind::Call(call), span });
        Some(StatementKind::Block(before))
    }

    /// Whether a call is one of a function of WSTRINGs where a block for STRINGs has the same name.
    pub(super) fn calls_wide(&mut self, call: &ast::Call) -> bool {
        let ExpressionKind::Name(name) = &call.callee.kind else { return false };
        name.quoting == Quoting::Bare
            && FUNCTIONS.iter().any(|function| name.is(function))
            && self.quietly(|checker| {
                let mut values = call.arguments.iter().filter_map(|argument| argument.value.as_ref());
                values.any(|value| is_wide(&checker.expression(value)))
            })
    }

    /// What concerns WSTRING: its functions, and conversions to and from it. `None`: the function is another one.
    pub(super) fn wide_function(&mut self, name: &Name, call: &ast::Call, arguments: &[(Typed, Span)], span: Span) -> Option<Typed> {
        let upper = name.text.to_ascii_uppercase();
        if self.dialect.judge(Construct::LongTypes) == Judgement::Reject {
            return None;
        }
        if let Some(typed) = self.wide_conversion(&upper, call, arguments, span) {
            return Some(typed);
        }
        let wide = arguments.iter().any(|(typed, _)| is_wide(typed));
        let base = if self.dialect.switches().wide_names {
            match upper.strip_prefix('W').filter(|base| FUNCTIONS.contains(base)) {
                Some(base) => base,
                None if wide && FUNCTIONS.contains(&upper.as_str()) => {
                    self.report(Problem::P6200, span, format!("`{upper}` takes a STRING, and this is a WSTRING")).help =
                        Some(format!("Call `W{upper}`."));
                    return Some(Typed::Poison);
                }
                None => return None,
            }
        } else if wide && FUNCTIONS.contains(&upper.as_str()) {
            upper.as_str()
        } else {
            return None;
        };
        if arguments.iter().any(|(typed, _)| *typed == Typed::Poison) {
            return Some(Typed::Poison);
        }
        Some(self.wide_call((base, &upper), call, arguments, span).unwrap_or(Typed::Poison))
    }

    fn wide_call(&mut self, (base, name): (&str, &str), call: &ast::Call, arguments: &[(Typed, Span)], span: Span) -> Option<Typed> {
        if base == "LEN" {
            let [(typed, place)] = arguments else {
                self.wrong_count(name, 1, span);
                return None;
            };
            let text = self.text_of(typed.clone(), *place, true)?;
            let value = Value { kind: ValueKind::Length(Box::new(text)), scalar: Scalar::I16, span };
            return Some(Typed::Scalar { value, data_type: DataType::Int });
        }
        let provided = standard::library::function(base, self.dialect)?;
        let function = TextFunction { wide: true, ..TextFunction::of(&provided, base, self.dialect)? };
        let block = self.names.provided(&provided)?;
        let interface = self.interface(block, call.callee.span)?;
        let formals: Vec<Variable> = interface.parameters().filter(|formal| formal.section == Section::Input).cloned().collect();
        let many = function.action == TextAction::Concat && arguments.len() > formals.len() && !self.dialect.switches().wide_names;
        let names: Vec<Parameter> = match many {
            true => (1..=arguments.len()).map(|number| Parameter { name: format!("IN{number}"), data_type: DataType::Void }).collect(),
            false => formals.iter().map(|formal| Parameter { name: formal.name.clone(), data_type: DataType::Void }).collect(),
        };
        if let Some(unknown) = call
            .arguments
            .iter()
            .filter_map(|argument| argument.name.as_ref())
            .find(|given| !names.iter().any(|known| given.is(&known.name)))
        {
            let known: Vec<String> = names.iter().map(|known| format!("`{}`", known.name)).collect();
            self.report(Problem::P3009, unknown.span, format!("`{name}` has no input `{}`", unknown.text)).help =
                Some(format!("It has {}.", known.join(", ")));
            return None;
        }
        if arguments.len() != names.len() {
            self.wrong_count(name, names.len(), span);
            return None;
        }
        let mut given = order_of(&names, call).into_iter().filter_map(|index| arguments.get(index).cloned());
        let mut folded = Vec::new();
        for formal in &formals {
            let (typed, place) = given.next()?;
            folded.push(self.wide_argument(formal, typed, place)?);
        }
        let mut result = self.wide_result(function, block, folded, span);
        for (typed, place) in given {
            let first = self.wide_argument(&formals[0], result, span)?;
            let second = self.wide_argument(&formals[1], typed, place)?;
            result = self.wide_result(function, block, vec![first, second], span);
        }
        Some(result)
    }

    fn wrong_count(&mut self, name: &str, count: usize, span: Span) {
        self.report(Problem::P6219, span, format!("`{name}` takes {}", super::calls::counted(count, "parameter")));
    }

    fn wide_argument(&mut self, formal: &Variable, typed: Typed, span: Span) -> Option<Argument> {
        let parameter = formal.offset;
        Some(match room_of(&formal.data_type) {
            Some(room) => {
                let text = self.text_of(typed, span, true)?;
                Argument::Text { parameter, text, room: TextRoom { wide: true, ..room } }
            }
            None => {
                let typed = self.number_in_text(formal, typed);
                Argument::Value { parameter, value: self.coerce(typed, span, &formal.data_type)? }
            }
        })
    }

    /// A length or a position in a text as an INT, if it may be of any integer type: beyond the limits of INT there are no characters.
    pub(super) fn number_in_text(&self, formal: &Variable, typed: Typed) -> Typed {
        if formal.data_type != DataType::Int || !self.dialect.switches().any_integer_in_texts {
            return typed;
        }
        let Typed::Scalar { value, data_type } = typed else { return typed };
        let is_integer = Kind::of(&data_type).is_some_and(Kind::is_integer);
        if !is_integer || matches!(data_type, DataType::Enumeration(_)) {
            return Typed::Scalar { value, data_type };
        }
        let (least, most) = standard::operators::limits(value.scalar);
        let (low, high) = standard::operators::limits(Scalar::I16);
        if low <= least && most <= high {
            return Typed::Scalar { value, data_type };
        }
        let span = value.span;
        let (wide, ops) = match least {
            0 => (Scalar::U64, &[(Op::MinU64, high)][..]),
            _ => (Scalar::I64, &[(Op::MinI64, high), (Op::MaxI64, low)][..]),
        };
        let limited = ops.iter().fold(operators::convert(value, wide), |value, &(op, limit)| {
            let limit = Value { kind: ValueKind::Constant(limit as u64), scalar: wide, span };
            operators::compute(op, vec![value, limit], wide)
        });
        Typed::Scalar { value: operators::convert(limited, Scalar::I16), data_type: DataType::Int }
    }

    fn wide_result(&mut self, function: TextFunction, block: sieben_model::block::BlockId, arguments: Vec<Argument>, span: Span) -> Typed {
        let finds = function.action == TextAction::Find;
        let result = if finds { DataType::Int } else { DataType::WideString(STRING_LENGTH_MAX.into()) };
        let callee = Callee::Function(block);
        let call =
            Call { callee, arguments, enable: None, result, clears_ok: self.reads_ok, of_library: true, written_out: Some(function), span };
        self.result_of(call, Vec::new(), span)
    }

    /// `X_TO_WSTRING`, `WSTRING_TO_X`, and `TO_X` of a WSTRING: through a STRING.
    fn wide_conversion(&mut self, name: &str, call: &ast::Call, arguments: &[(Typed, Span)], span: Span) -> Option<Typed> {
        let (from, to) = match name.strip_prefix("TO_") {
            Some(to) => (None, to),
            None => name.split_once("_TO_").map(|(from, to)| (Some(from), to))?,
        };
        let [(typed, place)] = arguments else { return None };
        let from_wide = from == Some("WSTRING") || from.is_none() && is_wide(typed);
        if !from_wide && to != "WSTRING" || from.is_none() && !self.dialect.switches().operators_as_functions {
            return None;
        }
        if *typed == Typed::Poison {
            return Some(Typed::Poison);
        }
        let converted = |text: Text| Typed::Text(Text::Converted(Box::new(text)));
        let inner = if from_wide {
            let text = self.text_of(typed.clone(), *place, true)?;
            match to {
                "WSTRING" => return Some(Typed::Text(text)),
                "STRING" => return Some(converted(text)),
                "WCHAR" => {
                    let block = standard::library::function("WSTRING_TO_WCHAR", self.dialect)?;
                    let resolved =
                        Resolved { parameters: Vec::new(), result: DataType::WideChar, meaning: standard::Meaning::Block(block) };
                    return Some(self.composed(name, resolved, call, vec![(Typed::Text(text), *place)], span));
                }
                _ => converted(text),
            }
        } else {
            match (from, typed) {
                (Some("STRING") | None, Typed::Text(_)) | (Some("CHAR" | "WCHAR"), _) => {
                    let text = match (from, typed) {
                        (Some("WCHAR"), Typed::Scalar { data_type: DataType::WideChar, .. }) | (None | Some("STRING"), _) => {
                            self.text(typed.clone(), *place)
                        }
                        (Some("WCHAR"), typed) => {
                            let value = self.coerce(typed.clone(), *place, &DataType::WideChar);
                            value.map(|value| Text::Character(Box::new(value)))
                        }
                        (_, typed) => {
                            let value = self.coerce(typed.clone(), *place, &DataType::Char);
                            value.map(|value| Text::Character(Box::new(value)))
                        }
                    };
                    let Some(text) = text else { return Some(Typed::Poison) };
                    return Some(if text.is_wide() { Typed::Text(text) } else { converted(text) });
                }
                _ => typed.clone(),
            }
        };
        // The same function of a STRING does the rest.
        let narrow = match (from_wide, from) {
            (true, _) => format!("STRING_TO_{to}"),
            (false, Some(from)) => format!("{from}_TO_STRING"),
            (false, None) => "TO_STRING".to_owned(),
        };
        let given = [Given { name: None, kind: kind_of(&inner) }];
        let typed = match standard::resolve(&narrow, self.dialect, &given)? {
            Err(refusal) => self.refused(refusal, arguments, span),
            Ok(resolved) => self.composed(&narrow, resolved, call, vec![(inner, *place)], span),
        };
        Some(match typed {
            Typed::Text(text) if !from_wide => converted(text),
            other => other,
        })
    }
}
