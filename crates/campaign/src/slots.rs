//! The expressions of a campaign, each with the slot that its value lies in after a scan.

use crate::spec::{Placed, Property, PropertyKind, Spec};

/// What an expression is wanted as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// `TRUE` or `FALSE`: 1 or 0.
    Boolean,
    /// A number.
    Number,
    /// A number or a Boolean: it is only compared.
    Either,
}

/// An expression of the file.
#[derive(Clone, Copy, Debug)]
pub struct Slot<'s> {
    /// What it is wanted as.
    pub wanted: Wanted,
    /// As it is written.
    pub expression: &'s Placed,
}

/// The slot of each property's first expression, and last the slot of the first measure: a response has two.
pub fn of_properties(spec: &Spec) -> Vec<usize> {
    let count = |property: &Property| 1 + usize::from(property.then.is_some());
    let ends = spec.properties.iter().scan(0, |end, property| {
        *end += count(property);
        Some(*end)
    });
    std::iter::once(0).chain(ends).collect()
}

/// All expressions in the order of their slots: those of the properties, then those of the measures.
pub fn slots(spec: &Spec) -> Vec<Slot<'_>> {
    let mut all = Vec::new();
    for property in &spec.properties {
        let wanted = if property.kind == PropertyKind::Same { Wanted::Either } else { Wanted::Boolean };
        all.push(Slot { wanted, expression: &property.expression });
        all.extend(property.then.as_ref().map(|then| Slot { wanted: Wanted::Boolean, expression: then }));
    }
    for measure in &spec.measures {
        let wanted = if measure.of.counts() { Wanted::Boolean } else { Wanted::Number };
        all.push(Slot { wanted, expression: &measure.expression });
    }
    all
}
