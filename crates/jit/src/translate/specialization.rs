//! Specialization: a block is compiled for the instance and the data block with which it is called, wherever these are constants, so that
//! its variables are at constant addresses. Where the data block is known and the instance may be one of several, a version knows that the
//! instance is inside the data block.
//!
//! What a version assumes is proven by the calls that enter it; nothing is checked when it runs. A caller that knows less calls the general
//! version, which is compiled only if there is such a caller.

use std::collections::VecDeque;

use cranelift_jit::JITModule;
use cranelift_module::{FuncId, Linkage, Module, ModuleError};
use rustc_hash::FxHashMap;
use sieben_engine::ir::{Callee, Inst, Place};
use sieben_engine::machine::Register;
use sieben_model::address::Area;
use sieben_model::block::{BlockId, BlockKind};

use super::{Find, OPEN_BLOCKS, Translator, bit_of, block_signature};
use crate::jit::Native;
use crate::passes::Pass;

/// Registers whose value a version may know.
const KNOWABLE: [Register; 7] =
    [OPEN_BLOCKS[0], OPEN_BLOCKS[1], OPEN_BLOCKS[2], OPEN_BLOCKS[3], OPEN_BLOCKS[4], OPEN_BLOCKS[5], Register::Ar2];

/// The place of AR2 among them.
const AR2: usize = 6;

/// Versions of one block, beside the general one. A block with more calls has none: most of them would find no version.
const VERSIONS_MAX: usize = 4;
/// IR instructions that all versions together may have, for each of the program.
const GROWTH: usize = 2;
/// IR instructions that all versions together may have in any program, besides those.
const GROWTH_MIN: usize = 4_000;
/// Rounds over a program after which every block counts as reading everything.
const ROUNDS_MAX: usize = 24;

/// What a version knows of [`KNOWABLE`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Assumed {
    values: [Option<u64>; KNOWABLE.len()],
    /// Whether AR2 leads to a byte of the instance data block, and all bytes from there on that the block reaches are there.
    pub(super) inside: bool,
}

impl Assumed {
    /// Registers and their values.
    pub(super) fn iter(self) -> impl Iterator<Item = (Register, u64)> {
        KNOWABLE.into_iter().zip(self.values).filter_map(|(register, value)| Some((register, value?)))
    }

    /// The registers.
    pub(super) fn registers(self) -> u32 {
        self.iter().fold(0, |all, (register, _)| all | bit_of(register))
    }
}

/// The functions of all blocks that are compiled, in the order in which somebody needed them first.
pub(super) struct Specializations {
    /// What each block and those that it calls read of [`KNOWABLE`].
    reads: Vec<u32>,
    functions: FxHashMap<(usize, Assumed), FuncId>,
    /// For each block, how many versions it has.
    counts: Vec<usize>,
    /// For each block, how many calls name it.
    calls: Vec<usize>,
    /// For each block, how many bytes of its instance it reaches.
    needs: Vec<u32>,
    /// Versions of one block.
    most: usize,
    /// IR instructions that versions may still have.
    room: usize,
    waiting: VecDeque<(usize, Assumed, FuncId)>,
}

impl Specializations {
    /// Begins with the blocks that are entered by others than calls.
    pub(super) fn new(
        module: &mut JITModule,
        blocks: &[Native],
        find: Find<'_>,
        needs: Vec<u32>,
        optimize: bool,
    ) -> Result<Self, Box<ModuleError>> {
        let mut calls = vec![0; blocks.len()];
        callees(blocks, find).into_iter().flatten().for_each(|callee| calls[callee] += 1);
        let instructions: usize = blocks.iter().map(|block| block.code.insts.len()).sum();
        let mut versions = Self {
            reads: reads(blocks, find, &calls),
            functions: FxHashMap::default(),
            counts: vec![0; blocks.len()],
            calls,
            needs,
            // Code that has to be there at once is compiled once.
            most: if optimize { VERSIONS_MAX } else { 1 },
            room: instructions.saturating_mul(GROWTH).saturating_add(GROWTH_MIN),
            waiting: VecDeque::new(),
        };
        let computed: Vec<BlockKind> = blocks
            .iter()
            .flat_map(|block| &block.code.insts)
            .filter_map(|inst| match inst {
                Inst::Call { callee: Callee::Number(kind, _), .. } => Some(*kind),
                _ => None,
            })
            .collect();
        for (index, block) in blocks.iter().enumerate() {
            let BlockId { kind, .. } = block.id;
            if kind == BlockKind::OrganizationBlock || computed.contains(&kind) {
                versions.function(module, index, Assumed::default())?;
            }
        }
        Ok(versions)
    }

    /// The next function to write.
    pub(super) fn next(&mut self) -> Option<(usize, Assumed, FuncId)> {
        self.waiting.pop_front()
    }

    /// The general version of a block, if somebody needed it.
    pub(super) fn general(&self, index: usize) -> Option<FuncId> {
        self.functions.get(&(index, Assumed::default())).copied()
    }

    /// The function of a version.
    fn function(&mut self, module: &mut JITModule, index: usize, known: Assumed) -> Result<FuncId, Box<ModuleError>> {
        if let Some(&function) = self.functions.get(&(index, known)) {
            return Ok(function);
        }
        let signature = block_signature(module);
        let name = format!("block_{index}_{}", self.counts[index]);
        let function = module.declare_function(&name, Linkage::Local, &signature)?;
        self.counts[index] += 1;
        self.functions.insert((index, known), function);
        self.waiting.push_back((index, known, function));
        Ok(function)
    }

    /// What a call that knows so much makes use of: all of it, that its instance is `inside`, or nothing if there are versions enough.
    fn settle(&mut self, known: Assumed, inside: bool, index: usize, block: &Native) -> Assumed {
        let size = block.code.insts.len();
        let mut anywhere = Assumed { inside, ..known };
        anywhere.values[AR2] = None;
        let own = (known.values[AR2].is_some() || !inside).then_some(known);
        for known in own.into_iter().chain(inside.then_some(anywhere)) {
            if known == Assumed::default() || self.functions.contains_key(&(index, known)) {
                return known;
            }
            // Many calls would find no version of their own, but one for all of them.
            if (self.calls[index] <= self.most || known.inside) && self.counts[index] < self.most && size <= self.room {
                self.room -= size;
                return known;
            }
        }
        Assumed::default()
    }

    /// How many bytes of its instance a block reaches.
    pub(super) fn needs(&self, index: usize) -> u32 {
        self.needs[index]
    }
}

impl Translator<'_> {
    /// The function that a call enters now, and what it knows.
    pub(super) fn version(&mut self, at: u32, index: usize) -> (FuncId, Assumed) {
        let mut known = Assumed::default();
        let reads = if self.options.passes.has(Pass::Specialization) { self.versions.reads[index] } else { 0 };
        for (register, known) in KNOWABLE.into_iter().zip(&mut known.values) {
            if reads & bit_of(register) != 0 {
                *known = self.current[register as usize].and_then(super::Val::constant);
            }
        }
        // Number, base and length of a data block belong together.
        for block in known.values[..6].chunks_mut(3) {
            if block.iter().any(Option::is_none) {
                block.fill(None);
            }
        }
        let has_instance = reads & bit_of(Register::Ar2) != 0 && known.values[AR2 - 1].is_some();
        let inside = has_instance && self.options.optimize && self.has_instance_inside(at, self.versions.needs(index));
        let known = self.versions.settle(known, inside, index, &self.blocks[index]);
        let function = self.versions.function(self.module, index, known);
        (function.expect("every function has a name of its own and the same signature"), known)
    }
}

/// What each block that is called, and those that it calls, read of [`KNOWABLE`].
fn reads(blocks: &[Native], find: Find<'_>, calls: &[usize]) -> Vec<u32> {
    let own = |block: &Native| block.code.insts.iter().fold(0, |all, inst| all | reads_of(inst));
    let mut all: Vec<u32> = blocks.iter().zip(calls).map(|(block, &calls)| if calls == 0 { 0 } else { own(block) }).collect();
    let callees = callees(blocks, find);
    for _ in 0..ROUNDS_MAX {
        let mut changed = false;
        for index in (0..blocks.len()).rev() {
            let together = callees[index].iter().fold(all[index], |together, &callee| together | all[callee]);
            changed |= std::mem::replace(&mut all[index], together) != together;
        }
        if !changed {
            return all;
        }
    }
    vec![u32::MAX; blocks.len()]
}

/// The blocks that each block calls, once for each call.
pub(super) fn callees(blocks: &[Native], find: Find<'_>) -> Vec<Vec<usize>> {
    let called = |inst: &Inst| match inst {
        Inst::Call { callee: Callee::Block(id), .. } => find(*id).map(|code| code as usize),
        _ => None,
    };
    blocks.iter().map(|block| block.code.insts.iter().filter_map(called).collect()).collect()
}

/// What an instruction reads. A pointer that may go anywhere mostly goes elsewhere.
fn reads_of(inst: &Inst) -> u32 {
    let place = |place: Place| match place {
        Place::Fixed { area, .. } | Place::Indirect { area, .. } => match area {
            Area::SharedData => OPEN_BLOCKS[..3].iter().fold(0, |all, &register| all | bit_of(register)),
            Area::InstanceData => OPEN_BLOCKS[3..].iter().fold(0, |all, &register| all | bit_of(register)),
            _ => 0,
        },
        Place::Crossing { .. } => 0,
    };
    let places = match *inst {
        Inst::Load { place: from, .. } => place(from),
        Inst::Store { place: to, .. } => place(to),
        Inst::Move { from, to, .. } | Inst::Text { from, to, .. } => place(from) | place(to),
        _ => 0,
    };
    places | super::status_liveness::effect(inst).reads
}
