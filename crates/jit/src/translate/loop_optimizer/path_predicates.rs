//! Path predicates: under which conditions a statement of an iteration is reached, so that forward branches become selects.

use super::kernel::Node;

/// Ways to a statement that differ in more than one condition; more are not followed.
const TERMS_MAX: usize = 12;
/// Conditions of one way.
const CONDITIONS_MAX: usize = 12;

/// Conditions that all hold or do not, in order.
pub(super) type PathPredicate = Vec<(Node, bool)>;

/// All ways to a statement. On each of them all of its conditions are as it says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct PathPredicates(Vec<PathPredicate>);

impl PathPredicates {
    /// The statement is reached in each iteration.
    pub(super) fn always() -> Self {
        Self(vec![PathPredicate::new()])
    }

    pub(super) fn is_always(&self) -> bool {
        self.0.iter().any(Vec::is_empty)
    }

    pub(super) fn is_never(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn each(&self) -> &[PathPredicate] {
        &self.0
    }

    /// Whether each of these ways is one of others, with more conditions perhaps.
    pub(super) fn are_all_among(&self, others: &Self) -> bool {
        let is_part = |other: &PathPredicate, way: &PathPredicate| other.iter().all(|condition| way.contains(condition));
        self.0.iter().all(|way| others.0.iter().any(|other| is_part(other, way)))
    }

    /// What is the same on all ways.
    pub(super) fn common(&self) -> PathPredicate {
        let Some((first, others)) = self.0.split_first() else { return PathPredicate::new() };
        first.iter().copied().filter(|condition| others.iter().all(|way| way.contains(condition))).collect()
    }

    /// Those of these ways on which a condition holds, or does not.
    pub(super) fn and(&self, condition: Node, holds: bool) -> Self {
        let ways = self.0.iter().filter(|way| !way.contains(&(condition, !holds))).map(|way| {
            let mut way = way.clone();
            if let Err(at) = way.binary_search(&(condition, holds)) {
                way.insert(at, (condition, holds));
            }
            way
        });
        let mut all = Self(ways.collect());
        all.simplify();
        all
    }

    /// Adds other ways; `None` if there are too many.
    pub(super) fn join(&mut self, other: Self) -> Option<()> {
        self.0.extend(other.0);
        self.simplify();
        (self.0.len() <= TERMS_MAX && self.0.iter().all(|way| way.len() <= CONDITIONS_MAX)).then_some(())
    }

    /// Leaves out what follows from the rest.
    fn simplify(&mut self) {
        loop {
            self.0.sort_by(|a, b| (a.len(), a).cmp(&(b.len(), b)));
            self.0.dedup();
            let is_part = |a: &PathPredicate, b: &PathPredicate| a.iter().all(|condition| b.contains(condition));
            let ways = &self.0;
            // A way with more conditions than another one leads nowhere else.
            let needless = (0..ways.len()).find(|&at| (0..ways.len()).any(|other| other != at && is_part(&ways[other], &ways[at])));
            if let Some(at) = needless {
                self.0.remove(at);
                continue;
            }
            // Where the other way of a condition leads there too, the condition does not count.
            let without = (0..ways.len()).find_map(|at| {
                let found = ways[at].iter().position(|&(condition, holds)| {
                    ways.iter().any(|other| {
                        let rest = || other.iter().filter(|&&it| it != (condition, !holds));
                        other.contains(&(condition, !holds)) && rest().all(|it| ways[at].contains(it))
                    })
                });
                found.map(|condition| (at, condition))
            });
            match without {
                Some((at, condition)) => drop(self.0[at].remove(condition)),
                None => return,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn holds(ways: &PathPredicates, values: u32) -> bool {
        ways.each().iter().any(|way| way.iter().all(|&(node, wanted)| (values >> node.number() & 1 != 0) == wanted))
    }

    /// A chain of IF and ELSIF, one IF in another, and jumps out of them: what is simplified is as true as what it came from.
    #[test]
    fn ways_that_meet_again_are_no_conditions_any_more() {
        let nodes: Vec<Node> = (0..4).map(Node::numbered).collect();
        let mut seed = 1_u32;
        let mut roll = |below: u32| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 8) % below
        };
        for _ in 0..2000 {
            let mut here = PathPredicates::always();
            let mut waiting: Vec<PathPredicates> = Vec::new();
            let mut wanted = vec![true; 16];
            let mut others: Vec<Vec<bool>> = Vec::new();
            for _ in 0..6 {
                let (node, side) = (nodes[roll(4) as usize], roll(2) == 0);
                waiting.push(here.and(node, side));
                let is = |values: u32| (values >> node.number() & 1 != 0) == side;
                others.push((0..16).map(|values| wanted[values as usize] && is(values)).collect());
                here = here.and(node, !side);
                (0..16).for_each(|values| wanted[values as usize] &= !is(values));
                if roll(2) == 0
                    && let (Some(ways), Some(also)) = (waiting.pop(), others.pop())
                {
                    here.join(ways).expect("few ways");
                    wanted.iter_mut().zip(also).for_each(|(wanted, also)| *wanted |= also);
                }
                for (values, wanted) in (0_u32..).zip(&wanted) {
                    assert_eq!(holds(&here, values), *wanted);
                }
            }
            for (ways, also) in waiting.into_iter().zip(others).rev() {
                here.join(ways).expect("few ways");
                wanted.iter_mut().zip(also).for_each(|(wanted, also)| *wanted |= also);
            }
            assert!(wanted.iter().all(|&wanted| wanted) && here == PathPredicates::always(), "all ways met: {here:?}");
        }
    }
}
