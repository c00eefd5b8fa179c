//! Where each box of a row stands: what feeds it directly to its left, outputs at the right end.

use sieben_lang::network::model::Place;

use super::super::figures::Figure;
use super::super::grid::{Cell, Grid};
use super::super::identity::STUB;
use super::super::layout::NetId;
use super::{Drawn, Node, Row, Source, Tail};

/// A row as a grid.
pub(super) fn row(row: Row) -> Grid {
    match row {
        Row::Source(node, number) => {
            let columns = node.columns.len();
            let (line, net) = (node.above, node.after);
            let grid = Grid { columns: columns + 1, lines: node.above + node.below + 1, ..Grid::default() };
            let mut placer = Placer { grid };
            placer.grid.cells.push(stub(Figure::StubOut(number), columns, line, net));
            placer.node(node, columns - 1, line, 0, &mut Vec::new(), Feeds::Something);
            placer.grid
        }
        Row::Drawn(drawn) => {
            let (above, below) = extent(&drawn);
            let grid = Grid { columns: columns(&drawn).max(1), lines: above + below + 1, ..Grid::default() };
            let mut placer = Placer { grid };
            placer.drawn(drawn, 0, above, &mut Vec::new());
            placer.grid
        }
    }
}

/// Columns before that of the outputs.
fn columns(drawn: &Drawn) -> usize {
    let tail = match &drawn.tail {
        Tail::Open | Tail::Outputs(_) => 0,
        Tail::Branches(rungs, number) => rungs.iter().map(columns).max().unwrap_or(0).max(usize::from(number.is_some())),
        Tail::Stub(_) => 1,
    };
    own_columns(&drawn.source) + tail
}

fn own_columns(source: &Source) -> usize {
    match source {
        Source::Open | Source::Left(_) => 0,
        Source::Operand(_) | Source::Stub(..) => 1,
        Source::Node(node) => node.columns.len(),
    }
}

/// Lines above and below the first line of a rung.
fn extent(drawn: &Drawn) -> (usize, usize) {
    let source = match &drawn.source {
        Source::Node(node) => (node.above, node.below),
        Source::Operand(operand) => (0, operand.lines.len().saturating_sub(1)),
        _ => (0, 0),
    };
    let tail = match &drawn.tail {
        Tail::Open | Tail::Stub(_) => (0, 0),
        Tail::Outputs(nodes) => stacked(nodes.iter().map(|node| (node.above, node.below))),
        Tail::Branches(rungs, number) => stacked(rungs.iter().map(extent).chain(number.map(|_| (0, 0)))),
    };
    (source.0.max(tail.0), source.1.max(tail.1))
}

fn stacked(sizes: impl Iterator<Item = (usize, usize)>) -> (usize, usize) {
    super::super::ladder::stacked(sizes)
}

fn stub(figure: Figure, column: usize, line: usize, net: NetId) -> Cell {
    Cell { column, line, figure, kind: STUB, place: Place::default(), before: Some(net), after: Some(net) }
}

/// What a box feeds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Feeds {
    Nothing,
    Something,
}

struct Placer {
    grid: Grid,
}

impl Placer {
    fn across(&mut self, line: usize, from: usize, to: usize, net: NetId) {
        if to > from {
            self.grid.across.push((line, from, to, net));
        }
    }

    /// Places a rung whose line from the left comes in at a border; collects the lines where it does.
    fn drawn(&mut self, drawn: Drawn, column: usize, line: usize, taps: &mut Vec<usize>) {
        let Drawn { source, tail, net } = drawn;
        let begin = column + own_columns(&source);
        let is_open = matches!(tail, Tail::Open);
        let is_left = matches!(source, Source::Left(_));
        match source {
            Source::Node(node) => {
                let feeds = if is_open { Feeds::Nothing } else { Feeds::Something };
                self.node(*node, begin - 1, line, column, taps, feeds);
            }
            Source::Operand(operand) => {
                let (kind, place) = operand.element.unwrap_or((STUB, Place::default()));
                let figure = Figure::Operand(operand.lines, operand.value);
                self.grid.cells.push(Cell { column, line, figure, kind, place, before: None, after: Some(operand.net) });
            }
            Source::Stub(number, net) => self.grid.cells.push(stub(Figure::StubIn(number), column, line, net)),
            Source::Left(_) | Source::Open => {}
        }
        let mut lines = Vec::new();
        let mut at = line;
        let mut last_below = None;
        let mut next = |above: usize, below: usize| {
            if let Some(last) = last_below {
                at += last + above + 1;
            }
            last_below = Some(below);
            at
        };
        match tail {
            Tail::Open => {}
            Tail::Stub(number) => {
                self.grid.cells.push(stub(Figure::StubOut(number), begin, line, net));
                lines.push(line);
            }
            Tail::Outputs(nodes) => {
                let outputs = self.grid.outputs();
                for node in nodes {
                    let line = next(node.above, node.below);
                    self.node(node, outputs, line, begin, &mut lines, Feeds::Nothing);
                }
            }
            Tail::Branches(rungs, number) => {
                for rung in rungs {
                    let (above, below) = extent(&rung);
                    let line = next(above, below);
                    self.drawn(rung, begin, line, &mut lines);
                }
                if let Some(number) = number {
                    let line = next(0, 0);
                    self.grid.cells.push(stub(Figure::StubOut(number), begin, line, net));
                    lines.push(line);
                }
            }
        }
        let bottom = lines.iter().copied().max().unwrap_or(line);
        if bottom > line {
            self.grid.down.push((begin, line, bottom, net));
        }
        if is_left {
            taps.push(line);
        }
    }

    /// Places a box at a column, its sources to the left of it; the line from the left comes from a border.
    fn node(&mut self, node: Node, column: usize, line: usize, border: usize, taps: &mut Vec<usize>, feeds: Feeds) {
        for (pin, source) in node.sources {
            let Some(offset) = node.figure.left.get(pin).map(|pin| pin.offset) else { continue };
            match source {
                Source::Node(source) => {
                    if let Some(before) = column.checked_sub(1) {
                        self.node(*source, before, line + offset, border, taps, Feeds::Something);
                    }
                }
                Source::Left(net) => {
                    self.across(line + offset, border, column, net);
                    taps.push(line + offset);
                }
                _ => {}
            }
        }
        let after = (feeds == Feeds::Something).then_some(node.after);
        let before = if column == self.grid.outputs() { Some(node.after) } else { None };
        let figure = Figure::Box(node.figure);
        self.grid.cells.push(Cell { column, line, figure, kind: node.kind, place: node.place, before, after });
    }
}
