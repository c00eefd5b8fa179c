//! What compiler, CPU and runner agree on about unit tests (`*.test.st`).
//!
//! Each test becomes an organization block that the CPU never calls by itself. The words of tests (`ASSERT_EQ`, `SCAN` …) become calls
//! of system functions with negative numbers; what a call means stands in the [`TestPlan`], by the place of the word in the source.

use std::collections::{BTreeMap, BTreeSet};

use crate::address::Address;
use crate::block::{BlockId, BlockKind};
use crate::source::Span;
use crate::types::DataType;

/// The organization block of the first test; those of the others follow, then that of TEARDOWN.
pub const FIRST_TEST_BLOCK: u16 = 0x8000;
/// Tests that one file may have: each is a function block, of which a CPU type has numbers for 8,000, and the program needs some.
pub const TESTS_MAX: usize = 5_000;

/// Asked at every word of a test: the row ([`TestPlan::words`]), whether an assertion holds, up to three values.
pub const WORD: BlockId = BlockId::new(BlockKind::SystemFunction, 110_u16.wrapping_neg());
/// Asked when an assertion about two texts does not hold: the row, both texts.
pub const TEXTS: BlockId = BlockId::new(BlockKind::SystemFunction, 111_u16.wrapping_neg());
/// Asked at the beginning of every block that a test of the file may mock: the answer (a byte) says whether its statements are left out.
pub const MOCKED: BlockId = BlockId::new(BlockKind::SystemFunction, 112_u16.wrapping_neg());
/// Sets a peripheral input: its byte address, its bytes (1, 2 or 4), the value.
pub const SET_INPUT: BlockId = BlockId::new(BlockKind::SystemFunction, 113_u16.wrapping_neg());
/// Holds inputs at the value that the process image has: its first bit, its bits.
pub const HOLD_INPUT: BlockId = BlockId::new(BlockKind::SystemFunction, 114_u16.wrapping_neg());

/// By how much `ASSERT_NEAR` lets two numbers differ if nothing is said.
pub const TOLERANCE: f64 = 1e-6;

macro_rules! words {
    ($( $Name:ident $word:literal $least:literal $most:literal $message:literal $use_:literal; )*) => {
        /// A word of test files.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[allow(missing_docs)] // The rows say it.
        pub enum Word { $( $Name, )* }

        impl Word {
            /// All words.
            pub const ALL: &[Self] = &[$(Self::$Name),*];
            /// As it is written.
            pub fn text(self) -> &'static str { match self { $(Self::$Name => $word),* } }
            /// How it is used, for messages.
            pub fn usage(self) -> &'static str { match self { $(Self::$Name => $use_),* } }
            /// How many parameters it takes, least and most, without a message.
            pub fn parameters(self) -> (usize, usize) { match self { $(Self::$Name => ($least, $most)),* } }
            /// Whether it takes a message as its last parameter.
            pub fn takes_message(self) -> bool { match self { $(Self::$Name => $message),* } }
        }
    };
}

#[rustfmt::skip] // A table.
words! {
    AssertTrue "ASSERT_TRUE"                 1 1 true  "ASSERT_TRUE(a)";
    AssertFalse "ASSERT_FALSE"               1 1 true  "ASSERT_FALSE(a)";
    AssertEqual "ASSERT_EQ"                  2 2 true  "ASSERT_EQ(a, b)";
    AssertNotEqual "ASSERT_NEQ"              2 2 true  "ASSERT_NEQ(a, b)";
    AssertGreater "ASSERT_GT"                2 2 true  "ASSERT_GT(a, b)";
    AssertGreaterEqual "ASSERT_GE"           2 2 true  "ASSERT_GE(a, b)";
    AssertLess "ASSERT_LT"                   2 2 true  "ASSERT_LT(a, b)";
    AssertLessEqual "ASSERT_LE"              2 2 true  "ASSERT_LE(a, b)";
    AssertNear "ASSERT_NEAR"                 2 3 true  "ASSERT_NEAR(a, b, tolerance)";
    Scan "SCAN"                              0 1 false "SCAN(n)";
    AdvanceTime "ADVANCE_TIME"               1 1 false "ADVANCE_TIME(T#5s)";
    Start "START"                            0 0 false "START()";
    Stop "STOP"                              0 0 false "STOP()";
    ExpectStop "EXPECT_STOP"                 0 1 false "EXPECT_STOP(16#4562)";
    Mock "MOCK"                              1 1 false "MOCK instance;";
    MockFunction "MOCK_FUNCTION"             1 2 false "MOCK_FUNCTION name RETURNS value;";
    VerifyCalled "MOCK_VERIFY_CALLED"        1 1 true  "MOCK_VERIFY_CALLED(name)";
    VerifyCallCount "MOCK_VERIFY_CALL_COUNT" 2 2 true  "MOCK_VERIFY_CALL_COUNT(name, n)";
}

impl Word {
    /// The word with this spelling, without regard to case.
    pub fn find(text: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|word| word.text().eq_ignore_ascii_case(text))
    }
    /// The sign between both values of an assertion that compares.
    pub fn sign(self) -> Option<&'static str> {
        Some(match self {
            Self::AssertEqual => "=",
            Self::AssertNotEqual => "<>",
            Self::AssertGreater => ">",
            Self::AssertGreaterEqual => ">=",
            Self::AssertLess => "<",
            Self::AssertLessEqual => "<=",
            Self::AssertNear => "≈",
            _ => return None,
        })
    }
}

/// A value that a word of a test is given.
#[derive(Clone, Debug, PartialEq)]
pub struct Operand {
    /// Where it is written.
    pub span: Span,
    /// Its type; `None` = a constant without a type: its text says the value.
    pub data_type: Option<DataType>,
    /// Bytes that the value is handed over in: 1, 2, 4 or 8; those of the type, or more where a dialect computes with more.
    pub bytes: u8,
}

/// A variable that the expression of an assertion reads.
#[derive(Clone, Debug, PartialEq)]
pub struct Signal {
    /// As it is written in the test.
    pub name: String,
    /// The data block that it lies in; `None` = the area of the address.
    pub data_block: Option<u16>,
    /// Where it lies.
    pub address: Address,
    /// Its type.
    pub data_type: DataType,
}

/// A word at its place in a test.
#[derive(Clone, Debug, PartialEq)]
pub struct WordCall {
    /// The word.
    pub word: Word,
    /// The whole call.
    pub span: Span,
    /// What its author says about it.
    pub message: Option<String>,
    /// Its values in order.
    pub operands: Vec<Operand>,
    /// What its expressions read and lies at a constant address.
    pub signals: Vec<Signal>,
    /// The function or function block that it mocks or asks about, and how that is called in the source.
    pub mocked: Option<(BlockId, String)>,
}

/// One test.
#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    /// Its name.
    pub name: String,
    /// The place of the name.
    pub span: Span,
    /// The organization block that runs SETUP and the test.
    pub block: BlockId,
}

/// All that a runner has to know about the tests of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TestPlan {
    /// The tests in the order of the source.
    pub tests: Vec<Test>,
    /// The organization block that runs TEARDOWN.
    pub teardown: Option<BlockId>,
    /// The words by the first byte of their place.
    pub words: BTreeMap<u32, WordCall>,
    /// Variables with a constant address that a test writes, by the first byte of the place.
    pub writes: BTreeMap<u32, Signal>,
    /// The blocks with statements of the test file: their statements are not the program's.
    pub blocks: BTreeSet<BlockId>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_found_and_its_usage_begins_with_it() {
        for &word in Word::ALL {
            assert_eq!(Word::find(&word.text().to_lowercase()), Some(word));
            assert!(word.usage().starts_with(word.text()), "{word:?}");
            assert!(word.parameters().0 <= word.parameters().1, "{word:?}");
        }
        assert_eq!(Word::find("ASSERT"), None);
    }
}
