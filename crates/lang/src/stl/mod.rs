//! STL (statement list, AWL): from text to statements with their meaning.

pub mod ast;
pub(crate) mod check;
pub mod instructions;
pub mod lower;
pub mod meaning;
pub mod operands;
pub(crate) mod resolve;
