//! Master control relay.

use sieben_engine::fault::Abort;
use sieben_engine::ir::{Inst, Op, Var};
use sieben_engine::machine::Register;

use crate::stl::lower::Lowering;

const MCR: Var = Var(Register::Mcr as u8);

/// `MCR(`: at most eight zones.
pub(crate) fn open(l: &mut Lowering<'_>) {
    let room = l.b.compute(Op::McrHasRoom, &[MCR]);
    l.b.push(Inst::RequireStack { condition: room, abort: Abort::McrStack });
    l.b.compute_into(MCR, Op::McrPush, &[MCR, Register::Rlo.into()]);
    status(l);
}

/// `)MCR`.
pub(crate) fn close(l: &mut Lowering<'_>) {
    let open = l.b.compute(Op::McrIsOpen, &[MCR]);
    l.b.push(Inst::RequireStack { condition: open, abort: Abort::McrStack });
    l.b.compute_into(MCR, Op::McrPop, &[MCR]);
    status(l);
}

fn status(l: &mut Lowering<'_>) {
    l.b.set(Register::Or, 0);
    l.b.set(Register::Sta, 1);
    l.b.set(Register::Fc, 0);
}
