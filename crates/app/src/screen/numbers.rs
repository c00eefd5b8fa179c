//! Numbers and times as the screen writes them.

/// `1204` as `1,204`.
pub(crate) fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// `12.04 s` or `1:02:03 h`.
pub(crate) fn clock(time_ms: u64) -> String {
    let (minutes, seconds) = (time_ms / 60_000, time_ms % 60_000 / 1_000);
    match minutes {
        0 => format!("{seconds}.{:02} s", time_ms % 1_000 / 10),
        1..60 => format!("{minutes}:{seconds:02}.{} min", time_ms % 1_000 / 100),
        _ => format!("{}:{:02}:{seconds:02} h", minutes / 60, minutes % 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_times_are_easy_to_read() {
        assert_eq!(["0", "999", "1,204", "12,345,678"], [0, 999, 1_204, 12_345_678].map(thousands)[..]);
        assert_eq!(["12.04 s", "2:03.4 min", "1:02:03 h"], [12_040, 123_400, 3_723_000].map(clock)[..]);
    }
}
