//! Two loops in one another that change places: where each turn of the outer one adds something to the same elements
//! (`c[i, j] := c[i, j] + f * b[k, j]` with `j` inside), the elements stay in registers while the turns of the outer loop are made for
//! them, many elements side by side.

use std::cell::RefCell;
use std::collections::BTreeSet;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_model::address::Width;

use super::super::loops::Loop;
use super::super::value::Val;
use super::kernel::{Cell, Kept, Kernel, Level, Node, Step, Turn, What};
use super::line::Carried;
use super::write::Writing;
use super::{InnerTurns, Plan, Writes, count};

/// The loops with the inner one around the other.
pub(super) struct Swapped {
    plan: Plan,
    /// Turns of what was the inner loop that are done side by side.
    lanes: u32,
    /// Where the counters of what was the inner loop begin, as values of the loops as they stand.
    starts: Vec<(Cell, Node)>,
    /// What cells hold behind both loops.
    ends: Vec<(Cell, End)>,
}

/// What a cell holds behind both loops.
#[derive(Clone, Copy)]
enum End {
    /// What a counter of the loop that was inside comes to.
    Inner(Cell),
    /// What one of the loop around it comes to.
    Outer,
    /// What the last of all turns makes of a cell: a value of the swapped loops.
    Last(Node),
}

impl Plan {
    /// The loops with the inner one around the other, if they may change places and its turns can be done side by side then.
    pub(super) fn swapped(&self) -> Option<Swapped> {
        let (kernel, starts, ends) = self.kernel.swapped()?;
        let counts = [Level::Outer, Level::Inner].map(|level| count::condition(&kernel, level));
        let [Some(count), Some(inner)] = counts else { return None };
        let plan = Self { kernel, count, inner: InnerTurns::Counted(inner) };
        // What the last turn leaves is one of the values side by side.
        let has_form = |node: Node| match plan.kernel.what(node) {
            What::After(cell) => plan.kernel.turn(Level::Inner).ends.get(&cell).is_some_and(|&end| plan.kernel.shape(end).is_some()),
            _ => false,
        };
        if !ends.iter().all(|&(_, end)| if let End::Last(node) = end { has_form(node) } else { true }) {
            return None;
        }
        let &[most, least] = plan.lanes().as_slice() else { return None };
        let lanes = match self.inner {
            InnerTurns::Counted(_) => most,
            InnerTurns::Constant(turns) => {
                let mut possible = [most, most / 2, most / 4, most / 8].into_iter();
                possible.find(|&lanes| lanes >= least && turns % i64::from(lanes) == 0)?
            }
        };
        Some(Swapped { plan, lanes, starts, ends })
    }
}

/// Cells with something for each.
type Of<T> = Vec<(Cell, T)>;

impl Kernel {
    /// The same turns in another order: all of the outer loop for one turn of the inner one, then those for the next.
    fn swapped(&self) -> Option<(Self, Of<Node>, Of<End>)> {
        let inner = self.inner.as_ref()?;
        let copies = self.outer.steps.iter().chain(&inner.steps).any(|step| matches!(step, Step::Copy(_)));
        let elements = self.elements_of_all_turns(inner).filter(|_| !copies)?;
        let mut kernel = Self { lines: RefCell::default(), shapes: RefCell::default(), ..self.clone() };
        (kernel.required, kernel.required_inside, kernel.settled) = (Vec::new(), Vec::new(), Vec::new());
        kernel.looked_at.clear();

        // The counters of the inner loop, and what its last turn leaves.
        let mut starts = Vec::new();
        let (mut outer_ends, mut inner_ends) = (Turn::default().ends, Turn::default().ends);
        for (cell, end, carried) in self.carried(Level::Inner) {
            match carried {
                Carried::Line(_) => {
                    let entry = *inner.entry.get(&cell)?;
                    if !self.is_same_in_all_turns(entry) {
                        return None;
                    }
                    starts.push((cell, entry));
                    outer_ends.insert(cell, end);
                }
                Carried::Nothing => drop(inner_ends.insert(cell, end)),
                _ => return None,
            }
        }
        let mut ends = Vec::new();
        for (&cell, &end) in &self.outer.ends {
            if matches!(self.kept(cell), Kept::Budget | Kept::Clock) {
                return None;
            }
            if let What::After(after) = self.what(end) {
                if outer_ends.contains_key(&after) {
                    ends.push((cell, End::Inner(after)));
                } else if after == cell && inner_ends.contains_key(&after) {
                    ends.push((cell, End::Last(end)));
                } else {
                    return None;
                }
                continue;
            }
            inner_ends.insert(cell, end);
            let after = kernel.add(What::After(cell));
            let is_line = self.cell_line(Level::Outer, cell).is_some();
            ends.push((cell, if is_line { End::Outer } else { End::Last(after) }));
        }

        // Elements begin with what they hold in front of both loops.
        let mut outer = Turn { again: inner.again, ends: outer_ends, ..Turn::default() };
        let mut into = Turn { again: self.outer.again, ..Turn::default() };
        let mut writes = Vec::new();
        for &(read, write) in &elements {
            let (width, value) = (self.accesses[write].width, self.accesses[write].value?);
            let cell = Cell::numbered(u16::try_from(kernel.cells.len()).ok()?);
            kernel.cells.push(Kept::Element { number: u16::try_from(write).ok()?, width });
            let [before, after] = [What::Read(read), What::After(cell)].map(|what| kernel.add(what));
            into.entry.insert(cell, before);
            inner_ends.insert(cell, value);
            kernel.nodes[self.reads[read].number() as usize] = What::Start(Level::Inner, cell);
            kernel.reads[read] = before;
            kernel.accesses[write].value = Some(after);
            outer.steps.push(Step::Access(read));
            writes.push(Step::Access(write));
        }
        outer.steps.push(Step::Inner);
        outer.steps.extend(writes);
        let is_element = |number: usize| elements.iter().any(|&(read, write)| number == read || number == write);
        for (number, access) in kernel.accesses.iter_mut().enumerate() {
            access.level = if is_element(number) { Level::Outer } else { Level::Inner };
        }
        let all = self.outer.steps.iter().flat_map(|step| match step {
            Step::Inner => inner.steps.as_slice(),
            step => std::slice::from_ref(step),
        });
        into.steps = all.copied().filter(|step| matches!(*step, Step::Access(number) if !is_element(number))).collect();

        // What one loop began with, the other one does now.
        for number in 0..self.nodes.len() {
            let node = Node::numbered(number as u32);
            kernel.nodes[number] = match self.what(node) {
                What::Start(Level::Inner, cell) => What::Start(Level::Outer, cell),
                What::Start(Level::Outer, cell) if self.outer.ends.contains_key(&cell) => What::Start(Level::Inner, cell),
                _ => continue,
            };
        }
        for &cell in inner_ends.keys() {
            into.entry.entry(cell).or_insert_with(|| kernel.add(What::Start(Level::Outer, cell)));
        }
        into.ends = inner_ends;
        let counters: BTreeSet<Cell> = inner.ends.keys().copied().collect();
        (kernel.outer, kernel.inner) = (outer, Some(into));
        kernel.needs_no_order(self, &counters).then_some((kernel, starts, ends))
    }

    /// The elements that each turn of the outer loop reads and writes again, by their two accesses; `None` if anything else is written, or
    /// somebody else may read them.
    fn elements_of_all_turns(&self, inner: &Turn) -> Option<Vec<(usize, usize)>> {
        let mut elements = Vec::new();
        for (write, access) in self.accesses.iter().enumerate().filter(|(_, access)| access.value.is_some()) {
            if access.level == Level::Outer || access.width == Width::Bit || !self.is_same_in_all_turns(access.pointer) {
                return None;
            }
            let others = (0..self.accesses.len()).filter(|&other| other != write);
            let (same, others): (Vec<usize>, Vec<usize>) = others.partition(|&other| access.is_same(&self.accesses[other]));
            let &[read] = same.as_slice() else { return None };
            let is_first = |number: &usize| inner.steps.iter().position(|step| *step == Step::Access(*number));
            let follows = is_first(&read).is_some_and(|read| is_first(&write).is_some_and(|write| read < write));
            if !follows || self.accesses[read].value.is_some() || others.iter().any(|&other| access.may_share(&self.accesses[other])) {
                return None;
            }
            elements.push((read, write));
        }
        (!elements.is_empty()).then_some(elements)
    }

    /// Whether the turns of swapped loops need nothing that only those of the loops as they stood know: what the inner one left, and what
    /// its cells held in front of it.
    fn needs_no_order(&self, before: &Self, counters: &BTreeSet<Cell>) -> bool {
        let of_accesses = self.accesses.iter().map(|access| access.pointer);
        let values = before.accesses.iter().filter_map(|access| access.value);
        let inner = self.inner.iter().flat_map(|inner| inner.ends.values().copied().chain([inner.again]));
        let mut waiting: Vec<Node> = of_accesses.chain(values).chain(inner).chain(self.outer.ends.values().copied()).collect();
        waiting.push(self.outer.again);
        let mut seen = BTreeSet::new();
        while let Some(node) = waiting.pop() {
            if !seen.insert(node) {
                continue;
            }
            let stood = if (node.number() as usize) < before.nodes.len() { before.what(node) } else { What::Constant(0) };
            match stood {
                What::After(_) => return false,
                What::Start(Level::Outer, cell) if counters.contains(&cell) => return false,
                What::Compute(op, args) => waiting.extend(&args[..op.arity()]),
                What::Read(_) | What::Start(..) | What::Constant(_) => {}
            }
        }
        true
    }
}

impl Writing<'_, '_, '_> {
    /// Writes turns of loops that change places, as many of the outer one as nobody asks about.
    pub(super) fn swapped(mut self, swapped: &Swapped, it: &Loop) {
        let Swapped { plan, lanes, starts, ends } = swapped;
        self.t.settle_bytes();
        self.take_before();
        let (turns, mut guard, all) = self.how_many();
        let inner_turns = self.all_inner_turns();
        if matches!(self.plan.inner, InnerTurns::Counted(_)) {
            let rest = self.t.b.ins().band_imm_s(inner_turns, i64::from(lanes - 1));
            let none = self.t.b.ins().icmp_imm_s(IntCC::Equal, rest, 0);
            guard = self.t.b.ins().band(guard, none);
        }
        let [enter, go_on] = [self.t.b.create_block(), self.t.b.create_block()];
        self.t.b.ins().brif(guard, enter, &[], go_on, &[]);
        self.t.b.switch_to_block(enter);
        self.t.b.seal_block(enter);
        let mut before = self.before.clone();
        for &(cell, entry) in starts {
            before.insert(cell, self.value_before(entry));
        }
        let mut writing = Writing::new(self.t, plan, Writes::lanes(*lanes));
        writing.before.clone_from(&before);
        let last = writing.all_swapped((turns, inner_turns), ends, self.kernel);
        for (cell, value) in last {
            self.t.write_cell(self.kernel, cell, value);
        }
        self.t.settle_bytes();
        self.leave_whole(it, (turns, all), go_on);
    }

    /// All turns of loops that changed places; what cells hold behind them.
    fn all_swapped(mut self, (outer, inner): (Value, Value), ends: &[(Cell, End)], stood: &Kernel) -> Vec<(Cell, Val)> {
        self.turns_inside(outer);
        self.turns(Level::Outer, inner);
        let mut last = Vec::new();
        for &(cell, end) in ends {
            let value = match end {
                End::Inner(counter) => {
                    let line = self.kernel.cell_line(Level::Outer, counter);
                    let before = self.before[&counter];
                    line.map(|line| self.t.behind(before, line, inner))
                }
                End::Outer => {
                    let before = self.before[&cell];
                    stood.cell_line(Level::Outer, cell).map(|line| self.t.behind(before, line, outer))
                }
                End::Last(node) => {
                    let value = self.value(node, Level::Outer);
                    Some(self.t.last_lane(&value, self.lanes))
                }
            };
            last.push((cell, value.unwrap_or_else(|| unreachable!("counters are on lines"))));
        }
        last
    }
}
