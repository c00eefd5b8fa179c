//! Pictures of simulated plants, each drawn of one moment that is data.

mod canvas;
mod conveyor;
mod dosing;
mod elevator;
mod junction;
mod motor;
mod panel;
mod tank;
mod terminals;
mod thermal;
mod view;

use std::collections::BTreeMap;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use sieben_sim::devices::Kind;

use crate::palette::Palette;
use canvas::Canvas;
use view::View;

/// A simulated plant at one moment, as data.
#[derive(Clone, Debug)]
pub(crate) struct PlantLook {
    /// What it is.
    pub(crate) kind: &'static Kind,
    /// What the user calls it.
    pub(crate) name: String,
    /// First input byte.
    pub(crate) input: u32,
    /// First output byte.
    pub(crate) output: u32,
    /// A value for each row of [`Kind::parameters`].
    pub(crate) parameters: Vec<f64>,
    /// Input bytes as the CPU reads them.
    pub(crate) inputs: Vec<u8>,
    /// Output bytes as the CPU writes them.
    pub(crate) outputs: Vec<u8>,
    /// What only the plant knows: name and value.
    pub(crate) state: Vec<(String, f64)>,
    /// Faults that it has at this moment, in the words of `--fault`.
    pub(crate) faults: Vec<String>,
    /// Symbols by address as English mnemonics write it with a space, `I 0.0`; empty if addresses have to do.
    pub(crate) symbols: BTreeMap<String, String>,
}

/// Columns and rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Size {
    /// Columns.
    pub(crate) width: u16,
    /// Rows.
    pub(crate) height: u16,
}

/// What the picture of a kind takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Sizes {
    /// Less shows a part of it.
    pub(crate) least: Size,
    /// More leaves cells free.
    pub(crate) best: Size,
}

/// When a picture is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Moment {
    /// The time of the CPU in milliseconds, for things that turn and blink.
    pub(crate) time_ms: u64,
}

/// How plants of a kind are drawn.
struct Picture {
    /// The name of the kind.
    kind: &'static str,
    sizes: Sizes,
    /// Draws on a canvas of any size.
    draw: fn(&mut Canvas<'_>, &View<'_>),
}

/// One for each kind.
const PICTURES: [Picture; 8] = [
    conveyor::PICTURE,
    dosing::PICTURE,
    elevator::PICTURE,
    junction::PICTURE,
    motor::PICTURE,
    panel::PICTURE,
    tank::PICTURE,
    thermal::PICTURE,
];

/// A kind without a picture of its own shows its terminals.
const TERMINALS: Picture = Picture {
    kind: "",
    sizes: Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 22 } },
    draw: |canvas, view| terminals::column(canvas, view, (0, 0, canvas.width()), &[]),
};

fn picture(kind: &Kind) -> &'static Picture {
    PICTURES.iter().find(|picture| picture.kind == kind.name).unwrap_or(&TERMINALS)
}

/// Columns and rows that the picture of a kind takes at best and at least.
pub(crate) fn size(kind: &Kind) -> Sizes {
    picture(kind).sizes
}

/// Draws a plant into an area of any size, from its upper left corner on.
pub(crate) fn draw(buffer: &mut Buffer, area: Rect, plant: &PlantLook, moment: Moment, palette: Palette) {
    (picture(plant.kind).draw)(&mut Canvas::new(buffer, area, palette), &View::new(plant, moment));
}

#[cfg(test)]
mod tests;
