//! Whole copies of structures in scalar iterations: after a branch if not each iteration makes them, since a select for each of their
//! numbers would take longer.

use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::Place;
use sieben_model::address::Width;

use super::super::load_elimination::COPIED_BYTES_MAX;
use super::super::memory::{Address, Bit, moved};
use super::super::moves::MOVED_BYTES_MAX;
use super::super::range_analysis::ByteRange;
use super::emission::Emitter;
use super::kernel::{Access, Effect, Kernel, Level, Node, PointedPart, StructureCopy};
use super::ssa_construction::{Goes, SsaBuilder};
use crate::passes::Pass;

impl SsaBuilder<'_, '_> {
    /// Reads a copy of bytes that is made as a whole.
    pub(super) fn copy_whole(&mut self, index: u32, (from, to, bytes): (Place, Place, u32), steps: &mut Vec<Effect>) -> Option<()> {
        if !self.kernel.passes.has(Pass::StructCopies) {
            return None;
        }
        if bytes > MOVED_BYTES_MAX || !self.is_outer() {
            return None;
        }
        let [read, write] = self.moved(index)?;
        let reached = self.reached();
        let from = self.end_of_copy((from, read), bytes, false)?;
        let to = self.end_of_copy((to, write), bytes, true)?;
        self.write_held(steps);
        let copied = StructureCopy { from, to, bytes, reached };
        self.held.forget_copied(&copied);
        steps.push(Effect::Copy(self.kernel.copies.len()));
        self.kernel.copies.push(copied);
        Some(())
    }

    /// The condition under which the running statement is reached, and whether that has to hold; none if it always is.
    fn reached(&mut self) -> Option<(Node, bool)> {
        if self.is_always_reached() {
            return None;
        }
        if let [way] = self.ways.each()
            && let &[(condition, holds)] = way.as_slice()
        {
            return Some((condition, holds));
        }
        let [no, yes] = [0, 1].map(|value| self.constant(value));
        Some((self.chosen(yes, no), true))
    }

    /// One end of a copy, which is known to lie among some bytes.
    fn end_of_copy(&mut self, (place, (base, inside)): (Place, ByteRange), bytes: u32, write: bool) -> Option<Access> {
        let Goes::To { area, pointer, offset } = self.goes_to(place, write)? else { return None };
        let (own, start, length) = area;
        if base != own || inside.start < i64::from(start) || inside.end > i64::from(start) + length as i64 {
            return None;
        }
        let (pointer, offset) = self.without_constants(pointer, offset);
        if let Some(pointer) = self.kernel.constant(pointer) {
            let first = moved(pointer, offset);
            if !first.is_multiple_of(8) || u64::from(first / 8) + u64::from(bytes) > length {
                return None;
            }
        }
        let part = self.part_behind(pointer, offset);
        Some(Access {
            level: Level::Outer,
            area,
            pointer,
            offset,
            width: Width::Byte,
            value: None,
            inside: Some(inside),
            sure: true,
            part,
            around: Vec::new(),
        })
    }
}

impl Kernel {
    /// The values that copies need.
    pub(super) fn of_copies(&self) -> impl Iterator<Item = Node> {
        self.copies.iter().flat_map(|copied| {
            let condition = copied.reached.map(|(condition, _)| condition);
            [Some(copied.from.pointer), Some(copied.to.pointer), condition].into_iter().flatten()
        })
    }

    /// Those that a copy needs in each iteration, without addresses that are counted on.
    pub(super) fn nodes_of_copy(&self, number: usize, level: Level) -> Vec<Node> {
        let StructureCopy { from, to, reached, .. } = &self.copies[number];
        let pointers = [from, to].into_iter().filter(|end| !self.is_counted_end(end, level)).map(|end| end.pointer);
        pointers.chain(reached.map(|(condition, _)| condition)).collect()
    }

    /// Whether the address of an end of a copy is counted on from iteration to iteration.
    pub(super) fn is_counted_end(&self, end: &Access, level: Level) -> bool {
        self.constant(end.pointer).is_none() && self.counted_on(end, level).is_some()
    }
}

impl Emitter<'_, '_, '_> {
    /// Writes copies that follow one another under the same condition.
    pub(super) fn copy_whole(&mut self, numbers: &[usize]) {
        let kernel = self.kernel;
        let ends: Vec<[Address; 2]> = numbers.iter().map(|&number| self.ends_of_copy(&kernel.copies[number])).collect();
        let behind = kernel.copies[numbers[0]].reached.map(|(condition, holds)| {
            let condition = self.first(condition, Level::Outer);
            let condition = self.t.flag(condition);
            let [copying, behind] = [self.t.b.create_block(), self.t.b.create_block()];
            let (yes, no) = if holds { (copying, behind) } else { (behind, copying) };
            self.t.b.ins().brif(condition, yes, &[], no, &[]);
            self.t.b.switch_to_block(copying);
            self.t.b.seal_block(copying);
            behind
        });
        // What was copied to a place that nothing else of them writes need not be read there.
        let mut known: Vec<(&StructureCopy, Vec<Value>)> = Vec::new();
        for (&number, &[from, to]) in numbers.iter().zip(&ends) {
            let copied = &kernel.copies[number];
            let is_it = |(earlier, _): &&(&StructureCopy, Vec<Value>)| {
                (earlier.to.area, earlier.to.pointer, earlier.to.offset, earlier.bytes)
                    == (copied.from.area, copied.from.pointer, copied.from.offset, copied.bytes)
            };
            let pieces = known.iter().find(is_it).map(|(_, pieces)| pieces.clone());
            let pieces = pieces.unwrap_or_else(|| self.t.pieces(from, copied.bytes));
            self.t.write_pieces(to, &pieces);
            known.retain(|(earlier, _)| !copied.to.may_share(&earlier.to));
            if copied.bytes <= COPIED_BYTES_MAX {
                known.push((copied, pieces));
            }
        }
        if let Some(behind) = behind {
            self.t.b.ins().jump(behind, &[]);
            self.t.b.switch_to_block(behind);
            self.t.b.seal_block(behind);
        }
        self.outer.bytes.clear();
    }

    fn ends_of_copy(&mut self, copied: &StructureCopy) -> [Address; 2] {
        [&copied.from, &copied.to].map(|end| {
            let (base, start, length) = end.area;
            if let Some(pointer) = self.kernel.constant(end.pointer) {
                let first = moved(pointer, end.offset) / 8;
                return Address { base: self.base(base), offset: start + first as i32, bit: Bit::Number(0) };
            }
            let part = end.part.unwrap_or(PointedPart { bytes: 0, bit: 0 });
            if let Some(&base) = self.outer.addresses.get(&end.counted()) {
                return Address { base, offset: start + part.bytes, bit: Bit::Number(0) };
            }
            let pointer = self.first(end.pointer, Level::Outer);
            let base = self.base(base);
            self.t.address_inside((base, start, length), pointer, end.offset, (Width::Byte, copied.bytes))
        })
    }
}
