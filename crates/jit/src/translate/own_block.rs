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
        loops::find(code, || kept(code, self.find, &|number| self.data_block(number & 0xFFFF).is_some()))
    }
}

/// What a variable holds.
#[derive(Clone, Copy, PartialEq)]
enum Known {
    /// What a register of DI held at the beginning.
    Own(Register),
    Constant(u64),
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
    // What is known of the variables written so far; a register of DI holds its own value before.
    let mut known = FxHashMap::default();
    let value_of = |known: &FxHashMap<Var, Option<Known>>, var: Var| match known.get(&var) {
        Some(known) => *known,
        None => instance().into_iter().find(|&register| var == register.into()).map(Known::Own),
    };
    let is_own = |known: &_| instance().into_iter().all(|register| value_of(known, register.into()) == Some(Known::Own(register)));
    insts.iter().all(|inst| {
        let result = match *inst {
            Inst::Compute { op: Op::Copy, args: [from, ..], .. } => value_of(&known, from),
            Inst::Constant { value, .. } => Some(Known::Constant(value)),
            _ => None,
        };
        let mut is_sure = !effect(inst).fails;
        match *inst {
            Inst::Open { register, number } => {
                is_sure = matches!(value_of(&known, number), Some(Known::Constant(number)) if is_loaded(number));
                known.extend(data_registers(register).map(|register| (Var::from(register), None)));
            }
            Inst::Call { callee: Callee::Block(id), .. } => is_sure = find(id).is_some(),
            Inst::Load { place: Place::Fixed { area: Area::Local, .. }, .. }
            | Inst::Store { place: Place::Fixed { area: Area::Local, .. }, .. } => is_sure = true,
            _ => {}
        }
        let leaves = targets(code, inst).next().is_some() || matches!(inst, Inst::Return);
        if let Some(dst) = sieben_engine::ir::verify::writes(inst) {
            known.insert(dst, result);
        }
        // The statement may end here, and variables of an instance may be those of another one.
        let is_open = is_own(&known);
        is_open || is_sure && !leaves && !touches_instance(inst)
    }) && is_own(&known)
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
