//! Local data behind the declared variables, for values that the checker keeps while a statement runs.

use sieben_model::address::Area;
use sieben_model::source::Span;

use crate::st::tree::{Base, Place};

/// The local data of a block.
pub(super) struct Locals {
    /// Bytes of the declared variables.
    declared: u32,
    /// Where the next value goes.
    next: u32,
    /// One behind the last byte that was ever used.
    end: u32,
}

impl Locals {
    /// Behind so many bytes of declared variables.
    pub(super) fn new(declared: u32) -> Self {
        let declared = declared.next_multiple_of(2);
        Self { declared, next: declared, end: declared }
    }

    /// A place for so many bytes.
    pub(super) fn place(&mut self, bytes: u32, span: Span) -> Place {
        let offset = self.next * 8;
        self.next += bytes.next_multiple_of(2);
        self.end = self.end.max(self.next);
        Place { base: Base::Area(Area::Local), offset, indexes: Vec::new(), span }
    }

    /// The next statement may use all of it again.
    pub(super) fn release(&mut self) {
        self.next = self.declared;
    }

    /// Bytes that the block needs.
    pub(super) fn bytes(&self) -> u32 {
        self.end
    }
}
