//! Scalar replacement of copied structures in an iteration: each number of 32 bits of one is loaded and stored like a variable.

use sieben_engine::ir::Place;
use sieben_model::address::Width;

use super::kernel::{Effect, Node};
use super::ssa_construction::{Reached, SsaBuilder};
use crate::passes::Pass;

/// Longer copies are left to loops that are not done at once.
const BYTES_MAX: u32 = 128;

impl SsaBuilder<'_, '_> {
    /// Reads a copy of bytes, which may overlap: all of them are read before one is written.
    pub(super) fn copy(&mut self, index: u32, (from, to, bytes): (Place, Place, u32), steps: &mut Vec<Effect>) -> Option<()> {
        if !self.kernel.passes.has(Pass::StructCopies) {
            return None;
        }
        if bytes > BYTES_MAX {
            return None;
        }
        let mut pieces = Vec::new();
        let mut first = 0;
        while first < bytes {
            let left = bytes - first;
            let width = [Width::DoubleWord, Width::Word].into_iter().find(|width| width.bytes() <= left).unwrap_or(Width::Byte);
            pieces.push((first, width));
            first += width.bytes();
        }
        let inside = self.moved(index);
        let part = |write: bool, first: u32, width: Width| {
            let (base, range) = inside.as_ref()?[usize::from(write)].clone();
            let behind = i64::from(bytes - first - width.bytes());
            Some((base, range.start + i64::from(first)..range.end - behind))
        };
        let mut values: Vec<Node> = Vec::new();
        for &(first, width) in &pieces {
            let known = part(false, first, width);
            values.push(match self.reach((behind(from, first), width), known, false)? {
                Reached::Slot(slot) => self.read_here(slot)?,
                Reached::Access(access) => self.read_at(access, steps),
            });
        }
        for (&(first, width), value) in pieces.iter().zip(values) {
            let known = part(true, first, width);
            match self.reach((behind(to, first), width), known, true)? {
                Reached::Slot(slot) => self.write_here(slot, value)?,
                Reached::Access(access) => self.write_at(access, value, steps),
            }
        }
        Some(())
    }
}

/// A place so many bytes behind another one.
fn behind(place: Place, bytes: u32) -> Place {
    let moved = |offset: u32| offset.wrapping_add(8 * bytes);
    match place {
        Place::Fixed { area, position } => Place::Fixed { area, position: moved(position) },
        Place::Indirect { area, pointer, offset } => Place::Indirect { area, pointer, offset: moved(offset) },
        Place::Crossing { pointer, offset } => Place::Crossing { pointer, offset: moved(offset) },
    }
}
