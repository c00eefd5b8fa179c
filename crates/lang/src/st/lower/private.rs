//! Which values in the local data nobody sees but the instructions that name them.

use std::collections::BTreeSet;
use std::ops::Range;

use sieben_engine::ir::{Inst, Place};
use sieben_model::address::{Area, Width};

/// What the code of a block does with its local data. Positions are in bits.
#[derive(Debug, Default)]
pub(super) struct Seen {
    scalars: BTreeSet<(u32, Width)>,
    /// What a pointer or an index may reach.
    shown: Vec<Range<u32>>,
    everything: bool,
}

impl Seen {
    /// Notes what an instruction reads and writes at constant addresses.
    pub(super) fn note(&mut self, inst: &Inst) {
        let mut bytes_at = |place: &Place, bytes: u32| match *place {
            Place::Fixed { area: Area::Local, position } => self.show(position..position.saturating_add(bytes.saturating_mul(8))),
            Place::Indirect { area: Area::Local, .. } => self.show_all(),
            _ => {}
        };
        match inst {
            Inst::Load { place: Place::Fixed { area: Area::Local, position }, width, .. }
            | Inst::Store { place: Place::Fixed { area: Area::Local, position }, width, .. } => {
                self.scalars.insert((*position, *width));
            }
            Inst::Move { from, to, bytes } => {
                bytes_at(from, *bytes);
                bytes_at(to, *bytes);
            }
            Inst::Text { from, from_room, to, to_room, .. } => {
                bytes_at(from, from_room.bytes());
                bytes_at(to, to_room.bytes());
            }
            _ => {}
        }
    }

    /// A pointer or an index may reach these bits.
    pub(super) fn show(&mut self, bits: Range<u32>) {
        self.shown.push(bits);
    }

    /// A pointer may reach everything.
    pub(super) fn show_all(&mut self) {
        self.everything = true;
    }

    /// The values that only their constant address reaches, always in one width.
    pub(super) fn private(&self) -> Vec<(u32, Width)> {
        if self.everything {
            return Vec::new();
        }
        let bits = |&(position, width): &(u32, Width)| position..position.saturating_add(width.bits());
        let mut shown = self.shown.clone();
        shown.sort_by_key(|range| range.start);
        let mut reach = 0;
        let mut joined: Vec<Range<u32>> = Vec::new();
        for range in shown {
            match joined.last_mut() {
                Some(last) if range.start <= reach => last.end = last.end.max(range.end),
                _ => joined.push(range.clone()),
            }
            reach = joined.last().map_or(0, |last| last.end);
        }
        let apart = |range: &Range<u32>| {
            let index = joined.partition_point(|shown| shown.end <= range.start);
            joined.get(index).is_none_or(|shown| shown.start >= range.end)
        };
        let scalars: Vec<_> = self.scalars.iter().collect();
        let mut private = Vec::new();
        let mut end = 0;
        for (index, &scalar) in scalars.iter().enumerate() {
            let range = bits(scalar);
            let alone = range.start >= end && scalars.get(index + 1).is_none_or(|next| next.0 >= range.end);
            end = end.max(range.end);
            if alone && apart(&range) {
                private.push(*scalar);
            }
        }
        private
    }
}
