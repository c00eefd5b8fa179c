//! Constant propagation for address register 2: where it holds its value at the entry of the block plus a constant.
//!
//! It points to the instance of a function block. A call of another function block saves it in the local data, moves it, and restores it,
//! so the saved value is followed through memory and through the called block.

use std::collections::BTreeMap;

use sieben_engine::ir::{Callee, Inst, Op, Place, Var};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::{Find, natural_loops};
use crate::jit::{Native, end};

/// Rounds over a program or a block after which nothing counts as known.
const ROUNDS_MAX: usize = 24;
/// Saved values that are followed at the same time, the newest ones.
const SAVED_MAX: usize = 8;

/// What is known of AR2 in a block. A number is what was added to its value at the beginning of the block, modulo 2^32.
#[derive(Debug, Default)]
pub(super) struct InstancePointer {
    /// Nothing in the block changes it.
    untouched: bool,
    /// At the beginning of each statement.
    at: Vec<Option<u32>>,
    /// Behind an instruction that writes it.
    after: BTreeMap<u32, u32>,
    /// A load that takes back what was saved of it.
    loaded: BTreeMap<u32, u32>,
    /// Whether it is the same behind a call of this block as before it.
    pub(super) kept: bool,
    /// Whether the block, or one that it calls, may write to local data of those that called it.
    pub(super) writes_outwards: bool,
}

impl InstancePointer {
    /// What was added at the beginning of a statement.
    pub(super) fn at(&self, statement: u32) -> Option<u32> {
        if self.untouched { Some(0) } else { self.at.get(statement as usize).copied().flatten() }
    }

    /// What was added to the saved value that an instruction loads.
    pub(super) fn loaded(&self, inst: u32) -> Option<u32> {
        self.loaded.get(&inst).copied()
    }

    /// What was added behind an instruction that writes it.
    pub(super) fn after(&self, inst: u32) -> Option<u32> {
        if self.untouched { Some(0) } else { self.after.get(&inst).copied() }
    }
}

/// Follows AR2 through all blocks.
pub(super) fn follow(blocks: &[Native], find: Find<'_>) -> Vec<InstancePointer> {
    let mut all: Vec<InstancePointer> =
        blocks.iter().map(|_| InstancePointer { untouched: true, kept: true, ..InstancePointer::default() }).collect();
    let callees: Vec<Vec<Option<usize>>> = blocks.iter().map(|block| callees(block, find)).collect();
    let mut settled = false;
    for _ in 0..ROUNDS_MAX {
        settled = true;
        for (index, block) in blocks.iter().enumerate().rev() {
            let outwards =
                writes_outwards(block) || callees[index].iter().any(|callee| callee.is_none_or(|code| all[code].writes_outwards));
            settled &= std::mem::replace(&mut all[index].writes_outwards, outwards) == outwards;
        }
        if settled {
            break;
        }
    }
    if !settled {
        all.iter_mut().for_each(|it| it.writes_outwards = true);
    }
    // That every block keeps it is taken for granted until one is found that does not: a block that calls itself keeps it if its own
    // code does.
    settled = false;
    for _ in 0..ROUNDS_MAX {
        settled = true;
        for (index, block) in blocks.iter().enumerate().rev() {
            if !all[index].kept && !all[index].untouched {
                continue;
            }
            let touched = block.code.insts.iter().any(|inst| sieben_engine::ir::verify::writes(inst) == Some(Register::Ar2.into()))
                || callees[index].iter().any(|callee| callee.is_none_or(|code| !all[code].kept));
            if touched {
                let before = all[index].kept;
                let found = Walk::new(block, &all, find).run();
                let found = InstancePointer { writes_outwards: all[index].writes_outwards, ..found };
                settled &= before == found.kept;
                all[index] = found;
            }
        }
        if settled {
            break;
        }
    }
    if !settled {
        all.iter_mut().for_each(|it| *it = InstancePointer { writes_outwards: true, ..InstancePointer::default() });
        return all;
    }
    // Blocks that were walked before another one turned out not to keep it are walked again.
    for (index, block) in blocks.iter().enumerate() {
        if !all[index].untouched {
            let found = Walk::new(block, &all, find).run();
            all[index] = InstancePointer { writes_outwards: all[index].writes_outwards, ..found };
        }
    }
    all
}

/// The blocks that a block calls; `None` = one that is not loaded, or not known beforehand.
fn callees(block: &Native, find: Find<'_>) -> Vec<Option<usize>> {
    let called = |inst: &Inst| match inst {
        Inst::Call { callee, .. } => Some(loaded(callee, find)),
        _ => None,
    };
    block.code.insts.iter().filter_map(called).collect()
}

fn loaded(callee: &Callee, find: Find<'_>) -> Option<usize> {
    match callee {
        Callee::Block(id) => find(*id).map(|code| code as usize),
        Callee::Number(..) => None,
    }
}

/// Whether a block writes through pointers that may point to the local data of a caller.
fn writes_outwards(block: &Native) -> bool {
    block.code.insts.iter().any(|inst| {
        matches!(
            inst,
            Inst::Store { place: Place::Crossing { .. }, .. }
                | Inst::Move { to: Place::Crossing { .. }, .. }
                | Inst::Text { to: Place::Crossing { .. }, .. }
        )
    })
}

/// What a variable holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum TempValue {
    Constant(u32),
    /// AR2 at the beginning of the block, and so much more.
    Entry(u32),
}

/// What is known at one place.
#[derive(Clone, Debug, PartialEq, Eq)]
struct State {
    ar2: Option<u32>,
    /// Double words in the local data that hold it: bit position, and what was added.
    saved: Vec<(u32, u32)>,
}

impl State {
    /// What is known on two ways.
    fn meet(mut self, other: &Self) -> Self {
        if self.ar2 != other.ar2 {
            self.ar2 = None;
        }
        self.saved.retain(|saved| other.saved.contains(saved));
        self
    }

    fn forget(&mut self, position: u32, bits: u32) {
        self.saved.retain(|&(at, _)| at + 32 <= position || position.saturating_add(bits) <= at);
    }
}

/// One block on the way to what is known in it.
struct Walk<'a> {
    block: &'a Native,
    all: &'a [InstancePointer],
    find: Find<'a>,
    arrivals: BTreeMap<u32, State>,
    changed: bool,
    held: BTreeMap<u8, TempValue>,
    found: InstancePointer,
}

impl<'a> Walk<'a> {
    fn new(block: &'a Native, all: &'a [InstancePointer], find: Find<'a>) -> Self {
        let found = InstancePointer::default();
        Self { block, all, find, arrivals: BTreeMap::new(), changed: false, held: BTreeMap::new(), found }
    }

    fn run(mut self) -> InstancePointer {
        for _ in 0..ROUNDS_MAX {
            self.changed = false;
            self.found = InstancePointer { kept: true, ..InstancePointer::default() };
            self.round();
            if !self.changed {
                return self.found;
            }
        }
        InstancePointer::default()
    }

    /// All statements once.
    fn round(&mut self) {
        let code = &self.block.code;
        let mut state = Some(State { ar2: Some(0), saved: Vec::new() });
        for statement in 0..code.statement_count() {
            if let Some(arrived) = self.arrivals.get(&(statement as u32)) {
                state = Some(match state {
                    Some(state) => state.meet(arrived),
                    None => arrived.clone(),
                });
            }
            self.found.at.push(state.as_ref().and_then(|state| state.ar2));
            self.held.clear();
            let mut failed: Option<State> = None;
            for (index, inst) in (code.statements[statement]..).zip(code.statement(statement)) {
                let Some(now) = &mut state else { break };
                if self.may_fail(inst) {
                    failed = Some(failed.map_or_else(|| now.clone(), |failed| failed.meet(now)));
                }
                for to in natural_loops::targets(code, inst) {
                    let arriving = now.clone();
                    self.arrive(to, arriving);
                }
                match inst {
                    Inst::Jump { .. } | Inst::JumpTable { .. } => state = None,
                    Inst::Return => {
                        self.found.kept &= now.ar2 == Some(0);
                        if let Some(end) = end(code).filter(|&end| end as usize != statement) {
                            let arriving = now.clone();
                            self.arrive(end, arriving);
                        }
                        state = None;
                    }
                    _ => self.inst(index, inst, now),
                }
            }
            state = match (state, failed) {
                (Some(state), Some(failed)) => Some(state.meet(&failed)),
                (state, failed) => state.or(failed),
            };
        }
    }

    fn arrive(&mut self, statement: u32, state: State) {
        let known = match self.arrivals.get(&statement) {
            Some(before) => state.meet(before),
            None => state,
        };
        if self.arrivals.get(&statement) != Some(&known) {
            self.arrivals.insert(statement, known);
            self.changed = true;
        }
    }

    /// What an instruction does that goes on behind itself.
    fn inst(&mut self, index: u32, inst: &Inst, state: &mut State) {
        let ar2 = Var::from(Register::Ar2);
        let held = |this: &Self, state: &State, var: Var| match var {
            var if var == ar2 => state.ar2.map(TempValue::Entry),
            var => this.held.get(&var.0).copied(),
        };
        let result = match *inst {
            Inst::Constant { value, .. } => u32::try_from(value).ok().map(TempValue::Constant),
            Inst::Compute { op: Op::Copy, args, .. } => held(self, state, args[0]),
            Inst::Compute { op: Op::AddU32, args, .. } => match (held(self, state, args[0]), held(self, state, args[1])) {
                (Some(TempValue::Entry(a)), Some(TempValue::Constant(b))) | (Some(TempValue::Constant(b)), Some(TempValue::Entry(a))) => {
                    Some(TempValue::Entry(a.wrapping_add(b)))
                }
                _ => None,
            },
            Inst::Load { place: Place::Fixed { area: Area::Local, position }, width: Width::DoubleWord, .. } => {
                let added = state.saved.iter().find(|&&(at, _)| at == position).map(|&(_, added)| added);
                if let Some(added) = added {
                    self.found.loaded.insert(index, added);
                }
                added.map(TempValue::Entry)
            }
            Inst::Store { place, width, src } => {
                let value = held(self, state, src);
                self.store(place, width, value, state);
                return;
            }
            Inst::Move { .. } | Inst::Text { .. } => {
                self.forget_seen(state);
                None
            }
            Inst::Call { ref callee, .. } => {
                let callee = loaded(callee, self.find).map(|code| &self.all[code]);
                if callee.is_none_or(|callee| callee.writes_outwards) {
                    self.forget_seen(state);
                }
                if callee.is_none_or(|callee| !callee.kept) {
                    state.ar2 = None;
                }
                self.held.clear();
                return;
            }
            _ => None,
        };
        let Some(dst) = sieben_engine::ir::verify::writes(inst) else { return };
        if dst == ar2 {
            state.ar2 = match result {
                Some(TempValue::Entry(added)) => Some(added),
                _ => None,
            };
            if let Some(added) = state.ar2 {
                self.found.after.insert(index, added);
            }
            return;
        }
        match result {
            Some(result) => self.held.insert(dst.0, result),
            None => self.held.remove(&dst.0),
        };
    }

    fn store(&mut self, place: Place, width: Width, value: Option<TempValue>, state: &mut State) {
        match place {
            Place::Fixed { area: Area::Local, position } => {
                state.forget(position, width.bits());
                let inside = u64::from(position / 8) + u64::from(width.bytes()) <= u64::from(self.block.local_size);
                if let (Some(TempValue::Entry(added)), Width::DoubleWord, 0, true) = (value, width, position % 8, inside) {
                    if state.saved.len() == SAVED_MAX {
                        state.saved.remove(0);
                    }
                    state.saved.push((position, added));
                }
            }
            Place::Indirect { area: Area::Local, .. } | Place::Crossing { .. } => self.forget_seen(state),
            _ => {}
        }
    }

    /// Forgets what somebody else may have changed.
    fn forget_seen(&self, state: &mut State) {
        state.saved.retain(|&(at, _)| self.block.private.binary_search(&(at, Width::DoubleWord)).is_ok());
    }
}

impl Walk<'_> {
    /// Whether the statement may end with an instruction and count as NOP.
    fn may_fail(&self, inst: &Inst) -> bool {
        let inside = |place: &Place, width: Width| match *place {
            Place::Fixed { area: Area::Local, position } => {
                let whole = width == Width::Bit || position % 8 == 0;
                whole && u64::from(position / 8) + u64::from(width.bytes()) <= u64::from(self.block.local_size)
            }
            _ => false,
        };
        match inst {
            Inst::Load { place, width, .. } | Inst::Store { place, width, .. } => !inside(place, *width),
            // One that finds no room ends the run.
            Inst::Call { callee, .. } => loaded(callee, self.find).is_none(),
            Inst::Move { .. }
            | Inst::Text { .. }
            | Inst::Intrinsic { .. }
            | Inst::Require { .. }
            | Inst::RequireStack { .. }
            | Inst::Open { .. } => true,
            _ => false,
        }
    }
}
