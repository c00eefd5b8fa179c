//! Whether a constant fits a type, and its bytes.

use sieben_model::literal::{Value, s5time_shortened};
use sieben_model::types::DataType;

/// Why a constant does not fit a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Misfit {
    /// The notation is of another type.
    Type,
    /// The notation fits, the value is too large or too small.
    Range,
}

/// The constant as a value of the type.
///
/// More is accepted than the editor of STEP 7 takes, as long as it can mean only one thing: `5` for a WORD, `W#16#5` for an INT, `1` for a REAL.
pub(crate) fn coerce(value: &Value, data_type: &DataType) -> Result<Value, Misfit> {
    let bits = |width: u32| bit_pattern(value, width);
    match data_type {
        DataType::Bool => match (value, number(value)) {
            (Value::Bool(bit), _) => Ok(Value::Bool(*bit)),
            (_, Some(0)) => Ok(Value::Bool(false)),
            (_, Some(1)) => Ok(Value::Bool(true)),
            (_, Some(_)) => Err(Misfit::Range),
            _ => Err(Misfit::Type),
        },
        DataType::Byte | DataType::Char => Ok(Value::Byte(bits(8)? as u8)),
        DataType::Word | DataType::S5Time | DataType::Date => Ok(Value::Word(bits(16)? as u16)),
        DataType::Int => Ok(Value::Int(bits(16)? as u16 as i16)),
        DataType::DoubleWord | DataType::Time | DataType::TimeOfDay => Ok(Value::DoubleWord(bits(32)?)),
        DataType::DoubleInt => Ok(Value::DoubleInt(bits(32)? as i32)),
        DataType::Real => match value {
            Value::Real(real) => Ok(Value::Real(*real)),
            Value::Int(integer) => Ok(Value::Real(f32::from(*integer))),
            Value::DoubleInt(integer) => Ok(Value::Real(*integer as f32)),
            _ => Err(Misfit::Type),
        },
        DataType::DateAndTime => match value {
            Value::DateAndTime(_) => Ok(value.clone()),
            _ => Err(Misfit::Type),
        },
        DataType::String(length) => match value {
            Value::Characters(text) if text.len() <= usize::from(*length) => Ok(value.clone()),
            Value::Characters(_) => Err(Misfit::Range),
            _ => Err(Misfit::Type),
        },
        DataType::Pointer => match value {
            Value::Pointer(pointer) => Ok(Value::DataPointer { db: 0, pointer: *pointer }),
            Value::DataPointer { .. } => Ok(value.clone()),
            _ => Err(Misfit::Type),
        },
        DataType::Any => match value {
            Value::Any(_) => Ok(value.clone()),
            _ => Err(Misfit::Type),
        },
        _ => Err(Misfit::Type),
    }
}

/// Whether the notation of the constant is one of the type itself, so that nothing was converted.
pub(crate) fn natural(value: &Value, data_type: &DataType) -> bool {
    match data_type {
        DataType::Time => matches!(value, Value::Time(_)),
        DataType::TimeOfDay => matches!(value, Value::TimeOfDay(_)),
        DataType::Date => matches!(value, Value::Date(_)),
        DataType::S5Time => matches!(value, Value::S5Time(_) | Value::Word(_)),
        _ => true,
    }
}

fn number(value: &Value) -> Option<i64> {
    match value {
        Value::Int(value) => Some(i64::from(*value)),
        Value::DoubleInt(value) => Some(i64::from(*value)),
        Value::Byte(value) => Some(i64::from(*value)),
        Value::Word(value) => Some(i64::from(*value)),
        Value::DoubleWord(value) => Some(i64::from(*value)),
        _ => None,
    }
}

/// The low `width` bits of a constant that fits them.
fn bit_pattern(value: &Value, width: u32) -> Result<u32, Misfit> {
    // Signed notations fit as signed or unsigned numbers of that width.
    let signed = |number: i64| {
        let range = -(1i64 << (width - 1))..(1i64 << width);
        if range.contains(&number) { Ok((number & ((1i64 << width) - 1)) as u32) } else { Err(Misfit::Range) }
    };
    let whole = |own: u32, bits: u32| if own <= width { Ok(bits) } else { Err(Misfit::Type) };
    match value {
        Value::Bool(_) | Value::DateAndTime(_) | Value::DataPointer { .. } | Value::Any(_) | Value::Image(_) => Err(Misfit::Type),
        Value::Real(_) => Err(Misfit::Type),
        Value::Int(number) => signed(i64::from(*number)),
        Value::DoubleInt(number) => signed(i64::from(*number)),
        Value::Byte(bits) => Ok(u32::from(*bits)),
        Value::Word(bits) => signed(i64::from(*bits)),
        Value::DoubleWord(bits) => signed(i64::from(*bits)),
        Value::Characters(text) => {
            if text.is_empty() || text.len() as u32 * 8 > width {
                return Err(Misfit::Range);
            }
            Ok(text.iter().fold(0, |bits, &byte| bits << 8 | u32::from(byte)))
        }
        Value::S5Time(bits) | Value::Counter(bits) | Value::Date(bits) => whole(16, u32::from(*bits)),
        Value::Time(milliseconds) => whole(32, *milliseconds as u32),
        Value::TimeOfDay(bits) | Value::Pointer(bits) => whole(32, *bits),
    }
}

/// Writes a value that [`coerce`] gave at a position in bits; what lies outside the image is left out.
pub(crate) fn write(image: &mut [u8], position: u64, data_type: &DataType, value: &Value) {
    let Ok(byte) = usize::try_from(position / 8) else { return };
    let mut put = |offset: usize, bytes: &[u8]| {
        if let Some(place) = image.get_mut(byte + offset..byte + offset + bytes.len()) {
            place.copy_from_slice(bytes);
        }
    };
    match value {
        Value::Bool(bit) => {
            if let Some(place) = image.get_mut(byte) {
                let mask = 1 << (position % 8);
                *place = if *bit { *place | mask } else { *place & !mask };
            }
        }
        Value::Byte(bits) => put(0, &[*bits]),
        Value::Int(number) => put(0, &number.to_be_bytes()),
        Value::Word(bits) | Value::S5Time(bits) | Value::Counter(bits) | Value::Date(bits) => put(0, &bits.to_be_bytes()),
        Value::DoubleInt(number) | Value::Time(number) => put(0, &number.to_be_bytes()),
        Value::DoubleWord(bits) | Value::TimeOfDay(bits) | Value::Pointer(bits) => put(0, &bits.to_be_bytes()),
        Value::Real(real) => put(0, &real.to_bits().to_be_bytes()),
        Value::DateAndTime(bytes) => put(0, bytes),
        Value::DataPointer { db, pointer } => {
            put(0, &db.to_be_bytes());
            put(2, &pointer.to_be_bytes());
        }
        Value::Any(bytes) => put(0, bytes),
        Value::Image(bytes) => put(0, bytes),
        Value::Characters(text) => {
            let maximum = match data_type {
                DataType::String(length) => *length,
                _ => return,
            };
            let text = &text[..text.len().min(usize::from(maximum))];
            put(0, &[maximum, text.len() as u8]);
            put(2, text);
            // What the initial value had behind the new one is gone.
            put(2 + text.len(), &vec![0; usize::from(maximum) - text.len()]);
        }
    }
}

/// Writes what a variable of this type holds at the start: its initial values, else those of its type.
pub(crate) fn write_initial(image: &mut [u8], position: u64, data_type: &DataType, initial: &[Value]) {
    match data_type {
        _ if matches!(initial, [Value::Image(_)]) => initial.iter().for_each(|value| write(image, position, data_type, value)),
        // Types without a byte may stand in one another so often that nobody can visit them all.
        DataType::Struct(structure) | DataType::Instance { structure, .. } if structure.size > 0 => {
            for field in &structure.fields {
                write_initial(image, position + u64::from(field.offset), &field.data_type, &field.initial);
            }
        }
        DataType::Array { element, .. } => {
            let count = data_type.elements();
            for (index, value) in initial.iter().enumerate().take(count as usize) {
                write(image, position + data_type.element_offset(index as u64), element, value);
            }
            let first = initial.len() as u64;
            if !starts_with_zeros(element) && first < count {
                write_initial(image, position + data_type.element_offset(first), element, &[]);
                // All further elements are copies of this one: an array of structures is laid out once.
                let start = ((position + data_type.element_offset(first)) / 8) as usize;
                let length = (element.bits() / 8) as usize;
                for index in first + 1..count {
                    let to = ((position + data_type.element_offset(index)) / 8) as usize;
                    if start + length > image.len() || to + length > image.len() {
                        break;
                    }
                    image.copy_within(start..start + length, to);
                }
            }
        }
        _ => match initial.first() {
            Some(value) => write(image, position, data_type, value),
            None => write_default(image, position, data_type),
        },
    }
}

fn starts_with_zeros(data_type: &DataType) -> bool {
    !matches!(
        data_type,
        DataType::Char
            | DataType::String(_)
            | DataType::DateAndTime
            | DataType::Any
            | DataType::Struct(_)
            | DataType::Instance { .. }
            | DataType::Array { .. }
            | DataType::WideString(_)
            | DataType::Enumeration(_)
            | DataType::Subrange(_)
    )
}

fn write_default(image: &mut [u8], position: u64, data_type: &DataType) {
    match data_type {
        DataType::Char => write(image, position, data_type, &Value::Byte(b' ')),
        DataType::String(_) => write(image, position, data_type, &Value::Characters(Vec::new())),
        // 1990-01-01, a Monday: day 2 of the week.
        DataType::DateAndTime => write(image, position, data_type, &Value::DateAndTime([0x90, 1, 1, 0, 0, 0, 0, 2])),
        // `P#P 0.0 VOID 0`: only the identification of S7 is set.
        DataType::Any => write(image, position, data_type, &Value::Any([0x10, 0, 0, 0, 0, 0, 0, 0, 0, 0])),
        DataType::WideString(length) => {
            let [high, low] = length.to_be_bytes();
            write(image, position, data_type, &Value::Image(vec![high, low, 0, 0]));
        }
        DataType::Enumeration(enumeration) => write_number(image, position, data_type, enumeration.initial as u64),
        DataType::Subrange(subrange) => write_number(image, position, data_type, subrange.initial as u64),
        _ => {}
    }
}

/// Writes the low bits of a number, as many as the type has.
fn write_number(image: &mut [u8], position: u64, data_type: &DataType, bits: u64) {
    let bytes = bits.to_be_bytes();
    let length = (data_type.bits() / 8).min(8) as usize;
    write(image, position, data_type, &Value::Image(bytes[8 - length..].to_vec()));
}

/// What is to be said of a time in milliseconds of which an S5TIME keeps much less.
pub(crate) fn shortened_s5time(written: &str, milliseconds: u64) -> Option<String> {
    Some(match s5time_shortened(milliseconds)? {
        0 => format!("`{written}` is no time at all as an S5TIME, which counts in steps of 10 ms"),
        kept => format!("`{written}` is only {kept} ms as an S5TIME, which counts in steps of 10 ms"),
    })
}
