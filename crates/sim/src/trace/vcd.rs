//! Traces for waveform viewers such as GTKWave: Value Change Dump, IEEE 1364.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::ops::RangeInclusive;

use sieben_model::bcd;
use sieben_model::format::Format;
use sieben_model::types::DataType;

use super::{Channel, Trace, TraceError};
use crate::names::{Kind, Sample};

/// How a channel is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// So many bits.
    Wire(u32),
    /// So many bits that are a signed or unsigned whole number.
    Integer(u32),
    /// A number in f64.
    Real,
    /// Text, an extension that GTKWave reads.
    Text,
}

impl Form {
    fn of(kind: &Kind) -> Self {
        if let Kind::Formatted(format, of) = kind {
            return match format {
                Format::Bin | Format::Hex | Format::Bool => Self::of(of),
                Format::Dec | Format::Int | Format::Dint | Format::Lint | Format::Real | Format::Lreal if !of.is_recorded_as_text() => {
                    Self::of(&kind.meaning())
                }
                _ => Self::Text,
            };
        }
        match kind {
            Kind::Formatted(..) => Self::Text,
            Kind::Bit => Self::Wire(1),
            Kind::Bits(width) => Self::Wire(*width),
            Kind::Status => Self::Wire(9),
            Kind::Number | Kind::TimeLeft => Self::Integer(32),
            Kind::Typed(DataType::Real | DataType::LongReal) => Self::Real,
            Kind::Typed(DataType::LongWord) => Self::Wire(64),
            Kind::Typed(
                DataType::Char
                | DataType::WideChar
                | DataType::Date
                | DataType::LongDate
                | DataType::TimeOfDay
                | DataType::LongTimeOfDay
                | DataType::DateAndTime
                | DataType::LongDateAndTime
                | DataType::S5Time,
            )
            | Kind::Bytes(_)
            | Kind::Text => Self::Text,
            Kind::Typed(data_type) => Self::Integer(data_type.bits() as u32),
        }
    }

    fn declaration(self) -> (&'static str, u32) {
        match self {
            Self::Wire(width) => ("wire", width),
            Self::Integer(width) => ("integer", width),
            Self::Real => ("real", 64),
            Self::Text => ("string", 1),
        }
    }
}

/// Writes a dump. One unit is a microsecond of virtual time, or one scan if time stood still.
///
/// TIME is a whole number of milliseconds. A value that was not loaded is `x`, or a text or REAL that says so.
///
/// # Errors
/// The trace cannot be read or the dump not be written.
pub fn write(trace: &Trace, range: &RangeInclusive<u64>, out: &mut dyn Write) -> Result<(), TraceError> {
    let stood_still = trace.summary().stood_still;
    writeln!(out, "$version Sieben {} $end", plain(&trace.origin().title))?;
    if stood_still {
        out.write_str("$comment Two scans began at the same time: one unit is one scan. $end\n")?;
    }
    out.write_str("$timescale 1 us $end\n$scope module cpu $end\n")?;
    let mut used = BTreeSet::new();
    for (index, channel) in trace.channels().iter().enumerate() {
        let (word, width) = Form::of(&channel.kind).declaration();
        writeln!(out, "$var {word} {width} {} {} $end", identifier(index), reference(&channel.name, &mut used))?;
    }
    out.write_str("$upscope $end\n$enddefinitions $end\n")?;
    let mut last = None;
    trace.visit(range, &mut |scans| {
        let at = |moment: super::Moment| if stood_still { moment.scan } else { moment.time_us };
        if !scans.changed.is_empty() {
            writeln!(out, "#{}", at(scans.first))?;
            let first = last.is_none();
            if first {
                out.write_str("$dumpvars\n")?;
            }
            for &channel in scans.changed {
                change(&trace.channels()[channel], &scans.values[channel], channel, out)?;
            }
            if first {
                out.write_str("$end\n")?;
            }
        }
        last = Some((at(scans.last()), at(scans.first), scans.changed.is_empty()));
        Ok(())
    })?;
    // A last time without a change keeps the end of the trace.
    if let Some((end, begin, unchanged)) = last
        && (end != begin || unchanged)
    {
        writeln!(out, "#{end}")?;
    }
    Ok(())
}

fn change(channel: &Channel, value: &Sample, index: usize, out: &mut dyn Write) -> Result<(), std::fmt::Error> {
    let id = identifier(index);
    match (Form::of(&channel.kind), value) {
        (Form::Wire(1), Sample::Bits(bits)) => writeln!(out, "{bits}{id}"),
        (Form::Wire(1), _) => writeln!(out, "x{id}"),
        (Form::Integer(width), Sample::Bits(bits)) => {
            let bits = match channel.kind {
                // The count, as `L` loads it.
                Kind::TimeLeft => u64::from(bcd::decode(*bits as u32, 3)),
                _ => *bits,
            };
            let bits = bits & if width >= 64 { u64::MAX } else { (1 << width) - 1 };
            writeln!(out, "b{bits:0width$b} {id}", width = width as usize)
        }
        (Form::Wire(_), Sample::Bits(bits)) => writeln!(out, "b{bits:b} {id}"),
        (Form::Wire(_) | Form::Integer(_), _) => writeln!(out, "bx {id}"),
        (Form::Real, Sample::Bits(bits)) => {
            let number = match *channel.kind.meaning() {
                Kind::Typed(DataType::LongReal) => f64::from_bits(*bits),
                _ => f64::from(f32::from_bits(*bits as u32)),
            };
            writeln!(out, "r{} {id}", number.to_string().to_lowercase())
        }
        (Form::Real, _) => writeln!(out, "rnan {id}"),
        (Form::Text, value) => writeln!(out, "s{} {id}", escaped(&value.display(&channel.kind).to_string())),
    }
}

/// The short name of a channel: printable characters, the most frequent digit first.
fn identifier(mut index: usize) -> String {
    let mut text = String::new();
    loop {
        text.push(char::from(b'!' + (index % 94) as u8));
        index /= 94;
        if index == 0 {
            return text;
        }
        index -= 1;
    }
}

/// A name without what the format gives a meaning to: blanks end a name, brackets and quotation marks are part of the syntax of viewers.
fn reference(name: &str, used: &mut BTreeSet<String>) -> String {
    let joined: String = name.split_whitespace().collect::<Vec<_>>().join("_");
    let mut text: String = joined
        .chars()
        .filter(|&c| c != '"' && !c.is_control())
        .map(|c| match c {
            '[' | '{' => '(',
            ']' | '}' => ')',
            '$' | '\\' => '_',
            c => c,
        })
        .collect();
    if text.is_empty() {
        text.push('_');
    }
    let mut unique = text.clone();
    let mut number = 2;
    while !used.insert(unique.clone()) {
        unique = format!("{text}_{number}");
        number += 1;
    }
    unique
}

/// A text in one word, as C writes it.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\\\"),
            c if c.is_ascii_graphic() => out.push(c),
            c => {
                let mut bytes = [0; 4];
                c.encode_utf8(&mut bytes).bytes().for_each(|byte| out.push_str(&format!("\\x{byte:02x}")));
            }
        }
    }
    if out.is_empty() { "\\x20".to_owned() } else { out }
}

/// A text that ends no command of the format.
fn plain(text: &str) -> String {
    text.replace('$', "_").split_whitespace().collect::<Vec<_>>().join(" ")
}
