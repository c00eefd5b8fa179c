//! A CASE that assigns a constant in each of its branches: the constants lie side by side in a few words, and the selector tells which one
//! it is. Nobody foresees where a jump by a table leads if the selector depends on the plant.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::{Inst, OnFault, Place, Target, Var};
use sieben_model::address::Width;

use super::Translator;
use super::value::Val;

/// Words of 64 bits that hold all constants; with more of them the choice between them takes longer than a jump.
const WORDS_MAX: u32 = 4;

/// What the branches of a CASE assign.
struct Constants {
    place: Place,
    width: Width,
    /// The instruction that writes it in one of the branches.
    store: u32,
    /// For each value of the selector, from 0 on.
    of_cases: Vec<u64>,
    /// Otherwise; `None` if nothing is written then.
    otherwise: Option<u64>,
    /// The statement behind the CASE.
    end: u32,
}

impl Translator<'_> {
    /// Writes a jump by a table behind which constants are assigned to a variable and nothing else is done; whether it was one.
    pub(super) fn assigns_by_table(&mut self, index: u32, selector: Var, targets: &[Target], otherwise: Target) -> bool {
        let Some(constants) = self.constants_of_case(targets, otherwise) else { return false };
        let Constants { place, width, of_cases, .. } = &constants;
        let most = of_cases.iter().copied().max().unwrap_or(0);
        let bits = [1, 8, 16].into_iter().find(|&bits| most >> bits == 0).unwrap_or(32);
        let in_word = 64 / bits;
        if (of_cases.len() as u32).div_ceil(in_word) > WORDS_MAX {
            return false;
        }
        let selector = self.get(selector);
        let selector = self.word(selector);
        let words = of_cases
            .chunks(in_word as usize)
            .map(|cases| cases.iter().zip(0..).fold(0, |word, (&constant, number): (&u64, u32)| word | constant << (number * bits)));
        let words: Vec<u64> = words.collect();
        let chosen = self.word_of_table(selector, &words, in_word);
        let distance = self.b.ins().imul_imm_u(selector, i64::from(bits));
        let distance = self.b.ins().band_imm_u(distance, 63);
        let found = self.b.ins().ushr(chosen, distance);
        let found = self.b.ins().ireduce(I32, found);
        let found = if bits < 32 { self.b.ins().band_imm_u(found, (1 << bits) - 1) } else { found };
        let otherwise = match constants.otherwise {
            Some(constant) => self.b.ins().iconst(I32, i64::from(constant as u32)),
            None => {
                let free = Var::temporary(self.temporaries.len()).unwrap_or_default();
                self.load(index, free, *place, *width, OnFault::SkipWrite);
                let old = self.get(free);
                if *width == Width::Bit { self.bit(old) } else { self.int(old) }
            }
        };
        let is_case = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, selector, of_cases.len() as i64);
        let value = self.b.ins().select(is_case, found, otherwise);
        let value = if *width == Width::Bit { Val::Bit { value, clean: false } } else { Val::Int(value) };
        self.store(constants.store, *place, *width, value);
        self.inst(index, &Inst::Jump { to: Target(constants.end) });
        true
    }

    /// The word with the constant for a selector; any of them if there is none.
    fn word_of_table(&mut self, selector: Value, words: &[u64], in_word: u32) -> Value {
        let mut chosen = self.b.ins().iconst(I64, words[0] as i64);
        for (&word, number) in words[1..].iter().zip(1..) {
            let word = self.b.ins().iconst(I64, word as i64);
            let before = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, selector, i64::from(number * in_word));
            chosen = self.b.ins().select(before, chosen, word);
        }
        chosen
    }

    /// What statements behind the running one assign to which its jump by a table leads, if they do nothing else.
    fn constants_of_case(&self, targets: &[Target], otherwise: Target) -> Option<Constants> {
        if !self.options.optimize || targets.is_empty() {
            return None;
        }
        let code = &self.native().code;
        let count = code.statement_count() as u32;
        let first = targets[0].0;
        // A way out of the block leads to its last statement.
        if first + 1 >= count {
            return None;
        }
        let end = match *code.statement(first as usize + 1) {
            [Inst::Jump { to: Target(end) }] => end,
            _ => first + 1,
        };
        let is_between = |to: u32| to > self.statement && to < end && end < count;
        let assigned = |Target(to): Target| match *code.statement(to as usize) {
            [Inst::Constant { dst, value }, Inst::Store { place, width, src }] if is_between(to) && src == dst => {
                Some((place, width, value))
            }
            _ => None,
        };
        let (place, width, _) = assigned(targets[0]).filter(|&(_, width, _)| width != Width::QuadWord)?;
        let constant = |target: Target| {
            let (to, wide, value) = assigned(target)?;
            (to == place && wide == width).then_some(value & ((1 << width.bits()) - 1))
        };
        // All that lies between are these statements and jumps to the end.
        let is_jump = |between: u32| matches!(*code.statement(between as usize), [Inst::Jump { to: Target(to) }] if to == end);
        let ends = |between: u32| between + 1 == end || is_jump(between + 1);
        let assigns = |between: u32| constant(Target(between)).is_some() && ends(between);
        let is_whole = (self.statement + 1..end).all(|between| !self.is_entered(between) && (is_jump(between) || assigns(between)));
        if !is_whole || self.constant_address(place, width).is_none() || self.is_protected(place) {
            return None;
        }
        let of_cases = targets.iter().map(|&target| constant(target)).collect::<Option<Vec<u64>>>()?;
        let otherwise = if otherwise == Target(end) { None } else { Some(constant(otherwise)?) };
        let store = code.statements[first as usize] + 1;
        Some(Constants { place, width, store, of_cases, otherwise, end })
    }
}
