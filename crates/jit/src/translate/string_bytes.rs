//! Inlined string operations: lengths are values, short strings are copied and compared without a call.
//!
//! What is copied is read before anything is written, as if through a temporary, and only the characters within the length are touched:
//! after them a string keeps its bytes. Longer ones are left to runtime functions, which take little time for each byte.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I8X16, I16, I32, I64};
use cranelift_codegen::ir::{Block, BlockArg, InstBuilder, Type, Value};
use sieben_engine::ir::verify::{reads, writes};
use sieben_engine::ir::{Inst, Op, TextAction, Var};

use super::Translator;
use super::load_elimination::Characters;
use super::memory::{Address, Bit, data};
use super::scalar_promotion::Base;
use super::string_comparison::WORD;
use super::strings::InBoundsString;
use super::symbols::Symbol;
use super::value::Val;
use crate::runtime_calls::RuntimeCall;

/// Characters that are worked on without a call.
pub(super) const CHARACTERS_MAX: u32 = 32;
/// The same where they are only copied.
const COPIED_MAX: u32 = 64;
/// Characters that one store writes.
const BLOCK: u32 = 16;
/// Values that two overlapping loads cover: twice as many bytes at most. The largest first.
pub(super) const PAIRS: [Type; 4] = [I8X16, I64, I32, I16];

/// Operations that ask whether a number is 0, and those that ask for its sign.
const EQUALITY: &[Op] = &[Op::Equal, Op::Differ];
const SIGN: &[Op] = &[Op::Equal, Op::Differ, Op::LtI32, Op::LeI32, Op::GtI32, Op::GeI32];

/// What an instruction that is written out leaves.
pub(super) struct InlinedString {
    pub(super) result: Value,
    /// What is known of those of its target, if it wrote a text there.
    pub(super) characters: Option<Characters>,
}

impl InlinedString {
    /// A result of an instruction that writes no text.
    fn nothing(result: Value) -> Self {
        Self { result, characters: None }
    }
}

impl Translator<'_> {
    /// How many characters of a text count.
    pub(super) fn text_length(&mut self, text: &InBoundsString) -> Value {
        if let Some(&[_, length]) = self.constant_head(text).as_deref() {
            return self.constant(u32::from(length).min(text.room.characters_max.into()));
        }
        if let Some(Characters { length, .. }) = self.known_characters(text) {
            return length;
        }
        let length = self.length_in_memory(text);
        self.remember_characters(text, Characters::some(length));
        length
    }

    /// The same as memory has it.
    pub(super) fn length_in_memory(&mut self, text: &InBoundsString) -> Value {
        let Address { base, offset, .. } = text.address;
        let length = match text.room.wide {
            false => self.b.ins().uload8(I32, data(), base, offset + 1),
            true => {
                let word = self.b.ins().load(I16, data(), base, offset + 2);
                let word = self.b.ins().bswap(word);
                self.b.ins().uextend(I32, word)
            }
        };
        let most = self.room(text);
        self.fewer(length, most)
    }

    /// The only character of a text that never has more than one, if it is known; anything if it has none.
    pub(super) fn only_character(&mut self, text: &InBoundsString) -> Option<Value> {
        match self.constant_characters_of(text, 1) {
            Some(characters) => Some(self.constant(characters.first().copied().unwrap_or(0).into())),
            None if let Some(only) = self.known_characters(text).and_then(|known| known.only) => Some(only),
            None if text.most.is_none() && text.characters_there() == 1 && !text.room.wide => {
                let Address { base, offset, .. } = text.address;
                Some(self.b.ins().uload8(I32, data(), base, offset + text.room.head() as i32))
            }
            None => None,
        }
    }

    /// Both lengths of a STRING, if they are known, as those of a literal are.
    fn constant_head(&self, text: &InBoundsString) -> Option<Vec<u8>> {
        let Address { base, offset, .. } = text.address;
        let is_known = base == self.local && !text.room.wide && text.most.is_none();
        is_known.then(|| self.constant_bytes(offset, 2)).flatten()
    }

    /// The characters that count, if all of them are known, as those of a literal are, and they are few.
    pub(super) fn constant_characters(&self, text: &InBoundsString) -> Option<Vec<u8>> {
        self.constant_characters_of(text, CHARACTERS_MAX)
    }

    /// The same of texts with at most so many.
    pub(super) fn constant_characters_of(&self, text: &InBoundsString, most: u32) -> Option<Vec<u8>> {
        let length = u32::from(*self.constant_head(text)?.last()?).min(text.room.characters_max.into());
        (length <= most).then(|| self.constant_bytes(text.address.offset + 2, length)).flatten()
    }

    /// How many characters there is room for.
    fn room(&mut self, text: &InBoundsString) -> Value {
        text.most.unwrap_or_else(|| self.constant(text.room.characters_max.into()))
    }

    /// The smaller one of two counts.
    pub(super) fn fewer(&mut self, a: Value, b: Value) -> Value {
        let more = self.b.ins().icmp(IntCC::UnsignedGreaterThan, a, b);
        self.b.ins().select(more, b, a)
    }

    /// A number that counts as 0 if it is negative.
    fn not_negative(&mut self, value: Value) -> Value {
        if self.bounds.get(&value).is_some_and(|&(_, most)| most <= i32::MAX as u32) {
            return value;
        }
        let zero = self.constant(0);
        self.b.ins().smax(value, zero)
    }

    /// The result of an instruction on STRINGs, if it is one that is written out here.
    pub(super) fn text_written_out(
        &mut self,
        (action, to, from, piece): (TextAction, &InBoundsString, &InBoundsString, [Var; 2]),
        (index, dst, word): (u32, Var, Value),
    ) -> Option<InlinedString> {
        // Code that has to be there at once is for the time until better code is there.
        let quick = !self.options.optimize && !self.options.exact;
        if quick || self.cold.is_some() || to.room.wide || from.room.wide {
            return None;
        }
        match action {
            TextAction::Assign if from.empty => {
                let (room, none) = (self.room(to), self.constant(0));
                self.store_lengths(to, room, none);
                Some(InlinedString { result: none, characters: Some(Characters { only: Some(none), ..Characters::some(none) }) })
            }
            TextAction::Assign | TextAction::Piece | TextAction::Append => Some(self.put((index, action), to, from, piece)),
            TextAction::Unsigned | TextAction::Signed | TextAction::SignedAlways => {
                let result = self.put_digits(action, to, word)?;
                let room = self.room(to);
                let length = self.fewer(result, room);
                Some(InlinedString { result, characters: Some(Characters::some(length)) })
            }
            TextAction::Find => self.find_characters(to, from).map(InlinedString::nothing),
            TextAction::Compare if self.is_compared(index, dst, EQUALITY) => Some(InlinedString::nothing(self.differ(to, from))),
            TextAction::Compare => {
                let by_sign = self.is_compared(index, dst, SIGN);
                Some(InlinedString::nothing(self.order((to, from), by_sign)))
            }
            TextAction::Number => {
                let form = self.get(piece[0]);
                let form = self.force(form).constant()?;
                self.number_of_text(to, from, form).map(InlinedString::nothing)
            }
            _ => None,
        }
    }

    /// Writes characters of a text to another one.
    fn put(&mut self, (index, action): (u32, TextAction), to: &InBoundsString, from: &InBoundsString, piece: [Var; 2]) -> InlinedString {
        let [most, most_read] = [to.room, from.room].map(|room| u32::from(room.characters_max));
        let length = self.text_length(from);
        let behind = (action == TextAction::Append).then(|| self.text_length(to));
        let mut known = Some((0, usize::MAX));
        let mut count_most = u32::MAX;
        let (first, count) = match action {
            TextAction::Assign => (None, length),
            _ => {
                let [first, count] = piece.map(|var| {
                    let value = self.get(var);
                    self.force(value)
                });
                // A negative number is 0.
                let number = |value: Val| value.constant().map(|number| usize::try_from(number as u32 as i32).unwrap_or(0));
                known = number(first).zip(number(count));
                count_most = self.most_of(index, piece[1]);
                self.piece_within((first, count), (length, most_read), count_most)
            }
        };
        let room = self.room(to);
        let fits = most_read <= most && to.most.is_none();
        let put = match behind {
            Some(behind) => {
                let room = self.b.ins().isub(room, behind);
                self.fewer(count, room)
            }
            None if fits || count_most <= most && to.most.is_none() => count,
            None => self.fewer(count, room),
        };
        let [source, target] = [(from, first), (to, behind)].map(|(text, skipped)| {
            let Address { base, offset, .. } = text.address;
            let base = match skipped {
                Some(skipped) => {
                    let skipped = self.b.ins().uextend(I64, skipped);
                    self.b.ins().iadd(base, skipped)
                }
                None => base,
            };
            Address { base, offset: offset + text.room.head() as i32, bit: Bit::Number(0) }
        });
        let characters = self.constant_characters(from).zip(known).map(|(characters, (first, count))| {
            let first = first.min(characters.len());
            let behind = first + count.min(characters.len() - first);
            characters[first..behind].to_vec()
        });
        let only = self.only_character(from);
        let most_put = if only.is_some() { 1 } else { most.min(most_read).min(count_most) };
        let copied = (put, most_put);
        let mut written = None;
        let mut word = None;
        let [a, b] = [from, to].map(|text| (text.address.base, text.address.offset, text.room.characters_max));
        match characters {
            // The first piece of a text that becomes the text.
            _ if a == b && first.is_none() && behind.is_none() => {}
            // Nothing is cut where the room is known.
            Some(characters) if behind.is_none() && to.most.is_none() && characters.len() as u32 <= most => {
                if let [] | [_] = characters[..] {
                    written = Some(self.constant(characters.first().copied().unwrap_or(0).into()));
                }
                self.store_characters(target, &characters)
            }
            _ if most_put == 1 => written = Some(self.put_one((source, only), target, put)),
            Some(characters) => {
                let [whole, cut, done] = [(); 3].map(|()| self.b.create_block());
                self.b.set_cold_block(cut);
                let fits = self.b.ins().icmp_imm_u(IntCC::Equal, put, characters.len() as i64);
                self.b.ins().brif(fits, whole, &[], cut, &[]);
                self.go_on_in(cut);
                self.copy_characters(source, target, copied);
                self.b.ins().jump(done, &[]);
                self.go_on_in(whole);
                self.store_characters(target, &characters);
                self.b.ins().jump(done, &[]);
                self.go_on_in(done);
            }
            None if behind.is_none() && to.most.is_none() && most_put <= WORD && most >= WORD && self.reads_behind(from) => {
                word = Some(self.put_eight((from, first, source), target, put));
            }
            None if behind.is_none() && first.is_none() && to.most.is_none() && most >= BLOCK && from.characters_there() >= BLOCK => {
                self.copy_block(source, target, copied);
            }
            None => self.copy_characters(source, target, copied),
        }
        let end = behind.map_or(put, |behind| self.b.ins().iadd(behind, put));
        self.store_lengths(to, room, end);
        let result = match action {
            TextAction::Assign if fits => self.constant(0),
            TextAction::Assign => {
                let cut = self.b.ins().icmp(IntCC::UnsignedLessThan, put, length);
                self.b.ins().uextend(I32, cut)
            }
            _ => count,
        };
        let only = written.filter(|_| behind.is_none());
        InlinedString { result, characters: Some(Characters { length: end, only, word }) }
    }

    /// Where a piece begins that two numbers name, `None` = with the text, and how many characters it has of a text with so many; no piece
    /// has more characters than the last number.
    fn piece_within(&mut self, (first, count): (Val, Val), (length, most_read): (Value, u32), count_most: u32) -> (Option<Value>, Value) {
        let first = match first {
            Val::Const(first) if first as u32 as i32 <= 0 => None,
            first => Some(self.int(first)),
        };
        if count_most == 1 {
            // It is there if the text reaches so far.
            let first = first.map(|first| self.not_negative(first));
            let there = match first {
                Some(first) => self.b.ins().icmp(IntCC::UnsignedLessThan, first, length),
                None => self.b.ins().icmp_imm_u(IntCC::NotEqual, length, 0),
            };
            let there = self.b.ins().uextend(I32, there);
            return match count {
                Val::Const(count) if count as u32 as i32 > 0 => (first, there),
                // It is 1, or 0 where a gate lets nothing through.
                count => {
                    let count = self.int(count);
                    (first, self.b.ins().band(count, there))
                }
            };
        }
        let first = first.map(|first| {
            let first = self.not_negative(first);
            self.fewer(first, length)
        });
        let left = first.map_or(length, |first| self.b.ins().isub(length, first));
        match count {
            Val::Const(count) if count as u32 as i32 >= most_read as i32 => (first, left),
            count => {
                let count = self.int(count);
                let count = self.not_negative(count);
                (first, self.fewer(count, left))
            }
        }
    }

    /// Writes one character or none; the one.
    fn put_one(&mut self, (from, only): (Address, Option<Value>), to: Address, count: Value) -> Value {
        let [one, done] = [(); 2].map(|()| self.b.create_block());
        let result = self.b.append_block_param(done, I32);
        let nothing = self.constant(0);
        self.b.ins().brif(count, one, &[], done, &[BlockArg::Value(only.unwrap_or(nothing))]);
        self.go_on_in(one);
        let byte = only.unwrap_or_else(|| self.b.ins().uload8(I32, data(), from.base, from.offset));
        self.b.ins().istore8(data(), byte, to.base, to.offset);
        self.b.ins().jump(done, &[BlockArg::Value(byte)]);
        self.go_on_in(done);
        only.unwrap_or(result)
    }

    /// Whether there is a word behind a text that may be read: the areas of the program are not the last bytes of memory.
    fn reads_behind(&self, text: &InBoundsString) -> bool {
        let end = match &text.touched {
            Some((Base::Arena, bytes)) => bytes.end,
            Some((Base::Local, _)) => self.layout.local.end as i64,
            _ => return false,
        };
        end + i64::from(WORD) <= self.layout.size as i64
    }

    /// Writes up to eight characters with one store, with what stands behind them; all of them in one word.
    fn put_eight(&mut self, (text, first, from): (&InBoundsString, Option<Value>, Address), to: Address, count: Value) -> Value {
        let word = match (self.known_characters(text).and_then(|known| known.word), first) {
            (Some(word), None) => word,
            (Some(word), Some(first)) => {
                // What is behind the last one is not counted.
                let skipped = self.b.ins().ishl_imm_u(first, 3);
                self.b.ins().ushr(word, skipped)
            }
            // Behind a text there are more bytes.
            (None, _) => self.b.ins().load(I64, data(), from.base, from.offset),
        };
        // Eight times as many bits, half of them at once: no number of bits is too large for a shift.
        let bits = self.b.ins().ishl_imm_u(count, 2);
        let all = self.b.ins().iconst(I64, -1);
        let behind = self.b.ins().ishl(all, bits);
        let behind = self.b.ins().ishl(behind, bits);
        let characters = self.b.ins().band_not(word, behind);
        let there = self.b.ins().load(I64, data(), to.base, to.offset);
        let there = self.b.ins().band(there, behind);
        let both = self.b.ins().bor(characters, there);
        self.b.ins().store(data(), both, to.base, to.offset);
        characters
    }

    /// How large a number of characters can be, as far as the statement of an instruction tells.
    fn most_of(&self, index: u32, var: Var) -> u32 {
        let code = &self.native().code;
        let first = code.statements[code.statements.partition_point(|&first| first <= index).saturating_sub(1)];
        let (mut wanted, mut bits) = (var, 32);
        for inst in code.insts[first as usize..index as usize].iter().rev() {
            match *inst {
                _ if writes(inst) != Some(wanted) => {}
                // A negative number is 0.
                Inst::Constant { value, .. } => {
                    let number = (value as u32 as i32) << (32 - bits) >> (32 - bits);
                    return u32::try_from(number).unwrap_or(0);
                }
                Inst::Compute { op: Op::Extend16, args, .. } => (wanted, bits) = (args[0], 16),
                // What a gate lets through, or 0.
                Inst::Compute { op: Op::Copy | Op::Gate, args, .. } => wanted = args[0],
                _ => break,
            }
        }
        u32::MAX
    }

    /// Writes both lengths of a text.
    pub(super) fn store_lengths(&mut self, text: &InBoundsString, most: Value, length: Value) {
        let Address { base, offset, .. } = text.address;
        self.b.ins().istore8(data(), most, base, offset);
        self.b.ins().istore8(data(), length, base, offset + 1);
    }

    /// Writes characters that are known.
    fn store_characters(&mut self, to: Address, characters: &[u8]) {
        let mut at = 0;
        for ty in PAIRS.into_iter().skip(1) {
            let size = ty.bytes() as usize;
            while at < characters.len() && characters.len() >= size {
                // The last ones are written with some of those before.
                let first = at.min(characters.len() - size);
                let number = self.constant_of_bytes(&characters[first..first + size], ty);
                self.b.ins().store(data(), number, to.base, to.offset + first as i32);
                at = first + size;
            }
        }
        if let Some(&byte) = characters.get(at) {
            let byte = self.constant(byte.into());
            self.b.ins().istore8(data(), byte, to.base, to.offset + at as i32);
        }
    }

    /// Copies so many bytes from the beginning of a text to that of another one, both of which have room for a block: few of them with one
    /// store, so that who reads them next does not wait for several. What stands behind them stays.
    fn copy_block(&mut self, from: Address, to: Address, (count, most): (Value, u32)) {
        let [few, many, done] = [(); 3].map(|()| self.b.create_block());
        let are_few = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, count, i64::from(BLOCK));
        self.b.ins().brif(are_few, few, &[], many, &[]);
        self.go_on_in(many);
        self.copy_characters(from, to, (count, most));
        self.b.ins().jump(done, &[]);
        self.go_on_in(few);
        let places = self.b.func.dfg.constants.insert((0..BLOCK as u8).collect::<Vec<u8>>().into());
        let places = self.b.ins().vconst(I8X16, places);
        let end = self.b.ins().ireduce(I8, count);
        let end = self.b.ins().splat(I8X16, end);
        let copied = self.b.ins().icmp(IntCC::SignedLessThan, places, end);
        let characters = self.b.ins().load(I8X16, data(), from.base, from.offset);
        let behind = self.b.ins().load(I8X16, data(), to.base, to.offset);
        let all = self.b.ins().bitselect(copied, characters, behind);
        self.b.ins().store(data(), all, to.base, to.offset);
        self.b.ins().jump(done, &[]);
        self.go_on_in(done);
    }

    /// Copies so many bytes, of which there are no more than the number behind.
    fn copy_characters(&mut self, from: Address, to: Address, (count, most): (Value, u32)) {
        let done = self.b.create_block();
        let bytes = self.b.ins().uextend(I64, count);
        if most > COPIED_MAX {
            let [copied, short] = [self.b.create_block(), self.b.create_block()];
            let is_long = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThan, count, i64::from(COPIED_MAX));
            self.b.ins().brif(is_long, copied, &[], short, &[]);
            self.go_on_in(copied);
            let [first, second] = [from, to].map(|address| self.arena_byte(address));
            let function = self.functions.get(self.module, Symbol::Question(RuntimeCall::CopyBytes));
            self.call(function, &[self.run, first, second, bytes]);
            self.b.ins().jump(done, &[]);
            self.go_on_in(short);
        }
        let sizes = [(I8X16, 2)].into_iter().chain(PAIRS.map(|ty| (ty, 1)));
        for (ty, pairs) in sizes {
            let (size, least) = (ty.bytes() as i32, ty.bytes() * pairs);
            if most < least {
                continue;
            }
            let [copied, shorter] = [self.b.create_block(), self.b.create_block()];
            let is_it = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThanOrEqual, count, i64::from(least));
            self.b.ins().brif(is_it, copied, &[], shorter, &[]);
            self.go_on_in(copied);
            let [from_end, to_end] = [from, to].map(|address| self.b.ins().iadd(address.base, bytes));
            let skipped = (0..pairs as i32).flat_map(|pair| [(false, pair * size), (true, -(pair + 1) * size)]);
            let skipped: Vec<(bool, i32)> = skipped.collect();
            let read = |at_end: bool| if at_end { from_end } else { from.base };
            let values: Vec<Value> =
                skipped.iter().map(|&(at_end, at)| self.b.ins().load(ty, data(), read(at_end), from.offset + at)).collect();
            for (&(at_end, at), value) in skipped.iter().zip(values) {
                let base = if at_end { to_end } else { to.base };
                self.b.ins().store(data(), value, base, to.offset + at);
            }
            self.b.ins().jump(done, &[]);
            self.go_on_in(shorter);
        }
        let one = self.b.create_block();
        self.b.ins().brif(count, one, &[], done, &[]);
        self.go_on_in(one);
        let byte = self.b.ins().uload8(I32, data(), from.base, from.offset);
        self.b.ins().istore8(data(), byte, to.base, to.offset);
        self.b.ins().jump(done, &[]);
        self.go_on_in(done);
    }

    /// Goes on in a block to which everything that leads there has been written.
    pub(super) fn go_on_in(&mut self, block: Block) {
        self.b.switch_to_block(block);
        self.b.seal_block(block);
    }

    /// Whether the order that an instruction finds is only compared with 0, by some of these operations.
    fn is_compared(&self, index: u32, dst: Var, by: &[Op]) -> bool {
        if dst.register().is_some() {
            return false;
        }
        let code = &self.native().code;
        let statement = code.statements.partition_point(|&first| first <= index).saturating_sub(1);
        let first = code.statements[statement];
        let mut zeros: Vec<Var> = Vec::new();
        for (at, inst) in (first..).zip(code.statement(statement)) {
            if at > index && reads(inst).any(|var| var == dst) {
                let Inst::Compute { op, args: [a, b, ..], .. } = *inst else { return false };
                let other = if a == dst { b } else { a };
                if !by.contains(&op) || other == dst || !zeros.contains(&other) {
                    return false;
                }
            }
            if let Some(written) = writes(inst) {
                if at > index && written == dst {
                    return true;
                }
                zeros.retain(|&zero| zero != written);
                if matches!(inst, Inst::Constant { value: 0, .. }) {
                    zeros.push(written);
                }
            }
        }
        true
    }
}
