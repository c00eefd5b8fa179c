//! Where a program goes from a statement.

use crate::stl::instructions::Instruction;
use crate::stl::lower::Statement;
use crate::stl::operands::Operand;

/// The statements that may run after a statement; none behind the end of the block.
pub(super) fn successors(statements: &[Statement], index: usize) -> Vec<usize> {
    let next = Some(index + 1);
    let target = match statements[index].operand {
        Operand::Label(target) => Some(target as usize),
        _ => None,
    };
    let after = match statements[index].instruction {
        Instruction::BlockEnd | Instruction::BlockEndUnconditional => Vec::new(),
        Instruction::Jump => target.into_iter().collect(),
        // The list of jumps lies between the statement and its label.
        Instruction::JumpList => (index + 1..=target.unwrap_or(index + 1)).collect(),
        _ => next.into_iter().chain(target).collect(),
    };
    after.into_iter().filter(|&statement| statement < statements.len()).collect()
}

/// Visits of statements, on average: programs of people need two or three. Jumps crossed like a knot could need thousands.
const VISITS_MAX: usize = 64;

/// The states before all statements, joined over every path: `None` where no path leads. All are `None` if the paths cannot be
/// followed in reasonable time.
///
/// `step` gives the state behind a statement, `join` puts a state into another one and says whether that changed.
pub(super) fn states<S: Clone>(
    statements: &[Statement],
    start: S,
    step: impl Fn(usize, &S) -> S,
    join: impl Fn(&mut S, &S) -> bool,
) -> Vec<Option<S>> {
    let mut before: Vec<Option<S>> = vec![None; statements.len()];
    if statements.is_empty() {
        return before;
    }
    before[0] = Some(start);
    let mut waiting = std::collections::BTreeSet::from([0]);
    let mut visits = 0;
    // The lowest first: jumps mostly lead forward, so that a statement is seen when its state is whole.
    while let Some(index) = waiting.pop_first() {
        let Some(state) = &before[index] else { continue };
        visits += 1;
        if visits > VISITS_MAX * statements.len() {
            return vec![None; statements.len()];
        }
        let after = step(index, state);
        for next in successors(statements, index) {
            let changed = match &mut before[next] {
                Some(known) => join(known, &after),
                empty => {
                    *empty = Some(after.clone());
                    true
                }
            };
            if changed {
                waiting.insert(next);
            }
        }
    }
    before
}
