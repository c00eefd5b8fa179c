//! The DI register as a callee-saved one, in a block that calls instances in other data blocks: a call of one opens its data block as DI,
//! and after the call the block's own one is open again, taken from where it was saved. So DI is at the beginning of each statement what it
//! was at entry, and a loop with such calls does not change it.

use rustc_hash::FxHashMap;
use sieben_engine::access::data_registers;
use sieben_engine::ir::{Callee, Code, DataRegister, Inst, Op, Place, Var};
use sieben_engine::machine::Register;
use sieben_model::address::Area;

use super::natural_loops::{self, NaturalLoop, targets};
use super::status_liveness::effect;
use super::{Find, Translator, bit_of};

/// Registers of DI.
fn instance() -> [Register; 3] {
    data_registers(DataRegister::Instance)
}

impl Translator<'_> {
    /// The loops of a block.
    pub(super) fn find_loops(&self, code: usize) -> Vec<NaturalLoop> {
        let code = &self.blocks[code].code;
        natural_loops::find(code, || kept(code, self.find))
    }
}

/// The registers of DI, if they hold at the beginning of each statement what they held when the block began.
fn kept(code: &Code, find: Find<'_>) -> u32 {
    let statements = 0..code.statement_count();
    let keeps = statements.map(|statement| code.statement(statement)).all(|insts| keeps(code, insts, find));
    if keeps { instance().into_iter().fold(0, |all, register| all | bit_of(register)) } else { 0 }
}

/// Whether a statement that begins with the own data block ends with it, whatever happens in it.
fn keeps(code: &Code, insts: &[Inst], find: Find<'_>) -> bool {
    // Which of the own values the variables written so far hold; a register of DI holds its own before.
    let mut held = FxHashMap::default();
    let value_of = |held: &FxHashMap<Var, Option<Register>>, var: Var| {
        held.get(&var).copied().unwrap_or_else(|| instance().into_iter().find(|&register| var == register.into()))
    };
    let is_own = |held: &_| instance().into_iter().all(|register| value_of(held, register.into()) == Some(register));
    insts.iter().all(|inst| {
        // The statement may end here before the instruction wrote anything, and variables of an instance may be those of another one.
        let is_sure = match *inst {
            Inst::Call { callee: Callee::Block(id), .. } => find(id).is_some(),
            Inst::Load { place: Place::Fixed { area: Area::Local, .. }, .. }
            | Inst::Store { place: Place::Fixed { area: Area::Local, .. }, .. } => true,
            _ => !effect(inst).fails,
        };
        let leaves = targets(code, inst).next().is_some() || matches!(inst, Inst::Return);
        let is_harmless = is_sure && !leaves && !touches_instance(inst) || is_own(&held);
        let result = match *inst {
            Inst::Compute { op: Op::Copy, args: [from, ..], .. } => value_of(&held, from),
            _ => None,
        };
        if let Inst::Open { register, .. } = *inst {
            held.extend(data_registers(register).map(|register| (Var::from(register), None)));
        }
        if let Some(dst) = sieben_engine::ir::verify::writes(inst) {
            held.insert(dst, result);
        }
        is_harmless
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
