//! Constants: their values and how they are written.

mod calendar;
pub mod elsewhere;

use std::fmt;

pub(crate) use calendar::calendar_date;
use calendar::{DATE_MAX, DAY_MS, TOD_RANGE, date_and_time_parts, parse_date, parse_date_and_time, parse_time_of_day, spell_time_of_day};
pub use calendar::{date_and_time_bytes, days_to_date};

use crate::bcd;
use crate::problems::Problem;
use crate::types::DataType;

/// The value of a constant, by the type its notation gives it.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The variants are the manual's own names.
pub enum Value {
    Bool(bool),
    /// A signed 16-bit integer without prefix.
    Int(i16),
    /// `L#`.
    DoubleInt(i32),
    Real(f32),
    /// `B#16#`.
    Byte(u8),
    /// `W#16#`, `2#` up to 16 digits, `B#(a,b)`.
    Word(u16),
    /// `DW#16#`, `2#` of more digits, `B#(a,b,c,d)`.
    DoubleWord(u32),
    /// Characters between apostrophes, one byte each: one to four where a number is wanted, up to 254 for a STRING.
    Characters(Vec<u8>),
    /// `S5T#` as its word.
    S5Time(u16),
    /// `C#` as its BCD word.
    Counter(u16),
    /// `T#` in milliseconds.
    Time(i32),
    /// `D#` in days since 1990-01-01.
    Date(u16),
    /// `TOD#` in milliseconds since midnight.
    TimeOfDay(u32),
    /// `DT#` as its eight bytes.
    DateAndTime([u8; 8]),
    /// `P#...` area-internal (bit 31 = 0) or area-crossing.
    Pointer(u32),
    /// `P#DB10.DBX 12.0` as a POINTER with a DB number, and `P#... REAL 20` as an ANY.
    DataPointer {
        db: u16,
        pointer: u32,
    },
    Any([u8; 10]),
    /// What a variable of the types of Structured Text, or a whole array or structure, holds: its bytes.
    Image(Vec<u8>),
}

impl Value {
    /// What ACCU 1 holds after `L` with this constant; `None` if it does not fit an accumulator or is not loaded.
    pub fn accumulator(&self) -> Option<u32> {
        Some(match self {
            Self::Int(value) => u32::from(*value as u16),
            Self::DoubleInt(value) | Self::Time(value) => *value as u32,
            Self::Real(value) => value.to_bits(),
            Self::Byte(value) => u32::from(*value),
            Self::Word(value) | Self::S5Time(value) | Self::Counter(value) | Self::Date(value) => u32::from(*value),
            Self::DoubleWord(value) | Self::TimeOfDay(value) | Self::Pointer(value) => *value,
            Self::Characters(text) if text.len() <= 4 => text.iter().fold(0, |word, &byte| word << 8 | u32::from(byte)),
            Self::Bool(_) | Self::Characters(_) | Self::DateAndTime(_) | Self::DataPointer { .. } | Self::Any(_) | Self::Image(_) => {
                return None;
            }
        })
    }
}

/// Why a text is not a constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LiteralError {
    /// The constant as the user wrote it.
    pub text: String,
    /// What is wrong with it.
    pub kind: LiteralErrorKind,
    /// Byte in the text given to [`parse`] where the trouble begins.
    pub offset: usize,
}

/// The ways in which a constant can be wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LiteralErrorKind {
    /// Well written, but too small or too large; holds the valid range in words.
    OutOfRange(&'static str),
    /// The prefix is known, what follows is not what it wants; holds what would be valid.
    Malformed(&'static str),
    /// A date that no calendar has.
    NoSuchDate,
    /// A character that no code page of STEP 7 can hold in one byte.
    Character(char),
    /// Not the beginning of any constant.
    Unknown,
}

impl LiteralError {
    /// The problem of the table that belongs to it.
    pub fn problem(&self) -> Problem {
        match self.kind {
            LiteralErrorKind::OutOfRange(_) => Problem::P4201,
            LiteralErrorKind::Malformed(_) => Problem::P4202,
            LiteralErrorKind::NoSuchDate => Problem::P4203,
            LiteralErrorKind::Character(_) => Problem::P4204,
            LiteralErrorKind::Unknown => Problem::P4205,
        }
    }
}

impl fmt::Display for LiteralError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text: String = self.text.chars().take(SHOWN).collect();
        match &self.kind {
            LiteralErrorKind::OutOfRange(range) => write!(f, "`{text}` is outside {range}"),
            LiteralErrorKind::Malformed(valid) => write!(f, "`{text}` is not understood: {valid}"),
            LiteralErrorKind::NoSuchDate => write!(f, "`{text}` names a day that the calendar does not have"),
            LiteralErrorKind::Character(character) => write!(
                f,
                "`{character}` in `{text}` does not fit into one byte of the code pages 1252, 1250 or 1251; `$hh` writes a byte by its two hex digits"
            ),
            LiteralErrorKind::Unknown => write!(
                f,
                "`{text}` is not a constant; constants look like 5, L#5, 1.5, W#16#00FF, 2#1010, C#20, S5T#2S, T#1H, D#2024-02-29, TOD#12:00:00, P#M 10.0, 'A', TRUE"
            ),
        }
    }
}

impl std::error::Error for LiteralError {}

/// Longest part of a wrong constant that a message repeats, in characters.
const SHOWN: usize = 60;
/// Longest text of a STRING.
const STRING_MAX: usize = 254;
/// Largest S5TIME: 999 × 10 s.
const S5TIME_MAX_MS: u64 = 9_990_000;

const INT_RANGE: &str = "-32768 to 32767 (a 32-bit integer is written with L#)";
const DINT_RANGE: &str = "L#-2147483648 to L#2147483647";
const REAL_RANGE: &str = "-3.402823E+38 to -1.175495E-38, 0.0, and 1.175495E-38 to 3.402823E+38";
const COUNTER_RANGE: &str = "C#0 to C#999";
const S5TIME_RANGE: &str = "S5T#0MS to S5T#2H46M30S";
const TIME_RANGE: &str = "T#-24D20H31M23S648MS to T#24D20H31M23S647MS";
const POINTER_RANGE: &str = "P#0.0 to P#65535.7";

type Parsed = Result<Value, LiteralErrorKind>;

/// Reads a constant in any notation of STL; letters in either case, blanks around it and underscores between digits are free.
pub fn parse(text: &str) -> Result<Value, LiteralError> {
    let trimmed = text.trim();
    let lead = text.len() - text.trim_start().len();
    let (prefix, value) = match trimmed.starts_with('\'') {
        true => (0, parse_characters(trimmed)),
        false => parse_plain(trimmed),
    };
    value.map_err(|kind| LiteralError { text: trimmed.to_owned(), kind, offset: lead + prefix })
}

/// Reads a constant in the notations that only extended programs have: `0x` behind `16#`, and underscores anywhere in a time.
pub fn parse_extended(text: &str) -> Option<Value> {
    let upper = text.trim().to_ascii_uppercase();
    let (prefix, rest) = upper.split_once('#')?;
    match prefix.trim_end() {
        "S5T" | "S5TIME" | "T" | "TIME" => parse(&format!("{prefix}#{}", rest.replace('_', ""))).ok(),
        "B" | "W" | "DW" => {
            let digits = rest.trim_start().strip_prefix("16#")?.trim_start().strip_prefix("0X")?;
            parse(&format!("{prefix}#16#{digits}")).ok()
        }
        "16" => parse(&format!("16#{}", rest.trim_start().strip_prefix("0X")?)).ok(),
        _ => None,
    }
}

/// The length of the understood prefix, and the value.
fn parse_plain(text: &str) -> (usize, Parsed) {
    use LiteralErrorKind::{Malformed, Unknown};
    // Every prefix is ASCII, so that upper-casing keeps the offsets.
    let upper = text.to_ascii_uppercase();
    let Some(hash) = upper.find('#') else {
        return (0, parse_without_prefix(&upper));
    };
    let prefix = upper[..hash].trim_end();
    let behind = &upper[hash + 1..];
    let rest = behind.trim_start();
    let value = match prefix {
        "L" => parse_long(rest),
        "2" => parse_binary(rest),
        "16" => parse_hex(rest, 32, "at most 16#FFFF_FFFF").map(|(value, digits)| match digits {
            0..=2 => Value::Byte(value as u8),
            3..=4 => Value::Word(value as u16),
            _ => Value::DoubleWord(value),
        }),
        "B" if rest.starts_with('(') => parse_byte_list(rest),
        "B" => sixteen(rest, "write `B#16#FF`, `B#(1,2)` or `B#(1,2,3,4)`")
            .and_then(|digits| parse_hex(digits, 8, "B#16#00 to B#16#FF"))
            .map(|(value, _)| Value::Byte(value as u8)),
        "W" => sixteen(rest, "write `W#16#` and up to four hex digits")
            .and_then(|digits| parse_hex(digits, 16, "W#16#0000 to W#16#FFFF"))
            .map(|(value, _)| Value::Word(value as u16)),
        "DW" => sixteen(rest, "write `DW#16#` and up to eight hex digits")
            .and_then(|digits| parse_hex(digits, 32, "DW#16#0000_0000 to DW#16#FFFF_FFFF"))
            .map(|(value, _)| Value::DoubleWord(value)),
        "C" => parse_counter(rest),
        "S5T" | "S5TIME" => parse_s5time(rest),
        "T" | "TIME" => parse_time(rest),
        "D" | "DATE" => parse_date(&without_blanks(rest)).map(Value::Date),
        "TOD" | "TIME_OF_DAY" => parse_time_of_day(&without_blanks(rest), TOD_RANGE).map(Value::TimeOfDay),
        "DT" | "DATE_AND_TIME" => parse_date_and_time(&without_blanks(rest)),
        "P" if rest.starts_with('#') => Err(Malformed("`P##` wants the name of a local variable, which only a statement can resolve")),
        "P" => parse_pointer(rest),
        _ => return (0, Err(Unknown)),
    };
    (hash + 1 + (behind.len() - rest.len()), value)
}

/// A number or TRUE and FALSE.
fn parse_without_prefix(text: &str) -> Parsed {
    use LiteralErrorKind::{Malformed, OutOfRange, Unknown};
    match text {
        "TRUE" => return Ok(Value::Bool(true)),
        "FALSE" => return Ok(Value::Bool(false)),
        _ => {}
    }
    let (sign, digits) = split_sign(text);
    if !digits.starts_with(|character: char| character.is_ascii_digit()) {
        return Err(Unknown);
    }
    if digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'_') {
        let number = parse_decimal(digits).ok_or(Malformed("digits may have single underscores between them, nothing else"))?;
        let number = i64::try_from(number).map_or(i64::MAX, |number| number * sign);
        return i16::try_from(number).map(Value::Int).map_err(|_| OutOfRange(INT_RANGE));
    }
    if let Some(real) = clean_real(digits) {
        let magnitude: f32 = real.parse().map_err(|_| Unknown)?;
        let zero = !mantissa(&real).bytes().any(|byte| matches!(byte, b'1'..=b'9'));
        // Denormal numbers are outside the range of REAL constants.
        if !(magnitude.is_normal() || zero) {
            return Err(OutOfRange(REAL_RANGE));
        }
        return Ok(Value::Real(if sign < 0 { -magnitude } else { magnitude }));
    }
    Err(Unknown)
}

/// The sign as a factor, and what follows it.
fn split_sign(text: &str) -> (i64, &str) {
    match text.as_bytes().first() {
        Some(b'-') => (-1, text[1..].trim_start()),
        Some(b'+') => (1, text[1..].trim_start()),
        _ => (1, text),
    }
}

fn mantissa(real: &str) -> &str {
    real.split('E').next().unwrap_or_default()
}

/// `1.5E+003` without underscores, if the text has this form; a point or an exponent makes a number a REAL.
fn clean_real(text: &str) -> Option<String> {
    let (mantissa, exponent) = match text.split_once('E') {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (text, None),
    };
    let (whole, fraction) = match mantissa.split_once('.') {
        Some((whole, fraction)) => (whole, Some(fraction)),
        None => (mantissa, None),
    };
    let mut real = join_digits(whole)?;
    if let Some(fraction) = fraction {
        real.push('.');
        real.push_str(&join_digits(fraction)?);
    }
    if let Some(exponent) = exponent {
        let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        real.push('E');
        real.push_str(exponent);
    }
    Some(real)
}

/// Digits without the underscores between them; an underscore at either end or two in a row are slips.
fn join_digits(text: &str) -> Option<String> {
    join_radix(text, 10)
}

fn join_radix(text: &str, radix: u32) -> Option<String> {
    if text.is_empty() || text.starts_with('_') || text.ends_with('_') || text.contains("__") {
        return None;
    }
    text.chars().filter(|&character| character != '_').map(|character| character.is_digit(radix).then_some(character)).collect()
}

/// A decimal number; saturates, so that the range check of the caller answers.
fn parse_decimal(text: &str) -> Option<u64> {
    let digits = join_digits(text)?;
    Some(digits.bytes().fold(0_u64, |sum, byte| sum.saturating_mul(10).saturating_add(u64::from(byte - b'0'))))
}

fn parse_long(text: &str) -> Parsed {
    let (sign, digits) = split_sign(text);
    let number = parse_decimal(digits).ok_or(LiteralErrorKind::Malformed("`L#` wants a decimal number, such as L#-5"))?;
    let number = i64::try_from(number).map_or(i64::MAX, |number| number * sign);
    i32::try_from(number).map(Value::DoubleInt).map_err(|_| LiteralErrorKind::OutOfRange(DINT_RANGE))
}

fn parse_binary(text: &str) -> Parsed {
    let digits = join_radix(text, 2).ok_or(LiteralErrorKind::Malformed("`2#` wants digits 0 and 1, such as 2#1010_0101"))?;
    match digits.len() {
        0..=16 => u16::from_str_radix(&digits, 2).map(Value::Word).map_err(|_| LiteralErrorKind::Unknown),
        17..=32 => u32::from_str_radix(&digits, 2).map(Value::DoubleWord).map_err(|_| LiteralErrorKind::Unknown),
        _ => Err(LiteralErrorKind::OutOfRange("the 32 binary digits of a double word")),
    }
}

/// What follows the `16#` of `W#16#`.
fn sixteen<'a>(text: &'a str, valid: &'static str) -> Result<&'a str, LiteralErrorKind> {
    text.strip_prefix("16#").map(str::trim_start).ok_or(LiteralErrorKind::Malformed(valid))
}

/// The value and the number of its digits.
fn parse_hex(text: &str, bits: u32, range: &'static str) -> Result<(u32, usize), LiteralErrorKind> {
    let digits = join_radix(text, 16)
        .ok_or(LiteralErrorKind::Malformed("behind 16# stand the hex digits 0 to 9 and A to F, with single underscores between them"))?;
    let significant = digits.trim_start_matches('0');
    let value = match significant.len() {
        0 => 0,
        1..=8 => u32::from_str_radix(significant, 16).unwrap_or(u32::MAX),
        _ => return Err(LiteralErrorKind::OutOfRange(range)),
    };
    match u64::from(value) >> bits {
        0 => Ok((value, digits.len())),
        _ => Err(LiteralErrorKind::OutOfRange(range)),
    }
}

fn parse_byte_list(text: &str) -> Parsed {
    use LiteralErrorKind::{Malformed, OutOfRange};
    let valid = Malformed("write two or four numbers from 0 to 255: B#(1,10) or B#(1,10,5,50)");
    let inner = text.strip_prefix('(').and_then(|text| text.strip_suffix(')')).ok_or(valid.clone())?;
    let mut bytes = Vec::with_capacity(4);
    for part in inner.split(',') {
        let number = parse_decimal(part.trim()).ok_or(valid.clone())?;
        bytes.push(u8::try_from(number).map_err(|_| OutOfRange("0 to 255 for each byte of B#(…)"))?);
        if bytes.len() > 4 {
            return Err(valid);
        }
    }
    match bytes[..] {
        [a, b] => Ok(Value::Word(u16::from_be_bytes([a, b]))),
        [a, b, c, d] => Ok(Value::DoubleWord(u32::from_be_bytes([a, b, c, d]))),
        _ => Err(valid),
    }
}

fn parse_counter(text: &str) -> Parsed {
    match parse_decimal(text) {
        Some(number @ 0..=999) => Ok(Value::Counter(bcd::encode(number as u32) as u16)),
        Some(_) => Err(LiteralErrorKind::OutOfRange(COUNTER_RANGE)),
        None => Err(LiteralErrorKind::Malformed("`C#` wants a decimal number from 0 to 999")),
    }
}

/// The number whose decimal digits are these nibbles, if all of them are decimal.
fn from_bcd(word: u32) -> Option<u32> {
    bcd::is_decimal(word, 8).then(|| bcd::decode(word, 8))
}

/// The word of an S5TIME: the finest base that holds the time, the remainder cut. `None` beyond 9990 s.
pub fn s5time_word(milliseconds: u64) -> Option<u16> {
    let (base, step) = match milliseconds {
        0..=9_990 => (0, 10),
        9_991..=99_900 => (1, 100),
        99_901..=999_000 => (2, 1_000),
        999_001..=S5TIME_MAX_MS => (3, 10_000),
        _ => return None,
    };
    Some(base << 12 | bcd::encode((milliseconds / step) as u32) as u16)
}

/// The time of an S5TIME word in milliseconds, if its three digits are decimal; bits 14 and 15 do not count.
pub fn s5time_milliseconds(word: u16) -> Option<u64> {
    let step = [10, 100, 1_000, 10_000][usize::from(word >> 12 & 3)];
    from_bcd(u32::from(word & 0xFFF)).map(|number| u64::from(number) * step)
}

/// What an S5TIME keeps of a time if that is much less: 0, or so little that more than a tenth is lost. Both are milliseconds.
///
/// From 100 ms on never so much is lost: the type has three digits.
pub fn s5time_shortened(milliseconds: u64) -> Option<u64> {
    let kept = s5time_milliseconds(s5time_word(milliseconds)?)?;
    ((milliseconds - kept) * 10 > milliseconds).then_some(kept)
}

/// The milliseconds that are written in a constant such as `S5T#5MS`.
pub fn written_milliseconds(text: &str) -> Option<u64> {
    let (_, time) = text.split_once('#')?;
    parse_duration(&without_blanks(time).to_ascii_uppercase())
}

fn parse_s5time(text: &str) -> Parsed {
    let milliseconds = parse_duration(&without_blanks(text)).ok_or(LiteralErrorKind::Malformed(
        "write hours, minutes, seconds and milliseconds in this order, such as S5T#1H2M3S or S5T#500MS",
    ))?;
    s5time_word(milliseconds).map(Value::S5Time).ok_or(LiteralErrorKind::OutOfRange(S5TIME_RANGE))
}

fn parse_time(text: &str) -> Parsed {
    let (sign, digits) = split_sign(text);
    let milliseconds = parse_duration(&without_blanks(digits)).ok_or(LiteralErrorKind::Malformed(
        "write days, hours, minutes, seconds and milliseconds in this order, such as T#1D2H3M4S5MS or T#-500MS",
    ))?;
    let milliseconds = i64::try_from(milliseconds).map_or(i64::MAX, |number| number * sign);
    i32::try_from(milliseconds).map(Value::Time).map_err(|_| LiteralErrorKind::OutOfRange(TIME_RANGE))
}

fn without_blanks(text: &str) -> String {
    text.chars().filter(|character| !character.is_whitespace()).collect()
}

/// The units of a duration with their milliseconds, in the order in which they may stand.
const UNITS: [(&str, u64); 5] = [("D", 86_400_000), ("H", 3_600_000), ("M", 60_000), ("S", 1_000), ("MS", 1)];

/// `1H_2M3S4MS` in milliseconds, saturating; the last unit may have a decimal fraction, digits below a millisecond are cut.
fn parse_duration(text: &str) -> Option<u64> {
    let mut rest = text;
    let mut total = 0_u64;
    let mut next_unit = 0;
    while !rest.is_empty() {
        let digits = rest.find(|character: char| !character.is_ascii_digit() && character != '.')?;
        let (number, behind) = rest.split_at(digits);
        let letters = behind.find(|character: char| !character.is_ascii_alphabetic()).unwrap_or(behind.len());
        let (unit, behind) = behind.split_at(letters);
        let position = UNITS.iter().position(|&(name, _)| name == unit)?;
        if position < next_unit {
            return None;
        }
        next_unit = position + 1;
        let factor = UNITS[position].1;
        let (whole, fraction) = number.split_once('.').map_or((number, None), |(whole, fraction)| (whole, Some(fraction)));
        total = total.saturating_add(parse_decimal(whole)?.saturating_mul(factor));
        rest = behind.strip_prefix('_').unwrap_or(behind);
        if rest.is_empty() && behind.ends_with('_') {
            return None;
        }
        if let Some(fraction) = fraction {
            if !rest.is_empty() {
                return None;
            }
            total = total.saturating_add(parse_fraction(fraction, factor)?);
        }
    }
    (next_unit > 0).then_some(total)
}

/// Decimal digits behind a point, as a part of `unit`; digits beyond the ninth do not count.
fn parse_fraction(digits: &str, unit: u64) -> Option<u64> {
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let counted = &digits[..digits.len().min(9)];
    let number: u64 = counted.parse().ok()?;
    Some(number * unit / 10_u64.pow(counted.len() as u32))
}

/// The letters of pointer areas in both mnemonic languages, longest first, and the area code.
const POINTER_AREAS: [(&str, u8); 14] = [
    ("DBX", 0x84),
    ("DIX", 0x85),
    ("PI", 0x80),
    ("PE", 0x80),
    ("PQ", 0x80),
    ("PA", 0x80),
    ("P", 0x80),
    ("I", 0x81),
    ("E", 0x81),
    ("Q", 0x82),
    ("A", 0x82),
    ("M", 0x83),
    ("L", 0x86),
    ("V", 0x87),
];

/// The type codes of an ANY with the words that name them; the first word of a code is the one that is written.
const ANY_TYPES: [(&str, u8); 24] = [
    ("VOID", 0x00),
    ("NIL", 0x00),
    ("BOOL", 0x01),
    ("BYTE", 0x02),
    ("CHAR", 0x03),
    ("WORD", 0x04),
    ("INT", 0x05),
    ("DWORD", 0x06),
    ("DINT", 0x07),
    ("REAL", 0x08),
    ("DATE", 0x09),
    ("TIME_OF_DAY", 0x0A),
    ("TOD", 0x0A),
    ("TIME", 0x0B),
    ("S5TIME", 0x0C),
    ("DATE_AND_TIME", 0x0E),
    ("DT", 0x0E),
    ("STRING", 0x13),
    ("BLOCK_FB", 0x17),
    ("BLOCK_FC", 0x18),
    ("BLOCK_DB", 0x19),
    ("BLOCK_SDB", 0x1A),
    ("COUNTER", 0x1C),
    ("TIMER", 0x1D),
];

/// The code of the type in an ANY that a word names, without regard to case: `P#M 0.0 BYTE 4`.
pub fn any_type_code(word: &str) -> Option<u8> {
    ANY_TYPES.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)).map(|&(_, code)| code)
}

/// The word for the type with this code in an ANY.
pub fn any_type_word(code: u8) -> Option<&'static str> {
    ANY_TYPES.iter().find(|&&(_, known)| known == code).map(|&(word, _)| word)
}

/// The letters of the area with this code in a pointer.
pub fn pointer_area(code: u8) -> Option<&'static str> {
    POINTER_AREAS
        .iter()
        .find(|&&(letters, known)| known == code && !matches!(letters, "PI" | "PE" | "PQ" | "PA"))
        .map(|&(letters, _)| letters)
}

const POINTER_FORMS: &str = "a pointer is P#byte.bit, P#M 10.0, P#DBX 10.0, P#DB5.DBX 10.0, or one of these with a type and a count, such as P#DB5.DBX 10.0 BYTE 20";

fn parse_pointer(text: &str) -> Parsed {
    use LiteralErrorKind::{Malformed, OutOfRange};
    let valid = || Malformed(POINTER_FORMS);
    if let Some(value) = parse_number_pointer(text) {
        return value;
    }
    let (db, rest) = match split_data_block(text) {
        Some((number, rest)) => {
            let db = u16::try_from(number).ok().filter(|&db| db > 0).ok_or(OutOfRange("DB1 to DB65535"))?;
            (Some(db), rest)
        }
        None => (None, text),
    };
    let (area, rest) = match POINTER_AREAS.iter().find_map(|&(letters, code)| rest.strip_prefix(letters).map(|rest| (code, rest))) {
        Some((code, rest)) => (code, rest.trim_start()),
        None => (0, rest),
    };
    if db.is_some() && !matches!(area, 0x84 | 0x85) {
        return Err(valid());
    }
    let end = rest.find(|character: char| !(character.is_ascii_digit() || character == '.')).unwrap_or(rest.len());
    let (number, behind) = rest.split_at(end);
    let (byte, bit) = number.split_once('.').ok_or_else(valid)?;
    let byte = parse_decimal(byte).ok_or_else(valid)?;
    let bit = parse_decimal(bit).ok_or_else(valid)?;
    let (Ok(byte), 0..=7) = (u16::try_from(byte), bit) else { return Err(OutOfRange(POINTER_RANGE)) };
    let pointer = u32::from(area) << 24 | u32::from(byte) << 3 | bit as u32;
    let behind = behind.trim_start();
    if behind.is_empty() {
        return Ok(match db {
            Some(db) => Value::DataPointer { db, pointer },
            None => Value::Pointer(pointer),
        });
    }
    let (code, count) = parse_type_and_count(behind)?;
    // An ANY names its area, except VOID 0, which points nowhere.
    if (area == 0 && code != 0) || code > 0x13 {
        return Err(valid());
    }
    Ok(any_value(code, count, db.unwrap_or(0), pointer))
}

/// `10.DBX` behind DB or DI: the number and what follows the point.
fn split_data_block(text: &str) -> Option<(u64, &str)> {
    let rest = text.strip_prefix("DB").or_else(|| text.strip_prefix("DI"))?.trim_start();
    let digits = rest.find(|character: char| !character.is_ascii_digit())?;
    let (number, rest) = rest.split_at(digits);
    Some((parse_decimal(number)?, rest.trim_start().strip_prefix('.')?.trim_start()))
}

/// `T 5 TIMER 1`, `C 3 COUNTER 1`: the form of an ANY that holds a number.
fn parse_number_pointer(text: &str) -> Option<Parsed> {
    let (letter, code) = match text.as_bytes().first()? {
        b'T' => ("T", 0x1D),
        b'C' => ("C", 0x1C),
        b'Z' => ("Z", 0x1C),
        _ => return None,
    };
    let rest = text.strip_prefix(letter)?.trim_start();
    let end = rest.find(|character: char| !character.is_ascii_digit()).unwrap_or(rest.len());
    let (number, behind) = rest.split_at(end);
    let number = parse_decimal(number)?;
    Some(match (u16::try_from(number), parse_type_and_count(behind.trim_start())) {
        (Err(_), _) => Err(LiteralErrorKind::OutOfRange("the numbers 0 to 65535")),
        (_, Err(kind)) => Err(kind),
        (Ok(number), Ok((written, count))) if written == code => Ok(any_value(code, count, 0, u32::from(number))),
        _ => Err(LiteralErrorKind::Malformed(POINTER_FORMS)),
    })
}

fn parse_type_and_count(text: &str) -> Result<(u8, u16), LiteralErrorKind> {
    use LiteralErrorKind::{Malformed, OutOfRange};
    let end = text.find(|character: char| character.is_whitespace()).unwrap_or(text.len());
    let (word, count) = text.split_at(end);
    let code = any_type_code(word).ok_or(Malformed(POINTER_FORMS))?;
    let count = parse_decimal(count.trim()).ok_or(Malformed(POINTER_FORMS))?;
    Ok((code, u16::try_from(count).map_err(|_| OutOfRange("a count of 0 to 65535"))?))
}

fn any_value(code: u8, count: u16, db: u16, pointer: u32) -> Value {
    let mut bytes = [0x10, code, 0, 0, 0, 0, 0, 0, 0, 0];
    bytes[2..4].copy_from_slice(&count.to_be_bytes());
    bytes[4..6].copy_from_slice(&db.to_be_bytes());
    bytes[6..].copy_from_slice(&pointer.to_be_bytes());
    Value::Any(bytes)
}

/// Characters between apostrophes; `$` begins an escape.
fn parse_characters(text: &str) -> Parsed {
    use LiteralErrorKind::{Character, Malformed, OutOfRange};
    let mut bytes = Vec::new();
    let mut rest = text[1..].chars();
    loop {
        let character = rest.next().ok_or(Malformed("an apostrophe `'` ends the characters"))?;
        let byte = match character {
            '\'' if rest.as_str().is_empty() => break,
            '\'' => return Err(Malformed("an apostrophe inside characters is written `$'`")),
            '$' => parse_escape(&mut rest).ok_or(Malformed("behind `$` stand `$`, `'`, L, N, P, R, T or two hex digits"))?,
            character if character.is_control() => {
                return Err(Malformed("control characters are written with `$`: $L, $P, $R, $T or two hex digits"));
            }
            character => character_byte(character).ok_or(Character(character))?,
        };
        if bytes.len() == STRING_MAX {
            return Err(OutOfRange("the 254 characters of a STRING"));
        }
        bytes.push(byte);
    }
    Ok(Value::Characters(bytes))
}

fn parse_escape(rest: &mut std::str::Chars<'_>) -> Option<u8> {
    let first = rest.next()?;
    Some(match first.to_ascii_uppercase() {
        '$' => b'$',
        '\'' => b'\'',
        'L' | 'N' => 0x0A,
        'P' => 0x0C,
        'R' => 0x0D,
        'T' => 0x09,
        _ => (first.to_digit(16)? << 4 | rest.next()?.to_digit(16)?) as u8,
    })
}

/// What the bytes 16#80 to 16#9F mean in code page 1252; a zero is a byte that means nothing.
const CP1252: [char; 32] = [
    '€', '\0', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\0', 'Ž', '\0', '\0', '‘', '’', '“', '”', '•', '–', '—', '˜', '™',
    'š', '›', 'œ', '\0', 'ž', 'Ÿ',
];

/// Letters of code page 1250 that 1252 does not have, with their bytes.
const CP1250: &str = "Ś\u{8C}Ť\u{8D}Ź\u{8F}ś\u{9C}ť\u{9D}ź\u{9F}Ł\u{A3}Ą\u{A5}Ş\u{AA}Ż\u{AF}ł\u{B3}ą\u{B9}ş\u{BA}Ľ\u{BC}ľ\u{BE}ż\u{BF}Ŕ\u{C0}Ă\u{C3}Ĺ\u{C5}Ć\u{C6}Č\u{C8}Ę\u{CA}Ě\u{CC}Ď\u{CF}Đ\u{D0}Ń\u{D1}Ň\u{D2}Ő\u{D5}Ř\u{D8}Ů\u{D9}Ű\u{DB}Ţ\u{DE}ŕ\u{E0}ă\u{E3}ĺ\u{E5}ć\u{E6}č\u{E8}ę\u{EA}ě\u{EC}ď\u{EF}đ\u{F0}ń\u{F1}ň\u{F2}ő\u{F5}ř\u{F8}ů\u{F9}ű\u{FB}ţ\u{FE}";

/// The byte of a character: code page 1252, else the byte that 1250 or 1251 has for the letter, as the source's author saw it.
pub fn character_byte(character: char) -> Option<u8> {
    let code = u32::from(character);
    match character {
        '\u{20}'..='\u{7E}' | '\u{A0}'..='\u{FF}' => Some(code as u8),
        'А'..='я' => Some((code - 0x410 + 0xC0) as u8),
        'Ё' => Some(0xA8),
        'ё' => Some(0xB8),
        '\0' => None,
        _ => CP1252.iter().position(|&known| known == character).map(|position| (position + 0x80) as u8).or_else(|| {
            let mut known = CP1250.chars();
            while let (Some(letter), Some(byte)) = (known.next(), known.next()) {
                if letter == character {
                    return Some(u32::from(byte) as u8);
                }
            }
            None
        }),
    }
}

/// The character that a byte shows in code page 1252; `None` for control characters.
fn byte_character(byte: u8) -> Option<char> {
    match byte {
        0x20..=0x7E | 0xA1..=0xFF => Some(char::from(byte)),
        0x80..=0x9F => Some(CP1252[usize::from(byte - 0x80)]).filter(|&character| character != '\0'),
        _ => None,
    }
}

fn spell_characters(bytes: &[u8]) -> String {
    let mut text = String::from("'");
    for &byte in bytes {
        match byte {
            b'$' | b'\'' => text.extend(['$', char::from(byte)]),
            0x0A => text.push_str("$L"),
            0x0C => text.push_str("$P"),
            0x0D => text.push_str("$R"),
            0x09 => text.push_str("$T"),
            _ => match byte_character(byte) {
                Some(character) => text.push(character),
                None => text.push_str(&format!("${byte:02X}")),
            },
        }
    }
    text.push('\'');
    text
}

/// The characters of a WSTRING between quotation marks, with `$` before what has no place there.
pub(crate) fn spell_wide(text: &str) -> String {
    let mut out = String::from("\"");
    for character in text.chars() {
        match character {
            '$' | '"' => out.extend(['$', character]),
            '\n' => out.push_str("$L"),
            '\u{C}' => out.push_str("$P"),
            '\r' => out.push_str("$R"),
            '\t' => out.push_str("$T"),
            character if character.is_control() => out.push_str(&format!("${:04X}", u32::from(character))),
            character => out.push(character),
        }
    }
    out.push('"');
    out
}

impl Value {
    /// The bits of the value, right-justified, as they come into ACCU 1; `None` for what is longer than 64 bits or has no fixed length.
    pub fn bits(&self) -> Option<u64> {
        Some(match *self {
            Self::Bool(value) => u64::from(value),
            Self::Int(value) => u64::from(value as u16),
            Self::DoubleInt(value) | Self::Time(value) => u64::from(value as u32),
            Self::Real(value) => u64::from(value.to_bits()),
            Self::Byte(value) => u64::from(value),
            Self::Word(value) | Self::S5Time(value) | Self::Counter(value) | Self::Date(value) => u64::from(value),
            Self::DoubleWord(value) | Self::TimeOfDay(value) | Self::Pointer(value) => u64::from(value),
            Self::Characters(ref bytes) if matches!(bytes.len(), 1..=4) => bytes.iter().fold(0, |word, &byte| word << 8 | u64::from(byte)),
            Self::DateAndTime(bytes) => u64::from_be_bytes(bytes),
            Self::DataPointer { db, pointer } => u64::from(db) << 32 | u64::from(pointer),
            Self::Characters(_) | Self::Any(_) | Self::Image(_) => return None,
        })
    }

    /// The length of the value in bits.
    pub fn width(&self) -> u32 {
        match self {
            Self::Bool(_) => 1,
            Self::Byte(_) => 8,
            Self::Int(_) | Self::Word(_) | Self::S5Time(_) | Self::Counter(_) | Self::Date(_) => 16,
            Self::DoubleInt(_) | Self::Real(_) | Self::DoubleWord(_) | Self::Time(_) | Self::TimeOfDay(_) | Self::Pointer(_) => 32,
            Self::Characters(bytes) => u32::try_from(bytes.len() * 8).unwrap_or(u32::MAX),
            Self::DateAndTime(_) => 64,
            Self::DataPointer { .. } => 48,
            Self::Any(_) => 80,
            Self::Image(bytes) => u32::try_from(bytes.len()).unwrap_or(u32::MAX).saturating_mul(8),
        }
    }

    /// The constant in its usual notation, with English letters for areas; [`parse`] reads it back.
    pub fn spell(&self) -> String {
        match *self {
            Self::Bool(true) => "TRUE".to_owned(),
            Self::Bool(false) => "FALSE".to_owned(),
            Self::Int(value) => value.to_string(),
            Self::DoubleInt(value) => format!("L#{value}"),
            Self::Real(value) if value.is_finite() => spell_real(value),
            // Infinity and NaN have no notation as REAL.
            Self::Real(value) => format!("DW#16#{:08X}", value.to_bits()),
            Self::Byte(value) => format!("B#16#{value:02X}"),
            Self::Word(value) => format!("W#16#{value:04X}"),
            Self::DoubleWord(value) => format!("DW#16#{value:08X}"),
            Self::Characters(ref bytes) => spell_characters(bytes),
            Self::S5Time(word) => match s5time_milliseconds(word) {
                Some(milliseconds) if s5time_word(milliseconds) == Some(word) => {
                    format!("S5T#{}", spell_duration(milliseconds, &UNITS[1..]))
                }
                // A coarser base than necessary, or digits that are not decimal.
                _ => format!("W#16#{word:04X}"),
            },
            Self::Counter(word) => match from_bcd(u32::from(word)) {
                Some(number @ 0..=999) => format!("C#{number}"),
                _ => format!("W#16#{word:04X}"),
            },
            Self::Time(value) => {
                let sign = if value < 0 { "-" } else { "" };
                format!("T#{sign}{}", spell_duration(u64::from(value.unsigned_abs()), &UNITS))
            }
            Self::Date(days) if days <= DATE_MAX => {
                let (year, month, day) = calendar_date(days);
                format!("D#{year}-{month:02}-{day:02}")
            }
            Self::Date(days) => format!("W#16#{days:04X}"),
            Self::TimeOfDay(value) if value < DAY_MS => format!("TOD#{}", spell_time_of_day(value)),
            Self::TimeOfDay(value) => format!("DW#16#{value:08X}"),
            Self::DateAndTime(ref bytes) => match date_and_time_parts(bytes) {
                Some((days, milliseconds)) => {
                    let (year, month, day) = calendar_date(days);
                    format!("DT#{year}-{month:02}-{day:02}-{}", spell_time_of_day(milliseconds))
                }
                None => format!("16#{:016X}", u64::from_be_bytes(*bytes)),
            },
            Self::Pointer(pointer) => format!("P#{}", spell_pointer(pointer)),
            Self::DataPointer { db: 0, pointer } => format!("P#{}", spell_pointer(pointer)),
            Self::DataPointer { db, pointer } => format!("P#{}{db}.{}", data_register(pointer), spell_pointer(pointer)),
            Self::Any(ref bytes) => spell_any(bytes),
            Self::Image(ref bytes) => bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" "),
        }
    }

    /// The value of a data type that fits 64 bits, from its bits; `None` for all other types.
    pub fn from_bits(data_type: &DataType, bits: u64) -> Option<Self> {
        Some(match data_type {
            DataType::Bool => Self::Bool(bits & 1 == 1),
            DataType::Byte => Self::Byte(bits as u8),
            DataType::Char => Self::Characters(vec![bits as u8]),
            DataType::Word => Self::Word(bits as u16),
            DataType::Int => Self::Int(bits as u16 as i16),
            DataType::DoubleWord => Self::DoubleWord(bits as u32),
            DataType::DoubleInt => Self::DoubleInt(bits as u32 as i32),
            DataType::Real => Self::Real(f32::from_bits(bits as u32)),
            DataType::Date => Self::Date(bits as u16),
            DataType::TimeOfDay => Self::TimeOfDay(bits as u32),
            DataType::Time => Self::Time(bits as u32 as i32),
            DataType::S5Time => Self::S5Time(bits as u16),
            DataType::DateAndTime => Self::DateAndTime(bits.to_be_bytes()),
            _ => return None,
        })
    }
}

/// Raw bits as a value of a data type, the way a table of variables shows it; types without a notation in hex by their width.
pub fn format_as(data_type: &DataType, bits: u64) -> String {
    if let Some(text) = elsewhere::format_as(data_type, bits) {
        return text;
    }
    match Value::from_bits(data_type, bits) {
        Some(Value::DoubleInt(value)) => value.to_string(),
        Some(Value::Real(value)) if value.is_nan() => "NaN".to_owned(),
        Some(Value::Real(value)) if value.is_infinite() => if value > 0.0 { "+INF" } else { "-INF" }.to_owned(),
        // Shown by its time even if the base is coarser than necessary.
        Some(Value::S5Time(word)) => match s5time_milliseconds(word) {
            Some(milliseconds) => format!("S5T#{}", spell_duration(milliseconds, &UNITS[1..])),
            None => format!("W#16#{word:04X}"),
        },
        Some(value) => value.spell(),
        None => match data_type.bits() {
            0..=16 => format!("W#16#{:04X}", bits as u16),
            64.. => format!("16#{bits:016X}"),
            _ => format!("DW#16#{:08X}", bits as u32),
        },
    }
}

/// A finite REAL in the shortest digits that read back the same, with the three exponent digits of STEP 7.
fn spell_real(value: f32) -> String {
    let text = format!("{value:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let point = if mantissa.contains('.') { "" } else { ".0" };
    let (sign, digits) = exponent.strip_prefix('-').map_or(('+', exponent), |digits| ('-', digits));
    format!("{mantissa}{point}e{sign}{digits:0>3}")
}

/// The units that are not zero, or `0MS`.
pub(crate) fn spell_duration(milliseconds: u64, units: &[(&str, u64)]) -> String {
    let mut left = milliseconds;
    let mut text = String::new();
    for &(unit, factor) in units {
        let number = left / factor;
        left %= factor;
        if number > 0 {
            text.push_str(&format!("{number}{unit}"));
        }
    }
    if text.is_empty() { "0MS".to_owned() } else { text }
}

fn data_register(pointer: u32) -> &'static str {
    if pointer >> 24 == 0x85 { "DI" } else { "DB" }
}

/// `10.0`, `M 10.0`; a double word that is no pointer in hex.
fn spell_pointer(pointer: u32) -> String {
    let code = (pointer >> 24) as u8;
    let position = format!("{}.{}", pointer >> 3 & 0xFFFF, pointer & 7);
    match pointer_area(code) {
        _ if pointer & 0x00F8_0000 != 0 => format!("16#{pointer:08X}"),
        Some(letters) => format!("{letters} {position}"),
        None if code == 0 => position,
        None => format!("16#{pointer:08X}"),
    }
}

fn spell_any(bytes: &[u8; 10]) -> String {
    let count = u16::from_be_bytes([bytes[2], bytes[3]]);
    let db = u16::from_be_bytes([bytes[4], bytes[5]]);
    let pointer = u32::from_be_bytes([bytes[6], bytes[7], bytes[8], bytes[9]]);
    let Some(word) = any_type_word(bytes[1]) else {
        return format!("16#{}", bytes.iter().map(|byte| format!("{byte:02X}")).collect::<String>());
    };
    match bytes[1] {
        0x1D => format!("P#T {} {word} {count}", pointer & 0xFFFF),
        0x1C => format!("P#C {} {word} {count}", pointer & 0xFFFF),
        _ if db > 0 => format!("P#{}{db}.{} {word} {count}", data_register(pointer), spell_pointer(pointer)),
        _ => format!("P#{} {word} {count}", spell_pointer(pointer)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn bits(text: &str) -> u64 {
        parse(text).unwrap_or_else(|error| panic!("{error}")).bits().expect("a value of at most 64 bits")
    }

    fn message(text: &str) -> String {
        parse(text).expect_err(text).to_string()
    }

    #[test]
    fn every_notation_of_the_manual_has_its_bits() {
        for (text, expected) in [
            ("-5", 0xFFFB),
            ("+5", 5),
            ("5", 5),
            ("- 5", 0xFFFB),
            ("-32768", 0x8000),
            ("L#-5", 0xFFFF_FFFB),
            ("L#+5", 5),
            ("l#2147483647", 0x7FFF_FFFF),
            ("2#1111_0000_1110_0001", 0xF0E1),
            ("2#11111111_00000000_11111111_00000001", 0xFF00_FF01),
            ("B#16#EF", 0xEF),
            ("b#16#ef", 0xEF),
            ("W#16#FAFB", 0xFAFB),
            ("W#16#00000001", 1),
            ("DW#16#1FFE_1ABC", 0x1FFE_1ABC),
            ("16#5", 5),
            ("B#(1, 10)", 0x010A),
            ("B#(1, 10, 5, 50)", 0x010A_0532),
            ("'A'", 0x41),
            ("'X6'", 0x5836),
            ("'264U'", 0x3236_3455),
            ("'$'$$'", 0x2724),
            ("'$L$n$P$R'", 0x0A0A_0C0D),
            ("'$41€'", 0x4180),
            ("'ŁЖ'", 0xA3C6),
            ("C#105", 0x105),
            ("S5T#2S250MS", 0x225),
            ("S5TIME#8s_290ms", 0x829),
            ("S5T#4S", 0x400),
            ("S5T#2H46M30S", 0x3999),
            ("S5T#2H_46M_30S", 0x3999),
            ("S5T#100S", 0x2100),
            ("S5T#0.5s", 0x50),
            ("S5T#5MS", 0),
            ("1.3E+5", 0x47FD_E800),
            ("1.300000e+005", 0x47FD_E800),
            ("-1.5E+0", 0xBFC0_0000),
            ("-0.0", 0x8000_0000),
            ("3.402823E+38", 0x7F7F_FFFD),
            ("P#30.0", 0xF0),
            ("P#I1.4", 0x8100_000C),
            ("P#E 1.4", 0x8100_000C),
            ("P#A1.4", 0x8200_000C),
            ("P#M 10.0", 0x8300_0050),
            ("P#DBX 1.0", 0x8400_0008),
            ("P#DIX1.0", 0x8500_0008),
            ("P#L 0.1", 0x8600_0001),
            ("P#V0.0", 0x8700_0000),
            ("P#PE 2.0", 0x8000_0010),
            ("P#65535.7", 0x7_FFFF),
            ("P#DB10.DBX12.0", 0x000A_8400_0060),
            ("P#DI 4.DIX 1.0", 0x0004_8500_0008),
            ("D#1994-03-15", 0x5FE),
            ("D#1990-01-01", 0),
            ("DATE#2168-12-31", 0xFF62),
            ("T#2d_14h_48m_14s_350ms", 0x0D79_ED0E),
            ("T#-24D_20H_31M_23S_648MS", 0x8000_0000),
            ("TIME#-1S", 0xFFFF_FC18),
            ("T#24D20H31M23S647MS", 0x7FFF_FFFF),
            ("TOD#01:10:3.300", 0x0040_2324),
            ("TIME_OF_DAY#23:59:59.999", 86_399_999),
            ("DT#1993-12-25-8:01:01.23", 0x9312_2508_0101_2307),
            ("DT#90-1-1-0:0:0.0", 0x9001_0100_0000_0002),
            (" true ", 1),
            ("FALSE", 0),
        ] {
            assert_eq!(bits(text), expected, "{text}: {:X} is not {expected:X}", bits(text));
        }
    }

    #[test]
    fn any_literals_have_their_ten_bytes() {
        for (text, expected) in [
            ("P#DB10.DBX12.0 REAL 20", [0x10, 8, 0, 0x14, 0, 0x0A, 0x84, 0, 0, 0x60]),
            ("P#DB1.DBX 0.0 DT 1", [0x10, 0x0E, 0, 1, 0, 1, 0x84, 0, 0, 0]),
            ("p#m 10.0 byte 4", [0x10, 2, 0, 4, 0, 0, 0x83, 0, 0, 0x50]),
            ("P#T 5 TIMER 1", [0x10, 0x1D, 0, 1, 0, 0, 0, 0, 0, 5]),
            ("P#Z 7 COUNTER 1", [0x10, 0x1C, 0, 1, 0, 0, 0, 0, 0, 7]),
            ("P#P 0.0 VOID 0", [0x10, 0, 0, 0, 0, 0, 0x80, 0, 0, 0]),
        ] {
            assert_eq!(parse(text), Ok(Value::Any(expected)), "{text}");
        }
    }

    #[test]
    fn messages_name_the_valid_range() {
        assert_eq!(message("C#1000"), "`C#1000` is outside C#0 to C#999");
        assert_eq!(message("40000"), "`40000` is outside -32768 to 32767 (a 32-bit integer is written with L#)");
        assert_eq!(message("S5T#3H"), "`S5T#3H` is outside S5T#0MS to S5T#2H46M30S");
        assert_eq!(message("D#2023-02-29"), "`D#2023-02-29` names a day that the calendar does not have");
        assert_eq!(message("B#(1,256)"), "`B#(1,256)` is outside 0 to 255 for each byte of B#(…)");
        for text in
            ["1e-40", "1e39", "B#16#100", "W#16#10000", "DW#16#100000000", "P#65536.0", "P#0.8", "L#2147483648", "T#25D", "TOD#24:0:0.0"]
        {
            assert!(message(text).contains(" is outside "), "{text}: {}", message(text));
        }
        for text in [
            "2#12", "W#16#", "W#FF", "C#-1", "S5T#", "S5T#1S1H", "T#5", "T#1S_", "D#1994", "P#1", "P##x", "'", "'a'b'", "'$Q'", "B#(1)",
            "2#1__0",
        ] {
            assert!(message(text).contains(" is not understood: "), "{text}: {}", message(text));
        }
        for text in ["", "#", "x", "Q#5", "1.", ".5", "1E", "--5", "0x10"] {
            assert!(message(text).contains(" is not a constant"), "{text}: {}", message(text));
        }
        assert_eq!(parse("  W#16#XYZ").map_err(|error| error.offset), Err(4));
    }

    #[test]
    fn s5time_cuts_to_the_base_it_chose() {
        for (milliseconds, word) in
            [(9_990, 0x0999), (9_991, 0x1099), (99_900, 0x1999), (99_950, 0x2099), (999_000, 0x2999), (999_900, 0x3099)]
        {
            assert_eq!(s5time_word(milliseconds), Some(word), "{milliseconds}");
        }
        assert_eq!(s5time_word(9_990_001), None);
    }

    #[test]
    fn raw_bits_are_shown_by_type() {
        for (data_type, bits, text) in [
            (DataType::Bool, 1, "TRUE"),
            (DataType::Int, 0xFFFB, "-5"),
            (DataType::DoubleInt, 0xFFFF_FFFB, "-5"),
            (DataType::Word, 0xFB, "W#16#00FB"),
            (DataType::Real, 0x3FC0_0000, "1.5e+000"),
            (DataType::Real, 0x7F80_0000, "+INF"),
            (DataType::Real, 0x7FC0_0000, "NaN"),
            (DataType::Time, 0xFFFF_FC18, "T#-1S"),
            (DataType::S5Time, 0x1005, "S5T#500MS"),
            (DataType::S5Time, 0x00FF, "W#16#00FF"),
            (DataType::Date, 0x5FE, "D#1994-03-15"),
            (DataType::TimeOfDay, 0x0040_2324, "TOD#01:10:03.300"),
            (DataType::Char, 0x41, "'A'"),
            (DataType::Timer, 5, "W#16#0005"),
        ] {
            assert_eq!(format_as(&data_type, bits), text);
        }
    }

    fn any_value_of_a_constant() -> impl Strategy<Value = Value> {
        prop_oneof![
            any::<bool>().prop_map(Value::Bool),
            any::<i16>().prop_map(Value::Int),
            any::<i32>().prop_map(Value::DoubleInt),
            any::<f32>().prop_filter("a REAL constant is normal or zero", |value| value.is_normal() || *value == 0.0).prop_map(Value::Real),
            any::<u8>().prop_map(Value::Byte),
            any::<u16>().prop_map(Value::Word),
            any::<u32>().prop_map(Value::DoubleWord),
            proptest::collection::vec(any::<u8>(), 0..20).prop_map(Value::Characters),
            (0..=S5TIME_MAX_MS).prop_map(|milliseconds| Value::S5Time(s5time_word(milliseconds).expect("in range"))),
            (0..=999_u32).prop_map(|number| Value::Counter(bcd::encode(number) as u16)),
            any::<i32>().prop_map(Value::Time),
            (0..=DATE_MAX).prop_map(Value::Date),
            (0..DAY_MS).prop_map(Value::TimeOfDay),
            (0..36_525_u16, 0..DAY_MS).prop_map(|(days, milliseconds)| Value::DateAndTime(date_and_time_bytes(days, milliseconds))),
            (prop_oneof![Just(0_u32), 0x80..=0x87_u32], 0..=0x7_FFFF_u32)
                .prop_map(|(area, position)| Value::Pointer(area << 24 | position)),
            (1..=u16::MAX, 0x84..=0x85_u32, 0..=0x7_FFFF_u32)
                .prop_map(|(db, area, position)| Value::DataPointer { db, pointer: area << 24 | position }),
            (1..=8_u8, any::<u16>(), any::<u16>(), 0..=0x7_FFFF_u32).prop_map(|(code, count, db, position)| any_value(
                code,
                count,
                db,
                0x8400_0000 | position
            )),
        ]
    }

    proptest! {
        #[test]
        fn what_is_spelled_reads_back_the_same(value in any_value_of_a_constant()) {
            prop_assert_eq!(parse(&value.spell()), Ok(value));
        }

        #[test]
        fn bits_and_type_give_the_value_back(bits in any::<u32>()) {
            for data_type in [DataType::Bool, DataType::Byte, DataType::Word, DataType::Int, DataType::DoubleInt, DataType::Time, DataType::S5Time] {
                let value = Value::from_bits(&data_type, u64::from(bits)).expect("elementary");
                let mask = (1_u64 << data_type.bits()) - 1;
                prop_assert_eq!(value.bits(), Some(u64::from(bits) & mask));
                prop_assert_eq!(u64::from(value.width()), data_type.bits());
                prop_assert!(!format_as(&data_type, u64::from(bits)).is_empty());
            }
        }

        #[test]
        fn no_text_panics(text in "\\PC*") {
            let _ = parse(&text).map(|value| value.spell()).map_err(|error| error.to_string());
        }

        #[test]
        fn no_text_of_constant_letters_panics(text in "(L|2|16|B|W|DW|C|S5T|T|D|TOD|DT|P|')?#?[-+0-9A-Z#._:(), '$]{0,24}") {
            if let Ok(value) = parse(&text) {
                prop_assert_eq!(parse(&value.spell()), Ok(value));
            }
        }

        #[test]
        fn no_bits_panic(bytes in any::<[u8; 10]>()) {
            for value in [
                Value::Any(bytes),
                Value::DateAndTime([bytes[0], bytes[1], bytes[2], bytes[3], bytes[4], bytes[5], bytes[6], bytes[7]]),
                Value::Pointer(u32::from_be_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
                Value::Date(u16::from_be_bytes([bytes[0], bytes[1]])),
                Value::Counter(u16::from_be_bytes([bytes[0], bytes[1]])),
            ] {
                prop_assert!(!value.spell().is_empty());
            }
        }
    }
}
