//! A block of which nothing is known but how its operands are written.

use super::{Class, Surroundings};
use crate::network::write::scratch_number;

/// Absolute addresses say what they are; a name that begins with `#t` is a temporary bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ByNotation {
    /// The caller of the block may read the branch result.
    pub branch_result_matters: bool,
}

impl Surroundings for ByNotation {
    fn scratch(&self, operand: &str) -> Option<u32> {
        scratch_number(operand)
    }

    fn is_temporary(&self, operand: &str) -> bool {
        operand.starts_with("#t")
    }

    fn class(&self, operand: &str) -> Class {
        let letters = operand.find(|sign: char| !sign.is_ascii_uppercase()).unwrap_or(operand.len());
        let (area, number) = operand.split_at(letters);
        let is_number = number.trim_start().starts_with(|sign: char| sign.is_ascii_digit());
        match area {
            "T" if is_number => Class::Timer,
            "C" if is_number => Class::Counter,
            area if is_number && area.ends_with('B') && area.len() > 1 => Class::Bits(8),
            area if is_number && area.ends_with('W') => Class::Bits(16),
            area if is_number && area.ends_with('D') => Class::Bits(32),
            "I" | "Q" | "M" | "L" if is_number => Class::Bits(1),
            _ => Class::Unknown,
        }
    }

    fn overlap(&self, left: &str, right: &str) -> bool {
        left == right
    }

    fn begins_fresh(&self) -> bool {
        true
    }

    fn is_read_elsewhere(&self, _: u32) -> bool {
        false
    }

    fn branch_result_matters(&self) -> bool {
        self.branch_result_matters
    }
}
