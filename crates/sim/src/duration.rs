//! Durations as people write them: `10ms`, `1.5s`, `1s500ms`, `2m`, `1h`.

use std::time::Duration;

/// Units and their microseconds.
const UNITS: [(&str, f64); 7] = [("us", 1.0), ("µs", 1.0), ("ms", 1e3), ("s", 1e6), ("m", 60e6), ("min", 60e6), ("h", 3600e6)];

/// Longest duration: 10 years, so that sums of microseconds never overflow.
const DURATION_MAX_US: f64 = 10.0 * 365.0 * 24.0 * 3600e6;

/// Longest time from one scan to the next: what falls into one, such as a cyclic interrupt or a step of a plant in every millisecond,
/// has an end that can be waited for.
pub const CYCLE_MAX: Duration = Duration::from_secs(24 * 3600);

/// Reads the time from one scan to the next.
///
/// # Errors
/// The text is no duration, or longer than [`CYCLE_MAX`]; the message says so.
pub fn parse_cycle(text: &str) -> Result<Duration, String> {
    let cycle = parse(text)?;
    match cycle > CYCLE_MAX {
        true => Err(format!("`{text}` is longer than 24 hours, the longest cycle")),
        false => Ok(cycle),
    }
}

/// Reads a duration: numbers with their units; a number without a unit is refused, except 0.
///
/// # Errors
/// The text is no duration, or longer than ten years; the message says so.
pub fn parse(text: &str) -> Result<Duration, String> {
    let wanted = || format!("`{text}` is not a duration; write a number with its unit: `10ms`, `1.5s`, `2m` or `1h`");
    let mut rest = text.trim();
    if rest == "0" {
        return Ok(Duration::ZERO);
    }
    if rest.is_empty() {
        return Err(wanted());
    }
    let mut us = 0.0;
    while !rest.is_empty() {
        // `f64::from_str` also takes `inf`, `NaN` and exponents, which nobody means here.
        let (number, behind) = rest.split_at(rest.find(|c: char| !c.is_ascii_digit() && c != '.').ok_or_else(wanted)?);
        let behind = behind.trim_start();
        let (unit, next) = behind.split_at(behind.find(|c: char| !c.is_alphabetic()).unwrap_or(behind.len()));
        let factor = UNITS.iter().find(|&&(name, _)| name == unit).ok_or_else(wanted)?.1;
        us += number.parse::<f64>().map_err(|_| wanted())? * factor;
        rest = next.trim_start();
    }
    if us > DURATION_MAX_US {
        return Err(format!("`{text}` is longer than ten years, the longest duration that is taken"));
    }
    Ok(Duration::from_micros(us.round() as u64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_is_read() {
        for (text, us) in [
            ("10ms", 10_000),
            ("1.5s", 1_500_000),
            ("2m", 120_000_000),
            ("2min", 120_000_000),
            ("1h", 3_600_000_000),
            ("250us", 250),
            ("250µs", 250),
            (" 3 s ", 3_000_000),
            ("0", 0),
            ("1s500ms", 1_500_000),
            ("1 min 30 s", 90_000_000),
        ] {
            assert_eq!(parse(text), Ok(Duration::from_micros(us)), "{text}");
        }
    }

    #[test]
    fn everything_else_is_refused() {
        for text in ["", "10", "ms", "-1s", "1e3s", "infs", "1.2.3s", "1d", "99999999h", "NaNms", "1s5", "s1", "."] {
            assert!(parse(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_cycle_is_a_day_at_most() {
        assert_eq!(parse_cycle("24h"), Ok(CYCLE_MAX));
        assert_eq!(parse_cycle("87599h"), Err("`87599h` is longer than 24 hours, the longest cycle".to_owned()));
        assert!(parse_cycle("1 day").is_err());
    }
}
