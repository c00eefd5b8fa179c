//! Durations as people write them: `10ms`, `1.5s`, `2m`, `1h`.

use std::time::Duration;

/// Units and their microseconds; the longer spelling first where one ends with another.
const UNITS: [(&str, f64); 7] = [("us", 1.0), ("µs", 1.0), ("ms", 1e3), ("min", 60e6), ("s", 1e6), ("m", 60e6), ("h", 3600e6)];

/// Longest duration: 10 years, so that sums of microseconds never overflow.
const DURATION_MAX_US: f64 = 10.0 * 365.0 * 24.0 * 3600e6;

/// Reads a duration; a number without a unit is refused, except 0.
pub(crate) fn parse(text: &str) -> Result<Duration, String> {
    let wanted = || format!("`{text}` is not a duration; write a number with its unit: `10ms`, `1.5s`, `2m` or `1h`");
    let trimmed = text.trim();
    if trimmed == "0" {
        return Ok(Duration::ZERO);
    }
    let (number, factor) =
        UNITS.iter().find_map(|&(unit, factor)| trimmed.strip_suffix(unit).map(|number| (number.trim_end(), factor))).ok_or_else(wanted)?;
    // `f64::from_str` also takes `inf`, `NaN` and exponents, which nobody means here.
    if number.is_empty() || !number.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.') {
        return Err(wanted());
    }
    let us = number.parse::<f64>().map_err(|_| wanted())? * factor;
    if us > DURATION_MAX_US {
        return Err(format!("`{text}` is longer than ten years, the longest duration that is taken"));
    }
    Ok(Duration::from_micros(us.round() as u64))
}

/// A duration in the largest unit that keeps it short: `850 µs`, `1.25 ms`, `3.0 s`.
pub(crate) fn show(duration: Duration) -> String {
    let us = duration.as_micros();
    match us {
        0..1_000 => format!("{us} µs"),
        1_000..1_000_000 => format!("{:.2} ms", us as f64 / 1e3),
        1_000_000..60_000_000 => format!("{:.1} s", us as f64 / 1e6),
        60_000_000..3_600_000_000 => format!("{} min {} s", us / 60_000_000, us / 1_000_000 % 60),
        _ => format!("{} h {} min", us / 3_600_000_000, us / 60_000_000 % 60),
    }
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
        ] {
            assert_eq!(parse(text), Ok(Duration::from_micros(us)), "{text}");
        }
    }

    #[test]
    fn everything_else_is_refused() {
        for text in ["", "10", "ms", "-1s", "1e3s", "infs", "1.2.3s", "1d", "99999999h", "NaNms"] {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
