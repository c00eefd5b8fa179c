//! ErrorStruct of TIA: what GET_ERROR tells of an error.

use std::sync::{Arc, LazyLock};

use sieben_model::types::{DataType, Field, Structure};

/// A row of a structure of TIA: the name of a field, its type, its first byte.
type Row = (&'static str, fn() -> DataType, u32);

/// The structures: name, bytes, fields. CREF says where the error is in the program, NREF in the data.
const STRUCTURES: &[(&str, u32, &[Row])] = &[
    (
        "ErrorStruct",
        28,
        &[
            ("ERROR_ID", || DataType::Word, 0),
            ("FLAGS", || DataType::Byte, 2),
            ("REACTION", || DataType::Byte, 3),
            ("CODE_ADDRESS", || made("CREF"), 4),
            ("MODE", || DataType::Byte, 12),
            ("OPERAND_NUMBER", || DataType::UnsignedInt, 14),
            ("POINTER_NUMBER_LOCATION", || DataType::UnsignedInt, 16),
            ("SLOT_NUMBER_SCOPE", || DataType::UnsignedInt, 18),
            ("DATA_ADDRESS", || made("NREF"), 20),
        ],
    ),
    (
        "CREF",
        8,
        &[("BLOCK_TYPE", || DataType::Byte, 0), ("CB_NUMBER", || DataType::UnsignedInt, 2), ("OFFSET", || DataType::UnsignedDoubleInt, 4)],
    ),
    (
        "NREF",
        8,
        &[("AREA", || DataType::Byte, 0), ("DB_NUMBER", || DataType::UnsignedInt, 2), ("OFFSET", || DataType::UnsignedDoubleInt, 4)],
    ),
];

/// First byte in an ErrorStruct of what the CPU tells: the number, what became of the statement, the block, its number, the statement.
pub(crate) const TOLD: [u32; 5] = [0, 3, 4, 6, 8];

/// Bytes of an ErrorStruct.
pub(crate) const BYTES: u32 = STRUCTURES[0].1;

/// The type with this name; `None` for other names.
pub(crate) fn data_type(word: &str) -> Option<DataType> {
    // Made once, so that two variables are of one type.
    static TYPES: LazyLock<Vec<DataType>> = LazyLock::new(|| STRUCTURES.iter().map(|(name, ..)| made(name)).collect());
    let at = STRUCTURES.iter().position(|(name, ..)| name.eq_ignore_ascii_case(word))?;
    TYPES.get(at).cloned()
}

fn made(word: &str) -> DataType {
    let fields = |rows: &[Row]| rows.iter().map(|(name, data_type, at)| field(name, data_type(), *at)).collect();
    match STRUCTURES.iter().find(|(name, ..)| *name == word) {
        Some((name, size, rows)) => DataType::Struct(Arc::new(Structure {
            name: Some((*name).to_owned()),
            fields: fields(rows),
            size: *size,
            index: Default::default(),
        })),
        None => DataType::Void,
    }
}

fn field(name: &str, data_type: DataType, at: u32) -> Field {
    Field { name: name.to_owned(), data_type, offset: at * 8, initial: Vec::new(), comment: String::new() }
}

/// Whether a type is ErrorStruct.
pub(crate) fn is_error_struct(data_type: &DataType) -> bool {
    matches!(data_type, DataType::Struct(structure) if structure.name.as_deref() == Some(STRUCTURES[0].0))
}
