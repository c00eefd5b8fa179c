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

use crate::trace::Moment;

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
