//! What a turn reads, as late as it needs it: what was written is written at the end of a turn, so that all that it reads would wait in
//! registers for it, or on the stack.

use std::collections::BTreeSet;

use super::kernel::{Kernel, Level, Node, Step, What};
use super::records::Records;

impl Kernel {
    /// The steps of a turn without a loop in it, with each read in front of the first write that needs it or another one of its row, or that
    /// may go to the same bits in one of the turns side by side.
    pub(super) fn steps_with_late_reads(&self, lanes: u32, records: &Records) -> Vec<Step> {
        let mut steps = Vec::new();
        let mut waiting: Vec<usize> = Vec::new();
        let mut seen = BTreeSet::new();
        for &step in &self.outer.steps {
            let Step::Access(number) = step else { return self.outer.steps.clone() };
            let access = &self.accesses[number];
            let Some(value) = access.value else {
                waiting.push(number);
                continue;
            };
            let mut needed = BTreeSet::new();
            [access.pointer, value].into_iter().for_each(|node| self.reads_behind(node, &mut seen, &mut needed));
            let meets = |read: usize| if lanes == 1 { self.accesses[read].may_meet(access) } else { self.touches(read, false, number) };
            for &read in waiting.iter().filter(|&&read| meets(read)) {
                needed.insert(read);
                self.reads_behind(self.accesses[read].pointer, &mut seen, &mut needed);
            }
            // A row is read once.
            let rows: BTreeSet<_> = needed.iter().filter_map(|&read| records.row(self, read)).collect();
            needed.extend(waiting.iter().filter(|&&read| records.row(self, read).is_some_and(|row| rows.contains(&row))));
            waiting.retain(|&read| {
                let is_needed = needed.contains(&read);
                steps.extend(is_needed.then_some(Step::Access(read)));
                !is_needed
            });
            steps.push(step);
        }
        steps.extend(waiting.into_iter().map(Step::Access));
        steps
    }

    /// Adds the reads on which a value rests, and those on which their addresses do, as far as they were not seen before.
    pub(super) fn reads_behind(&self, node: Node, seen: &mut BTreeSet<Node>, reads: &mut BTreeSet<usize>) {
        let mut waiting = vec![node];
        while let Some(node) = waiting.pop() {
            if !seen.insert(node) {
                continue;
            }
            match self.what(node) {
                What::Compute(op, args) => waiting.extend(&args[..op.arity()]),
                What::Read(access) => {
                    reads.insert(access);
                    waiting.push(self.accesses[access].pointer);
                }
                // What a turn begins with in order is what the one before ends with, which is one of those side by side.
                What::Start(Level::Outer, cell) if self.in_order.cells.contains(&cell) => waiting.push(self.outer.ends[&cell]),
                _ => {}
            }
        }
    }
}
