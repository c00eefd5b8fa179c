//! The arena: all areas and data blocks in one piece, big endian as in the S7.

use std::ops::Range;
use std::sync::Arc;

use sieben_model::address::{Address, Area, Operand, Width};

use super::data_block_table::DataBlockTable;
use super::known_layout::KnownLayout;
use super::layout::{Layout, RESERVE};

/// All data memory of a CPU.
#[derive(Clone, Debug, PartialEq)]
pub struct Memory {
    /// The bytes.
    pub arena: Vec<u8>,
    /// Where things lie in them.
    pub layout: Arc<Layout>,
    /// Data blocks by number.
    pub data_blocks: DataBlockTable,
    /// Which engine knows the layout.
    pub known_layout: KnownLayout,
}

/// A loaded data block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DataBlockEntry {
    /// First byte in the arena.
    pub base: u32,
    /// Length in bytes.
    pub length: u32,
    /// The program may not write it.
    pub read_only: bool,
}

impl Memory {
    /// Cleared memory.
    pub fn new(layout: Arc<Layout>) -> Self {
        let count = layout.data_blocks.keys().next_back().map_or(0, |&number| usize::from(number) + 1);
        let mut data_blocks = vec![None; count];
        for (&number, range) in &layout.data_blocks {
            data_blocks[usize::from(number)] = Some(DataBlockEntry {
                base: range.start as u32,
                length: range.len() as u32,
                read_only: layout.read_only.contains(&number),
            });
        }
        Self { arena: vec![0; layout.size], layout, data_blocks: DataBlockTable::new(data_blocks), known_layout: KnownLayout::default() }
    }

    /// The loaded data block with this number.
    pub fn data_block(&self, number: u64) -> Option<DataBlockEntry> {
        self.data_blocks.get(usize::try_from(number).ok()?).copied().flatten()
    }

    /// The bytes for data blocks created at run time.
    pub fn reserve(&self) -> Range<usize> {
        self.layout.reserve.min(self.arena.len())..self.arena.len()
    }

    /// Makes room for data blocks created at run time although the program creates none: those of another program come over.
    /// Only between two scans, because the arena may move.
    pub fn add_reserve(&mut self) {
        let size = self.arena.len().max(self.layout.reserve + RESERVE);
        self.arena.resize(size, 0);
    }

    /// Reads `width` at arena offset `at` (bit `bit` of that byte for a bit); of a quad word the low half.
    pub fn read_at(&self, at: usize, bit: u8, width: Width) -> u32 {
        self.read_wide(at, bit, width) as u32
    }

    /// Reads `width` at arena offset `at` (bit `bit` of that byte for a bit), zero-extended.
    #[inline(always)]
    pub fn read_wide(&self, at: usize, bit: u8, width: Width) -> u64 {
        let bytes = &self.arena[at..at + width.bytes() as usize];
        match width {
            Width::Bit => u64::from(bytes[0] >> bit & 1),
            Width::Byte => u64::from(bytes[0]),
            Width::Word => u64::from(u16::from_be_bytes([bytes[0], bytes[1]])),
            Width::DoubleWord => u64::from(u32::from_be_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
            Width::QuadWord => u64::from_be_bytes([bytes[0], bytes[1], bytes[2], bytes[3], bytes[4], bytes[5], bytes[6], bytes[7]]),
        }
    }

    /// Writes the low bits of `value` at arena offset `at`; into a quad word zero-extended.
    pub fn write_at(&mut self, at: usize, bit: u8, width: Width, value: u32) {
        self.write_wide(at, bit, width, u64::from(value));
    }

    /// Writes the low bits of `value` at arena offset `at`.
    #[inline(always)]
    pub fn write_wide(&mut self, at: usize, bit: u8, width: Width, value: u64) {
        let bytes = &mut self.arena[at..at + width.bytes() as usize];
        match width {
            Width::Bit => bytes[0] = bytes[0] & !(1 << bit) | ((value & 1) as u8) << bit,
            Width::Byte => bytes[0] = value as u8,
            Width::Word => bytes.copy_from_slice(&(value as u16).to_be_bytes()),
            Width::DoubleWord => bytes.copy_from_slice(&(value as u32).to_be_bytes()),
            Width::QuadWord => bytes.copy_from_slice(&value.to_be_bytes()),
        }
    }

    /// The arena offset of an operand in I, Q, M or a data block, if it lies inside; what an outside reader or writer uses.
    pub fn locate(&self, operand: &Operand) -> Option<usize> {
        let (range, address) = match operand {
            Operand::Address(address) => (self.layout.area(address.area)?, address),
            Operand::InDataBlock { db, address } => {
                let entry = self.data_block(u64::from(*db))?;
                (entry.base as usize..(entry.base + entry.length) as usize, address)
            }
            _ => return None,
        };
        let end = (address.byte as usize).checked_add(address.width.bytes() as usize)?;
        (end <= range.len()).then(|| range.start + address.byte as usize)
    }

    /// Reads an operand in I, Q, M or a data block; `None` if it is outside.
    pub fn read(&self, operand: &Operand) -> Option<u32> {
        let at = self.locate(operand)?;
        let (width, bit) = width_and_bit(operand)?;
        Some(self.read_at(at, bit, width))
    }

    /// Writes an operand in I, Q, M or a data block; `false` if it is outside.
    pub fn write(&mut self, operand: &Operand, value: u32) -> bool {
        let (Some(at), Some((width, bit))) = (self.locate(operand), width_and_bit(operand)) else { return false };
        self.write_at(at, bit, width, value);
        true
    }

    /// The bytes of an area (I, Q or M).
    pub fn area(&self, area: Area) -> &[u8] {
        self.layout.area(area).map_or(&[], |range| &self.arena[range])
    }

    /// The bytes of an area (I, Q or M), to change.
    pub fn area_mut(&mut self, area: Area) -> &mut [u8] {
        match self.layout.area(area) {
            Some(range) => &mut self.arena[range],
            None => &mut [],
        }
    }
}

fn width_and_bit(operand: &Operand) -> Option<(Width, u8)> {
    match operand {
        Operand::Address(Address { width, bit, .. }) | Operand::InDataBlock { address: Address { width, bit, .. }, .. } => {
            Some((*width, *bit))
        }
        _ => None,
    }
}
