//! Functions of texts that callers write out: what each does is a piece of a text, then others behind it, or the digits of a number.
//!
//! The blocks of the library do the same, for programs that call them as blocks; a test compares both.

use sieben_model::types::STRING_LENGTH_MAX;

use super::Provided;
use crate::st::dialect::Dialect;
use crate::st::tree::TextRoom;

/// A function of texts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextFunction {
    /// What it does.
    pub action: TextAction,
    /// What it does with numbers that name no characters.
    pub manner: Manner,
    /// Whether its texts are WSTRINGs.
    pub wide: bool,
}

/// What a function of texts does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // The names are those of the functions.
pub enum TextAction {
    Left,
    Right,
    Mid,
    Concat,
    Insert,
    Delete,
    Replace,
    Find,
    /// The digits of a number without a sign.
    Unsigned,
    /// The digits of a number with its sign: `-` in front of a negative one; of the S7 library `+` in front of the others.
    Signed,
    /// The characters of a REAL; of the S7 library with an exponent.
    Real,
    /// The characters of an LREAL.
    LongReal,
    /// The number that a text spells.
    Number,
}

/// Whose function it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Manner {
    /// The S7 library.
    S7,
    /// IEC 61131-3, where the S7 library does something else.
    Iec,
    /// TIA, where the S7 library does something else.
    Tia,
    /// CODESYS: without errors.
    Codesys,
}

/// The block of each function.
const BLOCKS: &[(&str, TextAction, Manner)] = &[
    ("LEFT", TextAction::Left, Manner::S7),
    ("RIGHT", TextAction::Right, Manner::S7),
    ("MID", TextAction::Mid, Manner::S7),
    ("CONCAT", TextAction::Concat, Manner::S7),
    ("INSERT", TextAction::Insert, Manner::S7),
    ("DELETE", TextAction::Delete, Manner::S7),
    ("REPLACE", TextAction::Replace, Manner::S7),
    ("FIND", TextAction::Find, Manner::S7),
    ("IEC_DELETE", TextAction::Delete, Manner::Iec),
    ("IEC_REPLACE", TextAction::Replace, Manner::Iec),
    ("TIA_REPLACE", TextAction::Replace, Manner::Tia),
    ("CODESYS_LEFT", TextAction::Left, Manner::Codesys),
    ("CODESYS_RIGHT", TextAction::Right, Manner::Codesys),
    ("CODESYS_MID", TextAction::Mid, Manner::Codesys),
    ("CODESYS_CONCAT", TextAction::Concat, Manner::Codesys),
    ("CODESYS_INSERT", TextAction::Insert, Manner::Codesys),
    ("CODESYS_DELETE", TextAction::Delete, Manner::Codesys),
    ("CODESYS_REPLACE", TextAction::Replace, Manner::Codesys),
    ("CODESYS_FIND", TextAction::Find, Manner::Codesys),
    ("I_STRNG", TextAction::Signed, Manner::S7),
    ("DI_STRNG", TextAction::Signed, Manner::S7),
    ("LINT_TO_STRING", TextAction::Signed, Manner::Iec),
    ("ULINT_TO_STRING", TextAction::Unsigned, Manner::Iec),
    ("TIA_LINT_TO_STRING", TextAction::Signed, Manner::S7),
    ("R_STRNG", TextAction::Real, Manner::S7),
    ("REAL_TO_STRING", TextAction::Real, Manner::Iec),
    ("LREAL_TO_STRING", TextAction::LongReal, Manner::Iec),
    ("STRNG_I", TextAction::Number, Manner::S7),
    ("STRNG_DI", TextAction::Number, Manner::S7),
    ("STRNG_R", TextAction::Number, Manner::S7),
    ("STRING_TO_SINT", TextAction::Number, Manner::Iec),
    ("STRING_TO_INT", TextAction::Number, Manner::Iec),
    ("STRING_TO_DINT", TextAction::Number, Manner::Iec),
    ("STRING_TO_USINT", TextAction::Number, Manner::Iec),
    ("STRING_TO_UINT", TextAction::Number, Manner::Iec),
    ("STRING_TO_UDINT", TextAction::Number, Manner::Iec),
    ("STRING_TO_ULINT", TextAction::Number, Manner::Iec),
    ("STRING_TO_LINT", TextAction::Number, Manner::Iec),
    ("STRING_TO_BYTE", TextAction::Number, Manner::Iec),
    ("STRING_TO_WORD", TextAction::Number, Manner::Iec),
    ("STRING_TO_DWORD", TextAction::Number, Manner::Iec),
    ("STRING_TO_LWORD", TextAction::Number, Manner::Iec),
    ("STRING_TO_REAL", TextAction::Number, Manner::Iec),
    ("STRING_TO_LREAL", TextAction::Number, Manner::Iec),
];

impl TextFunction {
    /// What a block of the library does, if callers write it out. Who names a block that has another name than its function calls it.
    pub fn of(provided: &Provided, called: &str, dialect: Dialect) -> Option<Self> {
        let name = match provided {
            Provided::Library(block) => block.name,
            Provided::Source { name, .. } => name,
            Provided::System(_) => return None,
        };
        // The blocks of conversions have the names of functions.
        let function = Self::of_block(name)?;
        let by_its_name = matches!(provided, Provided::Source { .. }) && name.eq_ignore_ascii_case(called);
        let manner = match function.action {
            // Blocks with the same name read texts in both manners.
            TextAction::Number if dialect.base() == Dialect::Codesys => Manner::Codesys,
            _ => function.manner,
        };
        (!by_its_name || function.converts()).then_some(Self { manner, ..function })
    }

    /// What the block with this name does, if callers write it out.
    pub fn of_block(name: &str) -> Option<Self> {
        let (_, action, manner) = BLOCKS.iter().find(|(block, ..)| *block == name)?;
        Some(Self { action: *action, manner: *manner, wide: false })
    }

    /// What its result has room for.
    pub fn result_room(self) -> TextRoom {
        TextRoom { characters_max: STRING_LENGTH_MAX.into(), wide: self.wide }
    }

    /// How many texts and numbers it takes.
    pub fn arity(self) -> (usize, usize) {
        match self.action {
            TextAction::Left | TextAction::Right => (1, 1),
            TextAction::Mid | TextAction::Delete => (1, 2),
            TextAction::Concat | TextAction::Find => (2, 0),
            TextAction::Insert => (2, 1),
            TextAction::Replace => (2, 2),
            TextAction::Unsigned | TextAction::Signed | TextAction::Real | TextAction::LongReal => (0, 1),
            TextAction::Number => (1, 0),
        }
    }

    /// Whether it makes a text of a number, or a number of a text.
    pub fn converts(self) -> bool {
        self.arity().0 == 0 || self.action == TextAction::Number
    }

    /// Whether it makes one piece of its text, or of a number: everything is read before anything is written.
    pub fn makes_one_piece(self) -> bool {
        self.cuts() || self.arity().0 == 0
    }

    /// Whether its result is a piece of its text.
    pub fn cuts(self) -> bool {
        matches!(self.action, TextAction::Left | TextAction::Right | TextAction::Mid)
    }
}
