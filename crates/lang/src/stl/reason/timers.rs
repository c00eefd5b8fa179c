//! Reasons of timers and counters. What was before them shows only in the machine that was kept before the statement.

use sieben_engine::Machine;
use sieben_engine::machine::{Counter, Timer, TimerKind};

use super::telling::Telling;
use crate::sentences::table::Sentence as S;
use crate::sentences::text::{Clause, Words, time};
use crate::stl::operands::Operand;
use crate::stl::why::Why;

/// The number of the timer or counter of the statement.
fn number(telling: &Telling<'_>) -> usize {
    match telling.operand() {
        Operand::Timer(number) | Operand::Counter(number) => telling.reader().number(number).map_or(usize::MAX, usize::from),
        _ => usize::MAX,
    }
}

fn timer(machine: &Machine, number: usize) -> Option<Timer> {
    let mut timer = machine.timers.get(number)?.clone();
    timer.refresh(machine.clock_us);
    Some(timer)
}

fn counter(machine: &Machine, number: usize) -> Option<&Counter> {
    machine.counters.get(number)
}

/// How a timer stands behind the statement.
fn timer_state(telling: &Telling<'_>, number: usize) -> Words {
    let machine = telling.moment.after;
    let Some(timer) = timer(machine, number) else { return "?".into() };
    let clause = if timer.running { S::StateRuns } else { S::StateStands };
    let left = time(timer.remaining(machine.clock_us), timer.base);
    telling.words(&Clause::new(clause).with("left", left).with("status", u64::from(timer.status)))
}

/// How a timer or counter stands behind the statement.
fn state(telling: &Telling<'_>, number: usize) -> Words {
    match telling.operand() {
        Operand::Counter(_) => telling.words(&Clause::new(S::StateCount).with("count", count_of(telling.moment.after, number))),
        _ => timer_state(telling, number),
    }
}

fn count_of(machine: &Machine, number: usize) -> u64 {
    counter(machine, number).map_or(0, |counter| u64::from(counter.count))
}

/// `SP`, `SE`, `SD`, `SS`, `SF`.
pub(super) fn start(telling: &Telling<'_>, kind: TimerKind) -> Vec<Clause> {
    let number = number(telling);
    let machine = telling.moment.after;
    let rlo = telling.before().rlo == 1;
    let edge = telling.moment.before.and_then(|before| before.timers.get(number)).map(|timer| timer.start_edge);
    let now = timer(machine, number).unwrap_or_default();
    let sentence = match (kind, edge, rlo) {
        (_, None, _) => S::TimerState,
        (TimerKind::OffDelay, Some(false), true) => S::OffDelayRises,
        (TimerKind::OffDelay, Some(true), false) => S::OffDelayFalls,
        (TimerKind::OffDelay, ..) => S::OffDelaySame,
        (_, Some(false), true) if now.running => S::TimerStarts,
        (_, Some(false), true) => S::TimerZero,
        (_, Some(true), true) => S::TimerSame,
        (TimerKind::Pulse | TimerKind::OnDelay, _, false) => S::TimerStops,
        _ => S::TimerGoesOn,
    };
    let clause = Clause::new(sentence).with("state", state(telling, number)).with("status", u64::from(now.status));
    vec![clause.with("time", s5time(telling.before().accu1))]
}

/// The S5TIME in an accumulator.
fn s5time(bits: u64) -> Words {
    let word = bits as u16;
    let value = sieben_model::bcd::decode(u32::from(word), 3) as u16;
    time(value, (word >> 12 & 3) as u8)
}

/// `R` of a timer or counter.
pub(super) fn reset(telling: &Telling<'_>) -> Vec<Clause> {
    let sentence = if telling.before().rlo == 1 { S::ResetOne0 } else { S::ResetNothing };
    vec![Clause::new(sentence).with("state", state(telling, number(telling)))]
}

/// `FR` of a timer or counter.
pub(super) fn enable(telling: &Telling<'_>) -> Vec<Clause> {
    let number = number(telling);
    let before = telling.moment.before;
    let is_timer = matches!(telling.operand(), Operand::Timer(_));
    let edge = match is_timer {
        true => before.and_then(|before| before.timers.get(number)).map(|timer| timer.enable_edge),
        false => before.and_then(|before| counter(before, number)).map(|counter| counter.enable_edge),
    };
    vec![Clause::new(match (telling.before().rlo, edge) {
        (1, Some(false)) if is_timer => S::TimerEnable,
        (1, Some(false)) => S::CounterEnable,
        (1, None) => S::EnableState,
        _ => S::EnableNothing,
    })]
}

/// `CU`, `CD`, `S`.
pub(super) fn count(telling: &Telling<'_>, why: Why) -> Vec<Clause> {
    let number = number(telling);
    let count = count_of(telling.moment.after, number);
    let before = telling.moment.before.and_then(|before| counter(before, number));
    let edge = before.map(|counter| match why {
        Why::CounterUp => counter.up_edge,
        Why::CounterDown => counter.down_edge,
        _ => counter.set_edge,
    });
    let was = before.map_or(0, |counter| u64::from(counter.count));
    let sentence = match (telling.before().rlo, edge, why) {
        (0, ..) => S::CountLow,
        (_, None, _) => S::CountState,
        (_, Some(true), _) => S::CountSame,
        (_, _, Why::CounterSet) => S::CounterSet,
        (_, _, Why::CounterUp) if was == count => S::CountsTop,
        (_, _, Why::CounterDown) if was == count => S::CountsBottom,
        _ => S::Counts,
    };
    vec![Clause::new(sentence).with("before", was).with("count", count)]
}

/// `LC`.
pub(super) fn load_bcd(telling: &Telling<'_>) -> Vec<Clause> {
    let bits = telling.after().accu1;
    vec![match telling.operand() {
        Operand::Timer(_) => Clause::new(S::LoadTimerBcd).with("value", s5time(bits)),
        _ => Clause::new(S::LoadCounterBcd).with("value", format!("{:X}", bits & 0xFFF)),
    }]
}
