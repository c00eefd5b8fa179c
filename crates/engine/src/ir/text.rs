//! The IR as text, for people.

use std::fmt;

use super::code::{Code, Inst, Var};

impl fmt::Display for Var {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.register() {
            Some(register) => f.write_str(register.name()),
            None => write!(f, "t{}", usize::from(self.0) - crate::machine::Register::COUNT),
        }
    }
}

impl fmt::Display for Inst {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant { dst, value } => write!(f, "{dst} := 16#{value:X}"),
            Self::Compute { op, dst, args } => {
                write!(f, "{dst} := {}", op.name())?;
                args.iter().take(op.arity()).try_for_each(|arg| write!(f, " {arg}"))
            }
            Self::Load { dst, place, width, .. } => write!(f, "{dst} := load {width:?} {place:?}"),
            Self::Store { place, width, src } => write!(f, "store {width:?} {place:?} := {src}"),
            Self::Intrinsic { dst, intrinsic, args } => {
                write!(f, "{dst} := {intrinsic:?}")?;
                args.iter().take(intrinsic.arity()).try_for_each(|arg| write!(f, " {arg}"))
            }
            other => write!(f, "{other:?}"),
        }
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for statement in 0..self.statement_count() {
            writeln!(f, "{statement}:")?;
            for inst in self.statement(statement) {
                writeln!(f, "    {inst}")?;
            }
        }
        Ok(())
    }
}
