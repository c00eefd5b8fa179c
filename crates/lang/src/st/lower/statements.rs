//! Statements but loops.

use std::collections::BTreeMap;

use sieben_engine::ir::{Inst, Op, Target, Var};
use sieben_model::address::Width;

use super::arithmetic::{bits, number, op};
use super::{Label, Lowering, width};
use crate::coverage::Label as Called;
use crate::st::standard::operators::Operation;
use crate::st::tree::{Branch, Place, Scalar, Statement, StatementKind, Value, ValueKind};

/// Targets that a jump table may have for each label of a CASE: more cost more memory than comparing costs time.
const TABLE_TARGETS_PER_LABEL: i128 = 4;
/// Targets that a jump table of a CASE may have in all.
const TABLE_TARGETS_MAX: i128 = 4_096;
/// Labels from which on a jump table or a search pays.
const TABLE_LABELS_MIN: usize = 4;
/// Ranges that are compared one after another at the end of a search.
const CHAIN_MAX: usize = 4;

/// Values of the selector that lead to one branch.
#[derive(Clone, Copy, Debug)]
struct Range {
    low: i128,
    high: i128,
    to: Label,
}

impl Lowering<'_> {
    /// Statements one after another.
    pub(super) fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            self.statement(statement);
        }
    }

    /// Statements inside another one.
    pub(super) fn inner_statements(&mut self, statements: &[Statement]) {
        let (span, behind) = (self.span, self.behind);
        self.statements(statements);
        self.span = span;
        self.behind = behind;
        self.fresh();
    }

    fn statement(&mut self, statement: &Statement) {
        if let StatementKind::Block(statements) = &statement.kind {
            return self.statements(statements);
        }
        self.span = statement.span;
        let around = std::mem::replace(&mut self.statement, statement.span);
        self.fresh();
        if !matches!(statement.kind, StatementKind::Label(_)) {
            self.count_statement();
        }
        let mark = self.hidden.mark();
        let outer = std::mem::replace(&mut self.behind, Label(0));
        self.behind = self.label();
        match &statement.kind {
            StatementKind::Assign { target, value } => self.assign(target, value),
            StatementKind::Copy { target, source, bytes } => self.copy_bytes(target, source, *bytes),
            StatementKind::AssignString { target, room, source } => self.assign_text(target, *room, source),
            StatementKind::Call(call) => self.call(call),
            StatementKind::If { branches, otherwise } => self.if_statement(branches, otherwise),
            StatementKind::Case { selector, branches, otherwise } => self.case_statement(selector, branches, otherwise),
            StatementKind::For(for_loop) => self.for_loop(for_loop),
            StatementKind::While { condition, body } => self.while_loop(condition, body),
            StatementKind::Repeat { body, until } => self.repeat_loop(body, until),
            StatementKind::Exit { depth } => self.leave_loop(*depth, |around| around.end),
            StatementKind::Continue { depth } => self.leave_loop(*depth, |around| around.next),
            StatementKind::Return => self.leave_to(self.exit),
            StatementKind::Label(name) => {
                let label = self.named(*name);
                self.bind(label);
            }
            StatementKind::Goto(name) => {
                let label = self.named(*name);
                self.leave_to(label);
            }
            StatementKind::SetOk(value) => {
                let value = self.value(value);
                match self.ok {
                    Some(ok) => self.store_local(ok, Width::Bit, value),
                    None => self.release(value),
                }
            }
            StatementKind::Intrinsic { intrinsic, args } => {
                let nothing = self.intrinsic(*intrinsic, args);
                self.release(nothing);
            }
            StatementKind::Block(_) => {}
        }
        let behind = self.behind;
        self.bind_behind(behind);
        self.behind = outer;
        self.statement = around;
        self.hidden.give_back(mark);
    }

    fn named(&mut self, name: u32) -> Label {
        if let Some(&label) = self.gotos.get(&name) {
            return label;
        }
        let label = self.label();
        self.gotos.insert(name, label);
        label
    }

    fn assign(&mut self, target: &Place, value: &Value) {
        let var = self.value(value);
        self.store_value(target, width(value.scalar), var);
    }

    /// Writes a value, which is used up, to a place whose indexes are computed after it.
    pub(super) fn store_value(&mut self, target: &Place, width: Width, mut var: Var) {
        if self.place_breaks(target) {
            let position = self.spill(var, width);
            let target = self.freeze(target);
            var = self.load_local(position, width);
            self.store(&target, width, var);
        } else {
            self.store(target, width, var);
        }
        self.release(var);
    }

    fn if_statement(&mut self, branches: &[(Value, Vec<Statement>)], otherwise: &[Statement]) {
        let end = self.behind;
        for (index, (condition, body)) in branches.iter().enumerate() {
            let is_last = index + 1 == branches.len() && otherwise.is_empty();
            let mut decision = self.decision_of(if index == 0 { "IF" } else { "ELSIF" }, condition);
            let next = if is_last { self.way(&decision, end) } else { self.label() };
            self.span = condition.span;
            // What was begun behind the branch before belongs to this condition.
            self.fresh();
            if index > 0 {
                self.count_statement();
            }
            self.branch(condition, next, false);
            self.part();
            self.came(&mut decision, 1);
            self.statements(body);
            if !is_last {
                self.leave_to(end);
                self.bind(next);
                self.came(&mut decision, 0);
            } else {
                self.end_way(&mut decision, 0, next, end);
            }
            self.decided(decision);
        }
        self.statements(otherwise);
        self.fresh();
    }

    // CASE.

    fn case_statement(&mut self, selector: &Value, branches: &[Branch], otherwise: &[Statement]) {
        let labels: Vec<Label> = branches.iter().map(|_| self.label()).collect();
        let end = self.behind;
        let is_open = !matches!(selector.kind, ValueKind::Constant(_));
        let mut decision = self.decision("CASE", selector.span).filter(|_| is_open).map(|open| {
            let named = branches.iter().fold(open, |open, branch| open.outcome(Called::Source(branch.span)));
            named.outcome(Called::Word(if otherwise.is_empty() { "no label" } else { "ELSE" }))
        });
        let none = if otherwise.is_empty() { self.way(&decision, end) } else { self.label() };
        let ranges = ranges(branches, &labels);
        if let ValueKind::Constant(constant) = selector.kind {
            let value = number(selector.scalar, constant);
            let to = ranges.iter().find(|range| (range.low..=range.high).contains(&value)).map_or(none, |range| range.to);
            self.leave_to(to);
        } else {
            let var = self.value(selector);
            self.part_of_case(var, selector, &ranges, none);
        }
        for (index, (label, branch)) in labels.iter().zip(branches).enumerate() {
            self.bind(*label);
            self.came(&mut decision, index);
            self.statements(&branch.body);
            self.leave_to(end);
        }
        if !otherwise.is_empty() {
            self.bind(none);
            self.came(&mut decision, branches.len());
            self.statements(otherwise);
        } else {
            self.end_way(&mut decision, branches.len(), none, end);
        }
        self.decided(decision);
        self.fresh();
    }

    /// Goes to the branch of a selector, by a table, a search or one comparison after another.
    fn part_of_case(&mut self, selector: Var, value: &Value, ranges: &[Range], none: Label) {
        let scalar = value.scalar;
        let (Some(first), Some(last)) = (ranges.first(), ranges.last()) else {
            self.release(selector);
            return self.leave_to(none);
        };
        let span = last.high - first.low + 1;
        if ranges.len() >= TABLE_LABELS_MIN && span <= TABLE_TARGETS_MAX && span <= ranges.len() as i128 * TABLE_TARGETS_PER_LABEL {
            let mut targets = Vec::with_capacity(span as usize);
            for range in ranges {
                targets.resize((range.low - first.low) as usize, Target(none.0));
                targets.resize((range.high - first.low + 1) as usize, Target(range.to.0));
            }
            let index = if first.low == 0 {
                selector
            } else {
                self.compute_with(op(Operation::Subtract, scalar), selector, bits(scalar, first.low))
            };
            let count = targets.len() as u32;
            let first = self.b.table(&targets);
            self.push(Inst::JumpTable { index, first, count, otherwise: Target(none.0) });
            self.release(index);
            self.begin();
            // Only a selector that failed comes here.
            self.jump(self.behind);
            return self.begin();
        }
        if ranges.len() <= CHAIN_MAX {
            self.chain(selector, scalar, ranges);
            self.release(selector);
            // A selector that failed goes to the end: it must not take a way of its own.
            if self.fallible {
                self.jump(none);
                self.begin();
                self.jump(self.behind);
                return self.begin();
            }
            return self.leave_to(none);
        }
        let position = self.spill(selector, width(scalar));
        self.part();
        self.search((position, scalar), ranges, none);
    }

    fn search(&mut self, (position, scalar): (u32, Scalar), ranges: &[Range], none: Label) {
        self.fresh();
        let selector = self.load_local(position, width(scalar));
        if ranges.len() <= CHAIN_MAX {
            self.chain(selector, scalar, ranges);
            self.release(selector);
            return self.leave_to(none);
        }
        let (below, above) = ranges.split_at(ranges.len() / 2);
        let right = self.label();
        if let Some(pivot) = above.first() {
            let pivot = self.constant(bits(scalar, pivot.low));
            let is_below = self.compute(op(Operation::Less, scalar), &[selector, pivot]);
            self.branch_on(is_below, right, false);
        }
        self.begin();
        self.search((position, scalar), below, none);
        self.bind(right);
        self.search((position, scalar), above, none);
    }

    /// Compares with one range after another; the selector stays.
    fn chain(&mut self, selector: Var, scalar: Scalar, ranges: &[Range]) {
        for range in ranges {
            let low = self.constant(bits(scalar, range.low));
            let hit = if range.low == range.high {
                let hit = self.compute_from(Op::Equal, &[selector, low]);
                self.release(low);
                hit
            } else {
                // One unsigned comparison of the distance from the lowest value.
                let distance = self.compute_from(op(Operation::Subtract, scalar), &[selector, low]);
                self.release(low);
                self.compute_with(Op::LeU64, distance, bits(scalar, range.high - range.low))
            };
            self.push(Inst::Branch { condition: hit, to: Target(range.to.0) });
            self.release(hit);
        }
    }
}

/// The values of all branches, in ascending order, none twice: the first branch in the source counts.
fn ranges(branches: &[Branch], labels: &[Label]) -> Vec<Range> {
    let mut all: BTreeMap<i128, Range> = BTreeMap::new();
    for (branch, &to) in branches.iter().zip(labels) {
        for &(low, high) in &branch.ranges {
            // What earlier labels leave of the range.
            let before = all.range(..low).next_back().map(|(_, taken)| taken.high);
            let mut low = before.map_or(low, |taken| low.max(taken + 1));
            let mut pieces = Vec::new();
            if low <= high {
                for taken in all.range(low..=high).map(|(_, taken)| taken) {
                    if taken.low > low {
                        pieces.push(Range { low, high: taken.low - 1, to });
                    }
                    low = taken.high + 1;
                }
            }
            if low <= high {
                pieces.push(Range { low, high, to });
            }
            all.extend(pieces.into_iter().map(|piece| (piece.low, piece)));
        }
    }
    all.into_values().collect()
}
