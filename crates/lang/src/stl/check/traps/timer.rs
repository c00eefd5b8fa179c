//! A timer that two statements of one path drive: each sees the edges that the other one makes.

use std::collections::BTreeMap;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Section;
use sieben_model::problems::Problem;

use super::super::flow;
use crate::stl::instructions::Instruction as I;
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::operands::{Actual, Call, CallInstance, NumberOperand, Operand};

/// What is driven.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Driven {
    Timer(u16),
    DataBlock(u16),
    MultiInstance(u32),
}

/// The statement that drove each on every path to here: of two conditions that choose between two starts only one holds.
type Before = BTreeMap<Driven, usize>;

/// Reports the second statement of a path that drives the same timer.
pub(super) fn check(block: &ResolvedBlock, diagnostics: &mut Vec<Diagnostic>) {
    let statements = &block.statements;
    let drives: Vec<Option<Driven>> = statements.iter().map(driven).collect();
    let mut count = BTreeMap::<Driven, usize>::new();
    drives.iter().flatten().for_each(|&one| *count.entry(one).or_default() += 1);
    if count.values().all(|&count| count < 2) {
        return;
    }
    // Only those that are driven twice somewhere are followed.
    let followed = |index: usize| drives[index].filter(|one| count[one] > 1);
    let step = |index: usize, before: &Before| {
        let mut after = before.clone();
        if let Some(one) = followed(index) {
            after.entry(one).or_insert(index);
        }
        after
    };
    let join = |known: &mut Before, more: &Before| {
        let size = known.len();
        known.retain(|one, _| more.contains_key(one));
        known.len() != size
    };
    let states = flow::states(statements, Before::new(), step, join);
    for (index, state) in states.iter().enumerate() {
        let (Some(one), Some(state)) = (followed(index), state) else { continue };
        // A loop comes back to the same statement.
        let Some(&first) = state.get(&one).filter(|&&first| first < index) else { continue };
        if same(&statements[first], &statements[index]) {
            continue;
        }
        let (what, how) = match one {
            Driven::Timer(number) => (format!("`T {number}`"), "started"),
            Driven::DataBlock(number) => (format!("the timer in `DB {number}`"), "called"),
            Driven::MultiInstance(_) => ("this timer".to_owned(), "called"),
        };
        let message = format!("{what} is {how} twice on this path: each time it sees the edges that the other one makes");
        diagnostics
            .push(Diagnostic::new(Problem::P5022, statements[index].span(), message).related(statements[first].span(), "the first time"));
    }
}

/// The timer that a statement drives.
fn driven(statement: &Statement) -> Option<Driven> {
    match (&statement.operand, statement.instruction) {
        (
            Operand::Timer(NumberOperand::Fixed(number)),
            I::TimerPulse | I::TimerExtendedPulse | I::TimerOnDelay | I::TimerRetentiveOnDelay | I::TimerOffDelay,
        ) => Some(Driven::Timer(*number)),
        (Operand::Call(call), _) if is_timer(call.callee) && TRIGGERS.iter().any(|name| given(call, name).is_some()) => {
            match call.instance? {
                CallInstance::DataBlock(number) => Some(Driven::DataBlock(number)),
                CallInstance::Multi(position) => Some(Driven::MultiInstance(position)),
            }
        }
        _ => None,
    }
}

/// Whether a block is TP, TON, TOF or one of the counters CTU, CTD, CTUD.
fn is_timer(block: BlockId) -> bool {
    block.kind == BlockKind::SystemFunctionBlock && block.number <= 5
}

/// The inputs whose edges start the timer or count.
const TRIGGERS: [&str; 3] = ["IN", "CU", "CD"];

/// What a call gives to one of these inputs; a constant makes the timer ready for the next time and is meant so.
fn given<'c>(call: &'c Call, name: &str) -> Option<&'c Actual> {
    let parameter = call.parameters.iter().find(|one| one.section == Section::Input && one.name.eq_ignore_ascii_case(name))?;
    parameter.actual.as_ref().filter(|actual| !matches!(actual, Actual::Constant(_)))
}

/// Whether both statements drive the timer with the same values, so that no edges come between them.
fn same(first: &Statement, second: &Statement) -> bool {
    match (&first.operand, &second.operand) {
        (Operand::Call(first), Operand::Call(second)) => TRIGGERS.iter().all(|name| match (given(first, name), given(second, name)) {
            (Some(first), Some(second)) => first == second,
            _ => true,
        }),
        _ => false,
    }
}
