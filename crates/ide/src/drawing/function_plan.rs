//! A network as function block diagram: boxes with their operands, from left to right, assignments at the right end.

mod build;
mod place;

use sieben_lang::network::model::{Content, Network, Place};

use super::figures::BoxFigure;
use super::grid::{self, Cell, Grid};
use super::layout::{Layout, Net, NetId};
use super::nesting::{self, Refusal};
use super::{Options, faces, identity, ladder};

/// Columns of a row that a reader can ask for.
const COLUMNS_MAX: usize = 1000;
/// Lines that a tapped line goes down to where it is read again; farther away its number stands.
const TAP_LINES_MAX: usize = 3;

/// A box with what feeds it and the room that it takes.
#[derive(Debug)]
struct Node {
    figure: BoxFigure,
    kind: &'static str,
    place: Place,
    /// What is drawn to the left of it: index of the pin, source.
    sources: Vec<(usize, Source)>,
    /// The line that leaves it.
    after: NetId,
    /// Lines above and below the one of its first pin, with all that feeds it.
    above: usize,
    below: usize,
    /// Widths of its own column and of those to the left of it.
    columns: Vec<usize>,
}

/// What feeds a pin.
#[derive(Debug)]
enum Source {
    /// Nothing.
    Open,
    /// An operand or constant: text, name of the pin if the value is kept under it, the element that it is.
    Operand(Operand),
    /// A box.
    Node(Box<Node>),
    /// The line that comes from the left, of a tap or of what feeds several outputs.
    Left(NetId),
    /// What is drawn elsewhere.
    Stub(u32, NetId),
}

/// An operand at a pin.
#[derive(Debug)]
struct Operand {
    lines: Vec<String>,
    value: Option<String>,
    element: Option<(&'static str, Place)>,
    net: NetId,
}

/// A rung: what comes from the left, and what it feeds.
#[derive(Debug)]
struct Drawn {
    source: Source,
    tail: Tail,
    net: NetId,
}

/// The right end of a rung.
#[derive(Debug)]
enum Tail {
    Open,
    Outputs(Vec<Node>),
    /// Sub-rungs, and the number of the line if it is read far away.
    Branches(Vec<Drawn>, Option<u32>),
    Stub(u32),
}

/// A row.
#[derive(Debug)]
enum Row {
    /// What feeds a pin that is drawn elsewhere.
    Source(Node, u32),
    Drawn(Drawn),
}

/// What a diagram is made with, its nets so far, and the rows before and after the one that is being made.
struct Maker<'a> {
    options: &'a Options<'a>,
    columns: usize,
    nets: Vec<Net>,
    /// The last number of a line that is drawn elsewhere.
    stubs: u32,
    /// The numbers of the tapped lines around, innermost last.
    taps: Vec<(NetId, Option<u32>)>,
    before: Vec<Row>,
    after: Vec<Row>,
}

/// Lays a network out as function block diagram.
///
/// # Errors
/// It nests too deep.
pub fn function_plan(network: &Network, options: &Options<'_>) -> Result<Layout, Refusal> {
    nesting::check(network, |_, _| None)?;
    let columns = options.columns.min(COLUMNS_MAX);
    let mut maker = Maker { options, columns, nets: vec![Net::Rail], stubs: 0, taps: Vec::new(), before: Vec::new(), after: Vec::new() };
    let mut layout = Layout::default();
    ladder::jump_label(network, &mut layout);
    match &network.content {
        Content::Empty => layout.lines += 1,
        Content::Alone(alone, place) => {
            let (above, mark) = faces::alone(alone);
            let node = maker.alone(mark, above, *place);
            let (lines, line) = (node.above + node.below + 1, node.above);
            let figure = super::figures::Figure::Box(node.figure);
            let cell = Cell { column: 0, line, figure, kind: node.kind, place: *place, before: None, after: None };
            grid::join(vec![Grid { cells: vec![cell], columns: 1, lines, ..Grid::default() }], &mut layout);
        }
        Content::Rung(rung) => {
            let drawn = maker.rung(rung, None);
            let mut rows = std::mem::take(&mut maker.before);
            rows.push(Row::Drawn(drawn));
            rows.append(&mut maker.after);
            grid::join(rows.into_iter().map(place::row).collect(), &mut layout);
        }
    }
    layout.nets = maker.nets;
    identity::name(&mut layout, options.line_of);
    Ok(layout)
}
