//! Initial values: whether a constant fits a type, and its bytes.

use sieben_model::literal::{Value, date_and_time_bytes, s5time_word};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::InitialAddress;
use super::types::Resolver;
use crate::declarations::values::{Misfit, write, write_initial};
use crate::scope::did_you_mean;
use crate::st::ast::DateAndTimeForm;
use crate::st::ast::{Expression, ExpressionKind, Initializer, InitializerKind, LiteralKind};
use crate::st::check::names::Constant;
use crate::st::dialect::{Construct, Dialect, Judgement};
use crate::st::dtl;

/// Days from 1970-01-01 to 1990-01-01, where the calendar of the S7 begins.
const DAYS_TO_1990: u32 = 7305;
/// The last DATE of an S7, 2168-12-31, in days since 1990-01-01.
const DATE_MAX: u32 = 0xFF62;
/// Nanoseconds of a day.
const DAY_NS: i64 = 86_400_000_000_000;
/// Nanoseconds of a millisecond.
const MILLISECOND: i64 = 1_000_000;

/// Lowest and highest value of an integer type or bit string; `None` for all others.
pub(crate) fn range(data_type: &DataType) -> Option<(i128, i128)> {
    let signed = |bits: u32| (-(1_i128 << (bits - 1)), (1_i128 << (bits - 1)) - 1);
    let unsigned = |bits: u32| (0, (1_i128 << bits) - 1);
    Some(match data_type {
        DataType::SmallInt => signed(8),
        DataType::Int => signed(16),
        DataType::DoubleInt => signed(32),
        DataType::LongInt => signed(64),
        DataType::UnsignedSmallInt | DataType::Byte => unsigned(8),
        DataType::UnsignedInt | DataType::Word => unsigned(16),
        DataType::UnsignedDoubleInt | DataType::DoubleWord => unsigned(32),
        DataType::UnsignedLongInt | DataType::LongWord => unsigned(64),
        DataType::Subrange(_) if data_type.counts_nanoseconds() => return None,
        DataType::Subrange(subrange) => (subrange.low, subrange.high),
        DataType::Enumeration(enumeration) => return range(&enumeration.base),
        _ => return None,
    })
}

/// What a variable of an elementary type holds unless something else is said, as a constant.
pub(crate) fn default_constant(data_type: &DataType) -> Option<LiteralKind> {
    let integer = |value: i128| LiteralKind::Integer { value, radix: 10 };
    Some(match data_type {
        DataType::Bool => LiteralKind::Bool(false),
        DataType::Real | DataType::LongReal => LiteralKind::Real { value: 0.0, single: 0.0 },
        DataType::Enumeration(enumeration) => integer(i128::from(enumeration.initial)),
        DataType::Subrange(subrange) if data_type.counts_nanoseconds() => return default_constant(&subrange.base),
        DataType::Subrange(subrange) => integer(subrange.initial),
        DataType::Time => LiteralKind::Duration { nanoseconds: 0, long: false },
        DataType::LongTime => LiteralKind::Duration { nanoseconds: 0, long: true },
        DataType::S5Time => LiteralKind::S5Time(0),
        DataType::Date => LiteralKind::Date { days: DAYS_TO_1990, long: false },
        DataType::LongDate => LiteralKind::Date { days: 0, long: true },
        DataType::TimeOfDay => LiteralKind::TimeOfDay { nanoseconds: 0, long: false },
        DataType::LongTimeOfDay => LiteralKind::TimeOfDay { nanoseconds: 0, long: true },
        DataType::String(_) => LiteralKind::Characters(Vec::new()),
        DataType::WideString(_) => LiteralKind::WideCharacters(Vec::new()),
        other => {
            range(other)?;
            integer(0)
        }
    })
}

/// The constant as a value of the type.
pub(crate) fn value_of(constant: &LiteralKind, data_type: &DataType, dialect: Dialect) -> Result<Value, Misfit> {
    use DataType as T;
    use LiteralKind as L;
    let checked = |value: i128, radix: u8| {
        let (low, high) = range(data_type).ok_or(Misfit::Type)?;
        // `16#FFFF` is a pattern of bits: an INT holds it.
        let pattern = radix != 10 && value >= 0 && data_type.bits() < 128 && value < 1_i128 << data_type.bits();
        let whole = !matches!(data_type, T::Subrange(_));
        if (low..=high).contains(&value) || pattern && whole { Ok(value as u64) } else { Err(Misfit::Range) }
    };
    let milliseconds = |nanoseconds: i64| {
        let milliseconds = nanoseconds / MILLISECOND;
        let fits = if dialect.switches().time_signed { i32::try_from(milliseconds).is_ok() } else { u32::try_from(milliseconds).is_ok() };
        if fits { Ok(milliseconds as u32) } else { Err(Misfit::Range) }
    };
    let long = |bits: u64| Ok(Value::Image(bits.to_be_bytes().to_vec()));
    match (data_type, constant) {
        (T::Bool, L::Bool(value)) => Ok(Value::Bool(*value)),
        (T::Bool, L::Integer { value: value @ (0 | 1), .. }) => Ok(Value::Bool(*value == 1)),
        (T::Bool, L::Integer { .. }) => Err(Misfit::Range),
        (T::Char | T::Byte, L::Characters(text)) => match text.as_slice() {
            &[character] => Ok(Value::Byte(character)),
            _ => Err(Misfit::Range),
        },
        (T::Char, L::Integer { value, .. }) => u8::try_from(*value).map(Value::Byte).map_err(|_| Misfit::Range),
        (T::WideChar, L::WideCharacters(text)) => match text.as_slice() {
            &[unit] => Ok(Value::Image(unit.to_be_bytes().to_vec())),
            _ => Err(Misfit::Range),
        },
        (T::WideChar, L::Characters(text)) if text.len() == 1 => Ok(Value::Image(vec![0, text[0]])),
        (T::Word, L::Integer { value, radix }) => checked(*value, *radix).map(|bits| Value::Word(bits as u16)),
        (T::Word, L::Counter(word) | L::S5Time(word)) | (T::S5Time, L::S5Time(word)) => Ok(Value::Word(*word)),
        (T::S5Time, L::Duration { nanoseconds, .. }) => {
            let milliseconds = u64::try_from(nanoseconds / MILLISECOND).map_err(|_| Misfit::Range)?;
            s5time_word(milliseconds).map(Value::Word).ok_or(Misfit::Range)
        }
        (T::Byte, L::Integer { value, radix }) => checked(*value, *radix).map(|bits| Value::Byte(bits as u8)),
        (T::Int, L::Integer { value, radix }) => checked(*value, *radix).map(|bits| Value::Int(bits as u16 as i16)),
        (T::DoubleInt, L::Integer { value, radix }) => checked(*value, *radix).map(|bits| Value::DoubleInt(bits as u32 as i32)),
        (T::DoubleWord, L::Integer { value, radix }) => checked(*value, *radix).map(|bits| Value::DoubleWord(bits as u32)),
        (T::Real, L::Real { single, .. }) => {
            if single.is_finite() {
                Ok(Value::Real(*single))
            } else {
                Err(Misfit::Range)
            }
        }
        (T::Real, L::Integer { value, .. }) => Ok(Value::Real(*value as f32)),
        (T::LongReal, L::Real { value, .. }) => long(value.to_bits()),
        (T::LongReal, L::Integer { value, .. }) => long((*value as f64).to_bits()),
        (T::Time, L::Duration { nanoseconds, .. }) => milliseconds(*nanoseconds).map(Value::DoubleWord),
        (T::LongTime, L::Duration { nanoseconds, .. }) => long(*nanoseconds as u64),
        (T::Date, L::Date { days, .. }) => match days.checked_sub(DAYS_TO_1990) {
            Some(days) if days <= DATE_MAX => Ok(Value::Word(days as u16)),
            _ => Err(Misfit::Range),
        },
        (T::LongDate, L::Date { days, .. }) => i64::from(*days).checked_mul(DAY_NS).map_or(Err(Misfit::Range), |bits| long(bits as u64)),
        (T::TimeOfDay, L::TimeOfDay { nanoseconds, .. }) => Ok(Value::DoubleWord((nanoseconds / MILLISECOND as u64) as u32)),
        (T::LongTimeOfDay, L::TimeOfDay { nanoseconds, .. }) => long(*nanoseconds),
        (T::DateAndTime, L::DateAndTime { nanoseconds, .. }) => {
            let days = u32::try_from(nanoseconds.div_euclid(DAY_NS)).ok().and_then(|days| days.checked_sub(DAYS_TO_1990));
            match days {
                // The eight bytes have two digits for the year.
                Some(days) if days < 36_525 => {
                    let milliseconds = (nanoseconds.rem_euclid(DAY_NS) / MILLISECOND) as u32;
                    Ok(Value::DateAndTime(date_and_time_bytes(days as u16, milliseconds)))
                }
                _ => Err(Misfit::Range),
            }
        }
        (T::LongDateAndTime, L::DateAndTime { nanoseconds, .. }) => long(*nanoseconds as u64),
        (dtl, L::DateAndTime { nanoseconds, form: DateAndTimeForm::Structured }) if dtl::is_dtl(dtl) => {
            Ok(Value::Image(dtl::bytes(*nanoseconds as u64).to_vec()))
        }
        (T::String(length), L::Characters(text)) => {
            if text.len() <= usize::from(*length) {
                Ok(Value::Characters(text.clone()))
            } else {
                Err(Misfit::Range)
            }
        }
        (T::WideString(length), L::WideCharacters(text)) => wide(*length, text),
        (T::WideString(length), L::Characters(text)) => wide(*length, &text.iter().map(|&byte| u16::from(byte)).collect::<Vec<_>>()),
        (T::Reference(_), L::Null) => long(0),
        (T::Reference(_), L::Integer { value: 0, .. }) => long(0),
        (T::Pointer, L::Pointer(Value::Pointer(pointer))) => Ok(Value::DataPointer { db: 0, pointer: *pointer }),
        (T::Pointer, L::Pointer(value @ Value::DataPointer { .. })) | (T::Any, L::Pointer(value @ Value::Any(_))) => Ok(value.clone()),
        (T::Pointer, L::Null) => Ok(Value::DataPointer { db: 0, pointer: 0 }),
        (_, L::Integer { value, radix }) => {
            let bits = checked(*value, *radix)?.to_be_bytes();
            let length = (data_type.bits() / 8).min(8) as usize;
            Ok(Value::Image(bits[8 - length..].to_vec()))
        }
        (T::Subrange(subrange), _) => value_of(constant, &subrange.base, dialect),
        _ => Err(Misfit::Type),
    }
}

fn wide(length: u16, text: &[u16]) -> Result<Value, Misfit> {
    if text.len() > usize::from(length) {
        return Err(Misfit::Range);
    }
    let words = [length, text.len() as u16];
    Ok(Value::Image(words.iter().chain(text).flat_map(|unit| unit.to_be_bytes()).collect()))
}

/// The bytes that a variable holds at the start.
pub(crate) fn bytes(data_type: &DataType, initial: &[Value]) -> Vec<u8> {
    let mut image = vec![0; data_type.bits().div_ceil(8) as usize];
    write_initial(&mut image, 0, data_type, initial);
    image
}

impl Resolver<'_, '_> {
    /// The constant in the form of the type; `None` if it does not fit, which is reported.
    pub(super) fn converted(&mut self, constant: Constant, data_type: &DataType, span: Span) -> Option<LiteralKind> {
        let constant = self.wrapped(&constant, data_type, span).unwrap_or(constant);
        self.fitting(&constant, data_type, span)?;
        Some(match (data_type, constant.value) {
            (DataType::Real | DataType::LongReal, LiteralKind::Integer { value, .. }) => {
                LiteralKind::Real { value: value as f64, single: value as f32 }
            }
            (DataType::Bool, LiteralKind::Integer { value, .. }) => LiteralKind::Bool(value == 1),
            (DataType::Int | DataType::DoubleInt | DataType::SmallInt | DataType::LongInt, LiteralKind::Integer { value, radix }) => {
                let (_, high) = range(data_type).unwrap_or_default();
                // A pattern of bits is the number that these bits are.
                LiteralKind::Integer { value: if value > high { value - (1 << data_type.bits()) } else { value }, radix }
            }
            (_, value) => value,
        })
    }

    /// A negative number as the pattern of bits of a type without a sign, where the dialect takes it for one; that is said.
    fn wrapped(&mut self, constant: &Constant, data_type: &DataType, span: Span) -> Option<Constant> {
        let LiteralKind::Integer { value, radix } = constant.value else { return None };
        let unsigned =
            range(data_type).is_some_and(|(low, _)| low == 0) && !matches!(data_type, DataType::Subrange(_) | DataType::Enumeration(_));
        let bits = data_type.bits();
        if !unsigned || self.dialect.judge(Construct::PointerTo) != Judgement::Accept || !(-(1_i128 << (bits - 1))..0).contains(&value) {
            return None;
        }
        let wrapped = value + (1_i128 << bits);
        let message = format!("{} has no negative values: {value} is {wrapped} here", self.dialect.type_words(data_type));
        self.report(Problem::P6201, span, message);
        Some(Constant { value: LiteralKind::Integer { value: wrapped, radix }, data_type: constant.data_type.clone() })
    }

    /// The value that a constant is for a variable; `None` if it does not fit, which is reported.
    pub(super) fn fitting(&mut self, constant: &Constant, data_type: &DataType, span: Span) -> Option<Value> {
        let wrapped = self.wrapped(constant, data_type, span);
        let constant = wrapped.as_ref().unwrap_or(constant);
        // An enumeration takes its own values only.
        let other = match (&constant.data_type, data_type) {
            (Some(DataType::Enumeration(a)), DataType::Enumeration(b)) => a != b,
            (_, DataType::Enumeration(_)) => self.dialect.judge(Construct::DecimalToBitString) != Judgement::Accept,
            _ => false,
        };
        if let (DataType::WideString(_), LiteralKind::Characters(_), None) = (data_type, &constant.value, &constant.data_type) {
            self.judge(Construct::NarrowInitial, span);
        }
        match value_of(&constant.value, data_type, self.dialect) {
            Ok(value) if !other => {
                self.judge_notation(constant, data_type, span);
                Some(value)
            }
            Err(Misfit::Range) => {
                let message = match (range(data_type), data_type) {
                    (Some((low, high)), _) => {
                        format!("this value is outside the range of {}, {low} to {high}", self.dialect.type_words(data_type))
                    }
                    (None, DataType::String(length)) => format!("this text is longer than the {length} characters of the variable"),
                    _ => format!("this value is outside the range of {}", self.dialect.type_words(data_type)),
                };
                self.report(Problem::P4001, span, message);
                None
            }
            _ => {
                self.report(Problem::P4006, span, format!("this value is not one of {}", self.dialect.type_words(data_type)));
                None
            }
        }
    }

    /// What the dialect thinks of the notation of a value.
    fn judge_notation(&mut self, constant: &Constant, data_type: &DataType, span: Span) {
        let bits = matches!(data_type, DataType::Byte | DataType::Word | DataType::DoubleWord | DataType::LongWord);
        if let (LiteralKind::Integer { radix, .. }, None) = (&constant.value, &constant.data_type) {
            if bits && *radix == 10 {
                self.judge(Construct::DecimalToBitString, span);
            } else if *data_type == DataType::Bool {
                self.judge(Construct::NumberToBool, span);
            }
        }
    }

    /// The initial values of a variable; empty if there are none, or if something was wrong with them, which is reported.
    pub(super) fn initial(&mut self, initializer: &Initializer, data_type: &DataType) -> Vec<Value> {
        if self.begins_with_address(0, data_type, initializer) {
            self.keep_addresses(initializer.span);
            return Vec::new();
        }
        let aggregate =
            matches!(data_type, DataType::Array { .. } | DataType::Struct(_) | DataType::Instance { .. }) && !dtl::is_dtl(data_type);
        if let (false, InitializerKind::Expression(expression)) = (aggregate, &initializer.kind) {
            let Some(constant) = self.constant_for(expression, data_type) else { return Vec::new() };
            return self.fitting(&constant, data_type, expression.span).into_iter().collect();
        }
        let mut image = bytes(data_type, &[]);
        self.fill(&mut image, 0, data_type, initializer);
        self.keep_addresses(initializer.span);
        vec![Value::Image(image)]
    }

    /// Whether the address that a reference or a pointer begins with is written by a statement of the restart.
    fn begins_with_address(&mut self, offset: u64, data_type: &DataType, initializer: &Initializer) -> bool {
        match (data_type, &initializer.kind) {
            (DataType::Reference(_), InitializerKind::Expression(value))
                if self.later && !matches!(value.kind, ExpressionKind::Literal(_)) =>
            {
                self.addresses.push(InitialAddress { offset, data_type: data_type.clone(), value: value.clone() });
                true
            }
            _ => false,
        }
    }

    fn keep_addresses(&mut self, of: Span) {
        let addresses = std::mem::take(&mut self.addresses);
        if !addresses.is_empty() {
            self.types.known.addresses.insert(of, addresses);
        }
    }

    /// A constant where a value of a type is wanted: names of an enumeration mean its values.
    fn constant_for(&mut self, expression: &Expression, data_type: &DataType) -> Option<Constant> {
        if let (DataType::Enumeration(enumeration), ExpressionKind::Name(name)) = (data_type, &expression.kind)
            && enumeration.values.iter().any(|(value, _)| value.eq_ignore_ascii_case(&name.text))
        {
            return self.value_of(data_type, name);
        }
        self.constant(expression)
    }

    /// Writes initial values into the bytes of a variable.
    pub(super) fn fill(&mut self, image: &mut [u8], position: u64, data_type: &DataType, initializer: &Initializer) {
        let span = initializer.span;
        match (data_type, &initializer.kind) {
            (DataType::Array { .. }, InitializerKind::List { .. } | InitializerKind::Repeat { .. } | InitializerKind::Expression(_)) => {
                let mut walk = Walk { position, index: 0, full: None };
                match &initializer.kind {
                    InitializerKind::List { elements, .. } => {
                        elements.iter().for_each(|entry| self.element(image, data_type, entry, &mut walk));
                    }
                    _ => self.element(image, data_type, initializer, &mut walk),
                }
                if let Some(span) = walk.full {
                    let message = format!("more initial values than the {} elements of the array", data_type.elements());
                    self.report(Problem::P4007, span, message);
                }
            }
            (DataType::Struct(structure) | DataType::Instance { structure, .. }, InitializerKind::Structure(fields)) => {
                for (name, value) in fields {
                    match structure.field(&name.text) {
                        Some(field) => {
                            let (offset, data_type) = (u64::from(field.offset), field.data_type.clone());
                            self.fill(image, position + offset, &data_type, value);
                        }
                        None => {
                            let names = structure.fields.iter().map(|field| field.name.as_str());
                            let nearest = self.types.scope.nearest(&name.text, names);
                            let message =
                                format!("{} has no field `{}`{}", self.dialect.type_words(data_type), name.text, did_you_mean(nearest));
                            self.report(Problem::P3007, name.span, message);
                        }
                    }
                }
            }
            (dtl, InitializerKind::Expression(expression)) if dtl::is_dtl(dtl) => {
                if let Some(constant) = self.constant(expression)
                    && let Some(Value::Image(bytes)) = self.fitting(&constant, data_type, expression.span)
                {
                    let first = (position / 8) as usize;
                    image[first..first + bytes.len()].copy_from_slice(&bytes);
                }
            }
            (DataType::Struct(_) | DataType::Instance { .. } | DataType::Array { .. }, _) => {
                let message = format!("{} takes no value as a whole; give one to each of its fields", self.dialect.type_words(data_type));
                self.report(Problem::P4006, span, message);
            }
            _ if self.begins_with_address(position, data_type, initializer) => {}
            (_, InitializerKind::Expression(expression)) => {
                if let Some(constant) = self.constant_for(expression, data_type)
                    && let Some(value) = self.fitting(&constant, data_type, expression.span)
                {
                    write(image, position, data_type, &value);
                }
            }
            // `[5]` and `(5)` are lists of one.
            (_, InitializerKind::List { elements, .. }) if elements.len() == 1 => self.fill(image, position, data_type, &elements[0]),
            _ => {
                self.report(Problem::P4007, span, format!("{} takes one value", self.dialect.type_words(data_type)));
            }
        }
    }

    /// Writes what one entry of a list says about the elements of an array.
    fn element(&mut self, image: &mut [u8], array: &DataType, initializer: &Initializer, walk: &mut Walk) {
        let DataType::Array { element, .. } = array else { return };
        let flat = !matches!(**element, DataType::Array { .. });
        match &initializer.kind {
            _ if walk.full.is_some() => {}
            InitializerKind::Repeat { count, values } => self.repeated(image, array, *count, values, walk),
            InitializerKind::List { elements, .. } if flat => elements.iter().for_each(|inner| self.element(image, array, inner, walk)),
            InitializerKind::Expression(expression) if let Some((count, values)) = self.repetition(expression) => {
                self.repeated(image, array, count, &values, walk);
            }
            _ if walk.index >= array.elements() => walk.full = Some(initializer.span),
            _ => {
                let at = walk.position + array.element_offset(walk.index);
                walk.index += 1;
                self.fill(image, at, element, initializer);
            }
        }
    }

    /// Writes values several times; without values it leaves the elements as they are.
    fn repeated(&mut self, image: &mut [u8], array: &DataType, count: u64, values: &[Initializer], walk: &mut Walk) {
        if values.is_empty() {
            walk.index = walk.index.saturating_add(count);
            return;
        }
        let problems = self.types.diagnostics.len();
        for _ in 0..count {
            let before = walk.index;
            values.iter().for_each(|value| self.element(image, array, value, walk));
            // What is wrong is said once, and what gives no element gives none the next time.
            if walk.full.is_some() || self.types.diagnostics.len() > problems || walk.index == before {
                return;
            }
        }
    }

    /// `n(0, 1)` with a constant `n`.
    fn repetition(&mut self, expression: &Expression) -> Option<(u64, Vec<Initializer>)> {
        let ExpressionKind::Call(call) = &expression.kind else { return None };
        if matches!(&call.callee.kind, ExpressionKind::Name(name) if ["ADR", "REF"].iter().any(|word| name.is(word))) {
            return None;
        }
        let count = u64::try_from(self.integer(&call.callee)?).ok()?;
        let values = call.arguments.iter().filter_map(|argument| argument.value.clone());
        Some((count, values.map(|value| Initializer { span: value.span, kind: InitializerKind::Expression(value) }).collect()))
    }
}

/// How far the elements of an array are written.
struct Walk {
    /// Where the array begins, in bits.
    position: u64,
    /// The next element.
    index: u64,
    /// Where there was one value too many.
    full: Option<Span>,
}
