//! Masks of lanes: bits, each as 32 that are equal to it. Of a mask that took two instructions, or that is the complement of another one,
//! both are available: most uses of a mask take as few instructions with its complement.

use cranelift_codegen::ir::condcodes::{CondCode, IntCC};
use cranelift_codegen::ir::types::I8X16;
use cranelift_codegen::ir::{InstBuilder, InstructionData, Opcode, Value, ValueDef};
use cranelift_module::Module;
use sieben_engine::ir::Op;

use super::super::Translator;
use super::super::value::Val;
use super::scalar_evolution::Shape;
use super::vectorization::{Lanes, little};

/// Whether processors compare vectors so in two steps, and in one for the opposite.
pub(super) fn takes_two(condition: IntCC) -> bool {
    matches!(condition, IntCC::NotEqual | IntCC::SignedGreaterThanOrEqual | IntCC::SignedLessThanOrEqual)
}

/// Whether all lanes are this constant.
pub(super) fn is_constant(value: &Lanes, number: u64) -> bool {
    matches!(value, Lanes::One(Val::Const(known)) if *known == number)
}

impl Translator<'_> {
    /// Compares numbers of 32 bits.
    pub(super) fn compared(&mut self, condition: IntCC, a: Value, b: Value) -> Value {
        let mask = self.b.ins().icmp(condition, a, b);
        if takes_two(condition) {
            let opposite = self.b.ins().icmp(condition.complement(), a, b);
            self.opposites.insert(mask, opposite);
        }
        mask
    }

    /// The opposite of a mask.
    pub(super) fn opposite_of(&mut self, mask: Value) -> Value {
        if let Some(&opposite) = self.opposites.get(&mask) {
            return opposite;
        }
        let opposite = self.b.ins().bnot(mask);
        self.opposites.insert(opposite, mask);
        opposite
    }

    /// The opposite of a mask that is a simpler one.
    fn simpler_opposite(&self, mask: Value) -> Option<Value> {
        self.opposites.get(&mask).copied()
    }

    /// The opposites of masks, if these are simpler, and whether they are not.
    pub(super) fn simplest(&self, masks: Vec<Value>) -> (Vec<Value>, bool) {
        match masks.iter().map(|&mask| self.simpler_opposite(mask)).collect::<Option<Vec<Value>>>() {
            Some(opposites) => (opposites, false),
            None => (masks, true),
        }
    }

    /// What logic makes of two masks.
    pub(super) fn logic_of_masks(&mut self, op: Op, a: Value, b: Value) -> Value {
        let opposites = [a, b].map(|mask| self.simpler_opposite(mask));
        match (op, opposites) {
            (Op::And, [Some(a), Some(b)]) => {
                let either = self.b.ins().bor(a, b);
                self.opposite_of(either)
            }
            (Op::And, [Some(a), None]) => self.b.ins().band_not(b, a),
            (Op::And, [None, Some(b)]) => self.b.ins().band_not(a, b),
            (Op::And, _) => self.b.ins().band(a, b),
            (Op::AndNot, [Some(a), Some(b)]) => self.b.ins().band_not(b, a),
            (Op::AndNot, [Some(a), None]) => {
                let either = self.b.ins().bor(a, b);
                self.opposite_of(either)
            }
            (Op::AndNot, [None, Some(b)]) => self.b.ins().band(a, b),
            (Op::AndNot, _) => self.b.ins().band_not(a, b),
            (Op::Or, [Some(a), Some(b)]) => {
                let both = self.b.ins().band(a, b);
                self.opposite_of(both)
            }
            (Op::Or, [Some(a), None]) => {
                let neither = self.b.ins().band_not(a, b);
                self.opposite_of(neither)
            }
            (Op::Or, [None, Some(b)]) => {
                let neither = self.b.ins().band_not(b, a);
                self.opposite_of(neither)
            }
            (Op::Or, _) => self.b.ins().bor(a, b),
            (_, [Some(a), Some(b)]) => self.b.ins().bxor(a, b),
            (_, [Some(a), None]) => {
                let same = self.b.ins().bxor(a, b);
                self.opposite_of(same)
            }
            (_, [None, Some(b)]) => {
                let same = self.b.ins().bxor(a, b);
                self.opposite_of(same)
            }
            _ => self.b.ins().bxor(a, b),
        }
    }

    /// 1 where a mask is set, and 0 elsewhere.
    pub(super) fn number_of_mask(&mut self, mask: Value) -> Value {
        match self.simpler_opposite(mask) {
            // One that is set is -1.
            Some(opposite) => {
                let one = self.all_words(1);
                self.b.ins().iadd(opposite, one)
            }
            None => self.b.ins().ushr_imm_u(mask, 31),
        }
    }

    /// Bytes with a bit of each set where a mask is.
    pub(super) fn with_bit_of_mask(&mut self, byte: Value, bit: u8, mask: Value) -> Value {
        let own = self.all_words(1 << bit);
        match (self.simpler_opposite(mask), bit) {
            // One that is set is -1.
            (Some(opposite), 0) => {
                let set = self.b.ins().bor(byte, own);
                self.b.ins().iadd(set, opposite)
            }
            (Some(opposite), _) => {
                let set = self.b.ins().bor(byte, own);
                let off = self.b.ins().band(opposite, own);
                self.b.ins().bxor(set, off)
            }
            (None, 0) => {
                let others = self.b.ins().band_not(byte, own);
                self.b.ins().isub(others, mask)
            }
            (None, _) => {
                let others = self.b.ins().band_not(byte, own);
                let set = self.b.ins().band(mask, own);
                self.b.ins().bor(others, set)
            }
        }
    }

    /// Numbers with some bits cleared, and of these those of `ones` and those of the masks that hold set.
    pub(super) fn with_bits_of_masks(&mut self, numbers: Value, cleared: u32, ones: u32, masks: &[(Value, u32)]) -> Value {
        let kept = self.all_words(!cleared);
        let mut numbers = self.b.ins().band(numbers, kept);
        if ones != 0 {
            let ones = self.all_words(ones);
            numbers = self.b.ins().bor(numbers, ones);
        }
        for &(mask, own) in masks {
            let all = self.all_words(own);
            numbers = match self.simpler_opposite(mask) {
                // One that is set is -1.
                None if own == 1 => self.b.ins().isub(numbers, mask),
                None => {
                    let set = self.b.ins().band(mask, all);
                    self.b.ins().bor(numbers, set)
                }
                Some(opposite) => {
                    let set = self.b.ins().band_not(all, opposite);
                    self.b.ins().bor(numbers, set)
                }
            };
        }
        numbers
    }

    /// Masks chosen by masks.
    pub(super) fn chosen_masks(&mut self, masks: &[Value], a: &Lanes, b: &Lanes, lanes: u32) -> Vec<Value> {
        let with = |this: &mut Self, op: Op, of: &Lanes| {
            let of = this.masks(of, lanes);
            masks.iter().zip(of).map(|(&mask, of)| this.logic_of_masks(op, of, mask)).collect()
        };
        if is_constant(b, 0) {
            return with(self, Op::And, a);
        }
        if is_constant(a, 0) {
            return with(self, Op::AndNot, b);
        }
        if is_constant(a, 1) {
            return with(self, Op::Or, b);
        }
        let [a, b] = [a, b].map(|of| self.masks(of, lanes));
        let one = |((&mask, a), b): ((&Value, Value), Value)| {
            // Of opposites the opposite is chosen.
            if let (Some(a), Some(b)) = (self.simpler_opposite(a), self.simpler_opposite(b)) {
                let chosen = self.choice_of_mask(mask, a, b);
                return self.opposite_of(chosen);
            }
            self.choice_of_mask(mask, a, b)
        };
        masks.iter().zip(a).zip(b).map(one).collect()
    }

    fn choice_of_mask(&mut self, mask: Value, a: Value, b: Value) -> Value {
        match self.simpler_opposite(mask) {
            Some(opposite) => self.choice(opposite, b, a),
            None => self.choice(mask, a, b),
        }
    }

    /// Numbers where masks hold, or do not, and 0 elsewhere.
    pub(super) fn where_masks(&mut self, values: Vec<Value>, masks: Vec<Value>, hold: bool, shape: Shape) -> Vec<Value> {
        let (masks, are_so) = self.simplest(masks);
        let masks = self.masks_of_shape(masks, shape);
        let both = values.into_iter().zip(masks);
        both.map(|(value, mask)| if hold == are_so { self.b.ins().band(value, mask) } else { self.b.ins().band_not(value, mask) }).collect()
    }

    /// Masks for numbers of 16 or 32 bits.
    pub(super) fn masks_of_shape(&mut self, masks: Vec<Value>, shape: Shape) -> Vec<Value> {
        if shape != Shape::Halves {
            return masks;
        }
        masks.chunks(2).map(|pair| self.b.ins().snarrow(pair[0], pair[pair.len() - 1])).collect()
    }

    /// The bits of one vector where those of a mask are set, and of another one elsewhere.
    pub(super) fn choice(&mut self, mask: Value, a: Value, b: Value) -> Value {
        let compared = |inst| matches!(self.b.func.dfg.insts[inst].opcode(), Opcode::Icmp | Opcode::Fcmp);
        if !self.blends() || self.b.func.dfg.value_def(mask).inst().is_some_and(compared) {
            return self.b.ins().bitselect(mask, a, b);
        }
        // Cranelift sees only of comparisons that all bits of a byte are the same.
        let ty = self.b.func.dfg.value_type(a);
        let [mask, a, b] = [mask, a, b].map(|vector| self.b.ins().bitcast(I8X16, little(), vector));
        let chosen = self.b.ins().blendv(mask, a, b);
        self.b.ins().bitcast(ty, little(), chosen)
    }

    /// Whether the processor chooses bytes by the highest bit of others in one step.
    fn blends(&self) -> bool {
        let isa = self.module.isa();
        cfg!(all(target_arch = "x86_64", not(feature = "aarch64")))
            && isa.isa_flags().iter().any(|flag| flag.name == "has_sse41" && flag.as_bool() == Some(true))
    }

    /// The vector of whose bytes another one is made, and which they are.
    pub(super) fn shuffled_of(&self, vector: Value) -> Option<(Value, Vec<u8>)> {
        let dfg = &self.b.func.dfg;
        let mut vector = vector;
        loop {
            let ValueDef::Result(inst, _) = dfg.value_def(vector) else { return None };
            match dfg.insts[inst] {
                InstructionData::LoadNoOffset { opcode: Opcode::Bitcast, arg, .. } => vector = arg,
                InstructionData::Shuffle { args: [a, b], imm, .. } if a == b => {
                    return Some((a, dfg.immediates.get(imm)?.as_slice().iter().map(|&at| at % 16).collect()));
                }
                _ => return None,
            }
        }
    }
}
