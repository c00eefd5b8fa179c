//! Editor services as plain data: reference data of a compiled program.
#![forbid(unsafe_code)]

pub mod assignment_list;
pub mod call_structure;
pub mod cross_reference;
mod structured_text;
pub mod target;
pub mod unused;
mod variables;
