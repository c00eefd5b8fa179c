//! The extension words of self-checking programs: `__ASSERT==` and its like, their tables and what they resolve to.
//!
//! The words are always read, formatted and converted; only an extended program may use them.

use sieben_engine::machine::Register;
use sieben_model::extension::Relation;
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;

use super::ast;
use super::mnemonics::pick;
use super::operands::{Location, Operand};

/// What stands before every extension word.
pub(crate) const PREFIX: &str = "__";

/// What the words together may do to the status word.
pub(crate) const STATUS: &str = "x x x x x x x x x";

/// An instruction that only extended programs have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Word {
    /// `__ASSERT== a, b`: stops with an error if the relation does not hold.
    Assert(Relation),
    /// `__STWRST`: all nine status bits become 0.
    StatusReset,
    /// `__SLEEP ms`: so much time passes inside the scan.
    Sleep,
    /// `__FEATURE n[, v]`: asks for or sets a property of the CPU.
    Feature,
}

impl Word {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Assert(Relation::Equal),
        Self::Assert(Relation::NotEqual),
        Self::Assert(Relation::Less),
        Self::Assert(Relation::Greater),
        Self::Assert(Relation::LessEqual),
        Self::Assert(Relation::GreaterEqual),
        Self::Assert(Relation::EqualReal),
        Self::StatusReset,
        Self::Sleep,
        Self::Feature,
    ];

    /// How it is written, the same in both mnemonic languages.
    pub fn spelling(self) -> String {
        match self {
            Self::Assert(relation) => format!("__ASSERT{}", relation.signs()),
            Self::StatusReset => "__STWRST".to_owned(),
            Self::Sleep => "__SLEEP".to_owned(),
            Self::Feature => "__FEATURE".to_owned(),
        }
    }

    /// What it does, in one sentence.
    pub fn doc(self) -> &'static str {
        match self {
            Self::Assert(Relation::EqualReal) => {
                "Stops the CPU with an error unless two REAL numbers differ by less than 1e-7; /FC becomes 0."
            }
            Self::Assert(_) => {
                "Stops the CPU with an error unless two values, compared without sign, stand to each other so; /FC becomes 0."
            }
            Self::StatusReset => "Clears all nine bits of the status word.",
            Self::Sleep => "Lets so many milliseconds pass inside the scan.",
            Self::Feature => {
                "Loads a property of the CPU into ACCU 1 and sets it if a second number is given: 0 is the number of accumulators, 1 the start information of OB 1."
            }
        }
    }

    /// What stands behind it, in words for a message.
    pub fn operands(self) -> &'static str {
        match self {
            Self::Assert(_) => "two operands with a comma between them: `__ASSERT== MW 10, 5`",
            Self::StatusReset => "no operand",
            Self::Sleep => "a number of milliseconds: `__SLEEP 100`",
            Self::Feature => "the number of a property, and a value if it is to be set: `__FEATURE 0, 4`",
        }
    }

    /// The word with this spelling, without regard to case.
    pub fn from_spelling(text: &str) -> Option<Self> {
        if !text.starts_with(PREFIX) {
            return None;
        }
        Self::ALL.into_iter().find(|word| word.spelling().eq_ignore_ascii_case(text))
    }
}

/// What a statement with an extension word does, with all names resolved.
#[derive(Clone, Debug, PartialEq)]
pub enum Extension {
    /// Compares two values.
    Assert {
        /// What has to hold.
        relation: Relation,
        /// Both sides.
        sides: [Compared; 2],
    },
    /// Clears the status word.
    StatusReset,
    /// Waits so many milliseconds.
    Sleep(Operand),
    /// Loads a property.
    Feature {
        /// Which.
        property: Property,
        /// Its new value, if it is set.
        value: Option<u32>,
    },
}

/// A property that `__FEATURE` names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Property {
    /// 0: the number of accumulators, 2 or 4.
    Accumulators,
    /// 1: whether OB 1 gets start information. Ours always does.
    StartInformation,
}

impl Property {
    /// The property with this number.
    pub(crate) fn from_number(number: i64) -> Option<Self> {
        match number {
            0 => Some(Self::Accumulators),
            1 => Some(Self::StartInformation),
            _ => None,
        }
    }
}

/// One side of an assertion.
#[derive(Clone, Debug, PartialEq)]
pub enum Compared {
    /// A number of at most 32 bits, and how many.
    Number(Operand, u8),
    /// A longer variable, by its place and bytes.
    Bytes(Location, u32),
    /// A longer constant.
    Constant(Vec<u8>),
}

/// A constant as the side of an assertion.
pub(crate) fn compared_constant(value: &Value) -> Compared {
    let bytes = match value {
        Value::Bool(_) => return Compared::Number(Operand::Constant(value.clone()), 1),
        Value::Byte(_) => return Compared::Number(Operand::Constant(value.clone()), 8),
        Value::Int(_) | Value::Word(_) | Value::S5Time(_) | Value::Counter(_) | Value::Date(_) => {
            return Compared::Number(Operand::Constant(value.clone()), 16);
        }
        Value::DataPointer { db, pointer } => db.to_be_bytes().into_iter().chain(pointer.to_be_bytes()).collect(),
        Value::Any(bytes) => bytes.to_vec(),
        Value::DateAndTime(bytes) => bytes.to_vec(),
        Value::Characters(text) if text.len() > 4 => text.clone(),
        _ => return Compared::Number(Operand::Constant(value.clone()), 32),
    };
    Compared::Constant(bytes)
}

/// The status bits by their names: international, SIMATIC, bit 0 first.
const STATUS_BITS: [(&str, &str); 9] =
    [("NFC", "NER"), ("RLO", "VKE"), ("STA", "STA"), ("OR", "OR"), ("OS", "OS"), ("OV", "OV"), ("CC0", "A0"), ("CC1", "A1"), ("BR", "BIE")];

/// Other spellings of the first-check bit.
const FIRST_CHECK: [(&str, &str); 2] = [("/FC", "/ER"), ("FC", "ER")];

/// The number of a status bit by its name, and the name in the other language if it is another one.
pub(crate) fn status_bit(name: &str, mnemonics: Mnemonics) -> Option<u32> {
    let own = |&(english, german): &(&'static str, &'static str)| match mnemonics {
        Mnemonics::English => english,
        Mnemonics::German => german,
    };
    if FIRST_CHECK.iter().any(|names| own(names).eq_ignore_ascii_case(name)) {
        return Some(0);
    }
    STATUS_BITS.iter().position(|names| own(names).eq_ignore_ascii_case(name)).map(|bit| bit as u32)
}

/// The name of a status bit in the other language; `None` if it is the same or unknown.
pub(crate) fn translate_status_bit(name: &str, from: Mnemonics) -> Option<&'static str> {
    let translated = pick(&FIRST_CHECK, name, from).or_else(|| pick(&STATUS_BITS, name, from));
    translated.filter(|target| !target.eq_ignore_ascii_case(name))
}

/// What stands behind the name of a register operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Selector {
    /// Nothing: the name is a constant.
    None,
    /// A number from 1 to this.
    Number(u32),
    /// A status bit by number or name.
    StatusBit,
}

/// Names of the operands that only extended programs have.
const OPERANDS: [(&str, Selector); 10] = [
    ("__STW", Selector::StatusBit),
    ("__ACCU", Selector::Number(4)),
    ("__AR", Selector::Number(2)),
    ("__DBR", Selector::Number(2)),
    ("__CNST_PI", Selector::None),
    ("__CNST_E", Selector::None),
    ("__CNST_PINF", Selector::None),
    ("__CNST_NINF", Selector::None),
    ("__CNST_PNAN", Selector::None),
    ("__CNST_NNAN", Selector::None),
];

/// The operand that a word begins, and the bytes of its name: `__ACCU 1`, `__ACCU1`.
pub(crate) fn operand_name(word: &str) -> Option<(&'static str, Selector)> {
    if !word.starts_with(PREFIX) {
        return None;
    }
    let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
    OPERANDS.iter().copied().find(|(name, selector)| {
        name.eq_ignore_ascii_case(word)
            || (matches!(selector, Selector::Number(_) | Selector::StatusBit) && name.eq_ignore_ascii_case(letters))
    })
}

/// The operand that a name and the number behind it stand for.
pub(crate) fn operand(name: &str, number: u32) -> Option<Operand> {
    let real = |bits: u32| Some(Operand::Constant(Value::Real(f32::from_bits(bits))));
    let register = |registers: &[Register]| {
        let index = (number as usize).checked_sub(1)?;
        registers.get(index).copied().map(Operand::Register)
    };
    match name {
        "__STW" => sieben_engine::machine::registers::STATUS_BITS.get(number as usize).copied().map(Operand::Register),
        "__ACCU" => register(&[Register::Accu1, Register::Accu2, Register::Accu3, Register::Accu4]),
        "__AR" => register(&[Register::Ar1, Register::Ar2]),
        "__DBR" => register(&[Register::DbNumber, Register::DiNumber]),
        "__CNST_PI" => real(std::f32::consts::PI.to_bits()),
        "__CNST_E" => real(std::f32::consts::E.to_bits()),
        "__CNST_PINF" => real(f32::INFINITY.to_bits()),
        "__CNST_NINF" => real(f32::NEG_INFINITY.to_bits()),
        // A quiet NaN of either sign.
        "__CNST_PNAN" => real(0x7FC0_0000),
        "__CNST_NNAN" => real(0xFFC0_0000),
        _ => None,
    }
}

/// Whether a register of such an operand is a status bit.
pub(crate) fn is_status_bit(register: Register) -> bool {
    sieben_engine::machine::registers::STATUS_BITS.contains(&register)
}

/// The number of accumulators that the statements of some sources ask for with `__FEATURE 0, n`, and where.
pub(crate) fn accumulators_asked<'a>(blocks: impl Iterator<Item = &'a ast::Block>) -> Vec<(u8, sieben_model::source::Span)> {
    blocks
        .flat_map(|block| &block.statements)
        .filter(|statement| statement.mnemonic.text.eq_ignore_ascii_case("__FEATURE"))
        .filter_map(|statement| {
            let ast::Operand::List(operands) = &statement.operand else { return None };
            let number = |index: usize| match operands.get(index) {
                Some((ast::Operand::Constant(ast::Constant { value: Some(value), .. }), _)) => value.accumulator(),
                _ => None,
            };
            match (number(0), number(1)) {
                (Some(0), Some(accumulators @ (2 | 4))) => Some((accumulators as u8, statement.span)),
                _ => None,
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_found_by_its_spelling() {
        for word in Word::ALL {
            assert_eq!(Word::from_spelling(&word.spelling().to_ascii_lowercase()), Some(word));
            assert!(!word.doc().is_empty() && !word.operands().is_empty());
        }
        assert_eq!(Word::from_spelling("__ASSERT"), None);
    }

    #[test]
    fn every_operand_stands_for_something() {
        for (name, selector) in OPERANDS {
            assert_eq!(operand_name(&name.to_ascii_lowercase()), Some((name, selector)));
            assert!(operand(name, 1).is_some(), "{name}");
        }
        assert_eq!(operand_name("__ACCU3"), Some(("__ACCU", Selector::Number(4))));
        assert_eq!((operand("__ACCU", 0), operand("__ACCU", 5), operand("__STW", 9)), (None, None, None));
    }

    #[test]
    fn names_of_status_bits_are_translated_both_ways() {
        for (english, german) in STATUS_BITS.into_iter().chain(FIRST_CHECK) {
            assert_eq!(status_bit(english, Mnemonics::English), status_bit(german, Mnemonics::German));
            if english != german {
                assert_eq!(translate_status_bit(english, Mnemonics::English), Some(german));
                assert_eq!(translate_status_bit(german, Mnemonics::German), Some(english));
            }
        }
        assert_eq!(translate_status_bit("OV", Mnemonics::English), None);
    }
}
