//! The assignment list: which inputs, outputs, bit memory, timers and counters a program uses.

use std::collections::{BTreeMap, BTreeSet};

use sieben_model::address::{Area, Width};

use crate::cross_reference::{CrossReference, Reference};
use crate::target::{Extent, Indirect, Memory, Reach, Target};

/// The areas of the list, in its order.
pub const AREAS: [Area; 5] = [Area::Input, Area::Output, Area::BitMemory, Area::PeripheralInput, Area::PeripheralOutput];

/// Longest range that is written into the list byte by byte: more than any area has.
const RANGE_BITS_MAX: u32 = 65_536 * 8;

/// How a bit is used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum BitUse {
    /// Not at all.
    #[default]
    None,
    /// A pointer or a range names it.
    Pointer,
    /// As part of a byte, word or double word.
    Wider,
    /// As a bit.
    Direct,
}

/// How a byte takes part in an access of a width.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum PartOf {
    /// It does not.
    #[default]
    None,
    /// It is a later byte of one.
    Inside,
    /// It is the first byte of one.
    First,
}

/// A byte of an area.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ByteUse {
    /// Its bits, bit 0 first.
    pub bits: [BitUse; 8],
    /// Accesses to bytes.
    pub byte: PartOf,
    /// Accesses to words.
    pub word: PartOf,
    /// Accesses to double words.
    pub double_word: PartOf,
    /// A pointer or a range names it.
    pub pointer: bool,
}

/// What is used of an area.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AreaUse {
    /// The bytes that are used, by number.
    pub bytes: BTreeMap<u32, ByteUse>,
    /// Accesses whose address is computed at run time, any of which may reach bytes that are not marked.
    pub indirect: Vec<Reference>,
}

/// What a program uses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AssignmentList {
    /// Each area of [`AREAS`] with its use.
    pub areas: Vec<(Area, AreaUse)>,
    /// Timers.
    pub timers: BTreeSet<u16>,
    /// Counters.
    pub counters: BTreeSet<u16>,
    /// Timers whose number is computed at run time.
    pub timers_indirect: Vec<Reference>,
    /// Counters whose number is computed at run time.
    pub counters_indirect: Vec<Reference>,
    /// Accesses whose area is in the pointer too: they may reach any area.
    pub crossing: Vec<Reference>,
}

impl AssignmentList {
    /// The list of a program.
    pub fn new(references: &CrossReference) -> Self {
        let mut list = Self { areas: AREAS.map(|area| (area, AreaUse::default())).to_vec(), ..Self::default() };
        for (target, uses) in references.entries() {
            match target {
                Target::Memory(memory) => {
                    if let Some((_, area)) = list.areas.iter_mut().find(|(area, _)| *area == memory.area) {
                        area.mark(memory);
                    }
                }
                Target::Timer(number) => {
                    list.timers.insert(*number);
                }
                Target::Counter(number) => {
                    list.counters.insert(*number);
                }
                Target::Indirect(Indirect { reach, .. }) => {
                    let place = match reach {
                        Reach::Memory(None, _) => Some(&mut list.crossing),
                        Reach::Memory(Some(wanted), _) => {
                            list.areas.iter_mut().find(|(area, _)| area == wanted).map(|(_, area)| &mut area.indirect)
                        }
                        Reach::Timer => Some(&mut list.timers_indirect),
                        Reach::Counter => Some(&mut list.counters_indirect),
                        Reach::Block(_) | Reach::InstanceBlock => None,
                    };
                    if let Some(place) = place {
                        place.extend_from_slice(uses);
                    }
                }
                Target::Block(_) | Target::Local { .. } => {}
            }
        }
        list
    }
}

impl AreaUse {
    fn mark(&mut self, memory: &Memory) {
        let first = memory.position / 8;
        match memory.extent {
            Extent::Width(Width::Bit) => {
                let bit = &mut self.bytes.entry(first).or_default().bits[(memory.position % 8) as usize];
                *bit = BitUse::Direct;
            }
            Extent::Width(width) => {
                for index in 0..width.bytes() {
                    let byte = self.bytes.entry(first.saturating_add(index)).or_default();
                    let column = match width {
                        Width::Bit | Width::Byte => &mut byte.byte,
                        Width::Word => &mut byte.word,
                        Width::DoubleWord | Width::QuadWord => &mut byte.double_word,
                    };
                    *column = (*column).max(if index == 0 { PartOf::First } else { PartOf::Inside });
                    for bit in &mut byte.bits {
                        *bit = (*bit).max(BitUse::Wider);
                    }
                }
            }
            Extent::Bits(_) | Extent::Unknown => {
                let end = memory.position.saturating_add(memory.bits().min(RANGE_BITS_MAX));
                for position in memory.position..end {
                    let byte = self.bytes.entry(position / 8).or_default();
                    byte.pointer = true;
                    let bit = &mut byte.bits[(position % 8) as usize];
                    *bit = (*bit).max(BitUse::Pointer);
                }
            }
        }
    }
}
