//! Instructions of the IR.
//!
//! A variable is a CPU register or a temporary. Temporaries live inside one statement; a call, or a
//! load that may fail, keeps only registers and its own result. Whatever may fail comes before the
//! first register that the statement changes, so that a failed statement counts as NOP.

use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use super::ops::Op;
use crate::intrinsics::Intrinsic;
use crate::machine::Register;

/// A register or a temporary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Var(pub u8);

impl Var {
    /// The `n`th temporary.
    pub fn temporary(n: usize) -> Option<Self> {
        u8::try_from(Register::COUNT + n).ok().map(Self)
    }
    /// The register, if it is one.
    pub fn register(self) -> Option<Register> {
        Register::ALL.get(usize::from(self.0)).copied()
    }
}

impl From<Register> for Var {
    fn from(register: Register) -> Self {
        Self(register as u8)
    }
}

/// A statement of the same block, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Target(pub u32);

/// The two data block registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DataRegister {
    /// DB: the shared data block.
    Shared,
    /// DI: the instance data block.
    Instance,
}

/// Where a load or store goes. Positions are in bits: byte × 8 + bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// A constant address; DB and DI mean the open block.
    Fixed {
        /// Which area.
        area: Area,
        /// The position.
        position: u32,
    },
    /// An address computed at run time in a known area: `MW[MD 4]`, `MW[AR1,P#2.0]`, a variable of an instance (`DIX[AR2,P#n]`).
    Indirect {
        /// Which area.
        area: Area,
        /// Holds an area-internal pointer; its area part is ignored.
        pointer: Var,
        /// Added to the pointer.
        offset: u32,
    },
    /// An address whose area is in the pointer too: `W[AR1,P#2.0]`, a parameter of an FC.
    Crossing {
        /// Holds an area-crossing pointer. In a move or a text instruction bits 32 to 47 may hold the number of the data block that
        /// a pointer into a shared data block means; 0 = the open one.
        pointer: Var,
        /// Added to the pointer.
        offset: u32,
    },
}

impl Place {
    /// The place `bytes` further on.
    #[must_use]
    pub fn moved(self, bytes: u32) -> Self {
        let by = |position: u32| position.saturating_add(bytes.saturating_mul(8));
        match self {
            Self::Fixed { area, position } => Self::Fixed { area, position: by(position) },
            Self::Indirect { area, pointer, offset } => Self::Indirect { area, pointer, offset: by(offset) },
            Self::Crossing { pointer, offset } => Self::Crossing { pointer, offset: by(offset) },
        }
    }
}

/// What a failed load does after the Host let it go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OnFault {
    /// The whole statement counts as NOP.
    SkipStatement,
    /// The same, and the load is part of a write: it fails with the codes of a write.
    SkipWrite,
    /// The load counts as done, with 0 or the Host's value.
    DeliverZero,
}

/// How a text lies in memory, and how many of its characters count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct TextRoom {
    /// The greatest number of characters that count; 0 = as the text itself says.
    pub characters_max: u16,
    /// Whether both lengths and the characters are words (WSTRING) instead of bytes (STRING).
    pub wide: bool,
}

impl TextRoom {
    /// The eight bytes of a number that was read from a text.
    pub const NUMBER: Self = Self::narrow(6);

    /// A STRING.
    #[must_use]
    pub const fn narrow(characters_max: u8) -> Self {
        Self { characters_max: characters_max as u16, wide: false }
    }
    /// A WSTRING.
    #[must_use]
    pub const fn wide(characters_max: u16) -> Self {
        Self { characters_max, wide: true }
    }
    /// The same width, and the text itself says how many characters count.
    #[must_use]
    pub const fn unknown(self) -> Self {
        Self { characters_max: 0, ..self }
    }
    /// Whether the text itself says how many characters count.
    #[must_use]
    pub const fn is_unknown(self) -> bool {
        self.characters_max == 0
    }
    /// Bytes of a character, and of each of both lengths.
    #[must_use]
    pub const fn unit(self) -> u32 {
        if self.wide { 2 } else { 1 }
    }
    /// Bytes before the characters: the greatest and the actual length.
    #[must_use]
    pub const fn head(self) -> u32 {
        2 * self.unit()
    }
    /// Bytes that the text takes at most.
    #[must_use]
    pub const fn bytes(self) -> u32 {
        let most = match (self.characters_max, self.wide) {
            (0, false) => u8::MAX as u32,
            (0, true) => u16::MAX as u32,
            (count, _) => count as u32,
        };
        self.head() + most * self.unit()
    }
}

/// What a text instruction does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TextAction {
    /// Writes `from` to `to`, both lengths too, cut to the room there; the result is 1 if it was cut, or if it has characters that a
    /// STRING does not know, for each of which it gets `?`. Where the room is unknown, the greatest length of `to` stays.
    Assign,
    /// The order of `to` and `from` by the codes of their characters: −1, 0 or 1 in 32 bits; a shorter text comes before a longer
    /// one that begins with it.
    Compare,
    /// The number of characters of `from`.
    Length,
    /// Where the characters of `from` stand in `to` first, counted from 1; 0 if they do not, or if there are none.
    Find,
    /// Writes a piece of `from` to `to`, both length bytes too, cut to the room there. `piece` holds the first character, counted from 0,
    /// and how many, in 32 bits with a sign: a negative number is 0, and what is not there does not count. The result is how many there are, before they are cut.
    Piece,
    /// The same behind the characters that `to` has.
    Append,
    /// Writes the decimal digits of an unsigned number to `to`, both lengths too, cut to the room there. The first of `piece` is the
    /// number, with 64 bits; `from` does not count. The result is how many characters there are, before they are cut.
    Unsigned,
    /// The same for a number with a sign, which stands in front of a negative one.
    Signed,
    /// The same, with a sign in front of every number.
    SignedAlways,
    /// The same for a REAL: as few digits as bring it back, always with a point.
    Real,
    /// The same for an LREAL.
    LongReal,
    /// The same for a REAL as the S7 library writes it, always fourteen characters; none if it is no number.
    RealS7,
    /// Writes the number that the characters of `from` spell to the eight bytes at `to`, which are no text: in the width of its type, and
    /// 0 behind it. The first of `piece` is a [`NumberForm`](crate::numbers_in_texts::NumberForm). The result is 1 if they spell one of that type.
    Number,
}

impl TextAction {
    /// All of them, in their order.
    pub const ALL: [Self; 13] = [
        Self::Assign,
        Self::Compare,
        Self::Length,
        Self::Find,
        Self::Piece,
        Self::Append,
        Self::Unsigned,
        Self::Signed,
        Self::SignedAlways,
        Self::Real,
        Self::LongReal,
        Self::RealS7,
        Self::Number,
    ];

    /// Whether it writes to `to`.
    pub fn writes(self) -> bool {
        matches!(self, Self::Assign | Self::Piece | Self::Append | Self::Number) || self.takes_number()
    }
    /// Whether it takes a piece, or a number in its place.
    pub fn takes_piece(self) -> bool {
        matches!(self, Self::Piece | Self::Append | Self::Number) || self.takes_number()
    }
    /// Whether it takes a number.
    pub fn takes_number(self) -> bool {
        matches!(self, Self::Unsigned | Self::Signed | Self::SignedAlways | Self::Real | Self::LongReal | Self::RealS7)
    }
    /// What it takes, in one word: a number, or the first character of a piece in the low half and how many in the high half.
    pub fn word(self, piece: [u64; 2]) -> u64 {
        if self.takes_number() { piece[0] } else { piece[0] & 0xFFFF_FFFF | piece[1] << 32 }
    }
}

/// The block that a call enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Callee {
    /// Known when the program is compiled.
    Block(BlockId),
    /// Kind known, number computed: `UC FC [MW 10]`.
    Number(BlockKind, Var),
}

/// One instruction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // The fields are named in the sentence of each variant.
pub enum Inst {
    /// `dst := value`.
    Constant { dst: Var, value: u64 },
    /// `dst := op(args)`; only the first `op.arity()` arguments count.
    Compute { op: Op, dst: Var, args: [Var; 4] },
    /// `dst := memory`, zero-extended.
    Load { dst: Var, place: Place, width: Width, on_fault: OnFault },
    /// `memory := src`, its low bits.
    Store { place: Place, width: Width, src: Var },
    /// `memory := memory`, so many bytes; both places are known to be bytes.
    Move { from: Place, to: Place, bytes: u32 },
    /// Works on two texts, STRINGs or WSTRINGs. `to_room` and `from_room` limit their characters.
    Text { action: TextAction, dst: Var, to: Place, to_room: TextRoom, from: Place, from_room: TextRoom, piece: [Var; 2] },
    /// `dst := pointer` that the caller gave for parameter `index` of an FC.
    Parameter { dst: Var, index: u16 },
    /// Gives the pointer of the next parameter to the call that follows.
    PassParameter { src: Var },
    /// `dst := result` of a function over the machine (0 if it has none).
    Intrinsic { dst: Var, intrinsic: Intrinsic, args: [Var; 4] },
    /// Fails with programming error `code` (FLT_REG = `register`) unless the condition holds; with [`crate::fault::NOTED`] in the
    /// code the error is told and the statement goes on.
    Require { condition: Var, code: u8, register: Var },
    /// Aborts the block unless the condition holds.
    RequireStack { condition: Var, abort: crate::fault::Abort },
    /// Opens the data block with this number; 0 closes the register.
    Open { register: DataRegister, number: Var },
    /// Goes on at the statement.
    Jump { to: Target },
    /// Goes on at the statement if the condition is 1.
    Branch { condition: Var, to: Target },
    /// Goes on at `tables[first + index]`, or at `otherwise` if `index >= count`.
    JumpTable { index: Var, first: u32, count: u32, otherwise: Target },
    /// Enters a block with the parameters passed before; goes on behind this instruction when it ends.
    Call { callee: Callee, parameters: u16 },
    /// Ends the block. Behind the call OS = 0, OR = 0, STA = 1, /FC = 0; DB, DI, MA and the nesting stack are the caller's.
    Return,
}

/// The code of one block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Code {
    /// The instructions of all statements, one after another.
    pub insts: Vec<Inst>,
    /// The first instruction of each statement; a last entry marks the end.
    pub statements: Vec<u32>,
    /// Targets of all jump tables.
    pub tables: Vec<Target>,
}

impl Code {
    /// Number of statements.
    pub fn statement_count(&self) -> usize {
        self.statements.len().saturating_sub(1)
    }
    /// The instructions of a statement.
    pub fn statement(&self, index: usize) -> &[Inst] {
        &self.insts[self.statements[index] as usize..self.statements[index + 1] as usize]
    }
}
