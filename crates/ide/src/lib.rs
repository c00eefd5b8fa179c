//! Editor services as plain data: reference data of a compiled program, pictures of its networks, and what an editor asks of one source and of all.
#![forbid(unsafe_code)]

pub mod assignment_list;
pub mod call_structure;
pub mod cross_reference;
pub mod drawing;
pub mod editing;
pub mod tags;
pub mod text;
pub mod unused;

pub use sieben_lang::references::target;
