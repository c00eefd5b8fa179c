//! A piece of the screen that a picture is drawn on: whatever lies outside of it is cut off.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};

use super::super::digits::{self, Cell};
use super::Size;
use crate::palette::{Lit, Palette};

/// Eighths of a cell from below, for levels.
const LEVELS: [char; 9] = [' ', '▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
/// Eighths of a cell from the left, for bars.
const BARS: [char; 9] = [' ', '▏', '▎', '▍', '▌', '▋', '▊', '▉', '█'];

/// Where a picture is drawn. Columns and rows count from its upper left corner.
pub(super) struct Canvas<'a> {
    buffer: &'a mut Buffer,
    area: Rect,
    palette: Palette,
}

/// Columns and rows from the corner of a canvas: left, top, width, height.
pub(super) type Place = (usize, usize, usize, usize);

impl<'a> Canvas<'a> {
    pub(super) fn new(buffer: &'a mut Buffer, area: Rect, palette: Palette) -> Self {
        let area = area.intersection(buffer.area);
        Self { buffer, area, palette }
    }
    pub(super) fn width(&self) -> usize {
        usize::from(self.area.width)
    }
    pub(super) fn height(&self) -> usize {
        usize::from(self.area.height)
    }
    /// Whether there is room for this.
    pub(super) fn holds(&self, size: Size) -> bool {
        self.area.width >= size.width && self.area.height >= size.height
    }
    pub(super) fn colour(&self, colour: Color) -> Style {
        self.palette.colour(colour)
    }
    pub(super) fn bold(&self, colour: Color) -> Style {
        self.palette.colour(colour).add_modifier(Modifier::BOLD)
    }
    pub(super) fn faint(&self) -> Style {
        self.palette.faint()
    }

    /// Writes in a style; what does not fit is cut off.
    pub(super) fn styled(&mut self, x: usize, y: usize, text: &str, style: Style) {
        if x < self.width() && y < self.height() {
            let at = (self.area.x + x as u16, self.area.y + y as u16);
            self.buffer.set_stringn(at.0, at.1, text, self.width() - x, style);
        }
    }
    pub(super) fn text(&mut self, x: usize, y: usize, text: &str) {
        self.styled(x, y, text, Style::new());
    }
    pub(super) fn faint_text(&mut self, x: usize, y: usize, text: &str) {
        self.styled(x, y, text, self.faint());
    }
    /// Lines below each other.
    pub(super) fn lines(&mut self, x: usize, y: usize, lines: &[&str]) {
        for (row, line) in lines.iter().enumerate() {
            self.text(x, y.saturating_add(row), line);
        }
    }

    /// Filled while it is on.
    pub(super) fn lamp(&mut self, x: usize, y: usize, lit: Lit, colour: Color) {
        let span = self.palette.led(lit, colour);
        self.styled(x, y, &span.content, span.style);
    }

    /// Two walls with a liquid between them, filled to a part from 0 to 1.
    pub(super) fn vessel(&mut self, (x, y, width, height): Place, level: f64) {
        let water = self.colour(Color::Blue);
        let eighths = cells(level, height * 8);
        for row in 0..height {
            let filled = eighths.saturating_sub(row * 8).min(8);
            let y = y + height - 1 - row;
            self.text(x, y, "│");
            self.styled(x + 1, y, &LEVELS[filled].to_string().repeat(width.saturating_sub(2)), water);
            self.text(x + width.saturating_sub(1), y, "│");
        }
    }

    /// A bar in a frame, filled from the left to a part from 0 to 1.
    pub(super) fn bar(&mut self, (x, y, width): (usize, usize, usize), part: f64, style: Style) {
        let inside = width.saturating_sub(2);
        let eighths = cells(part, inside * 8);
        let filled: String = (0..inside).map(|column| BARS[eighths.saturating_sub(column * 8).min(8)]).collect();
        self.faint_text(x, y, "▕");
        self.styled(x + 1, y, &filled, style);
        self.faint_text(x + inside + 1, y, "▏");
    }

    /// A display of four digits. Leading zeros are dark; so is a nibble above 9, but for a dash.
    pub(super) fn display(&mut self, x: usize, y: usize, word: u16) {
        let lit = self.bold(Color::LightRed);
        for (position, digit) in digits::of_word(word).into_iter().enumerate() {
            for row in 0..digits::HEIGHT {
                let text: String = digits::row(digit, row).into_iter().map(|cell| if cell == Cell::Lit { '█' } else { ' ' }).collect();
                self.styled(x + position * digits::WIDTH, y + row, &text, lit);
            }
        }
    }

    /// A thing that turns, at one of four quarters.
    pub(super) fn wheel(&mut self, x: usize, y: usize, quarters: f64, style: Style) {
        // Conversion of a float saturates.
        self.styled(x, y, ["◐", "◓", "◑", "◒"][(quarters.max(0.0) as u64 % 4) as usize], style);
    }
}

/// How many of so many cells a part from 0 to 1 fills.
pub(super) fn cells(part: f64, of: usize) -> usize {
    // Conversion of a float saturates, and what is no number becomes 0.
    (part.clamp(0.0, 1.0) * of as f64).round() as usize
}
