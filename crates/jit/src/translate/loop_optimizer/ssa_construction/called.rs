//! SSA construction of a block that an iteration calls, with what is known at the call, and of the loop in it, if there is one.

use sieben_engine::ir::{Inst, Op, Var};
use sieben_engine::machine::Register;
use sieben_model::address::Width;

use super::super::super::inlining::RESTORED;
use super::super::super::natural_loops::NaturalLoop;
use super::super::super::range_analysis::{self, Fact};
use super::super::super::scalar_promotion::Base;
use super::super::super::status_liveness::open_blocks;
use super::super::super::value::Val;
use super::super::super::{AFTER_CALL, AT_CALL, OPEN_BLOCKS, bit_of};
use super::super::kernel::{Access, Effect, Level, Node, Slot, SlotKind};
use super::{DEPTH_MAX, Frame, Region, SsaBuilder, facts};

/// Variables whose ranges are known where a block is called.
const FACTS_MAX: usize = 64;

impl SsaBuilder<'_, '_> {
    /// Whether a jump from a statement that each iteration reaches leads over the inner loop: as one before `FOR k := 1 TO n` does if
    /// that has no iterations. It is taken to be the same in all iterations of the outer loop.
    pub(super) fn jumps_over_inner(&self, statement: u32, to: u32) -> bool {
        let leads_over = |inside: &NaturalLoop| statement < inside.first && inside.last < to;
        self.level == Level::Outer && self.ways.is_always() && self.inside.as_ref().is_some_and(leads_over)
    }

    /// Notes what a block that is entered, or an inner loop that begins again, takes from the budget.
    pub(super) fn take(&mut self, weight: u32) -> Option<()> {
        self.blocks_most += weight;
        if self.ways.is_always() {
            self.blocks += weight;
            Some(())
        } else {
            self.take_sometimes(weight)
        }
    }

    /// Notes what some iterations take from the budget.
    fn take_sometimes(&mut self, weight: u32) -> Option<()> {
        if self.level == Level::Inner {
            return None;
        }
        let slot = self.slot(SlotKind::Budget);
        let before = self.read_slot(slot);
        let [no, yes, weight] = [0, 1, weight].map(|number| self.constant(u64::from(number)));
        let reached = self.chosen(yes, no);
        let taken = self.compute(Op::Gate, [weight, reached, weight, weight]);
        let after = self.compute(Op::AddU32, [before, taken, before, before]);
        self.now.insert(slot, after);
        Some(())
    }

    /// Reads a block that becomes part of the loop.
    pub(super) fn call(&mut self, code: usize, parameters: usize, steps: &mut Vec<Effect>) -> Option<()> {
        let t = &mut *self.translator;
        let block = &t.blocks[code].code;
        let others = bit_of(Register::Ma) | bit_of(Register::Nesting);
        let touches = |inst: &Inst| {
            let register = |var: Var| var.register().map_or(0, bit_of);
            let read = sieben_engine::ir::verify::reads(inst).map(register).fold(0, |all, bit| all | bit);
            let written = sieben_engine::ir::verify::writes(inst).map_or(0, register);
            read & others != 0 || written & (others | open_blocks()) != 0
        };
        // What a call restores stays as it is.
        if t.ranges.is_relative() || !t.inlines(code) || block.insts.iter().any(touches) {
            return None;
        }
        let given = self.passed.split_off(self.passed.len().checked_sub(parameters)?);
        let behind = i32::try_from(t.local_behind()).ok()?;
        let weight = u32::from(t.blocks[code].weight());
        let last = (block.statement_count() as u32).checked_sub(1)?;
        self.take(weight)?;
        for &(register, value) in AT_CALL.iter().filter(|(register, _)| !RESTORED.contains(register)) {
            let value = self.constant(value);
            self.set(register.into(), value)?;
        }
        let pointer = self.get(Register::Ar2.into())?;
        let known = |this: &Self, node: Node| this.kernel.constant(node).map(Val::Const);
        let unknown = Val::Word(self.translator.arena);
        let instance = known(self, pointer).unwrap_or(unknown);
        let vals = given.iter().map(|&node| known(self, node).unwrap_or(unknown)).collect();
        // The data blocks that are open where the block is called, not those before the loop.
        let mut open = [None; OPEN_BLOCKS.len()];
        for (value, register) in open.iter_mut().zip(OPEN_BLOCKS) {
            let node = self.get(register.into())?;
            *value = known(self, node);
        }
        let t = &mut *self.translator;
        self.frames.push(Frame {
            index: std::mem::replace(&mut t.index, code),
            local_offset: std::mem::replace(&mut t.local_offset, behind),
            ranges: std::mem::take(&mut t.ranges),
            vals: std::mem::replace(&mut t.given, vals),
            instance: std::mem::replace(&mut t.instance, instance),
            pointer: std::mem::replace(&mut t.current[Register::Ar2 as usize], instance.constant().map(Val::Const)),
            given: std::mem::replace(&mut self.given, given),
            passed: std::mem::take(&mut self.passed),
            inside: self.inside.take(),
            facts_inside: std::mem::take(&mut self.facts[1]),
        });
        let known_facts = self.facts_here();
        let callers: Vec<(i32, usize)> = (0..).map_while(|calls| self.caller_local(calls)).collect();
        let t = &mut *self.translator;
        let before = OPEN_BLOCKS.map(|register| t.current[register as usize]);
        OPEN_BLOCKS.iter().zip(open).for_each(|(&register, value)| t.current[register as usize] = value);
        let ranges = t.find_ranges_of_called(known_facts, &callers);
        t.ranges = ranges;
        OPEN_BLOCKS.iter().zip(before).for_each(|(&register, value)| t.current[register as usize] = value);
        let ways = self.ways.clone();
        let open = OPEN_BLOCKS.map(|register| {
            let slot = self.slot(SlotKind::Register(register));
            (slot, self.now.get(&slot).copied())
        });
        self.loop_in_called(code)?;
        self.statements((0, last), Region::Block, steps)?;
        self.forget_locals()?;
        self.leave_frames(self.frames.len() - 1);
        self.ways = ways;
        for (slot, before) in open {
            match before {
                Some(before) => self.now.insert(slot, before),
                None => self.now.remove(&slot),
            };
        }
        self.temporaries.clear();
        for (register, value) in AFTER_CALL {
            let value = self.constant(value);
            self.set(register.into(), value)?;
        }
        Some(())
    }

    /// Forgets the local data of a block that has ended, if nothing reads what it left there; `None` if some of it is read otherwise than
    /// it is written.
    fn forget_locals(&mut self) -> Option<()> {
        let t = &*self.translator;
        if !t.options.forgets_locals {
            return Some(());
        }
        let first = t.local_offset;
        self.forget(|offset, _| offset >= first)?;
        let slots = &self.kernel.slots;
        self.touched.retain(|slot, _| !matches!(slots[slot.number()], SlotKind::Memory { offset, .. } if offset >= first));
        Some(())
    }

    /// Forgets what the block handed to others through its local data, if nobody needs it behind the statement that did so.
    pub(super) fn forget_handed(&mut self) -> Option<()> {
        let t = &*self.translator;
        if !t.options.forgets_locals {
            return Some(());
        }
        let (block, first) = (t.native(), t.local_offset);
        self.forget(|offset, width| block.is_handed(offset - first, width.bytes()))
    }

    /// Forgets what was written to some local data, where no computed address leads: nobody would know then that it is written.
    fn forget(&mut self, is_forgotten: impl Fn(i32, Width) -> bool) -> Option<()> {
        let slots = &self.kernel.slots;
        let is_forgotten = |slot: Slot| match slots[slot.number()] {
            SlotKind::Memory { base: Base::Local, offset, width, .. } => is_forgotten(offset, width),
            _ => false,
        };
        for &slot in self.now.keys().filter(|&&slot| is_forgotten(slot)) {
            let (base, bytes, _) = slots[slot.number()].bytes()?;
            let is_reached = |access: &Access| {
                let (other_base, others) = access.bytes();
                base.may_share(&bytes, other_base, &others)
            };
            if self.kernel.accesses.iter().any(is_reached) {
                return None;
            }
        }
        self.now.retain(|&slot, _| !is_forgotten(slot));
        Some(())
    }

    /// Goes back to a caller, by the number of its own callers.
    pub(super) fn leave_frames(&mut self, depth: usize) {
        while self.frames.len() > depth
            && let Some(frame) = self.frames.pop()
        {
            let t = &mut *self.translator;
            (t.index, t.local_offset, t.ranges, t.given, t.instance) =
                (frame.index, frame.local_offset, frame.ranges, frame.vals, frame.instance);
            t.current[Register::Ar2 as usize] = frame.pointer;
            (self.given, self.passed, self.inside) = (frame.given, frame.passed, frame.inside);
            self.facts[1] = frame.facts_inside;
        }
    }

    /// What is known of variables in memory where a block is called.
    fn facts_here(&self) -> Vec<Fact> {
        let fact = |(&slot, &node): (&Slot, &Node)| {
            let SlotKind::Memory { base, offset, width: width @ (Width::Byte | Width::Word | Width::DoubleWord), .. } =
                self.kernel.kept(slot)
            else {
                return None;
            };
            let range = self.range(node, DEPTH_MAX);
            let range = match width {
                _ if range.bits <= width.bits() || range.exact().is_some() => range,
                Width::Word => range_analysis::result(Op::Low16, [range; 3]),
                _ => range,
            };
            let is_known = range.bits <= width.bits() || range.exact().is_some_and(|value| value >> width.bits() == 0);
            (is_known && range.most - range.least < (1 << width.bits()) - 1).then_some(Fact { variable: (base, offset, width), range })
        };
        let around = self.outer.iter().filter(|&(&slot, _)| !self.now.contains_key(&slot) && !self.is_written_inside(slot));
        self.now.iter().chain(around).filter_map(fact).take(FACTS_MAX).collect()
    }

    /// Notes the loop of a called block: the one inside the loop that is read, if there is one.
    fn loop_in_called(&mut self, code: usize) -> Option<()> {
        if self.unrolled {
            return Some(());
        }
        let mut loops = self.translator.find_loops(code).into_iter();
        let Some(inside) = loops.next() else { return Some(()) };
        if self.level == Level::Inner || loops.next().is_some() || !inside.asks_nothing {
            return None;
        }
        self.facts[1] = facts(self.translator, Some(inside.first));
        self.inside = Some(inside);
        Some(())
    }
}
