//! Values of variables, deferred or in the form that costs least.

use cranelift_codegen::ir::condcodes::{CondCode, IntCC};
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{self as clif, InstBuilder, InstructionData, Opcode, Value};
use sieben_engine::ir::Op;

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
    /// Bit `at` of 32, with anything around it: a bit of a byte that nobody has moved yet.
    At { value: Value, at: u8 },
    /// A REAL and its bits in 32. Where it is no number, the bits alone tell which one.
    Real { real: Value, bits: Value },
    /// An LREAL and its bits in 64. Where it is no number, the bits alone tell which one.
    Lreal { real: Value, bits: Value },
    /// An operation that is written where its result is needed first, if it ever is; by its number.
    Lazy(u32),
}

/// An operation that waits for somebody who needs its result.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lazy {
    op: Op,
    args: [Val; 4],
    /// How many waiting operations its arguments rest on.
    depth: u8,
    /// The result and the block in which it was written; `None` = on the hot path, which goes on through all that follows.
    written: Option<(Option<clif::Block>, Val)>,
}

/// Waiting operations that rest on one another: more would make cold code long.
const DEPTH_MAX: u8 = 6;

/// Constants that the present code has named: one name serves all that use it there. Without Cranelift's optimizations nobody else
/// would see that they are the same, and each name takes its time to compile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants([Option<(clif::Block, i64, Value)>; 64]);

impl Default for Constants {
    fn default() -> Self {
        Self([None; 64])
    }
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
    /// The result of an operation, written when it is needed.
    pub(super) fn later(&mut self, op: Op, args: [Val; 4]) -> Val {
        let result = self.waits(op, &args[..op.arity()]);
        if self.depth(result) > DEPTH_MAX { self.force(result) } else { result }
    }

    /// The same for an operation of which there can be only a few that rest on one another.
    pub(super) fn waits(&mut self, op: Op, used: &[Val]) -> Val {
        let depth = used.iter().map(|&arg| self.depth(arg)).max().unwrap_or(0).saturating_add(1);
        let number = self.lazies.len() as u32;
        let mut args = [Val::Const(0); 4];
        args[..used.len()].copy_from_slice(used);
        self.lazies.push(Lazy { op, args, depth, written: None });
        Val::Lazy(number)
    }

    /// The operation that calculates a value, and its arguments, if it was to wait.
    pub(super) fn waiting(&self, value: Val) -> Option<(Op, [Val; 4])> {
        let Val::Lazy(number) = value else { return None };
        let Lazy { op, args, .. } = self.lazies[number as usize];
        Some((op, args))
    }

    fn depth(&self, value: Val) -> u8 {
        let Val::Lazy(number) = value else { return 0 };
        match self.lazies[number as usize] {
            Lazy { written: Some((None, _)), .. } => 0,
            // What one cold block has written all others write again.
            Lazy { depth, .. } => depth,
        }
    }

    /// Writes an operation that waits, unless its result is there already.
    pub(super) fn force(&mut self, value: Val) -> Val {
        let Val::Lazy(number) = value else { return value };
        let lazy = self.lazies[number as usize];
        match lazy.written {
            Some((None, value)) => return value,
            Some((block, value)) if block == self.cold => return value,
            _ => {}
        }
        let result = self.compute_now(lazy.op, &lazy.args[..lazy.op.arity()]);
        let result = self.force(result);
        self.lazies[number as usize].written = Some((self.cold, result));
        result
    }

    /// A constant in 32 bits.
    pub(super) fn constant(&mut self, constant: u32) -> Value {
        let constant = i64::from(constant);
        let Some(block) = self.b.current_block() else { return self.b.ins().iconst(I32, constant) };
        let slot = constant as usize % self.constants.0.len();
        if let Some((other, known, value)) = self.constants.0[slot]
            && other == block
            && known == constant
        {
            return value;
        }
        let value = self.b.ins().iconst(I32, constant);
        self.constants.0[slot] = Some((block, constant, value));
        value
    }

    /// The bits of a mask, in 32 bits.
    pub(super) fn masked(&mut self, value: Value, mask: u32) -> Value {
        let mask = self.constant(mask);
        self.b.ins().band(value, mask)
    }

    /// As 64 bits.
    pub(super) fn word(&mut self, value: Val) -> Value {
        match self.force(value) {
            Val::Const(value) => self.b.ins().iconst(I64, value as i64),
            Val::Word(value) | Val::Lreal { bits: value, .. } => value,
            Val::Int(value) => self.b.ins().uextend(I64, value),
            Val::Real { bits, .. } => self.b.ins().uextend(I64, bits),
            value => {
                let flag = self.flag(value);
                self.b.ins().uextend(I64, flag)
            }
        }
    }

    /// The low 32 bits.
    pub(super) fn int(&mut self, value: Val) -> Value {
        match self.force(value) {
            Val::Const(value) => self.constant(value as u32),
            Val::Word(value) | Val::Lreal { bits: value, .. } => self.b.ins().ireduce(I32, value),
            Val::Int(value) => value,
            Val::Real { bits, .. } => bits,
            value => self.flag(value),
        }
    }

    /// Bit 0, with anything above it, in 32 bits.
    pub(super) fn bit(&mut self, value: Val) -> Value {
        match self.force(value) {
            Val::Const(value) => self.constant(value as u32 & 1),
            Val::Word(value) | Val::Lreal { bits: value, .. } => self.b.ins().ireduce(I32, value),
            Val::Int(value) | Val::Bit { value, .. } => value,
            Val::At { value, at } => self.moved(value, at, 0),
            Val::Real { bits, .. } => bits,
            Val::Lazy(_) => unreachable!("it was written"),
        }
    }

    /// Two bits at the same position, which is returned behind them: bits of bytes are moved at most once, to where the statement writes
    /// its result, if that is known.
    pub(super) fn aligned(&mut self, a: Val, b: Val) -> (Value, Value, u8) {
        let among_others = |value: Val| match value {
            Val::At { value, at } => Some((value, at)),
            Val::Bit { value, clean: false } => Some((value, 0)),
            _ => None,
        };
        match (among_others(a), among_others(b)) {
            (Some((a, at)), Some((b, other))) if self.aim.is_some() || at > 0 && other > 0 => {
                let to = if at == other { at } else { self.aim.unwrap_or(at) };
                (self.moved(a, at, to), self.moved(b, other, to), to)
            }
            _ => (self.bit(a), self.bit(b), 0),
        }
    }

    /// Moves bits from one position to another, around the end: what is at the others does not count.
    fn moved(&mut self, value: Value, from: u8, to: u8) -> Value {
        if from == to {
            return value;
        }
        let by = self.constant(u32::from(from.wrapping_sub(to) % 32));
        if self.is_alone(value, from) {
            let moved = self.b.ins().rotr(value, by);
            self.note_alone(moved, to, true);
            return moved;
        }
        if let Some((_, InstructionData::Unary { opcode: Opcode::Bnot, arg })) = self.definition(value) {
            // A NOT behind it is one with the AND that follows, in most cases.
            let value = self.b.ins().rotr(arg, by);
            return self.b.ins().bnot(value);
        }
        self.b.ins().rotr(value, by)
    }

    /// The bit at a position of 32, the others 0.
    pub(super) fn bit_at(&mut self, value: Val, to: u8) -> Value {
        match self.force(value) {
            Val::Bit { value, clean: true } => self.moved(value, 0, to),
            Val::At { value, at } => {
                let value = self.moved(value, at, to);
                self.bit_alone(value, to)
            }
            value => {
                let value = self.bit(value);
                let value = self.moved(value, 0, to);
                self.masked(value, 1 << to)
            }
        }
    }

    /// The bit at a position, the others 0.
    fn bit_alone(&mut self, value: Value, at: u8) -> Value {
        if self.is_alone(value, at) {
            return value;
        }
        let alone = self.masked(value, 1 << at);
        self.note_alone(alone, at, true);
        alone
    }

    /// Whether all bits of a number are 0 but one, perhaps.
    pub(super) fn is_alone(&self, value: Value, at: u8) -> bool {
        self.alone.get(&value) == Some(&at)
    }

    /// Notes that they are, if that is so.
    pub(super) fn note_alone(&mut self, value: Value, at: u8, is_alone: bool) {
        if is_alone {
            self.alone.insert(value, at);
        }
    }

    /// A bit at its position; `clean` counts at position 0.
    pub(super) fn bit_value(value: Value, at: u8, clean: bool) -> Val {
        if at == 0 { Val::Bit { value, clean } } else { Val::At { value, at } }
    }

    /// A bit of a number, by its own number below 64.
    pub(super) fn named_bit(&mut self, number: Val, bit: u8) -> Val {
        if bit < 32 {
            return Self::bit_value(self.int(number), bit, false);
        }
        let number = self.word(number);
        let moved = self.b.ins().ushr_imm_u(number, i64::from(bit));
        Val::Bit { value: self.b.ins().ireduce(I32, moved), clean: false }
    }

    /// The comparison whose result a bit is.
    pub(super) fn comparison(&self, bit: Val) -> Option<(IntCC, Value, Value)> {
        let Val::Bit { value, clean: true } = bit else { return None };
        let (_, InstructionData::Unary { opcode: Opcode::Uextend, arg }) = self.definition(value)? else { return None };
        match self.definition(arg)? {
            (_, InstructionData::IntCompare { cond, args: [a, b], .. }) => Some((cond, a, b)),
            _ => None,
        }
    }

    /// A bit for a jump or a choice: a value that is not 0 if it is 1, or, behind a NOT, if it is 0.
    pub(super) fn condition(&mut self, value: Val) -> (Value, bool) {
        let (value, negated) = self.without_not(value);
        match value {
            Val::At { value, at } => (self.b.ins().band_imm_u(value, 1 << at), negated),
            value => (self.flag(value), negated),
        }
    }

    /// What is not 0 where a condition is, and is 0 where it is not.
    pub(super) fn opposite(&mut self, condition: Value) -> Value {
        match self.definition(condition) {
            Some((_, InstructionData::Unary { opcode: Opcode::Uextend, arg })) => self.opposite(arg),
            Some((_, InstructionData::IntCompare { args: [a, b], cond, .. })) => self.b.ins().icmp(cond.complement(), a, b),
            Some((_, InstructionData::FloatCompare { args: [a, b], cond, .. })) => self.b.ins().fcmp(cond.complement(), a, b),
            _ => self.b.ins().icmp_imm_u(IntCC::Equal, condition, 0),
        }
    }

    /// What was negated, if a value is the result of a NOT.
    pub(super) fn without_not(&mut self, value: Val) -> (Val, bool) {
        let value = self.force(value);
        let (Val::Bit { value: bits, .. } | Val::At { value: bits, .. }) = value else { return (value, false) };
        let Some((_, data)) = self.definition(bits) else { return (value, false) };
        let is_one = |this: &Self, value: Value| this.iconst(value) == Some(1);
        match (value, data) {
            (Val::Bit { clean: false, .. }, InstructionData::Unary { opcode: Opcode::Bnot, arg }) => {
                (Val::Bit { value: arg, clean: false }, true)
            }
            (Val::At { at, .. }, InstructionData::Unary { opcode: Opcode::Bnot, arg }) => (Val::At { value: arg, at }, true),
            (Val::Bit { clean: true, .. }, InstructionData::Binary { opcode: Opcode::Bxor, args: [of, one] }) if is_one(self, one) => {
                (Val::Bit { value: of, clean: true }, true)
            }
            _ => (value, false),
        }
    }

    /// Bit 0 alone, in 32 bits.
    pub(super) fn flag(&mut self, value: Val) -> Value {
        match self.force(value) {
            value @ (Val::Const(_) | Val::Bit { clean: true, .. }) => self.bit(value),
            value => {
                let bit = self.bit(value);
                self.masked(bit, 1)
            }
        }
    }
}
