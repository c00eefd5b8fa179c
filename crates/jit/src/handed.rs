//! Values that a block hands to others through its local data, or keeps there for itself, and that nobody needs when the statement ends that
//! did so.

use std::collections::BTreeSet;
use std::ops::Range;

use sieben_engine::CodeBlock;
use sieben_engine::ir::{Inst, Place};
use sieben_model::address::{Area, Width};

/// Longer pieces are not written as one value.
const BITS_MAX: u32 = 64;

/// The pieces of local data, in bytes, that each statement which reads them or makes a pointer to them has written before, as a whole.
pub(crate) fn of_one_statement(block: &CodeBlock) -> Vec<Range<u32>> {
    let whole = |&(position, width): &(u32, Width)| (!matches!(width, Width::Bit | Width::Byte)).then(|| position..position + width.bits());
    let mut pieces: Vec<Range<u32>> = block.handed.iter().filter(|piece| piece.len() as u32 <= BITS_MAX).cloned().collect();
    pieces.extend(block.private.iter().filter_map(whole));
    pieces.sort_unstable_by_key(|piece| piece.start);
    pieces.dedup();
    if pieces.windows(2).any(|two| two[0].end > two[1].start) {
        return Vec::new();
    }
    let piece_at = |bit: u32| {
        let index = pieces.partition_point(|piece| piece.end <= bit);
        pieces.get(index).filter(|piece| piece.contains(&bit)).map(|_| index)
    };
    let mut others = BTreeSet::new();
    for statement in 0..block.code.statement_count() {
        let mut written = BTreeSet::new();
        for inst in block.code.statement(statement) {
            let read = match *inst {
                Inst::Store { place: Place::Fixed { area: Area::Local, position }, width, .. } => {
                    if let Some(index) = piece_at(position) {
                        let piece = &pieces[index];
                        // A piece has an even number of bytes.
                        let whole = position == piece.start && width.bytes().next_multiple_of(2) * 8 == piece.len() as u32;
                        if whole {
                            written.insert(index)
                        } else {
                            others.insert(index)
                        };
                    }
                    None
                }
                Inst::Load { place: Place::Fixed { area: Area::Local, position }, .. } => piece_at(position),
                Inst::Constant { value, .. } => {
                    let pointer = u32::try_from(value).unwrap_or(0);
                    let codes = [Area::Local, Area::CallerLocal].map(|area| u32::from(area.pointer_code()));
                    piece_at(pointer & 0x00FF_FFFF).filter(|_| codes.contains(&(pointer >> 24)))
                }
                Inst::Load { place, .. } | Inst::Store { place, .. } => {
                    if is_anywhere(place) {
                        return Vec::new();
                    }
                    None
                }
                Inst::Move { from, to, .. } | Inst::Text { from, to, .. } => {
                    for place in [from, to] {
                        if is_anywhere(place) {
                            return Vec::new();
                        }
                        if let Place::Fixed { area: Area::Local, position } = place {
                            others.extend(piece_at(position));
                        }
                    }
                    None
                }
                _ => None,
            };
            others.extend(read.filter(|index| !written.contains(index)));
        }
    }
    let own = pieces.iter().enumerate().filter(|(index, _)| !others.contains(index));
    own.map(|(_, piece)| piece.start / 8..piece.end / 8).collect()
}

/// Whether a place is at a computed position in local data.
fn is_anywhere(place: Place) -> bool {
    matches!(place, Place::Indirect { area: Area::Local, .. })
}
