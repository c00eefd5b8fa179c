//! POINT of the library Util of CODESYS: a place on a curve, as CHARCURVE takes them.

use std::sync::{Arc, LazyLock};

use sieben_model::literal::Value;
use sieben_model::types::{DataType, Field, Structure};

/// The word of the type, where no type of the program has it.
pub(crate) const WORD: &str = "POINT";

/// Two INT that begin with 0.
pub(crate) fn data_type() -> DataType {
    static TYPE: LazyLock<Arc<Structure>> = LazyLock::new(|| {
        let field = |(name, offset): (&str, u32)| Field {
            name: name.to_owned(),
            data_type: DataType::Int,
            offset,
            initial: vec![Value::Image(vec![0, 0])],
            comment: String::new(),
        };
        // Structures of the same fields are one type: a program may declare it, too.
        Arc::new(Structure { name: None, fields: [("X", 0), ("Y", 16)].map(field).to_vec(), size: 4, index: Default::default() })
    });
    DataType::Struct(Arc::clone(&TYPE))
}
