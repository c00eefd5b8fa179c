//! STL (statement list, AWL): from text to statements with their meaning.

pub mod ast;
pub mod instructions;
pub mod lower;
pub mod meaning;
pub mod operands;
