//! Superword-level parallelism for calls of one function block that follow one another, each with the next of its instances: their
//! arguments are written before all of them, then the block runs for four instances in lanes, and what stands between and after the calls
//! comes last. That is done where no statement that moves past another one reads or writes what the other one writes, and where there is no
//! slow path.

use std::ops::Range;

use sieben_engine::ir::{Callee, Inst, OnFault, Op, Place, Var};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockKind;

use super::loop_optimizer::slp_calls::{Bytes, Calls, ITERATIONS};
use super::natural_loops::targets;
use super::safepoint_coalescing::WEIGHT_MAX;
use super::value::Val;
use super::{OPEN_BLOCKS, Translator};
use crate::passes::Pass;

/// A call of a function block with an instance in that of the caller, as statements in ST make it.
#[derive(Clone, Debug)]
struct Call {
    statement: u32,
    /// Instructions that write what it is handed, and the call itself.
    head: Range<u32>,
    call: u32,
    called: usize,
    /// The pointer to its instance.
    pointer: u32,
}

/// Calls that were written side by side, of which the rest is still to be written.
pub(super) struct SlpGroup {
    calls: Vec<Call>,
    after: Vec<(Register, u64)>,
    weight: i64,
}

/// What some instructions read and write.
#[derive(Default)]
struct ModRefSet {
    reads: Vec<Bytes>,
    writes: Vec<Bytes>,
}

impl ModRefSet {
    fn add(&mut self, other: Self) {
        self.reads.extend(other.reads);
        self.writes.extend(other.writes);
    }

    fn reads_any(&self, bytes: &[Bytes]) -> bool {
        share(&self.reads, bytes)
    }

    fn writes_any(&self, bytes: &[Bytes]) -> bool {
        share(&self.writes, bytes)
    }
}

fn share(some: &[Bytes], others: &[Bytes]) -> bool {
    some.iter().any(|(base, bytes)| others.iter().any(|(other, range)| base.may_share(bytes, *other, range)))
}

impl Translator<'_> {
    /// Writes calls from the running statement on side by side, if they can be; the rest of their statements is written as these come.
    pub(super) fn begin_series(&mut self) {
        if self.series.is_some() || !self.may_have_series() {
            return;
        }
        let Some(calls) = self.calls_in_series() else { return };
        let (first, step) = (calls[0].pointer, calls[1].pointer - calls[0].pointer);
        let Some(all) = self.read_calls(calls[0].called, (first, step, calls.len() as u32)) else { return };
        let most = self.left_of_look() / all.weight.max(1);
        let count = self.stay_in_series(&calls, &all).min(most as usize) / ITERATIONS as usize * ITERATIONS as usize;
        if count == 0 || !self.is_looked_at(all.weight * count as i64) {
            return;
        }
        let statement = self.statement;
        for call in &calls[..count] {
            self.statement = call.statement;
            self.aim = None;
            self.temporaries.clear();
            self.bounds.clear();
            self.fixed.clear();
            for index in call.head.clone() {
                self.inst(index, &self.native().code.insts[index as usize]);
            }
        }
        self.statement = statement;
        self.temporaries.clear();
        self.bounds.clear();
        self.fixed.clear();
        self.call_side_by_side(&all, count as u32);
        self.series = Some(SlpGroup { calls: calls[..count].to_vec(), after: all.after, weight: all.weight });
    }

    /// Ends a series behind its last statement.
    pub(super) fn end_series(&mut self) {
        if self.series.as_ref().is_some_and(|series| series.calls.last().is_some_and(|call| call.statement == self.statement)) {
            self.series = None;
        }
    }

    /// Whether an instruction was written with a series; what is known behind a call is noted.
    pub(super) fn is_in_series(&mut self, index: u32) -> bool {
        let Some(series) = &self.series else { return false };
        if series.calls.iter().any(|call| call.call == index) {
            let (after, weight) = (series.after.clone(), series.weight);
            self.taken += weight;
            after.into_iter().for_each(|(register, value)| self.set_register(register, Val::Const(value)));
            return true;
        }
        series.calls.iter().any(|call| call.head.contains(&index))
    }

    /// Whether calls from the running statement on look like a series.
    pub(super) fn may_begin_series(&self) -> bool {
        self.calls_in_series().is_some()
    }

    fn may_have_series(&self) -> bool {
        self.options.does(Pass::SlpCalls)
            && self.options.forgets_locals
            && !self.options.exact
            && self.cold.is_none()
            && self.look.is_some()
            && self.choice.is_none()
            && !self.ranges.is_relative()
            && !self.loops.iter().any(|it| it.contains(self.statement))
            && !self.keeps_memory()
    }

    /// A call that a statement makes, if it is one that can be part of a series.
    fn call_of(&self, statement: u32) -> Option<Call> {
        let code = &self.native().code;
        let first = *code.statements.get(statement as usize)?;
        let insts = code.statement(statement as usize);
        let at = insts.iter().position(|inst| matches!(inst, Inst::Call { .. }))?;
        let ar2 = Var::from(Register::Ar2);
        let Inst::Call { callee: Callee::Block(id), parameters: 0 } = insts[at] else { return None };
        let [
            Inst::Store { place: saved, width: Width::DoubleWord, src },
            Inst::Constant { dst, value },
            Inst::Compute { op: Op::AddU32, dst: moved, args },
        ] = *insts.get(at.checked_sub(3)?..at)?
        else {
            return None;
        };
        let [
            Inst::Load { dst: back, place: from, width: Width::DoubleWord, .. },
            Inst::Compute { op: Op::Copy, dst: restored, args: copied },
        ] = *insts.get(at + 1..at + 3)?
        else {
            return None;
        };
        let is_local = matches!(saved, Place::Fixed { area: Area::Local, .. }) && saved == from;
        let moves = src == ar2 && moved == ar2 && args[..2] == [ar2, dst] && restored == ar2 && copied[0] == back;
        let pointer = self.current[Register::Ar2 as usize].and_then(Val::constant)?;
        let called = (self.find)(id).filter(|_| id.kind == BlockKind::FunctionBlock)? as usize;
        (is_local && moves && self.inlines(called)).then(|| Call {
            statement,
            head: first..first + at as u32 - 3,
            call: first + at as u32,
            called,
            pointer: (pointer as u32).wrapping_add(value as u32),
        })
    }

    /// Calls of one block from the running statement on whose instances lie at equal distances.
    fn calls_in_series(&self) -> Option<Vec<Call>> {
        let mut calls = vec![self.call_of(self.statement)?];
        let code = &self.native().code;
        for statement in self.statement + 1..code.statement_count() as u32 {
            if calls.len() == WEIGHT_MAX as usize || self.arrivals.contains_key(&statement) {
                break;
            }
            let insts = code.statement(statement as usize);
            if !insts.iter().any(|inst| matches!(inst, Inst::Call { .. })) {
                continue;
            }
            let Some(call) = self.call_of(statement) else { break };
            let last = &calls[calls.len() - 1];
            let step = call.pointer.checked_sub(last.pointer).filter(|step| *step > 0 && step % 8 == 0);
            let alike = calls.len() < 2 || step == calls[1].pointer.checked_sub(calls[0].pointer);
            if step.is_none() || !alike || call.called != last.called {
                break;
            }
            calls.push(call);
        }
        let [first, last] = [&calls[0], &calls[calls.len() - 1]].map(|call| call.pointer);
        (calls.len() >= ITERATIONS as usize && first >> 24 == last >> 24).then_some(calls)
    }

    /// How many of these calls may be done before all that stands between and behind them.
    fn stay_in_series(&self, calls: &[Call], all: &Calls) -> usize {
        let mut between = ModRefSet::default();
        let mut instances: Vec<Bytes> = Vec::new();
        for (number, call) in calls.iter().enumerate() {
            let own = [all.instance(number as u32)];
            let Some(head) = self.head_of_series(call) else { return number };
            let reads_change = head.reads_any(&between.writes) || head.reads_any(&instances);
            let writes_change = head.writes_any(&between.writes) || head.writes_any(&between.reads) || head.writes_any(&instances);
            let instance_changes = between.writes_any(&own) || between.reads_any(&own);
            if reads_change || writes_change || instance_changes || head.writes_any(&all.reads) {
                return number;
            }
            instances.extend(own);
            // AR2 is as before behind the three instructions that follow the call.
            let Some(rest) = self.touched_by_series(call.statement, call.call + 3..self.end_of(call.statement), call.statement) else {
                return number;
            };
            between.add(rest);
            let Some(next) = calls.get(number + 1) else { continue };
            for statement in call.statement + 1..next.statement {
                let first = self.end_of(statement - 1);
                let Some(more) = self.touched_by_series(statement, first..self.end_of(statement), next.statement) else {
                    return number + 1;
                };
                between.add(more);
            }
            if between.writes_any(&all.reads) {
                return number + 1;
            }
        }
        calls.len()
    }

    /// The first instruction behind a statement.
    fn end_of(&self, statement: u32) -> u32 {
        let code = &self.native().code;
        code.statements.get(statement as usize + 1).copied().unwrap_or(code.insts.len() as u32)
    }

    /// What a call is handed: it rests on memory alone.
    fn head_of_series(&self, call: &Call) -> Option<ModRefSet> {
        let is_own = |var: Var| var.register().is_none();
        let is_known = |var: Var| is_own(var) || var.register().is_some_and(|it| it == Register::Ar2 || OPEN_BLOCKS.contains(&it));
        let insts = &self.native().code.insts[call.head.start as usize..call.head.end as usize];
        let is_alone = |inst: &Inst| {
            sieben_engine::ir::verify::reads(inst).all(is_known) && sieben_engine::ir::verify::writes(inst).is_none_or(is_own)
        };
        if !insts.iter().all(is_alone) {
            return None;
        }
        self.touched_by_series(call.statement, call.head.clone(), call.statement)
    }

    /// What instructions of a statement read and write, if they can neither fail nor ask nor lead behind a statement.
    fn touched_by_series(&self, statement: u32, insts: Range<u32>, most: u32) -> Option<ModRefSet> {
        let code = &self.native().code;
        let is_ahead = |inst: &Inst| targets(code, inst).all(|to| to > statement && to <= most);
        let may_change = |dst: Var| dst.register().is_none_or(|register| register != Register::Ar2 && !OPEN_BLOCKS.contains(&register));
        let bytes = |place: Place, width: Width| {
            let (base, offset) = self.constant_address(place, width)?;
            Some((base, i64::from(offset)..i64::from(offset) + i64::from(width.bytes())))
        };
        let mut touched = ModRefSet::default();
        for inst in &code.insts[insts.start as usize..insts.end as usize] {
            match *inst {
                Inst::Constant { dst, .. } | Inst::Compute { dst, .. } if may_change(dst) => {}
                Inst::Load { dst, place, width, on_fault: OnFault::SkipStatement } if may_change(dst) => {
                    touched.reads.push(bytes(place, width)?);
                }
                Inst::Store { place, width, .. } if !self.is_protected(place) => touched.writes.push(bytes(place, width)?),
                Inst::Jump { .. } | Inst::Branch { .. } if is_ahead(inst) => {}
                _ => return None,
            }
        }
        Some(touched)
    }
}
