//! ST (structured text) and SCL in four dialects: text → syntax → typed tree → IR.

pub mod ast;
pub mod check;
pub mod declare;
pub mod dialect;
mod keywords;
mod lexer;
mod literals;
pub mod lower;
pub mod parser;
pub mod standard;
pub mod syntax;
pub mod tree;

pub use dialect::Dialect;
pub use parser::{Parsed, parse};
