//! Structured Text and SCL: text → syntax → typed tree → IR.

pub mod tree;
