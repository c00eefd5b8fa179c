//! What a body that is a diagram has besides statements and expressions: values that are kept on wires, and boxes.

use super::{Argument, Expression, Name};

/// A wire of a diagram: a value that was evaluated once and is read by what follows in its network. Wires are counted from 0 in each
/// network, in the order in which they get their values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Wire(pub u32);

/// A network of a body that is a diagram, by its place there: from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NetworkNumber(pub u32);

impl std::fmt::Display for NetworkNumber {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "network {}", self.0)
    }
}

/// A contact of a diagram, also one that watches for an edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// What it reads.
    pub operand: Expression,
    /// The network that it stands in.
    pub network: NetworkNumber,
}

/// A box of a diagram: a function, an operator or a function block.
#[derive(Clone, Debug, PartialEq)]
pub struct DiagramBox {
    /// The network that it stands in.
    pub network: NetworkNumber,
    /// What it is: `ADD`, `TON`, `Mixer`.
    pub of: Expression,
    /// The instance of a function block.
    pub instance: Option<Expression>,
    /// The line from the left.
    pub power: Option<Expression>,
    /// The input that the line enters, if it is said.
    pub power_pin: Option<Name>,
    /// What is wired to inputs.
    pub inputs: Vec<Argument>,
    /// What outputs are assigned to.
    pub outputs: Vec<Argument>,
    /// The output that goes on, if it is said.
    pub flow: Option<Name>,
    /// What goes on to the right.
    pub goes_on: GoesOn,
}

/// What goes on from a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GoesOn {
    /// Nothing.
    Nothing,
    /// The line: a BOOL.
    Line(Wire),
    /// Whatever its result is: it stands at a pin of another box.
    Value(Wire),
}

impl GoesOn {
    /// The wire.
    pub fn wire(self) -> Option<Wire> {
        match self {
            Self::Nothing => None,
            Self::Line(wire) | Self::Value(wire) => Some(wire),
        }
    }
}

impl DiagramBox {
    /// Its expressions.
    pub fn expressions(&self) -> impl Iterator<Item = &Expression> {
        let arguments = self.inputs.iter().chain(&self.outputs).filter_map(|argument| argument.value.as_ref());
        self.instance.iter().chain(&self.power).chain(arguments)
    }

    /// The argument of an input of this name.
    pub fn input(&self, name: &str) -> Option<&Argument> {
        self.inputs.iter().find(|input| input.name.as_ref().is_some_and(|written| written.is(name)))
    }
}
