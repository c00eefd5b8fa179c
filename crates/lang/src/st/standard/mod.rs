//! Standard functions: what a name means with the arguments it is given, in each dialect.
//!
//! Most functions are a few operations, which [`Meaning::Build`] composes; what is larger is a block of the library.

mod bits;
pub(crate) mod build;
mod call;
pub mod catalogue;
mod conversions;
mod generic;
pub mod library;
mod numeric;
pub mod operators;
pub mod s5;
mod selection;
pub mod texts;
mod time;

#[cfg(test)]
mod tests;

use std::collections::BTreeSet;

use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_model::types::DataType;

use super::dialect::Dialect;
use super::tree::{Place, Scalar, Value};
use crate::library::LibraryBlock;
use call::Call;
pub(crate) use generic::type_of_word;
use operators::Operation;

/// What a function of numbers without a type gives, as a number without a type: the arguments in the order of its inputs, named or not.
/// `None` for any other function, and for what is no number or none of a REAL, which the program finds out when it runs.
pub fn of_literals(name: &str, dialect: Dialect, arguments: &[(Option<&str>, f64)]) -> Option<f64> {
    let (op, inputs) = numeric::real_operation(&name.to_ascii_uppercase(), dialect)?;
    let mut words = [0; 4];
    for (index, (word, input)) in words.iter_mut().zip(inputs).enumerate() {
        let named = arguments.iter().find(|(name, _)| name.is_some_and(|name| name.eq_ignore_ascii_case(input)));
        let (_, value) = named.or_else(|| arguments.get(index).filter(|(name, _)| name.is_none()))?;
        *word = value.to_bits();
    }
    let value = f64::from_bits(op.eval(words));
    let single = value as f32;
    (arguments.len() == inputs.len() && (single.is_normal() || value == 0.0)).then_some(value)
}

/// An argument of a call as far as it decides what the function is.
#[derive(Clone, Debug, PartialEq)]
pub struct Given<'a> {
    /// The name of the parameter, if the call names it.
    pub name: Option<&'a str>,
    /// What the argument is.
    pub kind: GivenKind,
}

/// What an argument is.
#[derive(Clone, Debug, PartialEq)]
pub enum GivenKind {
    /// Something with a type.
    Typed(DataType),
    /// A whole number without a type.
    Integer {
        /// The number.
        value: i128,
        /// 2, 8, 10 or 16.
        radix: u8,
    },
    /// A number with a point and without a type.
    Real,
    /// Something of no type: NULL, or what was not understood.
    Unknown,
}

/// What a function is for the given arguments.
pub struct Resolved {
    /// Its parameters in the order that [`Build`] takes them; only those that the call gives. Empty for [`Meaning::Block`], whose
    /// interface says it.
    pub parameters: Vec<Parameter>,
    /// Type of the result; for [`Meaning::Block`] only what is not Void, else the interface says it too.
    pub result: DataType,
    /// How it is computed.
    pub meaning: Meaning,
}

/// A parameter of a standard function.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name: `IN`, `IN1`.
    pub name: String,
    /// What the argument is converted to.
    pub data_type: DataType,
}

/// How a function is computed.
pub enum Meaning {
    /// From values of the types of its parameters.
    Build(Build),
    /// The length of the one argument, a text.
    Length,
    /// The order of the two arguments, texts: whether this comparison of it with 0 holds.
    CompareTexts(Operation),
    /// By a block.
    Block(Provided),
    /// One of texts by a number, which comes first: by a block that chooses between two by a BOOL, again and again.
    Choose {
        /// The block: G, IN0, IN1.
        block: Provided,
        /// Texts that count from 0; a further one is for all other numbers.
        inputs: usize,
        /// What other numbers give where there is no further text: the last one, else an empty text and ENO is FALSE.
        last: bool,
    },
    /// By a block of two texts: of the first two, then of what comes out and the next one, and so on.
    Fold(Provided),
}

/// Composes the value of a function from those of its arguments.
pub type Build = Box<dyn Fn(Vec<Value>, &mut Building<'_>) -> Value>;

/// What surrounds the value that is composed.
pub struct Building<'a> {
    /// The call.
    pub span: Span,
    /// Whether the block wants to know of operations that fail (ENO, OK).
    pub checked: bool,
    /// Whether it wants to know of divisions by 0, if of nothing else.
    pub quotients: bool,
    /// Gives a place in the local data of the block for a value that is used more than once.
    pub temporary: &'a mut dyn FnMut(Scalar) -> Place,
}

/// A block that comes with Sieben.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Provided {
    /// A block of the S7 libraries, written in STL.
    Library(&'static LibraryBlock),
    /// SFC or SFB.
    System(BlockId),
    /// A block with this name that is written in ST.
    Source {
        /// Its name in the source.
        name: &'static str,
        /// The file.
        source: &'static Source,
    },
}

/// A file of library blocks written in ST.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// Where it lies in the repository.
    pub path: &'static str,
    /// In which dialect it is written.
    pub dialect: Dialect,
    /// Its text.
    pub text: &'static str,
}

/// A source of ST of the library that belongs to a program because something there needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkedSource {
    /// Its place among the sources of the program, after the user's and those of linked blocks of STL.
    pub file: FileId,
    /// Which source it is.
    pub source: &'static Source,
    /// Its blocks.
    pub blocks: BTreeSet<BlockId>,
}

/// Why a standard function cannot be called like this.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Which problem it is.
    pub problem: Problem,
    /// The argument that is wrong; `None` = the call as a whole.
    pub argument: Option<usize>,
    /// What is wrong, as the message of a diagnostic.
    pub message: String,
    /// What to do.
    pub help: String,
}

/// What a name means as a function with these arguments: `None` if it is no standard function of the dialect. EN and ENO are not among
/// the arguments.
pub fn resolve(name: &str, dialect: Dialect, arguments: &[Given<'_>]) -> Option<Result<Resolved, Refusal>> {
    let name = name.to_ascii_uppercase();
    // Test files have the functions of their dialect.
    let call = Call { name: &name, dialect: dialect.base(), arguments };
    let chapters = [numeric::resolve, bits::resolve, selection::resolve, time::resolve, conversions::resolve, blocks];
    chapters.iter().find_map(|chapter| chapter(&call))
}

/// What is a block of the library by its own name.
fn blocks(call: &Call<'_>) -> Option<Result<Resolved, Refusal>> {
    if call.name == "LEN" {
        // The library Standard of CODESYS has a name of its own for the text.
        let own = call.dialect == Dialect::Codesys
            && call.arguments.iter().any(|given| given.name.is_some_and(|name| name.eq_ignore_ascii_case("STR")));
        return Some(call.bind(&[if own { "STR" } else { "IN" }]).map(|_| Resolved {
            parameters: Vec::new(),
            result: DataType::Int,
            meaning: Meaning::Length,
        }));
    }
    if let Some(answer) = selection::concat(call) {
        return Some(answer);
    }
    let block = library::function(call.name, call.dialect)?;
    Some(Ok(Resolved { parameters: Vec::new(), result: DataType::Void, meaning: Meaning::Block(block) }))
}
