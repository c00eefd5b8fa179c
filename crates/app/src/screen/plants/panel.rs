//! The training panel: rows of bits, thumbwheel, display, and what it shows of motors and a horn.

use ratatui::style::Color;
use sieben_sim::devices::Place;

use super::canvas::Canvas;
use super::terminals;
use super::view::View;
use super::{Picture, Size, Sizes};
use crate::palette::Lit;

pub(super) const PICTURE: Picture =
    Picture { kind: "panel", sizes: Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 22 } }, draw };

/// Rows of the panel: what they are, the names before the bit, and the colour.
const ROWS: [(&str, &[&str], Color); 5] = [
    ("toggle switches", &["switch_0_", "switch_1_"], Color::Cyan),
    ("push buttons", &["button_0_", "button_1_"], Color::Cyan),
    ("selectors", &["selector_"], Color::Cyan),
    ("lamps", &["lamp_0_", "lamp_1_"], Color::Green),
    ("lamps", &["lamp_2_", "lamp_3_"], Color::Green),
];
/// Columns before the bits.
const HEAD: usize = 6;

fn draw(canvas: &mut Canvas<'_>, view: &View<'_>) {
    let large = canvas.holds(PICTURE.sizes.best);
    let there = |stems: &[&str]| view.signal(&format!("{}0", stems[0])).is_some();
    let mut y = 0;
    for (word, stems, colour) in ROWS.into_iter().filter(|row| there(row.1)) {
        for (byte, stem) in stems.iter().enumerate() {
            for bit in 0..8 {
                let name = format!("{stem}{bit}");
                let x = HEAD + byte * 17 + (7 - bit) * 2;
                canvas.lamp(x, y, view.lit(&name), colour);
                if view.fails(&name) {
                    canvas.styled(x + 1, y, "✗", canvas.bold(Color::Red));
                }
            }
        }
        let first = view.address(&format!("{}0", stems[0]));
        let byte = first.split('.').next().unwrap_or_default().replacen(' ', "B ", 1);
        canvas.text(0, y, &byte);
        if large {
            canvas.faint_text(HEAD + 35, y, word);
        }
        y += 1;
    }
    y += usize::from(large);
    words(canvas, view, y);
    y += 5;

    let mut x = 0;
    for (name, sign) in [("motor_left", "◄ M"), ("motor_right", "M ►"), ("horn", "♪")] {
        let Some(value) = view.known(name) else { continue };
        let lit = Lit::when(value > 0.0);
        canvas.lamp(x, y, lit, Color::Yellow);
        let text = format!("{sign} Q {:.1}", view.parameter(name));
        canvas.styled(x + 2, y, &text, if lit == Lit::On { canvas.bold(Color::Yellow) } else { canvas.faint() });
        x += text.chars().count() + 3;
    }
    if !large {
        terminals::faults(canvas, view, (0, canvas.height().min(11).saturating_sub(1), canvas.width()), 1);
        return;
    }
    terminals::faults(canvas, view, (0, y + 1, canvas.width()), 2);
    named(canvas, view, y + 2 + usize::from(!view.faults().is_empty()) * 2);
}

/// Thumbwheel and display.
fn words(canvas: &mut Canvas<'_>, view: &View<'_>, y: usize) {
    for (name, x) in [("thumbwheel", 0), ("display", 15)] {
        let Some(signal) = view.signal(name) else { continue };
        let (word, address) = (view.word(name).cast_unsigned(), view.address_of(signal));
        let mark = if view.fails(name) { "✗" } else { "" };
        if name == "display" {
            canvas.display(x, y, word);
            canvas.faint_text(7, y, &format!("{address:>7}"));
            canvas.faint_text(8, y + 1, &format!("  {word:04X}"));
            canvas.styled(14, y, mark, canvas.bold(Color::Red));
            continue;
        }
        canvas.text(x, y, &address);
        canvas.styled(x + address.len(), y, mark, canvas.bold(Color::Red));
        let digits: Vec<String> = format!("{word:04X}").chars().map(|digit| digit.to_string()).collect();
        canvas.faint_text(x, y + 1, " ▴ ▴ ▴ ▴");
        canvas.text(x, y + 2, &format!("│{}│", digits.join("│")));
        canvas.faint_text(x, y + 3, " ▾ ▾ ▾ ▾");
    }
}

/// The bits that have symbols, in two columns as far as there is room.
fn named(canvas: &mut Canvas<'_>, view: &View<'_>, top: usize) {
    let rows = canvas.height().min(22).saturating_sub(top);
    let bits = view.signals().iter().filter(|signal| matches!(signal.place, Place::Bit(..)) && view.label(signal) != signal.name);
    for (index, signal) in bits.take(rows * 2).enumerate() {
        terminals::line(canvas, view, (index / rows.max(1) * 30, top + index % rows.max(1), 29), signal);
    }
}
