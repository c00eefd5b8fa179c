//! The thermal process: an oven with its heater and fan, a thermometer, and where the temperature goes.

use ratatui::style::Color;

use super::canvas::{Canvas, cells};
use super::terminals;
use super::view::View;
use super::{Picture, Size, Sizes};
use crate::palette::Lit;

pub(super) const PICTURE: Picture =
    Picture { kind: "thermal", sizes: Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 18 } }, draw };

/// Kelvin per second below which the temperature stands.
const STANDS: f64 = 0.005;

fn draw(canvas: &mut Canvas<'_>, view: &View<'_>) {
    let large = canvas.holds(PICTURE.sizes.best);
    let (width, rows) = if large { (27, 11) } else { (21, 6) };
    let commanded = if view.is_on("heater") { 1.0 } else { view.part("power").clamp(0.0, 1.0) };
    oven(canvas, view, (width, rows), commanded);
    thermometer(canvas, view, (width + 2, 0, rows));

    let red = canvas.colour(Color::Red);
    let mut power = |x: usize, y: usize, word: &str, part: f64| {
        canvas.faint_text(x, y, word);
        canvas.bar((x + 6, y, if large { 20 } else { 9 }), part, red);
        canvas.text(x + if large { 26 } else { 15 }, y, &format!("{:.0}%", part * 100.0));
    };
    let arrived = view.state("power") / 100.0;
    let below = rows + 1;
    if large {
        power(0, below, "power", commanded);
        power(0, below + 1, "heat", arrived);
        let list = width + 11;
        terminals::column(canvas, view, (list, 0, canvas.width().saturating_sub(list)), &[]);
        terminals::faults(canvas, view, (0, below + 3, canvas.width()), 3);
        return;
    }
    power(0, rows, "power", commanded);
    power(20, rows, "heat", arrived);
    terminals::faults(canvas, view, (0, below, canvas.width()), 1);
    // The terminals stand below, two on a line.
    let half = canvas.width() / 2;
    for (index, signal) in view.signals().iter().enumerate() {
        terminals::line(canvas, view, (index % 2 * half, below + 1 + index / 2, half.saturating_sub(1)), signal);
    }
}

fn oven(canvas: &mut Canvas<'_>, view: &View<'_>, (width, rows): (usize, usize), commanded: f64) {
    let wall = |canvas: &mut Canvas<'_>, y: usize, left: &str, fill: &str, right: &str| {
        canvas.text(0, y, &format!("{left}{}{right}", fill.repeat(width - 2)));
    };
    wall(canvas, 0, "╭", "─", "╮");
    for row in 1..rows - 1 {
        wall(canvas, row, "│", " ", "│");
    }
    wall(canvas, rows - 1, "╰", "─", "╯");
    let middle = rows / 2 - 1;
    let trend = view.state("trend");
    let arrow = match trend {
        trend if trend > STANDS => "↗",
        trend if trend < -STANDS => "↘",
        _ => "→",
    };
    let temperature = format!("{:.1} °C {arrow}", view.state("temperature"));
    canvas.styled(width / 2 - 5, middle, &temperature, canvas.bold(Color::LightRed));
    canvas.faint_text(width / 2 - 5, middle + 1, &format!("{:+.1} K/min", trend * 60.0));
    // As much of the heater glows as there is power.
    let glowing = cells(commanded, width - 4);
    let wave = if view.flash() == Lit::On { "≋" } else { "≈" };
    canvas.faint_text(2, rows - 2, &"·".repeat(width - 4));
    canvas.styled(2, rows - 2, &wave.repeat(glowing), canvas.bold(Color::Red));
    let fan = width - 3;
    if view.is_on("fan") {
        let blades = ["✢", "✣", "✤", "✥"][(view.seconds() * 8.0) as usize % 4];
        canvas.styled(fan, 1, blades, canvas.bold(Color::Cyan));
    } else {
        canvas.faint_text(fan, 1, "○");
    }
    canvas.faint_text(fan.saturating_sub(4), 1, "fan");
    if view.signal("thermostat").is_some() && !view.is_on("thermostat") {
        canvas.styled(2, 1, "too hot!", canvas.bold(Color::Red));
    }
}

/// From the temperature around to the limit of the thermostat.
fn thermometer(canvas: &mut Canvas<'_>, view: &View<'_>, (x, y, rows): (usize, usize, usize)) {
    let (cold, hot) = (view.parameter("ambient"), view.parameter("limit"));
    let span = (hot - cold).max(1.0);
    canvas.vessel((x, y, 3, rows), (view.state("temperature") - cold) / span);
    canvas.faint_text(x + 3, y, &format!("{hot:.0}"));
    canvas.faint_text(x + 3, y + rows - 1, &format!("{cold:.0}"));
    if rows > 8 {
        canvas.faint_text(x + 3, y + rows / 2, &format!("{:.0}", f64::midpoint(cold, hot)));
    }
}
