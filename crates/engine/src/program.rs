//! A compiled program: code blocks in IR and data blocks.

use std::collections::BTreeMap;
use std::ops::Range;

use sieben_model::address::{Area, Operand, Width};
use sieben_model::block::{BlockAttributes, BlockId};
use sieben_model::interface::Interface;
use sieben_model::program::DataBlock;
use sieben_model::source::Span;
use sieben_model::types::DataType;
use sieben_model::value::Content;

use crate::ir::{Code, Inst, Place};

/// One code block, compiled.
#[derive(Clone, Debug, Default)]
pub struct CodeBlock {
    /// Its IR, the complete form.
    pub code: Code,
    /// Its declared variables.
    pub interface: Interface,
    /// Bytes of local data it needs, even: declared, hidden and addressed ones; an OB's include the start information.
    pub local_size: u32,
    /// Where each statement of the code comes from.
    pub spans: Vec<Span>,
    /// Values in the local data that are only reached by their constant address, always in this width: position in bits and
    /// width. No pointer, no index and no called block can see them.
    pub private: Vec<(u32, Width)>,
    /// Pieces of the local data that its language hands to called blocks: bits. A pointer to the beginning of one, which the block makes as
    /// a constant, leads no further than to its end.
    pub handed: Vec<Range<u32>>,
    /// Whether its language sees to it that it reads of its local data only what has been written since it began.
    pub reads_own_locals: bool,
    /// How many bytes it has at least on a real CPU, where that is known.
    pub mc7_bytes: Option<u32>,
}

impl CodeBlock {
    /// Where a function of Structured Text keeps its elementary parameters, by their index, in bits of its local data: what its first
    /// statements load through a parameter and store there, and what its last ones store back.
    pub fn copied_parameters(&self) -> BTreeMap<u16, u32> {
        let mut copies = BTreeMap::new();
        for window in self.code.insts.windows(3) {
            let (pointer, index, load, store) = match window {
                [Inst::Parameter { dst, index }, load @ Inst::Load { .. }, store @ Inst::Store { .. }]
                | [load @ Inst::Load { .. }, Inst::Parameter { dst, index }, store @ Inst::Store { .. }] => (dst, index, load, store),
                _ => continue,
            };
            let (Inst::Load { dst, place: from, .. }, Inst::Store { src, place: to, .. }) = (load, store) else { continue };
            let through = |place: &Place| matches!(place, Place::Crossing { pointer: by, offset: 0 } if by == pointer);
            if dst == src
                && let (Place::Fixed { area: Area::Local, position }, other) | (other, Place::Fixed { area: Area::Local, position }) =
                    (from, to)
                && through(other)
            {
                copies.entry(*index).or_insert(*position);
            }
        }
        copies
    }
}

/// Names of the variables of a program that has names without addresses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Names {
    /// Data blocks by name, in lower case.
    pub blocks: BTreeMap<String, u16>,
    /// Data blocks whose fields are called by their names alone; of two fields with one name the one of the first block counts.
    pub open: Vec<u16>,
    /// Variables with an address, in lower case.
    pub located: BTreeMap<String, (Operand, DataType)>,
    /// Constants that need no memory, in lower case; with the block whose statements call them by that name.
    pub constants: BTreeMap<(Option<BlockId>, String), Constant>,
    /// DATE and DT of the sources have 64 bits, as LDATE and LDT have.
    pub short_dates: bool,
}

/// A constant by its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// Its type.
    pub data_type: DataType,
    /// Its value.
    pub content: Content,
}

/// Everything that is loaded into a CPU.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// OBs, FCs and FBs.
    pub code: BTreeMap<BlockId, CodeBlock>,
    /// Data blocks by number.
    pub data: BTreeMap<u16, DataBlock>,
    /// What people call its variables, beside their addresses.
    pub names: Names,
    /// What the headers of its blocks say; nothing of a block without one.
    pub attributes: BTreeMap<BlockId, BlockAttributes>,
}
