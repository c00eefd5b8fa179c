//! Reads the values that users write for an item, in every notation of the languages.

use std::fmt;

use super::{Item, Place};
use crate::address::Operand;
use crate::bcd;
use crate::format::Format;
use crate::literal::{self, LiteralError, Value as Constant};
use crate::registers::StatusWord;
use crate::types::DataType;
use crate::value::{Content, Kind, Value};

/// Why what a user wrote is no value of an item; [`Self::of`] says it of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueError {
    text: String,
    kind: Trouble,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Trouble {
    /// No constant.
    Literal(LiteralError),
    /// More bits than the item has.
    TooLarge(u32),
    /// Not the nine characters of a status word.
    NoStatusWord,
    /// Neither 0 nor 1.
    NoBit,
    /// A constant of more than 64 bits.
    TooLong,
    /// More characters than the STRING holds.
    TooManyCharacters(u32),
    /// No characters.
    NoCharacters,
    /// `NaN` where no REAL is.
    NoReal,
    /// Not so many bytes.
    NoBytes(u32),
    /// A type that is not written from outside.
    ReadOnly,
}

impl ValueError {
    /// What is wrong, in one sentence about an item with this name.
    pub fn of(&self, name: &str) -> String {
        let text = &self.text;
        match &self.kind {
            Trouble::Literal(error) => error.to_string(),
            Trouble::TooLarge(width) => format!("`{text}` does not fit into `{name}`, which has {width} bits"),
            Trouble::NoStatusWord => format!("`{text}` is no status word, which has nine characters 0 or 1"),
            Trouble::NoBit => format!("`{text}` is no value of the bit `{name}`; write 0 or 1"),
            Trouble::TooLong => format!("`{text}` is no value of at most 64 bits"),
            Trouble::TooManyCharacters(most) => format!("`{text}` does not fit into `{name}`, which holds {most} characters"),
            Trouble::NoCharacters => format!("`{text}` is no value of the STRING `{name}`; write characters in single quotes"),
            Trouble::NoReal => format!("`NaN` is a value of 32 bits, which `{name}` is not"),
            Trouble::NoBytes(length) => format!("`{text}` is no value of `{name}`; write its {length} bytes as hex digits: `16#01 FF`"),
            Trouble::ReadOnly => format!("`{name}` can only be read"),
        }
    }
}

impl fmt::Display for ValueError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.of("it"))
    }
}

impl std::error::Error for ValueError {}

impl Item {
    /// Reads a value for it.
    ///
    /// # Errors
    /// The text is no constant, or does not fit.
    pub fn value(&self, text: &str) -> Result<Value, ValueError> {
        let text = text.trim();
        let content = match self.kind.plain() {
            Kind::Typed(DataType::String(length_max)) => Content::Bytes(characters(text, *length_max)?),
            Kind::Bytes(length) => Content::Bytes(bytes(text, *length)?),
            Kind::Typed(data_type) if data_type.stands_in_bytes() => return Err(trouble(text, Trouble::ReadOnly)),
            _ => Content::Bits(self.bits(text)?),
        };
        Ok(Value { kind: self.kind.clone(), content })
    }

    /// Reads a value that is expected of it: `NaN` stands for every REAL that is no number.
    ///
    /// # Errors
    /// As of [`Self::value`].
    pub fn expected(&self, text: &str) -> Result<Value, ValueError> {
        match (text.trim().eq_ignore_ascii_case("NaN"), &*self.kind.meaning()) {
            (true, Kind::Typed(DataType::LongReal)) | (false, _) => self.value(text),
            (true, _) if self.width() == 32 => Ok(Value::bits(self.kind.clone(), u64::from(f32::NAN.to_bits()))),
            (true, _) => Err(trouble(text, Trouble::NoReal)),
        }
    }

    fn data_type(&self) -> Option<DataType> {
        match self.kind.meaning().into_owned() {
            Kind::Typed(data_type) => Some(data_type),
            _ => None,
        }
    }

    fn bits(&self, text: &str) -> Result<u64, ValueError> {
        let width = self.width();
        if *self.kind.plain() == Kind::Status {
            if let Some(word) = StatusWord::parse(text) {
                return Ok(u64::from(word.0));
            }
            // `STW=111` would be a number to some and three bits to others.
            if text.bytes().all(|byte| byte.is_ascii_digit()) {
                return Err(trouble(text, Trouble::NoStatusWord));
            }
        }
        if width == 1 {
            return match text.to_ascii_uppercase().as_str() {
                "0" | "FALSE" | "2#0" => Ok(0),
                "1" | "TRUE" | "2#1" => Ok(1),
                _ => Err(trouble(text, Trouble::NoBit)),
            };
        }
        // `DB1.speed=5` means the number where the field is a REAL.
        // Digits that are too large for it are no infinity, which is written `+INF`.
        if let (Some(DataType::Real), Ok(number)) = (self.data_type(), text.parse::<f32>())
            && (number.is_finite() || !text.contains(|character: char| character.is_ascii_digit()))
        {
            return Ok(u64::from(number.to_bits()));
        }
        if let Some(data_type) = self.data_type()
            && let Some(bits) = literal::elsewhere::parse_as(&data_type, text)
        {
            return Ok(bits);
        }
        if let (Kind::Formatted(Format::Bcd, _), Ok(number)) = (&self.kind, text.parse::<i64>()) {
            return decimal_digits(number, width).ok_or_else(|| trouble(text, Trouble::TooLarge(width)));
        }
        if let Ok(number) = text.parse::<i64>() {
            return self.integer(text, number);
        }
        match text.to_ascii_uppercase().as_str() {
            "+INF" | "INF" if width == 32 => return Ok(u64::from(f32::INFINITY.to_bits())),
            "-INF" if width == 32 => return Ok(u64::from(f32::NEG_INFINITY.to_bits())),
            _ => {}
        }
        let value = literal::parse(text).map_err(|error| trouble(text, Trouble::Literal(error)))?;
        if let (Place::Operand(Operand::Counter(_)), Constant::Counter(count)) = (&self.place, &value) {
            return Ok(u64::from(bcd::decode(u32::from(*count), 3)));
        }
        let bits = value.bits().ok_or_else(|| trouble(text, Trouble::TooLong))?;
        match width {
            1..=63 if bits >> width != 0 => Err(trouble(text, Trouble::TooLarge(width))),
            _ => Ok(bits),
        }
    }

    /// A plain decimal number in this place; negative numbers as two's complement.
    fn integer(&self, text: &str, number: i64) -> Result<u64, ValueError> {
        let width = self.width();
        let is_register = matches!(self.place, Place::Register(_) | Place::Status);
        // A register takes what `L` would bring into it: 16 bits without the sign, as long as the number has no more.
        let taken = if is_register && i16::try_from(number).is_ok() { 16 } else { width };
        let (min, max) = match taken {
            1..=62 => (-(1_i64 << (taken - 1)), (1_i64 << taken) - 1),
            _ => (i64::MIN, i64::MAX),
        };
        if !(min..=max).contains(&number) {
            return Err(trouble(text, Trouble::TooLarge(width)));
        }
        Ok((number as u64) & if taken >= 64 { u64::MAX } else { (1 << taken) - 1 })
    }
}

/// A number as decimal digits of four bits each, with 15 before them for a minus; `None` if there are too many.
fn decimal_digits(number: i64, width: u32) -> Option<u64> {
    let digits = width / 4 - u32::from(number < 0);
    let size = u32::try_from(number.unsigned_abs()).ok().filter(|&size| u64::from(size) < 10_u64.pow(digits))?;
    let minus = if number < 0 { 0xF_u64 << (width - 4) } else { 0 };
    (number >= 0 || width > 8).then_some(minus | u64::from(bcd::encode(size)))
}

fn trouble(text: &str, kind: Trouble) -> ValueError {
    ValueError { text: text.to_owned(), kind }
}

/// The bytes of a STRING with these characters: maximum length, length, characters.
fn characters(text: &str, length_max: u8) -> Result<Box<[u8]>, ValueError> {
    let value = match text {
        "''" => Constant::Characters(Vec::new()),
        text => literal::parse(text).map_err(|error| trouble(text, Trouble::Literal(error)))?,
    };
    let Constant::Characters(characters) = value else { return Err(trouble(text, Trouble::NoCharacters)) };
    match u8::try_from(characters.len()) {
        Ok(length) if length <= length_max => Ok([length_max, length].into_iter().chain(characters).collect()),
        _ => Err(trouble(text, Trouble::TooManyCharacters(length_max.into()))),
    }
}

/// So many bytes, two hex digits each; `16#` before them, spaces and underscores between them are free.
fn bytes(text: &str, length: u32) -> Result<Box<[u8]>, ValueError> {
    let wanted = || trouble(text, Trouble::NoBytes(length));
    let digits: Option<Vec<u8>> = text
        .trim_start_matches("16#")
        .chars()
        .filter(|c| !matches!(c, ' ' | '_'))
        .map(|c| c.to_digit(16).and_then(|digit| u8::try_from(digit).ok()))
        .collect();
    let digits = digits.ok_or_else(wanted)?;
    let bytes: Vec<u8> = digits.chunks_exact(2).map(|pair| pair[0] << 4 | pair[1]).collect();
    if digits.len() % 2 == 0 && bytes.len() as u64 == u64::from(length) { Ok(bytes.into()) } else { Err(wanted()) }
}
