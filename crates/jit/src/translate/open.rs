//! Opening data blocks: by a constant number, or by the table of those that the program was loaded with.

use std::mem::offset_of;
use std::ops::Range;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{BlockArg, InstBuilder};
use sieben_engine::access::data_registers;
use sieben_engine::ir::{DataRegister, Var};
use sieben_model::address::Width;

use super::value::Val;
use super::{Continuation, TRUSTED, Translator};
use crate::run::{NOT_LOADED, Run};
use crate::runtime_calls::RuntimeCall;

impl Translator<'_> {
    /// Opens a data block.
    pub(super) fn open(&mut self, index: u32, register: DataRegister, number: Var) {
        let number = self.get(number);
        let number = self.force(number);
        if let Val::Const(number) = number
            && self.open_known(register, number & 0xFFFF)
        {
            return;
        }
        let registers = data_registers(register);
        let number = self.low_bits(number, Width::Word);
        let number = self.b.ins().uextend(I64, number);
        // Behind the last data block stands one that is not loaded.
        let last = self.load_run(offset_of!(Run<'_, '_>, open_last));
        let table = self.load_run(offset_of!(Run<'_, '_>, open_table));
        let inside = self.b.ins().icmp(IntCC::UnsignedLessThan, number, last);
        let place = self.b.ins().select(inside, number, last);
        let place = self.b.ins().ishl_imm_u(place, 3);
        let entry = self.b.ins().iadd(table, place);
        let base = self.b.ins().load(I32, TRUSTED, entry, 0);
        let length = self.b.ins().load(I32, TRUSTED, entry, 4);
        let missing = self.b.ins().icmp_imm_u(IntCC::Equal, base, i64::from(NOT_LOADED));
        let base = self.b.ins().uextend(I64, base);
        let length = self.b.ins().uextend(I64, length);
        let (slow, go_on) = (self.cold_block(), self.b.create_block());
        let delivered = [self.b.append_block_param(go_on, I64), self.b.append_block_param(go_on, I64)];
        self.b.ins().brif(missing, slow, &[], go_on, &[BlockArg::Value(base), BlockArg::Value(length)]);
        self.b.switch_to_block(slow);
        self.b.seal_block(slow);
        let before = self.cold.replace(slow);
        let site = self.site(index);
        let failed = self.ask(RuntimeCall::TryOpen, &[site, number]);
        let found = self.load_run(offset_of!(Run<'_, '_>, value));
        let low = self.b.ins().ireduce(I32, found);
        let found = [self.b.ins().uextend(I64, low), self.b.ins().ushr_imm_u(found, 32)];
        let failing = self.cold_block();
        self.b.ins().brif(failed, failing, &[], go_on, &found.map(BlockArg::Value));
        self.cold_path(failing, RuntimeCall::Failed, &[self.link, site], Continuation::NextStatement);
        self.cold = before;
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        for (register, value) in registers.into_iter().zip([number, delivered[0], delivered[1]]) {
            self.set_register(register, Val::Word(value));
        }
    }

    /// Opens a data block that the program has; whether that is known beforehand. The run makes sure that it is there.
    fn open_known(&mut self, register: DataRegister, number: u64) -> bool {
        let Some(range) = self.data_block(number) else { return false };
        let values = [number, range.start as u64, range.len() as u64];
        for (register, value) in data_registers(register).into_iter().zip(values) {
            self.set_register(register, Val::Const(value));
        }
        self.pinned.insert(number as u16);
        true
    }

    /// The bytes of a data block that the program has, by its number; 0 is none and has none.
    pub(super) fn data_block(&self, number: u64) -> Option<Range<usize>> {
        match number {
            0 => Some(0..0),
            _ => self.layout.data_blocks.get(&u16::try_from(number).ok()?).cloned(),
        }
    }
}
