//! The axis of a diagram: which moments lie where, and where its labels stand.

use std::ops::RangeInclusive;

use crate::trace::{Moment, Scans, Trace, TraceError};

/// What lies where: time in microseconds, or numbers of scans where time stood still.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// Whether positions are numbers of scans.
    pub(super) by_scan: bool,
    /// The first position.
    pub(super) start: u64,
    /// One behind the last: the last scan is as wide as the distance of two.
    pub(super) end: u64,
    /// The distance that all scans are multiples of; at least 1.
    pub(super) unit: u64,
    /// Whether a scan stands at every multiple of the unit.
    pub(super) regular: bool,
}

impl Axis {
    /// The axis of the scans of a range.
    pub(super) fn new(trace: &Trace, range: &RangeInclusive<u64>) -> Result<Self, TraceError> {
        let summary = trace.summary();
        let (mut first, mut last) = (summary.first, summary.last);
        if *range.start() > first.scan || *range.end() < last.scan {
            let mut seen: Option<(Moment, Moment)> = None;
            trace.visit(range, &mut |scans: &Scans<'_>| {
                seen = Some((seen.map_or(scans.first, |(first, _)| first), scans.last()));
                Ok(())
            })?;
            (first, last) = seen.unwrap_or((first, first));
        }
        // One scan has no distance to another.
        let by_scan = summary.stood_still || summary.scans == 1;
        let unit = if by_scan { 1 } else { summary.step_us.max(1) };
        let position = |moment: Moment| if by_scan { moment.scan } else { moment.time_us };
        let regular = by_scan || (summary.last.time_us - summary.first.time_us) / unit == summary.scans.saturating_sub(1);
        Ok(Self { by_scan, start: position(first), end: position(last).saturating_add(unit), unit, regular })
    }

    /// Where a moment lies.
    pub(super) fn position(&self, moment: Moment) -> u64 {
        if self.by_scan { moment.scan } else { moment.time_us }
    }

    /// The distance from the beginning to the end; at least 1.
    pub(super) fn span(&self) -> u64 {
        (self.end - self.start).max(1)
    }

    /// Where the first label stands.
    pub(super) fn first_label(&self, interval: u64) -> u64 {
        self.start.checked_next_multiple_of(interval).unwrap_or(u64::MAX)
    }

    /// A distance of labels: the least round one that is not below this one.
    pub(super) fn interval(&self, least: u64) -> u64 {
        if !self.by_scan && least > 10_000_000 {
            let minute = 60_000_000;
            let round = [minute / 4, minute / 2, minute, 2 * minute, 5 * minute, 10 * minute, 15 * minute, 30 * minute];
            let hour = 60 * minute;
            return round
                .into_iter()
                .find(|&round| round >= least)
                .unwrap_or_else(|| round_number(least.div_ceil(hour)).saturating_mul(hour));
        }
        round_number(least)
    }

    /// The unit of the labels that stand at such a distance: its name and how many positions it has.
    pub(super) fn label_unit(&self, interval: u64) -> (&'static str, u64) {
        const UNITS: [(&str, u64); 4] = [("h", 3_600_000_000), ("min", 60_000_000), ("s", 1_000_000), ("ms", 1000)];
        if self.by_scan {
            return ("scan", 1);
        }
        // Half a second reads well as 0.5 s beside 1 s.
        let half = |unit: u64| interval.is_multiple_of(unit / 2);
        UNITS.into_iter().find(|&(name, unit)| interval.is_multiple_of(unit) || name == "s" && half(unit)).unwrap_or(("µs", 1))
    }
}

/// The least of 1, 2, 5, 10, 20 … that is not below a number.
pub(super) fn round_number(least: u64) -> u64 {
    let mut power = 1_u64;
    loop {
        for digit in [1, 2, 5] {
            match power.checked_mul(digit) {
                Some(round) if round < least => {}
                Some(round) => return round,
                None => return u64::MAX,
            }
        }
        let Some(next) = power.checked_mul(10) else { return u64::MAX };
        power = next;
    }
}

/// A position in a unit of labels: `1.5`, `20`.
pub(super) fn label(position: u64, unit: u64) -> String {
    let (whole, rest) = (position / unit, position % unit);
    if rest == 0 {
        return whole.to_string();
    }
    // Units are 1 or have as many zeros as their fractions have digits, apart from minutes and hours, whose labels are whole.
    let digits = unit.ilog10() as usize;
    format!("{whole}.{}", format!("{rest:0digits$}").trim_end_matches('0'))
}

/// A time with its unit: `12.5 ms`, `3 s`.
pub(super) fn time(us: u64) -> String {
    match us {
        0 => "0 ms".to_owned(),
        1..1_000 => format!("{us} µs"),
        us if us < 1_000_000 || !us.is_multiple_of(1000) => format!("{} ms", label(us, 1000)),
        us => format!("{} s", label(us, 1_000_000)),
    }
}
