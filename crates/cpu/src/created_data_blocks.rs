//! Data blocks that the program makes: room for them, and how they outlive a power failure.

use std::collections::BTreeSet;

use sieben_engine::Machine;
use sieben_engine::machine::layout::RESERVE;
use sieben_engine::machine::memory::DataBlockEntry;

/// What SFC 22 and 85 answer: there is not as much memory.
const NO_MEMORY: u16 = 0x80B2;
/// The same: there is as much memory, but not in one piece.
const FRAGMENTED: u16 = 0x80B3;

/// What created data blocks take of the reserve, in the order of their places.
pub(crate) fn taken(machine: &Machine) -> Vec<(usize, u16)> {
    if machine.memory.data_blocks.is_as_laid_out() {
        return Vec::new();
    }
    let reserve = machine.memory.reserve();
    let mut taken: Vec<(usize, u16)> = machine
        .memory
        .data_blocks
        .iter()
        .enumerate()
        .filter_map(|(number, entry)| Some((entry.as_ref()?.base as usize, number as u16)))
        .filter(|(base, _)| reserve.contains(base))
        .collect();
    taken.sort_unstable();
    taken
}

/// The bytes from the beginning of a created data block to the next possible one.
pub(crate) fn room(bytes: u32) -> usize {
    (bytes as usize).next_multiple_of(8)
}

/// The first gap that is large enough, or the error code.
pub(crate) fn place(machine: &Machine, bytes: usize) -> Result<usize, u16> {
    let reserve = machine.memory.reserve();
    let mut cursor = reserve.start;
    let mut free = reserve.len();
    let mut found = None;
    for (base, number) in taken(machine) {
        if found.is_none() && base - cursor >= bytes {
            found = Some(cursor);
        }
        let used = machine.memory.data_block(u64::from(number)).map_or(0, |entry| room(entry.length));
        cursor = base + used;
        free = free.saturating_sub(used);
    }
    if found.is_none() && reserve.end.saturating_sub(cursor) >= bytes {
        found = Some(cursor);
    }
    found.ok_or(if free >= bytes { FRAGMENTED } else { NO_MEMORY })
}

/// Makes a data block of zeros at a place that [`place`] found.
pub(crate) fn insert(machine: &mut Machine, number: u16, base: usize, length: u32, read_only: bool) {
    let memory = &mut machine.memory;
    memory.arena[base..base + length as usize].fill(0);
    let index = usize::from(number);
    if memory.data_blocks.len() <= index {
        memory.data_blocks.resize(index + 1, None);
    }
    memory.data_blocks[index] = Some(DataBlockEntry { base: base as u32, length, read_only });
}

/// What SFC 85 says about a data block beside its length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Attributes {
    /// The program may not write it.
    pub(crate) read_only: bool,
    /// A warm restart sets it to zeros.
    pub(crate) non_retain: bool,
}

/// A created data block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Created {
    pub(crate) number: u16,
    /// Its first byte in the arena.
    pub(crate) base: u32,
    /// Its length in bytes.
    pub(crate) length: u32,
    pub(crate) attributes: Attributes,
}

/// The created data blocks, in the order of their places. `non_retain`: those with this attribute.
pub(crate) fn created(machine: &Machine, non_retain: &BTreeSet<u16>) -> Vec<Created> {
    let block = |number: u16| {
        let DataBlockEntry { base, length, read_only } = machine.memory.data_block(u64::from(number))?;
        let attributes = Attributes { read_only, non_retain: non_retain.contains(&number) };
        Some(Created { number, base, length, attributes })
    };
    taken(machine).into_iter().filter_map(|(_, number)| block(number)).collect()
}

/// Sets created data blocks to zeros.
pub(crate) fn clear(machine: &mut Machine, numbers: &BTreeSet<u16>) {
    for &number in numbers {
        let Some(entry) = machine.memory.data_block(u64::from(number)) else { continue };
        machine.memory.arena[entry.base as usize..(entry.base + entry.length) as usize].fill(0);
    }
}

/// Deletes all created data blocks; no block may be running.
pub(crate) fn delete_created(machine: &mut Machine) {
    for (_, number) in taken(machine) {
        machine.memory.data_blocks[usize::from(number)] = None;
    }
}

/// The room that data blocks need of the reserve, if they can be created together, which have their numbers and lengths in bytes.
pub(crate) fn fit(machine: &Machine, blocks: impl Iterator<Item = (u16, usize)>) -> bool {
    let mut numbers = BTreeSet::new();
    let mut left = RESERVE;
    for (number, length) in blocks {
        let sound = number > 0 && number <= machine.memory.layout.db_number_max && length > 0 && length.is_multiple_of(2);
        let Some(rest) = left.checked_sub(length.next_multiple_of(8)) else { return false };
        left = rest;
        if !sound || machine.memory.layout.data_blocks.contains_key(&number) || !numbers.insert(number) {
            return false;
        }
    }
    true
}

/// Makes a data block with these values, between two scans; one that [`fit`] found to fit among those before it.
pub(crate) fn create(machine: &mut Machine, number: u16, values: &[u8], read_only: bool) {
    machine.memory.add_reserve();
    let length = values.len() as u32;
    let base = place(machine, room(length)).expect("blocks that fit together find their places one behind the other");
    insert(machine, number, base, length, read_only);
    machine.memory.arena[base..base + values.len()].copy_from_slice(values);
}
