//! ST (structured text) and SCL in four dialects: text → syntax → typed tree → IR.

pub mod ast;
pub mod check;
pub mod dialect;
pub mod lower;
pub mod standard;
pub mod tree;
