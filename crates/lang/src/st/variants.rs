//! VARIANT of tia: an ANY, beside which the caller tells the type of what it points to and how many elements it has.

use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::literal::any_type_code;
use sieben_model::types::{DataType, Structure};

use super::ast::{TypeKind, TypeSpec};

/// The word of the type.
pub(crate) const WORD: &str = "VARIANT";

/// The code of a STRING in an ANY, whatever its length; a WSTRING has the same one and the sign of what the S7-300 does not have.
const TEXT: u32 = 0x13;
/// Sets codes of our own apart from those of an ANY.
const OWN: u32 = 0x8000_0000;

/// What the caller tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Told {
    /// The number of the type, of an array that of its elements: [`type_number`]; 0 = nothing is given.
    Type,
    /// How many elements an array has; 0 = it is no array.
    Count,
}

impl Told {
    pub(crate) const BOTH: [Self; 2] = [Self::Type, Self::Count];

    /// The type of the input that tells it.
    pub(crate) fn data_type(self) -> DataType {
        match self {
            Self::Type => DataType::LongWord,
            Self::Count => DataType::UnsignedDoubleInt,
        }
    }
}

/// The name of the input that tells something of a VARIANT.
pub(crate) fn told_name(variant: &str, told: Told) -> String {
    let word = if told == Told::Type { "TYPE" } else { "COUNT" };
    format!("{variant}__{word}")
}

/// Whether a type is written as VARIANT.
pub(crate) fn is_variant(written: &TypeSpec) -> bool {
    matches!(&written.kind, TypeKind::Named(path) if matches!(path.names.as_slice(), [name] if name.is(WORD)))
}

/// Whether an input tells something of a VARIANT: calls do not name it.
pub(crate) fn is_told(interface: &Interface, variable: &Variable) -> bool {
    let tells = |variant: &Variable| Told::BOTH.iter().any(|&told| told_name(&variant.name, told) == variable.name);
    variable.section == Section::Input
        && variable.name.contains("__")
        && interface.variables.iter().any(|variant| variant.data_type == DataType::Any && tells(variant))
}

/// The element of an array and how many there are; of any other type itself and 0.
pub(crate) fn elements(data_type: &DataType) -> (&DataType, u32) {
    match data_type {
        DataType::Array { bounds, element } => {
            let count = bounds.iter().map(|(low, high)| (i64::from(*high) - i64::from(*low) + 1).max(0) as u64).product::<u64>();
            (element, u32::try_from(count).unwrap_or(u32::MAX))
        }
        other => (other, 0),
    }
}

/// The number of a type that is no array: in the high half what it is, in the low half how many bits it has, 0 for texts of any length.
pub(crate) fn type_number(data_type: &DataType) -> u64 {
    let data_type = data_type.base();
    let (code, bits) = match data_type {
        DataType::String(_) => (TEXT, 0),
        DataType::WideString(_) => (TEXT | OWN, 0),
        other => (code_of(other), other.bits()),
    };
    u64::from(code) << 32 | (bits & 0xFFFF_FFFF)
}

fn code_of(data_type: &DataType) -> u32 {
    match data_type {
        DataType::Struct(structure) => named(structure.name.as_deref(), structure),
        DataType::Instance { block, .. } => hashed(block.to_string().bytes()),
        other => match other.word() {
            Some(word) => any_type_code(word).map_or_else(|| hashed(word.bytes()), u32::from),
            None => hashed(format!("{other:?}").bytes()),
        },
    }
}

/// Structures with a name are of one type if the names are the same, others if their fields are.
fn named(name: Option<&str>, structure: &Structure) -> u32 {
    match name {
        Some(name) => hashed(name.bytes().map(|letter| letter.to_ascii_uppercase())),
        None => {
            let field = |data_type: &DataType| {
                let (element, count) = elements(data_type);
                type_number(element) ^ u64::from(count)
            };
            hashed(structure.fields.iter().flat_map(|one| field(&one.data_type).to_be_bytes().into_iter().chain(one.offset.to_be_bytes())))
        }
    }
}

/// FNV-1a: the same number for the same type in every block and every run.
fn hashed(bytes: impl Iterator<Item = u8>) -> u32 {
    bytes.fold(0x811C_9DC5_u32, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)) | OWN
}
