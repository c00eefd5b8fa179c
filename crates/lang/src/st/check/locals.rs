//! Local data behind the declared variables, for values that the checker keeps while a statement runs.

use sieben_model::address::Area;
use sieben_model::source::Span;

use crate::st::tree::{Base, Place};

/// The local data of a block.
pub(super) struct Locals {
    /// Bytes of the declared variables.
    declared: u32,
    /// One behind the last byte that wires of the network take.
    held: u32,
    /// Where the next value goes.
    next: u32,
    /// One behind the last byte that was ever used.
    end: u32,
}

impl Locals {
    /// Behind so many bytes of declared variables.
    pub(super) fn new(declared: u32) -> Self {
        let declared = declared.next_multiple_of(2);
        Self { declared, held: declared, next: declared, end: declared }
    }

    /// A place for so many bytes.
    pub(super) fn place(&mut self, bytes: u32, span: Span) -> Place {
        let offset = self.next * 8;
        self.next += bytes.next_multiple_of(2);
        self.end = self.end.max(self.next);
        Place { base: Base::Area(Area::Local), offset, indexes: Vec::new(), span }
    }

    /// A place that the next statements leave alone.
    pub(super) fn hold(&mut self, bytes: u32, span: Span) -> Place {
        let place = self.place(bytes, span);
        self.held = self.next;
        place
    }

    /// The next statement may use all of it again, but what is held.
    pub(super) fn release(&mut self) {
        self.next = self.held;
    }

    /// What is held is needed no more.
    pub(super) fn let_go(&mut self) {
        self.held = self.declared;
        self.release();
    }

    /// Statements begin that stand inside of another one: what is held so far stays. What they were is for [`Self::leave`].
    pub(super) fn enter(&mut self) -> (u32, u32) {
        let outer = (self.declared, self.held);
        (self.declared, self.held) = (self.next, self.next);
        outer
    }

    /// The statements have ended.
    pub(super) fn leave(&mut self, outer: (u32, u32)) {
        (self.declared, self.held) = outer;
        self.release();
    }

    /// Bytes that the block needs.
    pub(super) fn bytes(&self) -> u32 {
        self.end
    }
}
