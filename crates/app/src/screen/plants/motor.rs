//! The motor: three lines through contactors and overload relay, star and delta, speed and current as bars.

use ratatui::style::{Color, Style};

use super::canvas::Canvas;
use super::terminals;
use super::view::View;
use super::{Picture, Size, Sizes};
use crate::palette::Lit;
use crate::screen::columns::fitted;

pub(super) const PICTURE: Picture =
    Picture { kind: "motor", sizes: Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 16 } }, draw };

/// Where the three lines run.
const LINES: [usize; 3] = [5, 8, 11];

fn draw(canvas: &mut Canvas<'_>, view: &View<'_>) {
    let large = canvas.holds(PICTURE.sizes.best);
    let list = if large { 22 } else { 16 };
    let room = canvas.width().saturating_sub(list);
    circuit(canvas, view, if large { 2 } else { 1 });

    // A contactor has a coil and an auxiliary contact, which stand on one line.
    let address = view.address_width() + 1;
    for (row, (coil, contact)) in [("line", "line_on"), ("star", "star_on"), ("delta", "delta_on")].into_iter().enumerate() {
        let mut x = list;
        for name in [coil, contact] {
            canvas.text(x, row, &view.address(name));
            canvas.lamp(x + address, row, view.lit(name), Color::Green);
            canvas.styled(x + address + 1, row, if view.fails(name) { "✗" } else { " " }, canvas.bold(Color::Red));
            x += address + 2;
        }
        let label = view.signal(coil).map_or(coil, |signal| view.label(signal));
        canvas.faint_text(x, row, &fitted(label, (list + room).saturating_sub(x)));
    }
    for (row, name) in ["overload", "turning", "reset"].into_iter().enumerate() {
        terminals::named(canvas, view, (list, row + 3, room), name);
    }
    let bars = [
        ("speed", "n", view.address("speed"), view.part("speed"), 100.0, Color::Green),
        ("current", "I", view.address("current"), view.part("current"), 1000.0, Color::Yellow),
        ("heat", "", "heat".to_owned(), view.state("heat") / 100.0, 100.0, Color::Red),
    ];
    for (row, (name, sign, address, part, all, colour)) in bars.into_iter().enumerate() {
        let y = 6 + row;
        let percent = format!("{:>4.0}%", part * all);
        canvas.text(list, y, &address);
        canvas.styled(list + 5, y, if view.fails(name) { "✗" } else { " " }, canvas.bold(Color::Red));
        let width = room.saturating_sub(9 + percent.len());
        canvas.bar((list + 6, y, width), part, canvas.colour(colour));
        canvas.text(list + 6 + width, y, &percent);
        canvas.faint_text(list + 7 + width + percent.len(), y, sign);
    }
    let starts = format!("{:.0} starts", view.state("starts"));
    if large {
        let words = ["n: speed, per cent of its own", "I: current, full at 10 × rated", "heat: the overload relay trips at 100"];
        for (row, word) in words.into_iter().enumerate() {
            canvas.faint_text(list, 9 + row, word);
        }
        canvas.text(list, 12, &starts);
        terminals::faults(canvas, view, (list, 13, room), 3);
    } else {
        canvas.text(list, 9, &starts);
        terminals::faults(canvas, view, (0, 10, canvas.width()), 1);
    }
}

/// The lines from the fuses to the motor and its star or delta. Each part takes so many rows.
fn circuit(canvas: &mut Canvas<'_>, view: &View<'_>, rows: usize) {
    let (live, dead) = (canvas.bold(Color::Yellow), Style::new());
    let blown = view.state("fuse_blown") > 0.0;
    let fuse = if blown { "✗" } else { "▯" };
    let after_fuse = if blown { dead } else { live };
    let [line, star, delta] = ["line_on", "star_on", "delta_on"].map(|name| view.is_on(name));
    let after_line = if line { after_fuse } else { dead };
    let tripped = view.signal("overload").is_some() && !view.is_on("overload");

    let mut y = 0;
    for (x, name) in LINES.into_iter().zip(["L1", "L2", "L3"]) {
        canvas.styled(x - 1, y, name, live);
    }
    y += 1;
    if rows > 1 {
        wires(canvas, y, "│", live);
        y += 1;
    }
    wires(canvas, y, fuse, if blown { canvas.bold(Color::Red) } else { live });
    canvas.faint_text(0, y, if blown { "blown" } else { "F0" });
    y += 1;
    contacts(canvas, view, y, "K1", ("line", line), after_line);
    y += 1;
    if rows > 1 {
        wires(canvas, y, "│", after_line);
        y += 1;
    }
    wires(canvas, y, if tripped { "✗" } else { "▯" }, if tripped { canvas.bold(Color::Red) } else { after_line });
    canvas.faint_text(0, y, "F1");
    y += 1;
    canvas.lines(3, y, &["╭─┴──┴──┴─╮", "│         │", "╰─┬──┬──┬─╯"]);
    let speed = view.state("speed");
    canvas.text(6, y + 1, "M");
    // At full speed it turns five times in a second, which the eye still sees.
    canvas.wheel(8, y + 1, view.seconds() * speed.clamp(0.0, 100.0) / 5.0, canvas.bold(Color::Cyan));
    if speed >= 1.0 {
        canvas.text(10, y + 1, "↻");
    }
    y += 3;
    contacts(canvas, view, y, "K2", ("delta", delta), if delta { after_line } else { dead });
    canvas.faint_text(13, y, "Δ");
    contacts(canvas, view, y + 1, "K3", ("star", star), if star { after_line } else { dead });
    canvas.faint_text(13, y + 1, "Y");
    if line && star && delta && view.flash() == Lit::On {
        canvas.styled(0, y + 1, "short!", canvas.bold(Color::Red));
    }
}

fn wires(canvas: &mut Canvas<'_>, y: usize, glyph: &str, style: Style) {
    for x in LINES {
        canvas.styled(x, y, glyph, style);
    }
}

/// The three contacts of a contactor: closed they are part of the line.
fn contacts(canvas: &mut Canvas<'_>, view: &View<'_>, y: usize, name: &str, (coil, closed): (&str, bool), style: Style) {
    canvas.faint_text(0, y, name);
    if view.fails(coil) {
        canvas.styled(2, y, "✗", canvas.bold(Color::Red));
    }
    wires(canvas, y, if closed { "┃" } else { "╱" }, style);
}
