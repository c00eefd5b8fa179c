//! Charts of a report as SVG.

use std::fmt::Write as _;

use sieben_campaign::histogram::Bucket;
use sieben_workspace::xml::escaped;

use super::Column;
use crate::campaign::said;

/// Width and height of a chart, and of its margins.
const SIZE: (f64, f64) = (460.0, 260.0);
const MARGIN: (f64, f64) = (64.0, 36.0);
/// Points of a scatter chart; of more every so many is drawn.
const POINTS_MAX: usize = 4_000;
/// Bars of a histogram.
const BARS: usize = 40;
/// Values of a parameter that a heat map has rows or columns for.
pub(super) const CELLS_MAX: usize = 60;
/// Rows or columns of a heat map that are labelled each; of more the first and the last are.
pub(super) const LABELS_MAX: usize = 12;
/// A cell of this size or larger has its value written in it.
pub(super) const WRITTEN: (f64, f64) = (34.0, 16.0);

/// How the parts of a chart look, in the page and in a file of its own.
pub(super) const STYLE: &str = ".fail{fill:#c2372e;color:#c2372e}.pass,.bar,.cell{fill:#2f6f9f}.none{fill:none;stroke:currentColor;stroke-opacity:.2}\
.axis{fill:none;stroke:currentColor;stroke-opacity:.5}svg text{font:11px system-ui,sans-serif;fill:currentColor}";
/// The same where the reader prefers it dark.
pub(super) const DARK: &str = ".fail{fill:#ff7a70;color:#ff7a70}.pass,.bar,.cell{fill:#6db3e8}";

/// A chart.
pub(super) struct Chart {
    /// What it shows.
    pub(super) title: String,
    /// What is drawn.
    inside: String,
}

impl Chart {
    /// As an element of the page, which has the style.
    pub(super) fn figure(&self) -> String {
        let title = escaped(&self.title);
        let (width, height) = SIZE;
        let svg = format!("<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{title}\">{}</svg>", self.inside);
        format!("<figure><figcaption>{title}</figcaption>{svg}</figure>")
    }

    /// As a file.
    pub(super) fn file(&self) -> String {
        let (width, height) = SIZE;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\">\n\
             <title>{}</title>\n<style>svg{{color:#1c2430;background:#fff}}{STYLE}@media(prefers-color-scheme:dark){{svg{{color:#dde3ea;background:#14181d}}{DARK}}}</style>\n{}\n</svg>\n",
            escaped(&self.title),
            self.inside.replace("><rect", ">\n<rect").replace("><circle", ">\n<circle").replace("><path", ">\n<path")
        )
    }
}

/// What stands at an axis: each text with its place.
pub(super) type Ticks = Vec<(f64, String)>;

fn text(text: &str, x: f64, y: f64, anchor: &str) -> String {
    format!("<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"{anchor}\">{}</text>", escaped(text))
}

/// Both ends of an axis.
fn ends((least, most): (f64, f64), (from, to): (f64, f64)) -> Ticks {
    vec![(from, axis_number(least)), (to, axis_number(most))]
}

/// A number as an axis has it: four digits say where a point is.
pub(super) fn axis_number(value: f64) -> String {
    with_digits(value, 4)
}

/// A number with so many digits at most.
pub(super) fn with_digits(value: f64, digits: usize) -> String {
    said::number(format!("{value:.*e}", digits - 1).parse().unwrap_or(value))
}

pub(super) fn chart(title: String, across: (&str, Ticks), up: (&str, Ticks), inside: &str) -> Chart {
    let (width, height) = SIZE;
    let (left, bottom) = MARGIN;
    let mut all = inside.to_owned();
    let _ = write!(all, "<path class=\"axis\" d=\"M{left} 14V{0:.0}H{1:.0}\"/>", height - bottom, width - 10.0);
    let right = width - 10.0;
    for (x, label) in across.1 {
        let anchor = if x <= left {
            "start"
        } else if x >= right {
            "end"
        } else {
            "middle"
        };
        all.push_str(&text(&label, x, height - bottom + 14.0, anchor));
    }
    for (y, label) in up.1 {
        all.push_str(&text(&label, left - 4.0, y.clamp(20.0, height - bottom), "end"));
    }
    all.push_str(&text(across.0, (left + width) / 2.0, height - 4.0, "middle"));
    all.push_str(&text(up.0, left + 4.0, 11.0, "start"));
    Chart { title, inside: all }
}

fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
    (least <= most).then_some((least, most))
}

/// A value as a place between two ends.
fn place(value: f64, (least, most): (f64, f64), (from, to): (f64, f64)) -> f64 {
    let part = if most > least { (value - least) / (most - least) } else { 0.5 };
    from + part * (to - from)
}

pub(super) fn plot() -> ((f64, f64), (f64, f64)) {
    ((MARGIN.0, SIZE.0 - 10.0), (SIZE.1 - MARGIN.1, 14.0))
}

/// How often which values of a measure came.
pub(super) fn histogram(column: &Column, buckets: &[Bucket]) -> Option<Chart> {
    let values: Vec<f64> = column.values.iter().flatten().copied().collect();
    let counted: u64 = buckets.iter().map(|bucket| bucket.count).sum();
    let bars: Vec<(f64, f64, u64)> = if values.len() as u64 == counted {
        // All values are there: bars of the same width.
        let (least, most) = extent(values.iter().copied())?;
        let width = (most - least) / BARS as f64;
        let mut counts = [0_u64; BARS];
        for value in values {
            // Conversions of floats saturate.
            let bar = if width > 0.0 { ((value - least) / width) as usize } else { 0 };
            counts[bar.min(BARS - 1)] += 1;
        }
        let width = if width > 0.0 { width } else { 1.0 / BARS as f64 };
        counts.iter().enumerate().map(|(bar, &count)| (least + width * bar as f64, least + width * (bar + 1) as f64, count)).collect()
    } else {
        buckets.iter().map(|bucket| (bucket.least, bucket.most, bucket.count)).collect()
    };
    let extent = (bars.first()?.0, bars.last()?.1);
    let most = bars.iter().map(|&(.., count)| count).max()?;
    let (across, up) = plot();
    let mut inside = String::new();
    for (least, end, count) in bars.into_iter().filter(|&(.., count)| count > 0) {
        let (x, to) = (place(least, extent, across), place(end, extent, across));
        let y = place(count as f64, (0.0, most as f64), up);
        let _ = write!(
            inside,
            "<rect class=\"bar\" x=\"{x:.1}\" y=\"{y:.1}\" width=\"{:.1}\" height=\"{:.1}\"><title>{count}</title></rect>",
            (to - x - 0.5).max(1.0),
            up.0 - y
        );
    }
    let title = format!("{}: how often", column.name);
    Some(chart(title, (&column.label(), ends(extent, across)), ("scenarios", ends((0.0, most as f64), up)), &inside))
}

/// A measure over a parameter, a point for each scenario.
pub(super) fn scatter(parameter: &Column, measure: &Column, passed: &[bool]) -> Option<Chart> {
    let all: Vec<(f64, f64, bool)> =
        parameter.values.iter().zip(&measure.values).zip(passed).filter_map(|((x, y), &passed)| Some(((*x)?, (*y)?, passed))).collect();
    let (x, y) = (extent(all.iter().map(|point| point.0))?, extent(all.iter().map(|point| point.1))?);
    if x.0 == x.1 {
        return None;
    }
    let (across, up) = plot();
    let step = all.len().div_ceil(POINTS_MAX).max(1);
    let mut inside = String::new();
    // What failed lies on top.
    for wanted in [true, false] {
        for (px, py, _) in all.iter().step_by(step).filter(|point| point.2 == wanted) {
            let class = if wanted { "pass" } else { "fail" };
            let _ =
                write!(inside, "<circle class=\"{class}\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"2.2\"/>", place(*px, x, across), place(*py, y, up));
        }
    }
    let title = format!("{} over {}", measure.name, parameter.name);
    Some(chart(title, (&parameter.label(), ends(x, across)), (&measure.label(), ends(y, up)), &inside))
}
