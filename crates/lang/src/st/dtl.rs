//! DTL, the point in time of TIA: a structure of twelve bytes with the parts of a date as numbers.

use std::sync::{Arc, LazyLock};

use sieben_model::literal::Value;
use sieben_model::literal::elsewhere::date_of_days;
use sieben_model::types::{DataType, Field, Structure};

/// The word of the type.
pub(crate) const WORD: &str = "DTL";

/// Bytes of a DTL.
pub(crate) const BYTES: usize = 12;

const SECOND: u64 = 1_000_000_000;
const DAY: u64 = 86_400 * SECOND;

/// The fields: name, type, first byte.
const FIELDS: &[(&str, DataType, usize)] = &[
    ("YEAR", DataType::UnsignedInt, 0),
    ("MONTH", DataType::UnsignedSmallInt, 2),
    ("DAY", DataType::UnsignedSmallInt, 3),
    ("WEEKDAY", DataType::UnsignedSmallInt, 4),
    ("HOUR", DataType::UnsignedSmallInt, 5),
    ("MINUTE", DataType::UnsignedSmallInt, 6),
    ("SECOND", DataType::UnsignedSmallInt, 7),
    ("NANOSECOND", DataType::UnsignedDoubleInt, 8),
];

/// The type. A variable of it begins with 1970-01-01, a Thursday.
pub(crate) fn data_type() -> DataType {
    static TYPE: LazyLock<Arc<Structure>> = LazyLock::new(|| {
        let first = bytes(0);
        let field = |(name, data_type, at): &(&str, DataType, usize)| Field {
            name: (*name).to_owned(),
            data_type: data_type.clone(),
            offset: (*at as u32) * 8,
            initial: vec![Value::Image(first[*at..*at + data_type.bits() as usize / 8].to_vec())],
            comment: String::new(),
        };
        Arc::new(Structure {
            name: Some(WORD.to_owned()),
            fields: FIELDS.iter().map(field).collect(),
            size: BYTES as u32,
            index: Default::default(),
        })
    });
    DataType::Struct(Arc::clone(&TYPE))
}

/// Whether a type is DTL.
pub(crate) fn is_dtl(data_type: &DataType) -> bool {
    matches!(data_type, DataType::Struct(structure) if structure.name.as_deref() == Some(WORD))
}

/// The bytes of a point in time in nanoseconds since 1970.
pub(crate) fn bytes(nanoseconds: u64) -> [u8; BYTES] {
    let (days, rest) = (nanoseconds / DAY, nanoseconds % DAY);
    let (year, month, day) = date_of_days(days);
    let seconds = rest / SECOND;
    // 1970-01-01 was a Thursday; 1 is Sunday.
    let weekday = (days + 4) % 7 + 1;
    let mut all = [0; BYTES];
    all[..2].copy_from_slice(&(year as u16).to_be_bytes());
    for (at, part) in [(2, month), (3, day), (4, weekday), (5, seconds / 3600), (6, seconds / 60 % 60), (7, seconds % 60)] {
        all[at] = part as u8;
    }
    all[8..].copy_from_slice(&((rest % SECOND) as u32).to_be_bytes());
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_in_time_has_its_parts() {
        // 2024-02-29-12:34:56.789 was a Thursday.
        assert_eq!(bytes(1_709_210_096_789_000_000), [7, 232, 2, 29, 5, 12, 34, 56, 0x2F, 0x07, 0x2F, 0x40]);
        assert_eq!(bytes(0), [7, 178, 1, 1, 5, 0, 0, 0, 0, 0, 0, 0]);
    }
}
