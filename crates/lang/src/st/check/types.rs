//! The typing rules: what a type is for the operations, what converts by itself, and what two operands have in common.

use sieben_model::types::DataType;

use crate::st::dialect::Dialect;
use crate::st::tree::Scalar;

/// What the values of an elementary type are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Class {
    /// BOOL, BYTE, WORD, DWORD, LWORD.
    Bits,
    /// SINT, INT, DINT, LINT.
    Signed,
    /// USINT, UINT, UDINT, ULINT.
    Unsigned,
    /// REAL, LREAL.
    Real,
    /// TIME, LTIME.
    Duration,
    /// DATE, LDATE.
    Date,
    /// TIME_OF_DAY, LTOD.
    TimeOfDay,
    /// LDT.
    DateAndTime,
    /// S5TIME.
    S5Time,
    /// CHAR, WCHAR.
    Character,
    /// REF_TO, POINTER TO, REFERENCE TO.
    Reference,
}

/// What an elementary type is for the operations: the class of its values and their bits (1, 8, 16, 32, 64).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Kind {
    /// The class.
    pub(crate) class: Class,
    /// The bits.
    pub(crate) bits: u32,
}

impl Kind {
    /// The kind of a type; of an enumeration and a subrange that of its base. `None`: a type whose values are no scalars.
    pub(crate) fn of(data_type: &DataType) -> Option<Self> {
        use DataType as T;
        let (class, bits) = match data_type.base() {
            T::Bool => (Class::Bits, 1),
            T::Byte => (Class::Bits, 8),
            T::Word => (Class::Bits, 16),
            T::DoubleWord => (Class::Bits, 32),
            T::LongWord => (Class::Bits, 64),
            T::SmallInt => (Class::Signed, 8),
            T::Int => (Class::Signed, 16),
            T::DoubleInt => (Class::Signed, 32),
            T::LongInt => (Class::Signed, 64),
            T::UnsignedSmallInt => (Class::Unsigned, 8),
            T::UnsignedInt => (Class::Unsigned, 16),
            T::UnsignedDoubleInt => (Class::Unsigned, 32),
            T::UnsignedLongInt => (Class::Unsigned, 64),
            T::Real => (Class::Real, 32),
            T::LongReal => (Class::Real, 64),
            T::Time => (Class::Duration, 32),
            T::LongTime => (Class::Duration, 64),
            T::Date => (Class::Date, 16),
            T::LongDate => (Class::Date, 64),
            T::TimeOfDay => (Class::TimeOfDay, 32),
            T::LongTimeOfDay => (Class::TimeOfDay, 64),
            T::LongDateAndTime => (Class::DateAndTime, 64),
            T::S5Time => (Class::S5Time, 16),
            T::Char => (Class::Character, 8),
            T::WideChar => (Class::Character, 16),
            T::Reference(_) => (Class::Reference, 64),
            _ => return None,
        };
        Some(Self { class, bits })
    }

    /// The type of this kind: the one without a name of its own.
    pub(crate) fn data_type(self) -> DataType {
        use DataType as T;
        match (self.class, self.bits) {
            (Class::Bits, 1) => T::Bool,
            (Class::Bits, 8) => T::Byte,
            (Class::Bits, 16) => T::Word,
            (Class::Bits, 32) => T::DoubleWord,
            (Class::Bits | Class::Reference, _) => T::LongWord,
            (Class::Signed, 8) => T::SmallInt,
            (Class::Signed, 16) => T::Int,
            (Class::Signed, 32) => T::DoubleInt,
            (Class::Signed, _) => T::LongInt,
            (Class::Unsigned, 8) => T::UnsignedSmallInt,
            (Class::Unsigned, 16) => T::UnsignedInt,
            (Class::Unsigned, 32) => T::UnsignedDoubleInt,
            (Class::Unsigned, _) => T::UnsignedLongInt,
            (Class::Real, 32) => T::Real,
            (Class::Real, _) => T::LongReal,
            (Class::Duration, 32) => T::Time,
            (Class::Duration, _) => T::LongTime,
            (Class::Date, 16) => T::Date,
            (Class::Date, _) => T::LongDate,
            (Class::TimeOfDay, 32) => T::TimeOfDay,
            (Class::TimeOfDay, _) => T::LongTimeOfDay,
            (Class::DateAndTime, _) => T::LongDateAndTime,
            (Class::S5Time, _) => T::S5Time,
            (Class::Character, 8) => T::Char,
            (Class::Character, _) => T::WideChar,
        }
    }

    /// What its values are for the operations of the engine.
    pub(crate) fn scalar(self, dialect: Dialect) -> Scalar {
        let signed = match self.class {
            Class::Signed => true,
            Class::Duration => dialect.switches().time_signed,
            Class::Real => return if self.bits == 32 { Scalar::F32 } else { Scalar::F64 },
            _ => false,
        };
        match (self.bits, signed) {
            (1, _) => Scalar::Bool,
            (8, false) => Scalar::U8,
            (16, false) => Scalar::U16,
            (32, false) => Scalar::U32,
            (_, false) => Scalar::U64,
            (8, true) => Scalar::I8,
            (16, true) => Scalar::I16,
            (32, true) => Scalar::I32,
            (_, true) => Scalar::I64,
        }
    }

    /// Whether its values are whole numbers.
    pub(crate) fn is_integer(self) -> bool {
        matches!(self.class, Class::Signed | Class::Unsigned)
    }

    /// Whether its values are numbers.
    pub(crate) fn is_number(self) -> bool {
        self.is_integer() || self.class == Class::Real
    }

    /// BOOL.
    pub(crate) const BOOL: Self = Self { class: Class::Bits, bits: 1 };
    /// INT.
    pub(crate) const INT: Self = Self { class: Class::Signed, bits: 16 };
    /// DINT.
    pub(crate) const DINT: Self = Self { class: Class::Signed, bits: 32 };
    /// LINT.
    pub(crate) const LINT: Self = Self { class: Class::Signed, bits: 64 };
    /// REAL.
    pub(crate) const REAL: Self = Self { class: Class::Real, bits: 32 };
    /// LREAL.
    pub(crate) const LREAL: Self = Self { class: Class::Real, bits: 64 };
    /// TIME.
    pub(crate) const TIME: Self = Self { class: Class::Duration, bits: 32 };
    /// LTIME.
    pub(crate) const LTIME: Self = Self { class: Class::Duration, bits: 64 };
}

/// The lowest and the highest value of a type of whole numbers or bits.
pub(crate) fn bounds(scalar: Scalar) -> (i128, i128) {
    match scalar {
        Scalar::Bool => (0, 1),
        Scalar::U8 => (0, u8::MAX.into()),
        Scalar::U16 => (0, u16::MAX.into()),
        Scalar::U32 => (0, u32::MAX.into()),
        Scalar::U64 => (0, u64::MAX.into()),
        Scalar::I8 => (i8::MIN.into(), i8::MAX.into()),
        Scalar::I16 => (i16::MIN.into(), i16::MAX.into()),
        Scalar::I32 => (i32::MIN.into(), i32::MAX.into()),
        Scalar::I64 => (i64::MIN.into(), i64::MAX.into()),
        // Whole numbers that a REAL, an LREAL holds exactly.
        Scalar::F32 => (-(1 << 24), 1 << 24),
        Scalar::F64 => (-(1 << 53), 1 << 53),
    }
}

/// Whether a value converts without a conversion function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Implicit {
    /// It does, and nothing is lost.
    Yes,
    /// It does, with a warning about what may be lost.
    Warned(Loss),
    /// It does not.
    No,
}

/// What an implicit conversion may lose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Loss {
    /// Whether the value is negative.
    Sign,
    /// Digits.
    Digits,
}

impl Loss {
    /// How a message says it.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::Sign => "the sign may change",
            Self::Digits => "digits may be lost",
        }
    }
}

/// How the sizes of two types compare; for numbers to REAL by the digits that it holds exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Size {
    Wider,
    Same,
    /// The target is smaller.
    Narrower,
    /// The target is as wide or wider.
    Fits,
}

const Y: Implicit = Implicit::Yes;
const N: Implicit = Implicit::No;
const SIGN: Implicit = Implicit::Warned(Loss::Sign);
const DIGITS: Implicit = Implicit::Warned(Loss::Digits);

/// From, to, size of the target; then by dialect. What no row names does not convert by itself.
#[rustfmt::skip] // A table.
const CONVERSIONS: &[(Class, Class, Size, [Implicit; 4])] = &[
    //                                               iec     codesys scl     tia
    (Class::Signed,    Class::Signed,    Size::Wider,    [Y,      Y,      Y,      Y]),
    (Class::Unsigned,  Class::Unsigned,  Size::Wider,    [Y,      Y,      Y,      Y]),
    (Class::Unsigned,  Class::Signed,    Size::Wider,    [Y,      Y,      Y,      Y]),
    (Class::Unsigned,  Class::Signed,    Size::Same,     [N,      SIGN,   N,      Y]),
    (Class::Signed,    Class::Unsigned,  Size::Fits,     [N,      SIGN,   N,      Y]),
    (Class::Signed,    Class::Real,      Size::Wider,    [Y,      Y,      Y,      Y]),
    (Class::Unsigned,  Class::Real,      Size::Wider,    [Y,      Y,      Y,      Y]),
    (Class::Signed,    Class::Real,      Size::Same,     [N,      DIGITS, Y,      Y]),
    (Class::Unsigned,  Class::Real,      Size::Same,     [N,      DIGITS, Y,      Y]),
    (Class::Signed,    Class::Real,      Size::Narrower, [N,      DIGITS, N,      N]),
    (Class::Unsigned,  Class::Real,      Size::Narrower, [N,      DIGITS, N,      N]),
    (Class::Real,      Class::Real,      Size::Wider,    [Y,      Y,      Y,      Y]),
    (Class::Real,      Class::Real,      Size::Narrower, [N,      DIGITS, N,      Y]),
    (Class::Bits,      Class::Bits,      Size::Wider,    [Y,      Y,      Y,      Y]),
    (Class::Bits,      Class::Unsigned,  Size::Fits,     [N,      Y,      N,      Y]),
    (Class::Bits,      Class::Signed,    Size::Wider,    [N,      Y,      N,      Y]),
    (Class::Bits,      Class::Signed,    Size::Same,     [N,      SIGN,   N,      Y]),
    (Class::Bits,      Class::Real,      Size::Wider,    [N,      Y,      N,      N]),
    (Class::Bits,      Class::Real,      Size::Same,     [N,      DIGITS, N,      N]),
    (Class::Unsigned,  Class::Bits,      Size::Fits,     [N,      Y,      N,      Y]),
    (Class::Signed,    Class::Bits,      Size::Fits,     [N,      SIGN,   N,      Y]),
    (Class::Duration,  Class::Duration,  Size::Wider,    [Y,      Y,      N,      Y]),
    (Class::Date,      Class::Date,      Size::Wider,    [Y,      Y,      N,      Y]),
    (Class::TimeOfDay, Class::TimeOfDay, Size::Wider,    [Y,      Y,      N,      Y]),
    (Class::Duration,  Class::Signed,    Size::Same,     [N,      N,      N,      Y]),
    (Class::Signed,    Class::Duration,  Size::Same,     [N,      N,      N,      Y]),
    (Class::Character, Class::Character, Size::Wider,    [Y,      Y,      N,      Y]),
    (Class::Character, Class::Bits,      Size::Same,     [N,      N,      N,      Y]),
    (Class::Bits,      Class::Character, Size::Same,     [N,      N,      N,      Y]),
];

/// BOOL to BYTE, WORD, DWORD, LWORD, by dialect.
const BOOL_TO_BITS: [Implicit; 4] = [N, N, Y, Y];

/// Whether a value of one kind converts to another without a conversion function.
pub(crate) fn implicit(from: Kind, to: Kind, dialect: Dialect) -> Implicit {
    if from == to {
        return Implicit::Yes;
    }
    if from == Kind::BOOL || to == Kind::BOOL {
        return if to.class == Class::Bits && to.bits > 1 { BOOL_TO_BITS[dialect.column()] } else { Implicit::No };
    }
    let size = if to.class == Class::Real && from.class != Class::Real {
        // 16 bits fit a REAL exactly, 32 bits an LREAL; 32 bits fit a REAL with rounding.
        (to.bits / 2).cmp(&from.bits).then_with(|| std::cmp::Ordering::Greater)
    } else {
        to.bits.cmp(&from.bits)
    };
    let (size, fits) = match size {
        std::cmp::Ordering::Greater => (Size::Wider, true),
        std::cmp::Ordering::Equal => (Size::Same, true),
        std::cmp::Ordering::Less if to.class == Class::Real && from.class != Class::Real && to.bits == from.bits => (Size::Same, false),
        std::cmp::Ordering::Less => (Size::Narrower, false),
    };
    let row = CONVERSIONS
        .iter()
        .find(|&&(class, target, wanted, _)| class == from.class && target == to.class && (wanted == size || wanted == Size::Fits && fits));
    row.map_or(Implicit::No, |(_, _, _, verdicts)| verdicts[dialect.column()])
}

/// The kind in which an operation on both is computed.
pub(crate) fn common(a: Kind, b: Kind, dialect: Dialect) -> Option<Kind> {
    if a == b {
        return Some(a);
    }
    let (there, back) = (implicit(a, b, dialect), implicit(b, a, dialect));
    let with_real = (a.class == Class::Real) != (b.class == Class::Real);
    match (there, back) {
        // Where both ways are open (equal width of different sign), the type of the left operand is the result.
        (Implicit::Yes, Implicit::Yes) => return Some(if a.class == Class::Bits { b } else { a }),
        (Implicit::Yes, _) => return Some(b),
        (_, Implicit::Yes) => return Some(a),
        (Implicit::Warned(_), _) if with_real => return Some(b),
        (_, Implicit::Warned(_)) if with_real => return Some(a),
        _ => {}
    }
    let smallest =
        CANDIDATES.iter().copied().find(|&kind| implicit(a, kind, dialect) == Implicit::Yes && implicit(b, kind, dialect) == Implicit::Yes);
    smallest.or(match (there, back) {
        (Implicit::Warned(_), _) => Some(b),
        (_, Implicit::Warned(_)) => Some(a),
        _ => None,
    })
}

/// What two types of numbers may meet in, smallest first.
const CANDIDATES: [Kind; 5] = [Kind::INT, Kind::DINT, Kind::REAL, Kind::LINT, Kind::LREAL];

#[cfg(test)]
mod tests {
    use super::*;

    const UINT: Kind = Kind { class: Class::Unsigned, bits: 16 };
    const UDINT: Kind = Kind { class: Class::Unsigned, bits: 32 };
    const BYTE: Kind = Kind { class: Class::Bits, bits: 8 };
    const WORD: Kind = Kind { class: Class::Bits, bits: 16 };

    #[test]
    fn kinds_and_types_lead_to_each_other() {
        for word in DataType::all_words() {
            let Some(data_type) = DataType::from_any_word(word) else { continue };
            if let Some(kind) = Kind::of(&data_type) {
                assert_eq!(kind.data_type(), data_type, "{word}");
                for dialect in Dialect::ALL {
                    assert_eq!(kind.scalar(dialect).bits(), kind.bits, "{word}");
                }
            }
        }
    }

    #[test]
    fn what_converts_by_itself_is_what_the_dialect_says() {
        let all = |from, to| Dialect::ALL.map(|dialect| implicit(from, to, dialect));
        assert_eq!(all(Kind::INT, Kind::DINT), [Y, Y, Y, Y]);
        assert_eq!(all(Kind::DINT, Kind::INT), [N, N, N, N]);
        assert_eq!(all(Kind::INT, Kind::REAL), [Y, Y, Y, Y]);
        assert_eq!(all(Kind::DINT, Kind::REAL), [N, DIGITS, Y, Y]);
        assert_eq!(all(Kind::DINT, Kind::LREAL), [Y, Y, Y, Y]);
        assert_eq!(all(Kind::LINT, Kind::REAL), [N, DIGITS, N, N]);
        assert_eq!(all(Kind::LINT, Kind::LREAL), [N, DIGITS, Y, Y]);
        assert_eq!(all(Kind::REAL, Kind::INT), [N, N, N, N]);
        assert_eq!(all(Kind::INT, UINT), [N, SIGN, N, Y]);
        assert_eq!(all(UINT, Kind::INT), [N, SIGN, N, Y]);
        assert_eq!(all(WORD, Kind::INT), [N, SIGN, N, Y]);
        assert_eq!(all(WORD, UINT), [N, Y, N, Y]);
        assert_eq!(all(BYTE, WORD), [Y, Y, Y, Y]);
        assert_eq!(all(Kind::BOOL, WORD), [N, N, Y, Y]);
        assert_eq!(all(WORD, Kind::BOOL), [N, N, N, N]);
    }

    #[test]
    fn two_operands_meet_in_the_smallest_common_type() {
        let all = |from, to| Dialect::ALL.map(|dialect| common(from, to, dialect));
        assert_eq!(all(Kind::INT, Kind::DINT), [Some(Kind::DINT); 4]);
        assert_eq!(common(Kind::INT, UINT, Dialect::Iec), Some(Kind::DINT));
        assert_eq!(common(Kind::DINT, UDINT, Dialect::Iec), Some(Kind::LINT));
        assert_eq!(all(Kind::DINT, Kind::REAL), [Some(Kind::LREAL), Some(Kind::REAL), Some(Kind::REAL), Some(Kind::REAL)]);
        assert_eq!(common(Kind::BOOL, Kind::INT, Dialect::Iec), None);
        assert_eq!(common(Kind::TIME, Kind::DINT, Dialect::Iec), None);
    }

    #[test]
    fn a_conversion_without_words_loses_nothing() {
        let kinds: Vec<Kind> = DataType::all_words().filter_map(DataType::from_any_word).filter_map(|one| Kind::of(&one)).collect();
        for &from in &kinds {
            for &to in &kinds {
                if implicit(from, to, Dialect::Iec) == Implicit::Yes && from.class != Class::Real {
                    let ((a, b), (c, d)) = (bounds(from.scalar(Dialect::Iec)), bounds(to.scalar(Dialect::Iec)));
                    assert!(c <= a && b <= d, "{from:?} {to:?}");
                }
            }
        }
    }
}
