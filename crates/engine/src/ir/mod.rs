//! The intermediate representation: one typed three-address code for every language.

pub mod builder;
pub mod code;
pub mod ops;
pub mod text;
pub mod verify;

pub use builder::Builder;
pub use code::{Callee, Code, DataRegister, Inst, OnFault, Place, Target, TextAction, TextRoom, Var};
pub use ops::Op;
pub use verify::verify;
