//! What fails in a step of Structured Text: an index outside its array, a division by 0, a result that is lost.

use crate::sentences::table::Sentence as S;
use crate::sentences::text::{Clause, one_line};
use crate::st::standard::operators::fails_of_division;
use crate::st::tree::visit::{self, Extent, Use, Visit};
use crate::st::tree::{Bounds, Place, Value, ValueKind};

use super::values::Values;

/// What failed, in words.
pub(super) struct Failed {
    pub(super) clause: Clause,
    /// Nothing comes of the whole statement.
    pub(super) ends: bool,
}

/// The first thing that fails when a value is computed.
pub(super) fn of_value(value: &Value, values: &Values<'_>) -> Option<Failed> {
    let mut search = Search { values, writes: false, found: None };
    search.value(value);
    search.found
}

/// The index of a target that is outside its array.
pub(super) fn of_target(target: &Place, values: &Values<'_>) -> Option<Failed> {
    let mut search = Search { values, writes: true, found: None };
    search.place(target, Use::Write, Extent::Unknown);
    search.found
}

struct Search<'a> {
    values: &'a Values<'a>,
    /// The statement is an assignment, and the place looked at its target.
    writes: bool,
    found: Option<Failed>,
}

impl Search<'_> {
    fn written(&self, value: &Value) -> String {
        format!("`{}`", one_line(self.values.slice(value.span)))
    }
}

impl<'t> Visit<'t> for Search<'_> {
    fn value(&mut self, value: &'t Value) {
        if self.found.is_some() {
            return;
        }
        let holds = |value: &Value| self.values.compute(value).map(|bits| bits & 1 == 1);
        match &value.kind {
            // What is not computed cannot fail.
            ValueKind::AndThen(a, b) | ValueKind::OrElse(a, b) => {
                let decides = matches!(value.kind, ValueKind::OrElse(..));
                let goes_on = holds(a) == Some(!decides);
                self.value(a);
                if goes_on {
                    self.value(b);
                }
            }
            ValueKind::Choose { condition, a, b } => {
                let chosen = holds(condition).map(|holds| if holds { a } else { b });
                self.value(condition);
                if let Some(chosen) = chosen {
                    self.value(chosen);
                }
            }
            // What is called is another story.
            ValueKind::Call(_) | ValueKind::After(..) => {}
            ValueKind::Checked { op, failed, args } => {
                visit::value(self, value);
                let mut words = [0; 4];
                let known = words.iter_mut().zip(args).all(|(word, arg)| self.values.compute(arg).map(|bits| *word = bits).is_some());
                if self.found.is_some() || !known || failed.eval(words) & 1 == 0 {
                    return;
                }
                let copies = *op == sieben_engine::ir::Op::Copy;
                let sentence = match failed {
                    _ if fails_of_division(*failed) && !copies && words[1] == 0 => S::StDividesByZero,
                    sieben_engine::ir::Op::OverflowsF32 | sieben_engine::ir::Op::OverflowsF64 => S::StNoNumber,
                    _ if copies => S::StNoResult,
                    _ => S::StOverflow,
                };
                self.found = Some(Failed { clause: Clause::new(sentence).with("text", self.written(value)), ends: false });
            }
            _ => visit::value(self, value),
        }
    }

    fn place(&mut self, place: &'t Place, how: Use, _: Extent<'t>) {
        visit::indexes(self, place);
        if self.found.is_some() {
            return;
        }
        let Some((index, number)) = self.values.index_outside(place) else { return };
        let sentence = match (index.check, how) {
            _ if self.writes && how == Use::Write => S::StIndexWrite,
            (Bounds::Fault, _) => S::StIndexLeft,
            _ => S::StIndexRead,
        };
        let high = index.low.saturating_add(i64::try_from(index.count).unwrap_or(i64::MAX)).saturating_sub(1);
        let clause = Clause::new(sentence)
            .with("index", number.to_string())
            .with("place", format!("`{}`", one_line(self.values.slice(place.span))))
            .with("low", index.low.to_string())
            .with("high", high.to_string());
        self.found = Some(Failed { clause, ends: sentence != S::StIndexRead });
    }
}
