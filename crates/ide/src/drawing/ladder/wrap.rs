//! Rows: a rung that is wider than the page goes on in the next row, from `»1` to `1»`, at the joint of its series that is nearest to the limit.
//!
//! Only where there is no such joint is a branch, or the logic of a pin, cut and drawn in a row of its own.

use std::collections::VecDeque;

use sieben_lang::network::model::Place;

use super::super::figures::Figure;
use super::super::identity::STUB;
use super::super::layout::NetId;
use super::measure::{cell, characters, contacts};
use super::{Drawn, Maker, Node, Nodes, Part, Path, Tail};

/// Columns of characters that the mark where a row goes on takes.
const STUB_COLUMNS: usize = 8;

/// Where a row begins.
#[derive(Debug)]
pub(super) enum Begin {
    /// At the rail.
    Rail,
    /// Where another row was cut.
    Stub(u32),
}

/// A row.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) begin: Begin,
    pub(super) drawn: Drawn,
}

/// What a row may take.
#[derive(Clone, Copy)]
struct Room {
    characters: usize,
    contacts: usize,
}

impl Room {
    fn less(self, characters: usize, contacts: usize) -> Self {
        Self { characters: self.characters.saturating_sub(characters), contacts: self.contacts.saturating_sub(contacts) }
    }
}

/// A rung in rows.
pub(super) fn rows(drawn: Drawn, maker: &mut Maker<'_>) -> Vec<Row> {
    let room = Room { characters: maker.options.columns, contacts: maker.options.contacts.max(1) };
    let first = Waiting { begin: Begin::Rail, drawn, more: VecDeque::new() };
    let mut wrapper = Wrapper { stubs: &mut maker.stubs, waiting: VecDeque::from([first]) };
    let mut rows = Vec::new();
    while let Some(mut row) = wrapper.waiting.pop_front() {
        let begin = if matches!(row.begin, Begin::Rail) { 0 } else { STUB_COLUMNS };
        let room = room.less(begin, 0);
        let mut more = std::mem::take(&mut row.more);
        if more.is_empty() {
            more = VecDeque::from(std::mem::take(&mut row.drawn.nodes));
        }
        row.take(&mut more, room);
        match more.is_empty() {
            true => {
                wrapper.fit(&mut row.drawn, room);
            }
            false => wrapper.fit_beginning(&mut row.drawn, more, room),
        }
        rows.push(Row { begin: row.begin, drawn: row.drawn });
    }
    rows
}

/// A row that is not laid out yet. What comes after its first elements waits apart from them, so that a long rung is looked at once.
struct Waiting {
    begin: Begin,
    drawn: Drawn,
    more: VecDeque<Node>,
}

impl Waiting {
    /// Takes elements until there are more than fit.
    fn take(&mut self, more: &mut VecDeque<Node>, room: Room) {
        let mut used = (0, 0);
        while fits(used.0, used.1, room)
            && let Some(node) = more.pop_front()
        {
            used = (used.0 + node.characters, used.1 + node.contacts);
            self.drawn.nodes.push(node);
        }
    }
}

struct Wrapper<'m> {
    stubs: &'m mut u32,
    waiting: VecDeque<Waiting>,
}

/// What became of a rung that was to fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fit {
    /// It stands in one row.
    Whole,
    /// Its rest waits at the end of those that wait.
    Cut,
}

fn fits(characters: usize, contacts: usize, room: Room) -> bool {
    characters <= room.characters && contacts <= room.contacts
}

/// Whether a T-branch is cut inside, not before: it is wider than a row anyway, and what stands before it leaves it half of one.
fn is_cut_inside(rungs: &[Drawn], left: Room, room: Room) -> bool {
    let row = room.less(STUB_COLUMNS, 0);
    let is_wide = rungs.iter().any(|rung| !fits(rung.characters(), rung.contacts(), row));
    let has_room = left.characters >= room.characters / 2 && left.contacts >= room.contacts / 2;
    let begins = |rung: &Drawn| rung.nodes.first().is_none_or(|first| fits(first.characters, first.contacts, left.less(STUB_COLUMNS, 0)));
    is_wide && has_room && rungs.iter().all(begins)
}

/// What is left of elements from a place on, where more than pieces of line is.
fn cut(nodes: &mut Nodes, index: usize) -> Option<Nodes> {
    let begin = nodes[index..].iter().position(|node| !node.is_gap())? + index;
    let rest = nodes.split_off(begin);
    nodes.truncate(index);
    Some(rest)
}

impl Tail {
    fn characters(&self) -> usize {
        match self {
            Self::Open => 0,
            Self::Outputs(outputs) => outputs.iter().map(|output| output.characters).max().unwrap_or(0) + 1,
            Self::Branches(rungs) => rungs.iter().map(Drawn::characters).max().unwrap_or(0),
            Self::Stub(_) => STUB_COLUMNS,
        }
    }

    fn contacts(&self) -> usize {
        match self {
            Self::Open | Self::Outputs(_) | Self::Stub(_) => 0,
            Self::Branches(rungs) => rungs.iter().map(Drawn::contacts).max().unwrap_or(0),
        }
    }
}

impl Drawn {
    fn characters(&self) -> usize {
        characters(&self.nodes) + self.tail.characters()
    }

    fn contacts(&self) -> usize {
        contacts(&self.nodes) + self.tail.contacts()
    }
}

impl Wrapper<'_> {
    fn number(&mut self) -> u32 {
        *self.stubs = self.stubs.saturating_add(1);
        *self.stubs
    }

    /// Makes the beginning of a rung fit, after which more elements come.
    fn fit_beginning(&mut self, drawn: &mut Drawn, mut more: VecDeque<Node>, room: Room) {
        let (tail, after) = (std::mem::replace(&mut drawn.tail, Tail::Open), drawn.after);
        if self.fit(drawn, room) == Fit::Cut
            && let Some(rest) = self.waiting.back_mut()
        {
            for node in std::mem::take(&mut rest.drawn.nodes).into_iter().rev() {
                more.push_front(node);
            }
            (rest.more, rest.drawn.tail) = (more, tail);
            return;
        }
        let number = self.number();
        let before = drawn.nodes.last().map_or(drawn.before, |last| last.after);
        (drawn.tail, drawn.after) = (Tail::Stub(number), before);
        let rest = Drawn { nodes: Nodes::new(), before, after, tail };
        self.waiting.push_back(Waiting { begin: Begin::Stub(number), drawn: rest, more });
    }

    /// Makes a rung fit; what does not waits for a row of its own.
    fn fit(&mut self, drawn: &mut Drawn, room: Room) -> Fit {
        if fits(drawn.characters(), drawn.contacts(), room) {
            return Fit::Whole;
        }
        let mut used = (0, 0);
        let mut cut = None;
        for (index, node) in drawn.nodes.iter_mut().enumerate() {
            let left = room.less(used.0 + STUB_COLUMNS, used.1);
            if !fits(node.characters, node.contacts, left) {
                if index > 0 {
                    cut = Some(index);
                    break;
                }
                self.shrink(node, left);
            }
            used = (used.0 + node.characters, used.1 + node.contacts);
        }
        let left = room.less(used.0, used.1);
        if cut.is_none() && !fits(drawn.tail.characters(), drawn.tail.contacts(), left) {
            match &mut drawn.tail {
                Tail::Branches(rungs) if drawn.nodes.is_empty() || is_cut_inside(rungs, left, room) => rungs.iter_mut().for_each(|rung| {
                    self.fit(rung, left);
                }),
                _ if !drawn.nodes.is_empty() => cut = Some(drawn.nodes.len()),
                _ => {}
            }
        }
        let Some(index) = cut else { return Fit::Whole };
        let number = self.number();
        let nodes = self::cut(&mut drawn.nodes, index).unwrap_or_default();
        let after = drawn.nodes.last().map_or(drawn.before, |last| last.after);
        let tail = std::mem::replace(&mut drawn.tail, Tail::Stub(number));
        let rest = Drawn { nodes, before: after, after: drawn.after, tail };
        drawn.after = after;
        self.waiting.push_back(Waiting { begin: Begin::Stub(number), drawn: rest, more: VecDeque::new() });
        Fit::Cut
    }

    /// Makes an element fit that is wider than a row: its branches, or the logic at its pins, go on elsewhere.
    fn shrink(&mut self, node: &mut Node, room: Room) {
        match &mut node.part {
            Part::Figure(_) => return,
            Part::Parallel(paths) => paths.iter_mut().for_each(|path| self.shrink_branch(path, room)),
            Part::Boxed(figure, logic) => {
                let left = room.less(figure.width() + 4, 1);
                for (_, path) in logic {
                    if !fits(path.characters(), path.contacts(), left) {
                        self.cut_pin(path);
                    }
                }
            }
        }
        node.settle();
    }

    fn shrink_branch(&mut self, path: &mut Path, room: Room) {
        if fits(path.characters(), path.contacts(), room) {
            return;
        }
        let mut used = (0, 0);
        let mut cut = None;
        // What is cut comes back at the end of the branch.
        let room = room.less(2 * STUB_COLUMNS, 0);
        for (index, node) in path.nodes.iter_mut().enumerate() {
            let left = room.less(used.0, used.1);
            if !fits(node.characters, node.contacts, left) {
                if index > 0 {
                    cut = Some(index);
                    break;
                }
                self.shrink(node, left);
            }
            used = (used.0 + node.characters, used.1 + node.contacts);
        }
        let Some(nodes) = cut.and_then(|index| self::cut(&mut path.nodes, index)) else { return };
        let before = path.nodes.last().map_or(path.before, |last| last.after);
        let (out, back) = (self.number(), self.number());
        path.nodes.push(stub(Figure::StubOut(out), before));
        path.nodes.push(stub(Figure::StubIn(back), path.after));
        self.later(Begin::Stub(out), nodes, before, path.after, back);
    }

    fn cut_pin(&mut self, path: &mut Path) {
        let number = self.number();
        let nodes = std::mem::take(&mut path.nodes);
        path.nodes.push(stub(Figure::StubIn(number), path.after));
        self.later(Begin::Rail, nodes, path.before, path.after, number);
    }

    fn later(&mut self, begin: Begin, nodes: Nodes, before: NetId, after: NetId, end: u32) {
        let drawn = Drawn { nodes, before, after, tail: Tail::Stub(end) };
        self.waiting.push_back(Waiting { begin, drawn, more: VecDeque::new() });
    }
}

/// The mark where a line goes on elsewhere or comes from there.
pub(super) fn stub(figure: Figure, net: NetId) -> Node {
    cell(figure, STUB, Place::default(), (net, net))
}
