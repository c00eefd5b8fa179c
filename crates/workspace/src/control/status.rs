//! The status of a block for those who ask for one sample at a time.

use std::collections::HashMap;
use std::sync::Arc;

use sieben_engine::FaultPlace;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::problems::Problem;

use super::answer::{Statement, Status};
use super::facts::Facts;
use super::request::{Wait, shortened};
use super::{LOOK, WAIT_MAX, listing};
use crate::gate::{Closed, Gate};
use crate::refusal::Refusal;
use crate::status::{Desk, Sample, Written};

/// Statements in one answer.
const STATEMENTS_MAX: usize = 1_000;

fn not_shown(message: impl Into<String>) -> Refusal {
    Refusal::new(Problem::P7095, message)
}

/// Looks at a block until a sample comes that is newer than the one with the number `after`; 0 stands for the newest one.
pub(super) fn status(
    gate: &Gate,
    desk: &Desk,
    (facts, written): (&Facts, &mut HashMap<BlockId, Written>),
    (name, after, from, wait): (&str, u64, u32, Wait),
) -> Result<Status, Refusal> {
    let block = facts.block(name).ok_or_else(|| not_shown(format!("there is no block `{}`", shortened(name))))?;
    if block.kind == BlockKind::DataBlock || !facts.program.code.contains_key(&block) {
        return Err(not_shown(format!("{block} has no statements in this program")));
    }
    if wait == Wait::Not {
        let written = written.entry(block).or_insert_with(|| listing::written(facts, block));
        desk.keep_looking(block, Arc::clone(written), gate.now_us());
        return newest(gate, desk, facts, (block, after, from));
    }
    let _look = desk.look([block]);
    let now_us = gate.now_us();
    let end = now_us.saturating_add(u64::try_from(WAIT_MAX.as_micros()).unwrap_or(u64::MAX));
    // A client that knows no sample of this run wants the next one.
    let newest = desk.number();
    let mut seen = if (1..=newest).contains(&after) { after } else { newest };
    while !gate.is_closed() {
        if let Some((number, looked)) = desk.wait_for_sample(seen, LOOK) {
            seen = number;
            let sample = looked.map_err(|error| not_shown(error.to_string()))?;
            // One that was replayed before the look began has nothing of the block.
            if sample.calls.contains(&block.into()) {
                return Ok(shown(facts, block, (number, &sample), from));
            }
        }
        if gate.now_us() >= end {
            return Err(not_shown("no scan has run within two seconds: the CPU is in STOP, or its time stands still"));
        }
    }
    Err(Closed.into())
}

/// The newest sample of a block that is looked at for a while; without statements if there is none after `after`.
fn newest(gate: &Gate, desk: &Desk, facts: &Facts, (block, after, from): (BlockId, u64, u32)) -> Result<Status, Refusal> {
    if gate.is_closed() {
        return Err(Closed.into());
    }
    let Some((number, looked)) = desk.newest() else { return Ok(nothing(block, 0)) };
    let sample = looked.map_err(|error| not_shown(error.to_string()))?;
    match number > after && sample.calls.contains(&block.into()) {
        true => Ok(shown(facts, block, (number, &sample), from)),
        false => Ok(nothing(block, number.min(after))),
    }
}

/// No sample that is newer.
fn nothing(block: BlockId, sample: u64) -> Status {
    Status { block, sample, scan: 0, time_us: 0, same: true, next: None, statements: Vec::new() }
}

fn shown(facts: &Facts, block: BlockId, (number, sample): (u64, &Sample), from: u32) -> Status {
    let mut wanted = sample.of(block.into()).skip_while(|&(number, _)| number < from.saturating_sub(1));
    let mut places = facts.places();
    let mut statements = Vec::new();
    for (statement, status) in wanted.by_ref().take(STATEMENTS_MAX) {
        statements.push(Statement {
            place: places.of(FaultPlace { block, statement }),
            times: status.times,
            before: status.before.clone(),
            after: status.after.clone(),
            value: status.value.clone(),
        });
    }
    let next = wanted.next().map(|(statement, _)| u64::from(statement) + 1);
    Status { block, sample: number, scan: sample.scan, time_us: sample.time_us, same: sample.same, next, statements }
}

#[cfg(test)]
mod tests {
    use sieben_engine::machine::Registers;

    use super::*;
    use crate::status::{Calls, StatementStatus};

    #[test]
    fn a_long_block_comes_in_parts_and_no_statement_twice() {
        let status = StatementStatus { before: Registers::fresh(), after: Registers::fresh(), times: 1, value: None };
        let numbers = || (0..5_000_u32).filter(|number| number % 2 == 0);
        let (block, other) = (BlockId::fc(1), BlockId::fc(2));
        let both = [block, other].map(Calls::from);
        let statements = numbers().flat_map(|number| both.map(|calls| ((calls, number), status.clone()))).collect();
        let sample = Sample { scan: 3, time_us: 0, same: true, calls: both.to_vec(), statements };
        let (mut seen, mut from) = (Vec::new(), Some(1));
        while let Some(number) = from {
            let part = shown(&Facts::default(), block, (1, &sample), u32::try_from(number).expect("a statement"));
            assert!(part.statements.len() <= STATEMENTS_MAX);
            seen.extend(part.statements.iter().map(|statement| statement.place.statement));
            from = part.next;
        }
        assert_eq!(seen, numbers().map(|number| u64::from(number) + 1).collect::<Vec<_>>());
        assert!(shown(&Facts::default(), block, (1, &sample), u32::MAX).statements.is_empty());
    }
}
