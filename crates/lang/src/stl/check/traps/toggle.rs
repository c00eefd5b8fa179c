//! A bit that one condition sets and the same condition resets again in the same scan: a flip-flop without `BEC` between its halves.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use crate::stl::instructions::Instruction as I;
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::operands::Operand;

/// Reports two strings of ANDs directly after one another that differ only in the bit itself: the first sets it, the second resets it.
pub(super) fn check(block: &ResolvedBlock, diagnostics: &mut Vec<Diagnostic>) {
    let statements = &block.statements;
    let mut previous: Option<Half<'_>> = None;
    let mut begin = 0;
    for (index, statement) in statements.iter().enumerate() {
        let half = match statement.instruction {
            I::And | I::AndNot => continue,
            I::Set | I::Reset => half(&statements[begin..index], statement),
            _ => None,
        };
        let jumped_to =
            |begin: usize| statements.iter().any(|one| matches!(one.operand, Operand::Label(target) if target as usize == begin));
        if let (Some(first), Some(second)) = (previous.as_ref(), half.as_ref())
            && first.undone_by(second)
            && !jumped_to(begin)
        {
            let done = if second.sets { "sets" } else { "resets" };
            let undone = if second.sets { "reset" } else { "set" };
            let message =
                format!("this statement {done} in the same scan again what was {undone} just before: its condition holds because of that");
            diagnostics
                .push(Diagnostic::new(Problem::P5030, statement.span(), message).related(first.statement.span(), format!("{undone} here")));
        }
        previous = half;
        begin = index + 1;
    }
}

/// `A a; AN x; S x`.
struct Half<'s> {
    statement: &'s Statement,
    sets: bool,
    /// How the bit itself is scanned.
    scanned: I,
    /// The other scans, in one order.
    others: Vec<(I, &'s Operand)>,
}

impl Half<'_> {
    /// Whether the second runs because of what the first did, and undoes it.
    fn undone_by(&self, second: &Half<'_>) -> bool {
        self.statement.operand == second.statement.operand
            && self.sets != second.sets
            && self.scanned != second.scanned
            && (self.scanned == I::AndNot) == self.sets
            && self.others.len() == second.others.len()
            && self.others.iter().all(|one| second.others.contains(one))
    }
}

fn half<'s>(scans: &'s [Statement], statement: &'s Statement) -> Option<Half<'s>> {
    let own = |scan: &&Statement| scan.operand == statement.operand;
    let scanned = scans.iter().find(own)?.instruction;
    if scans.iter().filter(own).count() != 1 || !matches!(statement.operand, Operand::Memory(_)) {
        return None;
    }
    let others = scans.iter().filter(|scan| !own(scan)).map(|scan| (scan.instruction, &scan.operand)).collect();
    Some(Half { statement, sets: statement.instruction == I::Set, scanned, others })
}
