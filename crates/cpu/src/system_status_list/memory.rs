//! How much the CPU has of what: lists 16#xy13, 16#xy14 and 16#xy15.

use super::{SystemStatus, record, words};

/// Bytes of work memory by CPU type.
const WORK_MEMORY: &[(&str, u32)] =
    &[("315-2PN/DP", 384 << 10), ("317-2PN/DP", 1 << 20), ("319-3PN/DP", 2 << 20), ("416-3", 16 << 20), ("417-4", 32 << 20)];
/// Bytes of the load memory: that of a large memory card.
const LOAD_MEMORY: u32 = 8 << 20;

/// A memory of the CPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemoryUse {
    /// Its bytes.
    pub size: u32,
    /// Those that the values of data blocks take.
    pub used: u32,
}

impl SystemStatus<'_> {
    /// The work memory and the load memory.
    pub fn memory(&self) -> [MemoryUse; 2] {
        memory(self)
    }
}

fn memory(status: &SystemStatus<'_>) -> [MemoryUse; 2] {
    let work = WORK_MEMORY.iter().find(|row| row.0 == status.cpu_type.name).map_or(WORK_MEMORY[0].1, |row| row.1);
    let loaded: usize = status.program.data.values().map(|block| block.image.len()).sum();
    let used = status.program.data.values().filter(|block| !block.unlinked).map(|block| block.image.len()).sum::<usize>();
    let of = |size: u32, used: usize| MemoryUse { size, used: u32::try_from(used).unwrap_or(u32::MAX).min(size) };
    [of(work, used), of(LOAD_MEMORY, loaded)]
}

/// List 16#xy13: work memory and load memory.
pub(super) fn areas(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    let row = |(index, MemoryUse { size, used }): (u16, MemoryUse)| {
        let largest = size - used;
        let [size, used, largest] = [size, used, largest].map(u32::to_be_bytes);
        // Code and number of the area, its size, mode, granularity; size, used and largest free block of its first part.
        record(36, &[&index.to_be_bytes(), &index.to_be_bytes(), &size, &[0, 1], &[0, 1], &size, &used, &largest])
    };
    (1..).zip(memory(status)).map(row).collect()
}

/// List 16#xy14: process image, bit memory, timers, counters, peripheral addresses, local data.
pub(super) fn system_areas(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    let cpu = status.cpu_type;
    let word = |value: u32| u16::try_from(value).unwrap_or(u16::MAX);
    // Bit memory is counted in bytes, in both of its records; what is retentive by default: 16 bytes of it and 8 counters.
    let rows: [(u16, u32, u16); 9] = [
        (1, cpu.process_image, 0),
        (2, cpu.process_image, 0),
        (3, cpu.bit_memory, 16),
        (4, u32::from(cpu.timers), 0),
        (5, u32::from(cpu.counters), 8),
        (6, cpu.peripheral, 0),
        (7, cpu.local_data, 0),
        (8, cpu.bit_memory, 16),
        (9, cpu.local_data / 1024, 0),
    ];
    rows.iter().map(|&(index, quantity, retentive)| words(8, &[index, 1, word(quantity), retentive])).collect()
}

/// List 16#xy15: kinds of blocks, how many there may be, how long they may be.
pub(super) fn block_types(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    let cpu = status.cpu_type;
    let kilobytes = u16::try_from(cpu.block_size_max / 1024).unwrap_or(u16::MAX);
    let rows = [
        (0x0800_u16, 23_u16),
        (0x0A00, cpu.db_number_max),
        (0x0B00, 0),
        (0x0C00, cpu.fc_number_max.saturating_add(1)),
        (0x0E00, cpu.fc_number_max.saturating_add(1)),
    ];
    let row = |&(kind, count): &(u16, u16)| {
        let [kind, count, kilobytes] = [kind, count, kilobytes].map(u16::to_be_bytes);
        record(10, &[&kind, &count, &kilobytes, &cpu.block_size_max.to_be_bytes()])
    };
    rows.iter().map(row).collect()
}
