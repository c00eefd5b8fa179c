//! Types of standard functions: which ones a parameter takes, and the one type that several arguments have together.

use sieben_model::types::{DataType, STRING_LENGTH_MAX};

use super::operators::{is_real, is_signed, limits};
use crate::st::dialect::{Calendar, Construct, Dialect, Judgement};
use crate::st::standard::{Given, GivenKind};
use crate::st::tree::Scalar;
use crate::st::tree::room_of;

/// What values of an elementary type are for the operations of the engine; `None` for types that are no scalars.
pub(crate) fn scalar_of(data_type: &DataType, dialect: Dialect) -> Option<Scalar> {
    use DataType as T;
    Some(match data_type.base() {
        T::Bool => Scalar::Bool,
        T::Byte | T::Char | T::UnsignedSmallInt => Scalar::U8,
        T::Word | T::Date | T::S5Time | T::UnsignedInt | T::WideChar => Scalar::U16,
        T::DoubleWord | T::TimeOfDay | T::UnsignedDoubleInt => Scalar::U32,
        T::LongWord | T::UnsignedLongInt | T::LongDate | T::LongTimeOfDay | T::LongDateAndTime => Scalar::U64,
        T::SmallInt => Scalar::I8,
        T::Int => Scalar::I16,
        T::DoubleInt => Scalar::I32,
        T::LongInt => Scalar::I64,
        T::Time if dialect.switches().time_signed => Scalar::I32,
        T::Time => Scalar::U32,
        T::LongTime if dialect.switches().time_signed => Scalar::I64,
        T::LongTime => Scalar::U64,
        T::Real => Scalar::F32,
        T::LongReal => Scalar::F64,
        _ => return None,
    })
}

/// The type that a word means in a dialect: where dates have 64 bits, DATE is LDATE and DT is LDT.
pub(crate) fn named(word: &str, dialect: Dialect) -> Option<DataType> {
    let data_type = DataType::from_any_word(word)?;
    Some(match (dialect.switches().calendar, data_type) {
        (Calendar::Long, DataType::Date) => DataType::LongDate,
        (Calendar::Long, DataType::DateAndTime) => DataType::LongDateAndTime,
        (_, data_type) => data_type,
    })
}

/// The type of one value or a text that a word names by itself: `INT`, `STRING`.
pub(crate) fn type_of_word(word: &str, dialect: Dialect) -> Option<DataType> {
    named(word, dialect)
        .filter(|found| found.is_elementary() || found.is_long() || *found == DataType::DateAndTime || room_of(found).is_some())
}

/// Types that a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Group {
    /// Integers, REAL, LREAL.
    Numbers,
    /// The same, and durations.
    Magnitudes,
    /// Integers.
    Integers,
    /// REAL and LREAL, and what becomes one of them.
    Reals,
    /// BOOL to LWORD.
    Bits,
    /// The same, and integers.
    BitsAndIntegers,
    /// Everything that is one value.
    Elementary,
}

impl Group {
    /// Whether it has the type.
    pub(crate) fn has(self, data_type: &DataType, dialect: Dialect) -> bool {
        use DataType as T;
        let data_type = data_type.base();
        let bits = matches!(data_type, T::Bool | T::Byte | T::Word | T::DoubleWord | T::LongWord);
        let integer = is_integer(data_type);
        let real = matches!(data_type, T::Real | T::LongReal);
        // What counts as a number by the implicit conversion of the dialect.
        let number = integer || real || bits && *data_type != T::Bool && dialect.judge(Construct::PointerTo) == Judgement::Accept;
        let duration = matches!(data_type, T::Time | T::LongTime);
        match self {
            Self::Numbers | Self::Reals => number,
            Self::Magnitudes => number || duration,
            Self::Integers => integer || number && !real,
            Self::Bits => bits,
            Self::BitsAndIntegers => bits || integer,
            Self::Elementary => scalar_of(data_type, dialect).is_some(),
        }
    }

    /// What belongs to it, for a message.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::Numbers | Self::Reals => "a number such as INT, DINT or REAL",
            Self::Magnitudes => "a number or a TIME",
            Self::Integers => "an integer such as INT or DINT",
            Self::Bits => "a bit string such as BYTE, WORD or DWORD",
            Self::BitsAndIntegers => "a bit string such as WORD, or an integer",
            Self::Elementary => "a value of an elementary type",
        }
    }
}

/// Whether the type is an integer.
pub(crate) fn is_integer(data_type: &DataType) -> bool {
    use DataType as T;
    matches!(
        data_type.base(),
        T::SmallInt | T::Int | T::DoubleInt | T::LongInt | T::UnsignedSmallInt | T::UnsignedInt | T::UnsignedDoubleInt | T::UnsignedLongInt
    )
}

/// Whether an argument is a text.
pub(crate) fn is_text(given: &Given<'_>) -> bool {
    matches!(&given.kind, GivenKind::Typed(DataType::String(_) | DataType::WideString(_)))
}

/// The type that an argument without one takes where nothing else says it.
pub(crate) fn type_of(given: &Given<'_>) -> Option<DataType> {
    Some(match &given.kind {
        GivenKind::Typed(data_type) => data_type.base().clone(),
        GivenKind::Integer { value, .. } => {
            let fits = |scalar| (limits(scalar).0..=limits(scalar).1).contains(value);
            match () {
                () if fits(Scalar::I16) => DataType::Int,
                () if fits(Scalar::I32) => DataType::DoubleInt,
                () if fits(Scalar::I64) => DataType::LongInt,
                () => DataType::UnsignedLongInt,
            }
        }
        GivenKind::Real => DataType::Real,
        GivenKind::Unknown => return None,
    })
}

/// The one type of several arguments: numbers without a type take that of the others, if they fit.
pub(crate) fn common(arguments: &[&Given<'_>], dialect: Dialect) -> Option<DataType> {
    let typed = arguments.iter().filter(|given| matches!(given.kind, GivenKind::Typed(_)));
    let mut joined: Option<DataType> = None;
    for given in typed {
        let one = type_of(given)?;
        joined = Some(match joined {
            Some(other) => join(&other, &one, dialect)?,
            None => one,
        });
    }
    for given in arguments.iter().filter(|given| !matches!(given.kind, GivenKind::Typed(_))) {
        let one = type_of(given)?;
        joined = Some(match joined {
            Some(other) if takes(&other, given, dialect) => other,
            Some(other) => join(&other, &one, dialect)?,
            None => one,
        });
    }
    joined
}

/// Whether a number without a type can be one of this type.
pub(crate) fn takes(data_type: &DataType, given: &Given<'_>, dialect: Dialect) -> bool {
    let Some(scalar) = scalar_of(data_type, dialect) else { return false };
    match &given.kind {
        GivenKind::Integer { value, radix } => {
            let (least, most) = limits(scalar);
            let kind = match data_type.base() {
                DataType::Bool => dialect.judge(Construct::NumberToBool) != Judgement::Reject,
                DataType::Byte | DataType::Word | DataType::DoubleWord | DataType::LongWord => {
                    *radix != 10 || dialect.judge(Construct::DecimalToBitString) != Judgement::Reject
                }
                other => is_integer(other) || is_real(scalar),
            };
            kind && (least..=most).contains(value)
        }
        GivenKind::Real => is_real(scalar),
        GivenKind::Typed(_) | GivenKind::Unknown => false,
    }
}

/// The type that two types have together: the wider one of a kind, or one that holds both.
fn join(a: &DataType, b: &DataType, dialect: Dialect) -> Option<DataType> {
    use DataType as T;
    if a == b {
        return Some(a.clone());
    }
    if let (T::String(a), T::String(b)) = (a, b) {
        return Some(T::String(*a.max(b)));
    }
    match (a, b) {
        (T::Char, T::String(_)) | (T::String(_), T::Char) => return Some(T::String(STRING_LENGTH_MAX)),
        (T::Time, T::LongTime) | (T::LongTime, T::Time) => return Some(T::LongTime),
        (T::TimeOfDay, T::LongTimeOfDay) | (T::LongTimeOfDay, T::TimeOfDay) => return Some(T::LongTimeOfDay),
        _ => {}
    }
    if Group::Bits.has(a, dialect) && Group::Bits.has(b, dialect) {
        return Some(if a.bits() >= b.bits() { a } else { b }.clone());
    }
    if !Group::Numbers.has(a, dialect) || !Group::Numbers.has(b, dialect) {
        return None;
    }
    let (left, right) = (scalar_of(a, dialect)?, scalar_of(b, dialect)?);
    if is_real(left) || is_real(right) {
        let whole = if is_real(left) { right } else { left };
        // A REAL holds no integer of 32 bits exactly; the dialects of the S7 do not mind.
        let long = left == Scalar::F64
            || right == Scalar::F64
            || !is_real(whole) && whole.bits() >= 32 && dialect.switches().calendar == Calendar::Long && dialect.switches().time_signed;
        return Some(if long { T::LongReal } else { T::Real });
    }
    let bits = match (is_signed(left), is_signed(right)) {
        (false, false) => return Some(unsigned(left.bits().max(right.bits()))),
        (true, true) => left.bits().max(right.bits()),
        (true, false) if left.bits() > right.bits() => left.bits(),
        (false, true) if right.bits() > left.bits() => right.bits(),
        _ => (2 * left.bits().max(right.bits())).min(64),
    };
    Some(match bits {
        8 => T::SmallInt,
        16 => T::Int,
        32 => T::DoubleInt,
        _ => T::LongInt,
    })
}

fn unsigned(bits: u32) -> DataType {
    match bits {
        8 => DataType::UnsignedSmallInt,
        16 => DataType::UnsignedInt,
        32 => DataType::UnsignedDoubleInt,
        _ => DataType::UnsignedLongInt,
    }
}
