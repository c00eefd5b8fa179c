//! FOR, WHILE, REPEAT. The condition stands at the end of a loop, so that a pass has one branch; that of a WHILE stands in front of it
//! too, so that a loop is entered at its beginning alone, and machine code sees it as one.

use sieben_engine::fault::lost;
use sieben_engine::ir::{Op, Var};
use sieben_model::address::Width;
use sieben_model::source::Span;

use super::arithmetic::{add_overflows, bits, number, op};
use super::counting::Open;
use super::{Label, Loop, Lowering, width};
use crate::coverage::Label as Called;
use crate::st::standard::operators::{Operation, limits};
use crate::st::tree::{For, Scalar, Statement, Value, ValueKind};

/// What a FOR compares with: a constant or a value in hidden local data.
#[derive(Clone, Copy)]
enum Bound {
    Constant(i128),
    Hidden(u32),
}

impl Lowering<'_> {
    pub(super) fn leave_loop(&mut self, depth: u32, to: impl Fn(&Loop) -> Label) {
        let index = self.loops.len().checked_sub(1 + depth as usize);
        let to = index.and_then(|index| self.loops.get(index)).map_or(self.behind, to);
        self.leave_to(to);
    }

    /// The body of a loop, with what EXIT and CONTINUE mean in it.
    fn body(&mut self, body: &[Statement], next: Label) {
        let around = Loop { end: self.behind, next };
        self.loops.push(around);
        let span = self.span;
        self.statements(body);
        self.span = span;
        self.loops.pop();
        self.behind = around.end;
    }

    pub(super) fn while_loop(&mut self, condition: &Value, body: &[Statement]) {
        let [first, test] = [self.label(), self.label()];
        let mut decision = self.decision_of("WHILE", condition);
        let out = self.way(&decision, self.behind);
        self.span = condition.span;
        self.fresh();
        self.branch(condition, out, false);
        self.part();
        self.bind(first);
        self.came(&mut decision, 1);
        self.body(body, test);
        self.span = condition.span;
        self.bind(test);
        self.branch(condition, first, true);
        self.part();
        if decision.is_some() {
            self.bind(out);
            self.came(&mut decision, 0);
        }
        self.decided(decision);
    }

    pub(super) fn repeat_loop(&mut self, body: &[Statement], until: &Value) {
        let [first, test] = [self.label(), self.label()];
        self.bind(first);
        self.body(body, test);
        let mut decision = self.decision_of("UNTIL", until);
        let again = self.way(&decision, first);
        self.span = until.span;
        self.bind(test);
        self.count_statement();
        self.branch(until, again, false);
        self.part();
        self.came(&mut decision, 1);
        if decision.is_some() {
            self.leave_to(self.behind);
            self.bind(again);
            self.came(&mut decision, 0);
            self.leave_to(first);
        }
        self.decided(decision);
    }

    pub(super) fn for_loop(&mut self, for_loop: &For) {
        let For { scalar, each_pass, body, .. } = for_loop;
        let (scalar, each_pass) = (*scalar, *each_pass);
        let entering = Span { end: for_loop.by.span.end.max(for_loop.to.span.end), ..for_loop.variable.span };
        let named = |open: Open| open.outcome(Called::Word("not entered")).outcome(Called::Word("entered"));
        // Whoever tests before each pass does not know whether it was the first one.
        let mut decision = self.decision("FOR", entering).filter(|_| !each_pass).map(named);
        let out = self.way(&decision, self.behind);
        let constant = |value: &Value| match value.kind {
            ValueKind::Constant(bits) => Some(number(scalar, bits)),
            _ => None,
        };
        let (from, to, by) = (constant(&for_loop.from), constant(&for_loop.to), constant(&for_loop.by));
        let variable = self.freeze(&for_loop.variable);
        let first_value = self.value(&for_loop.from);
        let inside = self.store_inside(&variable, width(scalar), first_value);
        self.release(first_value);
        let gated = inside.is_some();
        // Without its first value the loop is left out: a control variable that is not there would never reach its last value.
        if let Some(inside) = inside {
            let out = if by == Some(0) { self.behind } else { out };
            self.branch_on(inside, out, false);
            self.release(inside);
            self.part();
        } else if self.fallible {
            self.part();
        }

        let [first, next, test] = [self.label(), self.label(), self.label()];
        if each_pass && (to.is_none() || by.is_none()) {
            self.bind(test);
        }
        let to = self.bound(&for_loop.to, to, width(scalar));
        let by = self.bound(&for_loop.by, by, width(scalar));
        // A step of 0 leaves the loop.
        match by {
            Bound::Constant(0) => {
                let always = self.constant(1);
                self.lost_if(always, lost::STEP, always);
                self.release(always);
                return self.leave_to(self.behind);
            }
            Bound::Constant(_) => {}
            Bound::Hidden(position) => {
                let step = self.load_local(position, width(scalar));
                let is_zero = self.compute_with(Op::Equal, step, 0);
                self.lost_if(is_zero, lost::STEP, is_zero);
                self.branch_on(is_zero, out, true);
                self.release(is_zero);
                self.part();
            }
        }
        let enters = match (from, to, by) {
            (Some(from), Bound::Constant(to), Bound::Constant(by)) => {
                if by > 0 {
                    from <= to
                } else {
                    from >= to
                }
            }
            _ => false,
        };
        if !enters {
            let value = self.load(&variable, width(scalar));
            let past = self.compare(value, scalar, to, by, [Operation::Greater, Operation::Less]);
            self.branch_on(past, out, true);
            self.release(past);
            self.part();
        }
        self.came(&mut decision, 1);
        self.bind(first);
        self.body(body, next);
        self.span = for_loop.variable.span;
        self.bind(next);

        // One step on; past the last value of the type the loop ends.
        let value = self.load(&variable, width(scalar));
        let step = self.bound_value(by, scalar);
        let (least, most) = limits(scalar);
        let may_overflow = match (to, by) {
            (Bound::Constant(to), Bound::Constant(by)) => !(least..=most).contains(&(to + by)),
            _ => true,
        };
        let overflow = may_overflow.then(|| self.compute_from(add_overflows(scalar), &[value, step]));
        let sum = self.compute(op(Operation::Add, scalar), &[value, step]);
        self.store(&variable, width(scalar), sum);
        if each_pass && !matches!((to, by), (Bound::Constant(_), Bound::Constant(_))) {
            if let Some(overflow) = overflow {
                self.branch_on(overflow, self.behind, true);
                self.release(overflow);
            }
            self.release(sum);
            self.part();
            self.leave_to(test);
            return self.not_entered(decision, out);
        }
        let mut goes_on = self.compare(sum, scalar, to, by, [Operation::LessEqual, Operation::GreaterEqual]);
        if let Some(overflow) = overflow {
            goes_on = self.compute(Op::AndNot, &[goes_on, overflow]);
        }
        self.branch_on(goes_on, first, true);
        self.release(goes_on);
        self.part();
        if !enters || gated {
            self.not_entered(decision, out);
        }
    }

    /// The outcome of a loop that was not entered.
    fn not_entered(&mut self, mut decision: Option<Open>, out: Label) {
        if decision.is_some() {
            self.leave_to(self.behind);
            self.bind(out);
            self.came(&mut decision, 0);
        }
        self.decided(decision);
    }

    fn bound(&mut self, value: &Value, constant: Option<i128>, width: Width) -> Bound {
        match constant {
            Some(constant) => Bound::Constant(constant),
            None => {
                let var = self.value(value);
                Bound::Hidden(self.spill(var, width))
            }
        }
    }

    fn bound_value(&mut self, bound: Bound, scalar: Scalar) -> Var {
        match bound {
            Bound::Constant(constant) => self.constant(bits(scalar, constant)),
            Bound::Hidden(position) => self.load_local(position, width(scalar)),
        }
    }

    /// Compares a value of the control variable, which is used up, with the last value: in one way if the step is positive, in the
    /// other if it is negative.
    fn compare(&mut self, value: Var, scalar: Scalar, to: Bound, by: Bound, [rising, falling]: [Operation; 2]) -> Var {
        let to = self.bound_value(to, scalar);
        match by {
            Bound::Constant(by) => self.compute(op(if by > 0 { rising } else { falling }, scalar), &[value, to]),
            Bound::Hidden(position) => {
                let up = self.compute_from(op(rising, scalar), &[value, to]);
                let down = self.compute(op(falling, scalar), &[value, to]);
                let step = self.load_local(position, width(scalar));
                let falls = self.compute_with(op(Operation::Less, scalar), step, 0);
                self.compute(Op::Select, &[falls, down, up])
            }
        }
    }
}
