//! Rows of a diagram as cells in columns, and how they become a layout once the width of each column is known.

use sieben_lang::network::model::Place;

use super::figures::{Figure, Spot};
use super::layout::{Layout, NetId, Rail, Side, Wire};

/// A row of a diagram: all that is wired together before it goes on in the next one.
#[derive(Debug, Default)]
pub(super) struct Grid {
    /// Figures in their cells.
    pub(super) cells: Vec<Cell>,
    /// Horizontal pieces: line, first and last border, net.
    pub(super) across: Vec<(usize, usize, usize, NetId)>,
    /// Vertical pieces: border, first and last line, net.
    pub(super) down: Vec<(usize, usize, usize, NetId)>,
    /// Small rails of pins: border, line.
    pub(super) pin_rails: Vec<(usize, usize)>,
    /// Lines of the power rail, if there is one.
    pub(super) rail: Option<(usize, usize)>,
    /// Columns, that of the outputs not counted.
    pub(super) columns: usize,
    /// Lines.
    pub(super) lines: usize,
    /// A rail closes the outputs.
    pub(super) has_right_rail: bool,
}

impl Grid {
    /// The column of the outputs, which stand at the right end of the widest row: the one after the others and what may lie between.
    pub(super) fn outputs(&self) -> usize {
        self.columns + 1
    }
}

/// A figure in its cell.
#[derive(Debug)]
pub(super) struct Cell {
    /// Its column; see [`Grid::outputs`].
    pub(super) column: usize,
    /// The line of its wire.
    pub(super) line: usize,
    /// What stands there.
    pub(super) figure: Figure,
    /// What kind of element it is.
    pub(super) kind: &'static str,
    /// Where it comes from.
    pub(super) place: Place,
    /// The line that enters it.
    pub(super) before: Option<NetId>,
    /// The line that leaves it.
    pub(super) after: Option<NetId>,
}

/// A row with the width of each of its columns.
struct Measured {
    grid: Grid,
    /// Of the columns that are not outputs.
    widths: Vec<usize>,
    /// Of that of the outputs, if there are any.
    outputs: Option<usize>,
}

impl Measured {
    fn new(grid: Grid) -> Self {
        let mut widths = vec![0; grid.columns];
        let mut outputs = None;
        for cell in &grid.cells {
            let own = cell.figure.width();
            match widths.get_mut(cell.column) {
                Some(width) => *width = own.max(*width),
                None => outputs = outputs.max(Some(own)),
            }
        }
        Self { grid, widths, outputs }
    }

    /// Columns of characters: each column has a border at its left, and the last one at its right.
    fn columns(&self) -> usize {
        self.widths.iter().sum::<usize>() + self.widths.len() + self.outputs.map_or(0, |width| width + 1) + 1
    }
}

/// Puts rows under one another.
pub(super) fn join(rows: Vec<Grid>, layout: &mut Layout) {
    let rows: Vec<Measured> = rows.into_iter().map(Measured::new).collect();
    let columns = rows.iter().map(Measured::columns).max().unwrap_or(1);
    layout.columns = layout.columns.max(columns);
    for row in rows {
        let top = layout.lines;
        draw(&row, columns, top, layout);
        layout.lines = top + row.grid.lines;
    }
}

fn draw(row: &Measured, columns: usize, top: usize, layout: &mut Layout) {
    let grid = &row.grid;
    let mut borders = vec![0];
    let mut at = 0;
    for width in &row.widths {
        at += width + 1;
        borders.push(at);
    }
    if let Some(width) = row.outputs {
        borders.extend([columns.saturating_sub(width + 2), columns - 1]);
    }
    let border = |column: usize| borders[column.min(borders.len() - 1)];
    if let Some((from, to)) = grid.rail {
        layout.rails.push(Rail { column: 0, from: top + from, to: top + to, side: Side::Left });
    }
    for &(column, line) in &grid.pin_rails {
        layout.rails.push(Rail { column: border(column), from: top + line, to: top + line, side: Side::Left });
    }
    for &(line, from, to, net) in &grid.across {
        if border(to) > border(from) {
            layout.wires.push(Wire { net, from: (border(from), top + line), to: (border(to), top + line) });
        }
    }
    for &(column, from, to, net) in &grid.down {
        if to > from {
            layout.wires.push(Wire { net, from: (border(column), top + from), to: (border(column), top + to) });
        }
    }
    for cell in &grid.cells {
        let spot = Spot {
            left: border(cell.column),
            right: border(cell.column + 1),
            line: top + cell.line,
            kind: cell.kind,
            place: cell.place,
            before: cell.before,
            after: cell.after,
        };
        cell.figure.draw(&spot, layout);
        if grid.has_right_rail && cell.column == grid.outputs() {
            layout.rails.push(Rail { column: spot.right, from: spot.line, to: spot.line, side: Side::Right });
        }
    }
}
