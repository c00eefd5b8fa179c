//! ST (structured text) and SCL in four dialects: text → syntax → typed tree → IR.

pub mod ast;
pub(crate) mod body;
pub mod check;
pub mod declare;
pub mod diagrams;
pub mod dialect;
mod dtl;
mod error_struct;
pub mod format;
mod keywords;
mod lexer;
mod literals;
pub mod lower;
pub(crate) mod names;
pub mod objects;
mod open_arrays;
pub mod parser;
mod points;
pub(crate) mod reason;
pub(crate) mod references;
pub mod standard;
pub mod syntax;
pub mod tree;
mod type_class;
pub(crate) mod untold;
mod variants;
pub mod words;

pub use dialect::Dialect;
pub use format::format;
pub use parser::{Parsed, fuzz, parse};
