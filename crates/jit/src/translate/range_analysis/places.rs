//! What the analysis tracks: variables from which addresses are computed, and constants that these are compared with.

use std::collections::BTreeSet;
use std::ops::Range;

use rustc_hash::{FxHashMap, FxHashSet};
use sieben_engine::ir::{Code, Inst, Op, Place, TextAction, Var};
use sieben_engine::machine::Register;

use sieben_model::address::{Area, Width};

use super::interval::comparison;
use super::{CONSTANTS_MAX, PLACES_MAX, STOPS};

/// Local data that a block passes to others and that count as being relevant.
const PASSED_MAX: usize = 48;

/// Places that addresses, checked conditions and what these are compared with are computed from, in the block and in blocks that it calls;
/// and those of them that matter in called blocks alone.
pub(super) fn relevant(code: &Code) -> (FxHashSet<Place>, FxHashSet<Place>) {
    let mut relevant = computed_from(code);
    let mut given = given_to_instances(code);
    given.retain(|place| !relevant.contains(place));
    if relevant.len() + given.len() > PLACES_MAX {
        given.clear();
    }
    relevant.extend(&given);
    (relevant, given)
}

/// Numbers that statements write to the instances of blocks that they call: pointers, indexes, limits.
fn given_to_instances(code: &Code) -> FxHashSet<Place> {
    let mut given = FxHashSet::default();
    for index in 0..code.statement_count() {
        let insts = code.statement(index);
        let Some(call) = insts.iter().position(|inst| matches!(inst, Inst::Call { parameters: 0, .. })) else { continue };
        given.extend(insts[..call].iter().filter_map(|inst| match *inst {
            Inst::Store {
                place: place @ Place::Indirect { area: Area::InstanceData, pointer, .. },
                width: Width::Word | Width::DoubleWord,
                ..
            } if pointer.register().is_some() => Some(place),
            _ => None,
        }));
    }
    given
}

/// Places that addresses are computed from in the block itself, and what it hands on in its local data.
fn computed_from(code: &Code) -> FxHashSet<Place> {
    let is_plain = |place: Place| match place {
        Place::Fixed { .. } => true,
        Place::Indirect { pointer, .. } => pointer.register().is_some(),
        Place::Crossing { .. } => false,
    };
    let mut relevant = FxHashSet::default();
    let mut passed: FxHashSet<Place> = FxHashSet::default();
    let mut statements = Vec::new();
    for index in 0..code.statement_count() {
        let (mut loads, mut stores, mut begins, mut branches) = (Vec::new(), Vec::new(), false, false);
        for inst in code.statement(index) {
            match *inst {
                Inst::Load { place, .. } if is_plain(place) => loads.push(place),
                Inst::Store { place, .. } if is_plain(place) => stores.push(place),
                Inst::Load { .. } | Inst::Store { .. } | Inst::Move { .. } | Inst::Require { .. } => begins = true,
                Inst::Text { to, from, .. } if !(is_plain(to) && is_plain(from)) => begins = true,
                // Where the piece begins is looked at, and how long it is.
                Inst::Text { action: TextAction::Piece | TextAction::Append, .. } => begins = true,
                Inst::Branch { .. } => branches = true,
                _ => {}
            }
        }
        if begins {
            relevant.extend(loads.iter().copied());
        }
        relevant.extend(restored_pointer(code.statement(index)).filter(|&place| is_plain(place)));
        if matches!(
            code.statement(index).iter().rev().find(|inst| matches!(inst, Inst::Call { .. })),
            Some(Inst::Call { parameters: 1.., .. })
        ) {
            let local = |place: &&Place| matches!(place, Place::Fixed { area: Area::Local, .. });
            passed.extend(stores.iter().filter(local));
        }
        statements.push((loads, stores, branches));
    }
    // What a called block is given by a pointer may be what it computes its addresses from.
    if passed.len() <= PASSED_MAX {
        relevant.extend(passed);
    }
    if relevant.is_empty() {
        return relevant;
    }
    if relevant.len() > PLACES_MAX {
        relevant = most_loaded(&statements, &relevant);
    }
    loop {
        let mut more = relevant.clone();
        for (loads, stores, branches) in &statements {
            let touches = stores.iter().any(|place| more.contains(place)) || *branches && loads.iter().any(|place| more.contains(place));
            if touches {
                more.extend(loads.iter().copied());
            }
        }
        // What is farther from the addresses is left out where there is too much of it.
        if more.len() == relevant.len() || more.len() > PLACES_MAX {
            return relevant;
        }
        relevant = more;
    }
}

/// Where a statement finds the AR2 that was kept over a call.
fn restored_pointer(insts: &[Inst]) -> Option<Place> {
    let (at, from) = insts.iter().enumerate().rev().find_map(|(at, inst)| match *inst {
        Inst::Compute { op: Op::Copy, dst, args } if dst == Register::Ar2.into() => Some((at, args[0])),
        _ => None,
    })?;
    insts[..at].iter().rev().find_map(|inst| match *inst {
        Inst::Load { dst, place, .. } if dst == from => Some(place),
        _ => None,
    })
}

/// Those places that most statements load: counters of loops, and what is used beside them.
fn most_loaded(statements: &[(Vec<Place>, Vec<Place>, bool)], relevant: &FxHashSet<Place>) -> FxHashSet<Place> {
    let mut counts: FxHashMap<Place, (usize, usize)> = FxHashMap::default();
    for (at, (loads, ..)) in statements.iter().enumerate() {
        for place in loads.iter().filter(|place| relevant.contains(place)) {
            counts.entry(*place).or_insert((0, at)).0 += 1;
        }
    }
    let mut counts: Vec<(Place, (usize, usize))> = counts.into_iter().collect();
    counts.sort_by_key(|&(_, (count, first))| (std::cmp::Reverse(count), first));
    counts.into_iter().take(PLACES_MAX / 2).map(|(place, _)| place).collect()
}

/// Constants with which the block compares, by the statements that do.
pub(super) fn compared(code: &Code) -> Vec<(u32, i64)> {
    let mut compared = Vec::new();
    for statement in 0..code.statement_count() {
        let mut constants: FxHashMap<Var, u64> = FxHashMap::default();
        for inst in code.statement(statement) {
            match *inst {
                Inst::Constant { dst, value } => {
                    constants.insert(dst, value);
                    continue;
                }
                Inst::Compute { op, args, .. } if comparison(op).is_some() => {
                    let values = args[..op.arity()].iter().filter_map(|arg| constants.get(arg));
                    compared.extend(values.map(|&value| (statement as u32, i64::from(value as i32))));
                }
                _ => {}
            }
            if let Some(dst) = sieben_engine::ir::verify::writes(inst) {
                constants.remove(&dst);
            }
        }
    }
    compared
}

/// Where ranges that grow in a part of the block may stop: at the constants with which it compares, first of all in that part, and beside them.
pub(super) fn stops(compared: &[(u32, i64)], part: &Range<u32>) -> BTreeSet<i64> {
    let numbers = |there: bool| {
        let some = compared.iter().filter(|(statement, _)| part.contains(statement) == there);
        some.map(|&(_, constant)| constant).collect::<BTreeSet<i64>>()
    };
    let mut all: BTreeSet<i64> = numbers(true).into_iter().take(CONSTANTS_MAX).collect();
    let room = CONSTANTS_MAX - all.len();
    let others: Vec<i64> = numbers(false).difference(&all).take(room).copied().collect();
    all.extend(others);
    let beside = all.into_iter().flat_map(|constant| [constant - 1, constant, constant + 1]);
    beside.chain(STOPS).collect()
}
