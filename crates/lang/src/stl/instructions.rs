//! The instruction table.

/// An instruction (placeholder until the table lands).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Instruction {
    /// `A`.
    And,
}
