//! Writes what a scenario reads: times, names, values, interrupts.

use sieben_cpu::{DateAndTime, Interrupt};
use sieben_model::address::{Area, Operand};
use sieben_model::format::Format;
use sieben_model::literal;
use sieben_model::types::DataType;
use sieben_model::value::Content;

use super::Assignments;
use crate::names::{Kind, Name, Sample};

/// A time in the largest unit that needs no fraction.
pub(super) fn time(us: u64) -> String {
    match us {
        0 => "0ms".to_owned(),
        us if us.is_multiple_of(1000) => format!("{}ms", us / 1000),
        us => format!("{us}us"),
    }
}

/// A name so that a line gives it back: in quotes, unless it is an address or one word; its format after the quotes.
pub(super) fn name(text: &str) -> String {
    if let Some((plain, format)) = Format::split(text).and_then(|(plain, word)| Some((plain, Format::from_name(word)?))) {
        return format!("{}:{format}", name(plain));
    }
    let one_word = |part: &str| {
        part.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '[' | ']' | ','))
            && part.starts_with(|c: char| c.is_alphabetic() || c == '_')
    };
    let plain = text.starts_with('"') || Operand::parse(text).is_some() || text.split('.').all(one_word) || absolute(text);
    if plain { text.to_owned() } else { format!("\"{text}\"") }
}

/// `DB1.DBD 4`, `T 1`, `STW.RLO`: nothing that a line could misread.
fn absolute(text: &str) -> bool {
    !text.contains(['=', '"', '/']) && Operand::parse(&text.replace(' ', "")).is_some()
}

/// A value so that a line gives it back, bit for bit; `None` if there is none.
pub(super) fn value(name: &Name, sample: &Sample) -> Option<String> {
    match sample {
        Sample::Absent => None,
        Sample::Text(text) => Some(text.to_string()),
        Sample::Bits(bits) => Some(bits_of(name, *bits)),
    }
}

/// The bits of a value so that a line gives them back.
pub(super) fn bits_of(name: &Name, bits: u64) -> String {
    let text = name.show_bits(bits).to_string();
    let kept = name.value(&text).is_ok_and(|read| read.content == Content::Bits(bits)) && !text.contains(char::is_whitespace);
    if kept {
        return text;
    }
    match name.kind().plain() {
        // Numbers that REAL has several of, and characters that no text shows.
        Kind::Typed(data_type) if data_type.bits() == 64 => format!("16#{bits:016X}"),
        kind => format!("16#{bits:0digits$X}", digits = (kind.width().max(4) / 4) as usize),
    }
}

/// ` NAME=VALUE` of each.
pub(super) fn assignments(values: &Assignments) -> String {
    values.iter().map(|one| format!(" {}={}", one.name, one.value)).collect()
}

/// The rest of a line `interrupt …`.
pub(super) fn interrupt(interrupt: &Interrupt) -> String {
    let info = interrupt.start_information();
    format!(
        "OB {} EVENT=16#{:04X} ID=16#{:04X} INFO1=16#{:04X} INFO2=16#{:08X}",
        info.block, info.event, info.data_id, info.info_1, info.info_2
    )
}

pub(super) fn clock(clock: DateAndTime) -> String {
    literal::format_as(&DataType::DateAndTime, u64::from_be_bytes(clock.to_bcd()))
}

/// Whether a name means an input, which modules have.
pub(super) fn is_input(name: &Name) -> bool {
    matches!(name.operand(), Some(Operand::Address(address)) if matches!(address.area, Area::Input | Area::PeripheralInput))
}
