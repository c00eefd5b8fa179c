//! Heat maps of a report: two parameters against each other, a cell for each pair of their values.

use std::fmt::Write as _;

use sieben_workspace::xml::escaped;

use super::Column;
use super::charts::{CELLS_MAX, Chart, LABELS_MAX, Ticks, WRITTEN, axis_number, chart, plot, with_digits};
use crate::campaign::said;

/// Digits of a number in a cell.
const CELL_DIGITS: usize = 3;

/// Two parameters whose values are a grid.
pub(super) struct Grid<'a> {
    across: (&'a Column, Vec<f64>),
    up: (&'a Column, Vec<f64>),
    /// The rows of the result in each cell, row by row from below.
    cells: Vec<Vec<usize>>,
}

impl<'a> Grid<'a> {
    /// The grid of two parameters; none if their values are not those of a grid, but drawn.
    pub(super) fn of(across: &'a Column, up: &'a Column) -> Option<Self> {
        let distinct = |column: &Column| {
            let mut values: Vec<f64> = column.values.iter().flatten().copied().collect();
            values.sort_by(f64::total_cmp);
            values.dedup();
            (2..=CELLS_MAX).contains(&values.len()).then_some(values)
        };
        let (xs, ys) = (distinct(across)?, distinct(up)?);
        let mut cells = vec![Vec::new(); xs.len() * ys.len()];
        for (row, (x, y)) in across.values.iter().zip(&up.values).enumerate() {
            let find = |values: &[f64], value: f64| values.binary_search_by(|known| known.total_cmp(&value)).ok();
            if let (Some(x), Some(y)) = (x.and_then(|x| find(&xs, x)), y.and_then(|y| find(&ys, y))) {
                cells[y * xs.len() + x].push(row);
            }
        }
        // Of drawn values most pairs come never.
        let filled = cells.iter().filter(|cell| !cell.is_empty()).count();
        (filled * 2 > cells.len()).then_some(Self { across: (across, xs), up: (up, ys), cells })
    }

    /// How many of the scenarios of each cell did not pass.
    pub(super) fn failures(&self, passed: &[bool]) -> Chart {
        let share = |rows: &[usize]| {
            let failed = rows.iter().filter(|&&row| !passed[row]).count();
            let part = failed as f64 / rows.len().max(1) as f64;
            (failed > 0).then(|| (0.25 + 0.75 * part, failed.to_string(), format!("{failed} of {} did not pass", rows.len())))
        };
        self.chart("where it did not pass".to_owned(), "fail", share)
    }

    /// The mean of a measure in each cell.
    pub(super) fn means(&self, measure: &Column) -> Option<Chart> {
        let mean = |rows: &[usize]| {
            let values: Vec<f64> = rows.iter().filter_map(|&row| measure.values[row]).collect();
            (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
        };
        let means: Vec<f64> = self.cells.iter().filter_map(|rows| mean(rows)).collect();
        let (least, most) = (means.iter().copied().reduce(f64::min)?, means.iter().copied().reduce(f64::max)?);
        let shown = |rows: &[usize]| {
            let mean = mean(rows)?;
            let part = if most > least { (mean - least) / (most - least) } else { 0.5 };
            let unit = measure.unit.as_ref().map_or_else(String::new, |unit| format!(" {unit}"));
            Some((
                0.08 + 0.6 * part,
                with_digits(mean, CELL_DIGITS),
                format!("mean {}{unit} of {}", said::number(mean), said::scenarios(rows.len() as u64)),
            ))
        };
        Some(self.chart(format!("{}: mean", measure.label()), "cell", shown))
    }

    /// A cell is as dark as it is said, with its number and what it means; one of which nothing is said is empty.
    fn chart(&self, title: String, class: &str, shown: impl Fn(&[usize]) -> Option<(f64, String, String)>) -> Chart {
        let ((across, xs), (up, ys)) = (&self.across, &self.up);
        let (wide, high) = plot();
        let (width, height) = ((wide.1 - wide.0) / xs.len() as f64, (high.0 - high.1) / ys.len() as f64);
        let mut inside = String::new();
        for (index, rows) in self.cells.iter().enumerate().filter(|(_, rows)| !rows.is_empty()) {
            let (column, line) = (index % xs.len(), index / xs.len());
            let (x, y) = (wide.0 + width * column as f64, high.0 - height * (line + 1) as f64);
            let at = format!("{} = {}, {} = {}", across.name, said::number(xs[column]), up.name, said::number(ys[line]));
            let (class, opacity, number, said) = match shown(rows) {
                Some((opacity, number, said)) => (class, opacity, number, said),
                None => ("none", 1.0, String::new(), format!("none of {}", said::scenarios(rows.len() as u64))),
            };
            let _ = write!(
                inside,
                "<rect class=\"{class}\" fill-opacity=\"{opacity:.2}\" x=\"{x:.1}\" y=\"{y:.1}\" width=\"{:.1}\" height=\"{:.1}\"><title>{}: {}</title></rect>",
                width - 1.0,
                height - 1.0,
                escaped(&at),
                escaped(&said)
            );
            if width >= WRITTEN.0 && height >= WRITTEN.1 && !number.is_empty() {
                let _ = write!(
                    inside,
                    "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\" pointer-events=\"none\">{}</text>",
                    x + width / 2.0,
                    y + height / 2.0 + 4.0,
                    escaped(&number)
                );
            }
        }
        let middle = |from: f64, size: f64, index: usize| from + size * (index as f64 + 0.5);
        let ticks = |values: &[f64], at: &dyn Fn(usize) -> f64| -> Ticks {
            let said = |&(index, _): &(usize, &f64)| values.len() <= LABELS_MAX || index == 0 || index + 1 == values.len();
            values.iter().enumerate().filter(said).map(|(index, &value)| (at(index), axis_number(value))).collect()
        };
        let columns = ticks(xs, &|index| middle(wide.0, width, index));
        let lines = ticks(ys, &|index| middle(high.0, -height, index) + 4.0);
        chart(title, (&across.label(), columns), (&up.label(), lines), &inside)
    }
}
