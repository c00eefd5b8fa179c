//! REALs and LREALs that are read for calculations: their bytes are turned around in a register for reals, without a way through one for
//! numbers, which takes longer than the calculation.

use cranelift_codegen::cursor::{Cursor, FuncCursor};
use cranelift_codegen::ir::types::{F32, F32X4, F64, F64X2, I8X16};
use cranelift_codegen::ir::{Block, ConstantData, Function, Inst, InstBuilder, InstructionData, Opcode, Type, Value};
use rustc_hash::{FxHashMap, FxHashSet};

use super::turns::vector::{little, turned_order};

/// A number that was read, had its bytes turned around, and became a real: what did so, and the real with the vector of which it is the
/// first lane.
struct Read {
    load: Inst,
    swap: Inst,
    cast: Inst,
    real: Value,
    vector: Type,
}

/// Reads all numbers as reals that are nothing else and do not become a lane of a vector, which turns all its lanes at once.
pub(super) fn turn_as_reals(func: &mut Function) {
    let blocks: Vec<Block> = func.layout.blocks().collect();
    let insts: Vec<Inst> = blocks.into_iter().flat_map(|block| func.layout.block_insts(block)).collect();
    let mut uses: FxHashMap<Value, u32> = FxHashMap::default();
    let mut lanes: FxHashSet<Value> = FxHashSet::default();
    for &inst in &insts {
        func.dfg.inst_values(inst).for_each(|value| *uses.entry(value).or_default() += 1);
        if func.dfg.inst_results(inst).iter().any(|&result| func.dfg.value_type(result).is_vector()) {
            lanes.extend(func.dfg.inst_values(inst));
        }
    }
    for inst in insts {
        if let Some(read) = read_by(func, inst)
            && [read.load, read.swap].iter().all(|&inst| uses[&func.dfg.first_result(inst)] == 1)
            && !lanes.contains(&read.real)
        {
            read_as_real(func, read);
        }
    }
}

/// What became a real by an instruction.
fn read_by(func: &Function, cast: Inst) -> Option<Read> {
    let InstructionData::LoadNoOffset { opcode: Opcode::Bitcast, arg: number, .. } = func.dfg.insts[cast] else { return None };
    let swap = func.dfg.value_def(number).inst()?;
    let InstructionData::Unary { opcode: Opcode::Bswap, arg: bytes } = func.dfg.insts[swap] else { return None };
    let load = func.dfg.value_def(bytes).inst()?;
    if func.dfg.insts[load].opcode() != Opcode::Load {
        return None;
    }
    let real = func.dfg.first_result(cast);
    let vector = match func.dfg.value_type(real) {
        F32 => F32X4,
        F64 => F64X2,
        _ => return None,
    };
    Some(Read { load, swap, cast, real, vector })
}

/// Reads a number as the real that it becomes.
fn read_as_real(func: &mut Function, Read { load, swap, cast, real, vector }: Read) {
    let InstructionData::Load { arg: base, flags, offset, .. } = func.dfg.insts[load] else { unreachable!("it is a load") };
    let (ty, flags) = (func.dfg.value_type(real), func.dfg.mem_flags[flags]);
    let order = func.dfg.immediates.push(ConstantData::from(turned_order(ty.bytes() as u8)));
    let bytes = FuncCursor::new(func).at_inst(load).ins().load(ty, flags, base, offset);
    let mut cursor = FuncCursor::new(func).at_inst(cast);
    let lanes = cursor.ins().splat(vector, bytes);
    let lanes = cursor.ins().bitcast(I8X16, little(), lanes);
    let lanes = cursor.ins().shuffle(lanes, lanes, order);
    let lanes = cursor.ins().bitcast(vector, little(), lanes);
    let turned = cursor.ins().extractlane(lanes, 0);
    func.dfg.clear_results(cast);
    func.dfg.change_to_alias(real, turned);
    [cast, swap, load].into_iter().for_each(|inst| func.layout.remove_inst(inst));
}

#[cfg(test)]
mod tests {
    use cranelift_codegen::cursor::{Cursor, FuncCursor};
    use cranelift_codegen::ir::types::{F32, F32X4, F64, I32, I64};
    use cranelift_codegen::ir::{Function, InstBuilder, MemFlagsData, Type, Value};

    use super::turn_as_reals;

    /// What else needs a number that is read for a calculation.
    #[derive(Clone, Copy, Debug)]
    enum Other {
        Nothing,
        Number,
        Bytes,
        Lane,
    }

    /// Whether a number is read as a real.
    fn is_read_as_real(number: Type, real: Type, other: Other) -> bool {
        let mut func = Function::new();
        let block = func.dfg.make_block();
        let address = func.dfg.append_block_param(block, I64);
        let mut cursor = FuncCursor::new(&mut func);
        cursor.insert_block(block);
        let bytes = cursor.ins().load(number, MemFlagsData::new().with_notrap(), address, 4);
        let turned = cursor.ins().bswap(bytes);
        let cast = cursor.ins().bitcast(real, MemFlagsData::new(), turned);
        let sum = cursor.ins().fadd(cast, cast);
        let also = match other {
            Other::Nothing => sum,
            Other::Number => turned,
            Other::Bytes => bytes,
            Other::Lane => cursor.ins().splat(F32X4, cast),
        };
        cursor.ins().return_(&[sum, also]);
        turn_as_reals(&mut func);
        func.dfg.resolve_all_aliases();
        let insts: Vec<_> = func.layout.block_insts(block).collect();
        let types = |value: Value| func.dfg.value_type(value);
        let is_first = insts.first().is_some_and(|&first| types(func.dfg.first_result(first)) == real);
        assert_eq!(is_first, insts.len() == 8, "{}", func.display());
        is_first
    }

    #[test]
    fn a_number_that_is_nothing_but_a_real_is_read_as_one() {
        for (number, real) in [(I32, F32), (I64, F64)] {
            assert!(is_read_as_real(number, real, Other::Nothing));
            for other in [Other::Number, Other::Bytes] {
                assert!(!is_read_as_real(number, real, other), "{other:?}");
            }
        }
        assert!(!is_read_as_real(I32, F32, Other::Lane));
    }
}
