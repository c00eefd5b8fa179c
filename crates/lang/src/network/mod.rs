//! Diagrams: what ladder (LAD) and function block diagrams (FBD) both draw, as data, as text, and from and to plain statements.
//!
//! Nothing here knows a language: operands are kept as written, and what they mean is asked of the block that the network stands in.

pub mod boxes;
pub mod elements;
pub mod flavour;
pub mod form_a;
pub mod form_b;
pub mod fuzz;
pub mod memories;
pub mod mistake;
pub mod model;
pub mod operand;
pub mod pin_types;
pub mod read;
pub mod reasons;
pub mod rules;
pub mod statement;
pub mod to_lad;
pub mod write;
