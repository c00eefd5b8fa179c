//! The instance data block in a block that calls instances in other data blocks: a call of one opens its data block as DI, and behind the
//! call the own one is open again, taken from where it was saved. So DI is at the beginning of each statement what it was when the
//! block began, and a loop with such calls does not change it.

use rustc_hash::FxHashMap;
use sieben_engine::access::data_registers;
use sieben_engine::ir::{Callee, Code, DataRegister, Inst, Op, Place, Var};
use sieben_engine::machine::Register;
use sieben_model::address::Area;

use super::analysis::effect;
use super::loops::{self, Loop, targets};
use super::{Find, Translator, bit_of};

/// Registers of DI.
fn instance() -> [Register; 3] {
    data_registers(DataRegister::Instance)
}

impl Translator<'_> {
    /// The loops of a block.
    pub(super) fn find_loops(&self, code: usize) -> Vec<Loop> {
        let code = &self.blocks[code].code;
        loops::find(code, kept(code, self.find, &|number| self.data_block(number & 0xFFFF).is_some()))
    }
}

/// The registers of DI, if they hold at the beginning of each statement what they held when the block began. `is_loaded` says of a data block
/// whether opening it cannot fail.
fn kept(code: &Code, find: Find<'_>, is_loaded: &dyn Fn(u64) -> bool) -> u32 {
    let statements = 0..code.statement_count();
    let keeps = statements.map(|statement| code.statement(statement)).all(|insts| keeps(code, insts, find, is_loaded));
    if keeps { instance().into_iter().fold(0, |all, register| all | bit_of(register)) } else { 0 }
}

/// Whether a statement that begins with the own data block ends with it, whatever happens in it.
fn keeps(code: &Code, insts: &[Inst], find: Find<'_>, is_loaded: &dyn Fn(u64) -> bool) -> bool {
    let own: FxHashMap<Var, Register> = instance().into_iter().map(|register| (register.into(), register)).collect();
    // What holds one of the own values, and what a constant.
    let (mut held, mut constants) = (own.clone(), FxHashMap::default());
    let is_own = |held: &FxHashMap<Var, Register>| own.iter().all(|(var, register)| held.get(var) == Some(register));
    insts.iter().all(|inst| {
        let source = match *inst {
            Inst::Compute { op: Op::Copy, args: [from, ..], .. } => held.get(&from).copied(),
            _ => None,
        };
        let mut is_sure = !effect(inst).fails;
        match *inst {
            Inst::Open { register, number } => {
                is_sure = constants.get(&number).is_some_and(|&number| is_loaded(number));
                for register in data_registers(register) {
                    held.remove(&Var::from(register));
                }
            }
            Inst::Call { callee: Callee::Block(id), .. } => is_sure = find(id).is_some(),
            Inst::Load { place: Place::Fixed { area: Area::Local, .. }, .. }
            | Inst::Store { place: Place::Fixed { area: Area::Local, .. }, .. } => is_sure = true,
            _ => {}
        }
        let leaves = targets(code, inst).next().is_some() || matches!(inst, Inst::Return);
        if let Some(dst) = sieben_engine::ir::verify::writes(inst) {
            held.remove(&dst);
            constants.remove(&dst);
            if let Some(source) = source {
                held.insert(dst, source);
            }
            if let Inst::Constant { value, .. } = *inst {
                constants.insert(dst, value);
            }
        }
        // The statement may end here, and variables of an instance may be those of another one.
        let is_open = is_own(&held);
        is_open || is_sure && !leaves && !touches_instance(inst)
    }) && is_own(&held)
}

/// Whether an instruction itself reads or writes variables of the instance.
fn touches_instance(inst: &Inst) -> bool {
    let is_instance = |place: &Place| match place {
        Place::Fixed { area, .. } | Place::Indirect { area, .. } => *area == Area::InstanceData,
        Place::Crossing { .. } => true,
    };
    match inst {
        Inst::Load { place, .. } | Inst::Store { place, .. } => is_instance(place),
        Inst::Move { from, to, .. } | Inst::Text { from, to, .. } => is_instance(from) || is_instance(to),
        _ => false,
    }
}
