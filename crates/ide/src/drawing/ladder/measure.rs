//! How much room each element takes, and which line enters and leaves it: from the innermost element to the rung.

use sieben_lang::network::model::{Branch, Element, End, Kind, Line, Place, Rung};
use sieben_lang::network::operand::Operand;

use super::super::faces::{self, Face, Wired};
use super::super::figures::{BoxFigure, Figure, Mark, PinFigure};
use super::super::identity::{STUB, kind_of, kind_of_output};
use super::super::layout::{Net, NetId, Role};
use super::super::names::{NAME_COLUMNS_MAX, PIN_COLUMNS_MAX, wrapped};
use super::{Drawn, Maker, Node, Nodes, Part, Path, Tail};

/// What is written where nothing is wired to a pin.
pub(in crate::drawing) const OPEN: &str = "...";

/// Lines above and below a wire that elements in series need.
pub(super) fn heights(nodes: &[Node]) -> (usize, usize) {
    nodes.iter().fold((0, 0), |(above, below), node| (above.max(node.above), below.max(node.below)))
}

/// Lines above the first and below the first of things under one another, each with lines above and below its own.
pub(in crate::drawing) fn stacked(sizes: impl Iterator<Item = (usize, usize)>) -> (usize, usize) {
    let (mut first_above, mut last_wire, mut last_below, mut is_first) = (0, 0, 0, true);
    for (above, below) in sizes {
        if is_first {
            first_above = above;
        } else {
            last_wire += last_below + above + 1;
        }
        last_below = below;
        is_first = false;
    }
    (first_above, last_wire + last_below)
}

/// Columns of characters of elements in series: each has a border at its left.
pub(super) fn characters(nodes: &[Node]) -> usize {
    nodes.iter().map(|node| node.characters).sum()
}

/// Contacts of elements in series, one after another.
pub(super) fn contacts(nodes: &[Node]) -> usize {
    nodes.iter().map(|node| node.contacts).sum()
}

/// Columns of the grid of elements in series.
pub(super) fn columns(nodes: &[Node]) -> usize {
    nodes.iter().map(|node| node.columns).sum()
}

/// Where an element begins.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Begin {
    /// At the rail, which is vertical already.
    Rail,
    /// At a line.
    Line,
}

/// A piece of line that keeps two vertical ones apart.
fn gap(net: NetId) -> Node {
    cell(Figure::Gap, STUB, Place::default(), (net, net))
}

impl Path {
    /// With a piece of line after branches that end where it ends.
    fn closed(mut self) -> Self {
        if self.nodes.last().is_some_and(Node::is_parallel) {
            self.nodes.push(gap(self.after));
        }
        self
    }

    pub(super) fn characters(&self) -> usize {
        characters(&self.nodes)
    }

    pub(super) fn columns(&self) -> usize {
        columns(&self.nodes)
    }

    pub(super) fn contacts(&self) -> usize {
        contacts(&self.nodes)
    }
}

impl Node {
    /// A piece of line alone.
    pub(super) fn is_gap(&self) -> bool {
        matches!(self.part, Part::Figure(Figure::Gap))
    }

    fn is_parallel(&self) -> bool {
        matches!(self.part, Part::Parallel(_))
    }

    /// A parallel with the room that its branches take now.
    pub(super) fn settle(&mut self) {
        match &self.part {
            Part::Figure(_) => {}
            Part::Parallel(paths) => {
                self.columns = paths.iter().map(Path::columns).max().unwrap_or(0).max(1);
                self.contacts = paths.iter().map(Path::contacts).max().unwrap_or(0);
                self.characters = paths.iter().map(Path::characters).max().unwrap_or(0).max(3);
                (self.above, self.below) = stacked(paths.iter().map(|path| heights(&path.nodes)));
            }
            Part::Boxed(figure, logic) => {
                let columns = logic.iter().map(|(_, path)| path.columns()).max().unwrap_or(0);
                let characters = logic.iter().map(|(_, path)| path.characters()).max().unwrap_or(0);
                // A column keeps the rail of the pins away from what stands to the left.
                let gap = usize::from(!logic.is_empty());
                self.columns = columns + 1 + gap;
                self.contacts = logic.iter().map(|(_, path)| path.contacts()).max().unwrap_or(0) + 1;
                self.characters = characters + figure.width() + 1 + gap * 3;
                let (above, below) = figure.heights();
                let deepest = logic.last().map_or(0, |(offset, path)| offset + heights(&path.nodes).1);
                (self.above, self.below) = (above, below.max(deepest));
            }
        }
    }
}

impl Maker<'_> {
    pub(super) fn rung(&mut self, rung: &Rung, before: NetId, begin: Begin) -> Drawn {
        let (mut nodes, after) = self.line(&rung.line, before, begin);
        let tail = match &rung.end {
            End::Open => Tail::Open,
            End::Outputs(outputs) => {
                let coil = |output: &sieben_lang::network::model::Output| {
                    let coil = faces::coil(output);
                    let value = coil.value.map(|(_, value)| value);
                    let mark = if coil.mark.is_empty() { " " } else { coil.mark };
                    self.mark(true, mark, coil.above, value, output.place, kind_of_output(&output.kind), (after, after))
                };
                Tail::Outputs(outputs.iter().map(coil).collect())
            }
            End::Branches(rungs) => Tail::Branches(rungs.iter().map(|rung| self.sub_rung(rung, after)).collect()),
        };
        let splits = match &tail {
            Tail::Open | Tail::Stub(_) => false,
            Tail::Outputs(outputs) => outputs.len() > 1,
            Tail::Branches(_) => true,
        };
        if splits && nodes.last().is_some_and(Node::is_parallel) {
            nodes.push(gap(after));
        }
        Drawn { nodes, before, after, tail }
    }

    fn sub_rung(&mut self, rung: &Rung, tapped: NetId) -> Drawn {
        let before = self.net(Net::Tapped { before: tapped, place: rung.tap });
        let mut drawn = self.rung(rung, before, Begin::Line);
        if drawn.nodes.first().is_some_and(Node::is_parallel) {
            drawn.nodes.insert(0, gap(before));
        }
        drawn
    }

    fn line(&mut self, line: &[Element], mut before: NetId, mut begin: Begin) -> (Nodes, NetId) {
        let mut nodes = Vec::with_capacity(line.len());
        for element in line {
            if let Kind::Group { line, .. } = &element.kind {
                let (mut inner, after) = self.line(line, before, begin);
                nodes.append(&mut inner);
                before = after;
                begin = Begin::Line;
                continue;
            }
            let node = self.element(element, before, begin);
            begin = Begin::Line;
            if node.is_parallel() && nodes.last().is_some_and(Node::is_parallel) {
                nodes.push(gap(before));
            }
            before = node.after;
            nodes.push(node);
        }
        (nodes, before)
    }

    /// A branch; at the rail it begins there.
    fn branch(&mut self, line: &Line, element: &Element, before: NetId, begin: Begin) -> Path {
        if begin == Begin::Rail {
            let (nodes, after) = self.line(line, before, begin);
            return Path { nodes, before, after }.closed();
        }
        let mut path = self.path(line, element.place);
        if path.nodes.first().is_some_and(Node::is_parallel) {
            path.nodes.insert(0, gap(path.before));
        }
        path.closed()
    }

    /// Logic that begins at a branch or at a rail of its own.
    fn path(&mut self, line: &Line, begin: Place) -> Path {
        let place = line.first().map_or(begin, |first| first.place);
        let before = self.net(Net::Start(place));
        let (nodes, after) = self.line(line, before, Begin::Line);
        Path { nodes, before, after }
    }

    fn element(&mut self, element: &Element, before: NetId, begin: Begin) -> Node {
        let place = element.place;
        let kind = kind_of(&element.kind);
        match &element.kind {
            Kind::Contact { operand, negated } => {
                let after = self.net(Net::After { before, place, negated: *negated });
                let stroke = if *negated { "/" } else { "" };
                match operand.is_status() {
                    true => self.mark(false, &format!("{stroke}{operand}"), "", None, place, kind, (before, after)),
                    false => self.mark(false, if *negated { "/" } else { " " }, operand, None, place, kind, (before, after)),
                }
            }
            Kind::Compare { operation, left, right, .. } => {
                let after = self.net(Net::After { before, place, negated: false });
                self.two_operands(operation, left, Some(right), element, (before, after))
            }
            Kind::EdgeBox { falling, operand, memory } => {
                let after = self.net(Net::After { before, place, negated: false });
                let mark = match (memory, falling) {
                    (Some(_), false) => "POS",
                    (Some(_), true) => "NEG",
                    (None, false) => "P",
                    (None, true) => "N",
                };
                self.two_operands(mark, operand, memory.as_ref(), element, (before, after))
            }
            Kind::Edge { falling, memory } => {
                let after = self.net(Net::Found(place));
                self.mark(true, if *falling { "N" } else { "P" }, memory, None, place, kind, (before, after))
            }
            Kind::Not => {
                let after = self.net(Net::Not(before));
                self.mark(false, "NOT", "", None, place, kind, (before, after))
            }
            Kind::Midline { operand, .. } => {
                let after = self.net(Net::Found(place));
                self.mark(true, "#", operand, None, place, kind, (before, after))
            }
            Kind::Parallel { branches, .. } => self.parallel(branches, element, before, begin),
            _ => match faces::face(&element.kind) {
                Some(face) => self.boxed(&face, element, before),
                // Refused before anything is drawn.
                None => self.mark(false, "?", "", None, place, kind, (before, before)),
            },
        }
    }

    fn parallel(&mut self, branches: &[Branch], element: &Element, before: NetId, begin: Begin) -> Node {
        let paths: Vec<Path> = branches.iter().map(|branch| self.branch(&branch.line, element, before, begin)).collect();
        let after = self.net(Net::Join { before, branches: paths.iter().map(|path| path.after).collect() });
        let (kind, place) = (kind_of(&element.kind), element.place);
        let mut node =
            Node { part: Part::Parallel(paths), columns: 0, contacts: 0, characters: 0, above: 0, below: 0, kind, place, before, after };
        node.settle();
        node
    }

    /// A contact or coil: what stands in it, the operand above, a second one below.
    #[expect(clippy::too_many_arguments, reason = "the parts of one symbol")]
    pub(super) fn mark(
        &mut self,
        is_coil: bool,
        mark: &str,
        above: &str,
        below: Option<&str>,
        place: Place,
        kind: &'static str,
        (before, after): (NetId, NetId),
    ) -> Node {
        let named = |text: &str| wrapped(text, NAME_COLUMNS_MAX).into_iter().map(|line| (line, Role::Name)).collect::<Vec<_>>();
        let value = if above.is_empty() { None } else { self.value(place, above) };
        let mut under = below.map(named).unwrap_or_default();
        under.extend(below.and_then(|below| self.value(place, below)).or_else(|| value.clone()).map(|value| (value, Role::Value)));
        let figure = Figure::Mark(Mark { is_coil, mark: mark.to_owned(), above: named(above), below: under, value });
        cell(figure, kind, place, (before, after))
    }

    /// A contact with an operand above and one below, each with its value.
    fn two_operands(&mut self, mark: &str, top: &Operand, bottom: Option<&Operand>, element: &Element, nets: (NetId, NetId)) -> Node {
        let place = element.place;
        let named = |operand: &Operand| {
            let lines = wrapped(operand, NAME_COLUMNS_MAX).into_iter().map(|line| (line, Role::Name));
            lines.chain(self.value(place, operand).map(|value| (value, Role::Value))).collect::<Vec<_>>()
        };
        let (above, below) = (named(top), bottom.map(named).unwrap_or_default());
        let value = self.value(place, top);
        let figure = Figure::Mark(Mark { is_coil: false, mark: mark.to_owned(), above, below, value });
        cell(figure, kind_of(&element.kind), place, nets)
    }

    fn boxed(&mut self, face: &Face<'_>, element: &Element, before: NetId) -> Node {
        let place = element.place;
        let mut left = vec![PinFigure { net: Some(before), ..PinFigure::new(0, face.power) }];
        let mut logic = Vec::new();
        let mut at = 0;
        for input in &face.inputs {
            let mut pin = PinFigure { negated: input.negated, ..PinFigure::new(at + 1, input.name) };
            match &input.wired {
                Wired::Open => pin.actual = vec![OPEN.to_owned()],
                Wired::Operand(operand) => {
                    pin.actual = wrapped(operand, PIN_COLUMNS_MAX);
                    pin.value = self.value(place, operand).or_else(|| self.value(place, input.name));
                }
                Wired::Contact(contact, operand) => {
                    let net = self.net(Net::Found(contact.place));
                    pin.actual = wrapped(operand, PIN_COLUMNS_MAX);
                    pin.value = self.value(contact.place, operand);
                    pin.element = Some((kind_of(&contact.kind), contact.place, net));
                }
                Wired::Logic(line) => {
                    let mut path = self.path(line, place);
                    if face.hands_values_on
                        && let Some(Node { part: Part::Boxed(Figure::Box(figure), _), .. }) = path.nodes.last_mut()
                    {
                        figure.hand_value_on(line);
                    }
                    let (above, below) = heights(&path.nodes);
                    pin.offset = at + above + 1;
                    pin.net = Some(path.after);
                    at = pin.offset + below;
                    logic.push((pin.offset, path));
                }
            }
            at = at.max(pin.offset + pin.actual.len().saturating_sub(1));
            left.push(pin);
        }
        let mut right = vec![PinFigure::new(0, face.flow)];
        let mut at_right = 0;
        for (name, operand) in &face.outputs {
            at_right += 1;
            let mut pin = PinFigure::new(at_right, name);
            pin.actual = operand.map_or_else(|| vec![OPEN.to_owned()], |operand| wrapped(operand, PIN_COLUMNS_MAX));
            pin.value = operand.and_then(|operand| self.value(place, operand).or_else(|| self.value(place, name)));
            at_right += pin.actual.len().saturating_sub(1);
            right.push(pin);
        }
        let value = if face.above.is_empty() { None } else { self.value(place, face.above) };
        let height = left.last().map_or(0, |pin| pin.offset + pin.actual.len().saturating_sub(1)).max(at_right) + 1;
        let title = sieben_model::visible::name(&face.title);
        let figure = Figure::Box(BoxFigure { title, above: wrapped(face.above, PIN_COLUMNS_MAX), left, right, height, value });
        let after = self.net(Net::Found(place));
        let kind = kind_of(&element.kind);
        let mut node = Node {
            part: Part::Boxed(figure, logic),
            columns: 0,
            contacts: 0,
            characters: 0,
            above: 0,
            below: 0,
            kind,
            place,
            before,
            after,
        };
        node.settle();
        node
    }
}

/// A figure that takes one column.
pub(super) fn cell(figure: Figure, kind: &'static str, place: Place, (before, after): (NetId, NetId)) -> Node {
    let (above, below) = figure.heights();
    let characters = figure.width() + 1;
    let contacts = usize::from(matches!(figure, Figure::Mark(_) | Figure::Box(_)));
    Node { part: Part::Figure(figure), columns: 1, contacts, characters, above, below, kind, place, before, after }
}
