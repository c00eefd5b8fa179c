//! Timers and counters as machine code.
//!
//! [`Intrinsic::run`] is the definition; what stands here is compared with it over a grid of states, and calls it where machine code is not
//! worth its size: BCD values, presets that are not constants, numbers that the CPU does not have.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{self as clif, BlockArg, InstBuilder, Value};
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::Var;
use sieben_engine::machine::counters::COUNT_MAX;
use sieben_engine::machine::timers::BASE_US;
use sieben_engine::machine::{Counter, Timer, TimerKind};
use sieben_model::bcd;

use super::value::Val;
use super::{Continuation, TRUSTED, Translator};
use crate::run::Run;
use crate::runtime_calls::RuntimeCall;

/// For each time base its microseconds, and 2⁶⁴ divided by them, rounded up: for times below the longest that a timer runs, the upper
/// half of a product with it is exactly the quotient.
static BASES: [[u64; 2]; 4] = [numbers(0), numbers(1), numbers(2), numbers(3)];

const fn numbers(base: usize) -> [u64; 2] {
    [BASE_US[base], u64::MAX / BASE_US[base] + 1]
}

/// A timer or counter: the address from which fields are counted, and its offset there.
#[derive(Clone, Copy)]
struct Item {
    base: Value,
    offset: i32,
}

/// Timers that are known to be up to date, and counters whose count is known, the newest ones.
const FRESH_MAX: usize = 8;

/// The block in which Rust code is asked, once something goes there.
type SlowPath = Option<clif::Block>;

impl Translator<'_> {
    /// A function over the machine.
    pub(super) fn intrinsic(&mut self, index: u32, dst: Var, intrinsic: Intrinsic, args: [Var; 4]) {
        let args = [args[0], args[1], args[2]].map(|arg| {
            let value = self.get(arg);
            self.force(value)
        });
        let mut slow = None;
        let fast = if self.options.inline { self.written_out(intrinsic, args, &mut slow) } else { None };
        let result = match (fast, slow) {
            (Some(value), None) => value,
            (Some(value), Some(slow)) => {
                let done = self.b.create_block();
                let result = self.b.append_block_param(done, I64);
                let value = self.word(value);
                self.b.ins().jump(done, &[BlockArg::Value(value)]);
                self.b.switch_to_block(slow);
                self.b.seal_block(slow);
                let before = self.cold.replace(slow);
                let value = self.ask_intrinsic(index, args);
                self.b.ins().jump(done, &[BlockArg::Value(value)]);
                self.cold = before;
                self.b.switch_to_block(done);
                self.b.seal_block(done);
                self.counts.clear();
                Val::Word(result)
            }
            (None, _) => Val::Word(self.ask_intrinsic(index, args)),
        };
        self.set(dst, result);
    }

    /// The clock in milliseconds, 32 bits.
    pub(super) fn clock_ms(&mut self) -> Val {
        let ms = self.load_run(offset_of!(Run<'_, '_>, clock_ms));
        Val::Int(self.b.ins().ireduce(I32, ms))
    }

    fn ask_intrinsic(&mut self, index: u32, args: [Val; 3]) -> Value {
        let [a, b, c] = args.map(|arg| self.word(arg));
        let site = self.site(index);
        let failed = self.ask(RuntimeCall::TryIntrinsic, &[site, a, b, c]);
        self.unless_failed(failed, RuntimeCall::Failed, &[self.link, site], Continuation::NextStatement);
        self.result()
    }

    /// The code of an intrinsic, and its result; `None` where Rust code is always asked.
    fn written_out(&mut self, intrinsic: Intrinsic, [number, rlo, word]: [Val; 3], slow: &mut SlowPath) -> Option<Val> {
        use Intrinsic as I;
        if intrinsic == I::Clock {
            return Some(self.clock_ms());
        }
        if matches!(intrinsic, I::TimerBcd | I::CounterBcd) {
            return None;
        }
        let is_timer = matches!(intrinsic, I::TimerStart(_) | I::TimerReset | I::TimerEnable | I::TimerStatus | I::TimerValue);
        // Digits above 9 are a fault; those that are not known beforehand are looked at by Rust code.
        let preset = word.constant().map(|word| word as u16).filter(|&word| bcd::is_decimal(u32::from(word), 3));
        let item = self.item(is_timer, number, slow)?;
        Some(match intrinsic {
            I::TimerStart(kind) => {
                let refreshed = self.is_fresh(number);
                self.start_timer(item, kind, rlo, preset.filter(|_| kind != TimerKind::RetentiveOnDelay), refreshed, slow);
                if preset.is_some() && kind != TimerKind::RetentiveOnDelay {
                    self.know_as_fresh(number);
                }
                Val::Const(0)
            }
            I::TimerReset => {
                self.when(rlo, |this| {
                    for field in [offset_of!(Timer, running), offset_of!(Timer, base), offset_of!(Timer, status)] {
                        this.put_byte(item, field, 0);
                    }
                    this.put_word(item, offset_of!(Timer, value), 0);
                });
                Val::Const(0)
            }
            I::TimerEnable => {
                let edges = [offset_of!(Timer, start_edge)];
                self.enable(item, rlo, offset_of!(Timer, enable_edge), &edges);
                Val::Const(0)
            }
            I::TimerStatus => {
                if !self.is_fresh(number) {
                    self.refresh(item);
                    self.know_as_fresh(number);
                }
                Val::Bit { value: self.byte(item, offset_of!(Timer, status)), clean: true }
            }
            I::TimerValue => {
                let value = self.remaining(item);
                self.know_as_fresh(number);
                Val::Int(value)
            }
            I::CounterUp => self.count((item, number), rlo, offset_of!(Counter, up_edge), 1),
            I::CounterDown => self.count((item, number), rlo, offset_of!(Counter, down_edge), -1),
            I::CounterSet => {
                let rlo = self.flag(rlo);
                let starts = self.rises(item, rlo, offset_of!(Counter, set_edge));
                match preset {
                    Some(preset) => {
                        let count = self.count_of(item, number);
                        let value = self.b.ins().iconst(I32, i64::from(bcd::decode(u32::from(preset), 3)));
                        let count = self.b.ins().select(starts, value, count);
                        self.store_count(item, number, count);
                    }
                    None => self.leave_fast(starts, slow),
                }
                self.store_byte(item, offset_of!(Counter, set_edge), rlo);
                Val::Const(0)
            }
            I::CounterReset => {
                let rlo = self.flag(rlo);
                let count = self.count_of(item, number);
                let zero = self.b.ins().iconst(I32, 0);
                let count = self.b.ins().select(rlo, zero, count);
                self.store_count(item, number, count);
                Val::Const(0)
            }
            I::CounterEnable => {
                let edges = [offset_of!(Counter, set_edge), offset_of!(Counter, up_edge), offset_of!(Counter, down_edge)];
                self.enable(item, rlo, offset_of!(Counter, enable_edge), &edges);
                Val::Const(0)
            }
            I::CounterStatus => {
                let count = self.count_of(item, number);
                let is_not_zero = self.b.ins().icmp_imm_u(IntCC::NotEqual, count, 0);
                Val::Bit { value: self.b.ins().uextend(I32, is_not_zero), clean: true }
            }
            I::CounterValue => Val::Int(self.count_of(item, number)),
            I::TimerBcd | I::CounterBcd | I::Clock => return None,
        })
    }

    /// Whether a timer was brought up to date before, since when the clock stands still. Nothing that is done to timers makes that untrue.
    fn is_fresh(&self, number: Val) -> bool {
        number.constant().is_some_and(|number| self.fresh_timers.contains(&number))
    }

    fn know_as_fresh(&mut self, number: Val) {
        if let Val::Const(number) = number
            && !self.fresh_timers.contains(&number)
        {
            if self.fresh_timers.len() == FRESH_MAX {
                self.fresh_timers.remove(0);
            }
            self.fresh_timers.push(number);
        }
    }

    /// The count of a counter.
    fn count_of(&mut self, item: Item, number: Val) -> Value {
        if let Some(&(_, count)) = self.counts.iter().find(|(known, _)| number == Val::Const(*known)) {
            return count;
        }
        let count = self.word_field(item, offset_of!(Counter, count));
        self.know_count(number, count);
        count
    }

    fn store_count(&mut self, item: Item, number: Val, count: Value) {
        self.store_word(item, offset_of!(Counter, count), count);
        if number.constant().is_none() {
            // It may be any of them.
            self.counts.clear();
        }
        self.know_count(number, count);
    }

    fn know_count(&mut self, number: Val, count: Value) {
        if let Val::Const(number) = number {
            self.counts.retain(|&(known, _)| known != number);
            if self.counts.len() == FRESH_MAX {
                self.counts.remove(0);
            }
            self.counts.push((number, count));
        }
    }

    /// The timer or counter with this number; one that the CPU does not have is left to Rust code.
    fn item(&mut self, is_timer: bool, number: Val, slow: &mut SlowPath) -> Option<Item> {
        let (first, count, bytes) = match is_timer {
            true => (offset_of!(Run<'_, '_>, timers), self.layout.timers, size_of::<Timer>()),
            false => (offset_of!(Run<'_, '_>, counters), self.layout.counters, size_of::<Counter>()),
        };
        if let Val::Const(number) = number {
            let offset = i32::try_from(number.checked_mul(bytes as u64)?).ok().filter(|_| number < u64::from(count))?;
            return Some(Item { base: self.item_base(is_timer, first), offset });
        }
        let number = self.word(number);
        // Before the look: Rust code comes back behind what the other way computes.
        let base = self.item_base(is_timer, first);
        let missing = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThanOrEqual, number, i64::from(count));
        self.leave_fast(missing, slow);
        let moved = self.b.ins().imul_imm_u(number, bytes as i64);
        Some(Item { base: self.b.ins().iadd(base, moved), offset: 0 })
    }

    /// Address of the first timer or counter, which stays there until somebody is asked.
    fn item_base(&mut self, is_timer: bool, field: usize) -> Value {
        if let Some(base) = self.items[usize::from(is_timer)] {
            return base;
        }
        let base = self.load_run(field);
        self.items[usize::from(is_timer)] = Some(base);
        base
    }

    /// Asks Rust code if a condition holds; nothing has changed so far.
    fn leave_fast(&mut self, condition: Value, slow: &mut SlowPath) {
        let slow = *slow.get_or_insert_with(|| self.cold_block());
        let go_on = self.b.create_block();
        self.b.ins().brif(condition, slow, &[], go_on, &[]);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
    }

    /// Writes code that runs only if a bit is 1.
    fn when(&mut self, bit: Val, code: impl FnOnce(&mut Self)) {
        match bit {
            Val::Const(bit) if bit & 1 == 0 => {}
            Val::Const(_) => code(self),
            bit => {
                let bit = self.flag(bit);
                self.choose_way(bit, code, |_| {});
            }
        }
    }

    /// Writes two pieces of code, of which one runs: the first if the condition holds.
    fn choose_way(&mut self, condition: Value, yes: impl FnOnce(&mut Self), no: impl FnOnce(&mut Self)) {
        let [first, second, behind] = [0; 3].map(|_| self.b.create_block());
        self.b.ins().brif(condition, first, &[], second, &[]);
        self.b.switch_to_block(first);
        self.b.seal_block(first);
        yes(self);
        self.b.ins().jump(behind, &[]);
        self.b.switch_to_block(second);
        self.b.seal_block(second);
        no(self);
        self.b.ins().jump(behind, &[]);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
    }

    fn byte(&mut self, Item { base, offset }: Item, field: usize) -> Value {
        self.b.ins().uload8(I32, TRUSTED, base, offset + field as i32)
    }

    fn word_field(&mut self, Item { base, offset }: Item, field: usize) -> Value {
        self.b.ins().uload16(I32, TRUSTED, base, offset + field as i32)
    }

    fn store_byte(&mut self, Item { base, offset }: Item, field: usize, value: Value) {
        self.b.ins().istore8(TRUSTED, value, base, offset + field as i32);
    }

    fn store_word(&mut self, Item { base, offset }: Item, field: usize, value: Value) {
        self.b.ins().istore16(TRUSTED, value, base, offset + field as i32);
    }

    fn put_byte(&mut self, item: Item, field: usize, value: u8) {
        let value = self.b.ins().iconst(I32, i64::from(value));
        self.store_byte(item, field, value);
    }

    fn put_word(&mut self, item: Item, field: usize, value: u16) {
        let value = self.b.ins().iconst(I32, i64::from(value));
        self.store_word(item, field, value);
    }

    fn clock(&mut self) -> Value {
        self.load_run(offset_of!(Run<'_, '_>, clock_us))
    }

    /// Whether a bit is 1 and its edge memory 0.
    fn rises(&mut self, item: Item, bit: Value, edge: usize) -> Value {
        let edge = self.byte(item, edge);
        self.b.ins().band_not(bit, edge)
    }

    /// FR: on a rising edge other edge memories become 0.
    fn enable(&mut self, item: Item, rlo: Val, own: usize, edges: &[usize]) {
        let rlo = self.flag(rlo);
        let rises = self.rises(item, rlo, own);
        for &field in edges {
            let edge = self.byte(item, field);
            let edge = self.b.ins().band_not(edge, rises);
            self.store_byte(item, field, edge);
        }
        self.store_byte(item, own, rlo);
    }

    /// CU and CD.
    fn count(&mut self, (item, number): (Item, Val), rlo: Val, edge: usize, step: i64) -> Val {
        let rlo = self.flag(rlo);
        let rises = self.rises(item, rlo, edge);
        let count = self.count_of(item, number);
        let room = match step {
            1 => self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, count, i64::from(COUNT_MAX)),
            _ => self.b.ins().icmp_imm_u(IntCC::NotEqual, count, 0),
        };
        let room = self.b.ins().uextend(I32, room);
        let counts = self.b.ins().band(rises, room);
        let count = if step == 1 { self.b.ins().iadd(count, counts) } else { self.b.ins().isub(count, counts) };
        self.store_count(item, number, count);
        self.store_byte(item, edge, rlo);
        Val::Const(0)
    }

    /// Of a running timer: the value that it was started with, the time that has gone since, whether that is all of it, and where
    /// the numbers of its time base are.
    fn time(&mut self, item: Item) -> [Value; 4] {
        let base = self.byte(item, offset_of!(Timer, base));
        let base = self.b.ins().band_imm_u(base, 3);
        let base = self.b.ins().uextend(I64, base);
        let moved = self.b.ins().ishl_imm_u(base, 4);
        let table = self.b.ins().iconst(I64, BASES.as_ptr() as i64);
        let numbers = self.b.ins().iadd(table, moved);
        let unit = self.b.ins().load(I64, TRUSTED, numbers, 0);
        let value = self.word_field(item, offset_of!(Timer, value));
        let wide = self.b.ins().uextend(I64, value);
        let limit = self.b.ins().imul(wide, unit);
        let started = self.b.ins().load(I64, TRUSTED, item.base, item.offset + offset_of!(Timer, started_us) as i32);
        let now = self.clock();
        let gone = self.b.ins().isub(now, started);
        let ahead = self.b.ins().icmp(IntCC::UnsignedLessThan, now, started);
        let none = self.b.ins().iconst(I64, 0);
        let gone = self.b.ins().select(ahead, none, gone);
        let over = self.b.ins().icmp(IntCC::UnsignedGreaterThanOrEqual, gone, limit);
        [value, gone, over, numbers]
    }

    /// What is left of a value after a time below the whole of it.
    fn left(&mut self, value: Value, gone: Value, numbers: Value) -> Value {
        let reciprocal = self.b.ins().load(I64, TRUSTED, numbers, 8);
        let units = self.b.ins().umulhi(gone, reciprocal);
        let units = self.b.ins().ireduce(I32, units);
        self.b.ins().isub(value, units)
    }

    /// The end of a timer whose time is over.
    fn expire(&mut self, item: Item) {
        self.put_byte(item, offset_of!(Timer, running), 0);
        self.put_word(item, offset_of!(Timer, value), 0);
        let kind = self.byte(item, offset_of!(Timer, kind));
        let kind = self.b.ins().iadd_imm_s(kind, -(TimerKind::OnDelay as i64));
        let delays = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, kind, 2);
        let delays = self.b.ins().uextend(I32, delays);
        self.store_byte(item, offset_of!(Timer, status), delays);
    }

    /// `Timer::refresh`.
    fn refresh(&mut self, item: Item) {
        let running = self.byte(item, offset_of!(Timer, running));
        self.choose_way(
            running,
            |this| {
                let [_, _, over, _] = this.time(item);
                this.choose_way(over, |this| this.expire(item), |_| {});
            },
            |_| {},
        );
    }

    /// `Timer::refresh`, and the value.
    fn remaining(&mut self, item: Item) -> Value {
        let [runs, behind] = [0; 2].map(|_| self.b.create_block());
        let result = self.b.append_block_param(behind, I32);
        let value = self.word_field(item, offset_of!(Timer, value));
        let running = self.byte(item, offset_of!(Timer, running));
        self.b.ins().brif(running, runs, &[], behind, &[BlockArg::Value(value)]);
        self.b.switch_to_block(runs);
        self.b.seal_block(runs);
        let [value, gone, over, numbers] = self.time(item);
        let left = self.left(value, gone, numbers);
        let none = self.b.ins().iconst(I32, 0);
        let left = self.b.ins().select(over, none, left);
        self.choose_way(over, |this| this.expire(item), |_| {});
        self.b.ins().jump(behind, &[BlockArg::Value(left)]);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
        result
    }

    /// `Timer::stop`, which also does what `Timer::refresh` would have done to value and running bit.
    fn stop(&mut self, item: Item) {
        let running = self.byte(item, offset_of!(Timer, running));
        self.choose_way(
            running,
            |this| {
                let [value, gone, over, numbers] = this.time(item);
                let left = this.left(value, gone, numbers);
                let none = this.b.ins().iconst(I32, 0);
                let left = this.b.ins().select(over, none, left);
                this.store_word(item, offset_of!(Timer, value), left);
                this.put_byte(item, offset_of!(Timer, running), 0);
            },
            |_| {},
        );
    }

    /// `Timer::begin` with a value that is known, and the status behind it.
    fn begin(&mut self, item: Item, kind: TimerKind, preset: u16) {
        let value = bcd::decode(u32::from(preset), 3) as u16;
        let running = value > 0;
        let status = match kind {
            TimerKind::Pulse | TimerKind::ExtendedPulse | TimerKind::OffDelay => running,
            TimerKind::OnDelay | TimerKind::RetentiveOnDelay => !running,
        };
        let now = self.clock();
        self.b.ins().store(TRUSTED, now, item.base, item.offset + offset_of!(Timer, started_us) as i32);
        self.put_word(item, offset_of!(Timer, value), value);
        self.put_byte(item, offset_of!(Timer, kind), kind as u8);
        self.put_byte(item, offset_of!(Timer, base), (preset >> 12 & 3) as u8);
        self.put_byte(item, offset_of!(Timer, running), u8::from(running));
        self.put_byte(item, offset_of!(Timer, status), u8::from(status));
    }

    /// `Timer::start`, with a preset that is known beforehand; a retentive on delay keeps a status that may have to be brought up to date
    /// first, and has none.
    fn start_timer(&mut self, item: Item, kind: TimerKind, rlo: Val, preset: Option<u16>, fresh: bool, slow: &mut SlowPath) {
        let rlo = self.flag(rlo);
        let edge = self.byte(item, offset_of!(Timer, start_edge));
        let starts = match kind {
            TimerKind::OffDelay => self.b.ins().band_not(edge, rlo),
            _ => self.b.ins().band_not(rlo, edge),
        };
        let refresh = |this: &mut Self| {
            if !fresh {
                this.refresh(item);
            }
        };
        let not_started = |this: &mut Self| match kind {
            TimerKind::Pulse | TimerKind::OnDelay => this.choose_way(rlo, refresh, |this| {
                this.stop(item);
                this.put_byte(item, offset_of!(Timer, status), 0);
            }),
            TimerKind::ExtendedPulse | TimerKind::RetentiveOnDelay => refresh(this),
            TimerKind::OffDelay => {
                let rises = this.b.ins().band_not(rlo, edge);
                this.choose_way(
                    rises,
                    |this| {
                        this.stop(item);
                        this.put_byte(item, offset_of!(Timer, status), 1);
                    },
                    refresh,
                );
            }
        };
        match preset {
            Some(preset) => self.choose_way(starts, |this| this.begin(item, kind, preset), not_started),
            None => {
                self.leave_fast(starts, slow);
                not_started(self);
            }
        }
        self.store_byte(item, offset_of!(Timer, start_edge), rlo);
    }
}
