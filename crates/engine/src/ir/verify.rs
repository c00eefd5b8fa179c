//! The rules that code keeps, checked: engines rely on them.

use std::collections::HashSet;

use super::code::{Code, Inst, OnFault, Place, Target, TextAction, TextRoom, Var};
use crate::fault::NOTED;
use crate::machine::Register;

/// A rule that code breaks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Violation {
    /// The statement.
    pub statement: usize,
    /// The instruction in the statement.
    pub instruction: usize,
    /// The broken rule.
    pub rule: &'static str,
}

/// Checks the code of a block:
///
/// * every target is a statement, every table lies inside the list of tables;
/// * a temporary is written before it is read, in the same statement, and not across a call;
/// * behind a load that delivers 0 only its result is still readable;
/// * no register is changed before an instruction that may make the statement count as NOP;
/// * a number that is read from a text goes to eight bytes;
/// * the block ends with a return.
///
/// # Errors
/// The first broken rule.
pub fn verify(code: &Code) -> Result<(), Violation> {
    let count = code.statement_count();
    let violation = |statement, instruction, rule| Violation { statement, instruction, rule };
    if !matches!(code.insts.last(), Some(Inst::Return)) {
        return Err(violation(count, 0, "the last instruction is a return"));
    }
    for statement in 0..count {
        let mut written: HashSet<Var> = HashSet::new();
        let mut changed_register = false;
        let mut called = false;
        for (instruction, inst) in code.statement(statement).iter().enumerate() {
            let broken = |rule| Err(violation(statement, instruction, rule));
            if targets(inst, code).is_none_or(|targets| targets.iter().any(|target| target.0 as usize >= count)) {
                return broken("a target is a statement of the block");
            }
            if reads(inst).any(|var| var.register().is_none() && !written.contains(&var)) {
                return broken("a temporary is written before it is read");
            }
            if matches!(inst, Inst::Text { action: TextAction::Number, to_room, .. } if *to_room != TextRoom::NUMBER) {
                return broken("a number that is read from a text has eight bytes");
            }
            // The parameter code of a CALL changes registers between its parts, as on the real CPU.
            let skips = match inst {
                Inst::Load { on_fault, .. } => *on_fault != OnFault::DeliverZero,
                Inst::Store { .. } | Inst::Move { .. } | Inst::Text { .. } | Inst::Intrinsic { .. } | Inst::RequireStack { .. } => true,
                Inst::Require { code, .. } => code & NOTED == 0,
                _ => false,
            };
            let passes = code.statement(statement).iter().any(|inst| matches!(inst, Inst::Call { .. }));
            if skips && changed_register && !called && !passes {
                return broken("what may fail stands before the first register that the statement changes");
            }
            match inst {
                Inst::Call { .. } => {
                    written.clear();
                    called = true;
                }
                Inst::Load { on_fault: OnFault::DeliverZero, .. } => written.clear(),
                _ => {}
            }
            if let Some(dst) = writes(inst) {
                // Access through a POINTER takes its address into AR1 first, as the compiled access of the real CPU does.
                changed_register |= dst.register().is_some_and(|register| register != Register::Ar1);
                written.insert(dst);
            }
        }
    }
    Ok(())
}

/// Where an instruction may go on; `None` if its table lies outside the list.
fn targets(inst: &Inst, code: &Code) -> Option<Vec<Target>> {
    Some(match *inst {
        Inst::Jump { to } | Inst::Branch { to, .. } => vec![to],
        Inst::JumpTable { first, count, otherwise, .. } => {
            let table = code.tables.get(first as usize..first as usize + count as usize)?;
            table.iter().copied().chain([otherwise]).collect()
        }
        _ => Vec::new(),
    })
}

/// The variables that an instruction reads, each as often as it does.
pub fn reads(inst: &Inst) -> impl Iterator<Item = Var> + use<> {
    let pointer = |place: Place| match place {
        Place::Fixed { .. } => None,
        Place::Indirect { pointer, .. } | Place::Crossing { pointer, .. } => Some(pointer),
    };
    let first = |args: [Var; 4], count: usize| std::array::from_fn(|index| (index < count).then_some(args[index]));
    let found: [Option<Var>; 4] = match *inst {
        Inst::Compute { op, args, .. } => first(args, op.arity()),
        Inst::Intrinsic { intrinsic, args, .. } => first(args, intrinsic.arity()),
        Inst::Load { place, .. } => [pointer(place), None, None, None],
        Inst::Store { place, src, .. } => [pointer(place), Some(src), None, None],
        Inst::Move { from, to, .. } => [pointer(from), pointer(to), None, None],
        Inst::Text { action, from, to, piece: [at, length], .. } => {
            let piece = |var: Var| action.takes_piece().then_some(var);
            [pointer(from), pointer(to), piece(at), piece(length)]
        }
        Inst::Require { condition, register, .. } => [Some(condition), Some(register), None, None],
        Inst::PassParameter { src: var }
        | Inst::RequireStack { condition: var, .. }
        | Inst::Branch { condition: var, .. }
        | Inst::Open { number: var, .. }
        | Inst::JumpTable { index: var, .. }
        | Inst::Call { callee: super::Callee::Number(_, var), .. } => [Some(var), None, None, None],
        Inst::Constant { .. } | Inst::Parameter { .. } | Inst::Jump { .. } | Inst::Call { .. } | Inst::Return => [None; 4],
    };
    found.into_iter().flatten()
}

/// The variable that an instruction writes.
pub fn writes(inst: &Inst) -> Option<Var> {
    match *inst {
        Inst::Constant { dst, .. }
        | Inst::Compute { dst, .. }
        | Inst::Load { dst, .. }
        | Inst::Parameter { dst, .. }
        | Inst::Text { dst, .. }
        | Inst::Intrinsic { dst, .. } => Some(dst),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{Inst, Var, verify};
    use crate::ir::{Builder, Op, Target};
    use crate::machine::Register;

    #[test]
    fn broken_rules_are_found() {
        let temporary = Var::temporary(3).expect("a temporary");
        let cases: [(&str, Vec<Inst>); 4] = [
            ("target", vec![Inst::Jump { to: Target(9) }]),
            ("written before", vec![Inst::Compute { op: Op::Not, dst: Register::Rlo.into(), args: [temporary; 4] }]),
            (
                "stands before",
                vec![
                    Inst::Constant { dst: Register::Rlo.into(), value: 1 },
                    Inst::Require { condition: Register::Rlo.into(), code: 0x21, register: Register::Rlo.into() },
                ],
            ),
            (
                "written before",
                vec![
                    Inst::Constant { dst: temporary, value: 1 },
                    Inst::Call { callee: crate::ir::Callee::Block(sieben_model::block::BlockId::fc(1)), parameters: 0 },
                    Inst::PassParameter { src: temporary },
                ],
            ),
        ];
        for (rule, insts) in cases {
            let mut builder = Builder::default();
            builder.begin_statement();
            insts.into_iter().for_each(|inst| builder.push(inst));
            let violation = verify(&builder.finish()).expect_err(rule);
            assert!(violation.rule.contains(rule), "{violation:?}");
        }
    }

    #[test]
    fn an_empty_block_is_right() {
        assert_eq!(verify(&Builder::default().finish()), Ok(()));
    }
}
