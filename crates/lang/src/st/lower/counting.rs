//! What is counted in tests: each outcome of a decision is an IR statement of its own, which does nothing. Without counting there are none.

use sieben_model::source::Span;

use super::{Label, Lowering};
use crate::coverage::{Countable, Decision, Label as Called, Outcome, Seen};
use crate::st::tree::{Value, ValueKind};

/// A decision whose outcomes are being lowered.
pub(super) struct Open {
    word: &'static str,
    span: Span,
    outcomes: Vec<Outcome>,
}

impl Open {
    /// One more thing that can come of it; its number among them.
    pub(super) fn outcome(mut self, label: Called) -> Self {
        self.outcomes.push(Outcome { label, seen: Seen::default() });
        self
    }
}

impl Lowering<'_> {
    /// The source statement that begins here.
    pub(super) fn count_statement(&mut self) {
        let here = self.b.here().0;
        if let Some(counted) = &mut self.counted {
            counted.statements.push((self.span, Seen::ran(here)));
        }
    }

    /// A decision of the source, if decisions are counted.
    pub(super) fn decision(&self, word: &'static str, span: Span) -> Option<Open> {
        self.counted.as_ref().map(|_| Open { word, span, outcomes: Vec::new() })
    }

    /// The decision of a condition: FALSE, then TRUE. What is known beforehand decides nothing.
    pub(super) fn decision_of(&self, word: &'static str, condition: &Value) -> Option<Open> {
        // A condition that the checker made has no place of its own.
        if matches!(condition.kind, ValueKind::Constant(_)) || condition.span == self.statement {
            return None;
        }
        Some(self.decision(word, condition.span)?.outcome(Called::Word("FALSE")).outcome(Called::Word("TRUE")))
    }

    /// Whoever comes here has seen this outcome.
    pub(super) fn came(&mut self, decision: &mut Option<Open>, outcome: usize) {
        let Some(open) = decision else { return };
        self.fresh();
        let number = self.b.here().0;
        let behind = self.label();
        self.jump(behind);
        self.bind(behind);
        if let Some(outcome) = open.outcomes.get_mut(outcome) {
            outcome.seen.ran.push(number);
        }
    }

    /// Where an outcome leads that without counting leads straight to `to`.
    pub(super) fn way(&mut self, decision: &Option<Open>, to: Label) -> Label {
        if decision.is_some() { self.label() } else { to }
    }

    /// The way of an outcome: it goes on to `to`, and what comes before does too.
    pub(super) fn end_way(&mut self, decision: &mut Option<Open>, outcome: usize, way: Label, to: Label) {
        if decision.is_some() {
            self.leave_to(to);
            self.bind(way);
            self.came(decision, outcome);
            self.leave_to(to);
        }
    }

    /// The decision is lowered; one of which less than two things can come is none.
    pub(super) fn decided(&mut self, decision: Option<Open>) {
        if let (Some(open), Some(counted)) = (decision, &mut self.counted)
            && open.outcomes.iter().filter(|outcome| !outcome.seen.ran.is_empty()).count() > 1
        {
            counted.decisions.push(Decision { word: open.word, span: open.span, outcomes: open.outcomes });
        }
    }
}

/// What is counted in a block that was lowered, in the order of the source.
pub(super) fn in_order(mut counted: Countable) -> Countable {
    counted.decisions.sort_by_key(|decision| (decision.span.start, decision.span.end));
    counted
}
