//! Branches on two conditions, behind Cranelift's own optimizations: one of them is nearly always the same, and is computed and looked at
//! only where the other one does not tell the way. A counter looks at its limit when it counts, and not in each scan.

use cranelift_codegen::cursor::{Cursor, FuncCursor};
use cranelift_codegen::flowgraph::ControlFlowGraph;
use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{Block, Function, Inst, InstBuilder, InstructionData, Opcode, Value};
use rustc_hash::{FxHashMap, FxHashSet};

use super::near_reads::changes_memory;

/// Uses of values: who uses them, and in which block.
type Uses = FxHashMap<Value, Vec<(Inst, Block)>>;

/// Makes two branches of each branch on two conditions one of which is nearly always the same.
pub(super) fn part(func: &mut Function) {
    let blocks: Vec<Block> = func.layout.blocks().collect();
    let mut uses = Uses::default();
    for &block in &blocks {
        for inst in func.layout.block_insts(block) {
            for value in func.dfg.inst_values(inst) {
                uses.entry(func.dfg.resolve_aliases(value)).or_default().push((inst, block));
            }
        }
    }
    let flow = ControlFlowGraph::with_function(func);
    for block in blocks {
        if let Some(parted) = Parted::at_end_of(func, &uses, block) {
            let moved = parted.needed_late(func, &flow, &uses);
            // It may come from another block.
            if moved.last().is_some_and(|&last| func.dfg.first_result(last) == parted.late) {
                parted.part(func, &moved);
            }
        }
    }
}

/// How two conditions are joined.
#[derive(Clone, Copy, PartialEq)]
enum Joins {
    And,
    Or,
}

/// A branch on two conditions.
struct Parted {
    block: Block,
    branch: Inst,
    /// What joins them.
    joined: Inst,
    joins: Joins,
    /// What is looked at first, and behind that, if it has to be: the latter is 0 or 1.
    first: Value,
    late: Value,
}

impl Parted {
    /// The branch at the end of a block, if it looks at two conditions which nobody else wants to know joined.
    fn at_end_of(func: &Function, uses: &Uses, block: Block) -> Option<Self> {
        let branch = func.layout.last_inst(block)?;
        let InstructionData::Brif { arg, .. } = func.dfg.insts[branch] else { return None };
        let condition = func.dfg.resolve_aliases(arg);
        let joined = func.dfg.value_def(condition).inst()?;
        let (joins, args) = match func.dfg.insts[joined] {
            InstructionData::Binary { opcode: Opcode::Band, args } => (Joins::And, args),
            InstructionData::Binary { opcode: Opcode::Bor, args } => (Joins::Or, args),
            _ => return None,
        };
        let [a, b] = args.map(|value| func.dfg.resolve_aliases(value));
        let is_late = |value| match joins {
            Joins::And => is_nearly_always_true(func, value),
            Joins::Or => is_nearly_never_true(func, value),
        };
        let (first, late) = if is_late(b) { (a, b) } else { (b, a) };
        let is_used_once = uses.get(&condition).is_some_and(|uses| uses.len() == 1);
        (is_late(late) && is_used_once).then_some(Self { block, branch, joined, joins, first, late })
    }

    /// The instructions of the block that make the late condition and that nobody needs before it is looked at, in their order.
    fn needed_late(&self, func: &Function, flow: &ControlFlowGraph, uses: &Uses) -> Vec<Inst> {
        let InstructionData::Brif { blocks: ways, .. } = func.dfg.insts[self.branch] else { return Vec::new() };
        let [then, otherwise] = ways.map(|way| way.block(&func.dfg.value_lists));
        // Where both are true, what is computed between the branches is known if no other way leads there.
        let is_behind = |block| {
            self.joins == Joins::And && block == then && ![otherwise, self.block].contains(&then) && flow.pred_iter(then).count() == 1
        };
        let mut moved: Vec<Inst> = Vec::new();
        let mut gone = FxHashSet::from_iter([self.joined]);
        let mut is_changed = false;
        let insts: Vec<Inst> = func.layout.block_insts(self.block).collect();
        for &inst in insts.iter().rev() {
            let results = func.dfg.inst_results(inst);
            let makes_late = results.contains(&self.late) || moved.iter().any(|&moved| needs(func, moved, inst));
            let is_needed_by_others = results.iter().filter_map(|result| uses.get(result)).flatten();
            let mut is_needed_by_others = is_needed_by_others.filter(|&(inst, block)| !gone.contains(inst) && !is_behind(*block));
            if makes_late && may_be_late(func, inst, is_changed) && is_needed_by_others.next().is_none() {
                moved.push(inst);
                gone.insert(inst);
            }
            is_changed |= changes_memory(func, inst);
        }
        moved.reverse();
        moved
    }

    /// Makes two branches of one, with these instructions in front of the second one.
    fn part(self, func: &mut Function, moved: &[Inst]) {
        let InstructionData::Brif { blocks: ways, .. } = func.dfg.insts[self.branch] else { return };
        let next = func.dfg.make_block();
        func.layout.insert_block_after(next, self.block);
        if func.layout.is_cold(self.block) {
            func.layout.set_cold(next);
        }
        for &inst in moved {
            func.layout.remove_inst(inst);
            func.layout.append_inst(inst, next);
        }
        func.layout.remove_inst(self.joined);
        let again = ways.map(|way| way.deep_clone(&mut func.dfg.value_lists));
        let way = func.dfg.block_call(next, &[]);
        let mut cursor = FuncCursor::new(func).at_bottom(next);
        let second = cursor.ins().jump(next, &[]);
        cursor.func.dfg.insts[second] = InstructionData::Brif { opcode: Opcode::Brif, arg: self.late, blocks: again };
        cursor.goto_inst(self.branch);
        let mut first = self.first;
        // Of what is joined with 1 by AND, no other bit counts.
        if self.joins == Joins::And && comparison(cursor.func, first).is_none() {
            let ty = cursor.func.dfg.value_type(first);
            let one = cursor.ins().iconst(ty, 1);
            first = cursor.ins().band(first, one);
        }
        let blocks = if self.joins == Joins::And { [way, ways[1]] } else { [ways[0], way] };
        cursor.func.dfg.insts[self.branch] = InstructionData::Brif { opcode: Opcode::Brif, arg: first, blocks };
    }
}

/// A comparison: how, and of what.
fn comparison(func: &Function, value: Value) -> Option<(IntCC, [Value; 2])> {
    match func.dfg.insts[func.dfg.value_def(func.dfg.resolve_aliases(value)).inst()?] {
        InstructionData::IntCompare { cond, args, .. } => Some((cond, args.map(|value| func.dfg.resolve_aliases(value)))),
        InstructionData::Unary { opcode: Opcode::Uextend, arg } => comparison(func, arg),
        _ => None,
    }
}

/// Whether a comparison says that a number is not the greatest one or the least one.
fn is_nearly_always_true(func: &Function, value: Value) -> bool {
    let Some((cond, [number, limit])) = comparison(func, value) else { return false };
    let Some(limit) = constant_of(func, limit) else { return false };
    let ty = func.dfg.value_type(number);
    let extended = func.dfg.value_def(number).inst().and_then(|inst| match func.dfg.insts[inst] {
        InstructionData::Unary { opcode: Opcode::Sextend, arg } => Some(func.dfg.value_type(arg)),
        _ => None,
    });
    let greatest = u64::MAX >> (65 - extended.unwrap_or(ty).bits());
    let least = !greatest & u64::MAX >> (64 - ty.bits());
    match cond {
        IntCC::SignedLessThan => limit == greatest,
        IntCC::SignedGreaterThan => limit == least,
        IntCC::NotEqual => limit == greatest || limit == least,
        _ => false,
    }
}

/// Whether a comparison says that a number is below 0: a time that has passed is not, unless it is too long for its type.
fn is_nearly_never_true(func: &Function, value: Value) -> bool {
    comparison(func, value).is_some_and(|(cond, [_, limit])| cond == IntCC::SignedLessThan && constant_of(func, limit) == Some(0))
}

/// Whether an instruction may be done at the end of its block as well, where memory is changed behind it or not.
fn may_be_late(func: &Function, inst: Inst, is_changed: bool) -> bool {
    match func.dfg.insts[inst] {
        InstructionData::IntCompare { .. } | InstructionData::Unary { .. } => true,
        InstructionData::Load { flags, .. } => func.dfg.mem_flags[flags].notrap() && !is_changed,
        _ => false,
    }
}

/// Whether an instruction needs the result of another one.
fn needs(func: &Function, inst: Inst, other: Inst) -> bool {
    func.dfg.inst_values(inst).any(|value| func.dfg.inst_results(other).contains(&func.dfg.resolve_aliases(value)))
}

/// A constant with zeros above it.
pub(super) fn constant_of(func: &Function, value: Value) -> Option<u64> {
    let value = func.dfg.resolve_aliases(value);
    match func.dfg.insts[func.dfg.value_def(value).inst()?] {
        InstructionData::UnaryImm { opcode: Opcode::Iconst, imm } => {
            Some(imm.bits() as u64 & u64::MAX >> (64 - func.dfg.value_type(value).bits()))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use cranelift_codegen::ir::types::{I16, I32, I64};
    use cranelift_codegen::ir::{AbiParam, MemFlagsData, Signature, UserFuncName};
    use cranelift_codegen::isa::CallConv;

    use super::*;

    /// A function with these parameters.
    fn function(params: &[cranelift_codegen::ir::Type]) -> (Function, Block, Vec<Value>) {
        let mut signature = Signature::new(CallConv::SystemV);
        signature.params = params.iter().map(|&ty| AbiParam::new(ty)).collect();
        signature.returns.push(AbiParam::new(I32));
        let mut func = Function::with_name_signature(UserFuncName::default(), signature);
        let block = func.dfg.make_block();
        let params = params.iter().map(|&ty| func.dfg.append_block_param(block, ty)).collect();
        func.layout.append_block(block);
        (func, block, params)
    }

    /// What else a block does that branches on a bit and a number that is not the greatest.
    #[derive(Clone, Copy, PartialEq)]
    enum Beside {
        Nothing,
        WritesBehind,
        WritesInFront,
        NeedsNumberThen,
        NeedsNumberOtherwise,
        NeedsNumberLater,
        GoesTheSameWay,
        JumpsThere,
    }

    /// How many branches there are then, and whether the number is read behind the first one only.
    fn branches(joins: Joins, beside: Beside, limit: i64) -> (usize, bool) {
        let (mut func, block, params) = function(&[I64, I32]);
        let flags = MemFlagsData::new().with_notrap();
        let [then, otherwise, end] = [0; 3].map(|_| func.dfg.make_block());
        let mut cursor = FuncCursor::new(&mut func).at_bottom(block);
        let (address, bit) = (params[0], params[1]);
        let one = cursor.ins().iconst(I32, 1);
        if beside == Beside::WritesInFront {
            cursor.ins().store(flags, one, address, 0);
        }
        let number = cursor.ins().load(I16, flags, address, 0);
        let wide = cursor.ins().sextend(I32, number);
        if beside == Beside::WritesBehind {
            cursor.ins().store(flags, one, address, 0);
        }
        let limit = cursor.ins().iconst(I32, limit);
        let less = cursor.ins().icmp(IntCC::SignedLessThan, wide, limit);
        let less = cursor.ins().uextend(I32, less);
        let both = if joins == Joins::And { cursor.ins().band(bit, less) } else { cursor.ins().bor(bit, less) };
        let ways = if beside == Beside::GoesTheSameWay { [then, then] } else { [then, otherwise] };
        cursor.ins().brif(both, ways[0], &[], ways[1], &[]);
        for (block, needs) in [(then, Beside::NeedsNumberThen), (otherwise, Beside::NeedsNumberOtherwise), (end, Beside::NeedsNumberLater)]
        {
            cursor.insert_block(block);
            let needs_there = block == then && [Beside::GoesTheSameWay, Beside::JumpsThere].contains(&beside);
            let result = if needs == beside || needs_there { wide } else { one };
            if block == end {
                cursor.ins().return_(&[result]);
            } else {
                cursor.ins().store(flags, result, address, 8);
                let to = if block == otherwise && beside == Beside::JumpsThere { then } else { end };
                cursor.ins().jump(to, &[]);
            }
        }
        part(&mut func);
        let is_branch = |inst: &Inst| func.dfg.insts[*inst].opcode() == Opcode::Brif;
        let count = func.layout.blocks().map(|block| func.layout.block_insts(block).filter(is_branch).count()).sum();
        let read = func.dfg.value_def(number).inst().and_then(|read| func.layout.inst_block(read));
        (count, read != Some(block))
    }

    #[test]
    fn what_is_nearly_always_true_is_looked_at_last() {
        for (beside, count, moves) in [
            (Beside::Nothing, 2, true),
            (Beside::WritesInFront, 2, true),
            (Beside::WritesBehind, 2, false),
            (Beside::NeedsNumberThen, 2, true),
            (Beside::NeedsNumberOtherwise, 2, false),
            (Beside::NeedsNumberLater, 2, false),
            (Beside::GoesTheSameWay, 2, false),
            (Beside::JumpsThere, 2, false),
        ] {
            assert_eq!(branches(Joins::And, beside, 0x7FFF), (count, moves), "{}", beside as u32);
            // Both ways on which a number below 0 leads may be gone without it.
            let moves = moves && beside != Beside::NeedsNumberThen;
            assert_eq!(branches(Joins::Or, beside, 0), (count, moves), "{}", beside as u32);
        }
        assert_eq!(branches(Joins::And, Beside::Nothing, 0x7FFE), (1, false));
        assert_eq!(branches(Joins::And, Beside::Nothing, 0), (1, false));
        assert_eq!(branches(Joins::Or, Beside::Nothing, 0x7FFF), (1, false));
    }
}
