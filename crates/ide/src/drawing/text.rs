//! A diagram as text, for a terminal: box drawing characters, or those of ASCII alone.

use std::collections::HashMap;

use unicode_width::UnicodeWidthChar;

use super::flow::Flow;
use super::layout::{Layout, Outline, Role, Side, Symbol};

/// Which characters draw it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Characters {
    /// `├──┤ ├──`
    Unicode,
    /// `+--| |--`; names stay as they are.
    Ascii,
}

/// Draws a diagram; each line ends with a line feed and has no spaces at its end.
///
/// With what its lines carry, `═` is 1, `┄` is 0, `·` was not executed and `─` is unknown; in ASCII these are `=`, `-`, `.` and `?`.
pub fn text(layout: &Layout, flows: Option<&[Flow]>, characters: Characters) -> String {
    let mut page = Page::new(layout.columns, layout.lines, characters);
    for wire in &layout.wires {
        let flow = flows.map(|flows| flows.get(wire.net.0 as usize).copied().unwrap_or(Flow::Unknown));
        page.wire(wire.from, wire.to, flow);
    }
    for rail in &layout.rails {
        for line in rail.from..=rail.to {
            let side = if rail.side == Side::Left { NORTH | SOUTH } else { NORTH | SOUTH | WEST };
            page.join(rail.column, line, side, None);
        }
    }
    for symbol in &layout.symbols {
        page.symbol(symbol);
    }
    page.finish()
}

const NORTH: u8 = 1;
const EAST: u8 = 2;
const SOUTH: u8 = 4;
const WEST: u8 = 8;

/// Characters of lines by the sides that they join.
const CORNERS: [char; 16] = [' ', '│', '─', '└', '│', '│', '┌', '├', '─', '┘', '─', '┴', '┐', '┤', '┬', '┼'];

/// What a line that carries something is drawn with: horizontal and vertical, in Unicode and in ASCII.
const LINES: [(Flow, [char; 2], [char; 2]); 4] = [
    (Flow::One, ['═', '║'], ['=', '|']),
    (Flow::Zero, ['┄', '┆'], ['-', ':']),
    (Flow::NotRun, ['·', '·'], ['.', '.']),
    (Flow::Unknown, ['─', '│'], ['?', '?']),
];

/// A character of the page.
#[derive(Clone, Copy, Default)]
struct Cell {
    /// What is written; the second half of a wide character is `TAIL`.
    written: Option<char>,
    /// Sides that lines join here.
    sides: u8,
    /// What they carry.
    flow: Option<Flow>,
}

/// Stands in the second column of a wide character.
const TAIL: char = '\0';

struct Page {
    columns: usize,
    cells: Vec<Cell>,
    /// Marks that combine with the character of a cell.
    combined: HashMap<usize, String>,
    characters: Characters,
}

impl Page {
    fn new(columns: usize, lines: usize, characters: Characters) -> Self {
        let columns = columns.max(1);
        Self { columns, cells: vec![Cell::default(); columns.saturating_mul(lines)], combined: HashMap::new(), characters }
    }

    fn cell(&mut self, column: usize, line: usize) -> Option<&mut Cell> {
        if column >= self.columns {
            return None;
        }
        self.cells.get_mut(line * self.columns + column)
    }

    fn join(&mut self, column: usize, line: usize, sides: u8, flow: Option<Flow>) {
        if let Some(cell) = self.cell(column, line) {
            cell.sides |= sides;
            cell.flow = flow.or(cell.flow);
        }
    }

    fn wire(&mut self, from: (usize, usize), to: (usize, usize), flow: Option<Flow>) {
        if from.1 == to.1 {
            for column in from.0..=to.0 {
                let sides = if column == from.0 { EAST } else { 0 } | if column == to.0 { WEST } else { 0 };
                self.join(column, from.1, if sides == 0 { EAST | WEST } else { sides }, flow);
            }
        } else {
            for line in from.1..=to.1 {
                let sides = if line == from.1 { SOUTH } else { 0 } | if line == to.1 { NORTH } else { 0 };
                self.join(from.0, line, if sides == 0 { NORTH | SOUTH } else { sides }, flow);
            }
        }
    }

    fn put(&mut self, column: usize, line: usize, text: &str) {
        let mut at = column;
        for character in text.chars() {
            let width = character.width().unwrap_or(0);
            if width == 0 {
                if let Some(before) = at.checked_sub(1).filter(|before| *before >= column) {
                    self.combined.entry(line * self.columns + before).or_default().push(character);
                }
                continue;
            }
            if let Some(cell) = self.cell(at, line) {
                cell.written = Some(character);
            }
            for tail in 1..width {
                if let Some(cell) = self.cell(at + tail, line) {
                    cell.written = Some(TAIL);
                }
            }
            at += width;
        }
    }

    /// One of two characters, as the page may have them.
    fn sign(&self, unicode: char, ascii: char) -> char {
        if self.characters == Characters::Unicode { unicode } else { ascii }
    }

    fn put_sign(&mut self, column: usize, line: usize, unicode: char, ascii: char) {
        let sign = self.sign(unicode, ascii);
        if let Some(cell) = self.cell(column, line) {
            cell.written = Some(sign);
        }
    }

    fn symbol(&mut self, symbol: &Symbol) {
        match symbol.outline {
            Outline::None => {}
            Outline::Contact { from, to, line, .. } => {
                self.blank(from..=to, line);
                self.put_sign(from, line, '┤', '|');
                self.put_sign(to, line, '├', '|');
            }
            Outline::Coil { from, to, line } => {
                self.blank(from..=to, line);
                self.put_sign(from, line, '(', '(');
                self.put_sign(to, line, ')', ')');
            }
            Outline::Box { from, to, top, bottom } => self.outline_box(from, to, top, bottom),
        }
        for label in &symbol.labels {
            match label.role {
                Role::TickLeft => self.put_sign(label.column, label.line, '┤', '|'),
                Role::TickRight => self.put_sign(label.column, label.line, '├', '|'),
                Role::Circle => self.put_sign(label.column, label.line, 'o', 'o'),
                Role::Stub if self.characters == Characters::Ascii => self.put(label.column, label.line, &label.text.replace('»', ">")),
                _ => self.put(label.column, label.line, &label.text),
            }
        }
    }

    fn blank(&mut self, columns: std::ops::RangeInclusive<usize>, line: usize) {
        for column in columns {
            if let Some(cell) = self.cell(column, line) {
                cell.written = Some(' ');
            }
        }
    }

    fn outline_box(&mut self, from: usize, to: usize, top: usize, bottom: usize) {
        for line in top..=bottom {
            self.blank(from..=to, line);
            self.put_sign(from, line, '│', '|');
            self.put_sign(to, line, '│', '|');
        }
        for column in from..=to {
            self.put_sign(column, top, '─', '-');
            self.put_sign(column, bottom, '─', '-');
        }
        for (column, line, corner) in [(from, top, '┌'), (to, top, '┐'), (from, bottom, '└'), (to, bottom, '┘')] {
            self.put_sign(column, line, corner, '+');
        }
    }

    fn drawn(&self, cell: Cell) -> char {
        if let Some(character) = cell.written {
            return character;
        }
        let corner = CORNERS[usize::from(cell.sides & 15)];
        let is_across = matches!(corner, '─');
        let is_down = matches!(corner, '│');
        let signs = match (self.characters, cell.flow) {
            (_, None) => ['─', '│'],
            (Characters::Unicode, Some(flow)) => LINES.iter().find(|row| row.0 == flow).map_or(['─', '│'], |row| row.1),
            (Characters::Ascii, Some(flow)) => LINES.iter().find(|row| row.0 == flow).map_or(['-', '|'], |row| row.2),
        };
        match (self.characters, cell.sides) {
            (_, 0) => ' ',
            (Characters::Ascii, _) if cell.flow.is_none() && is_across => '-',
            (Characters::Ascii, _) if cell.flow.is_none() && is_down => '|',
            (_, _) if is_across => signs[0],
            (_, _) if is_down => signs[1],
            (Characters::Ascii, _) => '+',
            (Characters::Unicode, _) => corner,
        }
    }

    fn finish(self) -> String {
        let mut out = String::with_capacity(self.cells.len());
        for (line, cells) in self.cells.chunks(self.columns).enumerate() {
            let begin = out.len();
            for (column, cell) in cells.iter().enumerate() {
                let character = self.drawn(*cell);
                if character != TAIL {
                    out.push(character);
                }
                if let Some(marks) = (!self.combined.is_empty()).then(|| self.combined.get(&(line * self.columns + column))).flatten() {
                    out.push_str(marks);
                }
            }
            out.truncate(begin + out[begin..].trim_end_matches(' ').len());
            out.push('\n');
        }
        out
    }
}
