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
const CELLS_MAX: usize = 60;

fn frame(title: &str, across: &str, up: &str, (x, y): ((f64, f64), (f64, f64)), inside: &str) -> String {
    let (width, height) = SIZE;
    let (left, bottom) = MARGIN;
    let label = |text: &str, x: f64, y: f64, anchor: &str| {
        format!("<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"{anchor}\">{}</text>", escaped(text))
    };
    let mut svg = format!("<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">", escaped(title));
    svg.push_str(inside);
    let _ = write!(svg, "<path class=\"axis\" d=\"M{left} 14V{0:.0}H{1:.0}\"/>", height - bottom, width - 10.0);
    svg.push_str(&label(&said::number(x.0), left, height - bottom + 14.0, "start"));
    svg.push_str(&label(&said::number(x.1), width - 10.0, height - bottom + 14.0, "end"));
    svg.push_str(&label(across, (left + width) / 2.0, height - 4.0, "middle"));
    svg.push_str(&label(&said::number(y.0), left - 4.0, height - bottom, "end"));
    svg.push_str(&label(&said::number(y.1), left - 4.0, 20.0, "end"));
    svg.push_str(&label(up, left + 4.0, 11.0, "start"));
    svg.push_str("</svg>");
    format!("<figure><figcaption>{}</figcaption>{svg}</figure>", escaped(title))
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

fn plot() -> ((f64, f64), (f64, f64)) {
    ((MARGIN.0, SIZE.0 - 10.0), (SIZE.1 - MARGIN.1, 14.0))
}

/// How often which values of a measure came.
pub(super) fn histogram(column: &Column, buckets: &[Bucket]) -> Option<String> {
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
    let ends = (bars.first()?.0, bars.last()?.1);
    let most = bars.iter().map(|&(.., count)| count).max()?;
    let (across, up) = plot();
    let mut inside = String::new();
    for (least, end, count) in bars.into_iter().filter(|&(.., count)| count > 0) {
        let (x, to) = (place(least, ends, across), place(end, ends, across));
        let y = place(count as f64, (0.0, most as f64), up);
        let _ = write!(
            inside,
            "<rect class=\"bar\" x=\"{x:.1}\" y=\"{y:.1}\" width=\"{:.1}\" height=\"{:.1}\"><title>{count}</title></rect>",
            (to - x - 0.5).max(1.0),
            up.0 - y
        );
    }
    Some(frame(&format!("{}: how often", column.name), &column.label(), "scenarios", (ends, (0.0, most as f64)), &inside))
}

/// A measure over a parameter, a point for each scenario.
pub(super) fn scatter(parameter: &Column, measure: &Column, passed: &[bool]) -> Option<String> {
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
    Some(frame(&format!("{} over {}", measure.name, parameter.name), &parameter.label(), &measure.label(), (x, y), &inside))
}

/// Two parameters against each other: how many of their scenarios did not pass.
pub(super) fn heat_map(across: &Column, up: &Column, passed: &[bool]) -> Option<String> {
    let distinct = |column: &Column| {
        let mut values: Vec<f64> = column.values.iter().flatten().copied().collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        (2..=CELLS_MAX).contains(&values.len()).then_some(values)
    };
    let (xs, ys) = (distinct(across)?, distinct(up)?);
    let mut cells = vec![(0_u32, 0_u32); xs.len() * ys.len()];
    for ((x, y), &passed) in across.values.iter().zip(&up.values).zip(passed) {
        let (Some(x), Some(y)) = (x, y) else { continue };
        let find = |values: &[f64], value: f64| values.binary_search_by(|known| known.total_cmp(&value)).ok();
        if let (Some(x), Some(y)) = (find(&xs, *x), find(&ys, *y)) {
            let (all, failed) = &mut cells[y * xs.len() + x];
            *all += 1;
            *failed += u32::from(!passed);
        }
    }
    let (wide, high) = plot();
    let (width, height) = ((wide.1 - wide.0) / xs.len() as f64, (high.0 - high.1) / ys.len() as f64);
    let mut inside = String::new();
    for (index, &(all, failed)) in cells.iter().enumerate().filter(|(_, cell)| cell.0 > 0) {
        let (x, y) = (index % xs.len(), index / xs.len());
        let share = f64::from(failed) / f64::from(all);
        let _ = write!(
            inside,
            "<rect class=\"{}\" fill-opacity=\"{:.2}\" x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\"><title>{} = {}, {} = {}: {failed} of {all} did not pass</title></rect>",
            if failed > 0 { "fail" } else { "pass" },
            if failed > 0 { 0.25 + 0.75 * share } else { 0.35 },
            wide.0 + width * x as f64,
            high.0 - height * (y + 1) as f64,
            width - 1.0,
            height - 1.0,
            escaped(&across.name),
            said::number(xs[x]),
            escaped(&up.name),
            said::number(ys[y]),
        );
    }
    let ends = |values: &[f64]| (values[0], values[values.len() - 1]);
    Some(frame("where it did not pass", &across.label(), &up.label(), (ends(&xs), ends(&ys)), &inside))
}
