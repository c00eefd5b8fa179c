//! Names of blocks as STL writes them.

use sieben_model::address::Operand;
use sieben_model::block::BlockId;

use crate::scope::{Global, Scope, did_you_mean};
use crate::stl::ast;

/// The block that a header or operand names; `Err` is the message of why there is none.
pub(crate) fn block_of_name(scope: &Scope, name: &ast::BlockName) -> Result<BlockId, String> {
    match name {
        ast::BlockName::Absolute { kind, number, .. } => match u16::try_from(*number) {
            Ok(number) => Ok(BlockId::new(*kind, number)),
            Err(_) => Err(format!("`{} {number}` has a number above 65535", kind.abbreviation())),
        },
        ast::BlockName::Symbol(word) => match scope.global(&word.text) {
            None => Err(format!("`\"{}\"` is not in the symbol table{}", word.text, did_you_mean(scope.nearest_symbol(&word.text)))),
            Some(Global { operand: Some(Operand::Block(block)), .. }) => Ok(*block),
            Some(global) => Err(format!("`\"{}\"` stands for `{}`, which is not a block", word.text, global.address)),
        },
    }
}
