//! Numbers in the local data of a block that becomes part of another one, if that block branches: each is a value as long as the block runs,
//! and memory has it only where somebody may look. Without branches it waits for its store until the block has ended, and is dropped then.

use std::collections::BTreeSet;

use sieben_engine::ir::{Callee, Inst, Place};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockKind;

use super::Translator;
use super::inlining::Outer;
use super::promote::{Base, CALLS_MAX};
use crate::jit::loop_heads;

/// Numbers of one block; more would be kept on the stack, which is memory too.
const WORDS_MAX: usize = 12;

impl Translator<'_> {
    /// Keeps the numbers in the local data of the block that begins now, if no other block sees them.
    pub(super) fn keep_own_words(&mut self) {
        if !self.options.optimize || !self.options.forgets_locals || self.options.exact {
            return;
        }
        let native = self.native();
        let branches = native.code.insts.iter().any(|inst| matches!(inst, Inst::Branch { .. } | Inst::JumpTable { .. }));
        if !branches || !loop_heads(&native.code).is_empty() || !self.is_known_code(&native.code.insts, CALLS_MAX) {
            return;
        }
        let used = |position: u32| {
            native.code.insts.iter().any(|inst| match *inst {
                Inst::Load { place, .. } | Inst::Store { place, .. } => place == Place::Fixed { area: Area::Local, position },
                _ => false,
            })
        };
        let numbers = native.private.iter().filter(|&&(position, width)| width != Width::Bit && used(position));
        let numbers: Vec<(u32, Width)> = numbers.copied().collect();
        if numbers.len() > WORDS_MAX {
            return;
        }
        for (position, width) in numbers {
            self.keep_own(Base::Local, self.local_offset + (position / 8) as i32, width);
        }
    }

    /// Whether instructions call nothing but functions that become part of the block, and those neither; and whether all addresses to which
    /// they go are known where they are written, or lead to other memory than local data.
    fn is_known_code(&self, insts: &[Inst], depth: u32) -> bool {
        let (mut given, mut constants) = (BTreeSet::new(), BTreeSet::new());
        insts.iter().all(|inst| match *inst {
            Inst::Parameter { dst, .. } => {
                given.insert(dst.0);
                true
            }
            Inst::Constant { dst, .. } => {
                constants.insert(dst.0);
                true
            }
            Inst::PassParameter { src } => constants.contains(&src.0),
            Inst::Load { place, .. } | Inst::Store { place, .. } => match place {
                Place::Fixed { .. } => true,
                Place::Indirect { area, .. } => area != Area::Local,
                Place::Crossing { pointer, .. } => given.contains(&pointer.0),
            },
            Inst::Call { callee: Callee::Block(id), .. } if id.kind == BlockKind::Function => (self.find)(id).is_some_and(|called| {
                depth > 0 && self.inlines(called as usize) && self.is_known_code(&self.blocks[called as usize].code.insts, depth - 1)
            }),
            Inst::Move { .. } | Inst::Text { .. } | Inst::Call { .. } => false,
            _ => true,
        })
    }

    /// Drops what the caller has handed to the running block through its local data and waits for its store there, if the rest of the block
    /// does not read it, nor does the rest of the caller's statement.
    pub(super) fn drop_what_was_taken(&mut self) {
        if !self.words_wait() || !self.options.forgets_locals || self.options.exact {
            return;
        }
        let Some((caller, statement, call, first)) = self.outer.last().map(Outer::call) else { return };
        let (caller, own) = (&self.blocks[caller], &self.native().code);
        // Nothing waits any more where a loop begins that reads it.
        let left = &own.insts[own.statements[self.statement as usize] as usize..];
        let takes_more = |inst: &Inst| match inst {
            Inst::Load { place, .. } => !matches!(place, Place::Fixed { .. } | Place::Indirect { .. }),
            Inst::Move { .. } | Inst::Text { .. } | Inst::Call { .. } | Inst::PassParameter { .. } => true,
            _ => false,
        };
        if caller.handed.is_empty() || left.iter().any(takes_more) {
            return;
        }
        let end = caller.code.statements[statement as usize + 1] as usize;
        let behind = &caller.code.insts[call as usize + 1..end];
        let is_needed = |at: u32| {
            let Some(piece) = caller.handed.iter().find(|piece| piece.contains(&at)) else { return true };
            let bits = piece.start * 8..piece.end * 8;
            behind.iter().any(|inst| match *inst {
                Inst::Load { place: Place::Fixed { area: Area::Local, position }, .. } => bits.contains(&position),
                Inst::Load { place: Place::Fixed { .. }, .. } => false,
                Inst::Load { place: Place::Indirect { area, .. }, .. } => area == Area::Local,
                Inst::Constant { value, .. } => bits.contains(&(value as u32 & 0x00FF_FFFF)),
                Inst::Load { .. } | Inst::Move { .. } | Inst::Text { .. } | Inst::Call { .. } => true,
                _ => false,
            })
        };
        self.drop_words(|at| u32::try_from(at - first).is_ok_and(|at| !is_needed(at)));
    }
}
