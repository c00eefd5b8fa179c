//! What compiler and CPU have to agree on about the extension words of self-checking programs (`__ASSERT==` and its like).
//!
//! Most of what an extension word does is ordinary code. The rest asks the CPU through system functions with negative numbers:
//! -1 to -4 are called by programs, -100 to -102 only by the code of the extension words, the next two by that of GET_ERROR.

use std::fmt;

use crate::block::{BlockId, BlockKind};

/// How two values of an assertion have to stand to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `__ASSERT==`.
    Equal,
    /// `__ASSERT<>`.
    NotEqual,
    /// `__ASSERT<`.
    Less,
    /// `__ASSERT>`.
    Greater,
    /// `__ASSERT<=`.
    LessEqual,
    /// `__ASSERT>=`.
    GreaterEqual,
    /// `__ASSERT==R`: REAL numbers that differ by less than [`REAL_TOLERANCE`].
    EqualReal,
}

/// By how much two REAL numbers may differ that `__ASSERT==R` takes for equal.
pub const REAL_TOLERANCE: f32 = 1e-7;

impl Relation {
    /// All relations; the position of one is its code.
    pub const ALL: [Self; 7] =
        [Self::Equal, Self::NotEqual, Self::Less, Self::Greater, Self::LessEqual, Self::GreaterEqual, Self::EqualReal];

    /// The signs behind `__ASSERT`.
    pub fn signs(self) -> &'static str {
        match self {
            Self::Equal => "==",
            Self::NotEqual => "<>",
            Self::Less => "<",
            Self::Greater => ">",
            Self::LessEqual => "<=",
            Self::GreaterEqual => ">=",
            Self::EqualReal => "==R",
        }
    }

    /// Its number in a call, 0 to 6.
    pub fn code(self) -> u8 {
        Self::ALL.iter().position(|&relation| relation == self).map_or(0, |at| at as u8)
    }

    /// The relation with this code.
    pub fn from_code(code: u8) -> Option<Self> {
        Self::ALL.get(usize::from(code)).copied()
    }

    /// Whether it holds for two byte strings, which compare like words in a dictionary.
    pub fn holds(self, left: &[u8], right: &[u8]) -> bool {
        match self {
            Self::Equal | Self::EqualReal => left == right,
            Self::NotEqual => left != right,
            Self::Less => left < right,
            Self::Greater => left > right,
            Self::LessEqual => left <= right,
            Self::GreaterEqual => left >= right,
        }
    }
}

/// System function `-number`: the numbers of system blocks above 32767 are the negative ones.
const fn negative(kind: BlockKind, number: u16) -> BlockId {
    BlockId::new(kind, number.wrapping_neg())
}

/// Whether a block is one of those with a negative number, which only extended programs may call.
pub fn is_negative(block: BlockId) -> bool {
    matches!(block.kind, BlockKind::SystemFunction | BlockKind::SystemFunctionBlock) && block.number > 0x7FFF
}

/// SFC -1: does nothing and says so (BR = 1).
pub const NOTHING: BlockId = negative(BlockKind::SystemFunction, 1);
/// SFC -2 `__REBOOT`: the startup OB again, memory is kept.
pub const REBOOT: BlockId = negative(BlockKind::SystemFunction, 2);
/// SFC -3 `__SHUTDOWN`: the end of the program.
pub const SHUTDOWN: BlockId = negative(BlockKind::SystemFunction, 3);
/// SFC -4 `__CLKRST`: the clock memory begins anew.
pub const RESTART_CLOCK_MEMORY: BlockId = negative(BlockKind::SystemFunction, 4);
/// SFB -1: does nothing.
pub const NOTHING_WITH_INSTANCE: BlockId = negative(BlockKind::SystemFunctionBlock, 1);
/// What programs call by number or name.
pub const CALLED: [BlockId; 5] = [NOTHING, REBOOT, SHUTDOWN, RESTART_CLOCK_MEMORY, NOTHING_WITH_INSTANCE];
/// Called when an assertion about two values of up to 32 bits is false: [`Compared`] as a word, the left value, the right value.
pub const ASSERTION_FAILED: BlockId = negative(BlockKind::SystemFunction, 100);
/// Compares two byte strings: relation, then pointer to a POINTER and number of bytes of either side.
pub const ASSERT_BYTES: BlockId = negative(BlockKind::SystemFunction, 101);
/// Lets so many milliseconds pass inside the scan: the number.
pub const SLEEP: BlockId = negative(BlockKind::SystemFunction, 102);
/// Called by a block that handles its synchronous errors itself, as its first statement: OB 121 and OB 122 are not called for them.
pub const HANDLE_ERRORS: BlockId = negative(BlockKind::SystemFunction, 103);
/// The first error of such a block since it was asked; the next one counts from now on.
pub const FIRST_ERROR: BlockId = negative(BlockKind::SystemFunction, 104);

/// A relation with the widths of its sides, as one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Compared {
    /// The relation.
    pub relation: Relation,
    /// Bits of the left and the right value: 1, 8, 16 or 32.
    pub bits: [u8; 2],
}

impl Compared {
    /// As a number.
    pub fn to_word(self) -> u32 {
        u32::from_be_bytes([0, self.bits[1], self.bits[0], self.relation.code()])
    }
    /// From its number.
    pub fn from_word(word: u32) -> Option<Self> {
        let [_, right, left, code] = word.to_be_bytes();
        Some(Self { relation: Relation::from_code(code)?, bits: [left, right] })
    }
}

/// One side of an assertion that was false.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Side {
    /// A number of 1, 8, 16 or 32 bits.
    Number {
        /// The number.
        value: u32,
        /// Its bits.
        bits: u8,
    },
    /// A REAL, by its bits.
    Real(u32),
    /// Anything longer.
    Bytes(Vec<u8>),
}

/// Bytes of a long value that are shown.
const BYTES_SHOWN: usize = 32;

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number { value, bits: 1 } => write!(f, "{value}"),
            Self::Number { value, bits } => write!(f, "{value} (16#{value:0width$X})", width = usize::from(bits / 4)),
            Self::Real(bits) => write!(f, "{:?}", f32::from_bits(*bits)),
            Self::Bytes(bytes) => {
                f.write_str("B#16#")?;
                for byte in bytes.iter().take(BYTES_SHOWN) {
                    write!(f, "{byte:02X}")?;
                }
                if bytes.len() > BYTES_SHOWN {
                    write!(f, "… ({} bytes)", bytes.len())?;
                }
                Ok(())
            }
        }
    }
}

/// An assertion that was false.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FailedAssertion {
    /// What should have held.
    pub relation: Relation,
    /// The value on the left.
    pub left: Side,
    /// The value on the right.
    pub right: Side,
}

impl fmt::Display for FailedAssertion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let wanted = match self.relation {
            Relation::EqualReal => "==",
            relation => relation.signs(),
        };
        write!(f, "expected {} {wanted} {}", self.left, self.right)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_and_words_come_back() {
        for relation in Relation::ALL {
            assert_eq!(Relation::from_code(relation.code()), Some(relation));
            let compared = Compared { relation, bits: [1, 32] };
            assert_eq!(Compared::from_word(compared.to_word()), Some(compared));
        }
        assert_eq!(Relation::from_code(7), None);
        assert_eq!(Compared::from_word(0xFF), None);
    }

    #[test]
    fn negative_numbers_are_shown_as_such() {
        assert_eq!(NOTHING.to_string(), "SFC -1");
        assert_eq!(NOTHING_WITH_INSTANCE.to_string(), "SFB -1");
        assert!(is_negative(SLEEP) && !is_negative(BlockId::new(BlockKind::SystemFunction, 46)) && !is_negative(BlockId::fc(65_535)));
    }

    #[test]
    fn values_are_shown_in_their_width() {
        let failed = |bits| FailedAssertion {
            relation: Relation::Equal,
            left: Side::Number { value: 5, bits },
            right: Side::Number { value: 1, bits },
        };
        assert_eq!(failed(16).to_string(), "expected 5 (16#0005) == 1 (16#0001)");
        assert_eq!(failed(1).to_string(), "expected 5 == 1");
        assert_eq!(Side::Real(1.5f32.to_bits()).to_string(), "1.5");
        assert_eq!(Side::Bytes(vec![1; 40]).to_string(), format!("B#16#{}… (40 bytes)", "01".repeat(32)));
    }
}
