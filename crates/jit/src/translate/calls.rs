//! Calls of blocks, and what is passed to them.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::{Callee, Var};
use sieben_engine::machine::Register;

use super::inlining::{KEPT_IN, RESTORED};
use super::status_liveness::{ALL, SPARED, open_blocks, set_by_calls};
use super::value::Val;
use super::{AFTER_CALL, OPEN_BLOCKS, TRUSTED, Translator, bit_of};
use crate::run::Link;
use crate::runtime_calls::{LEAVE, RuntimeCall};

impl Translator<'_> {
    /// The pointer that the caller gave.
    pub(super) fn parameter(&mut self, dst: Var, index: u16) {
        if !self.outer.is_empty() {
            let pointer = self.given.get(usize::from(index)).copied().unwrap_or(Val::Const(0));
            return self.set(dst, pointer);
        }
        let first = self.b.ins().load(I64, TRUSTED, self.link, offset_of!(Link, parameters) as i32);
        let end = self.b.ins().load(I64, TRUSTED, self.link, offset_of!(Link, parameters_end) as i32);
        let address = self.b.ins().iadd_imm_u(first, 4 * i64::from(index));
        let pointer = self.b.ins().load(I32, TRUSTED, address, 0);
        let given = self.b.ins().icmp(IntCC::UnsignedLessThan, address, end);
        let none = self.b.ins().iconst(I32, 0);
        let pointer = self.b.ins().select(given, pointer, none);
        self.set(dst, Val::Int(pointer));
    }

    /// Takes a pointer for the block that is called next.
    pub(super) fn pass_parameter(&mut self, src: Var) {
        let value = self.get(src);
        let pointer = match self.force(value) {
            Val::Const(pointer) => Val::Const(pointer & 0xFFFF_FFFF),
            value => Val::Int(self.int(value)),
        };
        self.passed.push(pointer);
    }

    /// Puts the pointers where a function that is called, or an observer, finds them.
    pub(super) fn store_passed(&mut self) {
        if self.passed.is_empty() {
            return;
        }
        let end = self.own_parameters_end();
        for index in 0..self.passed.len() {
            let pointer = self.int(self.passed[index]);
            self.b.ins().store(TRUSTED, pointer, end, 4 * index as i32);
        }
    }

    pub(super) fn call_block(&mut self, index: u32, callee: Callee, parameters: u16) {
        match callee {
            Callee::Block(id) => match (self.find)(id) {
                Some(code) if self.inlines(code as usize) => {
                    self.call_inlined(index, code as usize, usize::from(parameters));
                    return self.temporaries.clear();
                }
                Some(code) => self.call_loaded(index, code as usize, parameters),
                None => self.call_other(index, None),
            },
            Callee::Number(_, number) => {
                let number = self.get(number);
                let number = self.word(number);
                self.call_other(index, Some(number));
            }
        }
        self.passed.truncate(self.passed.len().saturating_sub(usize::from(parameters)));
        self.temporaries.clear();
    }

    fn call_other(&mut self, index: u32, number: Option<Value>) {
        self.store_passed();
        self.words.forget_all();
        self.spill(self.dirty);
        (self.dirty, self.stored) = (0, ALL);
        let site = self.site(index);
        let number = number.unwrap_or_else(|| self.b.ins().iconst(I64, 0));
        let passed = self.b.ins().iconst(I64, self.passed.len() as i64);
        let answer = self.ask(RuntimeCall::CallOther, &[self.link, site, number, passed]);
        let cold = self.cold_block();
        let go_on = self.b.create_block();
        self.b.ins().brif(answer, cold, &[], go_on, &[]);
        self.b.switch_to_block(cold);
        self.b.seal_block(cold);
        // A call that failed is answered by the next statement.
        let left = self.b.ins().icmp_imm_u(IntCC::Equal, answer, LEAVE as i64);
        self.reload(ALL);
        let taken = self.taken;
        let next = self.edge(self.statement + 1);
        self.taken = taken;
        self.b.ins().brif(left, self.leave, &[], next, &[]);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.reload(ALL);
    }

    fn call_loaded(&mut self, index: u32, code: usize, parameters: u16) {
        self.forget_what_was_asked();
        self.look = None;
        self.stored = ALL;
        if self.pointers[code].writes_outwards {
            self.words.forget_all();
        }
        self.store_passed();
        let own = self.shown_link();
        let link = self.b.ins().iadd_imm_u(own, size_of::<Link>() as i64);
        let behind = self.local_behind();
        let local = self.b.ins().iadd_imm_u(self.local, behind);
        let callee = self.b.ins().iconst(I64, code as i64);
        let own_end = self.own_parameters_end();
        let passed = self.passed.len() as i64;
        let first = self.b.ins().iadd_imm_u(own_end, 4 * (passed - i64::from(parameters)));
        let last = self.b.ins().iadd_imm_u(own_end, 4 * passed);
        let site = self.native().named_inst(index);
        let site = self.b.ins().iconst(I64, i64::from(site));
        let put = |this: &mut Self, value: Value, offset: usize| {
            this.b.ins().store(TRUSTED, value, link, offset as i32);
        };
        put(self, callee, offset_of!(Link, code));
        put(self, site, offset_of!(Link, site));
        put(self, local, offset_of!(Link, local));
        put(self, first, offset_of!(Link, parameters));
        put(self, last, offset_of!(Link, parameters_end));
        let instance = self.register(Register::Ar2);
        let values = RESTORED.map(|register| self.register(register));
        for (&value, offset) in values.iter().zip(KEPT_IN) {
            let value = self.word(value);
            put(self, value, offset);
        }
        // The callee knows what a call sets, and does not read it.
        let (function, known) = self.version(index, code);
        let callee = &self.summaries[code];
        let handed = self.dirty & !set_by_calls() & !(SPARED & !callee.live_in()) | self.dirty & open_blocks();
        let handed = handed & !known.registers();
        let written = callee.written;
        let instance_kept = written & bit_of(Register::Ar2) != 0 && self.pointers[code].kept;
        self.spill(handed);
        self.dirty &= !handed;
        // The budget: a loop that calls keeps nothing else in a register.
        self.store_promoted();
        let left = self.call(function, &[self.run, self.arena, local, link]);
        let go_on = self.b.create_block();
        self.b.ins().brif(left, self.leave, &[], go_on, &[]);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.take_promoted();
        let needed = if self.options.exact { ALL } else { !SPARED | callee.live_out };
        let kept = if instance_kept { bit_of(Register::Ar2) } else { 0 };
        self.reload(written & needed & !set_by_calls() & !kept);
        for (register, value) in RESTORED.into_iter().zip(values) {
            let memory_may_differ =
                written & bit_of(register) != 0 || !OPEN_BLOCKS.contains(&register) || self.dirty & bit_of(register) != 0;
            self.current[register as usize] = Some(value);
            if memory_may_differ {
                self.dirty |= bit_of(register);
            }
        }
        for (register, value) in AFTER_CALL {
            self.set_register(register, Val::Const(value));
        }
        if instance_kept {
            self.set_register(Register::Ar2, instance);
        }
    }
}
