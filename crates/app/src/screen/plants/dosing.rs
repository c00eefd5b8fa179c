//! The dosing plant: supply tank, valve, flow meter and vessel below each other, the display at their right.

use ratatui::style::Color;

use super::canvas::{Canvas, cells};
use super::terminals;
use super::view::View;
use super::{Picture, Size, Sizes};

pub(super) const PICTURE: Picture =
    Picture { kind: "dosing", sizes: Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 20 } }, draw };

fn draw(canvas: &mut Canvas<'_>, view: &View<'_>) {
    let large = canvas.holds(PICTURE.sizes.best);
    let (supply, vessel, list) = if large { ((1, 1, 25, 7), (3, 11, 21, 8), 30) } else { ((1, 1, 13, 3), (3, 7, 9, 3), 16) };
    tank(canvas, view, supply, vessel);
    canvas.display(list, 0, view.word("display").cast_unsigned());
    let width = canvas.width().saturating_sub(list);
    if large {
        terminals::column(canvas, view, (list, 7, width), &[]);
        canvas.text(list, 13, &format!("flow      {:>7.2} l/s", view.state("flow")));
        canvas.text(list, 14, &format!("delivered {:>7.1} l", view.state("delivered")));
        canvas.text(list, 15, &format!("spilled   {:>7.1} l", view.state("spilled")));
        terminals::faults(canvas, view, (list, 17, width), 3);
    } else {
        terminals::named(canvas, view, (list, 5, width), "display");
        terminals::column(canvas, view, (list, 6, width), &["display"]);
        terminals::faults(canvas, view, (list, 10, width), 1);
    }
}

fn tank(canvas: &mut Canvas<'_>, view: &View<'_>, supply: super::canvas::Place, vessel: super::canvas::Place) {
    let water = canvas.colour(Color::Blue);
    let (x, top, width, rows) = supply;
    let pipe = x + width / 2;
    let (in_supply, in_vessel) = (view.state("supply"), view.state("vessel"));
    let (supply_litres, vessel_litres) = (view.parameter("supply").max(f64::MIN_POSITIVE), view.parameter("vessel").max(f64::MIN_POSITIVE));
    canvas.text(x, top - 1, &format!("╭{:─^1$}╮", format!(" {in_supply:.0} l "), width - 2));
    canvas.vessel(supply, in_supply / supply_litres);
    let floor = top + rows;
    canvas.text(x, floor, &format!("╰{0}┬─┬{0}╯", "─".repeat(width / 2 - 2)));

    let open = view.is_on("valve");
    let (valve, style) = if open { ("▶═◀", canvas.bold(Color::Green)) } else { ("▶│◀", canvas.faint()) };
    canvas.styled(pipe - 1, floor + 1, valve, style);
    canvas.faint_text(x, floor + 1, &view.address("valve"));
    if view.fails("valve") {
        canvas.styled(pipe + 2, floor + 1, "✗", canvas.bold(Color::Red));
    }
    canvas.text(pipe - 1, floor + 2, "│ │");
    canvas.faint_text(x, floor + 2, &view.address("flow"));
    if view.fails("flow") {
        canvas.styled(pipe, floor + 2, "✗", canvas.bold(Color::Red));
    } else {
        // The wheel of the flow meter turns a quarter with every half litre.
        canvas.wheel(pipe, floor + 2, view.state("delivered") * 2.0, ratatui::style::Style::new());
    }

    let (left, first, room, rows) = vessel;
    let level = in_vessel / vessel_litres;
    canvas.vessel(vessel, level);
    let flowing = view.state("flow") > 0.0;
    if flowing {
        for row in 0..rows - cells(level, rows) {
            canvas.styled(pipe, first + row, "┆", water);
        }
    }
    if flowing && level >= 1.0 {
        for row in 0..rows {
            canvas.styled(left - 1, first + row, "╎", water);
            canvas.styled(left + room, first + row, "╎", water);
        }
    }
    canvas.text(left, first + rows, &format!("╰{:─^1$}╯", format!(" {in_vessel:.0} l "), room - 2));
}
