//! Data types and their layout in data blocks and local data.

use std::fmt;
use std::sync::Arc;

use crate::address::Width;
use crate::block::BlockId;
use crate::literal::Value;
use crate::name_index::NameIndex;

/// A data type of STEP 7, or of those that its controllers lack and Structured Text has; all with the layout rules of the S7.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The variants are the manual's own names.
pub enum DataType {
    Bool,
    Byte,
    Char,
    Word,
    Int,
    DoubleWord,
    DoubleInt,
    Real,
    Date,
    TimeOfDay,
    Time,
    S5Time,
    DateAndTime,
    /// STRING with its maximum length.
    String(u8),
    /// ARRAY with its bounds, first dimension first; a low one above the high one is `*` of an ARRAY[*].
    Array {
        bounds: Vec<(i32, i32)>,
        element: Box<DataType>,
    },
    /// STRUCT or a UDT (then with its name).
    Struct(Arc<Structure>),
    /// An instance of a function block inside another one.
    Instance {
        block: BlockId,
        structure: Arc<Structure>,
    },
    Pointer,
    Any,
    Timer,
    Counter,
    BlockFunction,
    BlockFunctionBlock,
    BlockData,
    BlockSystemData,
    Void,
    /// SINT.
    SmallInt,
    /// USINT.
    UnsignedSmallInt,
    /// UINT.
    UnsignedInt,
    /// UDINT.
    UnsignedDoubleInt,
    /// LINT.
    LongInt,
    /// ULINT.
    UnsignedLongInt,
    /// LWORD.
    LongWord,
    /// LREAL.
    LongReal,
    /// LTIME in nanoseconds.
    LongTime,
    /// LDATE: nanoseconds since 1970-01-01 at midnight, as an unsigned number.
    LongDate,
    /// LTOD: nanoseconds since midnight.
    LongTimeOfDay,
    /// LDT: nanoseconds since 1970-01-01, as an unsigned number.
    LongDateAndTime,
    /// WCHAR, a unit of UTF-16.
    WideChar,
    /// WSTRING with its maximum length: that and the actual length as words, then units of UTF-16.
    WideString(u16),
    /// A type with named values.
    Enumeration(Arc<Enumeration>),
    /// An integer type with limits.
    Subrange(Arc<Subrange>),
    /// REF_TO, POINTER TO, REFERENCE TO: eight bytes, of which the first two are 0, then a data block number (0 = none) and an
    /// area-crossing pointer; all 0 = NULL.
    Reference(Arc<Reference>),
}

/// A type with named values.
#[derive(Clone, Debug, PartialEq)]
pub struct Enumeration {
    /// The name of the type; `None` for one that is written where a variable is declared.
    pub name: Option<String>,
    /// The integer type that holds the values.
    pub base: DataType,
    /// The names and their values, in the order of the declaration.
    pub values: Vec<(String, i64)>,
    /// What a variable holds at the start.
    pub initial: i64,
    /// As text a value is its name: the attribute 'to_string' of CODESYS.
    pub named: bool,
    /// Where the names stand.
    pub index: NameIndex,
}

/// Two that are one need not be compared, which the standard library spares only types that say so.
impl Eq for Enumeration {}

impl Enumeration {
    /// The value with this name, without regard to case.
    pub fn value(&self, name: &str) -> Option<i64> {
        self.index.find(&self.values, |(name, _)| name, name).map(|&(_, value)| value)
    }
}

/// An integer type with limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Subrange {
    /// The name of the type; `None` for one that is written where a variable is declared.
    pub name: Option<String>,
    /// The integer type that holds the values.
    pub base: DataType,
    /// The smallest value.
    pub low: i128,
    /// The greatest value.
    pub high: i128,
    /// What a variable holds at the start.
    pub initial: i128,
}

/// What a reference refers to, and how it is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// The type of what it refers to.
    pub target: DataType,
    /// How it is written.
    pub kind: ReferenceKind,
}

/// How a reference is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReferenceKind {
    /// `REF_TO`: followed with `^`.
    RefTo,
    /// `POINTER TO`: followed with `^`, and a number that can be counted with.
    Pointer,
    /// `REFERENCE TO`: used like the variable itself.
    Reference,
    /// The name of an interface: refers to an instance of a block that implements it.
    Interface,
}

/// The fields of a STRUCT, UDT or instance, laid out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Structure {
    /// `UDT 7` or its symbol, if the structure has a name.
    pub name: Option<String>,
    /// The fields in declaration order.
    pub fields: Vec<Field>,
    /// Length in bytes, always even.
    pub size: u32,
    /// Where the names of the fields stand.
    pub index: NameIndex,
}

/// Two that are one need not be compared, which the standard library spares only types that say so; also a NaN in it is the same then.
impl Eq for Structure {}

/// One field of a structure.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The name as declared.
    pub name: String,
    /// Its type.
    pub data_type: DataType,
    /// Offset from the start of the structure, in bits.
    pub offset: u32,
    /// Initial values: none, one, or one per array element in order (fewer than elements is allowed).
    pub initial: Vec<Value>,
    /// The comment behind the declaration.
    pub comment: String,
}

impl Structure {
    /// The field with this name, without regard to case.
    pub fn field(&self, name: &str) -> Option<&Field> {
        self.index.find(&self.fields, |field| &field.name, name)
    }
}

/// The types that one word names; of two words for one type the first is written.
const WORDS: &[(&str, DataType)] = &[
    ("BOOL", DataType::Bool),
    ("BYTE", DataType::Byte),
    ("CHAR", DataType::Char),
    ("WORD", DataType::Word),
    ("INT", DataType::Int),
    ("DWORD", DataType::DoubleWord),
    ("DINT", DataType::DoubleInt),
    ("REAL", DataType::Real),
    ("DATE", DataType::Date),
    ("TIME_OF_DAY", DataType::TimeOfDay),
    ("TOD", DataType::TimeOfDay),
    ("TIME", DataType::Time),
    ("S5TIME", DataType::S5Time),
    ("DATE_AND_TIME", DataType::DateAndTime),
    ("DT", DataType::DateAndTime),
    ("STRING", DataType::String(STRING_LENGTH_MAX)),
    ("POINTER", DataType::Pointer),
    ("ANY", DataType::Any),
    ("TIMER", DataType::Timer),
    ("COUNTER", DataType::Counter),
    ("BLOCK_FC", DataType::BlockFunction),
    ("BLOCK_FB", DataType::BlockFunctionBlock),
    ("BLOCK_DB", DataType::BlockData),
    ("BLOCK_SDB", DataType::BlockSystemData),
    ("VOID", DataType::Void),
];

/// The types that an S7-300/400 does not have, by their words; of two words for one type the first is written.
const WORDS_ELSEWHERE: &[(&str, DataType)] = &[
    ("SINT", DataType::SmallInt),
    ("USINT", DataType::UnsignedSmallInt),
    ("UINT", DataType::UnsignedInt),
    ("UDINT", DataType::UnsignedDoubleInt),
    ("LINT", DataType::LongInt),
    ("ULINT", DataType::UnsignedLongInt),
    ("LWORD", DataType::LongWord),
    ("LREAL", DataType::LongReal),
    ("LTIME", DataType::LongTime),
    ("LDATE", DataType::LongDate),
    ("LTOD", DataType::LongTimeOfDay),
    ("LTIME_OF_DAY", DataType::LongTimeOfDay),
    ("LDT", DataType::LongDateAndTime),
    ("LDATE_AND_TIME", DataType::LongDateAndTime),
    ("WCHAR", DataType::WideChar),
    ("WSTRING", DataType::WideString(STRING_LENGTH_MAX as u16)),
];

/// Characters that a STRING may have, and has if its declaration does not say.
pub const STRING_LENGTH_MAX: u8 = 254;

impl DataType {
    /// The type that a word names, without regard to case: `INT`, `TOD`, `STRING` of the greatest length.
    pub fn from_word(word: &str) -> Option<Self> {
        WORDS.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)).map(|(_, data_type)| data_type.clone())
    }

    /// The type of Structured Text that a word names, without regard to case: those of [`Self::from_word`] and the ones that an
    /// S7-300/400 does not have.
    pub fn from_any_word(word: &str) -> Option<Self> {
        let elsewhere = || WORDS_ELSEWHERE.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)).map(|(_, data_type)| data_type.clone());
        Self::from_word(word).or_else(elsewhere)
    }

    /// The words of [`Self::from_any_word`].
    pub fn all_words() -> impl Iterator<Item = &'static str> {
        WORDS.iter().chain(WORDS_ELSEWHERE).map(|&(word, _)| word)
    }

    /// The words of an S7-300/400 that name a type by themselves.
    pub fn words() -> impl Iterator<Item = &'static str> {
        WORDS.iter().map(|&(word, _)| word)
    }

    /// The word of a type that one word names.
    pub fn word(&self) -> Option<&'static str> {
        WORDS.iter().chain(WORDS_ELSEWHERE).find(|(_, data_type)| data_type == self).map(|&(word, _)| word)
    }

    /// Whether its values have names.
    pub fn is_enumeration(&self) -> bool {
        match self {
            Self::Enumeration(_) => true,
            Self::Subrange(subrange) => subrange.base.is_enumeration(),
            _ => false,
        }
    }

    /// Whether a value is no number of at most 64 bits but a row of bytes, however short.
    pub fn stands_in_bytes(&self) -> bool {
        matches!(
            self,
            Self::String(_)
                | Self::WideString(_)
                | Self::Array { .. }
                | Self::Struct(_)
                | Self::Instance { .. }
                | Self::Pointer
                | Self::Any
                | Self::Void
        )
    }

    /// The type whose values an enumeration or a subrange holds; any other type itself.
    pub fn base(&self) -> &Self {
        match self {
            Self::Enumeration(enumeration) => enumeration.base.base(),
            Self::Subrange(subrange) => subrange.base.base(),
            other => other,
        }
    }

    /// LDATE or LDT where DATE and DT have 64 bits, too: a type of its own with the same values, because as a number it counts nanoseconds
    /// where DATE and DT count seconds. Any other type itself.
    pub fn of_nanoseconds(self, word: &str) -> Self {
        let long =
            matches!(self, Self::LongDate | Self::LongDateAndTime) && word.get(..1).is_some_and(|first| first.eq_ignore_ascii_case("L"));
        if !long {
            return self;
        }
        let name = self.word().map(str::to_owned);
        Self::Subrange(Arc::new(Subrange { name, base: self, low: 0, high: i128::from(u64::MAX), initial: 0 }))
    }

    /// Whether it is one of [`Self::of_nanoseconds`].
    pub fn counts_nanoseconds(&self) -> bool {
        matches!(self, Self::Subrange(subrange) if matches!(subrange.base, Self::LongDate | Self::LongDateAndTime))
    }

    /// The width of an elementary type.
    pub fn width(&self) -> Option<Width> {
        if !self.is_elementary() {
            return None;
        }
        Some(match self.bits() {
            1 => Width::Bit,
            8 => Width::Byte,
            16 => Width::Word,
            _ => Width::DoubleWord,
        })
    }

    /// Whether a variable of the type is an instance of a function block, or has one in it.
    pub fn holds_instance(&self) -> bool {
        match self {
            Self::Instance { .. } => true,
            Self::Array { element, .. } => element.holds_instance(),
            Self::Struct(structure) => structure.size > 0 && structure.fields.iter().any(|field| field.data_type.holds_instance()),
            _ => false,
        }
    }

    /// Length in bits: 1 for BOOL, a multiple of 8 for all else; padded to words for complex types.
    pub fn bits(&self) -> u64 {
        match self {
            Self::Void => 0,
            Self::Bool => 1,
            Self::Byte | Self::Char | Self::SmallInt | Self::UnsignedSmallInt => 8,
            Self::Word | Self::Int | Self::Date | Self::S5Time | Self::UnsignedInt | Self::WideChar => 16,
            Self::Timer | Self::Counter => 16,
            Self::BlockFunction | Self::BlockFunctionBlock | Self::BlockData | Self::BlockSystemData => 16,
            Self::DoubleWord | Self::DoubleInt | Self::Real | Self::TimeOfDay | Self::Time | Self::UnsignedDoubleInt => 32,
            Self::DateAndTime | Self::Reference(_) => 64,
            Self::LongInt | Self::UnsignedLongInt | Self::LongWord | Self::LongReal => 64,
            Self::LongTime | Self::LongDate | Self::LongTimeOfDay | Self::LongDateAndTime => 64,
            Self::Enumeration(_) | Self::Subrange(_) => self.base().bits(),
            Self::WideString(length) => (u64::from(*length) + 2) * 16,
            Self::Pointer => 48,
            Self::Any => 80,
            Self::String(length) => (u64::from(*length) + 2).next_multiple_of(2) * 8,
            Self::Array { .. } => round_up(array_bits(self), 16),
            Self::Struct(structure) | Self::Instance { structure, .. } => u64::from(structure.size) * 8,
        }
    }

    /// Size in bits without what fills an array up to a word.
    pub fn bits_used(&self) -> u64 {
        match self {
            Self::Array { .. } => array_bits(self),
            other => other.bits(),
        }
    }

    /// Whether a value starts at an even byte.
    pub fn word_aligned(&self) -> bool {
        !matches!(self.base(), Self::Bool | Self::Byte | Self::Char | Self::SmallInt | Self::UnsignedSmallInt)
    }

    /// Whether the type fits ACCU 1: at most 32 bits and not a structure.
    pub fn is_elementary(&self) -> bool {
        matches!(
            self.base(),
            Self::Bool
                | Self::Byte
                | Self::Char
                | Self::Word
                | Self::Int
                | Self::DoubleWord
                | Self::DoubleInt
                | Self::Real
                | Self::Date
                | Self::TimeOfDay
                | Self::Time
                | Self::S5Time
                | Self::SmallInt
                | Self::UnsignedSmallInt
                | Self::UnsignedInt
                | Self::UnsignedDoubleInt
                | Self::WideChar
        )
    }

    /// Whether a value is one number of 64 bits (DATE_AND_TIME, a row of BCD digits, is none).
    pub fn is_long(&self) -> bool {
        matches!(
            self.base(),
            Self::LongInt
                | Self::UnsignedLongInt
                | Self::LongWord
                | Self::LongReal
                | Self::LongTime
                | Self::LongDate
                | Self::LongTimeOfDay
                | Self::LongDateAndTime
                | Self::Reference(_)
        )
    }

    /// Whether a value is the number of a timer, a counter or a block.
    pub fn is_number(&self) -> bool {
        matches!(
            self,
            Self::Timer | Self::Counter | Self::BlockFunction | Self::BlockFunctionBlock | Self::BlockData | Self::BlockSystemData
        )
    }

    /// Number of elements of an array (1 for all else), saturating.
    pub fn elements(&self) -> u64 {
        match self {
            Self::Array { bounds, .. } => bounds
                .iter()
                .map(|&(low, high)| u64::try_from(i64::from(high) - i64::from(low) + 1).unwrap_or(0))
                .fold(1, u64::saturating_mul),
            _ => 1,
        }
    }

    /// The number of the array element with these indexes, counted from 0 with the last index running fastest;
    /// `None` if the array has other dimensions or bounds.
    pub fn element_number(&self, indexes: &[i64]) -> Option<u64> {
        let Self::Array { bounds, .. } = self else { return None };
        if indexes.len() != bounds.len() {
            return None;
        }
        indexes.iter().zip(bounds).try_fold(0_u64, |number, (&index, &(low, high))| {
            let (low, high) = (i64::from(low), i64::from(high));
            let count = u64::try_from(high - low + 1).ok()?;
            (low..=high).contains(&index).then(|| number.saturating_mul(count).saturating_add(index.abs_diff(low)))
        })
    }

    /// Offset in bits of the array element with this index (counted from 0 over all dimensions, last index fastest).
    pub fn element_offset(&self, flat: u64) -> u64 {
        let Self::Array { bounds, element } = self else { return 0 };
        let step = element_step(element);
        let inner = bounds.last().map_or(1, |&(low, high)| u64::try_from(i64::from(high) - i64::from(low) + 1).unwrap_or(1)).max(1);
        if bounds.len() < 2 || element.word_aligned() {
            return flat.saturating_mul(step);
        }
        // The innermost dimension of BOOL, BYTE and CHAR is padded to a word when there are several dimensions.
        let row = round_up(inner.saturating_mul(step), 16);
        (flat / inner).saturating_mul(row).saturating_add((flat % inner) * step)
    }
}

impl fmt::Display for DataType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::String(length) => write!(f, "STRING[{length}]"),
            Self::Array { element, bounds } => {
                let shown = |&(low, high): &(i32, i32)| if low > high { "*".to_owned() } else { format!("{low}..{high}") };
                let bounds: Vec<String> = bounds.iter().map(shown).collect();
                write!(f, "ARRAY[{}] OF {element}", bounds.join(", "))
            }
            Self::Struct(structure) => f.write_str(structure.name.as_deref().unwrap_or("STRUCT")),
            Self::Instance { block, structure } => match &structure.name {
                Some(name) => f.write_str(name),
                None => block.fmt(f),
            },
            Self::WideString(length) => write!(f, "WSTRING[{length}]"),
            Self::Enumeration(enumeration) => f.write_str(enumeration.name.as_deref().unwrap_or("this enumeration")),
            Self::Subrange(subrange) => match &subrange.name {
                Some(name) => f.write_str(name),
                None => write!(f, "{}({}..{})", subrange.base, subrange.low, subrange.high),
            },
            Self::Reference(reference) => {
                let words = match reference.kind {
                    ReferenceKind::RefTo => "REF_TO",
                    ReferenceKind::Pointer => "POINTER TO",
                    ReferenceKind::Reference => "REFERENCE TO",
                    ReferenceKind::Interface => return reference.target.fmt(f),
                };
                write!(f, "{words} {}", reference.target)
            }
            simple => f.write_str(simple.word().unwrap_or_default()),
        }
    }
}

/// Distance of two neighbouring array elements, in bits.
fn element_step(element: &DataType) -> u64 {
    match element {
        DataType::Bool => 1,
        _ => element.bits(),
    }
}

fn array_bits(array: &DataType) -> u64 {
    let DataType::Array { element, .. } = array else { return 0 };
    let count = array.elements();
    if count == 0 {
        return 0;
    }
    array.element_offset(count - 1).saturating_add(element_step(element))
}

/// Where the next variable of a type goes, and the cursor behind it; both in bits.
pub fn place(cursor: u64, data_type: &DataType) -> (u64, u64) {
    let start = match data_type {
        DataType::Bool => cursor,
        _ if !data_type.word_aligned() => round_up(cursor, 8),
        _ => round_up(cursor, 16),
    };
    (start, start.saturating_add(data_type.bits()))
}

/// The next multiple, saturating: a type in a source can be larger than any number.
fn round_up(bits: u64, to: u64) -> u64 {
    bits.checked_next_multiple_of(to).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_array_has_a_length() {
        for element in [DataType::Bool, DataType::Byte, DataType::Real, DataType::String(STRING_LENGTH_MAX)] {
            let array = DataType::Array { bounds: vec![(i32::MIN, i32::MAX); 6], element: Box::new(element) };
            assert!(array.bits() > u64::MAX / 2);
            let (start, end) = place(1, &DataType::Array { bounds: vec![(0, 9); 2], element: Box::new(array) });
            assert_eq!((start, end), (16, u64::MAX));
        }
    }
}
