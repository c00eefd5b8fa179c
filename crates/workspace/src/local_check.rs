//! Watches a run for local data that are read before anything was written to them.

use std::collections::BTreeMap;

use sieben_engine::{FaultPlace, LocalAccess, Machine, StatementEvent, Tracer};
use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Section;
use sieben_model::problems::Problem;

use crate::project::Build;

/// What is known of the local data while a program runs.
#[derive(Debug, Default)]
pub struct LocalCheck {
    /// The bits of each byte that have a value.
    known: Vec<u8>,
    /// The first read of each place: what was read there, and how often.
    reads: BTreeMap<(BlockId, u32), Read>,
}

/// Local data that were read without having a value.
#[derive(Clone, Copy, Debug)]
struct Read {
    /// The block whose local data they are.
    owner: BlockId,
    /// The byte in its local data.
    byte: u32,
    /// How often.
    times: u64,
}

impl LocalCheck {
    fn byte(&mut self, at: u32) -> &mut u8 {
        let at = at as usize;
        if at >= self.known.len() {
            self.known.resize(at + 1, 0);
        }
        &mut self.known[at]
    }

    /// One warning for each statement that has read what nothing had written.
    pub fn findings(&self, build: &Build) -> Vec<Diagnostic> {
        let mut out = Vec::new();
        for (&(block, statement), read) in &self.reads {
            let code = build.compiled.program.code.get(&block);
            let Some(&span) = code.and_then(|code| code.spans.get(statement as usize)) else { continue };
            let times = if read.times == 1 { "once".to_owned() } else { format!("{} times", read.times) };
            let message = format!("{} was read {times} before it was written", name(build, read));
            out.push(Diagnostic::new(Problem::P4024, span, message));
        }
        out
    }
}

/// The variable that lies at a byte of the local data of a block.
fn name(build: &Build, read: &Read) -> String {
    let Some(code) = build.compiled.program.code.get(&read.owner) else { return format!("byte {} of the local data", read.byte) };
    let temporaries = code.interface.variables.iter().filter(|variable| variable.section == Section::Temp);
    let found = temporaries.rev().find(|variable| {
        let first = variable.offset / 8;
        let bytes = u32::try_from(variable.data_type.bits().div_ceil(8)).unwrap_or(u32::MAX);
        first <= read.byte && read.byte - first < bytes
    });
    match found {
        Some(variable) => format!("`#{}` of `{}`", variable.name, read.owner),
        None if read.byte >= code.interface.local_size => format!("a parameter of a block that `{}` has called", read.owner),
        None => format!("byte {} of the local data of `{}`", read.byte, read.owner),
    }
}

impl Tracer for LocalCheck {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {}

    fn local_data(&mut self, machine: &Machine, place: FaultPlace, access: LocalAccess) {
        match access {
            LocalAccess::Entered { first, bytes, known } => {
                for at in 0..bytes {
                    *self.byte(first + at) = if at < known { 0xFF } else { 0 };
                }
            }
            LocalAccess::Written { first, bytes, mask } => (first..first.saturating_add(bytes)).for_each(|at| *self.byte(at) |= mask),
            LocalAccess::Read { first, bytes, mask } => {
                let unknown = (first..first.saturating_add(bytes)).find(|&at| *self.byte(at) & mask != mask);
                let Some(at) = unknown else { return };
                let owner = machine.frames.iter().rev().find(|frame| frame.local_base <= at && at - frame.local_base < frame.local_size);
                let (owner, byte) = owner.map_or((place.block, at), |frame| (frame.block, at - frame.local_base));
                self.reads.entry((place.block, place.statement)).or_insert(Read { owner, byte, times: 0 }).times += 1;
            }
        }
    }
}
