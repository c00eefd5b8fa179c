//! From resolved statements to IR.

use sieben_engine::CodeBlock;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::interface::Interface;
use sieben_model::source::Span;

use super::instructions::Instruction;
use super::operands::Operand;

/// One statement with all names resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Which instruction.
    pub instruction: Instruction,
    /// Its operand.
    pub operand: Operand,
    /// The whole statement without its label.
    pub span: Span,
    /// Its network, counted from 1.
    pub network: u32,
}

/// A code block whose statements are resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct ResolvedBlock {
    /// `FC 1`.
    pub id: BlockId,
    /// Its declarations.
    pub interface: Interface,
    /// Its statements.
    pub statements: Vec<Statement>,
}

/// The IR of a block for a CPU type.
pub fn lower(block: &ResolvedBlock, cpu: &CpuType) -> CodeBlock {
    let _ = (block, cpu);
    CodeBlock::default()
}
