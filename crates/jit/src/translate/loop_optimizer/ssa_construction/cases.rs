//! Paths after branches, and those after a branch by a number as CASE makes them: each of these has a path predicate of its own, and where
//! one of them holds no other one does.

use sieben_engine::ir::{Op, Target};

use super::super::kernel::{Definition, Node};
use super::super::path_predicates::PathPredicates;
use super::SsaBuilder;

impl SsaBuilder<'_, '_> {
    /// The ways on which the targets of a table are reached. What is left is that on which no number was found.
    pub(super) fn ways_of_table(&mut self, index: Node, targets: &[Target], otherwise: u32) -> Vec<(u32, PathPredicates)> {
        let mut cases: Vec<(u32, Node)> = Vec::new();
        for (number, &Target(to)) in (0..).zip(targets) {
            // Numbers that lead nowhere else are found nowhere.
            if to == otherwise {
                continue;
            }
            let number = self.constant(number);
            let condition = self.compute(Op::Equal, [index, number, index, index]);
            match cases.iter().position(|&(other, _)| other == to) {
                Some(at) => cases[at].1 = self.compute(Op::Or, [cases[at].1, condition, condition, condition]),
                None => cases.push((to, condition)),
            }
        }
        let before = self.ways.clone();
        let mut ways = Vec::new();
        for &(to, condition) in &cases {
            let (taken, other) = self.ways_behind(condition);
            let is_open = self.one_way.is_none() && self.kernel.constant(condition).is_none();
            ways.push((to, if is_open { before.and(condition, true) } else { taken }));
            self.ways = other;
        }
        self.exclusive.push(cases.into_iter().map(|(_, condition)| condition).collect());
        ways
    }

    /// The ways behind a branch on which its condition holds, and on which it does not.
    pub(super) fn ways_behind(&mut self, condition: Node) -> (PathPredicates, PathPredicates) {
        let known = self.kernel.constant(condition).map(|value| value & 1 != 0);
        let chosen = self.one_way.filter(|_| known.is_none()).map(|ways| ways & 1 == 0);
        if let (Some(holds), Some(ways)) = (chosen, &mut self.one_way) {
            *ways >>= 1;
            self.kernel.ways.push((condition, holds));
        }
        if let Some(holds) = known.or(chosen) {
            let both = (self.ways.clone(), PathPredicates::default());
            return if holds { both } else { (both.1, both.0) };
        }
        let (condition, holds) = self.positive(condition);
        (self.ways.and(condition, holds), self.ways.and(condition, !holds))
    }

    /// A condition without a negation, and whether it has to hold.
    pub(in crate::translate::loop_optimizer) fn positive(&self, mut condition: Node) -> (Node, bool) {
        let mut holds = true;
        while let Definition::Compute(Op::Not, [of, ..]) = self.kernel.what(condition) {
            (condition, holds) = (of, !holds);
        }
        (condition, holds)
    }

    /// Whether a condition does not hold where another one does.
    pub(super) fn excludes(&self, holds: Node, other: Node) -> bool {
        let compared = |condition: Node| match self.kernel.what(condition) {
            Definition::Compute(op @ (Op::Equal | Op::EqI16 | Op::EqI32), [number, with, ..]) => {
                Some((op, number, self.kernel.constant(with)?))
            }
            _ => None,
        };
        let is_other_number = match (compared(holds), compared(other)) {
            (Some((op, number, with)), Some((other_op, other_number, other_with))) => {
                (op, number) == (other_op, other_number) && with as u16 != other_with as u16
            }
            _ => false,
        };
        holds != other && (is_other_number || self.exclusive.iter().any(|all| all.contains(&holds) && all.contains(&other)))
    }
}
