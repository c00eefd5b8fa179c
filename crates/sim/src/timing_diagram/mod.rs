//! Timing diagrams of traces, as text for terminals and as SVG.
//!
//! Nothing is drawn that was not recorded: a value holds until the scan that changed it, and where several changes fall into one column
//! or pixel, that place is marked instead of being drawn as one of them.

mod axis;
mod lanes;
mod svg;
mod text;

use std::ops::RangeInclusive;

pub use svg::svg;
pub use text::text;

use crate::names::{Sample, Shown};
use crate::trace::{Channel, Moment};

/// A moment that is pointed at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mark {
    /// Where.
    pub moment: Moment,
    /// What happened there.
    pub label: String,
}

/// What a diagram shows, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// The width: characters of text, or pixels of an SVG.
    pub width: usize,
    /// Draws text with the characters of ASCII only.
    pub ascii: bool,
    /// The scans that are shown, by their numbers; all if not said.
    pub window: Option<RangeInclusive<u64>>,
    /// Moments that are pointed at, beside that of the trigger.
    pub marks: Vec<Mark>,
    /// Times at which the values are written out, in microseconds.
    pub cursors_us: Vec<u64>,
}

/// The usual width of a terminal, in characters.
pub const TEXT_WIDTH: usize = 80;
/// The usual width of an SVG, in pixels.
pub const SVG_WIDTH: usize = 960;

/// Widths that are drawn: narrower ones have no room for a name, wider ones nobody sees.
pub const WIDTHS: RangeInclusive<usize> = 40..=4000;

impl Options {
    /// All of a trace, as text of the usual width.
    pub fn text() -> Self {
        Self { width: TEXT_WIDTH, ascii: false, window: None, marks: Vec::new(), cursors_us: Vec::new() }
    }

    /// All of a trace, as an SVG of the usual width.
    pub fn svg() -> Self {
        Self { width: SVG_WIDTH, ..Self::text() }
    }

    fn width(&self) -> usize {
        self.width.clamp(*WIDTHS.start(), *WIDTHS.end())
    }
}

/// A value as a diagram labels it: a REAL as people write it, `1.5`, everything else as everywhere.
fn shown(channel: &Channel, value: &Sample) -> String {
    match value.shown(&channel.kind) {
        Some(shown @ (Shown::Real(_) | Shown::LongReal(_) | Shown::TimeLeft(_) | Shown::Twofold { .. })) => shown.readable(),
        Some(shown) => shown.to_string(),
        None => "-".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::types::DataType;

    use super::*;
    use crate::names::Kind;

    #[test]
    fn a_real_is_labelled_as_people_write_it() {
        let channel = |data_type| Channel { name: "x".to_owned(), kind: Kind::Typed(data_type) };
        for (value, label) in
            [(0.0_f64, "0.0"), (1.0, "1.0"), (-12.5, "-12.5"), (999_999.5, "999999.5"), (1e6, "1.0e+006"), (1e-4, "1.0e-004")]
        {
            assert_eq!(shown(&channel(DataType::Real), &Sample::Bits(u64::from((value as f32).to_bits()))), label);
            assert_eq!(shown(&channel(DataType::LongReal), &Sample::Bits(value.to_bits())), label);
        }
        assert_eq!(shown(&channel(DataType::Int), &Sample::Bits(5)), "5");
        assert_eq!(shown(&channel(DataType::Real), &Sample::Bits(u64::from(f32::NAN.to_bits()))), "NaN");
    }
}
