//! Kinds and numbers of blocks.

use std::fmt;

/// What kind of block a number belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BlockKind {
    /// Organization block: started by the CPU.
    OrganizationBlock,
    /// Function: a block without memory of its own.
    Function,
    /// Function block: a block with an instance data block.
    FunctionBlock,
    /// Data block.
    DataBlock,
    /// System function, part of the CPU.
    SystemFunction,
    /// System function block, part of the CPU.
    SystemFunctionBlock,
    /// User-defined data type.
    UserDefinedType,
}

impl BlockKind {
    /// All kinds, in the order of the manual.
    pub const ALL: [Self; 7] = [
        Self::OrganizationBlock,
        Self::Function,
        Self::FunctionBlock,
        Self::DataBlock,
        Self::SystemFunction,
        Self::SystemFunctionBlock,
        Self::UserDefinedType,
    ];

    /// The abbreviation, the same in both mnemonic languages.
    pub fn abbreviation(self) -> &'static str {
        match self {
            Self::OrganizationBlock => "OB",
            Self::Function => "FC",
            Self::FunctionBlock => "FB",
            Self::DataBlock => "DB",
            Self::SystemFunction => "SFC",
            Self::SystemFunctionBlock => "SFB",
            Self::UserDefinedType => "UDT",
        }
    }

    /// The kind with this abbreviation, without regard to case.
    pub fn from_abbreviation(text: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.abbreviation().eq_ignore_ascii_case(text))
    }
}

/// A block by kind and number: `FB 12`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BlockId {
    /// What kind of block.
    pub kind: BlockKind,
    /// Its number, 0 to 65535; the CPU type sets tighter limits. Above 32767 an SFC or SFB is shown as a negative one.
    pub number: u16,
}

impl BlockId {
    /// A block of this kind and number.
    pub const fn new(kind: BlockKind, number: u16) -> Self {
        Self { kind, number }
    }
    /// Organization block `number`.
    pub const fn ob(number: u16) -> Self {
        Self::new(BlockKind::OrganizationBlock, number)
    }
    /// Function `number`.
    pub const fn fc(number: u16) -> Self {
        Self::new(BlockKind::Function, number)
    }
    /// Function block `number`.
    pub const fn fb(number: u16) -> Self {
        Self::new(BlockKind::FunctionBlock, number)
    }
    /// Data block `number`.
    pub const fn db(number: u16) -> Self {
        Self::new(BlockKind::DataBlock, number)
    }
}

impl fmt::Display for BlockId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // System blocks of the extension words have negative numbers; no CPU has so many others.
        match crate::extension::is_negative(*self) {
            true => write!(f, "{} {}", self.kind.abbreviation(), self.number as i16),
            false => write!(f, "{} {}", self.kind.abbreviation(), self.number),
        }
    }
}

/// The language that a block was written in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BlockLanguage {
    /// STL, also with a diagram here and there.
    #[default]
    Stl,
    /// All networks are diagrams; the first is a ladder.
    Lad,
    /// All networks are diagrams; the first is a function block diagram.
    Fbd,
    /// SCL of STEP 7 or TIA Portal.
    Scl,
    /// Structured Text of another dialect, or a block that the compiler made for it.
    St,
    /// A data block of the sources.
    Data,
    /// A data block that the program made at run time.
    CreatedData,
}

/// What the header of a block says of it, and its language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BlockAttributes {
    /// TITLE.
    pub title: String,
    /// AUTHOR, as it is written; a CPU keeps eight characters.
    pub author: String,
    /// FAMILY, the same.
    pub family: String,
    /// NAME, the same.
    pub name: String,
    /// VERSION; 0.1 where there is none.
    pub version: (u8, u8),
    /// KNOW_HOW_PROTECT.
    pub know_how_protected: bool,
    /// What it was written in.
    pub language: BlockLanguage,
}

impl BlockAttributes {
    /// Those of a block without a header.
    pub const fn of(language: BlockLanguage) -> Self {
        Self {
            title: String::new(),
            author: String::new(),
            family: String::new(),
            name: String::new(),
            version: (0, 1),
            know_how_protected: false,
            language,
        }
    }
}

impl Default for BlockAttributes {
    fn default() -> Self {
        Self::of(BlockLanguage::Stl)
    }
}
