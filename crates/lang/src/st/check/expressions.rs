//! Expressions → values: operators, types of operands and results, constants.

use sieben_engine::ir::Op;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, STRING_LENGTH_MAX};

use super::literals::{self, Misfit};
use super::places::Reached;
use super::pointers::{is_address, is_pointer, leaves_text, pointer_as};
use super::typed::Typed;
use super::types::{Class, Implicit, Kind, common, implicit};
use super::{Checker, operators};
use crate::st::ast::{BinaryOperator, DateAndTimeForm, Expression, ExpressionKind, Literal, LiteralKind, UnaryOperator};
use crate::st::dialect::{Calendar, Construct, Dialect, Judgement, LostResults};
use crate::st::dtl;
use crate::st::standard::{self, Given, GivenKind};
use crate::st::tree::{Scalar, Text, Value, ValueKind};

/// Characters of the longest WSTRING.
const WIDE_LENGTH_MAX: usize = 16_382;
/// Values of an enumeration that a message names.
const NAMED_VALUES_MAX: usize = 6;
/// What DATE of the S7 counts from.
const DAYS_FROM_1970_TO_1990: u64 = 7_305;
const MILLISECONDS_OF_DAY: u64 = 86_400_000;
const NANOSECONDS_OF_MILLISECOND: u64 = 1_000_000;
/// What is done where an address and a shorter number meet.
const KEEP_ADDRESS: &str = "An address has 64 bits here: keep it in a POINTER TO, or in a variable of type LWORD or __XWORD.";

impl Checker<'_> {
    /// What an expression is.
    pub(super) fn expression(&mut self, expression: &Expression) -> Typed {
        let span = expression.span;
        match &expression.kind {
            ExpressionKind::Literal(Literal { kind, prefix }) => self.literal(kind, *prefix, span),
            ExpressionKind::Parenthesized(inner) => self.expression(inner),
            ExpressionKind::Unary(operator, operand) => self.unary(*operator, operand, span),
            ExpressionKind::Binary(operator, place, left, right) => self.binary(*operator, *place, left, right),
            ExpressionKind::Call(call) => self.call_value(call, span),
            // Where the dialect does not have it, the parser has said so.
            ExpressionKind::Assign(..) => match self.dialect.judge(Construct::AssignmentExpression) {
                Judgement::Reject => Typed::Poison,
                _ => self.not_built(span, "an assignment inside an expression"),
            },
            ExpressionKind::This => match self.this(span) {
                Some(target) => Typed::Aggregate(target),
                None => Typed::Poison,
            },
            ExpressionKind::Super => {
                let message = "SUPER is no value: it stands before a method, or is called itself";
                self.report(Problem::P6286, span, message).help = Some("Write `SUPER^.Method()`, or `THIS^` for the instance.".to_owned());
                Typed::Poison
            }
            ExpressionKind::Missing => Typed::Poison,
            ExpressionKind::Name(_)
            | ExpressionKind::Global(_)
            | ExpressionKind::EnumValue { .. }
            | ExpressionKind::Address(_)
            | ExpressionKind::Member(..)
            | ExpressionKind::Index(..)
            | ExpressionKind::Dereference(_)
            | ExpressionKind::Slice(..)
            | ExpressionKind::Wire(_)
            | ExpressionKind::Contact(_)
            | ExpressionKind::DataAddress(_) => match self.reach(expression) {
                Reached::Target(target) => self.load(target),
                Reached::Other(typed) => typed,
            },
        }
    }

    /// The same where a type is expected: a bare name may be a value of that enumeration.
    pub(super) fn expression_for(&mut self, expression: &Expression, wanted: &DataType) -> Typed {
        if let (ExpressionKind::Name(name), DataType::Enumeration(_)) = (&expression.kind, wanted)
            && self.names.local(&name.text).is_none()
            && let Some(value) = self.value_of(wanted, name)
        {
            return value;
        }
        if let Some(typed) = self.long_difference(expression, wanted) {
            return typed;
        }
        if *wanted == DataType::LongTime {
            self.want_long(expression);
        }
        if let Some(typed) = self.untyped_as(expression, wanted) {
            return self.expression(&typed);
        }
        match self.by_target(expression, wanted) {
            Some(Some(conversion)) => self.expression(&conversion),
            Some(None) => Typed::Poison,
            None => self.expression(expression),
        }
    }

    /// An expression as a value of a type.
    pub(super) fn value(&mut self, expression: &Expression, wanted: &DataType) -> Option<Value> {
        let typed = self.expression_for(expression, wanted);
        self.coerce(typed, expression.span, wanted)
    }

    /// A condition.
    pub(super) fn condition(&mut self, expression: &Expression) -> Option<Value> {
        let typed = self.expression(expression);
        match &typed {
            Typed::Scalar { data_type: DataType::Bool, .. } | Typed::Poison => self.coerce(typed, expression.span, &DataType::Bool),
            Typed::Integer { value: 0 | 1, .. } => self.coerce(typed, expression.span, &DataType::Bool),
            other => {
                let what = self.what(other);
                let number = matches!(other, Typed::Integer { .. })
                    || matches!(other, Typed::Scalar { data_type, .. } if Kind::of(data_type).is_some_and(|kind| kind.class != Class::Real));
                let diagnostic = self.report(Problem::P6203, expression.span, format!("a condition is BOOL, not {what}"));
                if number {
                    diagnostic.help = Some("Compare it, for example with `<> 0`.".to_owned());
                }
                None
            }
        }
    }

    /// A constant as written.
    pub(super) fn literal(&mut self, literal: &LiteralKind, prefix: Option<&'static str>, span: Span) -> Typed {
        if let LiteralKind::DateAndTime { nanoseconds, form: DateAndTimeForm::Structured } = literal {
            let nanoseconds = *nanoseconds as u64;
            return Typed::Structured(nanoseconds, dtl::bytes(nanoseconds));
        }
        let natural = prefix.and_then(DataType::from_any_word).or_else(|| literals::natural(literal, self.dialect));
        let natural = natural.map(|data_type| self.native(data_type));
        let counts_nanoseconds =
            matches!(literal, LiteralKind::Date { long: true, .. } | LiteralKind::DateAndTime { form: DateAndTimeForm::Long, .. });
        let natural = match self.dialect.switches().calendar {
            Calendar::Long if counts_nanoseconds => natural.map(|data_type| data_type.of_nanoseconds("L")),
            _ => natural,
        };
        match (literal, natural) {
            (LiteralKind::Integer { value, radix }, None) => Typed::Integer { value: *value, radix: *radix },
            (LiteralKind::Real { value, single }, None) => Typed::Real { value: *value, single: *single },
            (LiteralKind::Characters(text), None | Some(DataType::String(_))) if text.len() <= 254 => {
                Typed::Text(Text::Constant(text.clone()))
            }
            (LiteralKind::Characters(text), None | Some(DataType::String(_))) => {
                let message = format!("this text has {} characters, and a STRING holds at most 254", text.len());
                self.report(Problem::P4001, span, message);
                Typed::Poison
            }
            (LiteralKind::WideCharacters(text), None | Some(DataType::WideString(_))) if text.len() <= WIDE_LENGTH_MAX => {
                Typed::Text(Text::WideConstant(text.clone()))
            }
            (LiteralKind::WideCharacters(text), None | Some(DataType::WideString(_))) => {
                let message = format!("this text has {} characters, and a WSTRING holds at most {WIDE_LENGTH_MAX}", text.len());
                self.report(Problem::P4001, span, message);
                Typed::Poison
            }
            (LiteralKind::Null, _) => Typed::Null,
            (LiteralKind::Pointer(value), _) => Typed::Pointer(value.clone()),
            (LiteralKind::DateAndTime { nanoseconds, .. }, Some(DataType::DateAndTime)) => match literals::date_and_time(*nanoseconds) {
                Some(bytes) => Typed::Moment(bytes),
                None => {
                    self.report(Problem::P4001, span, "a DATE_AND_TIME lies in the years 1990 to 2089");
                    Typed::Poison
                }
            },
            (_, Some(data_type)) => match Kind::of(&data_type).ok_or(Misfit::Type).and_then(|kind| {
                // A prefix says how a number is meant: `WORD#5`, `BOOL#1`.
                literals::bits(literal, kind, self.dialect).map(|(bits, _)| (bits, kind))
            }) {
                Ok((bits, kind)) => {
                    let scalar = kind.scalar(self.dialect);
                    Typed::Scalar { value: Value { kind: ValueKind::Constant(bits), scalar, span }, data_type }
                }
                Err(misfit) => {
                    self.misfit(&misfit, &data_type, span);
                    Typed::Poison
                }
            },
            (_, None) => Typed::Poison,
        }
    }

    /// What DATE and DATE_AND_TIME mean in the dialect.
    fn native(&self, data_type: DataType) -> DataType {
        match (self.dialect.switches().calendar, data_type) {
            (Calendar::Long, DataType::Date) => DataType::LongDate,
            (Calendar::Long, DataType::DateAndTime) => DataType::LongDateAndTime,
            (_, other) => other,
        }
    }

    fn misfit(&mut self, misfit: &Misfit, data_type: &DataType, span: Span) {
        match misfit {
            Misfit::Range(range) => {
                let message = format!("this constant is outside the range of {}, {range}", self.words(data_type));
                self.report(Problem::P4001, span, message);
            }
            Misfit::Type => {
                self.report(Problem::P4006, span, format!("this constant is no value of type {}", self.words(data_type)));
            }
        }
    }

    /// An expression as a value with its type: a number without a type gets the one that it has by itself.
    pub(super) fn scalar(&mut self, typed: Typed, span: Span) -> Option<(Value, DataType)> {
        let (literal, kind) = match typed {
            Typed::Poison => return None,
            Typed::Scalar { value, data_type } => return Some((value, data_type)),
            Typed::Number { data_type, value } => return Some((value, data_type)),
            Typed::Integer { value, radix } => (LiteralKind::Integer { value, radix }, literals::integer_kind(value)),
            Typed::Real { value, single } => (LiteralKind::Real { value, single }, self.real_kind(value, single)),
            Typed::Text(Text::Constant(text)) if text.len() == 1 => {
                (LiteralKind::Characters(text), Kind { class: Class::Character, bits: 8 })
            }
            Typed::Text(Text::WideConstant(text)) if text.len() == 1 => {
                (LiteralKind::WideCharacters(text), Kind { class: Class::Character, bits: 16 })
            }
            other => {
                let what = self.what(&other);
                self.report(Problem::P6202, span, format!("a number or another elementary value belongs here, not {what}"));
                return None;
            }
        };
        match literals::bits(&literal, kind, self.dialect) {
            Ok((bits, _)) => Some((Value { kind: ValueKind::Constant(bits), scalar: kind.scalar(self.dialect), span }, kind.data_type())),
            Err(misfit) => {
                self.misfit(&misfit, &kind.data_type(), span);
                None
            }
        }
    }

    /// The type of a number with a point that nothing else gives one.
    fn real_kind(&self, value: f64, single: f32) -> Kind {
        let loses = f64::from(single) != value && self.dialect.switches().real_literal_widens;
        // A decimal fraction is never exact: digits count that a REAL cannot show.
        let needs = loses && ((f64::from(single) - value) / value).abs() > 1e-7 || single.is_infinite() && value.is_finite();
        if needs { Kind::LREAL } else { Kind::REAL }
    }

    /// An expression as a value of the wanted type; an implicit conversion is written out.
    pub(super) fn coerce(&mut self, typed: Typed, span: Span, wanted: &DataType) -> Option<Value> {
        let Some(kind) = Kind::of(wanted) else {
            if typed != Typed::Poison && *wanted != DataType::Void {
                let what = self.what(&typed);
                self.report(Problem::P6200, span, format!("{} is wanted here, not {what}", self.words(wanted)));
            }
            return None;
        };
        let scalar = kind.scalar(self.dialect);
        let typed = match self.upwards(typed, span, wanted) {
            Ok(value) => return Some(value),
            Err(typed) => typed,
        };
        let literal = match typed {
            Typed::Poison => return None,
            Typed::Integer { value: 0, .. } if kind.class == Class::Reference && self.dialect.has_pointers() => LiteralKind::Null,
            Typed::Integer { value, radix } => LiteralKind::Integer { value, radix },
            Typed::Real { value, single } => LiteralKind::Real { value, single },
            Typed::Text(Text::Constant(text)) if kind.class == Class::Character => LiteralKind::Characters(text),
            Typed::Text(Text::WideConstant(text)) if kind.class == Class::Character => LiteralKind::WideCharacters(text),
            Typed::Null if kind.class == Class::Reference => LiteralKind::Null,
            Typed::Scalar { value, data_type } => return self.convert(value, &data_type, wanted, span),
            other => {
                let (what, help) = (self.what(&other), self.reader_of(&other, wanted));
                let diagnostic = self.report(Problem::P6200, span, format!("{} is wanted here, not {what}", self.words(wanted)));
                if help.is_some() {
                    diagnostic.help = help;
                }
                return None;
            }
        };
        if let DataType::Enumeration(_) = wanted
            && !(self.dialect.has_pointers() && matches!(literal, LiteralKind::Integer { .. }))
        {
            let message = format!("a value of {} is wanted here, and a number is none", self.words(wanted));
            self.report(Problem::P6200, span, message).help = names_of_values(wanted);
            return None;
        }
        if let LiteralKind::Integer { value, .. } = literal
            && self.wraps(value, kind)
        {
            let message = format!("{} has no negative values: {value} is {} here", self.words(wanted), value + (1 << kind.bits));
            self.report(Problem::P6201, span, message);
            let value = Value { kind: ValueKind::Constant(value as u64 & literals::mask(kind.bits)), scalar, span };
            return self.within_subrange(&value, wanted, span).then_some(value);
        }
        match literals::bits(&literal, kind, self.dialect) {
            Ok((bits, construct)) => {
                if construct.is_some_and(|construct| !self.judge(construct, span)) {
                    return None;
                }
                let value = Value { kind: ValueKind::Constant(bits), scalar, span };
                self.within_subrange(&value, wanted, span).then_some(value)
            }
            Err(Misfit::Type) if matches!(literal, LiteralKind::Real { .. }) => {
                let message = format!("{} is wanted here, and this number is REAL", self.words(wanted));
                self.report(Problem::P6200, span, message).help =
                    Some("Write a whole number, or convert it, for example with ROUND or REAL_TO_INT.".into());
                None
            }
            Err(Misfit::Type) => {
                let shown = match literal {
                    LiteralKind::Characters(_) => "a text",
                    LiteralKind::WideCharacters(_) => "a text between `\"`, which is a WSTRING",
                    _ => "a number",
                };
                let help = self.as_written(&literal, wanted);
                let diagnostic = self.report(Problem::P6200, span, format!("{} is wanted here, not {shown}", self.words(wanted)));
                if help.is_some() {
                    diagnostic.help = help;
                }
                None
            }
            Err(misfit) => {
                self.misfit(&misfit, wanted, span);
                None
            }
        }
    }

    /// Whether a negative number becomes the pattern of bits of a type without a sign, as a variable with a sign does there.
    fn wraps(&self, value: i128, kind: Kind) -> bool {
        let unsigned = kind.class == Class::Unsigned || kind.class == Class::Bits && kind.bits > 1;
        let signed = Kind { class: Class::Signed, bits: kind.bits };
        let least = -(1_i128 << (kind.bits.max(1) - 1));
        unsigned
            && !self.keeps_sign
            && self.dialect.has_pointers()
            && (least..0).contains(&value)
            && implicit(signed, kind, self.dialect) != Implicit::No
    }

    /// The function that reads a value from a text, or the values of which one is wanted.
    fn reader_of(&self, typed: &Typed, wanted: &DataType) -> Option<String> {
        if let DataType::Enumeration(_) = wanted {
            return names_of_values(wanted);
        }
        if !matches!(typed, Typed::Text(text) if !text.is_wide()) {
            return None;
        }
        let function = format!("STRING_TO_{}", self.word_in_names(wanted.base())?);
        self.takes(&function, &DataType::String(STRING_LENGTH_MAX)).then(|| format!("Convert it with `{function}`."))
    }

    /// Whether there is a function that takes one value of a type.
    fn takes(&self, function: &str, given: &DataType) -> bool {
        let given = [Given { name: None, kind: GivenKind::Typed(given.clone()) }];
        matches!(standard::resolve(function, self.dialect, &given), Some(Ok(_)))
    }

    /// How a number without a type is written as a constant of a duration or a date.
    fn as_written(&self, literal: &LiteralKind, wanted: &DataType) -> Option<String> {
        let LiteralKind::Integer { value, radix: 10 } = *literal else { return None };
        // What its duration is written with, and milliseconds that it has at least and at most.
        let (prefix, least, most) = match wanted.base() {
            DataType::S5Time => ("S5T", 10, 9_990_000),
            DataType::LongTime => ("LT", 1, i128::from(i64::MAX) / 1_000_000),
            DataType::Time => ("T", 1, i128::from(i32::MAX)),
            DataType::Date | DataType::LongDate => return Some("Write a date, such as `D#2026-01-31`.".to_owned()),
            DataType::TimeOfDay | DataType::LongTimeOfDay => return Some("Write a time of day, such as `TOD#12:00:00`.".to_owned()),
            DataType::DateAndTime | DataType::LongDateAndTime => {
                return Some("Write a date with a time, such as `DT#2026-01-31-12:00:00`.".to_owned());
            }
            _ => return None,
        };
        let value = if (least..=most).contains(&value) { value } else { 500 };
        Some(format!("Write a duration with its unit, such as `{prefix}#{value}ms`."))
    }

    /// Whether a constant lies in the limits of a subrange.
    fn within_subrange(&mut self, value: &Value, wanted: &DataType, span: Span) -> bool {
        let DataType::Subrange(subrange) = wanted else { return true };
        let (least, most) = self.range_of(value);
        if most < subrange.low || least > subrange.high {
            let shown = if least == most { least.to_string() } else { format!("{least}..{most}") };
            let message = format!("{shown} is outside {}({}..{})", self.words(subrange.base.base()), subrange.low, subrange.high);
            self.report(Problem::P4001, span, message);
            return false;
        }
        true
    }

    /// A value of one type as a value of another one.
    fn convert(&mut self, value: Value, from: &DataType, wanted: &DataType, span: Span) -> Option<Value> {
        let (source, target) = (Kind::of(from)?, Kind::of(wanted)?);
        let scalar = target.scalar(self.dialect);
        if from == wanted {
            return Some(operators::convert(value, scalar));
        }
        let allowed = match (from, wanted) {
            (DataType::Enumeration(_), DataType::Enumeration(_)) => Implicit::No,
            (_, DataType::Enumeration(_)) if self.dialect.has_pointers() && source.is_integer() => Implicit::Yes,
            (DataType::Enumeration(_), _) if self.dialect.switches().integer_bits_min > 8 => implicit(source, target, self.dialect),
            (DataType::Enumeration(_), _) | (_, DataType::Enumeration(_)) => Implicit::No,
            (DataType::Reference(a), DataType::Reference(b)) if same_type(&a.target, &b.target) => Implicit::Yes,
            // An address is one of whatever the pointer wants to see there.
            (a, b) if is_pointer(a) && (is_pointer(b) || is_address(b)) || is_address(a) && is_pointer(b) => Implicit::Yes,
            (DataType::Reference(_), _) | (_, DataType::Reference(_)) => Implicit::No,
            _ => implicit(source, target, self.dialect),
        };
        // A constant that fits needs no wider type: `USINT#5` may go into an INT of any sign.
        match allowed {
            Implicit::Yes => {}
            Implicit::Warned(loss) => {
                if !matches!(value.kind, ValueKind::Constant(_)) {
                    let message = format!("{} becomes {} here: {}", self.words(from), self.words(wanted), loss.words());
                    self.report(Problem::P6201, span, message);
                }
            }
            Implicit::No => {
                self.no_conversion(from, wanted, span);
                return None;
            }
        }
        if is_pointer(from) || is_pointer(wanted) {
            self.counts_characters |= leaves_text(from, wanted);
            return Some(operators::convert(pointer_as(value, from, wanted), scalar));
        }
        let value = operators::convert(lengthened(value, source, target, self.dialect), scalar);
        self.within_subrange(&value, wanted, span).then_some(value)
    }

    /// The word of a type in the names of conversions.
    fn word_in_names(&self, data_type: &DataType) -> Option<&'static str> {
        match (data_type, self.dialect.switches().calendar) {
            (DataType::LongDate, Calendar::Long) => Some("DATE"),
            (DataType::LongDateAndTime, Calendar::Long) => Some("DT"),
            (DataType::TimeOfDay, _) => Some("TOD"),
            (DataType::DateAndTime, _) => Some("DT"),
            _ => data_type.word(),
        }
    }

    /// Says that a type does not become another one, and what does it.
    pub(super) fn no_conversion(&mut self, from: &DataType, wanted: &DataType, span: Span) {
        let message = format!("{} is wanted here, and this is {}", self.words(wanted), self.words(from));
        let (source, target) = (self.word_in_names(from.base()), self.word_in_names(wanted.base()));
        let function =
            source.zip(target).filter(|(source, target)| source != target).map(|(source, target)| format!("{source}_TO_{target}"));
        // A date made of a time of day is its bits, which nobody means.
        let part_of_time = |data_type: &DataType| match Kind::of(data_type).map(|kind| kind.class) {
            Some(class @ (Class::Date | Class::TimeOfDay | Class::Duration)) => Some(class),
            _ => None,
        };
        let meant = part_of_time(from).zip(part_of_time(wanted)).is_none_or(|(a, b)| a == b);
        let function = function.filter(|_| meant);
        let mut help =
            function.filter(|function| self.takes(function, from.base())).map(|function| format!("Convert it with `{function}`."));
        if let DataType::Enumeration(_) = wanted {
            help = names_of_values(wanted);
        } else if let DataType::Enumeration(_) = from {
            let number = target.filter(|_| Kind::of(wanted).is_some_and(|kind| kind.is_number() || kind.class == Class::Bits));
            help = Some(match number {
                Some(target) => format!("Convert it with `TO_{target}`."),
                None => "Convert its number, which `TO_INT` gives.".to_owned(),
            });
        } else if help.is_none() && (is_pointer(from) || is_pointer(wanted) && Kind::of(from).is_some()) {
            help = Some(KEEP_ADDRESS.to_owned());
        }
        let diagnostic = self.report(Problem::P6200, span, message);
        if help.is_some() {
            diagnostic.help = help;
        }
    }

    fn unary(&mut self, operator: UnaryOperator, operand: &Expression, span: Span) -> Typed {
        let typed = self.expression(operand);
        match (operator, typed) {
            (_, Typed::Poison) => Typed::Poison,
            (UnaryOperator::Minus, Typed::Integer { value, radix }) => Typed::Integer { value: -value, radix },
            (UnaryOperator::Minus, Typed::Real { value, single }) => Typed::Real { value: -value, single: -single },
            (UnaryOperator::Plus, number @ (Typed::Integer { .. } | Typed::Real { .. })) => number,
            (UnaryOperator::Not, Typed::Integer { value, radix }) => {
                // A pattern of bits is as wide as the smallest of WORD, DWORD and LWORD that holds it.
                let bits = [16, 32, 64].into_iter().find(|&bits| value >= 0 && value >> bits == 0).unwrap_or(64);
                Typed::Integer { value: i128::from(!(value as u64) & literals::mask(bits)), radix: radix.max(2) }
            }
            (operator, typed) => {
                let Some((value, data_type)) = self.scalar(typed, operand.span) else { return Typed::Poison };
                self.unary_scalar(operator, value, data_type, span)
            }
        }
    }

    fn unary_scalar(&mut self, operator: UnaryOperator, value: Value, data_type: DataType, span: Span) -> Typed {
        let Some(kind) = Kind::of(&data_type) else { return self.no_operand(operator_sign(operator), &data_type, span) };
        let plain = kind.data_type();
        // A bit string that counts as a number has a negative one, as `0 - x` has it.
        let counts = kind.class == Class::Bits
            && kind.bits > 1
            && implicit(Kind { class: Class::Bits, bits: 16 }, Kind { class: Class::Unsigned, bits: 16 }, self.dialect) == Implicit::Yes;
        let kind = match operator {
            UnaryOperator::Minus | UnaryOperator::Plus if counts => Kind { class: Class::Unsigned, ..kind },
            _ => kind,
        };
        match operator {
            UnaryOperator::Plus if kind.is_number() || kind.class == Class::Duration => Typed::Scalar { value, data_type },
            UnaryOperator::Minus if kind.is_number() || kind.class == Class::Duration => {
                if kind.class == Class::Unsigned {
                    let widened = self.dialect.switches().integer_bits_min > 8;
                    if !widened {
                        let message = format!("{} has no negative values", self.words(&data_type));
                        self.report(Problem::P6202, span, message).help = Some("Convert it to a signed type first.".to_owned());
                        return Typed::Poison;
                    }
                    self.report(Problem::P6201, span, format!("{} has no negative values: the result wraps", self.words(&data_type)));
                }
                let value = operators::convert(value, self.working(kind));
                let Some(operation) = operators::negation(value.scalar) else { return Typed::Poison };
                let scalar = value.scalar;
                let value = self.operation(operation, vec![value], scalar);
                Typed::Scalar { value: Value { span, ..value }, data_type: plain }
            }
            UnaryOperator::Not if kind.class == Class::Bits || self.bits_of_integers(kind) => {
                let value = operators::convert(value, kind.scalar(self.dialect));
                let Some(op) = operators::inversion(value.scalar) else { return Typed::Poison };
                let scalar = value.scalar;
                Typed::Scalar { value: Value { span, ..operators::compute(op, vec![value], scalar) }, data_type: plain }
            }
            _ => self.no_operand(operator_sign(operator), &data_type, span),
        }
    }

    fn no_operand(&mut self, sign: &str, data_type: &DataType, span: Span) -> Typed {
        self.report(Problem::P6202, span, format!("`{sign}` does not take {}", self.words(data_type)));
        Typed::Poison
    }

    /// Whether the dialect lets AND, OR, XOR and NOT work on the bits of integers.
    pub(super) fn bits_of_integers(&self, kind: Kind) -> bool {
        kind.is_integer()
            && implicit(Kind { class: Class::Unsigned, bits: 16 }, Kind { class: Class::Bits, bits: 16 }, self.dialect) == Implicit::Yes
    }

    /// The scalar in which numbers of a kind are computed.
    fn working(&self, kind: Kind) -> Scalar {
        let scalar = kind.scalar(self.dialect);
        let wide = self.dialect.switches().integer_bits_min;
        match scalar {
            Scalar::I8 | Scalar::I16 if wide >= 32 => Scalar::I32,
            Scalar::U8 | Scalar::U16 if wide >= 32 => Scalar::U32,
            other => other,
        }
    }

    /// An operation that tells ENO or OK if it fails, in a block that looks at them, or else the Host.
    fn operation(&mut self, operation: operators::Operation, args: Vec<Value>, scalar: Scalar) -> Value {
        let told = match self.lost {
            LostResults::All => true,
            LostResults::Quotients => operation.1.is_some_and(standard::operators::fails_of_division),
            LostResults::None => false,
        };
        let divides = |failed| standard::operators::fails_of_division(failed) && !standard::operators::may_divide_wrong(failed, &args[1]);
        if !self.reads_ok && (!told || operation.1.is_some_and(divides)) {
            return operators::compute(operation.0, args, scalar);
        }
        let value = operators::checked(operation, args, scalar);
        match standard::operators::lost_real(scalar) {
            // In a block that looks at ENO the operators of REAL leave it as it is.
            Some(failed) if told && !self.reads_ok && matches!(value.kind, ValueKind::Compute { .. }) => {
                operators::checked((Op::Copy, Some(failed)), vec![value], scalar)
            }
            _ => value,
        }
    }

    fn binary(&mut self, operator: BinaryOperator, sign: Span, left: &Expression, right: &Expression) -> Typed {
        let span = left.span.to(right.span);
        if self.asks_for_type(left).or_else(|| self.asks_for_type(right)).is_some() {
            return self.compared_types(operator, left, right).unwrap_or(Typed::Poison);
        }
        let (a, b) = self.both(left, right);
        if a == Typed::Poison || b == Typed::Poison {
            return Typed::Poison;
        }
        let result = match operator {
            BinaryOperator::And | BinaryOperator::Or | BinaryOperator::Xor => self.logic(operator, sign, (a, left.span), (b, right.span)),
            BinaryOperator::AndThen | BinaryOperator::OrElse => self.short_circuit(operator, (a, left.span), (b, right.span)),
            _ if operator.compares() => {
                if let ExpressionKind::Binary(inner, ..) = &left.kind
                    && orders(*inner)
                    && orders(operator)
                    && matches!(b, Typed::Integer { .. } | Typed::Real { .. } | Typed::Scalar { .. })
                    && !matches!(&b, Typed::Scalar { data_type: DataType::Bool, .. })
                {
                    let message = format!("the result of `{}` is BOOL, and `{}` compares it with a number", inner.sign(), operator.sign());
                    self.report(Problem::P6202, sign, message).help = Some("Write `a < b AND b < c`.".to_owned());
                    return Typed::Poison;
                }
                self.comparison(operator, sign, (a, left.span), (b, right.span))
            }
            _ => self.arithmetic(operator, sign, (a, left.span), (b, right.span)),
        };
        match result {
            Typed::Scalar { value, data_type } => Typed::Scalar { value: Value { span, ..value }, data_type },
            other => other,
        }
    }

    /// Both operands; a bare name beside a value of an enumeration may be another value of it.
    pub(super) fn both(&mut self, left: &Expression, right: &Expression) -> (Typed, Typed) {
        if let Some(both) = self.beside_untyped(left, right) {
            return both;
        }
        let named = |expression: &Expression| matches!(expression.kind, ExpressionKind::Name(_));
        if named(right) {
            let a = self.expression(left);
            let b = match &a {
                Typed::Scalar { data_type, .. } => self.expression_for(right, &data_type.clone()),
                _ => self.expression(right),
            };
            return (a, b);
        }
        if named(left) {
            let b = self.expression(right);
            let a = match &b {
                Typed::Scalar { data_type, .. } => self.expression_for(left, &data_type.clone()),
                _ => self.expression(left),
            };
            return (a, b);
        }
        (self.expression(left), self.expression(right))
    }

    fn short_circuit(&mut self, operator: BinaryOperator, (a, left): (Typed, Span), (b, right): (Typed, Span)) -> Typed {
        let (Some(a), Some(b)) = (self.coerce(a, left, &DataType::Bool), self.coerce(b, right, &DataType::Bool)) else {
            return Typed::Poison;
        };
        let (a, b) = (Box::new(a), Box::new(b));
        let kind = if operator == BinaryOperator::AndThen { ValueKind::AndThen(a, b) } else { ValueKind::OrElse(a, b) };
        Typed::Scalar { value: Value { kind, scalar: Scalar::Bool, span: left.to(right) }, data_type: DataType::Bool }
    }

    fn logic(&mut self, operator: BinaryOperator, sign: Span, (a, left): (Typed, Span), (b, right): (Typed, Span)) -> Typed {
        if let (&Typed::Integer { value: x, radix }, &Typed::Integer { value: y, radix: other }) = (&a, &b) {
            let value = match operator {
                BinaryOperator::And => x & y,
                BinaryOperator::Or => x | y,
                _ => x ^ y,
            };
            return Typed::Integer { value, radix: if radix == 10 { other } else { radix } };
        }
        let Some((kind, a, b)) = self.meet(operator, sign, (a, left), (b, right)) else { return Typed::Poison };
        if kind.class != Class::Bits && !self.bits_of_integers(kind) {
            let message = format!("`{}` works on BOOL and bit strings, not on {}", operator.sign(), self.words(&kind.data_type()));
            let help = match kind.is_integer() {
                true => {
                    let bits = Kind { class: Class::Bits, bits: kind.bits }.data_type();
                    format!("Convert it first, for example with `{}_TO_{}`.", self.words(&kind.data_type()), self.words(&bits))
                }
                false => "Compare the value first.".to_owned(),
            };
            self.report(Problem::P6202, sign, message).help = Some(help);
            return Typed::Poison;
        }
        let scalar = kind.scalar(self.dialect);
        let (a, b) = (operators::convert(a, scalar), operators::convert(b, scalar));
        let Some((op, _)) = operators::binary(operator, scalar) else { return Typed::Poison };
        Typed::Scalar { value: operators::compute(op, vec![a, b], scalar), data_type: kind.data_type() }
    }

    /// Both operands with the kind in which they meet; unconverted.
    fn meet(
        &mut self,
        operator: BinaryOperator,
        sign: Span,
        (a, left): (Typed, Span),
        (b, right): (Typed, Span),
    ) -> Option<(Kind, Value, Value)> {
        let mut written = None;
        let (a, b) = match (generic(&a), generic(&b)) {
            (Some(literal), None) => {
                let (b, other) = self.scalar(b, right)?;
                written = self.as_written(&literal, &other);
                (self.beside(literal, a, left, &other)?, (b, other))
            }
            (None, Some(literal)) => {
                let (a, other) = self.scalar(a, left)?;
                written = self.as_written(&literal, &other);
                let b = self.beside(literal, b, right, &other)?;
                ((a, other), b)
            }
            _ => (self.scalar(a, left)?, self.scalar(b, right)?),
        };
        let kinds = Kind::of(&a.1).zip(Kind::of(&b.1));
        let enumerated = matches!(a.1, DataType::Enumeration(_)) || matches!(b.1, DataType::Enumeration(_));
        let met = match kinds {
            Some((x, y)) if !enumerated || a.1 == b.1 || self.dialect.switches().integer_bits_min > 8 => common(x, y, self.dialect),
            _ => None,
        };
        let Some(kind) = met else {
            let message = format!("`{}` does not take {} and {}", operator.sign(), self.words(&a.1), self.words(&b.1));
            let help = written.filter(|_| operator.compares());
            let other =
                if is_pointer(&a.1) || is_pointer(&b.1) { KEEP_ADDRESS } else { "Convert one of the two to the type of the other." };
            let help = help.unwrap_or_else(|| other.to_owned());
            self.report(Problem::P6202, sign, message).help = Some(help);
            return None;
        };
        let long = |(value, data_type): (Value, DataType)| match Kind::of(&data_type) {
            Some(own) => lengthened(value, own, kind, self.dialect),
            None => value,
        };
        Some((kind, long(a), long(b)))
    }

    /// A number without a type beside an operand with one.
    fn beside(&mut self, literal: LiteralKind, typed: Typed, span: Span, other: &DataType) -> Option<(Value, DataType)> {
        if let Some(kind) = Kind::of(other).filter(|&kind| kind.class != Class::Reference)
            && !matches!(other, DataType::Enumeration(_))
            && let Ok((bits, construct)) = literals::bits(&literal, kind, self.dialect)
        {
            // 1 beside BOOL is TRUE only where the dialect says so; other notes are about assignments.
            if construct == Some(Construct::NumberToBool) && !self.judge(Construct::NumberToBool, span) {
                return None;
            }
            let value = Value { kind: ValueKind::Constant(bits), scalar: kind.scalar(self.dialect), span };
            return Some((value, kind.data_type()));
        }
        self.scalar(typed, span)
    }

    pub(super) fn comparison(
        &mut self,
        operator: BinaryOperator,
        sign: Span,
        (a, left): (Typed, Span),
        (b, right): (Typed, Span),
    ) -> Typed {
        let of_bool = |value: Value| Typed::Scalar { value, data_type: DataType::Bool };
        let folded = match (&a, &b) {
            (Typed::Integer { value: x, .. }, Typed::Integer { value: y, .. }) => Some(x.cmp(y)),
            (Typed::Integer { .. } | Typed::Real { .. }, Typed::Integer { .. } | Typed::Real { .. }) => number(&a).partial_cmp(&number(&b)),
            _ => None,
        };
        if let Some(order) = folded {
            let holds = match operator {
                BinaryOperator::Equal => order.is_eq(),
                BinaryOperator::NotEqual => order.is_ne(),
                BinaryOperator::Less => order.is_lt(),
                BinaryOperator::LessEqual => order.is_le(),
                BinaryOperator::Greater => order.is_gt(),
                _ => order.is_ge(),
            };
            return of_bool(Value { kind: ValueKind::Constant(u64::from(holds)), scalar: Scalar::Bool, span: left });
        }
        if matches!(a, Typed::Text(_)) || matches!(b, Typed::Text(_)) {
            let character = |typed: &Typed| matches!(typed, Typed::Scalar { data_type: DataType::Char | DataType::WideChar, .. });
            // A literal of one character beside a CHAR is a CHAR.
            let as_characters = (character(&a) && is_one_character(&b)) || (character(&b) && is_one_character(&a));
            if !as_characters {
                let Some((a, b)) = self.two_texts((a, left), (b, right)) else { return Typed::Poison };
                let Some((op, _)) = operators::binary(operator, Scalar::I32) else { return Typed::Poison };
                return of_bool(super::texts::compared(op, a, b, left.to(right)));
            }
        }
        let (a, b) = (self.zero_as_null(a, &b), b);
        let (a, b) = (a.clone(), self.zero_as_null(b, &a));
        if let Some(value) = self.pointers_compared(operator, &a, &b, left.to(right)) {
            return of_bool(value);
        }
        if a == Typed::Null || b == Typed::Null {
            let (value, data_type) = match if a == Typed::Null { self.scalar(b, right) } else { self.scalar(a, left) } {
                Some(found) => found,
                None => return Typed::Poison,
            };
            if !matches!(data_type, DataType::Reference(_)) || orders(operator) {
                return self.no_operand(operator.sign(), &data_type, sign);
            }
            let null = Value { kind: ValueKind::Constant(0), scalar: Scalar::U64, span: sign };
            let op = if operator == BinaryOperator::Equal { Op::Equal } else { Op::Differ };
            return of_bool(operators::compute(op, vec![value, null], Scalar::Bool));
        }
        let (a, b) = match Self::is_dtl(&a) && Self::is_dtl(&b) {
            true => (self.dtl_as_number(a, left), self.dtl_as_number(b, right)),
            false => (a, b),
        };
        if a == Typed::Poison || b == Typed::Poison {
            return Typed::Poison;
        }
        match (Self::is_dtl(&a), Self::is_dtl(&b)) {
            (true, false) => return self.dtl_beside(operator.sign(), &b, right),
            (false, true) => return self.dtl_beside(operator.sign(), &a, left),
            _ => {}
        }
        if let (Typed::Aggregate(target) | Typed::Delivered(_, target), _) | (_, Typed::Aggregate(target) | Typed::Delivered(_, target)) =
            (&a, &b)
        {
            let message = format!("`{}` compares elementary values and texts, not {}", operator.sign(), self.words(&target.data_type));
            let help = (target.data_type == DataType::DateAndTime).then(|| "Call EQ_DT, LT_DT and their like of the library.".to_owned());
            let diagnostic = self.report(Problem::P6202, sign, message);
            if help.is_some() {
                diagnostic.help = help;
            }
            return Typed::Poison;
        }
        let always = self.always(operator, (&a, left), (&b, right));
        let Some((kind, a, b)) = self.meet(operator, sign, (a, left), (b, right)) else { return Typed::Poison };
        let unordered = kind == Kind::BOOL && !self.dialect.switches().bool_ordered || kind.class == Class::S5Time;
        if orders(operator) && unordered {
            let message = format!("{} has no order: `{}` does not take it", self.words(&kind.data_type()), operator.sign());
            self.report(Problem::P6202, sign, message).help = Some("Compare with `=` or `<>`.".to_owned());
            return Typed::Poison;
        }
        let scalar =
            if kind.is_integer() || kind.class == Class::Bits && kind.bits > 1 { self.working(kind) } else { kind.scalar(self.dialect) };
        let (a, b) = (operators::convert(a, scalar), operators::convert(b, scalar));
        if let Some(result) = always {
            let message = format!("this comparison is always {}", if result { "TRUE" } else { "FALSE" });
            self.report(Problem::P6221, left.to(right), message);
        }
        let Some((op, _)) = operators::binary(operator, scalar) else { return Typed::Poison };
        of_bool(operators::compute(op, vec![a, b], Scalar::Bool))
    }

    /// What a comparison of a variable with a number beyond its type always is.
    fn always(&mut self, operator: BinaryOperator, (a, _): (&Typed, Span), (b, _): (&Typed, Span)) -> Option<bool> {
        let (operator, value, number) = match (a, b) {
            (Typed::Scalar { value, .. }, Typed::Integer { value: number, .. }) => (operator, value, *number),
            (Typed::Integer { value: number, .. }, Typed::Scalar { value, .. }) => (mirrored(operator), value, *number),
            _ => return None,
        };
        if matches!(value.scalar, Scalar::F32 | Scalar::F64 | Scalar::Bool) || matches!(value.kind, ValueKind::Constant(_)) {
            return None;
        }
        let (least, most) = self.range_of(value);
        match operator {
            BinaryOperator::Less if most < number => Some(true),
            BinaryOperator::Less if least >= number => Some(false),
            BinaryOperator::LessEqual if most <= number => Some(true),
            BinaryOperator::LessEqual if least > number => Some(false),
            BinaryOperator::Greater if least > number => Some(true),
            BinaryOperator::Greater if most <= number => Some(false),
            BinaryOperator::GreaterEqual if least >= number => Some(true),
            BinaryOperator::GreaterEqual if most < number => Some(false),
            BinaryOperator::Equal if number < least || number > most => Some(false),
            BinaryOperator::NotEqual if number < least || number > most => Some(true),
            _ => None,
        }
    }

    pub(super) fn arithmetic(
        &mut self,
        operator: BinaryOperator,
        sign: Span,
        (a, left): (Typed, Span),
        (b, right): (Typed, Span),
    ) -> Typed {
        if let Some(folded) = self.fold(operator, sign, &a, &b) {
            return folded;
        }
        if let Some(pointer) = self.pointer_sum(operator, (&a, left), (&b, right)) {
            return pointer;
        }
        let kind_of = |typed: &Typed| match typed {
            Typed::Scalar { data_type, .. } => Kind::of(data_type),
            _ => None,
        };
        if Self::is_dtl(&a) || Self::is_dtl(&b) {
            self.report(Problem::P6202, sign, format!("`{}` does not take a DTL", operator.sign())).help =
                Some("Call T_ADD and T_SUB with a duration, T_DIFF with two DTL.".to_owned());
            return Typed::Poison;
        }
        let character = |data_type: &DataType| matches!(data_type, DataType::Char | DataType::WideChar);
        let text =
            |typed: &Typed| matches!(typed, Typed::Text(_)) || matches!(typed, Typed::Scalar { data_type, .. } if character(data_type));
        if operator == BinaryOperator::Add && text(&a) && text(&b) {
            self.report(Problem::P6202, sign, "`+` does not join texts").help = Some("Write `CONCAT(a, b)`.".to_owned());
            return Typed::Poison;
        }
        let (x, y) = (kind_of(&a), kind_of(&b));
        let timed = |kind: Option<Kind>| {
            kind.is_some_and(|kind| matches!(kind.class, Class::Duration | Class::Date | Class::TimeOfDay | Class::DateAndTime))
        };
        if timed(x) || timed(y) {
            return self.time_arithmetic(operator, sign, (a, left), (b, right));
        }
        if operator == BinaryOperator::Power {
            return self.power((a, left), (b, right), sign);
        }
        if matches!(operator, BinaryOperator::IntegerDivide | BinaryOperator::Modulo)
            && let Some(kind) = [x, y].into_iter().flatten().find(|kind| kind.class == Class::Real)
        {
            return self.no_operand(operator.sign(), &kind.data_type(), sign);
        }
        let Some((kind, a, b)) = self.meet(operator, sign, (a, left), (b, right)) else { return Typed::Poison };
        let bits = kind.class == Class::Bits
            && kind.bits > 1
            && implicit(Kind { class: Class::Bits, bits: 16 }, Kind { class: Class::Unsigned, bits: 16 }, self.dialect) == Implicit::Yes;
        if !kind.is_number() && !bits {
            let message = format!("`{}` computes with numbers, not with {}", operator.sign(), self.words(&kind.data_type()));
            // A dialect without integers that have no sign takes those with one.
            let of_bits = self.words(&kind.data_type());
            let mut functions = [Class::Unsigned, Class::Signed].into_iter().map(|class| {
                let integer = Kind { class, bits: kind.bits.max(16) }.data_type();
                [format!("{of_bits}_TO_{}", self.words(&integer)), format!("{}_TO_{of_bits}", self.words(&integer))]
            });
            let help = functions
                .find(|[function, _]| self.takes(function, &kind.data_type()))
                .map(|[there, back]| format!("Convert it first with `{there}`, and the result with `{back}` if it is bits again."));
            let diagnostic = self.report(Problem::P6202, sign, message);
            if kind.class == Class::Bits && kind.bits > 1 {
                diagnostic.help = help;
            }
            return Typed::Poison;
        }
        if kind.class == Class::Real && matches!(operator, BinaryOperator::Modulo | BinaryOperator::IntegerDivide) {
            return self.no_operand(operator.sign(), &kind.data_type(), sign);
        }
        let scalar = self.working(kind);
        let (a, b) = (operators::convert(a, scalar), operators::convert(b, scalar));
        self.zero_divisor(operator, &b, right);
        let Some(operation) = operators::binary(operator, scalar) else { return Typed::Poison };
        Typed::Scalar { value: self.operation(operation, vec![a, b], scalar), data_type: kind.data_type() }
    }

    /// Says that a divisor is the constant 0.
    fn zero_divisor(&mut self, operator: BinaryOperator, divisor: &Value, span: Span) {
        let integer = !matches!(divisor.scalar, Scalar::F32 | Scalar::F64);
        if integer && divisor.kind == ValueKind::Constant(0) && matches!(operator, BinaryOperator::Divide | BinaryOperator::IntegerDivide) {
            self.report(Problem::P6227, span, "the divisor is 0");
        }
    }

    /// Numbers without types: computed exactly, and still without a type.
    fn fold(&mut self, operator: BinaryOperator, sign: Span, a: &Typed, b: &Typed) -> Option<Typed> {
        if operator == BinaryOperator::Power {
            return self.power_of_literals(a, b);
        }
        if let (&Typed::Integer { value: x, radix }, &Typed::Integer { value: y, .. }) = (a, b) {
            let value = match operator {
                BinaryOperator::Add => x.checked_add(y),
                BinaryOperator::Subtract => x.checked_sub(y),
                BinaryOperator::Multiply => x.checked_mul(y),
                BinaryOperator::Divide | BinaryOperator::IntegerDivide if y == 0 => {
                    self.report(Problem::P6227, sign, "the divisor is 0");
                    Some(0)
                }
                BinaryOperator::Divide | BinaryOperator::IntegerDivide => x.checked_div(y),
                BinaryOperator::Modulo => Some(x.checked_rem(y).unwrap_or(0)),
                _ => return None,
            };
            // Numbers beyond all types say so where they are used.
            let value = value.unwrap_or(i128::MAX);
            return Some(Typed::Integer { value, radix });
        }
        let numbers = |typed: &Typed| matches!(typed, Typed::Integer { .. } | Typed::Real { .. });
        if !numbers(a) || !numbers(b) {
            return None;
        }
        let ((x, single_x), (y, single_y)) = (reals(a)?, reals(b)?);
        let (value, single) = match operator {
            BinaryOperator::Add => (x + y, single_x + single_y),
            BinaryOperator::Subtract => (x - y, single_x - single_y),
            BinaryOperator::Multiply => (x * y, single_x * single_y),
            BinaryOperator::Divide => (x / y, single_x / single_y),
            _ => return None,
        };
        Some(Typed::Real { value, single })
    }

    /// `**` of numbers without types is one, where LREAL may want all its digits and where it is a number of a REAL too.
    fn power_of_literals(&self, a: &Typed, b: &Typed) -> Option<Typed> {
        let ((x, _), (y, _)) = (reals(a)?, reals(b)?);
        let value = f64::from_bits(Op::PowF64.eval([x.to_bits(), y.to_bits(), 0, 0]));
        let single = value as f32;
        let folds = self.dialect.judge(Construct::LongTypes) != Judgement::Reject && (single.is_normal() || value == 0.0);
        folds.then_some(Typed::Real { value, single })
    }

    /// `**`: REAL or LREAL, as the wider operand says.
    fn power(&mut self, (a, left): (Typed, Span), (b, right): (Typed, Span), sign: Span) -> Typed {
        let (Some((a, base)), Some((b, exponent))) = (self.scalar(a, left), self.scalar(b, right)) else { return Typed::Poison };
        let (Some(x), Some(y)) = (Kind::of(&base), Kind::of(&exponent)) else { return Typed::Poison };
        if let Some(wrong) = [x, y].into_iter().find(|kind| !kind.is_number()) {
            return self.no_operand("**", &wrong.data_type(), sign);
        }
        let kind = if x == Kind::LREAL || y == Kind::LREAL { Kind::LREAL } else { Kind::REAL };
        let scalar = kind.scalar(self.dialect);
        let args = vec![operators::convert(a, scalar), operators::convert(b, scalar)];
        let Some((op, _)) = operators::binary(BinaryOperator::Power, scalar) else { return Typed::Poison };
        Typed::Scalar { value: operators::compute(op, args, scalar), data_type: kind.data_type() }
    }

    /// Operators with durations, dates and times of day.
    fn time_arithmetic(&mut self, operator: BinaryOperator, sign: Span, (a, left): (Typed, Span), (b, right): (Typed, Span)) -> Typed {
        let (Some((a, first)), Some((b, second))) = (self.scalar(a, left), self.scalar(b, right)) else { return Typed::Poison };
        let (Some(x), Some(y)) = (Kind::of(&first), Kind::of(&second)) else { return Typed::Poison };
        use BinaryOperator as B;
        use Class::{Date, DateAndTime, Duration, TimeOfDay};
        let constant = |word: u64, scalar: Scalar| Value { kind: ValueKind::Constant(word), scalar, span: sign };
        let done = |value: Value, kind: Kind| Typed::Scalar { value, data_type: kind.data_type() };
        match (operator, x.class, y.class) {
            (B::Add | B::Subtract, Duration, Duration) => {
                let kind = if x.bits >= y.bits { x } else { y };
                let (a, b) = (self.duration_as(a, x, kind), self.duration_as(b, y, kind));
                let scalar = kind.scalar(self.dialect);
                let Some(operation) = operators::binary(operator, scalar) else { return Typed::Poison };
                done(self.operation(operation, vec![a, b], scalar), kind)
            }
            (B::Multiply, Duration, _) if y.is_number() => self.scaled(operator, (a, x), (b, y)),
            (B::Multiply, _, Duration) if x.is_number() => {
                // The standard writes the duration first.
                self.scaled(operator, (b, y), (a, x))
            }
            (B::Divide | B::IntegerDivide, Duration, _) if y.is_number() => {
                self.zero_divisor(operator, &b, right);
                self.scaled(B::Divide, (a, x), (b, y))
            }
            (B::Add | B::Subtract, DateAndTime | Date, Duration) if x.bits == 64 && x.class == DateAndTime => {
                let scalar = x.scalar(self.dialect);
                let b = operators::convert(self.duration_as(b, y, Kind::LTIME), scalar);
                let Some((op, _)) = operators::binary(operator, scalar) else { return Typed::Poison };
                done(operators::compute(op, vec![a, b], scalar), x)
            }
            (B::Add | B::Subtract, TimeOfDay, Duration) => {
                let (duration, day) = match x.bits {
                    64 => (self.duration_as(b, y, Kind::LTIME), MILLISECONDS_OF_DAY * NANOSECONDS_OF_MILLISECOND),
                    _ => (self.duration_as(b, y, Kind::TIME), MILLISECONDS_OF_DAY),
                };
                // Midnight is followed by the next day, and preceded by the one before.
                let wide = Scalar::I64;
                let Some((op, _)) = operators::binary(operator, wide) else { return Typed::Poison };
                let sum = operators::compute(op, vec![operators::convert(a, wide), operators::convert(duration, wide)], wide);
                let rest = operators::compute(Op::RemI64, vec![sum, constant(day, wide)], wide);
                let above = operators::compute(Op::AddU64, vec![rest, constant(day, wide)], wide);
                let rest = operators::compute(Op::RemI64, vec![above, constant(day, wide)], wide);
                done(operators::convert(rest, x.scalar(self.dialect)), x)
            }
            (B::Subtract, Date, Date) | (B::Subtract, DateAndTime, DateAndTime) | (B::Subtract, TimeOfDay, TimeOfDay) => {
                let wide = Scalar::I64;
                let difference = operators::compute(Op::SubU64, vec![operators::convert(a, wide), operators::convert(b, wide)], wide);
                let time = Kind::TIME.scalar(self.dialect);
                match (x.bits.max(y.bits), self.dialect.switches().calendar) {
                    // Days.
                    (16, _) => {
                        let milliseconds = operators::compute(Op::MulU64, vec![difference, constant(MILLISECONDS_OF_DAY, wide)], wide);
                        done(operators::convert(milliseconds, time), Kind::TIME)
                    }
                    (32, _) => done(operators::convert(difference, time), Kind::TIME),
                    // LDT beside the DATE_AND_TIME of the S7 is always the long type.
                    (_, Calendar::S7) => done(difference, Kind::LTIME),
                    (_, Calendar::Long) if x.class == TimeOfDay || self.long_signs.contains(&sign.start) => done(difference, Kind::LTIME),
                    (_, Calendar::Long) => {
                        let divisor = constant(NANOSECONDS_OF_MILLISECOND, wide);
                        done(operators::convert(operators::compute(Op::DivI64, vec![difference, divisor], wide), time), Kind::TIME)
                    }
                }
            }
            _ => {
                let message = format!("`{}` does not take {} and {}", operator.sign(), self.words(&first), self.words(&second));
                let help = match (x.class, y.class) {
                    (Duration, Class::Signed | Class::Unsigned) | (Class::Signed | Class::Unsigned, Duration) => {
                        "Convert the number with `DINT_TO_TIME` first, or write it as a duration, such as `T#5s`."
                    }
                    (Duration, Duration) => "Convert both with `TIME_TO_DINT` first.",
                    _ => "Dates, times of day and durations are added and subtracted; a duration is multiplied and divided by a number.",
                };
                self.report(Problem::P6202, sign, message).help = Some(help.to_owned());
                Typed::Poison
            }
        }
    }

    /// A duration in milliseconds or nanoseconds.
    fn duration_as(&mut self, value: Value, from: Kind, to: Kind) -> Value {
        let value = operators::convert(value, to.scalar(self.dialect));
        if from.bits < to.bits {
            let factor = Value { kind: ValueKind::Constant(NANOSECONDS_OF_MILLISECOND), scalar: value.scalar, span: value.span };
            let scalar = value.scalar;
            return operators::compute(Op::MulU64, vec![value, factor], scalar);
        }
        value
    }

    /// A duration times or divided by a number.
    fn scaled(&mut self, operator: BinaryOperator, (duration, kind): (Value, Kind), (number, by): (Value, Kind)) -> Typed {
        let scalar = kind.scalar(self.dialect);
        if by.class == Class::Real {
            let (a, b) = (operators::convert(duration, Scalar::F64), operators::convert(number, Scalar::F64));
            let Some((op, _)) = operators::binary(operator, Scalar::F64) else { return Typed::Poison };
            let product = operators::compute(op, vec![a, b], Scalar::F64);
            return Typed::Scalar { value: operators::convert(product, scalar), data_type: kind.data_type() };
        }
        let wide = if by.bits > kind.bits || by.class == Class::Unsigned && by.bits == kind.bits { Scalar::I64 } else { scalar };
        let (a, b) = (operators::convert(duration, wide), operators::convert(number, wide));
        let Some(operation) = operators::binary(operator, wide) else { return Typed::Poison };
        let value = self.operation(operation, vec![a, b], wide);
        Typed::Scalar { value: operators::convert(value, scalar), data_type: kind.data_type() }
    }
}

/// A duration, a time of day or a date as the type with L, which counts nanoseconds, dates since 1970; other values as they are.
fn lengthened(value: Value, from: Kind, to: Kind, dialect: Dialect) -> Value {
    if from.class != to.class || from.bits >= to.bits {
        return value;
    }
    let (before, factor) = match from.class {
        Class::Duration | Class::TimeOfDay => (0, NANOSECONDS_OF_MILLISECOND),
        Class::Date => (DAYS_FROM_1970_TO_1990, MILLISECONDS_OF_DAY * NANOSECONDS_OF_MILLISECOND),
        _ => return value,
    };
    let scalar = to.scalar(dialect);
    let constant = |bits| Value { kind: ValueKind::Constant(bits), scalar, span: value.span };
    let (before, factor) = (constant(before), constant(factor));
    let value = operators::compute(Op::AddU64, vec![operators::convert(value, scalar), before], scalar);
    operators::compute(Op::MulU64, vec![value, factor], scalar)
}

/// Whether it is a literal of one character.
fn is_one_character(typed: &Typed) -> bool {
    matches!(generic(typed), Some(LiteralKind::Characters(_) | LiteralKind::WideCharacters(_)))
}

/// Whether an operator asks for an order.
fn orders(operator: BinaryOperator) -> bool {
    matches!(operator, BinaryOperator::Less | BinaryOperator::LessEqual | BinaryOperator::Greater | BinaryOperator::GreaterEqual)
}

/// The operator with its operands exchanged.
fn mirrored(operator: BinaryOperator) -> BinaryOperator {
    match operator {
        BinaryOperator::Less => BinaryOperator::Greater,
        BinaryOperator::LessEqual => BinaryOperator::GreaterEqual,
        BinaryOperator::Greater => BinaryOperator::Less,
        BinaryOperator::GreaterEqual => BinaryOperator::LessEqual,
        other => other,
    }
}

fn operator_sign(operator: UnaryOperator) -> &'static str {
    match operator {
        UnaryOperator::Minus => "-",
        UnaryOperator::Plus => "+",
        UnaryOperator::Not => "NOT",
    }
}

/// A number without a type, as a literal.
fn generic(typed: &Typed) -> Option<LiteralKind> {
    match typed {
        Typed::Integer { value, radix } => Some(LiteralKind::Integer { value: *value, radix: *radix }),
        Typed::Real { value, single } => Some(LiteralKind::Real { value: *value, single: *single }),
        Typed::Text(Text::Constant(text)) if text.len() == 1 => Some(LiteralKind::Characters(text.clone())),
        Typed::Text(Text::WideConstant(text)) if text.len() == 1 => Some(LiteralKind::WideCharacters(text.clone())),
        _ => None,
    }
}

/// A number without a type as LREAL and REAL.
fn reals(typed: &Typed) -> Option<(f64, f32)> {
    match *typed {
        Typed::Integer { value, .. } => Some((value as f64, value as f32)),
        Typed::Real { value, single } => Some((value, single)),
        _ => None,
    }
}

fn number(typed: &Typed) -> f64 {
    reals(typed).map_or(f64::NAN, |(value, _)| value)
}

/// Whether two types are the same for a copy: equal structures count by their fields.
pub(super) fn same_type(a: &DataType, b: &DataType) -> bool {
    match (a, b) {
        (DataType::Struct(x), DataType::Struct(y)) => match (&x.name, &y.name) {
            (Some(first), Some(second)) => first.eq_ignore_ascii_case(second),
            _ => {
                x.size == y.size
                    && x.fields.len() == y.fields.len()
                    && x.fields.iter().zip(&y.fields).all(|(f, g)| f.offset == g.offset && same_type(&f.data_type, &g.data_type))
            }
        },
        (DataType::Instance { block: x, .. }, DataType::Instance { block: y, .. }) => x == y,
        (DataType::Array { bounds: x, element: a }, DataType::Array { bounds: y, element: b }) => x == y && same_type(a, b),
        _ => a == b,
    }
}

/// Says which values an enumeration has.
fn names_of_values(data_type: &DataType) -> Option<String> {
    let DataType::Enumeration(enumeration) = data_type else { return None };
    let named = enumeration.values.iter().take(NAMED_VALUES_MAX).map(|(name, _)| format!("`{name}`"));
    let names: Vec<String> = named.collect();
    let others = if enumeration.values.len() > names.len() { " and so on" } else { "" };
    Some(format!("Write one of its values: {}{others}.", names.join(", ")))
}
