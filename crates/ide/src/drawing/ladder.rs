//! A network as ladder: contacts from left to right between rails, branches under one another, boxes with their pins, coils at the right end.

mod measure;
mod place;
mod wrap;

pub(super) use measure::stacked;

use sieben_lang::network::model::{Content, Network, Place};

use super::figures::Figure;
use super::grid::{self, Cell, Grid};
use super::identity;
use super::layout::{Label, Layout, Net, NetId, Outline, Role, Symbol};
use super::names;
use super::nesting::{self, Refusal};
use super::{Options, faces};

/// Elements in series with the room that they take.
type Nodes = Vec<Node>;

/// An element with the room that it takes.
#[derive(Debug)]
struct Node {
    part: Part,
    /// Columns of the grid.
    columns: usize,
    /// Contacts and boxes, one after another.
    contacts: usize,
    /// Columns of characters.
    characters: usize,
    /// Lines above and below the one of its wire.
    above: usize,
    below: usize,
    kind: &'static str,
    place: Place,
    before: NetId,
    after: NetId,
}

/// What an element is drawn as.
#[derive(Debug)]
enum Part {
    Figure(Figure),
    Parallel(Vec<Path>),
    /// A box, and the logic at its pins: lines below the power pin, logic.
    Boxed(Figure, Vec<(usize, Path)>),
}

/// A branch of a parallel or the logic of a pin: its elements, and the line that it begins and ends with.
#[derive(Debug)]
struct Path {
    nodes: Nodes,
    before: NetId,
    after: NetId,
}

/// A rung, or what is left of one after a row.
#[derive(Debug)]
struct Drawn {
    nodes: Nodes,
    before: NetId,
    after: NetId,
    tail: Tail,
}

/// The right end of a rung.
#[derive(Debug)]
enum Tail {
    Open,
    Outputs(Nodes),
    Branches(Vec<Drawn>),
    Stub(u32),
}

/// What a diagram is made with, and its nets so far.
struct Maker<'a> {
    options: &'a Options<'a>,
    nets: Vec<Net>,
    /// The last number of a line that is drawn elsewhere.
    stubs: u32,
}

impl Maker<'_> {
    fn net(&mut self, net: Net) -> NetId {
        self.nets.push(net);
        NetId(u32::try_from(self.nets.len() - 1).unwrap_or(u32::MAX))
    }

    fn value(&self, place: Place, operand: &str) -> Option<String> {
        self.options.status.and_then(|status| status.value(place, operand))
    }
}

/// Lays a network out as ladder.
///
/// # Errors
/// It nests too deep, or has an element that only a function block diagram has.
pub fn ladder(network: &Network, options: &Options<'_>) -> Result<Layout, Refusal> {
    nesting::check(network, nesting::only_function_plan)?;
    let mut maker = Maker { options, nets: Vec::new(), stubs: 0 };
    let rail = maker.net(Net::Rail);
    let mut layout = Layout::default();
    jump_label(network, &mut layout);
    match &network.content {
        Content::Empty => empty(&mut layout),
        Content::Alone(alone, place) => {
            let (above, mark) = faces::alone(alone);
            let node = maker.mark(true, mark, above, None, *place, identity::ALONE, (rail, rail));
            let lines = node.above + node.below + 1;
            let mut grid = Grid { rail: Some((0, lines - 1)), lines, columns: 1, ..Grid::default() };
            let Part::Figure(figure) = node.part else { return Ok(layout) };
            let (kind, line) = (node.kind, node.above);
            grid.cells.push(Cell { column: 0, line, figure, kind, place: *place, before: Some(rail), after: None });
            grid::join(vec![grid], &mut layout);
        }
        Content::Rung(rung) => {
            let drawn = maker.rung(rung, rail, measure::Begin::Rail);
            let rows = wrap::rows(drawn, &mut maker);
            grid::join(rows.into_iter().map(place::row).collect(), &mut layout);
        }
    }
    layout.nets = maker.nets;
    identity::name(&mut layout, options.line_of);
    Ok(layout)
}

/// A piece of rail alone.
pub(super) fn empty(layout: &mut Layout) {
    let top = layout.lines;
    layout.rails.push(super::layout::Rail { column: 0, from: top, to: top, side: super::layout::Side::Left });
    layout.columns = layout.columns.max(1);
    layout.lines += 1;
}

/// The label that jumps name, in a line of its own above all.
pub(super) fn jump_label(network: &Network, layout: &mut Layout) {
    let Some(label) = &network.label else { return };
    let text = format!("{}:", sieben_model::visible::name(label));
    layout.columns = names::width(&text) + 1;
    layout.lines = 1;
    let labels = vec![Label { column: 0, line: 0, text, role: Role::Jump }];
    layout.symbols.push(Symbol {
        kind: identity::JUMP_LABEL,
        element: String::new(),
        place: Place::default(),
        outline: Outline::None,
        labels,
        before: None,
        after: None,
        value: None,
    });
}
