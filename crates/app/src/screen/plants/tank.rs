//! The tank: level between its valves, float switches at its wall.

use ratatui::style::Color;

use super::canvas::{Canvas, cells};
use super::terminals;
use super::view::View;
use super::{Picture, Size, Sizes};

pub(super) const PICTURE: Picture =
    Picture { kind: "tank", sizes: Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 20 } }, draw };

fn draw(canvas: &mut Canvas<'_>, view: &View<'_>) {
    let large = canvas.holds(PICTURE.sizes.best);
    let (width, rows, list) = if large { (27, 15, 32) } else { (13, 6, 16) };
    let level = view.state("level") / 100.0;
    let inlet = view.known("inlet").map_or(0.0, |per_cent| per_cent / 100.0).max(view.part("inlet_valve"));
    let outlet = view.state("outlet") / 100.0;
    let pipe = width / 2;

    valve(canvas, (pipe - 1, 0), inlet);
    canvas.text(0, 0, &"═".repeat(pipe - 1));
    canvas.vessel((0, 1, width, rows), level);
    let water = canvas.colour(Color::Blue);
    if inlet > 0.0 {
        for row in 0..rows - cells(level, rows) {
            canvas.styled(pipe, 1 + row, "┆", water);
        }
    }
    let floor = rows + 1;
    canvas.text(0, floor, &format!("╰{0}┬─┬{0}╯", "─".repeat(pipe - 2)));
    valve(canvas, (pipe - 1, floor + 1), outlet);
    canvas.styled(pipe, floor + 2, if outlet > 0.0 && level > 0.0 { "┆" } else { " " }, water);
    if level >= 1.0 && inlet > 0.0 {
        for row in 0..rows {
            canvas.styled(width + 1, 1 + row, "╎", water);
        }
    }
    // The floats hang where they switch: at 98, 90 and 10 per cent.
    let row_of = |part: f64| 1 + (rows - 1).saturating_sub(cells(part, rows - 1));
    let floats = [("overflow", 1), ("high", row_of(0.9).max(2)), ("low", row_of(0.1))];
    for (name, row) in floats {
        canvas.lamp(width, row, view.lit(name), Color::Green);
    }

    terminals::column(canvas, view, (list, 0, canvas.width().saturating_sub(list)), &[]);
    let below = view.signals().len();
    let content = format!("{:.0} of {:.0} l, {:.0} %", view.state("content"), view.parameter("volume"), level * 100.0);
    canvas.text(list, below, &content);
    if view.state("spilled") > 0.0 {
        canvas.styled(0, floor + 1, &format!("✗{:.0} l", view.state("spilled")), canvas.colour(Color::Red));
    }
    if large {
        canvas.bar((list, below + 1, 28), level, water);
        if view.state("spilled") > 0.0 {
            canvas.text(list, below + 2, &format!("spilled {:.0} l", view.state("spilled")));
        }
        terminals::faults(canvas, view, (list, below + 4, 28), 5);
    } else {
        terminals::faults(canvas, view, (0, 10, canvas.width()), 1);
    }
}

/// A valve in a pipe and how far it is open.
fn valve(canvas: &mut Canvas<'_>, (x, y): (usize, usize), open: f64) {
    let (glyph, style) = match cells(open, 100) {
        0 => ("▶│◀", canvas.faint()),
        99..=100 => ("▶═◀", canvas.bold(Color::Green)),
        _ => ("▶╪◀", canvas.bold(Color::Yellow)),
    };
    canvas.styled(x, y, glyph, style);
    canvas.text(x + 3, y, &format!(" {:.0}%", open * 100.0));
}
