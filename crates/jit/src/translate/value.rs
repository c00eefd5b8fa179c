//! Values of variables, in the form that costs least.

use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};

use super::Translator;

/// What a register or temporary holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Val {
    /// A constant.
    Const(u64),
    /// 64 bits.
    Word(Value),
    /// 32 bits, the others 0.
    Int(Value),
    /// One bit, lowest in 32; the others are 0 only if it is clean.
    Bit { value: Value, clean: bool },
}

impl Val {
    /// The constant, if it is one.
    pub(super) fn constant(self) -> Option<u64> {
        match self {
            Self::Const(value) => Some(value),
            _ => None,
        }
    }
}

impl Translator<'_> {
    /// As 64 bits.
    pub(super) fn word(&mut self, value: Val) -> Value {
        match value {
            Val::Const(value) => self.b.ins().iconst(I64, value as i64),
            Val::Word(value) => value,
            Val::Int(value) => self.b.ins().uextend(I64, value),
            Val::Bit { .. } => {
                let flag = self.flag(value);
                self.b.ins().uextend(I64, flag)
            }
        }
    }

    /// The low 32 bits.
    pub(super) fn int(&mut self, value: Val) -> Value {
        match value {
            Val::Const(value) => self.b.ins().iconst(I32, i64::from(value as u32)),
            Val::Word(value) => self.b.ins().ireduce(I32, value),
            Val::Int(value) => value,
            Val::Bit { .. } => self.flag(value),
        }
    }

    /// Bit 0, with anything above it, in 32 bits.
    pub(super) fn bit(&mut self, value: Val) -> Value {
        match value {
            Val::Const(value) => self.b.ins().iconst(I32, (value & 1) as i64),
            Val::Word(value) => self.b.ins().ireduce(I32, value),
            Val::Int(value) | Val::Bit { value, .. } => value,
        }
    }

    /// Bit 0 alone, in 32 bits.
    pub(super) fn flag(&mut self, value: Val) -> Value {
        match value {
            Val::Const(_) | Val::Bit { clean: true, .. } => self.bit(value),
            _ => {
                let bit = self.bit(value);
                self.b.ins().band_imm_u(bit, 1)
            }
        }
    }
}
