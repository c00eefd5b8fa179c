//! Boolean simplification: selects between bits become logic, and nested selects with the same value become one. If-conversion leaves a
//! select for each variable after each branch, and most of what a timer writes is 0 or 1 on one side.

use std::collections::BTreeMap;

use sieben_engine::ir::Op;

use super::kernel::{Definition, Kernel, Node, StructureCopy};
use crate::passes::Pass;

/// Values of a loop of which choices are looked at.
const NODES_MAX: usize = 2_000;

impl Kernel {
    /// Writes choices in their shortest form. Values rest on those before them, so that one pass finds all.
    pub(super) fn shorten_choices(&mut self) {
        if !self.passes.has(Pass::BooleanSimplification) {
            return;
        }
        let count = self.nodes.len();
        if count > NODES_MAX {
            return;
        }
        for number in 0..count {
            let node = Node::numbered(number as u32);
            let Definition::Compute(op, mut args) = self.what(node) else { continue };
            args[..op.arity()].iter_mut().for_each(|arg| *arg = self.without_copies(*arg));
            self.nodes[number] = Definition::Compute(op, args);
            let shorter = match op {
                Op::Select if args[..3].iter().all(|&arg| self.is_bit(arg)) => Some(self.choice_of_bits(args)),
                // What counts bits adds 1 or 0.
                Op::Gate if self.constant(args[0]).is_none() && args[..2].iter().all(|&arg| self.is_bit(arg)) => {
                    Some(self.both(args[0], args[1]))
                }
                Op::And if args[..2].iter().all(|&arg| self.is_bit(arg)) => Some(self.both(args[0], args[1])),
                Op::Or if args[..2].iter().all(|&arg| self.is_bit(arg)) => Some(self.either(args[0], args[1])),
                Op::AndNot if args[..2].iter().all(|&arg| self.is_bit(arg)) => Some(self.first_alone(args[0], args[1])),
                _ => None,
            };
            if let Some(shorter) = shorter {
                self.nodes[number] = shorter;
            }
        }
        self.join_choices();
        let mut all = std::mem::take(&mut self.outer);
        let mut inner = self.inner.take();
        for iteration in [Some(&mut all), inner.as_mut()].into_iter().flatten() {
            let values = iteration.ends.values_mut().chain(iteration.entry.values_mut()).chain([&mut iteration.again]);
            values.for_each(|value| *value = self.without_copies(*value));
        }
        (self.outer, self.inner) = (all, inner);
        for at in 0..self.accesses.len() {
            self.accesses[at].pointer = self.without_copies(self.accesses[at].pointer);
            self.accesses[at].value = self.accesses[at].value.map(|value| self.without_copies(value));
            for around in 0..self.accesses[at].around.len() {
                self.accesses[at].around[around].pointer = self.without_copies(self.accesses[at].around[around].pointer);
            }
        }
        for at in 0..self.inspected.len() {
            self.inspected[at].0 = self.without_copies(self.inspected[at].0);
        }
        for at in 0..self.copies.len() {
            let StructureCopy { from, to, reached, .. } = &self.copies[at];
            let pointers = [from, to].map(|end| self.without_copies(end.pointer));
            let reached = reached.map(|(condition, holds)| (self.without_copies(condition), holds));
            let copied = &mut self.copies[at];
            ([copied.from.pointer, copied.to.pointer], copied.reached) = (pointers, reached);
        }
    }

    pub(super) fn without_copies(&self, node: Node) -> Node {
        match self.what(node) {
            Definition::Compute(Op::Copy, [of, ..]) => of,
            _ => node,
        }
    }

    /// A choice between bits; its parts are bits, too.
    fn choice_of_bits(&self, args: [Node; 4]) -> Definition {
        let [condition, a, b, _] = args;
        let (first, second) = (self.constant(a), self.constant(b));
        match self.constant(condition) {
            Some(condition) => copy(if condition != 0 { a } else { b }),
            None if a == b => copy(a),
            None if a == condition || first == Some(1) => self.either(condition, b),
            None if b == condition || second == Some(0) => self.both(condition, a),
            None if first == Some(0) => self.first_alone(b, condition),
            None => Definition::Compute(Op::Select, args),
        }
    }

    fn both(&self, a: Node, b: Node) -> Definition {
        match (self.constant(a), self.constant(b)) {
            (Some(0), _) | (_, Some(0)) => Definition::Constant(0),
            (Some(_), _) => copy(b),
            (_, Some(_)) => copy(a),
            _ if a == b => copy(a),
            _ => Definition::Compute(Op::And, [a, b, a, a]),
        }
    }

    fn either(&self, a: Node, b: Node) -> Definition {
        match (self.constant(a), self.constant(b)) {
            (Some(1), _) | (_, Some(1)) => Definition::Constant(1),
            (Some(_), _) => copy(b),
            (_, Some(_)) => copy(a),
            _ if a == b => copy(a),
            _ => Definition::Compute(Op::Or, [a, b, a, a]),
        }
    }

    /// One bit without another one.
    fn first_alone(&self, a: Node, b: Node) -> Definition {
        match (self.constant(a), self.constant(b)) {
            (Some(0), _) | (_, Some(1)) => Definition::Constant(0),
            (_, Some(_)) => copy(a),
            (Some(_), _) => Definition::Compute(Op::Not, [b; 4]),
            _ if a == b => Definition::Constant(0),
            _ => Definition::Compute(Op::AndNot, [a, b, a, a]),
        }
    }

    /// Makes one choice of a choice between another one and a value that this one has, too, where several variables share the condition
    /// that is made of both.
    fn join_choices(&mut self) {
        let count = self.nodes.len();
        let mut conditions: BTreeMap<(bool, Node, Node), usize> = BTreeMap::new();
        let choices = (0..count).filter_map(|number| self.two_choices(Node::numbered(number as u32)));
        choices.for_each(|(condition, ..)| *conditions.entry(condition).or_default() += 1);
        for number in 0..count {
            if let Some((condition, chosen, other)) = self.two_choices(Node::numbered(number as u32))
                && conditions.get(&condition).is_some_and(|&count| count > 1)
            {
                let (holds, outer, inner) = condition;
                let both = self.conjunction(if holds { Op::And } else { Op::AndNot }, outer, inner);
                self.nodes[number] = Definition::Compute(Op::Select, [both, chosen, other, both]);
            }
        }
    }

    /// Such a choice: whether the inner condition holds, with the outer one, where the first value is chosen, and both values. What a
    /// slot held stays the last choice, by which iterations are known that write it.
    fn two_choices(&self, node: Node) -> Option<((bool, Node, Node), Node, Node)> {
        let Definition::Compute(Op::Select, [condition, a, b, _]) = self.what(node) else { return None };
        let Definition::Compute(Op::Select, [inner, x, y, _]) = self.what(a) else { return None };
        let bits = self.is_bit(condition) && self.is_bit(inner) && !self.is_bit(node);
        if !bits || matches!(self.what(b), Definition::Start(..)) {
            return None;
        }
        match () {
            () if y == b => Some(((true, condition, inner), x, b)),
            () if x == b => Some(((false, condition, inner), y, b)),
            () => None,
        }
    }

    /// A condition made of two, the same value wherever it is needed.
    fn conjunction(&mut self, op: Op, a: Node, b: Node) -> Node {
        let what = Definition::Compute(op, [a, b, a, a]);
        let known = self.nodes.iter().position(|&other| other == what);
        known.map_or_else(|| self.add(what), |number| Node::numbered(number as u32))
    }
}

fn copy(node: Node) -> Definition {
    Definition::Compute(Op::Copy, [node; 4])
}
