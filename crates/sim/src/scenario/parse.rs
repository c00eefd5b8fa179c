//! Reads the parts of the lines of a scenario.

use std::ops::Range;

use sieben_cpu::retain::Numbers;
use sieben_cpu::{CyclicInterrupt, DateAndTime, Interrupt, OperatingMode, RetentiveAreas};
use sieben_model::literal::{self, Value};

use super::{Assignment, Assignments, Command, PlantLine, SCANS_MAX};
use crate::{duration as durations, names};

/// Cuts a comment: a line that begins with `//`, or the rest behind ` //` outside of quotes.
pub(super) fn without_comment(line: &str) -> &str {
    if line.trim_start().starts_with("//") {
        return "";
    }
    let mut from = 0;
    while let Some(at) = line[from..].find(['"', '\'', '/']).map(|at| from + at) {
        let rest = &line[at + 1..];
        match line.as_bytes()[at] {
            b'/' if rest.starts_with('/') && line[..at].ends_with(' ') => return &line[..at - 1],
            b'/' => from = at + 1,
            // A quote that nothing closes is none.
            quote => from = rest.find(char::from(quote)).map_or(at + 1, |end| at + 1 + end + 1),
        }
    }
    line
}

/// A point in time as STL writes it, `DT#2026-11-22-09:30:00`.
pub(super) fn date_and_time(text: &str) -> Result<DateAndTime, String> {
    let wanted = || format!("`{text}` is no time of day; write `clock DT#2026-11-22-09:30:00`");
    let value = literal::parse(text.trim()).map_err(|_| wanted())?;
    match value {
        Value::DateAndTime(_) => value.bits().and_then(|bits| DateAndTime::from_bytes(bits.to_be_bytes())).ok_or_else(wanted),
        _ => Err(wanted()),
    }
}

pub(super) fn assignments(text: &str) -> Result<Assignments, String> {
    let out = names::assignments(text).map_err(|error| error.to_string())?;
    if out.is_empty() {
        return Err("write at least one `NAME=VALUE`".to_owned());
    }
    Ok(out.into_iter().map(|(name, value)| Assignment::written(name, value)).collect())
}

/// `oven gain=181.3 seed=7`.
pub(super) fn plant(rest: &str) -> Result<PlantLine, String> {
    let wanted = || format!("`plant {rest}` is not understood; write the plant and its parameters: `plant oven gain=181.3 seed=7`");
    let (module, values) = rest.split_once(char::is_whitespace).ok_or_else(wanted)?;
    let mut line = PlantLine { module: module.to_owned(), ..PlantLine::default() };
    for word in values.split_whitespace() {
        match word.split_once('=').ok_or_else(wanted)? {
            ("seed", value) => line.seed = Some(value.parse().map_err(|_| format!("`{value}` is no seed; write a whole number"))?),
            (name, value) => {
                let number = value.parse::<f64>().ok().filter(|number| number.is_finite());
                line.parameters.push((name.to_owned(), number.ok_or_else(|| format!("`{value}` is no number for `{name}`"))?));
            }
        }
    }
    Ok(line)
}

pub(super) fn scan(rest: &str) -> Result<Command, String> {
    let mut words = rest.split_whitespace();
    let command = match (words.next(), words.next()) {
        (None, _) => Command::Scan(1),
        (Some("until"), Some(time)) => Command::ScanUntil(duration(time)?),
        (Some("at"), Some(time)) => Command::ScanAt(duration(time)?),
        (Some(count), None) if !matches!(count, "until" | "at") => {
            let count = count.parse().ok().filter(|&count| count <= SCANS_MAX);
            Command::Scan(count.ok_or_else(|| format!("`{rest}` is no number of scans up to {SCANS_MAX}"))?)
        }
        _ => return Err(format!("`scan {rest}` is not understood; write `scan`, `scan 3`, `scan until 400ms` or `scan at 400ms`")),
    };
    match words.next() {
        Some(word) => Err(format!("`{word}` does not belong here")),
        None => Ok(command),
    }
}

/// `OB 40`, `OB 82 EVENT=16#3842 INFO1=4`, `OB 40 at safe point 17`.
pub(super) fn interrupt(rest: &str) -> Result<Command, String> {
    let not_understood = || format!("`interrupt {rest}` is not understood; write `interrupt OB 40` or `interrupt OB 40 at safe point 17`");
    let (what, point) = match rest.split_once(" at ") {
        None => (rest, None),
        Some((what, behind)) => {
            let words: Vec<String> = behind.split_whitespace().map(str::to_ascii_lowercase).collect();
            let point = match words.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
                ["safe", "point", point] => point.parse::<u64>().ok().filter(|&point| point > 0),
                _ => None,
            };
            (what, Some(point.ok_or_else(not_understood)?))
        }
    };
    let (number, fields) = block_number(what).ok_or_else(not_understood)?;
    let usual = Interrupt::usual(number).ok_or_else(|| {
        format!("no event starts OB {number}; write one of OB 10 to 17, 20 to 23, 30 to 38, 40 to 47, 55 to 57, 60 or 80 to 87")
    })?;
    let mut info = usual.start_information();
    for field in fields.split_whitespace() {
        let wrong = || {
            format!(
                "`{field}` is no part of the start information; write `EVENT=`, `ID=`, `INFO1=` or `INFO2=` and a number such as 16#3942"
            )
        };
        let (name, value) = field.split_once('=').ok_or_else(wrong)?;
        let value = match value.strip_prefix("16#") {
            Some(digits) => u32::from_str_radix(&digits.replace('_', ""), 16),
            None => value.parse(),
        };
        let value = value.map_err(|_| wrong())?;
        let word = u16::try_from(value);
        match name.to_ascii_uppercase().as_str() {
            "EVENT" => info.event = word.map_err(|_| wrong())?,
            "ID" => info.data_id = word.map_err(|_| wrong())?,
            "INFO1" => info.info_1 = word.map_err(|_| wrong())?,
            "INFO2" => info.info_2 = value,
            _ => return Err(wrong()),
        }
    }
    let interrupt = Interrupt::event(number, info.event, info.data_id, info.info_1, info.info_2);
    interrupt.map(|interrupt| Command::Interrupt(interrupt, point)).ok_or_else(not_understood)
}

/// `OB 40 …` or `OB40 …`: the number, and what stands behind it.
fn block_number(text: &str) -> Option<(u16, &str)> {
    let behind = text.trim_start().get(2..).filter(|_| text.trim_start().get(..2).is_some_and(|ob| ob.eq_ignore_ascii_case("ob")))?;
    let behind = behind.trim_start();
    let end = behind.find(|c: char| !c.is_ascii_digit()).unwrap_or(behind.len());
    Some((behind[..end].parse().ok()?, &behind[end..]))
}

/// Reads `m=0..31,40 t=1 c=`; what is not named stays as the CPU has it.
pub(super) fn retain(rest: &str) -> Result<RetentiveAreas, String> {
    let mut areas = RetentiveAreas::default();
    for word in rest.split_whitespace() {
        let (name, text) = word.split_once('=').unwrap_or((word, "?"));
        let numbers = match name.to_ascii_lowercase().as_str() {
            "m" => &mut areas.bit_memory,
            "t" => &mut areas.timers,
            "c" => &mut areas.counters,
            _ => return Err(format!("`{word}` is not understood; write `retain m=0..31 t=0..3 c=0..7`")),
        };
        *numbers = Numbers::parse(text)?;
    }
    Ok(areas)
}

/// `OB 35 50ms`, `OB 35 50ms phase 10ms`.
pub(super) fn cyclic(rest: &str) -> Result<(u16, CyclicInterrupt), String> {
    let not_understood = || format!("`cyclic {rest}` is not understood; write `cyclic OB 35 50ms` or `cyclic OB 35 50ms phase 10ms`");
    let (number, behind) = block_number(rest).ok_or_else(not_understood)?;
    if CyclicInterrupt::usual(number).is_none() {
        return Err(format!("OB {number} is no cyclic interrupt; these are OB 30 to OB 38"));
    }
    let ms = |text: &str, least: u64| {
        let us = duration(text)?;
        let ms = u16::try_from(us / 1000).ok().filter(|&ms| us % 1000 == 0 && u64::from(ms) >= least && ms <= CyclicInterrupt::MS_MAX);
        ms.ok_or_else(|| format!("`{text}` is no time of a cyclic interrupt; write {least}ms to 60s, in whole milliseconds"))
    };
    let (interval_ms, phase_ms) = match behind.split_whitespace().collect::<Vec<_>>().as_slice() {
        [interval] => (ms(interval, 1)?, 0),
        [interval, "phase", phase] => (ms(interval, 1)?, ms(phase, 0)?),
        _ => return Err(not_understood()),
    };
    Ok((number, CyclicInterrupt { interval_ms, phase_ms }))
}

pub(super) fn expect(rest: &str) -> Result<Command, String> {
    let (word, behind) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
    match word {
        "stop" => {
            let digits = behind.trim().strip_prefix("16#").unwrap_or(behind.trim());
            let event = u16::from_str_radix(digits, 16).map_err(|_| format!("`{}` is no event such as 16#2522", behind.trim()))?;
            return Ok(Command::ExpectStop(event));
        }
        "mode" => {
            let modes = [OperatingMode::Stop, OperatingMode::Startup, OperatingMode::Run, OperatingMode::Hold];
            let mode = modes.into_iter().find(|mode| mode.to_string().eq_ignore_ascii_case(behind.trim()));
            return mode
                .map(Command::ExpectMode)
                .ok_or_else(|| format!("`{}` is no mode; write RUN, STOP, STARTUP or HOLD", behind.trim()));
        }
        _ => {}
    }
    let (values, within) = match rest.rsplit_once(" within ") {
        Some((values, time)) => (values, Some(duration(time.trim())?)),
        None => (rest, None),
    };
    Ok(Command::Expect(assignments(values)?, within))
}

/// Splits `I 0.0 MW10 "a name" DB1.x` into names: a word that begins with a digit belongs to the one before it.
pub(super) fn name_list(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    let (mut quoted, mut start) = (false, None);
    let mut words = Vec::new();
    for (at, c) in text.char_indices() {
        quoted ^= c == '"';
        match (c.is_whitespace() && !quoted, start) {
            (true, Some(begin)) => {
                words.push(&text[begin..at]);
                start = None;
            }
            (false, None) => start = Some(at),
            _ => {}
        }
    }
    words.extend(start.map(|begin| &text[begin..]));
    for word in words {
        match out.last_mut() {
            Some(before) if word.starts_with(|c: char| c.is_ascii_digit()) => {
                before.push(' ');
                before.push_str(word);
            }
            _ => out.push(word.to_owned()),
        }
    }
    out
}

/// `0..63` or `none`: bytes, the last one included.
pub(super) fn byte_range(text: &str) -> Result<Range<u32>, String> {
    if text == "none" {
        return Ok(0..0);
    }
    let parse = |text: &str| text.trim().parse::<u32>().ok().filter(|&byte| byte < 65_536);
    match text.split_once("..").map(|(first, last)| (parse(first), parse(last))) {
        Some((Some(first), Some(last))) if first <= last => Ok(first..last + 1),
        _ => Err(format!("`{text}` are no bytes; write `0..63` or `none`")),
    }
}

/// A duration in microseconds.
pub(super) fn duration(text: &str) -> Result<u64, String> {
    // Ten years of microseconds fit.
    durations::parse(text).map(|duration| duration.as_micros() as u64)
}
