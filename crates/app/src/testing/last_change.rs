//! Which statement changed a variable last, in words.

use std::time::Duration;

use sieben_model::address::Area;
use sieben_sim::runner::Written;

use crate::project::Build;
use crate::{controller, duration};

/// Characters of a statement that are shown.
const STATEMENT_MAX: usize = 60;

/// How a scan is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scans {
    /// As a unit test does, which counts its own.
    Counted,
    /// By its number, from 0.
    Numbered,
}

/// One sentence about who changed a variable last; `area` is where it lies.
pub(super) fn sentence(build: &Build, name: &str, area: Area, written: Option<Written>, scans: Scans) -> String {
    let Some(Written { place, scan, time_us }) = written else {
        return match area {
            Area::Input => format!("`{name}`: an input that no statement writes"),
            _ => format!("`{name}`: no statement has changed it"),
        };
    };
    let at = controller::line_at(build, place).map_or_else(
        || controller::place_text(build, place),
        |line| {
            let text: String = line.statement.chars().take(STATEMENT_MAX).collect();
            format!("{}:{} `{text}` ({})", line.file, line.number, controller::place_text(build, place))
        },
    );
    let when = match (scan, scans) {
        (0, _) => "before the first scan".to_owned(),
        (_, Scans::Counted) => format!("in the {} scan", ordinal(scan)),
        (_, Scans::Numbered) => format!("in scan {}", scan - 1),
    };
    let time = if time_us == 0 { String::new() } else { format!(", at {}", duration::show(Duration::from_micros(time_us))) };
    format!("`{name}` was changed last by {at}, {when}{time}")
}

/// `1st`, `2nd`, `11th`: a test counts its scans from one, a number of a scan begins with 0.
fn ordinal(number: u64) -> String {
    let ending = match (number % 10, number % 100) {
        (_, 11..=13) => "th",
        (1, _) => "st",
        (2, _) => "nd",
        (3, _) => "rd",
        _ => "th",
    };
    format!("{number}{ending}")
}

#[cfg(test)]
mod tests {
    use super::ordinal;

    #[test]
    fn scans_of_a_test_are_counted_in_words_of_english() {
        let all: Vec<String> = [1, 2, 3, 4, 11, 12, 13, 21, 22, 101, 111].into_iter().map(ordinal).collect();
        assert_eq!(all.join(" "), "1st 2nd 3rd 4th 11th 12th 13th 21st 22nd 101st 111th");
    }
}
