//! Products of 16 bits with constants, calculated in 32: x86 puts one of 16 bits into a register of which it keeps the upper half, so that
//! it waits for whatever was there before, in a loop for the end of the turn before.

use cranelift_codegen::cursor::{Cursor, FuncCursor};
use cranelift_codegen::ir::types::{I16, I32, I64};
use cranelift_codegen::ir::{Block, Function, Inst, InstBuilder, InstructionData, Opcode, Value};

use super::branches::constant_of;

/// Multiplies in whole registers, behind Cranelift's own optimizations: they would multiply in 16 bits again.
pub(super) fn widen(func: &mut Function) {
    let blocks: Vec<Block> = func.layout.blocks().collect();
    let insts: Vec<Inst> = blocks.into_iter().flat_map(|block| func.layout.block_insts(block)).collect();
    for inst in insts {
        let InstructionData::Binary { opcode: Opcode::Imul, args } = func.dfg.insts[inst] else { continue };
        let result = func.dfg.first_result(inst);
        if func.dfg.value_type(result) != I16 || !args.iter().any(|&arg| constant_of(func, arg).is_some()) {
            continue;
        }
        let [a, b] = args.map(|arg| whole(func, inst, arg));
        let mut cursor = FuncCursor::new(func).at_inst(inst);
        let product = cursor.ins().imul(a, b);
        let low = cursor.ins().ireduce(I16, product);
        func.dfg.clear_results(inst);
        func.dfg.change_to_alias(result, low);
        func.layout.remove_inst(inst);
    }
}

/// A number of 32 bits that ends with one of 16.
fn whole(func: &mut Function, at: Inst, value: Value) -> Value {
    let number = constant_of(func, value);
    let of = func.dfg.value_def(value).inst().and_then(|inst| match func.dfg.insts[inst] {
        InstructionData::Unary { opcode: Opcode::Ireduce, arg } => Some(arg),
        _ => None,
    });
    let of_64_bits = of.is_some_and(|of| func.dfg.value_type(of) == I64);
    let mut cursor = FuncCursor::new(func).at_inst(at);
    match (number, of) {
        (Some(number), _) => cursor.ins().iconst(I32, i64::from(number as i16)),
        (None, Some(of)) if of_64_bits => cursor.ins().ireduce(I32, of),
        (None, Some(of)) => of,
        (None, None) => cursor.ins().uextend(I32, value),
    }
}

#[cfg(test)]
mod tests {
    use cranelift_codegen::cursor::{Cursor, FuncCursor};
    use cranelift_codegen::ir::types::{I16, I32, I64, Type};
    use cranelift_codegen::ir::{Function, InstBuilder, InstructionData, Opcode};

    use super::widen;

    /// The types of the products of a function with one of 16 bits: of a parameter of a type, cut to 16 bits, and a constant or itself.
    fn products(ty: Type, by_itself: bool, factor_first: bool) -> Vec<Type> {
        let mut func = Function::new();
        let block = func.dfg.make_block();
        let number = func.dfg.append_block_param(block, ty);
        let mut cursor = FuncCursor::new(&mut func);
        cursor.insert_block(block);
        let number = if ty == I16 { number } else { cursor.ins().ireduce(I16, number) };
        let factor = if by_itself { number } else { cursor.ins().iconst(I16, 0xFFF3) };
        let (a, b) = if factor_first { (factor, number) } else { (number, factor) };
        let product = cursor.ins().imul(a, b);
        let sum = cursor.ins().iadd(product, number);
        cursor.ins().return_(&[sum]);
        widen(&mut func);
        let block = func.layout.entry_block().expect("a block");
        let is_product = |inst: &_| matches!(func.dfg.insts[*inst], InstructionData::Binary { opcode: Opcode::Imul, .. });
        let products = func.layout.block_insts(block).filter(is_product);
        products.map(|inst| func.dfg.value_type(func.dfg.first_result(inst))).collect()
    }

    #[test]
    fn a_product_with_a_constant_is_calculated_in_32_bits() {
        for ty in [I16, I32, I64] {
            for factor_first in [false, true] {
                assert_eq!(products(ty, false, factor_first), [I32], "{ty}");
                assert_eq!(products(ty, true, factor_first), [I16], "{ty}: the register with the product held a factor before");
            }
        }
    }
}
