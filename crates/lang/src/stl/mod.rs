//! STL (statement list, AWL): from text to statements with their meaning.

pub mod ast;
pub(crate) mod body;
pub(crate) mod check;
pub mod convert;
pub(crate) mod counting;
pub(crate) mod declare;
pub mod diagrams;
pub mod extension;
pub mod format;
pub mod heads;
pub mod instructions;
mod lexer;
mod look_alikes;
pub mod lower;
pub mod meaning;
pub mod mnemonics;
pub(crate) mod names;
pub mod operands;
pub mod parser;
pub(crate) mod reason;
pub mod redraw;
pub(crate) mod references;
pub(crate) mod resolve;
pub(crate) mod size;
pub mod syntax;
pub mod why;
pub mod words;

pub use convert::convert;
pub use format::format;
pub use look_alikes::latin;
pub use parser::{Parsed, fuzz, fuzz_diagrams, parse};
