//! Comparison of STRINGs and search for characters in them, eight or sixteen characters at a time.

use std::ops::Range;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I8X16, I16, I32, I64};
use cranelift_codegen::ir::{BlockArg, InstBuilder, Value};
use sieben_engine::ir::TextAction;

use super::Translator;
use super::memory::{Address, data};
use super::string_bytes::{CHARACTERS_MAX, PAIRS};
use super::strings::InBoundsString;
use super::symbols::Symbol;
use crate::runtime_calls::RuntimeCall;

/// Characters in one word.
pub(super) const WORD: u32 = 8;
/// Characters of a literal in which one is looked for in registers.
const ALPHABET_MAX: u32 = 64;

/// Some characters as a word, the first one in the lowest byte; the others are 0.
fn word_of(characters: &[u8]) -> u64 {
    characters.iter().take(WORD as usize).rev().fold(0, |word, &character| word << 8 | u64::from(character))
}

impl Translator<'_> {
    /// Characters of a text, up to eight, the first one in the lowest byte. What is behind its length is anything that is there; what is
    /// behind those that are asked for is 0.
    pub(super) fn characters_at(&mut self, text: &InBoundsString, which: Range<u32>) -> Value {
        let Address { base, offset, .. } = text.address;
        let offset = offset + (text.room.head() + which.start) as i32;
        let room = which.end.saturating_sub(which.start);
        if let Some(word) = self.known_characters(text).and_then(|known| known.word).filter(|_| which.start == 0) {
            return if room < WORD { self.b.ins().band_imm_u(word, (1 << (8 * room)) - 1) } else { word };
        }
        // Two loads that overlap reach no further than the text.
        let half = match room {
            0 => return self.b.ins().iconst(I64, 0),
            1 => return self.b.ins().uload8(I64, data(), base, offset),
            2..4 => I16,
            4..WORD => I32,
            _ => return self.b.ins().load(I64, data(), base, offset),
        };
        let behind = room - half.bytes();
        let [first, last] = [0, behind].map(|skipped| match half {
            I16 => self.b.ins().uload16(I64, data(), base, offset + skipped as i32),
            _ => self.b.ins().uload32(data(), base, offset + skipped as i32),
        });
        let last = self.b.ins().ishl_imm_u(last, i64::from(8 * behind));
        self.b.ins().bor(first, last)
    }

    /// The same, as far as they are known.
    fn known_or_at(&mut self, (text, known): (&InBoundsString, Option<&[u8]>), first: u32) -> Value {
        match known {
            Some(characters) => {
                let word = word_of(characters.get(first as usize..).unwrap_or_default());
                self.b.ins().iconst(I64, word as i64)
            }
            None => self.characters_at(text, first..text.characters_there()),
        }
    }

    /// Two texts of at most one character each, as numbers that have the order and the equality of the texts.
    fn as_numbers(&mut self, a: &InBoundsString, b: &InBoundsString) -> Option<[Value; 2]> {
        let only = [self.only_character(a)?, self.only_character(b)?];
        let lengths = [a, b].map(|text| self.text_length(text));
        let zero = self.constant(0);
        Some([0, 1].map(|which| {
            let some = self.b.ins().iadd_imm_u(only[which], 1);
            self.b.ins().select(lengths[which], some, zero)
        }))
    }

    /// 0 if two texts have the same characters, else another number.
    pub(super) fn differ(&mut self, a: &InBoundsString, b: &InBoundsString) -> Value {
        let is_empty = |text: &InBoundsString| self.constant_characters(text).is_some_and(|characters| characters.is_empty());
        if !is_empty(a)
            && !is_empty(b)
            && let Some([a, b]) = self.as_numbers(a, b)
        {
            return self.b.ins().bxor(a, b);
        }
        match (self.constant_characters(a), self.constant_characters(b)) {
            (Some(characters), _) => return self.differ_from(b, &characters),
            (_, Some(characters)) => return self.differ_from(a, &characters),
            _ => {}
        }
        let [length, other] = [a, b].map(|text| self.text_length(text));
        let most = u32::from(a.room.characters_max.min(b.room.characters_max));
        let done = self.b.create_block();
        let result = self.b.append_block_param(done, I32);
        let [same, differ] = [self.b.create_block(), self.b.create_block()];
        let as_long = self.b.ins().icmp(IntCC::Equal, length, other);
        self.b.ins().brif(as_long, same, &[], differ, &[]);
        self.go_on_in(differ);
        let one = self.b.ins().iconst(I32, 1);
        self.b.ins().jump(done, &[BlockArg::Value(one)]);
        self.go_on_in(same);
        let bytes = self.b.ins().uextend(I64, length);
        let [a, b] = [a, b].map(|text| Address { offset: text.address.offset + text.room.head() as i32, ..text.address });
        if most > CHARACTERS_MAX {
            let [compared, short] = [self.b.create_block(), self.b.create_block()];
            let is_long = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThan, length, i64::from(CHARACTERS_MAX));
            self.b.ins().brif(is_long, compared, &[], short, &[]);
            self.go_on_in(compared);
            // Most texts differ at their beginning.
            let [beginning, other] = [a, b].map(|address| self.b.ins().load(I8X16, data(), address.base, address.offset));
            let bits = self.b.ins().bxor(beginning, other);
            let differ = self.b.ins().vany_true(bits);
            let (differ, same) = (self.b.ins().uextend(I32, differ), self.b.create_block());
            self.b.ins().brif(differ, done, &[BlockArg::Value(differ)], same, &[]);
            self.go_on_in(same);
            let [first, second] = [a, b].map(|address| self.arena_byte(address));
            let function = self.functions.get(self.module, Symbol::Question(RuntimeCall::BytesDiffer));
            let answer = self.call(function, &[self.run, first, second, bytes]);
            let answer = self.b.ins().ireduce(I32, answer);
            self.b.ins().jump(done, &[BlockArg::Value(answer)]);
            self.go_on_in(short);
        }
        for ty in PAIRS {
            if most < ty.bytes() {
                continue;
            }
            let [compared, shorter] = [self.b.create_block(), self.b.create_block()];
            let is_it = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThanOrEqual, length, i64::from(ty.bytes()));
            self.b.ins().brif(is_it, compared, &[], shorter, &[]);
            self.go_on_in(compared);
            let size = ty.bytes() as i32;
            let ends = [a, b].map(|address| self.b.ins().iadd(address.base, bytes));
            let firsts = [a, b].map(|address| self.b.ins().load(ty, data(), address.base, address.offset));
            let lasts = [(a, ends[0]), (b, ends[1])].map(|(address, end)| self.b.ins().load(ty, data(), end, address.offset - size));
            let first = self.b.ins().bxor(firsts[0], firsts[1]);
            let last = self.b.ins().bxor(lasts[0], lasts[1]);
            let bits = self.b.ins().bor(first, last);
            let other = if ty.is_vector() { self.b.ins().vany_true(bits) } else { self.b.ins().icmp_imm_u(IntCC::NotEqual, bits, 0) };
            let other = self.b.ins().uextend(I32, other);
            self.b.ins().jump(done, &[BlockArg::Value(other)]);
            self.go_on_in(shorter);
        }
        let one = self.b.create_block();
        self.b.ins().brif(length, one, &[], done, &[BlockArg::Value(length)]);
        self.go_on_in(one);
        let bytes = [a, b].map(|address| self.b.ins().uload8(I32, data(), address.base, address.offset));
        let bits = self.b.ins().bxor(bytes[0], bytes[1]);
        self.b.ins().jump(done, &[BlockArg::Value(bits)]);
        self.go_on_in(done);
        result
    }

    /// The same where the characters of one of them are known: all that the other one has in their place is looked at.
    fn differ_from(&mut self, text: &InBoundsString, characters: &[u8]) -> Value {
        let count = characters.len() as u32;
        if count > text.characters_there() {
            return self.constant(1);
        }
        let length = self.text_length(text);
        if count == 0 {
            return length;
        }
        // The length is known early; the characters of a text that was just written with another one are waited for.
        let [as_long, done] = [(); 2].map(|()| self.b.create_block());
        let result = self.b.append_block_param(done, I32);
        let one = self.constant(1);
        let is_as_long = self.b.ins().icmp_imm_u(IntCC::Equal, length, i64::from(count));
        self.b.ins().brif(is_as_long, as_long, &[], done, &[BlockArg::Value(one)]);
        self.go_on_in(as_long);
        let mut bits = self.b.ins().iconst(I64, 0);
        for first in (0..count).step_by(WORD as usize) {
            // The last ones are looked at with some of those before.
            let first = if count > WORD { first.min(count - WORD) } else { first };
            let word = self.characters_at(text, first..count);
            let known = self.b.ins().iconst(I64, word_of(&characters[first as usize..]) as i64);
            let others = self.b.ins().bxor(word, known);
            bits = self.b.ins().bor(bits, others);
        }
        let differ = self.b.ins().icmp_imm_u(IntCC::NotEqual, bits, 0);
        let differ = self.b.ins().uextend(I32, differ);
        self.b.ins().jump(done, &[BlockArg::Value(differ)]);
        self.go_on_in(done);
        result
    }

    /// −1, 0 or 1, or another number with that sign if only the sign counts: the first word in which two texts differ as far as both go,
    /// the first character highest, or their lengths.
    pub(super) fn order(&mut self, (a, b): (&InBoundsString, &InBoundsString), by_sign: bool) -> Value {
        if let Some([a, b]) = self.as_numbers(a, b) {
            return if by_sign { self.b.ins().isub(a, b) } else { self.order_of([a, b]) };
        }
        let lengths = [a, b].map(|text| self.text_length(text));
        let known = [a, b].map(|text| self.constant_characters(text));
        let both = self.b.ins().umin(lengths[0], lengths[1]);
        let most = u32::from(a.room.characters_max.min(b.room.characters_max));
        let [by_length, by_word, done] = [(); 3].map(|()| self.b.create_block());
        let words = [(); 2].map(|()| self.b.append_block_param(by_word, I64));
        let result = self.b.append_block_param(done, I32);
        for first in (0..most.min(CHARACTERS_MAX)).step_by(WORD as usize) {
            let some = self.b.create_block();
            let more = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThan, both, i64::from(first));
            self.b.ins().brif(more, some, &[], by_length, &[]);
            self.go_on_in(some);
            // What is behind the shorter one is shifted out.
            let end = self.constant(first + WORD);
            let missing = self.b.ins().isub(end, both);
            let zero = self.constant(0);
            let missing = self.b.ins().smax(missing, zero);
            let missing = self.b.ins().ishl_imm_u(missing, 3);
            let mut word = |text: &InBoundsString, known: &Option<Vec<u8>>| {
                let word = self.known_or_at((text, known.as_deref()), first);
                let word = self.b.ins().bswap(word);
                self.b.ins().ushr(word, missing)
            };
            let arguments = [word(a, &known[0]), word(b, &known[1])];
            let next = self.b.create_block();
            let same = self.b.ins().icmp(IntCC::Equal, arguments[0], arguments[1]);
            self.b.ins().brif(same, next, &[], by_word, &arguments.map(BlockArg::Value));
            self.go_on_in(next);
        }
        // Most texts differ before.
        if most > CHARACTERS_MAX {
            let long = self.b.create_block();
            let is_long = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThan, both, i64::from(CHARACTERS_MAX));
            self.b.ins().brif(is_long, long, &[], by_length, &[]);
            self.go_on_in(long);
            let nothing = self.b.ins().iconst(I64, 0);
            let order = self.call_for_texts(TextAction::Compare, a, b, nothing);
            self.b.ins().jump(done, &[BlockArg::Value(order)]);
        } else {
            self.b.ins().jump(by_length, &[]);
        }
        self.go_on_in(by_word);
        let order = self.order_of(words);
        self.b.ins().jump(done, &[BlockArg::Value(order)]);
        self.go_on_in(by_length);
        let order = if by_sign { self.b.ins().isub(lengths[0], lengths[1]) } else { self.order_of(lengths) };
        self.b.ins().jump(done, &[BlockArg::Value(order)]);
        self.go_on_in(done);
        result
    }

    /// −1, 0 or 1.
    fn order_of(&mut self, [a, b]: [Value; 2]) -> Value {
        let greater = self.b.ins().icmp(IntCC::UnsignedGreaterThan, a, b);
        let less = self.b.ins().icmp(IntCC::UnsignedLessThan, a, b);
        let [greater, less] = [greater, less].map(|it| self.b.ins().uextend(I32, it));
        self.b.ins().isub(greater, less)
    }

    /// Where characters stand in others that are known: one of them is looked for without a look at memory, which would wait for the literal.
    fn find_in_constant(&mut self, characters: &[u8], to: &InBoundsString, from: &InBoundsString) -> Value {
        let count = self.text_length(from);
        if let Some(wanted) = self.only_character(from) {
            let (place, zero) = (self.find_one_in_constant(characters, wanted), self.constant(0));
            return self.b.ins().select(count, place, zero);
        }
        let [one, others, done] = [(); 3].map(|()| self.b.create_block());
        let result = self.b.append_block_param(done, I32);
        let is_one = self.b.ins().icmp_imm_u(IntCC::Equal, count, 1);
        self.b.ins().brif(is_one, one, &[], others, &[]);
        self.go_on_in(others);
        let place = match self.find_in_memory(to, from) {
            Some(place) => place,
            None => {
                let nothing = self.b.ins().iconst(I64, 0);
                self.call_for_texts(TextAction::Find, to, from, nothing)
            }
        };
        self.b.ins().jump(done, &[BlockArg::Value(place)]);
        self.go_on_in(one);
        let Address { base, offset, .. } = from.address;
        let wanted = self.b.ins().uload8(I32, data(), base, offset + from.room.head() as i32);
        let place = self.find_one_in_constant(characters, wanted);
        self.b.ins().jump(done, &[BlockArg::Value(place)]);
        self.go_on_in(done);
        result
    }

    /// Where one character stands in others that are known, 0 = nowhere.
    fn find_one_in_constant(&mut self, characters: &[u8], wanted: Value) -> Value {
        let wanted = self.b.ins().ireduce(I8, wanted);
        let wanted = self.b.ins().splat(I8X16, wanted);
        let mut bits = self.b.ins().iconst(I64, 0);
        for (index, piece) in characters.chunks(I8X16.bytes() as usize).enumerate() {
            let mut all = piece.to_vec();
            all.resize(I8X16.bytes() as usize, 0);
            let all = self.b.func.dfg.constants.insert(all.into());
            let all = self.b.ins().vconst(I8X16, all);
            let same = self.b.ins().icmp(IntCC::Equal, all, wanted);
            let found = self.b.ins().vhigh_bits(I32, same);
            // What stands behind the last one counts as none.
            let found = self.b.ins().band_imm_u(found, (1 << piece.len()) - 1);
            let found = self.b.ins().uextend(I64, found);
            let found = self.b.ins().ishl_imm_u(found, index as i64 * i64::from(I8X16.bytes()));
            bits = self.b.ins().bor(bits, found);
        }
        let place = self.b.ins().ctz(bits);
        let place = self.b.ins().ireduce(I32, place);
        let place = self.b.ins().iadd_imm_u(place, 1);
        let zero = self.constant(0);
        self.b.ins().select(bits, place, zero)
    }

    /// Where characters stand in a text; `None` = Rust code has to look.
    pub(super) fn find_characters(&mut self, to: &InBoundsString, from: &InBoundsString) -> Option<Value> {
        if let Some(characters) = self.constant_characters_of(to, ALPHABET_MAX)
            && !characters.is_empty()
        {
            return Some(self.find_in_constant(&characters, to, from));
        }
        self.find_in_memory(to, from)
    }

    /// Where up to eight characters stand in a text; more are looked for by Rust code.
    fn find_in_memory(&mut self, to: &InBoundsString, from: &InBoundsString) -> Option<Value> {
        let room = u32::from(to.room.characters_max);
        let known = self.constant_characters(from);
        if room < I8X16.bytes() || known.as_ref().is_some_and(|known| known.len() > WORD as usize) {
            return None;
        }
        let only = if known.is_none() { self.only_character(from) } else { None };
        let [length, count] = [to, from].map(|text| self.text_length(text));
        let [few, look, found, next, done] = [(); 5].map(|()| self.b.create_block());
        let at = self.b.append_block_param(look, I32);
        let candidates = self.b.append_block_param(found, I32);
        let result = self.b.append_block_param(done, I32);
        let zero = self.constant(0);
        if known.is_some() || only.is_some() {
            self.b.ins().brif(count, few, &[], done, &[BlockArg::Value(zero)]);
        } else {
            let many = self.b.create_block();
            let above = self.b.ins().iadd_imm_s(count, -1);
            let is_few = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, above, i64::from(WORD));
            self.b.ins().brif(is_few, few, &[], many, &[]);
            self.go_on_in(many);
            let nothing = self.b.ins().iconst(I64, 0);
            let place = self.call_for_texts(TextAction::Find, to, from, nothing);
            self.b.ins().jump(done, &[BlockArg::Value(place)]);
        }
        self.go_on_in(few);
        let is_one = only.is_some() || known.as_ref().is_some_and(|known| known.len() == 1);
        let mask = self.b.ins().iconst(I64, -1);
        let bits = self.b.ins().ishl_imm_u(count, 3);
        let bits = self.b.ins().ineg(bits);
        let mask = self.b.ins().ushr(mask, bits);
        let wanted = match only {
            Some(only) => only,
            None => {
                let wanted = self.known_or_at((from, known.as_deref()), 0);
                self.b.ins().band(wanted, mask)
            }
        };
        let first = self.b.ins().ireduce(I8, wanted);
        let first = self.b.ins().splat(I8X16, first);
        let offset = to.address.offset + to.room.head() as i32;
        let zero = self.constant(0);
        self.b.ins().jump(look, &[BlockArg::Value(zero)]);
        self.b.switch_to_block(look);
        // The last ones that there is room for: those before are looked at twice, and what is looked for does not begin there.
        let last = self.constant(room - I8X16.bytes());
        let begin = self.fewer(at, last);
        let skipped = self.b.ins().uextend(I64, begin);
        let base = self.b.ins().iadd(to.address.base, skipped);
        let characters = self.b.ins().load(I8X16, data(), base, offset);
        let same = self.b.ins().icmp(IntCC::Equal, characters, first);
        let bits = self.b.ins().vhigh_bits(I32, same);
        self.b.ins().brif(bits, found, &[BlockArg::Value(bits)], next, &[]);
        self.b.switch_to_block(found);
        let place = self.b.ins().ctz(candidates);
        let place = self.b.ins().iadd(place, begin);
        let end = self.b.ins().iadd(place, count);
        let counts = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, end, length);
        let answer = self.b.ins().iadd_imm_u(place, 1);
        if is_one {
            let answer = self.b.ins().select(counts, answer, zero);
            self.b.ins().jump(done, &[BlockArg::Value(answer)]);
        } else {
            let [there, other] = [(); 2].map(|()| self.b.create_block());
            self.b.ins().brif(counts, there, &[], done, &[BlockArg::Value(zero)]);
            self.go_on_in(there);
            // A word that reaches no further than the text.
            let last = self.constant(room - WORD);
            let from = self.fewer(place, last);
            let before = self.b.ins().isub(place, from);
            let before = self.b.ins().ishl_imm_u(before, 3);
            let from = self.b.ins().uextend(I64, from);
            let base = self.b.ins().iadd(to.address.base, from);
            let word = self.b.ins().load(I64, data(), base, offset);
            let word = self.b.ins().ushr(word, before);
            let word = self.b.ins().band(word, mask);
            let same = self.b.ins().icmp(IntCC::Equal, word, wanted);
            self.b.ins().brif(same, done, &[BlockArg::Value(answer)], other, &[]);
            self.go_on_in(other);
            let without = self.b.ins().iadd_imm_s(candidates, -1);
            let left = self.b.ins().band(candidates, without);
            self.b.ins().brif(left, found, &[BlockArg::Value(left)], next, &[]);
        }
        self.b.seal_block(found);
        self.go_on_in(next);
        let at = self.b.ins().iadd_imm_u(at, i64::from(I8X16.bytes()));
        let more = self.b.ins().icmp(IntCC::UnsignedLessThan, at, length);
        let zero = self.constant(0);
        self.b.ins().brif(more, look, &[BlockArg::Value(at)], done, &[BlockArg::Value(zero)]);
        self.b.seal_block(look);
        self.go_on_in(done);
        Some(result)
    }
}
