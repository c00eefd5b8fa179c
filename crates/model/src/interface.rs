//! The interface of a block: its declared parameters and variables.

use crate::block::BlockId;
use crate::literal::Value;
use crate::source::Span;
use crate::types::DataType;

/// Which part of the declaration a variable belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Section {
    /// VAR_INPUT.
    Input,
    /// VAR_OUTPUT.
    Output,
    /// VAR_IN_OUT.
    InOut,
    /// VAR: static data of a function block.
    Static,
    /// VAR_TEMP.
    Temp,
    /// The result of a function, `RET_VAL`.
    Return,
}

/// One declared variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// The name as declared.
    pub name: String,
    /// Its section.
    pub section: Section,
    /// Its type.
    pub data_type: DataType,
    /// Where it lies. Bits from the start of the instance (FB: IN, OUT, IN_OUT, STAT),
    /// of the local data (TEMP), or the index of the parameter (FC: IN, OUT, IN_OUT, RETURN).
    pub offset: u32,
    /// Initial values as in [`crate::types::Field::initial`].
    pub initial: Vec<Value>,
    /// The comment behind the declaration.
    pub comment: String,
    /// The place of its name.
    pub span: Span,
}

impl Variable {
    /// Whether a caller gives it in a CALL.
    pub fn is_parameter(&self) -> bool {
        matches!(self.section, Section::Input | Section::Output | Section::InOut | Section::Return)
    }
}

/// All declared variables of a block, in declaration order, sections in the order of [`Section`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Interface {
    /// The variables.
    pub variables: Vec<Variable>,
    /// Bytes of the instance data (FB), always even.
    pub instance_size: u32,
    /// Bytes of declared local data (TEMP), always even; an OB's include its 20 bytes of start information.
    pub local_size: u32,
}

impl Interface {
    /// Whether another interface has the same variables at the same addresses; where their names stand in the source does not matter.
    pub fn has_shape_of(&self, other: &Self) -> bool {
        let same = |(one, other): (&Variable, &Variable)| {
            one.name == other.name
                && (one.section, one.offset) == (other.section, other.offset)
                && one.data_type == other.data_type
                && one.initial == other.initial
                && one.comment == other.comment
        };
        self.variables.len() == other.variables.len()
            && (self.instance_size, self.local_size) == (other.instance_size, other.local_size)
            && self.variables.iter().zip(&other.variables).all(same)
    }
    /// The variable with this name, without regard to case.
    pub fn variable(&self, name: &str) -> Option<&Variable> {
        self.variables.iter().find(|variable| variable.name.eq_ignore_ascii_case(name))
    }
    /// The parameters in the order of a CALL; the index is their number for an FC.
    pub fn parameters(&self) -> impl Iterator<Item = &Variable> {
        self.variables.iter().filter(|variable| variable.is_parameter())
    }
}

/// A system function or system function block as its callers see it.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemBlock {
    /// `SFC 46`.
    pub block: BlockId,
    /// `STP`.
    pub name: &'static str,
    /// Its parameters.
    pub interface: Interface,
    /// What has it, if the CPU types of this program do not: "CPU 31xC". A call compiles, is warned of, and fails at run time.
    pub only: Option<&'static str>,
}
