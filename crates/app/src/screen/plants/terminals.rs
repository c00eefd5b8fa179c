//! Terminals of a plant in a picture, one line each: address, state, symbol.

use ratatui::style::Color;
use sieben_sim::devices::{Place, Signal};

use super::canvas::Canvas;
use super::view::View;
use crate::palette::Lit;
use crate::screen::columns::{fitted, padded};

/// Lines of terminals in a column of so many cells: what the table of the kind has, without those that the picture shows elsewhere.
pub(super) fn column(canvas: &mut Canvas<'_>, view: &View<'_>, (x, y, width): (usize, usize, usize), without: &[&str]) {
    let shown = view.signals().iter().filter(|signal| !without.contains(&signal.name));
    for (row, signal) in shown.enumerate() {
        line(canvas, view, (x, y + row, width), signal);
    }
}

/// A terminal by its name.
pub(super) fn named(canvas: &mut Canvas<'_>, view: &View<'_>, place: (usize, usize, usize), name: &str) {
    if let Some(signal) = view.signal(name) {
        line(canvas, view, place, signal);
    }
}

/// A terminal by its name, with a word that is short enough for a narrow column.
pub(super) fn called(canvas: &mut Canvas<'_>, view: &View<'_>, place: (usize, usize, usize), (name, word): (&str, &str)) {
    if let Some(signal) = view.signal(name) {
        labelled(canvas, view, place, (signal, word));
    }
}

/// A terminal: `I 0.0 ● START`, with `✗` before the symbol while it has a fault.
pub(super) fn line(canvas: &mut Canvas<'_>, view: &View<'_>, place: (usize, usize, usize), signal: &Signal) {
    labelled(canvas, view, place, (signal, view.label(signal)));
}

fn labelled(canvas: &mut Canvas<'_>, view: &View<'_>, (x, y, width): (usize, usize, usize), (signal, label): (&Signal, &str)) {
    let fails = view.fails(signal.name);
    let value = match signal.place {
        Place::Bit(..) => String::new(),
        Place::Word(_) if signal.unit == "BCD" => format!("{:04X}", view.raw(signal)),
        Place::Word(_) => {
            let decimals = usize::from(signal.per_unit > 1.0);
            let value = f64::from(view.raw(signal)) / signal.per_unit;
            format!("{value:.decimals$}{}{}", if signal.unit == "%" { "" } else { " " }, signal.unit)
        }
    };
    let text = format!("{}{}", view.address_of(signal), if value.is_empty() { "" } else { " " });
    canvas.text(x, y, &fitted(&text, width));
    let mut at = x + text.chars().count().max(view.address_width() + 1);
    match signal.place {
        Place::Bit(..) => {
            canvas.lamp(at, y, Lit::when(view.raw(signal) != 0), lamp_colour(signal));
            at += 1;
        }
        Place::Word(_) => {
            canvas.text(at, y, &value);
            at += value.chars().count();
        }
    }
    canvas.styled(at, y, if fails { "✗" } else { " " }, canvas.bold(Color::Red));
    let room = (x + width).saturating_sub(at + 1);
    let style = if fails { canvas.colour(Color::Red) } else { canvas.faint() };
    canvas.styled(at + 1, y, &fitted(label, room), style);
}

/// Lamps have the colour of their glass.
fn lamp_colour(signal: &Signal) -> Color {
    match signal.name.rsplit_once('_').map_or("", |name| name.1) {
        "red" | "alarm" => Color::Red,
        "yellow" => Color::Yellow,
        _ => Color::Green,
    }
}

/// The faults of a plant, one line each, up to so many; the last line says how many there are besides.
pub(super) fn faults(canvas: &mut Canvas<'_>, view: &View<'_>, (x, y, width): (usize, usize, usize), most: usize) {
    let all = view.faults();
    let style = canvas.bold(Color::Red);
    for (row, fault) in all.iter().take(most).enumerate() {
        let more = if row + 1 == most && all.len() > most { format!(" and {} more", all.len() - most) } else { String::new() };
        let room = width.saturating_sub(2 + more.len());
        let text = format!("✗ {}{more}", fitted(fault, room));
        // Whatever stood there makes room.
        canvas.styled(x, y + row, &padded(&text, width), style);
    }
}
