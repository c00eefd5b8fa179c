//! Operations as machine code. This list is the only place where an operation has a second meaning: each line is compared with
//! its row in the table of operations over a grid of values.

use sieben_engine::ir::Op;

use super::{Translator, value::Val};

impl Translator<'_> {
    /// The operation as machine code, if it has such a form.
    pub(super) fn inline(&mut self, op: Op, args: &[Val]) -> Option<Val> {
        match op {
            Op::Low32 => Some(Val::Int(self.int(args[0]))),
            _ => None,
        }
    }
}
