//! The values of literals in the notations of all dialects, with the ranges of each.

use sieben_model::literal::{character_byte, days_to_date, parse, s5time_word};
use sieben_model::problems::Problem;

use super::ast::{DateAndTimeForm, Literal, LiteralKind};
use super::dialect::{Calendar, Construct, Dialect};
use super::lexer::Prefix;

/// Why a text is no literal: the problem and what would be valid.
pub(super) type Wrong = (Problem, String);
/// A literal, and what it has that not every dialect accepts.
pub(super) type Decoded = Result<(Literal, Option<Construct>), Wrong>;

const DAY_NS: u64 = 86_400_000_000_000;
const MILLISECOND_NS: i128 = 1_000_000;
/// 1990-01-01 in days since 1970.
const DAYS_1990: u32 = 7_305;
/// Longest part of a wrong literal that a message repeats, in characters.
const SHOWN: usize = 60;

fn plain(kind: LiteralKind) -> Decoded {
    Ok((Literal { kind, prefix: None }, None))
}

fn shown(text: &str) -> String {
    let short: String = text.chars().take(SHOWN).collect();
    format!("`{}`", short.escape_debug())
}

fn malformed(text: &str, valid: &str) -> Wrong {
    (Problem::P4202, format!("{} is not understood: {valid}", shown(text)))
}

fn out_of_range(text: &str, range: &str) -> Wrong {
    (Problem::P4201, format!("{} is outside {range}", shown(text)))
}

/// A number without prefix: `12`, `16#FF`, `1.5`, `1E10`.
pub(super) fn number(text: &str) -> Decoded {
    if text.contains('#') || text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'_') {
        let (value, radix) = integer(text, text)?;
        if value > i128::from(u64::MAX) {
            return Err(out_of_range(text, "the 64 bits of the largest integer types"));
        }
        return plain(LiteralKind::Integer { value, radix });
    }
    let unit = text.trim_start_matches(|character: char| character.is_ascii_digit() || matches!(character, '.' | '_'));
    if ["d", "h", "m", "s", "ms", "us", "ns"].iter().any(|known| known.eq_ignore_ascii_case(unit)) {
        return Err(malformed(text, &format!("a duration is written `T#{}`", text.chars().take(SHOWN).collect::<String>())));
    }
    let note = (!text.contains('.')).then_some(Construct::RealWithoutPoint);
    Ok((Literal { kind: real(text, text)?, prefix: None }, note))
}

/// A whole number, with its base before a `#`; saturates far above every type.
fn integer(digits: &str, whole: &str) -> Result<(i128, u8), Wrong> {
    let (radix, digits) = match digits.split_once('#') {
        None => (10, digits),
        Some(("2", digits)) => (2, digits),
        Some(("8", digits)) => (8, digits),
        Some(("10", digits)) => (10, digits),
        Some(("16", digits)) => (16, digits),
        Some(_) => return Err(malformed(whole, "the base of a number is 2, 8, 10 or 16, such as `16#FF`")),
    };
    let joined = join(digits, u32::from(radix))
        .ok_or_else(|| malformed(whole, &format!("behind it stand digits of base {radix}, with single underscores between them")))?;
    let value = joined.bytes().fold(0_i128, |sum, byte| {
        let digit = char::from(byte).to_digit(u32::from(radix)).unwrap_or(0);
        sum.saturating_mul(i128::from(radix)).saturating_add(i128::from(digit)).min(1 << 80)
    });
    Ok((value, radix))
}

/// Digits without the underscores between them.
fn join(text: &str, radix: u32) -> Option<String> {
    if text.is_empty() || text.starts_with('_') || text.ends_with('_') || text.contains("__") {
        return None;
    }
    text.chars().filter(|&character| character != '_').map(|character| character.is_digit(radix).then_some(character)).collect()
}

fn real(text: &str, whole: &str) -> Result<LiteralKind, Wrong> {
    let wrong = || malformed(whole, "a number is written like 12, 16#FF, 1.5 or 1.5E-3");
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (text, None),
    };
    let (sign, mantissa) = split_sign(mantissa);
    let (integer, fraction) = mantissa.split_once('.').unwrap_or((mantissa, "0"));
    let mut clean = format!("{sign}{}.{}", join(integer, 10).ok_or_else(wrong)?, join(fraction, 10).ok_or_else(wrong)?);
    if let Some(exponent) = exponent {
        let (sign, digits) = split_sign(exponent);
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(wrong());
        }
        clean.push_str(&format!("e{sign}{digits}"));
    }
    let value: f64 = clean.parse().map_err(|_| wrong())?;
    let single: f32 = clean.parse().map_err(|_| wrong())?;
    match value.is_finite() {
        true => Ok(LiteralKind::Real { value, single }),
        false => Err(out_of_range(whole, "the range of LREAL, about ±1.8E308")),
    }
}

fn split_sign(text: &str) -> (&str, &str) {
    match text.as_bytes().first() {
        Some(b'-' | b'+') => text.split_at(1),
        _ => ("", text),
    }
}

/// A literal with a prefix.
pub(super) fn prefixed(text: &str, dialect: Dialect) -> Decoded {
    let Some((word, rest)) = text.split_once('#') else { return Err(malformed(text, "a prefix ends with `#`")) };
    let Some(prefix) = Prefix::of(word) else { return Err(malformed(text, "no type has this name")) };
    match prefix {
        Prefix::Number("BOOL") => match rest {
            _ if rest == "1" || rest.eq_ignore_ascii_case("TRUE") => boolean(true),
            _ if rest == "0" || rest.eq_ignore_ascii_case("FALSE") => boolean(false),
            _ => Err(malformed(text, "write `BOOL#TRUE` or `BOOL#FALSE`")),
        },
        Prefix::Number(of @ ("REAL" | "LREAL")) => {
            let kind = real(rest, text)?;
            match kind {
                LiteralKind::Real { single, .. } if of == "REAL" && !single.is_finite() => {
                    Err(out_of_range(text, "the range of REAL, about ±3.4E38"))
                }
                kind => Ok((Literal { kind, prefix: Some(of) }, None)),
            }
        }
        Prefix::Number(of) if rest.starts_with('(') => byte_list(text, of, rest),
        Prefix::Number(of) => {
            let (sign, digits) = split_sign(rest);
            let (value, radix) = integer(digits, text)?;
            let value = if sign == "-" { -value } else { value };
            let (low, high) = range_of(of);
            match (low..=high).contains(&value) {
                true => Ok((Literal { kind: LiteralKind::Integer { value, radix }, prefix: Some(of) }, None)),
                false => Err(out_of_range(text, &format!("{of}, {low} to {high}"))),
            }
        }
        Prefix::Duration => duration(text, rest, false, dialect),
        Prefix::LongDuration => duration(text, rest, true, dialect),
        Prefix::S5Time => s5time(text, rest),
        Prefix::Date | Prefix::LongDate => {
            let long = prefix == Prefix::LongDate;
            let days = date(text, rest, long || dialect.switches().calendar == Calendar::Long)?;
            plain(LiteralKind::Date { days, long })
        }
        Prefix::TimeOfDay | Prefix::LongTimeOfDay => {
            let long = prefix == Prefix::LongTimeOfDay;
            plain(LiteralKind::TimeOfDay { nanoseconds: time_of_day(text, rest, long)?, long })
        }
        Prefix::DateAndTime | Prefix::LongDateAndTime | Prefix::StructuredDateAndTime => {
            let form = match prefix {
                Prefix::DateAndTime => DateAndTimeForm::Short,
                Prefix::LongDateAndTime => DateAndTimeForm::Long,
                _ => DateAndTimeForm::Structured,
            };
            date_and_time(text, rest, form, dialect)
        }
        Prefix::Characters(of) => typed_characters(text, of, rest, dialect),
        Prefix::Counter => match join(rest, 10).map(|digits| digits.parse::<u32>().unwrap_or(u32::MAX)) {
            Some(count @ 0..=999) => plain(LiteralKind::Counter(sieben_model::bcd::encode(count) as u16)),
            Some(_) => Err(out_of_range(text, "C#0 to C#999")),
            None => Err(malformed(text, "write `C#` and a number from 0 to 999")),
        },
        Prefix::Pointer => match parse(text) {
            Ok(value) => plain(LiteralKind::Pointer(value)),
            Err(error) => Err((error.problem(), error.to_string())),
        },
    }
}

fn boolean(value: bool) -> Decoded {
    Ok((Literal { kind: LiteralKind::Bool(value), prefix: Some("BOOL") }, None))
}

/// The lowest and the highest value of a type of whole numbers or bits.
fn range_of(of: &str) -> (i128, i128) {
    let signed = |bits: u32| (-(1_i128 << (bits - 1)), (1_i128 << (bits - 1)) - 1);
    let unsigned = |bits: u32| (0, (1_i128 << bits) - 1);
    match of {
        "SINT" => signed(8),
        "INT" => signed(16),
        "DINT" => signed(32),
        "LINT" => signed(64),
        "BYTE" | "USINT" => unsigned(8),
        "WORD" | "UINT" => unsigned(16),
        "DWORD" | "UDINT" => unsigned(32),
        _ => unsigned(64),
    }
}

/// `B#(1,2)`, `DW#(1,2,3,4)`.
fn byte_list(text: &str, of: &'static str, rest: &str) -> Decoded {
    let wrong = || malformed(text, "write numbers from 0 to 255 with commas between them, as many as the type has bytes: `W#(1,2)`");
    let inner = rest.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).ok_or_else(wrong)?;
    let mut value = 0_i128;
    let mut count = 0;
    for part in inner.split(',') {
        let (byte, _) = integer(part.trim(), text)?;
        if !(0..=255).contains(&byte) || count == 8 {
            return Err(wrong());
        }
        value = value << 8 | byte;
        count += 1;
    }
    let prefix = match (of, count) {
        ("BYTE" | "WORD", 2) => "WORD",
        ("BYTE" | "DWORD", 4) => "DWORD",
        ("LWORD", 8) => "LWORD",
        _ => return Err(wrong()),
    };
    Ok((Literal { kind: LiteralKind::Integer { value, radix: 16 }, prefix: Some(prefix) }, None))
}

/// The units of a duration, longest first, in nanoseconds, with the next longer one.
const UNITS: [(&str, u64, u64); 7] = [
    ("d", DAY_NS, u64::MAX),
    ("h", 3_600_000_000_000, DAY_NS),
    ("m", 60_000_000_000, 3_600_000_000_000),
    ("s", 1_000_000_000, 60_000_000_000),
    ("ms", 1_000_000, 1_000_000_000),
    ("us", 1_000, 1_000_000),
    ("ns", 1, 1_000),
];

/// The nanoseconds of a duration, and whether a field behind the first one is larger than its unit.
fn fields(text: &str, whole: &str) -> Result<(i128, bool), Wrong> {
    let wrong =
        || malformed(whole, "a duration is written like T#1d2h3m4s5ms, the longest unit first, each once, a fraction only in the last");
    let (sign, mut rest) = split_sign(text);
    let (mut total, mut next_unit, mut overflow) = (0_i128, 0, false);
    while !rest.is_empty() {
        let digits = rest.find(|c: char| !(c.is_ascii_digit() || c == '_' || c == '.')).ok_or_else(wrong)?;
        let (number, behind) = rest.split_at(digits);
        let letters = behind.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(behind.len());
        let (unit, behind) = behind.split_at(letters);
        let position = UNITS.iter().position(|(name, ..)| name.eq_ignore_ascii_case(unit)).ok_or_else(wrong)?;
        if position < next_unit {
            return Err(wrong());
        }
        let (_, factor, limit) = UNITS[position];
        let (integer, fraction) = number.split_once('.').map_or((number, None), |(integer, fraction)| (integer, Some(fraction)));
        let integer = join(integer, 10).ok_or_else(wrong)?.parse::<u64>().unwrap_or(u64::MAX);
        let value = i128::from(integer) * i128::from(factor);
        overflow |= next_unit > 0 && value >= i128::from(limit);
        total += value;
        next_unit = position + 1;
        rest = match behind.strip_prefix('_') {
            Some("") => return Err(wrong()),
            Some(behind) => behind,
            None => behind,
        };
        if let Some(fraction) = fraction {
            if !rest.is_empty() {
                return Err(wrong());
            }
            total += part(&join(fraction, 10).ok_or_else(wrong)?, factor);
        }
    }
    match next_unit {
        0 => Err(wrong()),
        _ => Ok((if sign == "-" { -total } else { total }, overflow)),
    }
}

/// Decimal digits behind a point as a part of `unit`, rounded to the nearest; digits beyond the 18th do not count.
fn part(digits: &str, unit: u64) -> i128 {
    let counted = &digits[..digits.len().min(18)];
    let number: i128 = counted.parse().unwrap_or(0);
    let scale = 10_i128.pow(counted.len() as u32);
    (number * i128::from(unit) + scale / 2) / scale
}

/// Rounds to whole units, halves away from zero.
fn rounded(value: i128, unit: i128) -> i128 {
    (value.abs() + unit / 2) / unit * value.signum()
}

fn duration(text: &str, rest: &str, long: bool, dialect: Dialect) -> Decoded {
    let (exact, overflow) = fields(rest, text)?;
    let nanoseconds = match long {
        // Without a sign it goes twice as far: the pattern of bits says it.
        true if !dialect.switches().time_signed => {
            u64::try_from(exact).map_err(|_| out_of_range(text, "LT#0ns to LT#213503d23h34m33s709ms551us615ns"))? as i64
        }
        true => i64::try_from(exact)
            .map_err(|_| out_of_range(text, "LT#-106751d23h47m16s854ms775us808ns to LT#106751d23h47m16s854ms775us807ns"))?,
        false => {
            let milliseconds = rounded(exact, MILLISECOND_NS);
            let (low, high, range) = match dialect.switches().time_signed {
                true => (i128::from(i32::MIN), i128::from(i32::MAX), "T#-24d20h31m23s648ms to T#24d20h31m23s647ms"),
                false => (0, i128::from(u32::MAX), "T#0ms to T#49d17h2m47s295ms"),
            };
            if !(low..=high).contains(&milliseconds) {
                return Err(out_of_range(text, range));
            }
            // At most 2^32 milliseconds fit.
            (milliseconds * MILLISECOND_NS) as i64
        }
    };
    Ok((Literal { kind: LiteralKind::Duration { nanoseconds, long }, prefix: None }, overflow.then_some(Construct::DurationOverflow)))
}

fn s5time(text: &str, rest: &str) -> Decoded {
    let (exact, overflow) = fields(rest, text)?;
    let word = u64::try_from(exact).ok().and_then(|nanoseconds| s5time_word(nanoseconds / 1_000_000));
    let word = word.ok_or_else(|| out_of_range(text, "S5T#0ms to S5T#2h46m30s"))?;
    Ok((Literal { kind: LiteralKind::S5Time(word), prefix: None }, overflow.then_some(Construct::DurationOverflow)))
}

/// The days since 1970 of `2024-01-31`.
fn date(whole: &str, text: &str, long: bool) -> Result<u32, Wrong> {
    let wrong = || malformed(whole, "a date is year-month-day, such as D#2024-02-29");
    let numbers: Option<Vec<u32>> = text.split('-').map(|part| join(part, 10)?.parse().ok()).collect();
    let numbers = numbers.ok_or_else(wrong)?;
    let &[year, month, day] = numbers.as_slice() else { return Err(wrong()) };
    // A date of the S7 has the year in full or its last two digits.
    let year = match year {
        0..=89 if !long => year + 2000,
        90..=99 if !long => year + 1900,
        year => year,
    };
    let (low, high) = if long { (1970, 2262) } else { (1990, 2168) };
    if !(low..=high).contains(&year) {
        return Err(out_of_range(whole, if long { "D#1970-01-01 to D#2262-04-11" } else { "D#1990-01-01 to D#2168-12-31" }));
    }
    // The calendar repeats every 28 years from 1970 to 1990.
    let shift = if year < 1990 { 28 } else { 0 };
    let narrow = |value: u32| u8::try_from(value).ok();
    let days = narrow(month).zip(narrow(day)).and_then(|(month, day)| days_to_date((year + shift) as u16, month, day));
    let days = days.ok_or_else(|| (Problem::P4203, format!("{} names a day that the calendar does not have", shown(whole))))?;
    let days = if shift > 0 { days + DAYS_1990 - 10_227 } else { days + DAYS_1990 };
    match days {
        // 2262-04-11, the last whole day of 63 bits of nanoseconds.
        0..=106_751 => Ok(days),
        _ => Err(out_of_range(whole, "D#1970-01-01 to D#2262-04-11")),
    }
}

fn time_of_day(whole: &str, text: &str, long: bool) -> Result<u64, Wrong> {
    let wrong = || malformed(whole, "a time of day is hours:minutes:seconds.milliseconds, such as TOD#12:34:56.789");
    let parts: Vec<&str> = text.split(':').collect();
    // Seconds may be missing in what people write by hand.
    let (hours, minutes, seconds) = match parts[..] {
        [hours, minutes] => (hours, minutes, "0"),
        [hours, minutes, seconds] => (hours, minutes, seconds),
        _ => return Err(wrong()),
    };
    let number = |text: &str| join(text, 10).map(|digits| digits.parse::<u64>().unwrap_or(u64::MAX));
    let (seconds, fraction) = seconds.split_once('.').unwrap_or((seconds, "0"));
    let fraction = join(fraction, 10).ok_or_else(wrong)?;
    let (Some(hours), Some(minutes), Some(seconds)) = (number(hours), number(minutes), number(seconds)) else { return Err(wrong()) };
    if hours > 23 || minutes > 59 || seconds > 59 {
        return Err(out_of_range(whole, "TOD#0:0:0.000 to TOD#23:59:59.999"));
    }
    let resolution = if long { 1 } else { MILLISECOND_NS };
    let nanoseconds = i128::from((hours * 60 + minutes) * 60 + seconds) * 1_000_000_000 + part(&fraction, 1_000_000_000);
    let nanoseconds = (rounded(nanoseconds, resolution) * resolution) as u64;
    // 23:59:59.9996 rounds into the next day, which is none.
    Ok(nanoseconds.min(DAY_NS - resolution as u64))
}

fn date_and_time(text: &str, rest: &str, form: DateAndTimeForm, dialect: Dialect) -> Decoded {
    let long = form != DateAndTimeForm::Short || dialect.switches().calendar == Calendar::Long;
    let valid = "a date and time is year-month-day-hours:minutes:seconds, such as DT#2024-02-29-12:30:00";
    let (day, time) = rest.rsplit_once('-').ok_or_else(|| malformed(text, valid))?;
    let days = date(text, day, long)?;
    // 2090-01-01; DATE_AND_TIME of the S7 has two digits for the year.
    if !long && days >= 43_829 {
        return Err(out_of_range(text, "DT#1990-01-01-0:0:0.000 to DT#2089-12-31-23:59:59.999"));
    }
    let nanoseconds = i128::from(days) * i128::from(DAY_NS) + i128::from(time_of_day(text, time, form != DateAndTimeForm::Short)?);
    let nanoseconds = i64::try_from(nanoseconds).map_err(|_| out_of_range(text, "DT#1970-01-01-0:0:0 to DT#2262-04-11-23:47:16"))?;
    plain(LiteralKind::DateAndTime { nanoseconds, form })
}

fn typed_characters(text: &str, of: &'static str, rest: &str, dialect: Dialect) -> Decoded {
    let wide = of.starts_with('W');
    let single = of.ends_with("CHAR");
    let (kind, length) = if rest.starts_with(['\'', '"']) {
        let kind = if wide { wide_characters(rest, dialect)? } else { characters(rest, dialect)? };
        let length = match &kind {
            LiteralKind::WideCharacters(units) => units.len(),
            LiteralKind::Characters(bytes) => bytes.len(),
            _ => 0,
        };
        (kind, length)
    } else if single {
        let (value, radix) = integer(rest, text)?;
        if value > if wide { 0xFFFF } else { 0xFF } {
            return Err(out_of_range(text, &format!("the codes of {of}")));
        }
        (LiteralKind::Integer { value, radix }, 1)
    } else {
        return Err(malformed(text, "write the text between apostrophes, such as `STRING#'text'`"));
    };
    match single && length != 1 {
        true => Err(malformed(text, &format!("a {of} is exactly one character"))),
        false => Ok((Literal { kind, prefix: Some(of) }, None)),
    }
}

/// `'text'` with its quotes.
pub(super) fn characters(text: &str, dialect: Dialect) -> Result<LiteralKind, Wrong> {
    let mut bytes = Vec::with_capacity(text.len());
    for unit in units(text, 2, dialect)? {
        bytes.push(match unit {
            Unit::Code(code) => code as u8,
            Unit::Character(character) => character_byte(character).ok_or_else(|| {
                let message = format!("`{character}` does not fit into one byte of a STRING; `$hh` writes a byte by its two hex digits");
                (Problem::P4204, message)
            })?,
        });
    }
    Ok(LiteralKind::Characters(bytes))
}

/// `"text"` or `'text'` with its quotes, as UTF-16.
pub(super) fn wide_characters(text: &str, dialect: Dialect) -> Result<LiteralKind, Wrong> {
    let mut wide = Vec::with_capacity(text.len());
    for unit in units(text, 4, dialect)? {
        match unit {
            Unit::Code(code) => wide.push(code),
            Unit::Character(character) => wide.extend_from_slice(character.encode_utf16(&mut [0; 2])),
        }
    }
    Ok(LiteralKind::WideCharacters(wide))
}

/// A character of a string as written, or the code that an escape names.
enum Unit {
    Character(char),
    Code(u16),
}

fn units(text: &str, hex_digits: usize, dialect: Dialect) -> Result<Vec<Unit>, Wrong> {
    let quote = text.chars().next().unwrap_or('\'');
    let inner = text.get(1..text.len().saturating_sub(1)).unwrap_or_default();
    let mut units = Vec::with_capacity(inner.len());
    let mut rest = inner.chars();
    while let Some(character) = rest.next() {
        if character != '$' {
            units.push(Unit::Character(character));
            continue;
        }
        let escape = rest.as_str();
        let wrong = || {
            let written: String = escape.chars().take(1).collect();
            let message = format!(
                "`${written}` in a string means nothing: behind `$` stand `$`, `{quote}`, L, N, P, R, T or {hex_digits} hex digits"
            );
            (Problem::P4202, message)
        };
        let first = rest.next().ok_or_else(wrong)?;
        let code = match first.to_ascii_uppercase() {
            '$' | '\'' | '"' => first as u16,
            'L' => 0x0A,
            'N' => {
                if dialect.switches().newline_is_two {
                    units.push(Unit::Code(0x0D));
                }
                0x0A
            }
            'P' => 0x0C,
            'R' => 0x0D,
            'T' => 0x09,
            '>' => {
                let end = escape.find("$<").ok_or_else(wrong)?;
                rest = escape[end + 2..].chars();
                continue;
            }
            _ => {
                let digits = escape.get(..hex_digits).ok_or_else(wrong)?;
                let code = u16::from_str_radix(digits, 16).map_err(|_| wrong())?;
                rest = escape[hex_digits..].chars();
                code
            }
        };
        units.push(Unit::Code(code));
    }
    Ok(units)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(text: &str, dialect: Dialect) -> LiteralKind {
        prefixed(text, dialect).unwrap_or_else(|(_, message)| panic!("{message}")).0.kind
    }

    #[test]
    fn a_date_counts_days_since_1970_in_every_dialect() {
        for (text, days) in [("D#1990-01-01", 7_305), ("D#2000-02-29", 11_016), ("D#2024-01-31", 19_753)] {
            for dialect in Dialect::ALL {
                assert_eq!(kind(text, dialect), LiteralKind::Date { days, long: false }, "{text} {dialect:?}");
            }
        }
        for (text, days) in [("D#1970-01-01", 0), ("D#1972-02-29", 789), ("D#1989-12-31", 7_304), ("D#2262-04-11", 106_751)] {
            assert_eq!(kind(text, Dialect::Iec), LiteralKind::Date { days, long: false }, "{text}");
        }
        for text in ["D#1989-12-31", "DT#2090-01-01-0:0:0"] {
            assert!(prefixed(text, Dialect::Scl).is_err());
        }
        for text in ["D#2023-02-29", "D#1971-02-29", "D#2024-13-01", "D#2024-01", "D#2262-04-12", "D#1969-12-31"] {
            assert!(prefixed(text, Dialect::Iec).is_err(), "{text}");
        }
    }

    #[test]
    fn a_duration_has_its_units_in_order_and_rounds_its_fraction() {
        let milliseconds = |text, dialect| match kind(text, dialect) {
            LiteralKind::Duration { nanoseconds, .. } => nanoseconds / 1_000_000,
            other => panic!("{other:?}"),
        };
        for (text, expected) in
            [("T#1.5m", 90_000), ("T#25h_15m", 90_900_000), ("t#90M", 5_400_000), ("TIME#-5s_3ms", -5_003), ("T#0.0005s", 1)]
        {
            assert_eq!(milliseconds(text, Dialect::Iec), expected, "{text}");
        }
        assert_eq!(milliseconds("T#49d17h2m47s295ms", Dialect::Codesys), i64::from(u32::MAX));
        assert_eq!(kind("LT#1us5ns", Dialect::Iec), LiteralKind::Duration { nanoseconds: 1_005, long: true });
        assert_eq!(kind("S5T#1m5s550ms", Dialect::Scl), LiteralKind::S5Time(0x1655));
        for text in ["T#5", "T#", "T#1s1m", "T#1s1s", "T#1.5s3ms", "T#1s_", "T#25d"] {
            assert!(prefixed(text, Dialect::Iec).is_err(), "{text}");
        }
        assert!(prefixed("T#-1ms", Dialect::Codesys).is_err());
        assert_eq!(prefixed("T#1h90m", Dialect::Scl).map(|(_, note)| note), Ok(Some(Construct::DurationOverflow)));
    }

    #[test]
    fn numbers_keep_the_range_of_their_prefix() {
        for (text, value) in [
            ("SINT#-128", -128),
            ("UINT#16#FF", 255),
            ("L#5", 5),
            ("WORD#2#1", 1),
            ("DW#(1,2,3,4)", 0x0102_0304),
            ("ULINT#18446744073709551615", u64::MAX.into()),
        ] {
            assert!(matches!(kind(text, Dialect::Scl), LiteralKind::Integer { value: found, .. } if found == value), "{text}");
        }
        for text in ["SINT#128", "UINT#-1", "BYTE#16#100", "INT#5x", "INT#1__0", "INT#3#11", "B#(1,2,3)", "BOOL#2"] {
            assert!(prefixed(text, Dialect::Scl).is_err(), "{text}");
        }
        assert!(number("18446744073709551616").is_err());
        assert_eq!(number("1E10").map(|(_, note)| note), Ok(Some(Construct::RealWithoutPoint)));
        assert!(number("1.5e").is_err() && number("1.5x").is_err() && number("5x").is_err());
    }

    #[test]
    fn strings_know_their_escapes() {
        let bytes = |text, dialect| match characters(text, dialect) {
            Ok(LiteralKind::Characters(bytes)) => bytes,
            other => panic!("{other:?}"),
        };
        assert_eq!(bytes("'a$$b$'$41$l'", Dialect::Iec), b"a$b'A\n");
        assert_eq!(bytes("'$N'", Dialect::Scl), b"\r\n");
        assert_eq!(bytes("'ab$>\r\n   $<cd'", Dialect::Scl), b"abcd");
        assert_eq!(bytes("'ä€'", Dialect::Tia), [0xE4, 0x80]);
        assert!(characters("'$x'", Dialect::Iec).is_err() && characters("'$é'", Dialect::Iec).is_err());
        let euro = LiteralKind::WideCharacters(vec![0x20AC, 0x41]);
        assert_eq!(wide_characters("\"€$0041\"", Dialect::Iec), Ok(euro));
    }
}
