//! The terminals of a plant, one line each: address, state, symbol.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Style};
use sieben_sim::devices::{Place, Signal};

use super::PlantLook;
use crate::palette::{Lit, Palette};

/// Draws as many of them as there is room for.
pub(super) fn draw(buffer: &mut Buffer, area: Rect, plant: &PlantLook, palette: Palette) {
    let area = area.intersection(buffer.area);
    for (signal, y) in plant.kind.signals.iter().zip(area.top()..area.bottom()) {
        line(buffer, Rect { y, height: 1, ..area }, plant, signal, palette);
    }
}

fn line(buffer: &mut Buffer, area: Rect, plant: &PlantLook, signal: &Signal, palette: Palette) {
    let (base, bytes) = if signal.is_input() { (plant.input, &plant.inputs) } else { (plant.output, &plant.outputs) };
    let at = |byte: u32| bytes.get(byte as usize).copied().unwrap_or(0);
    let address = signal.address(base);
    let name = plant.symbols.get(&address).map_or(signal.name, String::as_str);
    let value = match signal.place {
        Place::Bit(byte, bit) => palette.led(Lit::when(at(byte) >> bit & 1 != 0), Color::Green),
        Place::Word(byte) => format!("{:>6}", i16::from_be_bytes([at(byte), at(byte.saturating_add(1))])).into(),
    };
    let value_width = value.width() as u16;
    let columns =
        [(address, Style::new(), 8), (value.content.into_owned(), value.style, value_width + 1), (name.to_owned(), palette.faint(), 0)];
    let mut x = area.x;
    for (text, style, width) in columns {
        if x < area.right() {
            buffer.set_stringn(x, area.y, text, usize::from(area.right() - x), style);
        }
        x = x.saturating_add(width);
    }
}
