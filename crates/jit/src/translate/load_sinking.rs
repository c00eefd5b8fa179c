//! Load sinking: each load moves as near as can be to its use, after Cranelift's own optimizations. These move calculations to where their
//! results are used but leave each load where it was written, so that its result occupies a register, or the stack. An instruction can take
//! the load directly before it as an operand.

use std::collections::BTreeMap;
use std::ops::Range;

use cranelift_codegen::ir::{Block, Function, Inst, InstructionData, Opcode, Value};

/// Bytes of memory: behind which address, and from where to where.
struct ByteRange {
    base: Value,
    range: Range<i64>,
}

impl ByteRange {
    /// What an instruction reads or writes, if that is all it does to memory.
    fn of(func: &Function, inst: Inst) -> Option<Self> {
        let (base, offset, number) = match func.dfg.insts[inst] {
            InstructionData::Load { opcode: Opcode::Load, arg, offset, .. } => (arg, offset, func.dfg.first_result(inst)),
            InstructionData::Store { opcode: Opcode::Store, args: [number, base], offset, .. } => (base, offset, number),
            _ => return None,
        };
        let start = i64::from(i32::from(offset));
        Some(Self { base, range: start..start + i64::from(func.dfg.value_type(number).bytes()) })
    }

    /// What an instruction reads that may as well be read later.
    fn of_read(func: &Function, inst: Inst) -> Option<Self> {
        match func.dfg.insts[inst] {
            InstructionData::Load { flags, .. } if func.dfg.mem_flags[flags].notrap() => Self::of(func, inst),
            _ => None,
        }
    }

    /// Whether others are surely not among them.
    fn are_apart(&self, others: &Self) -> bool {
        self.base == others.base && (self.range.end <= others.range.start || others.range.end <= self.range.start)
    }
}

/// What changes memory: the place of the instruction, and which bytes, if that is known.
type Clobber = (usize, Option<ByteRange>);

/// Moves reads down to where their blocks first need them, as far as nothing between may change what they read.
pub(super) fn bring_nearer(func: &mut Function) {
    let blocks: Vec<Block> = func.layout.blocks().collect();
    blocks.into_iter().for_each(|block| bring_nearer_in(func, block));
}

fn bring_nearer_in(func: &mut Function, block: Block) {
    let insts: Vec<Inst> = func.layout.block_insts(block).collect();
    // Where values are first needed, and the first of the reads that were put before an instruction.
    let mut needed: BTreeMap<Value, usize> = BTreeMap::new();
    let mut in_front: BTreeMap<usize, Inst> = BTreeMap::new();
    // From the last one on.
    let mut changes: Vec<Clobber> = Vec::new();
    for (at, &inst) in insts.iter().enumerate().rev() {
        let mut place = at;
        if let Some(bytes) = ByteRange::of_read(func, inst) {
            let first = needed.get(&func.dfg.first_result(inst)).copied().unwrap_or(at);
            let meets = |change: &Option<ByteRange>| change.as_ref().is_none_or(|change| !change.are_apart(&bytes));
            let mut between = changes.iter().rev().take_while(|(change, _)| *change < first);
            place = between.find(|(_, change)| meets(change)).map_or(first, |&(change, _)| change);
            if place > at {
                func.layout.remove_inst(inst);
                func.layout.insert_inst(inst, in_front.get(&place).copied().unwrap_or(insts[place]));
                in_front.insert(place, inst);
            }
        } else if changes_memory(func, inst) {
            changes.push((at, ByteRange::of(func, inst)));
        }
        for value in func.dfg.inst_values(inst) {
            needed.entry(value).and_modify(|first| *first = place.min(*first)).or_insert(place);
        }
    }
}

/// Whether an instruction may change memory, or must not change places with one that reads it.
pub(super) fn changes_memory(func: &Function, inst: Inst) -> bool {
    let opcode = func.dfg.insts[inst].opcode();
    opcode.can_store() || opcode.is_call() || opcode.other_side_effects()
}

#[cfg(test)]
mod tests {
    use cranelift_codegen::cursor::{Cursor, FuncCursor};
    use cranelift_codegen::ir::types::{I32, I64};
    use cranelift_codegen::ir::{AbiParam, Function, Inst, InstBuilder, MemFlagsData, Signature, UserFuncName};
    use cranelift_codegen::isa::CallConv;

    use super::bring_nearer;

    /// What lies between a read of four bytes, 8 behind the first address, and what needs it.
    #[derive(Clone, Copy, Debug)]
    enum Between {
        /// A write of four bytes behind the first or second address.
        Write {
            address: usize,
            offset: i32,
        },
        Read,
        Fence,
        Call,
    }

    /// The instructions of a function before and behind, in their order. A sum needs the read at its end if it does not begin with it.
    fn moved(between: Between, begins: bool, may_trap: bool) -> [Vec<Inst>; 2] {
        let mut signature = Signature::new(CallConv::SystemV);
        signature.params = vec![AbiParam::new(I64); 2];
        signature.returns.push(AbiParam::new(I32));
        let mut func = Function::with_name_signature(UserFuncName::default(), signature.clone());
        let block = func.dfg.make_block();
        let addresses = [0; 2].map(|_| func.dfg.append_block_param(block, I64));
        let callee = func.import_signature(signature);
        let mut cursor = FuncCursor::new(&mut func);
        cursor.insert_block(block);
        let one = cursor.ins().iconst(I32, 1);
        let flags = if may_trap { MemFlagsData::new() } else { MemFlagsData::new().with_notrap() };
        let read = cursor.ins().load(I32, flags, addresses[0], 8);
        let first = if begins { cursor.ins().iadd(read, one) } else { one };
        let other = match between {
            Between::Write { address, offset } => {
                cursor.ins().store(MemFlagsData::new(), one, addresses[address], offset);
                one
            }
            Between::Read => cursor.ins().load(I32, MemFlagsData::new(), addresses[1], 0),
            Between::Fence => {
                cursor.ins().fence();
                one
            }
            Between::Call => {
                let call = cursor.ins().call_indirect(callee, addresses[1], &addresses);
                cursor.func.dfg.first_result(call)
            }
        };
        let sum = cursor.ins().iadd(other, first);
        let sum = cursor.ins().iadd(sum, read);
        cursor.ins().return_(&[sum]);
        let before = func.layout.block_insts(block).collect();
        bring_nearer(&mut func);
        [before, func.layout.block_insts(block).collect()]
    }

    fn stays(between: Between) -> bool {
        let [before, behind] = moved(between, false, false);
        // The read is the second one, and what lies between the third one; the first sum is before what needs the read.
        assert!(before == behind || behind == [before[0], before[2], before[3], before[1], before[4], before[5]], "{between:?}");
        before == behind
    }

    #[test]
    fn a_read_moves_to_what_needs_it_unless_something_between_may_change_what_it_reads() {
        assert!(!stays(Between::Read));
        assert!(stays(Between::Fence));
        assert!(stays(Between::Call));
        for offset in 0..20 {
            assert_eq!(stays(Between::Write { address: 0, offset }), (5..12).contains(&offset), "{offset}");
            assert!(stays(Between::Write { address: 1, offset }));
        }
    }

    #[test]
    fn a_read_that_may_trap_or_that_is_needed_at_once_stays() {
        for (begins, may_trap) in [(true, false), (false, true)] {
            let [before, behind] = moved(Between::Read, begins, may_trap);
            assert_eq!(before, behind);
        }
    }

    #[test]
    fn a_read_moves_up_to_a_write_in_front_of_what_needs_it() {
        let mut func = Function::new();
        let block = func.dfg.make_block();
        let [address, other] = [0; 2].map(|_| func.dfg.append_block_param(block, I64));
        let mut cursor = FuncCursor::new(&mut func);
        cursor.insert_block(block);
        let flags = MemFlagsData::new().with_notrap();
        // An address that is read, what is read there, and one more: each before what needs it first.
        let place = cursor.ins().load(I64, flags, address, 0);
        let number = cursor.ins().load(I32, flags, place, 0);
        let beside = cursor.ins().load(I32, flags, address, 8);
        let one = cursor.ins().iconst(I32, 1);
        let two = cursor.ins().iadd(one, one);
        cursor.ins().store(flags, two, other, 0);
        let sum = cursor.ins().iadd(number, beside);
        cursor.ins().return_(&[sum]);
        let before: Vec<Inst> = func.layout.block_insts(block).collect();
        bring_nearer(&mut func);
        let behind: Vec<Inst> = func.layout.block_insts(block).collect();
        assert_eq!(behind, [3, 4, 0, 1, 2, 5, 6, 7].map(|at: usize| before[at]));
    }
}
