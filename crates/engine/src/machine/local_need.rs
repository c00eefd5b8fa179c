//! How much local data a program can use.

use std::collections::BTreeMap;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;

use crate::ir::{Callee, Inst};
use crate::program::Program;

/// Bytes that the start information of an organization block takes, whatever it declares.
const START_INFORMATION: usize = 20;

/// Bytes of local data that all priority classes of a program use together at most: each of its organization blocks once, with the deepest
/// calls that the CPU type allows, and in each an organization block of a synchronous error; beside them one block that the Host may enter.
/// Of a program whose code the engine has from elsewhere nothing is known.
pub(super) fn at_most(cpu: &CpuType, program: &Program) -> usize {
    if program.code.is_empty() {
        return usize::MAX;
    }
    let of_blocks = needs(cpu, program);
    let other = of_blocks.iter().filter(|(block, _)| block.kind != BlockKind::OrganizationBlock).map(|(_, &need)| need).max().unwrap_or(0);
    let organization_blocks = of_blocks.iter().filter(|(block, _)| block.kind == BlockKind::OrganizationBlock);
    let (errors, classes): (Vec<_>, Vec<_>) = organization_blocks.partition(|(block, _)| super::is_error_block(**block));
    let error = errors.into_iter().map(|(_, &need)| need).max().unwrap_or(0);
    let all = classes.into_iter().fold(other, |all, (_, &need)| all.saturating_add(need).saturating_add(error));
    all.max(START_INFORMATION)
}

/// What each block needs with the deepest calls out of it.
fn needs(cpu: &CpuType, program: &Program) -> BTreeMap<BlockId, usize> {
    let own: BTreeMap<BlockId, usize> = program.code.iter().map(|(&block, code)| (block, own(block, code.local_size))).collect();
    let callees: BTreeMap<BlockId, Vec<Callee>> = program.code.iter().map(|(&block, code)| (block, callees(&code.code.insts))).collect();
    let mut needs = own.clone();
    // Each round has chains of one block more; deeper ones than the CPU type allows end in STOP.
    for _ in 0..usize::from(cpu.nesting_depth) + usize::from(cpu.nesting_depth_error) + 1 {
        let mut greatest: BTreeMap<BlockKind, usize> = BTreeMap::new();
        for (block, &need) in &needs {
            let of_kind = greatest.entry(block.kind).or_default();
            *of_kind = need.max(*of_kind);
        }
        let deepest = |callee: &Callee| match callee {
            Callee::Block(block) => needs.get(block).copied().unwrap_or(0),
            Callee::Number(kind, _) => greatest.get(kind).copied().unwrap_or(0),
        };
        let next: BTreeMap<BlockId, usize> = callees
            .iter()
            .map(|(block, callees)| (*block, own[block].saturating_add(callees.iter().map(deepest).max().unwrap_or(0))))
            .collect();
        if next == needs {
            break;
        }
        needs = next;
    }
    needs
}

fn own(block: BlockId, local_size: u32) -> usize {
    let least = if block.kind == BlockKind::OrganizationBlock { START_INFORMATION } else { 0 };
    (local_size as usize).max(least)
}

fn callees(insts: &[Inst]) -> Vec<Callee> {
    let callee = |inst: &Inst| match inst {
        Inst::Call { callee, .. } => Some(*callee),
        _ => None,
    };
    insts.iter().filter_map(callee).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::Builder;
    use crate::program::CodeBlock;

    /// A block with so much local data that calls these.
    fn block(local_size: u32, calls: &[Callee]) -> CodeBlock {
        let mut builder = Builder::default();
        builder.begin_statement();
        for &callee in calls {
            builder.push(Inst::Call { callee, parameters: 0 });
        }
        CodeBlock { code: builder.finish(), local_size, ..CodeBlock::default() }
    }

    #[test]
    fn the_deepest_chain_of_each_organization_block_counts_once() {
        let fc = |number| Callee::Block(BlockId::fc(number));
        let code = [
            (BlockId::ob(1), block(30, &[fc(1), fc(2)])),
            (BlockId::ob(35), block(0, &[fc(2)])),
            (BlockId::fc(1), block(100, &[fc(2)])),
            (BlockId::fc(2), block(8, &[])),
            (BlockId::fc(3), block(5000, &[])),
        ];
        let mut program = Program { code: code.into(), ..Program::default() };
        let cpu = &CpuType::ALL[0];
        assert_eq!(at_most(cpu, &program), 30 + 100 + 8 + 20 + 8 + 5000, "FC 3 is not called");
        // An error can come in each of both classes.
        program.code.insert(BlockId::ob(121), block(40, &[fc(2)]));
        assert_eq!(at_most(cpu, &program), 138 + 28 + 2 * 48 + 5000);
    }

    #[test]
    fn calls_that_are_not_known_and_calls_in_circles_are_as_deep_as_the_cpu_type_allows() {
        let cpu = &CpuType::ALL[0];
        let depth = usize::from(cpu.nesting_depth);
        let circle =
            [(BlockId::ob(1), block(20, &[Callee::Block(BlockId::fc(1))])), (BlockId::fc(1), block(100, &[Callee::Block(BlockId::fc(1))]))];
        let need = at_most(cpu, &Program { code: circle.into(), ..Program::default() });
        assert!(need >= 20 + depth * 100, "{need}");
        let mut builder = Builder::default();
        builder.begin_statement();
        let number = builder.temporary();
        builder.push(Inst::Call { callee: Callee::Number(BlockKind::Function, number), parameters: 0 });
        let indirect = CodeBlock { code: builder.finish(), local_size: 20, ..CodeBlock::default() };
        let code = [(BlockId::ob(1), indirect), (BlockId::fc(7), block(700, &[]))];
        assert_eq!(at_most(cpu, &Program { code: code.into(), ..Program::default() }), 720 + 700);
        assert_eq!(at_most(cpu, &Program::default()), usize::MAX);
    }
}
