//! Jumps.

use sieben_engine::ir::{Inst, Op, Target, Var};
use sieben_engine::machine::Register;

use super::WRONG_OPERAND;
use super::accumulators::ACCU1;
use super::bit_logic::status_scan;
use crate::stl::instructions::Instruction;
use crate::stl::lower::{Lowering, Statement};
use crate::stl::operands::{Operand, StatusScan};

fn target(operand: &Operand) -> Target {
    match operand {
        Operand::Label(statement) => Target(*statement),
        _ => unreachable!("{WRONG_OPERAND}"),
    }
}

/// `JU`.
pub(crate) fn always(l: &mut Lowering<'_>, operand: &Operand) {
    l.b.push(Inst::Jump { to: target(operand) });
}

/// `JC`, `JCN`, `JCB`, `JNB`: the status changes, taken or not.
pub(crate) fn on_rlo(l: &mut Lowering<'_>, operand: &Operand, when: bool, save: bool) {
    let condition = l.b.compute(if when { Op::Copy } else { Op::Not }, &[Register::Rlo.into()]);
    if save {
        l.b.copy(Register::Br, Register::Rlo);
    }
    l.b.set(Register::Rlo, 1);
    end_of_string(l);
    l.b.push(Inst::Branch { condition, to: target(operand) });
}

/// `JBI`, `JNBI`.
pub(crate) fn on_br(l: &mut Lowering<'_>, operand: &Operand, when: bool) {
    let condition = l.b.compute(if when { Op::Copy } else { Op::Not }, &[Register::Br.into()]);
    end_of_string(l);
    l.b.push(Inst::Branch { condition, to: target(operand) });
}

fn end_of_string(l: &mut Lowering<'_>) {
    l.b.set(Register::Or, 0);
    l.b.set(Register::Sta, 1);
    l.b.set(Register::Fc, 0);
}

/// `JO`.
pub(crate) fn on_bit(l: &mut Lowering<'_>, operand: &Operand, register: Register) {
    l.b.push(Inst::Branch { condition: register.into(), to: target(operand) });
}

/// `JOS`: OS is 0 afterwards in every case.
pub(crate) fn on_stored_overflow(l: &mut Lowering<'_>, operand: &Operand) {
    let condition = l.b.compute(Op::Copy, &[Register::Os.into()]);
    l.b.set(Register::Os, 0);
    l.b.push(Inst::Branch { condition, to: target(operand) });
}

/// `JZ`, `JN`, `JP`, `JM`, `JPZ`, `JMZ`, `JUO`.
pub(crate) fn on_status(l: &mut Lowering<'_>, operand: &Operand, scan: StatusScan) {
    let condition = status_scan(l, scan);
    l.b.push(Inst::Branch { condition, to: target(operand) });
}

/// `JL`: the list is the unbroken run of JU statements behind it.
pub(crate) fn list(l: &mut Lowering<'_>, operand: &Operand) {
    let otherwise = target(operand);
    let entries: Vec<Target> = list_entries(l.statements, l.index).iter().map(|entry| target(&entry.operand)).collect();
    let index: Var = l.b.compute(Op::Low8, &[ACCU1]);
    let first = l.b.table(&entries);
    let count = u32::try_from(entries.len()).unwrap_or(0);
    l.b.push(Inst::JumpTable { index, first, count, otherwise });
}

/// A jump distributor has at most 255 entries.
const LIST_MAX: usize = 255;

/// The entries of the jump distributor that is this statement: the `JU` behind it, as far as its label.
pub(crate) fn list_entries(statements: &[Statement], number: usize) -> Vec<&Statement> {
    let end = match statements.get(number).map(|statement| &statement.operand) {
        Some(Operand::Label(label)) => *label as usize,
        _ => return Vec::new(),
    };
    let entries = statements.iter().take(end).skip(number + 1);
    entries.take_while(|statement| statement.instruction == Instruction::Jump).take(LIST_MAX).collect()
}

/// `LOOP`: 0 wraps to 65535, so a start value of 0 runs the body 65536 times.
pub(crate) fn looping(l: &mut Lowering<'_>, operand: &Operand) {
    let count = l.b.compute(Op::Decrement16, &[ACCU1]);
    l.b.compute_into(Register::Accu1, Op::MergeLow16, &[ACCU1, count]);
    let condition = l.b.compute(Op::IsNonzero, &[count]);
    l.b.push(Inst::Branch { condition, to: target(operand) });
}
