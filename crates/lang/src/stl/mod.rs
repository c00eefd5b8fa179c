//! STL (statement list, AWL): from text to statements with their meaning.

pub mod ast;
<<<<<<< HEAD
pub mod convert;
pub mod format;
=======
pub(crate) mod check;
>>>>>>> main
pub mod instructions;
mod lexer;
pub mod lower;
pub mod meaning;
pub mod mnemonics;
pub mod operands;
<<<<<<< HEAD
pub mod parser;
pub mod syntax;

pub use convert::convert;
pub use format::format;
pub use parser::{Parsed, fuzz, parse};
=======
pub(crate) mod resolve;
>>>>>>> main
