//! Formats of a watch table: how a value is shown where a user says so, as `MD 20:REAL` or `MB 3:BIN`.

mod notation;

use std::fmt;

use crate::types::DataType;
use crate::value::{Content, Kind};

pub use notation::{spell_long_real, spell_real};

/// How a value is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)] // The variants are the names of the table.
pub enum Format {
    Bool,
    Bin,
    Hex,
    Dec,
    Int,
    Dint,
    Lint,
    Real,
    Lreal,
    Char,
    Bcd,
    S5Time,
    Time,
    Ltime,
    Date,
    Ldate,
    Tod,
    Ltod,
    Dt,
    Ldt,
    Counter,
    Pointer,
    Any,
}

/// What a format can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    /// One bit.
    Bit,
    /// So many bits: 8, 16, 32 or 64.
    Width(u32),
    /// A timer.
    Timer,
    /// A counter.
    Counter,
    /// The value of a timer or counter, the number or length of a data block, as a plain number.
    Number,
    /// The status word.
    Status,
    /// The six bytes of a POINTER.
    Pointer,
    /// The ten bytes of an ANY.
    Any,
    /// A STRING or WSTRING.
    Characters,
    /// Bytes without a type.
    Bytes,
}

/// A row of the table of formats.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The format.
    pub format: Format,
    /// What it is called: `S5TIME`.
    pub name: &'static str,
    /// What else it is called.
    pub also: &'static [&'static str],
    /// What it can show.
    pub fits: &'static [Fit],
    /// What its values look like.
    pub notation: &'static str,
}

const fn row(format: Format, name: &'static str, also: &'static [&'static str], fits: &'static [Fit], notation: &'static str) -> Row {
    Row { format, name, also, fits, notation }
}

use Fit::{Bit, Bytes, Characters, Number, Status, Timer, Width};

/// All formats.
pub const ROWS: &[Row] = &[
    row(Format::Bool, "BOOL", &[], &[Bit], "TRUE"),
    row(
        Format::Bin,
        "BIN",
        &[],
        &[Bit, Width(8), Width(16), Width(32), Width(64), Number, Status, Fit::Pointer, Fit::Any, Bytes],
        "2#0000_0101",
    ),
    row(
        Format::Hex,
        "HEX",
        &[],
        &[Bit, Width(8), Width(16), Width(32), Width(64), Number, Status, Fit::Pointer, Fit::Any, Bytes, Characters],
        "W#16#00FF",
    ),
    row(Format::Dec, "DEC", &[], &[Bit, Width(8), Width(16), Width(32), Width(64), Number], "-2"),
    row(Format::Int, "INT", &[], &[Width(16)], "-2"),
    row(Format::Dint, "DINT", &[], &[Width(32)], "L#-2"),
    row(Format::Lint, "LINT", &[], &[Width(64)], "-2"),
    row(Format::Real, "REAL", &[], &[Width(32)], "10.0"),
    row(Format::Lreal, "LREAL", &[], &[Width(64)], "10.0"),
    row(Format::Char, "CHAR", &[], &[Width(8), Width(16), Width(32), Width(64), Characters, Bytes], "'AB'"),
    row(Format::Bcd, "BCD", &[], &[Width(8), Width(16), Width(32)], "142"),
    row(Format::S5Time, "S5TIME", &[], &[Width(16), Timer], "S5T#5S"),
    row(Format::Time, "TIME", &[], &[Width(32)], "T#1H30M"),
    row(Format::Ltime, "LTIME", &[], &[Width(64)], "LT#1S500MS"),
    row(Format::Date, "DATE", &[], &[Width(16)], "D#2024-02-29"),
    row(Format::Ldate, "LDATE", &[], &[Width(64)], "LD#2024-02-29"),
    row(Format::Tod, "TOD", &["TIME_OF_DAY"], &[Width(32)], "TOD#12:00:00.000"),
    row(Format::Ltod, "LTOD", &[], &[Width(64)], "LTOD#12:00:00.000000000"),
    row(Format::Dt, "DT", &["DATE_AND_TIME"], &[Width(64)], "DT#2024-02-29-12:00:00.000"),
    row(Format::Ldt, "LDT", &[], &[Width(64)], "LDT#2024-02-29-12:00:00.000000000"),
    row(Format::Counter, "COUNTER", &[], &[Width(16), Fit::Counter], "C#20"),
    row(Format::Pointer, "POINTER", &[], &[Width(32), Fit::Pointer], "P#M 10.0"),
    row(Format::Any, "ANY", &[], &[Fit::Any], "P#DB5.DBX 10.0 BYTE 20"),
];

/// A number that a program can calculate with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Figure {
    /// A whole one.
    Whole(i64),
    /// A REAL.
    Real(f32),
    /// An LREAL.
    LongReal(f64),
    /// A time in units of its base: a count of so many milliseconds each.
    OfBase {
        /// How many.
        count: u16,
        /// Milliseconds of one.
        base_ms: u32,
    },
}

/// A value in a format.
#[derive(Clone, Debug, PartialEq)]
pub struct Formatted {
    /// In the notation of the format; bits that the format does not know in hex, with a mark.
    pub text: String,
    /// The number that it is, if it is one.
    pub figure: Option<Figure>,
    /// What else there is to see of it: the numbers of its bits, its fields.
    pub details: Vec<String>,
}

impl Format {
    /// Its row of the table.
    pub fn row(self) -> &'static Row {
        ROWS.iter().find(|row| row.format == self).unwrap_or(&ROWS[0])
    }

    /// Its name: `S5TIME`.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The format with a name, without regard to case.
    pub fn from_name(name: &str) -> Option<Self> {
        let is = |known: &&str| known.eq_ignore_ascii_case(name);
        ROWS.iter().find(|row| is(&row.name) || row.also.iter().any(is)).map(|row| row.format)
    }

    /// Splits `MD 20:REAL` into a name and what follows its last colon outside of quotes; `None` if there is no such colon.
    pub fn split(text: &str) -> Option<(&str, &str)> {
        let at = text.rfind(':').filter(|&at| text[at..].bytes().all(|byte| byte != b'"'))?;
        Some((text[..at].trim_end(), text[at + 1..].trim()))
    }

    /// Whether it can show one of these.
    pub fn fits(self, any: &[Fit]) -> bool {
        self.row().fits.iter().any(|fit| any.contains(fit))
    }

    /// The formats that can show one of these.
    pub fn fitting(any: &[Fit]) -> impl Iterator<Item = Self> {
        ROWS.iter().map(|row| row.format).filter(move |format| format.fits(any))
    }

    /// The data type whose values it shows, where there are so many bits.
    pub fn data_type(self, width: u32) -> Option<DataType> {
        Some(match self {
            Self::Bool => DataType::Bool,
            Self::Int => DataType::Int,
            Self::Dint => DataType::DoubleInt,
            Self::Lint => DataType::LongInt,
            Self::Dec => match width {
                8 => DataType::UnsignedSmallInt,
                16 => DataType::Int,
                32 => DataType::DoubleInt,
                64 => DataType::LongInt,
                _ => return None,
            },
            Self::Real => DataType::Real,
            Self::Lreal => DataType::LongReal,
            Self::Char if width == 8 => DataType::Char,
            Self::S5Time => DataType::S5Time,
            Self::Time => DataType::Time,
            Self::Ltime => DataType::LongTime,
            Self::Date => DataType::Date,
            Self::Ldate => DataType::LongDate,
            Self::Tod => DataType::TimeOfDay,
            Self::Ltod => DataType::LongTimeOfDay,
            Self::Dt => DataType::DateAndTime,
            Self::Ldt => DataType::LongDateAndTime,
            Self::Bin | Self::Hex | Self::Char | Self::Bcd | Self::Counter | Self::Pointer | Self::Any => return None,
        })
    }

    /// A value of this kind in the format. What the bits mean nothing in is shown in hex, with a mark.
    pub fn show(self, of: &Kind, content: &Content) -> Formatted {
        notation::show(self, of, content)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bit => f.write_str("a bit"),
            Self::Width(8) => f.write_str("a byte"),
            Self::Width(16) => f.write_str("a word"),
            Self::Width(32) => f.write_str("a double word"),
            Self::Width(width) => write!(f, "{width} bits"),
            Self::Timer => f.write_str("a timer"),
            Self::Counter => f.write_str("a counter"),
            Self::Number => f.write_str("a number"),
            Self::Status => f.write_str("the status word"),
            Self::Pointer => f.write_str("a POINTER"),
            Self::Any => f.write_str("an ANY"),
            Self::Characters => f.write_str("a string"),
            Self::Bytes => f.write_str("bytes"),
        }
    }
}

/// Why a value is not shown in a format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FormatError {
    /// No format is called that.
    Unknown(String),
    /// The format does not show such values.
    Unfit {
        /// The format.
        format: Format,
        /// What the value is.
        is: Fit,
        /// The formats that show it.
        fitting: Vec<Format>,
    },
}

impl FormatError {
    /// What is wrong, about an item with this name.
    pub fn of(&self, name: &str) -> String {
        match self {
            Self::Unknown(word) if word.is_empty() => format!("after the colon of `{name}:` a format is missing"),
            Self::Unknown(word) => format!("`{word}`, asked for with `{name}`, is no format"),
            Self::Unfit { format, is, .. } => {
                let shows: Vec<String> = format.row().fits.iter().filter(|fit| **fit != Fit::Number).map(ToString::to_string).collect();
                format!("`{name}` is {is}, and {format} shows {}", listed(&shows))
            }
        }
    }

    /// What to write instead.
    pub fn help(&self) -> String {
        let names = |formats: &[Format]| listed(&formats.iter().map(|format| format!("`{format}`")).collect::<Vec<_>>());
        match self {
            Self::Unknown(_) => format!("the formats are {}", names(&ROWS.iter().map(|row| row.format).collect::<Vec<_>>())),
            Self::Unfit { fitting, .. } if fitting.is_empty() => "leave the format out".to_owned(),
            Self::Unfit { fitting, .. } => format!("it is shown as {}", names(fitting)),
        }
    }
}

/// `a`, `b` or `c`.
fn listed(words: &[String]) -> String {
    match words.split_last() {
        None => String::new(),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The page whose table of values is the test.
    const PAGE: &str = include_str!("../../../docs/reference/formats.md");

    /// The cells of the rows of the table with these headings.
    fn table(headings: &str) -> Vec<Vec<&'static str>> {
        let lines = PAGE.lines().skip_while(|line| *line != headings).skip(2).take_while(|line| line.starts_with('|'));
        lines.map(|line| line.trim_matches('|').split('|').map(|cell| cell.trim().trim_matches('`')).collect()).collect()
    }

    /// `16#00FF` or `16#01 02 03` as a value of the kind that its number of digits says.
    fn value(text: &str) -> (Kind, Content) {
        let digits = text.trim_start_matches("16#").replace(' ', "");
        let bytes: Vec<u8> = (0..digits.len() / 2).map(|at| u8::from_str_radix(&digits[2 * at..2 * at + 2], 16).expect("hex")).collect();
        let kind = match bytes.len() {
            6 => Kind::Typed(DataType::Pointer),
            10 => Kind::Typed(DataType::Any),
            length => Kind::Bits(length as u32 * 8),
        };
        match kind {
            Kind::Bits(_) => (kind, Content::Bits(bytes.iter().fold(0, |bits, &byte| bits << 8 | u64::from(byte)))),
            kind => (kind, Content::Bytes(bytes.into())),
        }
    }

    #[test]
    fn every_row_of_the_page_is_what_a_value_is_shown_as() {
        let rows = table("| format | value | shown |");
        for row in &rows {
            let [name, bits, shown] = row[..] else { panic!("{row:?} has three cells") };
            let format = Format::from_name(name).unwrap_or_else(|| panic!("{name} is no format"));
            let (kind, content) = value(bits);
            assert!(format.fits(&kind.fits()), "{name} of {bits}");
            assert_eq!(format.show(&kind, &content).text, shown, "{name} of {bits}");
        }
        for row in ROWS.iter().filter(|row| row.format != Format::Bool) {
            assert!(rows.iter().any(|cells| cells[0] == row.name), "the page shows no value as {}", row.name);
        }
    }

    #[test]
    fn the_page_lists_every_format_with_what_it_shows() {
        let rows = table("| format | shows | notation |");
        assert_eq!(rows.len(), ROWS.len());
        for (cells, row) in rows.iter().zip(ROWS) {
            let fits: Vec<String> = row.fits.iter().map(ToString::to_string).collect();
            let names: Vec<&str> = [row.name].into_iter().chain(row.also.iter().copied()).collect();
            assert_eq!(cells, &vec![names.join("`, `").as_str(), fits.join(", ").as_str(), row.notation], "{}", row.name);
        }
    }

    #[test]
    fn names_are_read_in_either_case_and_colons_in_quotes_are_none() {
        assert_eq!(Format::from_name("s5time"), Some(Format::S5Time));
        assert_eq!(Format::from_name("date_and_time"), Some(Format::Dt));
        assert_eq!(Format::split("MD 20 : real"), Some(("MD 20", "real")));
        assert_eq!(Format::split("\"a:b\""), None);
        assert_eq!(Format::split("\"a:b\":INT"), Some(("\"a:b\"", "INT")));
    }

    #[test]
    fn every_format_shows_every_value_and_never_panics() {
        let kinds = [Kind::Bit, Kind::Bits(8), Kind::Bits(16), Kind::Bits(32), Kind::Bits(64), Kind::Number, Kind::Status];
        let bytes = [Kind::Typed(DataType::Pointer), Kind::Typed(DataType::Any), Kind::Typed(DataType::String(4)), Kind::Bytes(3)];
        for row in ROWS {
            // Also those that do not fit: the head of a recording can say anything.
            for kind in kinds.iter().chain(&bytes) {
                let formatted = Kind::Formatted(row.format, Box::new(kind.clone()));
                for bits in [0, 1, 0x7F, 0x80, 0xFF, 0x0999, 0xFFFF, 0x8000_0000, 0xFFFF_FFFF, u64::MAX] {
                    let shown = formatted.show(&Content::Bits(bits)).to_string();
                    assert!(!shown.is_empty() || matches!(row.format, Format::Char), "{} of {kind:?} {bits:X}", row.name);
                    formatted.number(bits);
                    formatted.scale(bits);
                    formatted.compare(bits, 1);
                }
            }
            // Also bytes that are fewer than their type has.
            for kind in &bytes {
                for length in 0..12 {
                    row.format.show(kind, &Content::Bytes(vec![0xFF; length].into()));
                }
            }
        }
    }
}
