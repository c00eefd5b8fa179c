//! Where the panels of the screen stand, for every size of a terminal.

use ratatui::layout::Constraint::{self, Fill, Length};
use ratatui::layout::{Layout, Rect};

use super::MIN_WIDTH;
use crate::screen::plants::Sizes;
use crate::screen::state::Part;

/// A panel of the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Panel {
    Plant,
    Signals,
    Program,
    Values,
    Changes,
    Diagnostics,
    Run,
}

impl From<Part> for Panel {
    fn from(part: Part) -> Self {
        match part {
            Part::Program => Self::Program,
            Part::Values => Self::Values,
            Part::Changes => Self::Changes,
            Part::Diagnostics => Self::Diagnostics,
            Part::Run => Self::Run,
        }
    }
}

/// From this width on the program stands in a column of its own.
const WIDE: u16 = 120;
/// From this width on there are four columns.
const WIDEST: u16 = 180;
/// From this height on a narrow screen has room for the program and one thing more.
const HIGH: u16 = 26;
/// Frame of a panel, both sides.
const FRAME: u16 = 2;
/// The column of inputs, outputs and values on wide screens.
const SIGNALS_WIDTH: u16 = 38;
/// The column of the plant on narrow screens.
const PLANT_WIDTH: u16 = 42;
/// Rows that inputs and outputs have at least below a plant.
const SIGNALS_HEIGHT: u16 = 9;
/// Rows of the panel of the run.
const RUN_HEIGHT: u16 = 10;

fn rows<const N: usize>(area: Rect, heights: [Constraint; N]) -> [Rect; N] {
    Layout::vertical(heights).areas(area)
}

fn columns<const N: usize>(area: Rect, widths: [Constraint; N]) -> [Rect; N] {
    Layout::horizontal(widths).areas(area)
}

/// The panels with their places; `plant` is what the picture of the plant takes, `part` what the changing part shows.
pub(super) fn panels(area: Rect, plant: Option<Sizes>, part: Part) -> Vec<(Panel, Rect)> {
    match area.width {
        WIDEST.. => four_columns(area, plant),
        WIDE.. => three_columns(area, plant, part),
        _ => two_columns(area, plant, part),
    }
}

/// How high the panel of a plant is in a column of this height of which others want so much.
fn plant_height(sizes: Sizes, column: u16, others: u16) -> u16 {
    (sizes.best.height + FRAME).min(column.saturating_sub(others)).max((sizes.least.height + FRAME).min(column))
}

/// Plant, inputs and outputs on the left; the rest on the right, one part at a time, or the program and one part.
fn two_columns(area: Rect, plant: Option<Sizes>, part: Part) -> Vec<(Panel, Rect)> {
    let left_width = if plant.is_some() { PLANT_WIDTH + area.width.saturating_sub(MIN_WIDTH) / 4 } else { PLANT_WIDTH };
    let [left, right] = columns(area, [Length(left_width), Fill(1)]);
    let mut panels = match plant {
        None => vec![(Panel::Signals, left)],
        Some(sizes) => {
            let [plant, signals] = rows(left, [Length(plant_height(sizes, left.height, SIGNALS_HEIGHT.max(left.height / 3))), Fill(1)]);
            vec![(Panel::Plant, plant), (Panel::Signals, signals)]
        }
    };
    if right.height < HIGH {
        panels.push((part.into(), right));
    } else {
        let lower = if part == Part::Program { Panel::Changes } else { part.into() };
        let [program, below] = rows(right, [Fill(3), Fill(2)]);
        panels.extend([(Panel::Program, program), (lower, below)]);
    }
    panels
}

/// A column with the plant, if there is one, and below it what changed.
fn plant_and_changes(column: Rect, plant: Option<Sizes>) -> Vec<(Panel, Rect)> {
    let Some(sizes) = plant else { return vec![(Panel::Changes, column)] };
    let [plant, changes] = rows(column, [Length(plant_height(sizes, column.height, column.height / 3)), Fill(1)]);
    vec![(Panel::Plant, plant), (Panel::Changes, changes)]
}

/// Plant and changes; inputs, outputs and values; the program and one part.
fn three_columns(area: Rect, plant: Option<Sizes>, part: Part) -> Vec<(Panel, Rect)> {
    let [left, middle, right] = columns(area, [Length(PLANT_WIDTH + (area.width - WIDE) / 4), Length(SIGNALS_WIDTH), Fill(1)]);
    let lower = if matches!(part, Part::Program | Part::Values | Part::Changes) { Panel::Diagnostics } else { part.into() };
    let mut panels = plant_and_changes(left, plant);
    let [signals, values] = rows(middle, [Fill(3), Fill(2)]);
    let [program, below] = rows(right, [Fill(2), Fill(1)]);
    panels.extend([(Panel::Signals, signals), (Panel::Values, values), (Panel::Program, program), (lower, below)]);
    panels
}

/// Plant and changes; inputs and outputs; the program; run, values and diagnostics.
fn four_columns(area: Rect, plant: Option<Sizes>) -> Vec<(Panel, Rect)> {
    let spare = area.width - WIDEST;
    let plant_width = plant.map_or(PLANT_WIDTH + spare / 2, |sizes| (sizes.best.width + FRAME).min(PLANT_WIDTH + spare / 2));
    let widths = [Length(plant_width), Length(SIGNALS_WIDTH), Fill(3), Fill(2)];
    let [left, signals, program, right] = columns(area, widths);
    let mut panels = plant_and_changes(left, plant);
    let [run, values, diagnostics] = rows(right, [Length(RUN_HEIGHT.min(right.height / 3)), Fill(3), Fill(2)]);
    panels.extend([
        (Panel::Signals, signals),
        (Panel::Program, program),
        (Panel::Run, run),
        (Panel::Values, values),
        (Panel::Diagnostics, diagnostics),
    ]);
    panels
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::screen::plants::Size;

    #[test]
    fn panels_cover_the_area_and_no_two_of_them_the_same_cell() {
        let sizes = Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 22 } };
        for (width, height) in [(80, 22), (100, 28), (119, 26), (120, 30), (159, 40), (160, 24), (200, 48), (300, 100)] {
            for plant in [None, Some(sizes)] {
                for part in [Part::Program, Part::Values, Part::Changes, Part::Diagnostics, Part::Run] {
                    let area = Rect::new(0, 1, width, height);
                    let panels = panels(area, plant, part);
                    let cells: u32 = panels.iter().map(|(_, rect)| rect.area()).sum();
                    assert_eq!(cells, area.area(), "{width} × {height} {part:?}");
                    for (at, (_, one)) in panels.iter().enumerate() {
                        assert!(
                            panels[at + 1..].iter().all(|(_, other)| one.intersection(*other).is_empty()),
                            "{width} × {height} {panels:?}"
                        );
                    }
                    if let (Some(sizes), Some((_, rect))) = (plant, panels.iter().find(|(panel, _)| *panel == Panel::Plant)) {
                        assert!(rect.width >= sizes.least.width + FRAME && rect.height >= sizes.least.height + FRAME, "{width} × {height}");
                    }
                }
            }
        }
    }
}
