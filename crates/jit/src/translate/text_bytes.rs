//! STRINGs in place: their lengths are values, short ones are copied and compared without a call.
//!
//! What is copied is read before anything is written, as if through a temporary, and only the characters that count are touched: behind
//! them a text keeps what it has. Longer ones are left to Rust code, which takes little time for each byte.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I8X16, I16, I32, I64};
use cranelift_codegen::ir::{Block, BlockArg, InstBuilder, Type, Value};
use sieben_engine::ir::verify::{reads, writes};
use sieben_engine::ir::{Inst, Op, TextAction, Var};

use super::Translator;
use super::memory::{Address, Bit, data};
use super::outside::Outside;
use super::texts::Whole;
use super::value::Val;
use crate::ask::Question;

/// Values that two overlapping loads cover: twice as many bytes at most. The largest first.
const PAIRS: [Type; 4] = [I8X16, I64, I32, I16];

impl Translator<'_> {
    /// How many characters of a text count.
    pub(super) fn text_length(&mut self, text: &Whole) -> Value {
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

    /// How many characters there is room for.
    fn room(&mut self, text: &Whole) -> Value {
        text.most.unwrap_or_else(|| self.constant(text.room.characters_max.into()))
    }

    /// The smaller one of two counts.
    fn fewer(&mut self, a: Value, b: Value) -> Value {
        let more = self.b.ins().icmp(IntCC::UnsignedGreaterThan, a, b);
        self.b.ins().select(more, b, a)
    }

    /// A number that counts as 0 if it is negative, and at most so many.
    fn within(&mut self, value: Value, most: Value) -> Value {
        let zero = self.constant(0);
        let some = self.b.ins().icmp(IntCC::SignedGreaterThan, value, zero);
        let value = self.b.ins().select(some, value, zero);
        self.fewer(value, most)
    }

    /// The result of an instruction on STRINGs, if it is one that is written out here.
    pub(super) fn text_written_out(
        &mut self,
        (action, to, from, piece): (TextAction, &Whole, &Whole, [Var; 2]),
        (index, dst, word): (u32, Var, Value),
    ) -> Option<Value> {
        // Code that has to be there at once is for the time until better code is there.
        let quick = !self.options.optimize && !self.options.exact;
        if quick || self.cold.is_some() || to.room.wide || from.room.wide {
            return None;
        }
        match action {
            TextAction::Assign if from.empty => {
                let (room, none) = (self.room(to), self.constant(0));
                self.store_lengths(to, room, none);
                Some(none)
            }
            TextAction::Assign | TextAction::Piece | TextAction::Append => Some(self.put(action, to, from, piece)),
            TextAction::Find if to.room.characters_max >= I8X16.bytes() as u16 => Some(self.find_one(to, from)),
            TextAction::Compare if self.only_equality_counts(index, dst) => Some(self.differ(to, from)),
            TextAction::Unsigned | TextAction::Signed | TextAction::SignedAlways => self.put_digits(action, to, word),
            TextAction::Number => {
                let form = self.get(piece[0]);
                let form = self.force(form).constant()?;
                self.whole_number(to, from, form)
            }
            _ => None,
        }
    }

    /// Writes characters of a text to another one.
    fn put(&mut self, action: TextAction, to: &Whole, from: &Whole, piece: [Var; 2]) -> Value {
        let [most, most_read] = [to.room, from.room].map(|room| u32::from(room.characters_max));
        let length = self.text_length(from);
        let behind = (action == TextAction::Append).then(|| self.text_length(to));
        let (first, count) = match action {
            TextAction::Assign => (None, length),
            _ => {
                let [first, count] = piece.map(|var| {
                    let value = self.get(var);
                    self.force(value)
                });
                let (first, left) = match first {
                    Val::Const(first) if first as u32 as i32 <= 0 => (None, length),
                    first => {
                        let first = self.int(first);
                        let first = self.within(first, length);
                        (Some(first), self.b.ins().isub(length, first))
                    }
                };
                let count = match count {
                    Val::Const(count) if count as u32 as i32 >= most_read as i32 => left,
                    count => {
                        let count = self.int(count);
                        self.within(count, left)
                    }
                };
                (first, count)
            }
        };
        let room = self.room(to);
        let fits = most_read <= most && to.most.is_none();
        let put = match behind {
            Some(behind) => {
                let room = self.b.ins().isub(room, behind);
                self.fewer(count, room)
            }
            None if fits => count,
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
        self.copy_characters(source, target, (put, most.min(most_read)));
        let end = behind.map_or(put, |behind| self.b.ins().iadd(behind, put));
        self.store_lengths(to, room, end);
        match action {
            TextAction::Assign if fits => self.constant(0),
            TextAction::Assign => {
                let cut = self.b.ins().icmp(IntCC::UnsignedLessThan, put, length);
                self.b.ins().uextend(I32, cut)
            }
            _ => count,
        }
    }

    /// Writes both lengths of a text.
    pub(super) fn store_lengths(&mut self, text: &Whole, most: Value, length: Value) {
        let Address { base, offset, .. } = text.address;
        self.b.ins().istore8(data(), most, base, offset);
        self.b.ins().istore8(data(), length, base, offset + 1);
    }

    /// Copies so many bytes, of which there are no more than the number behind.
    fn copy_characters(&mut self, from: Address, to: Address, (count, most): (Value, u32)) {
        let done = self.b.create_block();
        let bytes = self.b.ins().uextend(I64, count);
        let long = 2 * I8X16.bytes();
        if most > long {
            let [copied, short] = [self.b.create_block(), self.b.create_block()];
            let is_long = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThan, count, i64::from(long));
            self.b.ins().brif(is_long, copied, &[], short, &[]);
            self.go_on_in(copied);
            let [first, second] = [from, to].map(|address| self.arena_byte(address));
            let function = self.functions.get(self.module, Outside::Question(Question::CopyBytes));
            self.call(function, &[self.run, first, second, bytes]);
            self.b.ins().jump(done, &[]);
            self.go_on_in(short);
        }
        for ty in PAIRS {
            if most < ty.bytes() {
                continue;
            }
            let [copied, shorter] = [self.b.create_block(), self.b.create_block()];
            let is_it = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThanOrEqual, count, i64::from(ty.bytes()));
            self.b.ins().brif(is_it, copied, &[], shorter, &[]);
            self.go_on_in(copied);
            let [from_end, to_end] = [from, to].map(|address| self.b.ins().iadd(address.base, bytes));
            let size = ty.bytes() as i32;
            let first = self.b.ins().load(ty, data(), from.base, from.offset);
            let last = self.b.ins().load(ty, data(), from_end, from.offset - size);
            self.b.ins().store(data(), first, to.base, to.offset);
            self.b.ins().store(data(), last, to_end, to.offset - size);
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

    /// Where one character stands in a text; several are looked for by Rust code.
    fn find_one(&mut self, to: &Whole, from: &Whole) -> Value {
        let [length, count] = [to, from].map(|text| self.text_length(text));
        let [several, one, look, found, next, done] = [(); 6].map(|()| self.b.create_block());
        let at = self.b.append_block_param(look, I32);
        let result = self.b.append_block_param(done, I32);
        let is_one = self.b.ins().icmp_imm_u(IntCC::Equal, count, 1);
        self.b.ins().brif(is_one, one, &[], several, &[]);
        self.go_on_in(several);
        let nothing = self.b.ins().iconst(I64, 0);
        let place = self.call_for_texts(TextAction::Find, to, from, nothing);
        self.b.ins().jump(done, &[BlockArg::Value(place)]);
        self.go_on_in(one);
        let [all, wanted] = [to, from].map(|text| Address { offset: text.address.offset + text.room.head() as i32, ..text.address });
        let wanted = self.b.ins().load(I8, data(), wanted.base, wanted.offset);
        let wanted = self.b.ins().splat(I8X16, wanted);
        let zero = self.constant(0);
        self.b.ins().jump(look, &[BlockArg::Value(zero)]);
        self.b.switch_to_block(look);
        // The last ones that there is room for: those before are looked at twice, and the character is not among them.
        let last = self.constant(u32::from(to.room.characters_max) - I8X16.bytes());
        let first = self.fewer(at, last);
        let skipped = self.b.ins().uextend(I64, first);
        let base = self.b.ins().iadd(all.base, skipped);
        let characters = self.b.ins().load(I8X16, data(), base, all.offset);
        let same = self.b.ins().icmp(IntCC::Equal, characters, wanted);
        let bits = self.b.ins().vhigh_bits(I32, same);
        self.b.ins().brif(bits, found, &[], next, &[]);
        self.go_on_in(found);
        let place = self.b.ins().ctz(bits);
        let place = self.b.ins().iadd(place, first);
        let counts = self.b.ins().icmp(IntCC::UnsignedLessThan, place, length);
        let place = self.b.ins().iadd_imm_u(place, 1);
        let place = self.b.ins().select(counts, place, zero);
        self.b.ins().jump(done, &[BlockArg::Value(place)]);
        self.go_on_in(next);
        let at = self.b.ins().iadd_imm_u(at, i64::from(I8X16.bytes()));
        let more = self.b.ins().icmp(IntCC::UnsignedLessThan, at, length);
        self.b.ins().brif(more, look, &[BlockArg::Value(at)], done, &[BlockArg::Value(zero)]);
        self.b.seal_block(look);
        self.go_on_in(done);
        result
    }

    /// 0 if two texts have the same characters, else another number.
    fn differ(&mut self, a: &Whole, b: &Whole) -> Value {
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
        let long = 2 * I64.bytes();
        if most > long {
            let [compared, short] = [self.b.create_block(), self.b.create_block()];
            let is_long = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThan, length, i64::from(long));
            self.b.ins().brif(is_long, compared, &[], short, &[]);
            self.go_on_in(compared);
            let [first, second] = [a, b].map(|address| self.arena_byte(address));
            let function = self.functions.get(self.module, Outside::Question(Question::BytesDiffer));
            let answer = self.call(function, &[self.run, first, second, bytes]);
            let answer = self.b.ins().ireduce(I32, answer);
            self.b.ins().jump(done, &[BlockArg::Value(answer)]);
            self.go_on_in(short);
        }
        for ty in PAIRS.into_iter().skip(1) {
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
            let other = self.b.ins().icmp_imm_u(IntCC::NotEqual, bits, 0);
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

    /// Goes on in a block to which everything that leads there has been written.
    pub(super) fn go_on_in(&mut self, block: Block) {
        self.b.switch_to_block(block);
        self.b.seal_block(block);
    }

    /// Whether the order that an instruction finds is only asked whether it is 0.
    fn only_equality_counts(&self, index: u32, dst: Var) -> bool {
        if dst.register().is_some() {
            return false;
        }
        let code = &self.native().code;
        let statement = code.statements.partition_point(|&first| first <= index).saturating_sub(1);
        let first = code.statements[statement];
        let mut zeros: Vec<Var> = Vec::new();
        for (at, inst) in (first..).zip(code.statement(statement)) {
            if at > index && reads(inst).any(|var| var == dst) {
                let Inst::Compute { op: Op::Equal | Op::Differ, args: [a, b, ..], .. } = *inst else { return false };
                let other = if a == dst { b } else { a };
                if other == dst || !zeros.contains(&other) {
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
