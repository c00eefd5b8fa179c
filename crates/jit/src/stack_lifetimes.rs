//! Lifetimes of stack slots: bytes of the local data, outgoing argument slots mostly, that nothing reads after the statement that wrote
//! them.

use std::collections::{BTreeMap, BTreeSet};
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
                Inst::Constant { value, .. } => pointed_position(value).and_then(piece_at),
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

/// Where a constant leads in local data, if it may be a pointer there.
fn pointed_position(value: u64) -> Option<u32> {
    let pointer = u32::try_from(value).ok()?;
    let codes = [Area::Local, Area::CallerLocal].map(|area| u32::from(area.pointer_code()));
    codes.contains(&(pointer >> 24)).then_some(pointer & 0x00FF_FFFF)
}

/// Whether a place is at a computed position in local data.
fn is_anywhere(place: Place) -> bool {
    matches!(place, Place::Indirect { area: Area::Local, .. })
}

/// Bits of the local data that nobody else reaches, or that are handed out alone, and beside which nobody needs anything in their byte; the
/// pieces that are handed out are given in bytes.
pub(crate) fn single_bits(block: &CodeBlock, pieces: &[Range<u32>]) -> Vec<u32> {
    let mut bits: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    let mut others: BTreeSet<u32> = BTreeSet::new();
    for inst in &block.code.insts {
        match *inst {
            Inst::Load { place, width, .. } | Inst::Store { place, width, .. } => match (place, width) {
                (Place::Fixed { area: Area::Local, position }, Width::Bit) => _ = bits.entry(position / 8).or_default().insert(position),
                (Place::Fixed { area: Area::Local, position }, _) => others.extend(position / 8..position / 8 + width.bytes()),
                _ if is_anywhere(place) => return Vec::new(),
                _ => {}
            },
            Inst::Constant { value, .. } => {
                if let Some(position) = pointed_position(value) {
                    bits.entry(position / 8).or_default().insert(position);
                }
            }
            Inst::Move { from, to, .. } | Inst::Text { from, to, .. }
                if [from, to].into_iter().any(|place| is_anywhere(place) || matches!(place, Place::Fixed { area: Area::Local, .. })) =>
            {
                return Vec::new();
            }
            _ => {}
        }
    }
    let is_own = |position: u32| {
        let is_handed = || pieces.iter().any(|piece| piece.len() == 2 && piece.start * 8 == position);
        block.private.contains(&(position, Width::Bit)) || is_handed()
    };
    let single = |(byte, bits): (u32, BTreeSet<u32>)| {
        let (first, is_one) = (bits.first().copied()?, bits.len() == 1);
        (is_one && !others.contains(&byte) && is_own(first)).then_some(first)
    };
    bits.into_iter().filter_map(single).collect()
}

#[cfg(test)]
mod tests {
    use std::ops::Range;

    use sieben_engine::CodeBlock;
    use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place};
    use sieben_model::address::{Area, Width};

    use super::single_bits;

    /// The first bit of the third byte of local data, which is looked at.
    const BIT: u32 = 16;

    fn local(position: u32) -> Place {
        Place::Fixed { area: Area::Local, position }
    }

    /// What is found in a block that looks at the bit and does something else.
    fn found(private: &[(u32, Width)], handed: Option<Range<u32>>, other: &dyn Fn(&mut Builder)) -> Vec<u32> {
        let mut b = Builder::default();
        b.begin_statement();
        let bit = b.load(local(BIT), Width::Bit, OnFault::SkipStatement);
        let bit = b.compute(Op::Not, &[bit]);
        b.store(local(BIT), Width::Bit, bit);
        other(&mut b);
        b.begin_statement();
        b.push(Inst::Return);
        let block = CodeBlock { code: b.finish(), private: private.to_vec(), ..CodeBlock::default() };
        single_bits(&block, handed.as_slice())
    }

    fn found_beside(other: &dyn Fn(&mut Builder)) -> Vec<u32> {
        let private = [(BIT, Width::Bit), (BIT + 1, Width::Bit), (BIT + 8, Width::Byte)];
        found(&private, None, other)
    }

    #[test]
    fn a_bit_stands_alone_if_the_block_looks_at_nothing_else_in_its_byte() {
        assert_eq!(found_beside(&|_| {}), [BIT]);
        let store = |position, width| {
            move |b: &mut Builder| {
                let value = b.constant(1);
                b.store(local(position), width, value);
            }
        };
        assert_eq!(found_beside(&store(BIT + 1, Width::Bit)), [0; 0]);
        assert_eq!(found_beside(&store(BIT + 8, Width::Byte)), [BIT]);
        assert_eq!(found_beside(&store(BIT, Width::Byte)), [0; 0]);
        assert_eq!(found_beside(&store(BIT - 16, Width::DoubleWord)), [0; 0]);
        assert_eq!(found_beside(&store(BIT - 8, Width::Byte)), [BIT]);
        let pointer = |area: Area, position: u32| {
            move |b: &mut Builder| {
                let pointer = b.constant(u64::from(area.pointer_code()) << 24 | u64::from(position));
                b.push(Inst::PassParameter { src: pointer });
            }
        };
        for area in [Area::Local, Area::CallerLocal] {
            assert_eq!(found_beside(&pointer(area, BIT)), [BIT], "{area:?}");
            assert_eq!(found_beside(&pointer(area, BIT + 3)), [0; 0], "{area:?}");
        }
        assert_eq!(found_beside(&pointer(Area::BitMemory, BIT + 3)), [BIT]);
    }

    #[test]
    fn nothing_stands_alone_where_local_data_are_reached_otherwise() {
        let indirect = |b: &mut Builder| {
            let (pointer, value) = (b.constant(0), b.constant(1));
            b.store(Place::Indirect { area: Area::Local, pointer, offset: 0 }, Width::Bit, value);
        };
        assert_eq!(found_beside(&indirect), [0; 0]);
        let moved = |b: &mut Builder| b.push(Inst::Move { from: local(0), to: local(64), bytes: 4 });
        assert_eq!(found_beside(&moved), [0; 0]);
    }

    #[test]
    fn a_bit_is_of_the_block_alone_or_handed_out_alone() {
        assert_eq!(found(&[], None, &|_| {}), [0; 0]);
        assert_eq!(found(&[(BIT, Width::Byte)], None, &|_| {}), [0; 0]);
        assert_eq!(found(&[], Some(2..4), &|_| {}), [BIT]);
        assert_eq!(found(&[], Some(2..6), &|_| {}), [0; 0], "there may be more in it");
        assert_eq!(found(&[], Some(0..2), &|_| {}), [0; 0]);
    }
}
