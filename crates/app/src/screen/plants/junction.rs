//! The junction: columns of lamps, and the two roads with cars and pedestrians that wait or go across.

use ratatui::style::Color;

use super::canvas::{Canvas, cells};
use super::terminals;
use super::view::View;
use super::{Picture, Size, Sizes};

pub(super) const PICTURE: Picture =
    Picture { kind: "junction", sizes: Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 19 } }, draw };

/// The terminals of the main road, the side road and the pedestrians, with words for narrow columns.
const COLUMNS: [(&str, &[(&str, &str)]); 3] = [
    ("main road", &[("main_red", "red"), ("main_yellow", "yel"), ("main_green", "grn"), ("main_car", "car"), ("main_red_lit", "lit")]),
    ("side road", &[("side_red", "red"), ("side_yellow", "yel"), ("side_green", "grn"), ("side_car", "car"), ("side_red_lit", "lit")]),
    ("pedestrians", &[("walk_red", "red"), ("walk_green", "grn"), ("request", "req"), ("button", "btn")]),
];

fn draw(canvas: &mut Canvas<'_>, view: &View<'_>) {
    let large = canvas.holds(PICTURE.sizes.best);
    let width = canvas.width() / 3;
    for (index, (head, names)) in COLUMNS.into_iter().enumerate() {
        let x = index * width;
        canvas.text(x, 0, head);
        for (row, &(name, word)) in names.iter().enumerate() {
            let place = (x, 1 + row, width.saturating_sub(1));
            match large {
                true => terminals::named(canvas, view, place, name),
                false => terminals::called(canvas, view, place, (name, word)),
            }
        }
    }
    let roads = if large {
        Roads { top: 7, crossing: 34, right: 60, lanes: 3, side_rows: 5 }
    } else {
        Roads { top: 6, crossing: 20, right: 40, lanes: 1, side_rows: 2 }
    };
    roads.draw(canvas, view);
    let last = roads.top + roads.lanes + 1 + roads.side_rows;
    let conflict = view.state("conflict");
    if conflict > 0.0 {
        canvas.styled(0, if large { last + 1 } else { 5 }, &format!("✗ conflict for {conflict:.2} s"), canvas.bold(Color::Red));
    }
    let (y, rows) = if large { (last + 2, 2) } else { (last, 1) };
    terminals::faults(canvas, view, (0, y, canvas.width()), rows);
}

/// Where the roads run.
struct Roads {
    /// The upper edge of the main road.
    top: usize,
    /// Where pedestrians cross it.
    crossing: usize,
    /// Where it ends.
    right: usize,
    /// Rows of the main road.
    lanes: usize,
    /// Rows of the side road.
    side_rows: usize,
}

impl Roads {
    fn draw(&self, canvas: &mut Canvas<'_>, view: &View<'_>) {
        let &Self { top, crossing, right, lanes, side_rows } = self;
        let lower = top + lanes + 1;
        let lane = top + lanes.div_ceil(2);
        let (west, east) = (crossing + 3, crossing + 7);
        let edge = "─".repeat(crossing);
        let rest = "─".repeat(right - east - 1);
        canvas.text(0, top, &format!("{edge}  ─╯   ╰{rest}"));
        canvas.text(0, lower, &format!("{edge}  ─╮   ╭{rest}"));
        for row in 0..lanes + 2 {
            canvas.faint_text(crossing, top + row, "╫╫");
        }
        for row in 0..side_rows {
            canvas.text(west, lower + 1 + row, "│   │");
        }

        let car = canvas.bold(Color::Cyan);
        let waiting = |name: &str| view.state(name).clamp(0.0, 1e6) as usize;
        for index in 0..waiting("main_queue").min(crossing / 2) {
            canvas.styled(crossing - 2 - index * 2, lane, "▬", car);
        }
        if let Some(part) = going(view, "main_crossing") {
            canvas.styled(crossing + cells(part, right - crossing - 1), lane, "▬", car);
        }
        for index in 0..waiting("side_queue").min(side_rows) {
            canvas.styled(west + 2, lower + 1 + index, "▮", car);
        }
        if let Some(part) = going(view, "side_crossing") {
            canvas.styled(west + 2, lower - cells(part, lanes + 1), "▮", car);
        }
        let people = canvas.bold(Color::Magenta);
        let walkers = waiting("walkers");
        if walkers > 0 {
            canvas.styled(crossing, lower + 1, "i", people);
            canvas.text(crossing - 3, lower + 1, &format!("{walkers:>2}"));
        }
        if let Some(part) = going(view, "walk_crossing") {
            canvas.styled(crossing, lower - cells(part, lanes + 1), "i", people);
        }
        for (x, below, count, word) in [
            (0, 1, waiting("main_queue"), "wait"),
            (0, 2, waiting("main_passed"), "passed"),
            (east + 2, 1, waiting("side_queue"), "wait"),
            (east + 2, 2, waiting("side_passed"), "passed"),
            (crossing - 9, 2, waiting("walk_passed"), "walked"),
        ] {
            canvas.faint_text(x, lower + below, &format!("{count} {word}"));
        }
    }
}

/// How far those who started last have come, if they are not across.
fn going(view: &View<'_>, name: &str) -> Option<f64> {
    view.known(name).filter(|&per_cent| per_cent > 0.0).map(|per_cent| per_cent / 100.0)
}
