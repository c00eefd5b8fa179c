//! How often a function uses its elementary parameters: what is used more than once is copied to local data at its begin, and
//! outputs back at its end, instead of following the pointer of the caller each time.

use std::collections::HashMap;

use crate::st::tree::visit::{self, Extent, Use, Visit};
use crate::st::tree::{Base, Place, Statement, StatementKind};

/// What a function does with a parameter. Uses in a loop count twice.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Usage {
    pub(super) reads: u32,
    pub(super) writes: u32,
    /// A pointer to it is needed.
    pub(super) addressed: bool,
}

/// The uses of all elementary parameters, by their index.
pub(super) fn parameters(statements: &[Statement]) -> HashMap<u16, Usage> {
    let mut counter = Counter { weight: 1, uses: HashMap::new() };
    visit::statements(&mut counter, statements);
    counter.uses
}

struct Counter {
    weight: u32,
    uses: HashMap<u16, Usage>,
}

impl Counter {
    fn in_loop(&mut self, count: impl FnOnce(&mut Self)) {
        let outside = std::mem::replace(&mut self.weight, 2);
        count(self);
        self.weight = outside;
    }
}

impl<'t> Visit<'t> for Counter {
    fn statement(&mut self, statement: &'t Statement) {
        match &statement.kind {
            // The first value is computed once.
            StatementKind::For(one) => {
                self.value(&one.from);
                self.in_loop(|this| {
                    [&one.to, &one.by].into_iter().for_each(|value| this.value(value));
                    this.place(&one.variable, Use::ReadWrite, Extent::Scalar(one.scalar));
                    visit::statements(this, &one.body);
                });
            }
            StatementKind::While { .. } | StatementKind::Repeat { .. } => self.in_loop(|this| visit::statement(this, statement)),
            // A jump back makes a loop of what lies between.
            StatementKind::Label(_) => self.weight = 2,
            _ => visit::statement(self, statement),
        }
    }

    fn place(&mut self, place: &'t Place, how: Use, extent: Extent<'t>) {
        if let Base::Parameter(index) = place.base {
            let usage = self.uses.entry(index).or_default();
            let is_elementary = match extent {
                Extent::Scalar(_) => true,
                Extent::Type(data_type) => how == Use::ReadWrite && data_type.is_elementary(),
                Extent::Text(_) | Extent::Bytes(_) | Extent::Unknown => false,
            };
            match how {
                Use::Read | Use::Write | Use::ReadWrite if is_elementary => {
                    usage.reads += if how == Use::Write { 0 } else { self.weight };
                    usage.writes += if how == Use::Read { 0 } else { self.weight };
                }
                _ => usage.addressed = true,
            }
        }
        visit::base(self, place);
        visit::indexes(self, place);
    }
}
