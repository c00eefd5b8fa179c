//! Dead load elimination: loads in bounds whose results no instruction uses.

use sieben_engine::ir::{Inst, Op, Place, Var};
use sieben_model::address::Width;

use super::Translator;
use crate::passes::Pass;

/// Instructions after a load that are searched for a use of its result.
const USES_MAX: u32 = 96;

impl Translator<'_> {
    /// Whether a load cannot fail and its result is not used, because a select that would take it has been decided.
    pub(super) fn is_dead_load(&mut self, index: u32, dst: Var, (place, width): (Place, Width)) -> bool {
        if !self.options.passes.has(Pass::DeadLoadElimination) {
            return false;
        }
        let is_in_bounds = self.ranges.inside(index).is_some() || self.constant_address(place, width).is_some();
        if !self.options.optimize || !is_in_bounds || dst.register().is_some() {
            return false;
        }
        let code = &self.native().code;
        let end = code.statements.get(self.statement as usize + 1).copied().unwrap_or(code.insts.len() as u32);
        let seen = end.min(index + 1 + USES_MAX);
        // What a temporary holds here is not what it holds there, if it is written in between.
        let mut written = vec![dst];
        for inst in &code.insts[index as usize + 1..seen as usize] {
            let needed = match *inst {
                Inst::Compute { op: Op::Select, args: [condition, a, b, _], .. } => {
                    let stays = condition.register().is_none() && !written.contains(&condition);
                    let known = if stays { self.get(condition).constant() } else { None };
                    match known {
                        Some(condition) => dst == if condition & 1 != 0 { a } else { b },
                        None => [condition, a, b].contains(&dst),
                    }
                }
                _ => sieben_engine::ir::verify::reads(inst).any(|var| var == dst),
            };
            if needed {
                return false;
            }
            match sieben_engine::ir::verify::writes(inst) {
                Some(var) if var == dst => return true,
                Some(var) => written.push(var),
                None => {}
            }
        }
        seen == end
    }
}
