//! Predictive commoning: what the next iteration of a loop loads, where an iteration knows it, as the neighbour that it has loaded or
//! stored itself, is carried on in a register. The next iteration does not wait for memory that was just written.

use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::emission::Emitter;
use super::kernel::{Access, Definition, Effect, Kernel, Level, Node, Slot, SlotKind, StructureCopy};
use crate::passes::Pass;

/// Variables that are handed on so: more would not stay in registers.
const AHEAD_MAX: usize = 4;
/// Bits that are handed on so, where eight iterations are written behind one another: within these they are nothing but values.
const BITS_AHEAD_MAX: usize = 12;
/// Variables of an iteration that are looked at.
const KNOWN_MAX: usize = 64;

/// What is known of a variable at a computed address.
#[derive(Clone)]
struct CarriedLoad {
    at: Access,
    value: Node,
    /// The condition under which it holds that, and whether that has to hold.
    only: Option<(Node, bool)>,
}

impl Kernel {
    /// The same loop with as much handed on to the next iteration as that would read, apart from bits.
    pub(super) fn with_ahead(self) -> Self {
        self.with_more_ahead(|width| width != Width::Bit, AHEAD_MAX)
    }

    /// The same loop with the bits handed on to the next iteration that it would read.
    pub(super) fn with_bits_ahead(self) -> Self {
        self.with_more_ahead(|width| width == Width::Bit, BITS_AHEAD_MAX)
    }

    fn with_more_ahead(mut self, is_one: impl Fn(Width) -> bool, most: usize) -> Self {
        if !self.passes.has(Pass::PredictiveCommoning) {
            return self;
        }
        // What is looked at before the loop is read there as each iteration would read it.
        if !self.inspected.is_empty() {
            return self;
        }
        let most = self.ahead.len() + most;
        let (known, read_first) = self.known_at_end(is_one);
        for number in read_first {
            let access = self.accesses[number].clone();
            let Some(step) = self.line(access.pointer, Level::Outer).filter(|line| line.bits == 32 && !line.is_same()) else { continue };
            let next = Access { offset: access.offset.wrapping_add(step.step) & 0x00FF_FFFF, ..access.clone() };
            let Some(known) = known.iter().find(|known| known.at.is_same(&next) && known.only.is_none()) else { continue };
            let (Ok(slot), Ok(at)) = (u16::try_from(self.slots.len()), u16::try_from(self.ahead.len())) else { break };
            let slot = Slot::numbered(slot);
            self.slots.push(SlotKind::Ahead { number: at, width: access.width });
            self.nodes[self.reads[number].number() as usize] = Definition::Start(Level::Outer, slot);
            self.outer.ends.insert(slot, known.value);
            self.outer.steps.retain(|&step| step != Effect::Access(number));
            self.ahead.push(access);
            if self.ahead.len() == most {
                break;
            }
        }
        self.lines.borrow_mut().clear();
        self.shapes.borrow_mut().clear();
        self
    }

    /// What is known of variables at the end of an iteration, and the reads before which nothing may have written what they read.
    fn known_at_end(&mut self, is_one: impl Fn(Width) -> bool) -> (Vec<CarriedLoad>, Vec<usize>) {
        let mut known: Vec<CarriedLoad> = Vec::new();
        let mut read_first = Vec::new();
        for at in 0..self.outer.steps.len() {
            match self.outer.steps[at] {
                Effect::Access(number) => {
                    let access = self.accesses[number].clone();
                    let value = match access.value {
                        Some(value) => {
                            known.retain(|known| !known.at.may_meet(&access));
                            value
                        }
                        None => {
                            if is_one(access.width) && self.is_untouched(&access, &self.outer.steps[..at]) {
                                read_first.push(number);
                            }
                            self.reads[number]
                        }
                    };
                    if is_one(access.width) && !known.iter().any(|known| known.at.is_same(&access)) && known.len() < KNOWN_MAX {
                        known.push(CarriedLoad { at: access, value, only: None });
                    }
                }
                Effect::Copy(number) => {
                    let copied = self.copies[number].clone();
                    let there = self.known_behind(&known, &copied);
                    known.retain(|known| !known.at.may_meet_copied(&copied.to, copied.bytes));
                    known.extend(there);
                }
                Effect::Inner => return (Vec::new(), Vec::new()),
            }
        }
        (known, read_first)
    }

    /// What is known of variables where a copy writes.
    fn known_behind(&mut self, known: &[CarriedLoad], copied: &StructureCopy) -> Vec<CarriedLoad> {
        let mut there = Vec::new();
        for one in known.iter().filter(|one| one.only.is_none() || one.only == copied.reached) {
            // Positions have 24 bits.
            let behind = one.at.offset.wrapping_sub(copied.from.offset) & 0x00FF_FFFF;
            let is_part = (one.at.area, one.at.pointer) == (copied.from.area, copied.from.pointer)
                && behind + 8 * one.at.width.bytes() <= 8 * copied.bytes;
            if !is_part {
                continue;
            }
            let offset = copied.to.offset.wrapping_add(behind) & 0x00FF_FFFF;
            let at = Access { offset, width: one.at.width, ..copied.to.clone() };
            let before = known.iter().find(|known| known.at.is_same(&at) && known.only.is_none());
            there.push(match (copied.reached, before) {
                (None, _) => CarriedLoad { at, value: one.value, only: None },
                (only, None) => CarriedLoad { at, value: one.value, only },
                (Some((condition, holds)), Some(before)) => {
                    let (a, b) = if holds { (one.value, before.value) } else { (before.value, one.value) };
                    let value = self.add(Definition::Compute(Op::Select, [condition, a, b, condition]));
                    CarriedLoad { at, value, only: None }
                }
            });
        }
        there
    }

    /// Whether none of these steps may write what an access reads.
    fn is_untouched(&self, access: &Access, steps: &[Effect]) -> bool {
        steps.iter().all(|step| match *step {
            Effect::Access(number) => self.accesses[number].value.is_none() || !access.may_meet(&self.accesses[number]),
            Effect::Copy(number) => !access.may_meet_copied(&self.copies[number].to, self.copies[number].bytes),
            Effect::Inner => false,
        })
    }
}

impl Emitter<'_, '_, '_> {
    /// Reads what the first iteration would read itself.
    pub(super) fn read_ahead(&mut self) {
        for (number, &kept) in self.kernel.slots.iter().enumerate() {
            let SlotKind::Ahead { number: at, width } = kept else { continue };
            let access = &self.kernel.ahead[usize::from(at)];
            let pointer = self.value_before(access.pointer);
            let address = self.address_at(access, pointer);
            let value = self.t.read(address, width);
            self.before.insert(Slot::numbered(number as u16), value);
        }
    }
}
