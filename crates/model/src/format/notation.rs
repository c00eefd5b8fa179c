//! Values in the notation of each format.

use super::{Figure, Format, Formatted};
use crate::bcd;
use crate::literal::{self, Value};
use crate::types::DataType;
use crate::value::{Content, Kind};

/// Sizes of a REAL that is written with all its digits before the point; others have an exponent.
const PLAIN: std::ops::Range<f64> = 0.001..1_000_000.0;
/// Milliseconds of a day.
const DAY_MS: u64 = 86_400_000;
/// Bits from which on binary digits have their numbers below them.
const NUMBERED_FROM: u32 = 32;

/// A REAL as people write it: `1.5`; what is very large or small with an exponent.
pub fn spell_real(value: f32) -> String {
    if is_plain(value.into()) { format!("{value:?}") } else { literal::format_as(&DataType::Real, value.to_bits().into()) }
}

/// An LREAL as people write it.
pub fn spell_long_real(value: f64) -> String {
    if is_plain(value) { format!("{value:?}") } else { literal::format_as(&DataType::LongReal, value.to_bits()) }
}

fn is_plain(value: f64) -> bool {
    value == 0.0 || PLAIN.contains(&value.abs())
}

impl Formatted {
    fn plain(text: impl Into<String>) -> Self {
        Self { text: text.into(), figure: None, details: Vec::new() }
    }

    fn whole(text: impl Into<String>, number: i64) -> Self {
        Self { figure: Some(Figure::Whole(number)), ..Self::plain(text) }
    }

    /// Bits that mean nothing in the format.
    fn marked(hex: &str, format: Format) -> Self {
        Self::plain(format!("{hex} (no {format})"))
    }
}

/// A value in a format.
pub(super) fn show(format: Format, of: &Kind, content: &Content) -> Formatted {
    let raw = Raw::of(of, content);
    let (bits, width) = (raw.bits, raw.width);
    let marked = || Formatted::marked(&raw.hex(), format);
    let typed = |data_type: &DataType| Formatted::plain(literal::format_as(data_type, bits));
    match format {
        Format::Bool => Formatted::plain(if bits & 1 == 1 { "TRUE" } else { "FALSE" }),
        Format::Bin => raw.binary(),
        Format::Hex => Formatted::plain(raw.hex()),
        Format::Dec | Format::Lint => {
            let number = raw.signed();
            Formatted::whole(number.to_string(), number)
        }
        Format::Int => Formatted::whole((bits as u16 as i16).to_string(), i64::from(bits as u16 as i16)),
        Format::Dint => Formatted::whole(format!("L#{}", bits as u32 as i32), i64::from(bits as u32 as i32)),
        Format::Real => {
            let value = f32::from_bits(bits as u32);
            Formatted { figure: Some(Figure::Real(value)), ..Formatted::plain(spell_real(value)) }
        }
        Format::Lreal => {
            let value = f64::from_bits(bits);
            Formatted { figure: Some(Figure::LongReal(value)), ..Formatted::plain(spell_long_real(value)) }
        }
        Format::Char => match (of, content) {
            (Kind::Typed(DataType::String(_) | DataType::WideString(_)), _) => Formatted::plain(of.show(content).to_string()),
            _ => Formatted::plain(Value::Characters(raw.bytes()).spell()),
        },
        Format::Bcd => decimal_digits(bits, width).map_or_else(marked, |number| Formatted::whole(number.to_string(), number)),
        Format::S5Time => match literal::s5time_milliseconds(bits as u16) {
            Some(_) => {
                let figure = Figure::OfBase {
                    count: bcd::decode(bits as u32, 3) as u16,
                    base_ms: [10, 100, 1_000, 10_000][(bits >> 12 & 3) as usize],
                };
                Formatted { figure: Some(figure), ..typed(&DataType::S5Time) }
            }
            None => marked(),
        },
        Format::Date => match Value::Date(bits as u16).spell() {
            text if text.starts_with("D#") => Formatted::plain(text),
            _ => marked(),
        },
        Format::Tod if bits >= DAY_MS => marked(),
        Format::Ltod if bits >= DAY_MS * 1_000_000 => marked(),
        Format::Dt => match Value::DateAndTime(bits.to_be_bytes()).spell() {
            text if text.starts_with("DT#") => Formatted::plain(text),
            _ => marked(),
        },
        Format::Tod | Format::Ltod | Format::Time | Format::Ltime | Format::Ldate | Format::Ldt => {
            format.data_type(width).map_or_else(marked, |data_type| typed(&data_type))
        }
        Format::Counter if *of == Kind::Number => Formatted::whole(format!("C#{bits}"), i64::try_from(bits).unwrap_or(i64::MAX)),
        Format::Counter => match Value::Counter(bits as u16).spell() {
            text if text.starts_with("C#") => Formatted::whole(text, i64::from(bcd::decode(bits as u32, 3))),
            _ => marked(),
        },
        Format::Pointer if width == 48 => match raw.bytes()[..] {
            [db_1, db_2, a, b, c, d] => {
                pointer(Some(u16::from_be_bytes([db_1, db_2])), u32::from_be_bytes([a, b, c, d])).unwrap_or_else(marked)
            }
            _ => marked(),
        },
        Format::Pointer => pointer(None, bits as u32).unwrap_or_else(marked),
        Format::Any => <[u8; 10]>::try_from(raw.bytes()).ok().and_then(any).unwrap_or_else(marked),
    }
}

/// A value as what it is made of.
struct Raw {
    /// The last 64 bits.
    bits: u64,
    /// How many there are.
    width: u32,
    /// All of it, if it is bytes.
    bytes: Option<Vec<u8>>,
    is_number: bool,
}

impl Raw {
    fn of(of: &Kind, content: &Content) -> Self {
        let is_number = *of == Kind::Number || matches!(of, Kind::Typed(data_type) if crate::value::names_a_number(data_type));
        match content {
            Content::Bits(bits) => {
                let width = match of {
                    _ if is_number => 16,
                    Kind::Status => 16,
                    // Bytes of a length that a number has.
                    Kind::Bytes(length) => length.saturating_mul(8).min(64),
                    of => of.width(),
                };
                Self { bits: *bits, width, bytes: None, is_number }
            }
            Content::Bytes(bytes) => Self {
                bits: bytes.iter().fold(0, |bits, &byte| bits << 8 | u64::from(byte)),
                width: u32::try_from(bytes.len()).unwrap_or(u32::MAX).saturating_mul(8),
                bytes: Some(bytes.to_vec()),
                is_number,
            },
        }
    }

    /// All bytes, in the order of the S7.
    fn bytes(&self) -> Vec<u8> {
        let own = || self.bits.to_be_bytes()[8 - (self.width.div_ceil(8) as usize).min(8)..].to_vec();
        self.bytes.clone().unwrap_or_else(own)
    }

    fn hex(&self) -> String {
        let bits = self.bits;
        match self.width {
            0..=1 if self.bytes.is_none() => format!("16#{bits:X}"),
            8 => format!("B#16#{bits:02X}"),
            16 => format!("W#16#{bits:04X}"),
            32 => format!("DW#16#{bits:08X}"),
            64 => literal::format_as(&DataType::LongWord, bits),
            _ => format!("16#{}", self.bytes().iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ")),
        }
    }

    /// Bytes and plain numbers without a sign, all else with the sign that `+I` and `+D` see.
    fn signed(&self) -> i64 {
        match self.width {
            _ if self.is_number => i64::try_from(self.bits).unwrap_or(i64::MAX),
            16 => i64::from(self.bits as u16 as i16),
            32 => i64::from(self.bits as u32 as i32),
            _ => self.bits as i64,
        }
    }

    /// Binary digits in groups of four. Below those of a double word stand the numbers of the first bit of each group; longer values are
    /// listed byte by byte.
    fn binary(&self) -> Formatted {
        if self.width <= 1 {
            return Formatted::plain(format!("2#{}", self.bits & 1));
        }
        let groups = |byte: &u8| format!("{:04b}_{:04b}", byte >> 4, byte & 0xF);
        let bytes = self.bytes();
        let text = format!("2#{}", bytes.iter().map(groups).collect::<Vec<_>>().join("_"));
        let details = match self.width {
            NUMBERED_FROM | 64 => {
                let numbers: String = (1..=self.width / 4).map(|group| format!("{:<5}", self.width - 4 * group + 3)).collect();
                vec![format!("  {}", numbers.trim_end())]
            }
            48 | 80 => bytes.iter().enumerate().map(|(at, byte)| format!("byte {at}: {}  16#{byte:02X}", groups(byte))).collect(),
            _ => Vec::new(),
        };
        Formatted { details, ..Formatted::plain(text) }
    }
}

/// Decimal digits of four bits each. 15 in the place of the first digit of a word or double word is the minus that `ITB` and `DTB` write.
fn decimal_digits(bits: u64, width: u32) -> Option<i64> {
    let (bits, digits) = (bits as u32, (width / 4).min(8));
    let minus = digits > 2 && bits >> (4 * digits - 4) == 0xF;
    let digits = if minus { digits - 1 } else { digits };
    let number = bcd::is_decimal(bits, digits).then(|| i64::from(bcd::decode(bits, digits)))?;
    Some(if minus { -number } else { number })
}

/// A pointer, with the data block if it has one; `None` if it is none.
fn pointer(db: Option<u16>, pointer: u32) -> Option<Formatted> {
    let fields = fields_of(pointer)?;
    let text = Value::DataPointer { db: db.unwrap_or(0), pointer }.spell();
    let details = match db {
        None => vec![
            format!("bits 31 to 24: {}", fields.area),
            format!("bits 18 to 3: byte {}", fields.byte),
            format!("bits 2 to 0: bit {}", fields.bit),
        ],
        Some(db) => vec![
            format!("bytes 0 and 1: {}", data_block(db)),
            format!("byte 2: {}", fields.area),
            format!("bytes 3 to 5: byte {}, bit {}", fields.byte, fields.bit),
        ],
    };
    Some(Formatted { details, ..Formatted::plain(text) })
}

/// An ANY; `None` if it is none.
fn any(bytes: [u8; 10]) -> Option<Formatted> {
    let [syntax, code, c_1, c_2, db_1, db_2, a, b, c, d] = bytes;
    let word = literal::any_type_word(code).filter(|_| syntax == 0x10)?;
    let target = u32::from_be_bytes([a, b, c, d]);
    let place = match word {
        "TIMER" | "COUNTER" => format!("bytes 6 to 9: number {}", target & 0xFFFF),
        _ => {
            let fields = fields_of(target)?;
            format!("byte 6: {}; bytes 7 to 9: byte {}, bit {}", fields.area, fields.byte, fields.bit)
        }
    };
    let details = vec![
        format!("byte 0: 16#{syntax:02X}, an S7 pointer"),
        format!("byte 1: type {word} (16#{code:02X})"),
        format!("bytes 2 and 3: count {}", u16::from_be_bytes([c_1, c_2])),
        format!("bytes 4 and 5: {}", data_block(u16::from_be_bytes([db_1, db_2]))),
        place,
    ];
    Some(Formatted { details, ..Formatted::plain(Value::Any(bytes).spell()) })
}

fn data_block(db: u16) -> String {
    if db == 0 { "no data block".to_owned() } else { format!("DB {db}") }
}

/// What a pointer is made of.
struct Fields {
    area: String,
    byte: u32,
    bit: u32,
}

fn fields_of(pointer: u32) -> Option<Fields> {
    let code = (pointer >> 24) as u8;
    let area = match code {
        0 => "no area".to_owned(),
        code => format!("area {} (16#{code:02X})", literal::pointer_area(code)?),
    };
    (pointer & 0x00F8_0000 == 0).then_some(Fields { area, byte: pointer >> 3 & 0xFFFF, bit: pointer & 7 })
}
