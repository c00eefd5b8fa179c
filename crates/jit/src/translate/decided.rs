//! Conditions of which a part decides: `a[i].key < key OR a[i].key = key AND a[i].number <= number` jumps as soon as its first comparison says
//! where to, and reads no more. What is left out can neither fail nor change anything.

use sieben_engine::ir::{Inst, Op, Place, Target, Var};
use sieben_model::address::Width;

use super::value::Val;
use super::{Translator, compares};

/// Parts of a condition behind which it may be decided.
const PARTS_MAX: usize = 3;

/// What a statement does that ends with a branch, and is decided earlier.
#[derive(Debug, Default)]
pub(super) struct Decided {
    jumps: Vec<Jump>,
    /// Instructions that read what an instruction in front has read.
    same: Vec<(u32, u32)>,
    /// What was read, by the instruction.
    read: Vec<(u32, Val)>,
}

/// A jump behind a part of a condition.
#[derive(Clone, Copy, Debug)]
struct Jump {
    /// The instruction that computes the part.
    behind: u32,
    part: Var,
    /// What the part is where it decides.
    holds: bool,
    to: Target,
}

/// What a temporary is made of: numbers that are the same are made of the same.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Made {
    Constant(u64),
    Register(Var),
    Computed(Op, [Option<usize>; 4]),
    /// Read in a place, behind what leads there.
    Read(Place, Option<usize>, Width),
    /// Anything else.
    Other(u32),
}

/// Temporaries that are constants.
type Known = Vec<(Var, u64)>;

/// Whether an operation says whether something holds.
fn is_part(op: Op) -> bool {
    compares(op) || matches!(op, Op::Equal | Op::Below | Op::And | Op::AndNot | Op::Or | Op::Xor | Op::Not)
}

/// Notes what an instruction makes of what is known.
fn step(known: &mut Known, inst: &Inst) {
    let Some(dst) = sieben_engine::ir::verify::writes(inst) else { return };
    let value_of = |var: Var| known.iter().find(|(other, _)| *other == var).map(|&(_, value)| value);
    let result = match *inst {
        Inst::Constant { value, .. } => Some(value),
        Inst::Compute { op, args, .. } => {
            let values = args.map(value_of);
            match (op, values) {
                (Op::And | Op::AndNot, [Some(0), ..]) | (Op::And, [_, Some(0), ..]) | (Op::AndNot, [_, Some(1), ..]) => Some(0),
                (Op::Or, [Some(1), ..] | [_, Some(1), ..]) => Some(1),
                _ if values[..op.arity()].iter().all(Option::is_some) => Some(op.eval(values.map(Option::unwrap_or_default))),
                _ => None,
            }
        }
        _ => None,
    };
    known.retain(|(var, _)| *var != dst);
    known.extend(result.map(|result| (dst, result)));
}

impl Translator<'_> {
    /// Where the running statement, which ends with a branch in a loop, is decided by a part of its condition.
    pub(super) fn decided_by_parts(&self) -> Decided {
        let code = &self.native().code;
        let statement = code.statement(self.statement as usize);
        let first = code.statements[self.statement as usize];
        let next = self.statement + 1;
        let (before, condition, [taken, not_taken]) = match *statement {
            [ref before @ .., Inst::Branch { condition, to }] => (before, condition, [to, Target(next)]),
            [ref before @ .., Inst::Branch { condition, to }, Inst::Jump { to: otherwise }] => (before, condition, [to, otherwise]),
            _ => return Decided::default(),
        };
        let in_loop = self.loops.iter().any(|it| it.contains(self.statement));
        if !self.options.optimize || !in_loop || self.is_choice(first + before.len() as u32, taken.0) {
            return Decided::default();
        }
        // Behind the last instruction that does more than to compute.
        let does_more = |at: &usize| !self.computes_only(first + *at as u32, &before[*at]);
        let begin = (0..before.len()).rev().find(does_more).map_or(0, |at| at + 1);
        let mut known = Known::new();
        let mut jumps = Vec::new();
        for (at, inst) in before.iter().enumerate() {
            step(&mut known, inst);
            let Inst::Compute { op, dst: part, .. } = *inst else { continue };
            let rest = &before[at + 1..];
            let is_known = known.iter().any(|(var, _)| *var == part);
            if at + 1 < begin || jumps.len() == PARTS_MAX || is_known || !is_part(op) || part.register().is_some() {
                continue;
            }
            if !(first + at as u32 + 1..).zip(rest).any(|(index, inst)| self.reads_element(index, inst)) {
                break;
            }
            let ends_with = |holds: bool| {
                let mut known = known.clone();
                known.push((part, u64::from(holds)));
                rest.iter().for_each(|inst| step(&mut known, inst));
                known.iter().find(|(var, _)| *var == condition).map(|&(_, value)| if value & 1 != 0 { taken } else { not_taken })
            };
            let Some((holds, to)) = [false, true].into_iter().find_map(|holds| Some((holds, ends_with(holds)?))) else { continue };
            if to.0 > self.statement {
                jumps.push(Jump { behind: first + at as u32, part, holds, to });
                known.push((part, u64::from(!holds)));
            }
        }
        let same = if jumps.is_empty() { Vec::new() } else { self.same_elements(first + begin as u32, &before[begin..]) };
        Decided { jumps, same, read: Vec::new() }
    }

    /// Which instructions read an element that another one in front of them has read.
    fn same_elements(&self, first: u32, insts: &[Inst]) -> Vec<(u32, u32)> {
        let mut made: Vec<(Made, u32)> = Vec::new();
        let mut held: Vec<(Var, usize)> = Vec::new();
        let mut same = Vec::new();
        for (index, inst) in (first..).zip(insts) {
            // Nothing writes a register here.
            for register in sieben_engine::ir::verify::reads(inst).filter(|var| var.register().is_some()) {
                if !held.iter().any(|(var, _)| *var == register) {
                    held.push((register, made.len()));
                    made.push((Made::Register(register), index));
                }
            }
            let of = |var: Var| held.iter().find(|(other, _)| *other == var).map(|&(_, number)| number);
            let now = match *inst {
                Inst::Constant { value, .. } => Made::Constant(value),
                Inst::Compute { op: Op::Copy, args, .. } if let Some(number) = of(args[0]) => made[number].0,
                Inst::Compute { op, args, .. } if args[..op.arity()].iter().all(|&arg| of(arg).is_some()) => {
                    let mut parts = args.map(of);
                    parts[op.arity()..].fill(None);
                    Made::Computed(op, parts)
                }
                Inst::Load { place, width, .. } => match place {
                    Place::Fixed { .. } => Made::Read(place, None, width),
                    Place::Indirect { area, pointer, offset } if let Some(number) = of(pointer) => {
                        Made::Read(Place::Indirect { area, pointer: Var::default(), offset }, Some(number), width)
                    }
                    _ => Made::Other(index),
                },
                _ => Made::Other(index),
            };
            let Some(dst) = sieben_engine::ir::verify::writes(inst) else { continue };
            let number = made.iter().position(|(other, _)| *other == now).unwrap_or(made.len());
            match made.get(number) {
                Some(&(_, earlier)) if self.reads_element(index, inst) => same.push((index, earlier)),
                Some(_) => {}
                None => made.push((now, index)),
            }
            held.retain(|(var, _)| *var != dst);
            held.push((dst, number));
        }
        same
    }

    /// Delivers what an instruction reads, if it was read before; whether it was.
    pub(super) fn is_read_again(&mut self, index: u32, inst: &Inst, decided: &Decided) -> bool {
        let Inst::Load { dst, .. } = *inst else { return false };
        let earlier = decided.same.iter().find(|(index_of, _)| *index_of == index).map(|&(_, earlier)| earlier);
        let Some(&(_, value)) = decided.read.iter().find(|(index, _)| Some(*index) == earlier) else { return false };
        self.set(dst, value);
        true
    }

    /// Notes what an instruction has read that is read again.
    pub(super) fn note_read(&mut self, index: u32, inst: &Inst, decided: &mut Decided) {
        if let Inst::Load { dst, .. } = *inst
            && decided.same.iter().any(|&(_, earlier)| earlier == index)
            && !self.is_needless(index, dst)
        {
            let value = self.get(dst);
            decided.read.push((index, value));
        }
    }

    /// Jumps behind an instruction that computes a part of the condition, if the part decides.
    pub(super) fn jump_if_decided(&mut self, index: u32, decided: &mut Decided) {
        let Some(&Jump { part, holds, to, .. }) = decided.jumps.iter().find(|it| it.behind == index) else { return };
        let condition = self.get(part);
        let condition = self.force(condition);
        match condition.constant() {
            // The parts behind it decide as if this one did not.
            Some(value) if value & 1 != u64::from(holds) => {}
            None if self.meeting.is_none() && self.series.is_none() => {
                let condition = if holds { condition } else { self.not(condition) };
                self.branch(condition, to);
                self.set(part, Val::Const(u64::from(!holds)));
            }
            _ => decided.jumps.clear(),
        }
    }

    /// Whether an instruction can neither fail nor change anything but temporaries, and nobody is asked.
    fn computes_only(&self, index: u32, inst: &Inst) -> bool {
        let is_own = |dst: Var| dst.register().is_none();
        match *inst {
            Inst::Constant { dst, .. } | Inst::Compute { dst, .. } => is_own(dst),
            Inst::Load { dst, place, width, .. } => is_own(dst) && self.is_there(index, place, width),
            Inst::Require { .. } => self.ranges.is_met(index),
            _ => false,
        }
    }

    /// Whether an instruction reads at an address that is computed.
    fn reads_element(&self, index: u32, inst: &Inst) -> bool {
        match *inst {
            Inst::Load { place, width, .. } => self.constant_address(place, width).is_none() && self.ranges.inside(index).is_some(),
            _ => false,
        }
    }
}
