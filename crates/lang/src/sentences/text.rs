//! Values and words as they stand in a sentence.

use sieben_model::literal::{Value, format_as};
use sieben_model::types::DataType;

use super::Language;
use super::table::Sentence;

/// What is filled in for a name between braces, in English and German.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Words(pub(crate) [String; 2]);

impl Words {
    pub(crate) fn of(&self, language: Language) -> &str {
        &self.0[usize::from(language == Language::German)]
    }
}

impl From<String> for Words {
    fn from(text: String) -> Self {
        Self([text.clone(), text])
    }
}

impl From<&str> for Words {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<[&str; 2]> for Words {
    fn from(both: [&str; 2]) -> Self {
        Self(both.map(str::to_owned))
    }
}

impl From<u64> for Words {
    fn from(number: u64) -> Self {
        number.to_string().into()
    }
}

/// A sentence with what is filled in.
#[derive(Clone, Debug)]
pub(crate) struct Clause {
    pub(crate) sentence: Sentence,
    values: Vec<(&'static str, Words)>,
}

impl Clause {
    pub(crate) fn new(sentence: Sentence) -> Self {
        Self { sentence, values: Vec::new() }
    }

    /// Fills in a value.
    pub(crate) fn with(mut self, name: &'static str, words: impl Into<Words>) -> Self {
        self.values.push((name, words.into()));
        self
    }

    /// The words in a language; what was not filled in comes from `others`.
    pub(crate) fn render(&self, language: Language, others: &dyn Fn(&str) -> Option<Words>) -> String {
        let mut out = String::new();
        let mut rest = self.sentence.template(language);
        while let Some((before, behind)) = rest.split_once('{') {
            out.push_str(before);
            let Some((name, behind)) = behind.split_once('}') else {
                out.push('{');
                rest = behind;
                break;
            };
            match self.values.iter().find(|(own, _)| *own == name) {
                Some((_, words)) => out.push_str(words.of(language)),
                None => match others(name) {
                    Some(words) => out.push_str(words.of(language)),
                    None => out.push_str(&format!("{{{name}}}")),
                },
            }
            rest = behind;
        }
        out + rest
    }

    /// The words in both languages.
    pub(crate) fn words(&self, others: &dyn Fn(&str) -> Option<Words>) -> Words {
        Words(Language::ALL.map(|language| self.render(language, others)))
    }
}

/// A text in one line, without comments, each run of blanks as one.
pub(crate) fn one_line(text: &str) -> String {
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ").trim_end_matches(';').trim_end().to_owned()
}

/// A REAL.
pub(crate) fn real(bits: u64) -> String {
    let value = f32::from_bits(bits as u32);
    match value.abs() {
        // Numbers of everyday size are easier to read without an exponent.
        size if size == 0.0 || (0.001..1_000_000.0).contains(&size) => format!("{value:?}"),
        _ => format_as(&DataType::Real, bits & 0xFFFF_FFFF),
    }
}

/// Bits whose type nobody knows: as an integer, and in hex where that says more.
pub(crate) fn loose(bits: u64) -> String {
    let bits = bits as u32;
    match bits {
        0..=9 => bits.to_string(),
        10..=0xFFFF => format!("{} (16#{bits:04X})", bits as u16 as i16),
        _ => {
            let value = f32::from_bits(bits);
            match value.is_normal() && (1e-6..1e9).contains(&value.abs()) {
                true => format!("16#{bits:08X} ({} as a REAL)", real(u64::from(bits))),
                false => format!("{} (16#{bits:08X})", bits as i32),
            }
        }
    }
}

/// [`loose`] in both languages.
pub(crate) fn loose_words(bits: u64) -> Words {
    let english = loose(bits);
    Words([english.clone(), english.replace(" as a REAL", " als REAL")])
}

/// A pointer: `P#M 13.1`, `P#2.0`.
pub(crate) fn pointer(bits: u64) -> String {
    Value::Pointer(bits as u32).spell()
}

/// A value of a data type.
pub(crate) fn typed(data_type: &DataType, bits: u64) -> Words {
    match data_type {
        DataType::Real => real(bits).into(),
        DataType::Bool => if bits & 1 == 1 { "1" } else { "0" }.into(),
        DataType::Word | DataType::Byte | DataType::DoubleWord => loose_words(bits),
        _ => format_as(data_type, bits).into(),
    }
}

/// A time of an S5 timer: so many steps of a time base.
pub(crate) fn time(value: u16, base: u8) -> Words {
    let milliseconds = u64::from(value) * [10, 100, 1_000, 10_000][usize::from(base & 3)];
    let seconds = milliseconds / 1_000;
    match milliseconds {
        0..1_000 => format!("{milliseconds} ms").into(),
        1_000..60_000 => {
            let text = format!("{seconds}.{:03}", milliseconds % 1_000);
            let text = text.trim_end_matches('0').trim_end_matches('.');
            Words([format!("{text} s"), format!("{} s", text.replace('.', ","))])
        }
        _ => format!("{} min {} s", seconds / 60, seconds % 60).into(),
    }
}
