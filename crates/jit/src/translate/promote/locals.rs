//! Loops whose blocks write nothing but local data: functions that are given numbers and hand back what they make of them. What such a loop
//! itself only reads elsewhere is still in memory as it was when the loop is left, and need not be stored there again.

use std::collections::{BTreeMap, BTreeSet};

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Callee, Inst, Place};
use sieben_model::address::Area;

use super::super::Translator;
use super::super::loops::Loop;
use super::CALLS_MAX;

/// The numbers of the areas of local data in a pointer: of the block that runs, and of its caller.
const LOCALS: [u64; 2] = [0x86, 0x87];

impl Translator<'_> {
    /// Whether the blocks that a loop calls write only local data: their own, or that of their callers by the pointers that they are given.
    pub(super) fn calls_write_locals_only(&self, it: &Loop) -> bool {
        let code = &self.native().code;
        (it.first..=it.last).all(|statement| self.writes_locals_only(code.statement(statement as usize), None, CALLS_MAX))
    }

    /// The same for a statement of the loop, or of a block that was given so many pointers.
    fn writes_locals_only(&self, insts: &[Inst], given: Option<u16>, depth: u32) -> bool {
        let mut constants: BTreeMap<u8, u64> = BTreeMap::new();
        let mut pointers = BTreeSet::new();
        for inst in insts {
            let is_known = match *inst {
                Inst::Call { callee: Callee::Block(id), parameters } => (self.find)(id).is_some_and(|called| {
                    let block = &self.blocks[called as usize].code;
                    let mut statements = (0..block.statement_count()).map(|statement| block.statement(statement));
                    depth > 0
                        && self.inlines(called as usize)
                        && statements.all(|insts| self.writes_locals_only(insts, Some(parameters), depth - 1))
                }),
                Inst::PassParameter { src } => {
                    pointers.contains(&src.0) || constants.get(&src.0).is_some_and(|pointer| LOCALS.contains(&(pointer >> 24)))
                }
                Inst::Parameter { index, .. } => given.is_none_or(|given| index < given),
                Inst::Store { place, .. } if given.is_some() => match place {
                    Place::Fixed { area, .. } => area == Area::Local,
                    Place::Crossing { pointer, .. } => pointers.contains(&pointer.0),
                    Place::Indirect { .. } => false,
                },
                Inst::Call { .. } => false,
                Inst::Move { .. } | Inst::Text { .. } => given.is_none(),
                Inst::Intrinsic { intrinsic, .. } => intrinsic == Intrinsic::Clock || given.is_none(),
                _ => true,
            };
            if !is_known {
                return false;
            }
            if let Some(dst) = sieben_engine::ir::verify::writes(inst) {
                constants.remove(&dst.0);
                pointers.remove(&dst.0);
                match *inst {
                    Inst::Constant { value, .. } => drop(constants.insert(dst.0, value)),
                    Inst::Parameter { .. } if given.is_some() => drop(pointers.insert(dst.0)),
                    _ => {}
                }
            }
        }
        true
    }
}
