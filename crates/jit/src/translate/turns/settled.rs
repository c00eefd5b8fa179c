//! Conditions that are the same in all turns and on one side of which a turn leaves variables as they were: `IF first_scan THEN …`. They are
//! looked at in front of the loop, and a version of it for that side neither reads nor writes these variables.

use std::collections::BTreeMap;

use sieben_engine::ir::Op;

use super::kernel::{Access, Kernel, Node, Step, What};

/// Larger loops are not written once more.
const NODES_MAX: usize = 600;
/// Conditions that are looked at.
const CONDITIONS_MAX: usize = 4;
/// How far choices in one another, and conditions made of others, are followed.
const DEPTH_MAX: usize = 6;

impl Kernel {
    /// The same loop where such conditions are as they leave most variables alone, if there are any.
    pub(super) fn settled(&self) -> Option<Self> {
        if self.inner.is_some() || self.nodes.len() > NODES_MAX {
            return None;
        }
        let mut kernel: Option<Self> = None;
        for _ in 0..CONDITIONS_MAX {
            let now = kernel.as_ref().unwrap_or(self);
            let Some((condition, holds)) = now.most_kept() else { break };
            let mut next = now.clone();
            next.settle(condition, holds);
            kernel = Some(next);
        }
        kernel
    }

    /// The condition on one side of which most writes leave the variable as it was, and whether it holds there.
    fn most_kept(&self) -> Option<(Node, bool)> {
        let mut sides: BTreeMap<(Node, bool), usize> = BTreeMap::new();
        for access in &self.accesses {
            let mut found = Vec::new();
            access.value.iter().for_each(|&value| self.kept_where(access, value, DEPTH_MAX, &mut found));
            found.sort_unstable();
            found.dedup();
            found.into_iter().for_each(|side| *sides.entry(side).or_default() += 1);
        }
        sides.into_iter().max_by_key(|&(side, count)| (count, std::cmp::Reverse(side))).map(|(side, _)| side)
    }

    /// Conditions under which what is written is what the variable held.
    fn kept_where(&self, access: &Access, value: Node, depth: usize, found: &mut Vec<(Node, bool)>) {
        let What::Compute(op, [first, a, b, _]) = self.what(value) else { return };
        let before = |node: Node| matches!(self.what(node), What::Read(read) if self.accesses[read].is_same(access));
        let (condition, holds) = match op {
            Op::Select if before(b) => (first, false),
            Op::Select if before(a) => (first, true),
            Op::Select if depth > 0 => {
                return [a, b].into_iter().for_each(|side| self.kept_where(access, side, depth - 1, found));
            }
            Op::Or if before(a) => (first, false),
            Op::Or if before(first) => (a, false),
            Op::And if before(a) => (first, true),
            Op::And if before(first) => (a, true),
            Op::AndNot if before(first) => (a, false),
            _ => return,
        };
        found.extend(self.same_condition(condition, holds, DEPTH_MAX));
    }

    /// A condition that is the same in all turns and makes another one hold, or not hold.
    fn same_condition(&self, condition: Node, holds: bool, depth: usize) -> Option<(Node, bool)> {
        let What::Compute(op, [a, b, ..]) = self.what(condition) else {
            return self.is_settled_in_front(condition).then_some((condition, holds));
        };
        if op == Op::Not {
            return self.same_condition(a, !holds, depth.checked_sub(1)?);
        }
        if self.is_settled_in_front(condition) {
            return Some((condition, holds));
        }
        let depth = depth.checked_sub(1)?;
        let (first, second) = match (op, holds) {
            (Op::And, false) | (Op::Or, true) => ((a, holds), (b, holds)),
            (Op::AndNot, false) => ((a, false), (b, true)),
            _ => return None,
        };
        [first, second].into_iter().find_map(|(part, holds)| self.same_condition(part, holds, depth))
    }

    /// Whether all conditions that are looked at in front of the loop are the same in all turns.
    pub(super) fn settles_in_front(&self) -> bool {
        self.settled.iter().all(|&(condition, _)| self.is_same_in_all_turns(condition))
    }

    /// Whether a condition can be looked at in front of the loop for all turns.
    fn is_settled_in_front(&self, node: Node) -> bool {
        self.is_same_in_all_turns(node) && self.is_bit(node) && self.constant(node).is_none()
    }

    /// Makes a condition a constant, which is looked at in front of the loop.
    fn settle(&mut self, condition: Node, holds: bool) {
        let what = self.what(condition);
        let place = condition.number() as usize;
        self.nodes[place] = What::Constant(u64::from(holds));
        let moved = self.add(what);
        self.settled.push((moved, holds));
        self.simplify();
    }

    /// Leaves out what constants make superfluous.
    pub(super) fn simplify(&mut self) {
        // Conditions that were made of two stand behind all others.
        for _ in 0..2 {
            self.fold_constants();
            self.shorten_choices();
        }
        self.forget_what_stays();
        self.forget_unread();
        self.lines.borrow_mut().clear();
        self.shapes.borrow_mut().clear();
    }

    fn fold_constants(&mut self) {
        for number in 0..self.nodes.len() {
            let What::Compute(op, mut args) = self.nodes[number] else { continue };
            let used = op.arity();
            args[..used].iter_mut().for_each(|arg| *arg = self.without_copies(*arg));
            let constants = args.map(|arg| self.constant(arg));
            let copy = |node: Node| What::Compute(Op::Copy, [node; 4]);
            let [first, second, ..] = constants;
            self.nodes[number] = match op {
                _ if constants[..used].iter().all(Option::is_some) => {
                    What::Constant(op.eval(constants.map(|constant| constant.unwrap_or(0))))
                }
                Op::Select if let Some(condition) = first => copy(if condition & 1 != 0 { args[1] } else { args[2] }),
                Op::Select if args[1] == args[2] => copy(args[1]),
                Op::Gate if let Some(condition) = second => {
                    if condition & 1 != 0 {
                        copy(args[0])
                    } else {
                        What::Constant(0)
                    }
                }
                Op::AddU32 | Op::SubU32 if second == Some(0) && self.is_32_bits(args[0]) => copy(args[0]),
                Op::AddU16 | Op::SubU16 if second == Some(0) && self.is_16_bits(args[0]) => copy(args[0]),
                _ => What::Compute(op, args),
            };
        }
    }

    /// What is written as it was read is not written, if nobody wrote there between.
    fn forget_what_stays(&mut self) {
        let steps: Vec<usize> = self
            .outer
            .steps
            .iter()
            .filter_map(|step| match *step {
                Step::Access(number) => Some(number),
                Step::Copy(_) | Step::Inner => None,
            })
            .collect();
        for (at, &number) in steps.iter().enumerate() {
            let access = &self.accesses[number];
            let Some(What::Read(read)) = access.value.map(|value| self.what(value)) else { continue };
            let Some(first) = steps[..at].iter().position(|&step| step == read) else { continue };
            let is_written = |&other: &usize| self.accesses[other].value.is_some() && self.accesses[other].may_meet(access);
            if self.accesses[read].is_same(access) && !steps[first..at].iter().any(is_written) {
                self.accesses[number].value = None;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use sieben_engine::ir::Op;
    use sieben_model::address::Width;

    use super::super::super::promote::Base;
    use super::super::kernel::{Access, Cell, Kept, Kernel, Level, Node, Step, Turn, What};

    /// A loop in the making: a counter on a line, a flag that no turn writes, and one that turns write.
    struct Loop {
        kernel: Kernel,
        pointer: Node,
        flag: Node,
        changed: Node,
        one: Node,
    }

    /// One of the values of such a loop.
    type Part = fn(&Loop) -> Node;

    impl Loop {
        fn new() -> Self {
            let mut kernel = Kernel::empty();
            let cell = |offset: i32, width: Width| Kept::Memory { base: Base::Arena, offset, width, bit: 0 };
            kernel.cells = vec![cell(0, Width::DoubleWord), cell(4, Width::Bit), cell(5, Width::Bit)];
            let [counter, flag, changed] = [0, 1, 2].map(|cell| What::Start(Level::Outer, Cell::numbered(cell)));
            let number = Node::numbered;
            let step = What::Compute(Op::AddU32, [number(0), number(3), number(0), number(0)]);
            let not = What::Compute(Op::Not, [number(2); 4]);
            kernel.nodes = vec![counter, flag, changed, What::Constant(32), step, not, What::Constant(1)];
            kernel.outer.ends = [(Cell::numbered(0), number(4)), (Cell::numbered(2), number(5))].into();
            Self { kernel, pointer: number(0), flag: number(1), changed: number(2), one: number(6) }
        }

        fn node(&mut self, what: What) -> Node {
            self.kernel.add(what)
        }

        fn compute(&mut self, op: Op, [a, b, c]: [Node; 3]) -> Node {
            self.node(What::Compute(op, [a, b, c, a]))
        }

        fn access(&mut self, offset: u32, value: Option<Node>) -> Node {
            let number = self.kernel.accesses.len();
            let (area, inside) = ((Base::Arena, 100, 1000), Some(100..1100));
            let (pointer, width) = (self.pointer, Width::DoubleWord);
            self.kernel.accesses.push(Access {
                level: Level::Outer,
                area,
                pointer,
                offset,
                width,
                value,
                inside,
                sure: true,
                part: None,
                around: Vec::new(),
            });
            let read = self.node(What::Read(number));
            self.kernel.reads.push(read);
            self.kernel.outer.steps.push(Step::Access(number));
            read
        }

        /// A turn that writes 1 to a variable where a condition holds, or where it does not.
        fn writing(condition: impl Fn(&mut Self) -> Node, holds: bool) -> Self {
            let mut it = Self::new();
            let condition = condition(&mut it);
            let before = it.access(0, None);
            let (a, b) = if holds { (it.one, before) } else { (before, it.one) };
            let value = it.compute(Op::Select, [condition, a, b]);
            it.access(0, Some(value));
            it
        }

        /// Conditions of the version with fewer accesses, if there is one, and how many accesses that has.
        fn settled(&self) -> Option<(Vec<bool>, usize)> {
            let kernel = self.kernel.settled()?;
            Some((kernel.settled.iter().map(|&(_, holds)| holds).collect(), kernel.accesses.len()))
        }
    }

    #[test]
    fn what_no_turn_changes_is_looked_at_in_front_of_the_loop() {
        for holds in [false, true] {
            let it = Loop::writing(|it| it.flag, holds);
            assert_eq!(it.settled(), Some((vec![!holds], 0)), "neither read nor written");
            assert_eq!(Loop::writing(|it| it.changed, holds).settled(), None, "turns write the condition");
            let read = |it: &mut Loop| {
                let read = it.access(64, None);
                it.compute(Op::Differ, [read, it.one, read])
            };
            assert_eq!(Loop::writing(read, holds).settled(), None, "each turn reads the condition");
        }
    }

    #[test]
    fn of_a_condition_with_parts_that_is_looked_at_which_no_turn_changes() {
        let of = |op: Op, first: Part, second: Part| {
            move |it: &mut Loop| {
                let parts = [first(it), second(it), first(it)];
                it.compute(op, parts)
            }
        };
        let (flag, changed): (Part, Part) = (|it| it.flag, |it| it.changed);
        let settled = |op, first, second, holds| Loop::writing(of(op, first, second), holds).settled();
        assert_eq!(settled(Op::And, flag, changed, true), Some((vec![false], 0)));
        assert_eq!(settled(Op::And, changed, flag, true), Some((vec![false], 0)));
        assert_eq!(settled(Op::Or, changed, flag, false), Some((vec![true], 0)));
        assert_eq!(settled(Op::AndNot, flag, changed, true), Some((vec![false], 0)));
        assert_eq!(settled(Op::AndNot, changed, flag, true), Some((vec![true], 0)));
        assert_eq!(settled(Op::Not, flag, flag, true), Some((vec![true], 0)));
        assert_eq!(settled(Op::And, flag, changed, false), None, "both parts have to hold");
        assert_eq!(settled(Op::Or, flag, changed, true), None, "no part may hold");
        assert_eq!(settled(Op::Xor, flag, changed, true), None);
    }

    #[test]
    fn what_was_written_between_is_written_again() {
        for (offset, accesses) in [(0, 3), (16, 3), (32, 1)] {
            let mut it = Loop::new();
            let before = it.access(0, None);
            it.access(offset, Some(it.one));
            let value = it.compute(Op::Select, [it.flag, it.one, before]);
            it.access(0, Some(value));
            assert_eq!(it.settled(), Some((vec![false], accesses)), "{offset}");
        }
    }

    #[test]
    fn another_variable_is_written_whatever_the_condition() {
        let mut it = Loop::new();
        let before = it.access(32, None);
        let value = it.compute(Op::Select, [it.flag, it.one, before]);
        it.access(0, Some(value));
        assert_eq!(it.settled(), None);
    }

    #[test]
    fn loops_in_loops_stay_as_they_are() {
        let mut it = Loop::writing(|it| it.flag, true);
        it.kernel.inner = Some(Turn::default());
        assert_eq!(it.settled(), None);
    }

    #[test]
    fn several_conditions_are_looked_at_and_no_more_than_some() {
        for conditions in 1..=super::CONDITIONS_MAX + 2 {
            let mut it = Loop::new();
            for at in 0..conditions {
                let cell = it.kernel.cells.len();
                it.kernel.cells.push(Kept::Memory { base: Base::Arena, offset: 10 + at as i32, width: Width::Bit, bit: 0 });
                let flag = it.node(What::Start(Level::Outer, Cell::numbered(cell as u16)));
                let before = it.access(64 * at as u32, None);
                let value = it.compute(Op::Select, [flag, it.one, before]);
                it.access(64 * at as u32, Some(value));
            }
            let settled = conditions.min(super::CONDITIONS_MAX);
            assert_eq!(it.settled(), Some((vec![false; settled], 2 * (conditions - settled))));
        }
    }
}
