//! What an expression is before its place decides: a number without a type, a value, a text, a structure, or no value at all.

use sieben_model::block::BlockId;
use sieben_model::literal::Value as Pointer;
use sieben_model::types::DataType;

use super::names::Role;
use crate::st::dtl::BYTES;
use crate::st::tree::{Place, Statement, Text, Value};

/// An expression that has been looked at.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Typed {
    /// Not understood, which is reported: nothing that depends on it is reported again.
    Poison,
    /// A whole number without a type: it takes the type of its place.
    Integer { value: i128, radix: u8 },
    /// A number with a point and without a type.
    Real { value: f64, single: f32 },
    /// A value. Where a dialect computes in more bits than the type has, the scalar is wider than the type.
    Scalar { value: Value, data_type: DataType },
    /// A STRING, or characters between apostrophes.
    Text(Text),
    /// An array, a structure, an instance, DATE_AND_TIME of the S7: what has a place and no scalar.
    Aggregate(Target),
    /// What a function delivers that is an array, a structure or a DATE_AND_TIME: where the statements put it.
    Delivered(Vec<Statement>, Target),
    /// A constant of the DATE_AND_TIME of the S7.
    Moment([u8; 8]),
    /// A constant of the type DTL: its nanoseconds since 1970, and its bytes.
    Structured(u64, [u8; BYTES]),
    /// A constant pointer.
    Pointer(Pointer),
    /// NULL.
    Null,
    /// A timer, a counter, or the number of a block.
    Number { data_type: DataType, value: Value },
    /// A block by its name or number.
    Block(BlockId),
    /// A type.
    Type(DataType),
    /// The first names of a qualified one.
    Qualifier(Vec<String>),
}

/// A variable, or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Target {
    /// Where it lies.
    pub(super) place: Place,
    /// Its type.
    pub(super) data_type: DataType,
    /// How the variable is declared that it belongs to.
    pub(super) role: Role,
    /// The name of that variable.
    pub(super) name: String,
    /// Through what it was reached last.
    pub(super) through: Through,
}

/// How a part of a variable was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Through {
    /// It is the variable itself.
    Itself,
    /// A field of a structure or an element.
    Part,
    /// A field of an instance that is a VAR_INPUT.
    InstanceInput,
    /// A VAR_OUTPUT of an instance.
    InstanceOutput,
    /// Anything else of an instance.
    InstanceInternal,
    /// Bits of a value: [`crate::st::ast::Slice`].
    Slice,
    /// A reference.
    Reference,
}
