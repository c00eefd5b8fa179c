//! The conveyor: the belt with its parts, light barriers over it, what was delivered and what fell off.

use ratatui::style::Color;
use sieben_sim::devices::Signal;
use sieben_sim::devices::conveyor::{PART, PART_PLACES};

use super::canvas::Canvas;
use super::terminals;
use super::view::View;
use super::{Picture, Size, Sizes};
use crate::palette::Lit;

pub(super) const PICTURE: Picture =
    Picture { kind: "conveyor", sizes: Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 15 } }, draw };

/// Cells between two marks on the belt.
const MARKS: usize = 4;

fn draw(canvas: &mut Canvas<'_>, view: &View<'_>) {
    let large = canvas.holds(PICTURE.sizes.best);
    let (columns, thickness) = if large { (54, 2) } else { (34, 1) };
    // The left end is over the first cell of the belt, the right end over the last one.
    let (first, last) = (3, columns + 1);
    let length = view.parameter("length").max(PART);
    let per_metre = (last - first) as f64 / length;
    let column = |metres: f64| first as f64 + metres * per_metre;

    terminals::faults(canvas, view, (0, 0, canvas.width()), 1);
    for (name, at) in [("left_end", 0.0), ("middle", length / 2.0), ("right_end", length)] {
        let x = column(at).round() as usize;
        canvas.lamp(x, 1, view.lit(name), Color::Green);
        canvas.faint_text(x, 2, if view.is_on(name) { "╵" } else { "┊" });
    }
    if view.is_on("horn") {
        let note = if view.flash() == Lit::On { "♪" } else { "♫" };
        canvas.styled(canvas.width().saturating_sub(8), 2, &format!("horn {note}"), canvas.bold(Color::Yellow));
    }

    let belt = 3 + thickness;
    let width = ((PART * per_metre) as usize).clamp(1, columns);
    for at in PART_PLACES.into_iter().filter_map(|name| view.known(name)) {
        let left = (column(at - PART / 2.0).round().clamp(0.0, 200.0) as usize).max(1);
        for row in 3..belt {
            canvas.styled(left, row, &"█".repeat(width), canvas.colour(Color::Yellow));
        }
    }
    let velocity = view.state("velocity");
    let moved = (view.seconds() * velocity * per_metre).rem_euclid(MARKS as f64) as usize;
    let mark = if velocity > 0.0 { '›' } else { '‹' };
    let on_belt = |cell: usize| if velocity != 0.0 && cell % MARKS == moved { mark } else { '═' };
    canvas.text(2, belt, &(0..columns).map(on_belt).collect::<String>());
    let turned = view.seconds() * velocity * 4.0 / length;
    for x in [1, columns + 2] {
        canvas.wheel(x, belt, turned.rem_euclid(4.0), canvas.colour(Color::Cyan));
    }

    let below = belt + 1;
    let way = if velocity > 0.0 { " ►" } else { "" };
    let other_way = if velocity < 0.0 { "◄ " } else { "" };
    canvas.text(columns / 2 - 4, below, &format!("{other_way}{:.2} m/s{way}", velocity.abs()));
    canvas.faint_text(1, below, &format!("↓{:.0} fell off", view.state("dropped")));
    let delivered = format!("{:.0} delivered", view.state("delivered"));
    canvas.text((columns + 3).saturating_sub(delivered.len()), below, &delivered);
    let hidden = view.state("parts") - PART_PLACES.len() as f64;
    if hidden > 0.0 {
        canvas.faint_text(1, 1, &format!("+{hidden:.0}"));
    }

    let top = below + 1;
    let half = canvas.width() / 2;
    let (inputs, outputs): (Vec<&Signal>, Vec<&Signal>) = view.signals().iter().partition(|signal| signal.is_input());
    // The scale stands at the head of the shorter column.
    let (weight, bits): (Vec<&Signal>, Vec<&Signal>) = inputs.into_iter().partition(|signal| signal.name == "weight");
    for (x, column) in [(0, bits), (half, outputs.into_iter().chain(weight).collect::<Vec<_>>())] {
        for (row, signal) in column.into_iter().enumerate() {
            terminals::line(canvas, view, (x, top + row, half.saturating_sub(1)), signal);
        }
    }
}
