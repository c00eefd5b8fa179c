//! What a PLC program is: nouns, no behaviour.
#![forbid(unsafe_code)]

pub mod address;
pub mod bcd;
pub mod block;
pub mod cpu_type;
pub mod diagnostic;
pub mod extension;
pub mod format;
pub mod interface;
pub mod item;
pub mod language;
pub mod literal;
pub mod mnemonics;
pub mod name_index;
pub mod nearest;
pub mod origin;
pub mod problems;
pub mod profile;
pub mod program;
pub mod registers;
pub mod source;
pub mod symbols;
pub mod testing;
pub mod types;
pub mod value;
pub mod visible;
