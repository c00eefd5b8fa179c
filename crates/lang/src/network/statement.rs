//! Statements as the reader and the writer of diagrams see them: English mnemonics, operands as written.

use super::model::Place;
use super::operand::Operand;

/// One statement of a network.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statement {
    /// Its label.
    pub label: Option<Operand>,
    /// The English mnemonic: `A`, `A(`, `)`, `=`, `CALL`.
    pub mnemonic: &'static str,
    /// The operand, empty if there is none; of `CALL` the block.
    pub operand: Operand,
    /// The instance data block of a `CALL`.
    pub instance: Option<Operand>,
    /// The parameters of a `CALL`, in their order.
    pub parameters: Vec<Parameter>,
    /// The element that made it.
    pub place: Place,
}

/// A parameter of a `CALL`.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: Operand,
    /// The actual parameter.
    pub actual: Operand,
    /// Which way the value goes, as far as the interface of the block is known.
    pub passing: Passing,
}

impl PartialEq for Parameter {
    /// In STL both ways are written in the same manner.
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.actual == other.actual
    }
}

/// Which way the value of a parameter goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passing {
    /// Into the block, or both ways, or not known.
    In,
    /// Out of the block.
    Out,
}

impl Statement {
    /// A statement without a label.
    pub fn new(mnemonic: &'static str, operand: impl Into<Operand>) -> Self {
        Self { mnemonic, operand: operand.into(), ..Self::default() }
    }

    /// Mnemonic and operand are these.
    pub fn is(&self, mnemonic: &str, operand: &str) -> bool {
        self.mnemonic == mnemonic && self.operand == operand
    }
}
