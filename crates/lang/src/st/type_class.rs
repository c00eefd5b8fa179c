//! What an input of type ANY says of its variable in codesys: TypeClass, diSize and pValue.

use std::sync::Arc;

use sieben_model::types::{DataType, Enumeration, ReferenceKind};

/// The type of TypeClass.
pub(crate) const WORD: &str = "TYPE_CLASS";
/// What stands before it and before the types of the system.
pub(crate) const SYSTEM: &str = "__SYSTEM";

/// Words for types of any kind.
pub(crate) const ANY_WORDS: [&str; 7] = ["ANY", "ANY_BIT", "ANY_DATE", "ANY_INT", "ANY_NUM", "ANY_REAL", "ANY_STRING"];

/// The values of the type, in their order.
#[rustfmt::skip] // A table.
const VALUES: &[&str] = &[
    "TYPE_BOOL", "TYPE_BIT", "TYPE_BYTE", "TYPE_WORD", "TYPE_DWORD", "TYPE_LWORD", "TYPE_SINT", "TYPE_INT", "TYPE_DINT", "TYPE_LINT",
    "TYPE_USINT", "TYPE_UINT", "TYPE_UDINT", "TYPE_ULINT", "TYPE_REAL", "TYPE_LREAL", "TYPE_STRING", "TYPE_WSTRING", "TYPE_TIME",
    "TYPE_DATE", "TYPE_DATEANDTIME", "TYPE_TIMEOFDAY", "TYPE_POINTER", "TYPE_REFERENCE", "TYPE_SUBRANGE", "TYPE_ENUM", "TYPE_ARRAY",
    "TYPE_PARAMS", "TYPE_USERDEF", "TYPE_NONE", "TYPE_ANY", "TYPE_ANYBIT", "TYPE_ANYDATE", "TYPE_ANYINT", "TYPE_ANYNUM", "TYPE_ANYREAL",
    "TYPE_LAZY", "TYPE_LTIME",
];

/// The enumeration.
pub(crate) fn data_type() -> DataType {
    DataType::Enumeration(Arc::new(Enumeration {
        name: Some(WORD.to_owned()),
        base: DataType::Int,
        values: VALUES.iter().zip(0..).map(|(value, number)| ((*value).to_owned(), number)).collect(),
        initial: 0,
        named: false,
        index: Default::default(),
    }))
}

/// The value for a type.
pub(crate) fn class_of(data_type: &DataType) -> u32 {
    use DataType as T;
    let word = match data_type {
        T::Bool => "TYPE_BOOL",
        T::Byte | T::Char => "TYPE_BYTE",
        T::Word | T::WideChar => "TYPE_WORD",
        T::DoubleWord => "TYPE_DWORD",
        T::LongWord => "TYPE_LWORD",
        T::SmallInt => "TYPE_SINT",
        T::Int => "TYPE_INT",
        T::DoubleInt => "TYPE_DINT",
        T::LongInt => "TYPE_LINT",
        T::UnsignedSmallInt => "TYPE_USINT",
        T::UnsignedInt => "TYPE_UINT",
        T::UnsignedDoubleInt => "TYPE_UDINT",
        T::UnsignedLongInt => "TYPE_ULINT",
        T::Real => "TYPE_REAL",
        T::LongReal => "TYPE_LREAL",
        T::String(_) => "TYPE_STRING",
        T::WideString(_) => "TYPE_WSTRING",
        T::Time => "TYPE_TIME",
        T::LongTime => "TYPE_LTIME",
        T::Date | T::LongDate => "TYPE_DATE",
        T::DateAndTime | T::LongDateAndTime => "TYPE_DATEANDTIME",
        T::TimeOfDay | T::LongTimeOfDay => "TYPE_TIMEOFDAY",
        T::Reference(reference) if reference.kind == ReferenceKind::Reference => "TYPE_REFERENCE",
        T::Reference(_) => "TYPE_POINTER",
        T::Subrange(_) => "TYPE_SUBRANGE",
        T::Enumeration(_) => "TYPE_ENUM",
        T::Array { .. } => "TYPE_ARRAY",
        T::Struct(_) | T::Instance { .. } => "TYPE_USERDEF",
        _ => "TYPE_NONE",
    };
    VALUES.iter().position(|value| *value == word).map_or(u32::MAX, |position| position as u32)
}
