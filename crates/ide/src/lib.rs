//! Editor services as plain data: reference data of a compiled program, pictures of its networks, and what one source says by itself.
#![forbid(unsafe_code)]

pub mod assignment_list;
pub mod call_structure;
pub mod cross_reference;
pub mod drawing;
pub mod tags;
pub mod text;
pub mod unused;

pub use sieben_lang::references::target;
