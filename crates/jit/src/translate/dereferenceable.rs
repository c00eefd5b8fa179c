//! Dereferenceable bytes: how many bytes of its instance a block reaches, with all that it calls. A specialization of it may assume that so
//! many are there.

use sieben_engine::ir::{Callee, Inst, Place, TextRoom};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::Find;
use super::mod_ref::IndexValues;
use super::pointer_propagation::InstancePointer;
use crate::jit::Native;

/// The bytes that all blocks reach from where AR2 points when they are called, as far as the code tells: what it does not tell is looked at
/// when it runs.
pub(super) fn find(blocks: &[Native], pointers: &[InstancePointer], find: Find<'_>) -> Vec<u32> {
    let mut search = Search { blocks, pointers, find, looked: vec![false; blocks.len()], found: vec![0; blocks.len()] };
    (0..blocks.len()).for_each(|index| search.of_block(index));
    search.found.into_iter().map(|bits| u32::try_from((bits + 7) / 8).unwrap_or(u32::MAX)).collect()
}

struct Search<'a> {
    blocks: &'a [Native],
    pointers: &'a [InstancePointer],
    find: Find<'a>,
    looked: Vec<bool>,
    /// In bits.
    found: Vec<i64>,
}

impl Search<'_> {
    /// A block that calls itself reaches no more by that.
    fn of_block(&mut self, index: usize) {
        if std::mem::replace(&mut self.looked[index], true) {
            return;
        }
        let (code, pointers) = (&self.blocks[index].code, &self.pointers[index]);
        let mut reached = 0;
        for statement in 0..code.statement_count() {
            let mut instance = pointers.at(statement as u32);
            let mut numbers = IndexValues::default();
            for (at, inst) in (code.statements[statement]..).zip(code.statement(statement)) {
                let mut touches = |place: Place, bits: u32| {
                    let Place::Indirect { area: Area::InstanceData, pointer, offset } = place else { return };
                    let behind = match pointer.register() {
                        Some(Register::Ar2) => numbers.moved_by(instance).map(|(_, most)| most + i64::from(offset)),
                        _ => numbers.instance_range(pointer, offset, Width::Bit).map(|range| range.end - 1),
                    };
                    reached = behind.map_or(reached, |behind| reached.max(behind + i64::from(bits)));
                };
                let of_text = |room: TextRoom| 8 * if room.is_unknown() { room.head() } else { room.bytes() };
                match *inst {
                    Inst::Load { place, width, .. } | Inst::Store { place, width, .. } => touches(place, width.bits()),
                    Inst::Move { from, to, bytes } => {
                        touches(from, 8 * bytes);
                        touches(to, 8 * bytes);
                    }
                    Inst::Text { from, from_room, to, to_room, .. } => {
                        touches(from, of_text(from_room));
                        touches(to, of_text(to_room));
                    }
                    Inst::Call { callee: Callee::Block(id), .. } => {
                        if let (Some(callee), Some((_, most))) = ((self.find)(id), numbers.moved_by(instance)) {
                            self.of_block(callee as usize);
                            reached = reached.max(most + self.found[callee as usize]);
                        }
                        numbers = IndexValues::default();
                        if !(self.find)(id).is_some_and(|callee| self.pointers[callee as usize].kept) {
                            instance = None;
                        }
                    }
                    _ => {}
                }
                if let Some(dst) = sieben_engine::ir::verify::writes(inst) {
                    numbers.follow_write((at, inst, dst), &mut instance, pointers);
                }
            }
        }
        self.found[index] = reached;
    }
}
