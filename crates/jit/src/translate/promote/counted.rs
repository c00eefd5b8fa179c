//! The budget of a loop that counts: in a loop of which each turn adds 1 to a variable, or subtracts it, the budget is as far from the variable
//! in one turn as in the next. What is kept in a register is that distance, which no turn changes, and the variable alone counts.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, Value};
use cranelift_frontend::Variable;
use sieben_engine::ir::{Inst, Place};
use sieben_model::address::Width;

use super::super::Translator;
use super::super::loops::{Loop, made_by, targets};
use super::super::ranges::step_of;
use super::super::value::Val;
use super::{Base, Promoted};

/// How the budget's variable is to be read in a loop that counts.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Counted {
    /// What stands for the variable that counts, and how long that is.
    counter: Variable,
    width: Width,
    /// The instruction that stores it one further.
    store: u32,
    /// Whether it counts down, as the budget does: the budget is the counter less the budget's variable then, and else the other way round.
    down: bool,
    /// First and last statement of the loop.
    first: u32,
    last: u32,
}

/// A step of a counter: the instruction that stores it, and whether it counts down.
struct Step {
    store: u32,
    down: bool,
    place: (Base, i32, Width),
}

impl Translator<'_> {
    /// Lets the budget be counted by a variable of a loop that begins now, if one does.
    pub(in super::super) fn count_budget(&mut self, it: &Loop) {
        if !self.options.optimize || self.cold.is_some() || self.taken != 0 || !it.calls_nothing {
            return;
        }
        let Some(step) = self.step_of_each_turn(it) else { return };
        let is_it = |kept: &&Promoted| (kept.base, kept.offset, kept.width) == step.place && kept.written && kept.handed.is_none();
        let Some(counter) = self.kept().iter().find(is_it).map(|kept| kept.variable) else { return };
        let counted = Counted { counter, width: step.place.2, store: step.store, down: step.down, first: it.first, last: it.last };
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let count = self.counter(counted);
        let distance = if counted.down { self.b.ins().isub(count, budget) } else { self.b.ins().iadd(budget, count) };
        self.b.def_var(variable, distance);
        self.counted = Some(counted);
    }

    /// The last statement of a loop that nobody jumps over in it and that does nothing but to count.
    fn step_of_each_turn(&self, it: &Loop) -> Option<Step> {
        let code = &self.native().code;
        let has_loops = self.loops.iter().any(|other| other.first > it.first && other.last <= it.last);
        let insts =
            (it.first..=it.last).flat_map(|statement| (code.statements[statement as usize]..).zip(code.statement(statement as usize)));
        let ends_block = it.last as usize + 1 >= code.statement_count();
        if has_loops || ends_block || self.turn_of(it.first).is_some() || self.native().weight_of_jump((it.last, it.first)) != 1 {
            return None;
        }
        // Turns that are written out take from the budget, too.
        if self.native().turns().iter().any(|turns| it.contains(turns.first)) {
            return None;
        }
        // One more number that no turn changes would take a register where there is cold code in each turn.
        if !insts.clone().all(|(index, inst)| self.asks_nobody(index, inst)) {
            return None;
        }
        // Each turn comes to this statement once.
        let is_passed = |statement: u32| {
            (it.first..=it.last).all(|from| {
                let mut to = code.statement(from as usize).iter().flat_map(|inst| targets(code, inst));
                to.all(|to| {
                    !it.contains(to) || if from < statement { (from + 1..=statement).contains(&to) } else { to == it.first || to > from }
                })
            })
        };
        let mut steps = (it.first..=it.last).rev().filter(|&statement| is_passed(statement)).filter_map(|statement| self.step(statement));
        steps.find(|step| {
            let is_there = |index: u32, place: Place, width: Width| self.place_of(index, place, width, true) == Some(step.place);
            !insts.clone().any(|(index, inst)| match *inst {
                Inst::Store { place, width, .. } => index != step.store && is_there(index, place, width),
                _ => false,
            })
        })
    }

    /// The step with which a statement begins, if it does: nothing else happens in front of it.
    fn step(&self, statement: u32) -> Option<Step> {
        let code = &self.native().code;
        let first = code.statements[statement as usize];
        let insts = code.statement(statement as usize);
        let at = insts.iter().position(|inst| !matches!(inst, Inst::Load { .. } | Inst::Constant { .. } | Inst::Compute { .. }))?;
        let Inst::Store { place, width, src } = insts[at] else { return None };
        let (sum, Inst::Compute { op, args: [counter, one, ..], .. }) = made_by(&insts[..at], src)? else { return None };
        let (_, Inst::Load { place: from, width: read, .. }) = made_by(&insts[..sum], counter)? else { return None };
        let (_, Inst::Constant { value, .. }) = made_by(&insts[..sum], one)? else { return None };
        let (bits, down) = step_of(op, value)?;
        if (from, read, bits) != (place, width, width.bits()) || !self.ranges.is_step(first + sum as u32) {
            return None;
        }
        let index = first + at as u32;
        let place = self.place_of(index, place, width, true)?;
        Some(Step { store: index, down, place })
    }

    /// Whether an instruction asks nobody, whatever happens: who is asked may change what counts behind where it was read.
    fn asks_nobody(&self, index: u32, inst: &Inst) -> bool {
        match *inst {
            Inst::Constant { .. } | Inst::Compute { .. } | Inst::Jump { .. } | Inst::Branch { .. } | Inst::JumpTable { .. } => true,
            Inst::Load { place, width, .. } => self.is_there(index, place, width) || self.place_of(index, place, width, false).is_some(),
            Inst::Store { place, width, .. } => self.is_there(index, place, width) || self.place_of(index, place, width, true).is_some(),
            Inst::Move { .. } => self.ranges.moved(index).is_some(),
            Inst::Require { .. } => self.ranges.is_met(index),
            _ => false,
        }
    }

    fn place_of(&self, index: u32, place: Place, width: Width, written: bool) -> Option<(Base, i32, Width)> {
        let known = self.constant_address(place, width).or_else(|| self.ranges.pointed(index));
        let (base, offset) = known.or_else(|| self.instance_address(place, width, written))?;
        Some((base, offset, width))
    }

    /// The variable that counts, as a number with sign.
    fn counter(&mut self, counted: Counted) -> Value {
        let value = self.b.use_var(counted.counter);
        self.as_count(counted, value)
    }

    fn as_count(&mut self, counted: Counted, value: Value) -> Value {
        match counted.width {
            Width::Word => {
                let number = self.i16(Val::Int(value));
                if number == value { self.b.ins().uextend(I64, number) } else { self.b.ins().sextend(I64, number) }
            }
            _ => self.i64(Val::Int(value)),
        }
    }

    /// The budget, and what has been taken from it, as its variable has it.
    pub(super) fn budget_there(&mut self, variable: Value) -> Value {
        let Some(counted) = self.counted else { return variable };
        let count = self.counter(counted);
        if counted.down { self.b.ins().isub(count, variable) } else { self.b.ins().isub(variable, count) }
    }

    /// The same for a budget that was read.
    pub(super) fn budget_as_kept(&mut self, budget: Value) -> Value {
        let Some(counted) = self.counted else { return budget };
        let count = self.counter(counted);
        if counted.down { self.b.ins().isub(count, budget) } else { self.b.ins().iadd(budget, count) }
    }

    /// What the budget's variable is less so much.
    pub(in super::super) fn less_budget(&mut self, variable: Value, taken: i64) -> Value {
        let taken = if self.counted.is_some_and(|counted| counted.down) { taken } else { -taken };
        self.b.ins().iadd_imm_s(variable, taken)
    }

    /// Whether the budget is used up, behind a turn of a loop that counts.
    pub(in super::super) fn counted_down(&mut self) -> Option<Value> {
        let counted = self.counted?;
        let count = self.counter(counted);
        let variable = self.budget();
        let limit = self.b.use_var(variable);
        let beyond = if counted.down { IntCC::SignedLessThan } else { IntCC::SignedGreaterThan };
        Some(self.b.ins().icmp(beyond, count, limit))
    }

    /// Gives what stands for a variable another value, which may be one further than before; the budget stays what it is.
    pub(super) fn define(&mut self, promoted: &Promoted, value: Value, is_step: bool) {
        if let Some(counted) = self.counted.filter(|it| it.counter == promoted.variable) {
            if is_step {
                self.taken -= 1;
            } else {
                let before = self.counter(counted);
                let now = self.as_count(counted, value);
                let further = self.b.ins().isub(now, before);
                let variable = self.budget();
                let distance = self.b.use_var(variable);
                let distance = self.b.ins().iadd(distance, further);
                self.b.def_var(variable, distance);
            }
        }
        self.b.def_var(promoted.variable, value);
    }

    /// Whether an instruction that stores a value counts one further.
    pub(in super::super) fn is_step_of_turn(&self, index: u32) -> bool {
        self.cold.is_none() && self.counted.is_some_and(|it| it.store == index)
    }

    /// Whether a statement is outside of the loop that counts the budget.
    pub(in super::super) fn leaves_counted(&self, to: u32) -> bool {
        self.counted.is_some_and(|it| !(it.first..=it.last).contains(&to))
    }

    /// Lets the budget's variable be the budget again on a way out of the loop.
    pub(super) fn leave_counted(&mut self, to: u32) {
        if !self.leaves_counted(to) {
            return;
        }
        let variable = self.budget();
        let distance = self.b.use_var(variable);
        let budget = self.budget_there(distance);
        self.b.def_var(variable, budget);
        self.counted = None;
    }
}
