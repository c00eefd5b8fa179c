//! Base-relative form: in blocks that reach their instance by AR2 alone, what is found with AR2 at the first byte of the instance holds for
//! each address of it, if all pointers are AR2 plus an offset, and if nothing is made of them but access to the instance. For a call AR2 is
//! moved to a part of the instance, and restored after it from the local data, where it counts as any number. A pointer that is passed on
//! is made of its position, which is a number as any other.

use std::collections::BTreeSet;

use rustc_hash::FxHashSet;
use sieben_engine::ir::{Code, DataRegister, Inst, Op, Place, Var, verify};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::Interval;
use crate::translate::scalar_promotion::ComputedAddress;

/// The instance of a block, wherever it lies.
#[derive(Clone, Debug)]
pub(in crate::translate) struct Relative {
    pub(in crate::translate) instance: ComputedAddress,
    /// Where it begins behind that address, in bytes.
    pub(in crate::translate) first: i64,
    /// Bytes that are there.
    pub(in crate::translate) bytes: i64,
    /// Whether it may not be written.
    pub(in crate::translate) protected: bool,
    /// What AR2 really holds.
    pub(in crate::translate) real: Interval,
    pub(in crate::translate) uses: Uses,
}

/// What the instructions of a block do with AR2 and what is calculated from it.
#[derive(Clone, Debug, Default)]
pub(in crate::translate) struct Uses {
    /// Those that calculate pointers into the instance, keep AR2, or take it back.
    pub(in crate::translate) pointers: FxHashSet<u32>,
    /// Those that take the position from AR2.
    pub(in crate::translate) positions: FxHashSet<u32>,
}

/// What a block does with AR2, if it reaches its instance in no other way. `is_bounded` tells whether it is known what a call writes, and
/// that it leaves AR2 as it is; `is_taken_back` whether AR2 is known behind an instruction that writes it.
pub(in crate::translate) fn uses(code: &Code, is_bounded: &dyn Fn(&Inst) -> bool, is_taken_back: &dyn Fn(u32) -> bool) -> Option<Uses> {
    let mut found = Uses::default();
    for statement in 0..code.statement_count() {
        let mut pointers: BTreeSet<u8> = BTreeSet::new();
        for (index, inst) in (code.statements[statement]..).zip(code.statement(statement)) {
            let is_pointer = |var: Var| var.register() == Some(Register::Ar2) || pointers.contains(&var.0);
            let is_apart_there = |place: Place| match place {
                Place::Fixed { area, .. } => area != Area::InstanceData,
                Place::Indirect { area, pointer, .. } => (area == Area::InstanceData) == is_pointer(pointer),
                Place::Crossing { pointer, .. } => !is_pointer(pointer),
            };
            let mut calculated = false;
            let fine = match *inst {
                Inst::Compute { op: Op::Copy, args, .. } => {
                    calculated = is_pointer(args[0]);
                    true
                }
                Inst::Compute { op: op @ (Op::AddU32 | Op::SubU32), args, .. } => match args.map(is_pointer) {
                    [false, false, ..] => true,
                    [true, true, ..] => false,
                    [first, ..] => {
                        calculated = true;
                        first || op == Op::AddU32
                    }
                },
                Inst::Compute { op: Op::AndU32, args: [position, mask, ..], .. }
                    if position.register() == Some(Register::Ar2) && !is_pointer(mask) =>
                {
                    found.positions.insert(index);
                    true
                }
                Inst::Load { place, .. } => is_apart_there(place),
                Inst::Store { place: Place::Fixed { area: Area::Local, .. }, width: Width::DoubleWord, src } if is_pointer(src) => {
                    found.pointers.insert(index);
                    true
                }
                Inst::Store { place, src, .. } => is_apart_there(place) && !is_pointer(src),
                Inst::Move { from, to, .. } => is_apart_there(from) && is_apart_there(to),
                Inst::Text { .. } | Inst::Open { register: DataRegister::Instance, .. } => false,
                Inst::Call { .. } => is_bounded(inst),
                _ => !verify::reads(inst).any(is_pointer),
            };
            if !fine {
                return None;
            }
            if let Some(dst) = verify::writes(inst) {
                match dst.register() {
                    Some(Register::Ar2) if calculated || is_taken_back(index) => {
                        found.pointers.insert(index);
                        continue;
                    }
                    Some(register) if calculated || register == Register::Ar2 => return None,
                    _ => {}
                }
                if calculated {
                    pointers.insert(dst.0);
                    found.pointers.insert(index);
                } else {
                    pointers.remove(&dst.0);
                }
            }
        }
    }
    Some(found)
}
