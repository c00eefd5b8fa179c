//! The cross reference: what every statement refers to, and how.

use std::collections::BTreeMap;

use sieben_lang::Compiled;
pub use sieben_lang::references::{Reference, Usage};
use sieben_model::address::Area;

use crate::target::{Memory, Target};

/// All references of a program, by target, then by block and statement.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CrossReference {
    /// The references.
    pub references: Vec<Reference>,
}

impl CrossReference {
    /// Collects the references of all code blocks.
    pub fn new(compiled: &Compiled) -> Self {
        // What a block of the library does inside is no more a matter of the program than the inside of a system function.
        let blocks = compiled.bodies.keys().filter(|&&id| !compiled.is_of_library(id));
        let mut references: Vec<Reference> = blocks.flat_map(|&id| compiled.references(id)).collect();
        references.sort_by(|a, b| (&a.target, a.block, a.statement, a.span).cmp(&(&b.target, b.block, b.statement, b.span)));
        Self { references }
    }

    /// The references of each target.
    pub fn entries(&self) -> impl Iterator<Item = (&Target, &[Reference])> {
        self.references.chunk_by(|a, b| a.target == b.target).map(|references| (&references[0].target, references))
    }

    /// The targets that have bits in common with each target and are not the same, in order.
    pub fn overlaps(&self) -> Overlaps {
        let mut overlaps = Overlaps::default();
        for (target, _) in self.entries() {
            if let Target::Memory(memory) = target {
                overlaps.insert(*memory);
            }
        }
        overlaps
    }
}

/// The addresses of a program, by area and data block.
#[derive(Clone, Debug, Default)]
pub struct Overlaps {
    areas: BTreeMap<(Area, Option<u16>), InArea>,
}

/// Addresses in the order of their first bits, apart by size: one long range must not make every search as long as itself.
/// The key is the binary logarithm of the number of bits.
type InArea = BTreeMap<u32, Vec<Memory>>;

impl Overlaps {
    /// Takes in an address; they come in their order.
    fn insert(&mut self, memory: Memory) {
        let area = self.areas.entry((memory.area, memory.db)).or_default();
        area.entry(memory.bits().ilog2()).or_default().push(memory);
    }

    /// The other addresses of the program that share a bit with this one.
    pub fn of(&self, memory: &Memory) -> Vec<Memory> {
        let Some(area) = self.areas.get(&(memory.area, memory.db)) else { return Vec::new() };
        let mut found = Vec::new();
        for (size, addresses) in area {
            let bits_max = u32::MAX >> (31 - size);
            let first = addresses.partition_point(|other| other.position.saturating_add(bits_max) <= memory.position);
            let behind = addresses[first..].iter().take_while(|other| other.position < memory.end());
            found.extend(behind.filter(|other| *other != memory && other.overlaps(memory)));
        }
        found.sort_unstable();
        found
    }
}
