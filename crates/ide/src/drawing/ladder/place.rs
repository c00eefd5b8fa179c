//! Where each element of a row stands, from the rail to the coils.

use super::super::figures::Figure;
use super::super::grid::{Cell, Grid};
use super::super::identity::STUB;
use super::super::layout::NetId;
use super::measure::{columns, heights, stacked};
use super::wrap::{Begin, Row};
use super::{Drawn, Node, Nodes, Part, Path, Tail};

/// A row as a grid.
pub(super) fn row(row: Row) -> Grid {
    let begin = usize::from(matches!(row.begin, Begin::Stub(_)));
    let columns = (begin + logic_columns(&row.drawn)).max(1);
    let (above, below) = extent(&row.drawn);
    let mut grid = Grid { columns, lines: above + below + 1, has_right_rail: true, ..Grid::default() };
    match row.begin {
        Begin::Rail => grid.rail = Some((0, grid.lines - 1)),
        Begin::Stub(number) => {
            let (figure, net) = (Figure::StubIn(number), row.drawn.before);
            grid.cells.push(cell(figure, 0, above, Some(net)));
        }
    }
    let mut placer = Placer { grid };
    let last = placer.drawn(row.drawn, begin, above);
    if let Some(rail) = &mut placer.grid.rail {
        // No rail below the last line that begins there.
        rail.1 = last.max(above);
    }
    placer.grid
}

/// Columns before that of the outputs.
fn logic_columns(drawn: &Drawn) -> usize {
    let tail = match &drawn.tail {
        Tail::Open | Tail::Outputs(_) => 0,
        Tail::Branches(rungs) => rungs.iter().map(logic_columns).max().unwrap_or(0),
        Tail::Stub(_) => 1,
    };
    columns(&drawn.nodes) + tail
}

/// Lines above and below the first wire of a rung.
fn extent(drawn: &Drawn) -> (usize, usize) {
    let (above, below) = heights(&drawn.nodes);
    let tail = match &drawn.tail {
        Tail::Open | Tail::Stub(_) => (0, 0),
        Tail::Outputs(outputs) => stacked(outputs.iter().map(|output| (output.above, output.below))),
        Tail::Branches(rungs) => stacked(rungs.iter().map(extent)),
    };
    (above.max(tail.0), below.max(tail.1))
}

fn cell(figure: Figure, column: usize, line: usize, net: Option<NetId>) -> Cell {
    Cell { column, line, figure, kind: STUB, place: sieben_lang::network::model::Place::default(), before: net, after: net }
}

struct Placer {
    grid: Grid,
}

/// Goes down from thing to thing: the line of each, from the lines above and below that each needs.
struct Descent {
    line: usize,
    below: usize,
    is_first: bool,
}

impl Descent {
    fn new(line: usize) -> Self {
        Self { line, below: 0, is_first: true }
    }

    fn next(&mut self, (above, below): (usize, usize)) -> usize {
        if !self.is_first {
            self.line += self.below + above + 1;
        }
        self.is_first = false;
        self.below = below;
        self.line
    }
}

impl Placer {
    /// Places a rung; answers the last line that begins at its left border.
    fn drawn(&mut self, drawn: Drawn, column: usize, line: usize) -> usize {
        let is_open = matches!(drawn.tail, Tail::Open);
        let begins_with_parallel = matches!(drawn.nodes.first(), Some(Node { part: Part::Parallel(_), .. }));
        let (end, mut last) = self.nodes(drawn.nodes, column, line);
        if !begins_with_parallel {
            last = line;
        }
        if is_open && let Some(cell) = self.grid.cells.last_mut() {
            // Nothing is wired to the right of the last element.
            cell.after = None;
        }
        let mut descent = Descent::new(line);
        let mut bottom = line;
        let outputs = self.grid.outputs();
        match drawn.tail {
            Tail::Open => {}
            Tail::Stub(number) => self.grid.cells.push(cell(Figure::StubOut(number), end, line, Some(drawn.after))),
            Tail::Outputs(all) => {
                for output in all {
                    bottom = descent.next((output.above, output.below));
                    self.across(bottom, end, outputs, drawn.after);
                    self.node(output, outputs, bottom);
                }
            }
            Tail::Branches(rungs) => {
                for rung in rungs {
                    bottom = descent.next(extent(&rung));
                    self.drawn(rung, end, bottom);
                }
            }
        }
        self.down(end, line, bottom, drawn.after);
        if end == column { last.max(bottom) } else { last }
    }

    fn across(&mut self, line: usize, from: usize, to: usize, net: NetId) {
        if to > from {
            self.grid.across.push((line, from, to, net));
        }
    }

    /// A vertical piece; at the rail it is the rail.
    fn down(&mut self, column: usize, from: usize, to: usize, net: NetId) {
        if column > 0 || self.grid.rail.is_none() {
            self.grid.down.push((column, from, to, net));
        }
    }

    /// Places elements in series; answers the border after them, and the last line of the first one's branches.
    fn nodes(&mut self, nodes: Nodes, mut column: usize, line: usize) -> (usize, usize) {
        let mut last = line;
        for (index, node) in nodes.into_iter().enumerate() {
            let columns = node.columns;
            let bottom = self.node(node, column, line);
            if index == 0 {
                last = bottom;
            }
            column += columns;
        }
        (column, last)
    }

    fn path(&mut self, path: Path, column: usize, line: usize, end: usize) {
        let after = path.after;
        let (reached, _) = self.nodes(path.nodes, column, line);
        self.across(line, reached, end, after);
    }

    /// Places an element; answers the last line that begins at its left border.
    fn node(&mut self, node: Node, column: usize, line: usize) -> usize {
        let Node { columns, kind, place, before, after, .. } = node;
        match node.part {
            Part::Figure(figure) => {
                self.grid.cells.push(Cell { column, line, figure, kind, place, before: Some(before), after: Some(after) });
                line
            }
            Part::Parallel(paths) => {
                let mut descent = Descent::new(line);
                let end = column + columns;
                let mut bottom = line;
                for path in paths {
                    bottom = descent.next(heights(&path.nodes));
                    self.path(path, column, bottom, end);
                }
                self.down(column, line, bottom, before);
                self.down(end, line, bottom, after);
                bottom
            }
            Part::Boxed(figure, logic) => {
                let own = column + columns - 1;
                if !matches!(&figure, Figure::Box(figure) if figure.left.first().is_some_and(|pin| pin.is_hidden)) {
                    self.across(line, column, own, before);
                }
                for (offset, path) in logic {
                    let begins_elsewhere = match path.nodes.first() {
                        Some(Node { part: Part::Figure(Figure::StubIn(_)), .. }) => true,
                        Some(Node { part: Part::Boxed(Figure::Box(figure), _), .. }) => {
                            figure.left.first().is_some_and(|pin| pin.is_hidden)
                        }
                        _ => false,
                    };
                    let line = line + offset;
                    if !begins_elsewhere {
                        self.grid.pin_rails.push((column + 1, line));
                    }
                    self.path(path, column + 1, line, own);
                }
                self.grid.cells.push(Cell { column: own, line, figure, kind, place, before: Some(before), after: Some(after) });
                line
            }
        }
    }
}
