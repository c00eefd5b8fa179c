//! The blocks that a CPU has, as those outside see them.

use std::collections::{BTreeMap, BTreeSet};

use sieben_engine::{Machine, Program};
use sieben_model::block::{BlockAttributes, BlockId, BlockKind, BlockLanguage};
use sieben_model::cpu_type::CpuType;

use crate::clock::DateAndTime;
use crate::created_data_blocks;

/// A block that is loaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BlockView {
    /// Which one.
    pub id: BlockId,
    /// What its header says, and its language.
    pub attributes: BlockAttributes,
    /// Bytes of local data that it needs; 0 for a data block.
    pub local_bytes: u32,
    /// Bytes that its statements have at least as machine code of the S7; `None` for a data block, and where that is not known.
    pub code_bytes: Option<u32>,
    /// Bytes of its values; 0 for a block with statements.
    pub data_bytes: u32,
    /// Bytes in the load memory, without header and interface: its values or its code. A data block that the program made has none.
    pub load_memory_bytes: Option<u32>,
    /// What a data block is an instance of, or which UDT it has.
    pub based_on: Option<BlockId>,
    /// The program may not write it.
    pub read_only: bool,
    /// A warm restart sets it to the values of the load memory.
    pub non_retain: bool,
    /// It is in the load memory only.
    pub unlinked: bool,
    /// When it was loaded, by the clock of the CPU: sources do not keep when they were written. Of a data block that the program made it is
    /// when the program was loaded.
    pub loaded: DateAndTime,
}

/// When blocks were loaded, by the clock of the CPU.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct LoadTimes {
    /// The program as a whole.
    pub(crate) program: DateAndTime,
    /// Blocks that came later.
    later: BTreeMap<BlockId, DateAndTime>,
}

impl LoadTimes {
    /// The program is loaded.
    pub(crate) fn at(program: DateAndTime) -> Self {
        Self { program, later: BTreeMap::new() }
    }

    /// A block is loaded while the rest of the program stays.
    pub(crate) fn later(&mut self, id: BlockId, now: DateAndTime) {
        self.later.insert(id, now);
    }

    /// A block is there no more.
    pub(crate) fn forget(&mut self, id: BlockId) {
        self.later.remove(&id);
    }

    fn of(&self, id: BlockId) -> DateAndTime {
        self.later.get(&id).copied().unwrap_or(self.program)
    }
}

/// What a CPU is loaded with.
#[derive(Clone, Copy)]
pub(crate) struct LoadedBlocks<'a> {
    pub(crate) cpu_type: &'a CpuType,
    pub(crate) program: &'a Program,
    pub(crate) machine: &'a Machine,
    /// Created data blocks that a warm restart clears.
    pub(crate) non_retain: &'a BTreeSet<u16>,
    pub(crate) times: &'a LoadTimes,
}

impl LoadedBlocks<'_> {
    /// All of them by kind and number, created data blocks too. Blocks with numbers that the CPU type does not have are those of tests.
    pub(crate) fn all(&self) -> Vec<BlockId> {
        let code = self.program.code.keys().copied();
        let data = self.program.data.keys().map(|&number| BlockId::db(number));
        let created = created_data_blocks::taken(self.machine).into_iter().map(|(_, number)| BlockId::db(number));
        let ids: BTreeSet<BlockId> = code.chain(data).chain(created).filter(|&id| self.has_number(id)).collect();
        ids.into_iter().collect()
    }

    /// One of them.
    pub(crate) fn view(&self, id: BlockId) -> Option<BlockView> {
        if !self.has_number(id) {
            return None;
        }
        match id.kind {
            BlockKind::DataBlock => self.data(id),
            _ => self.code(id),
        }
    }

    fn has_number(&self, id: BlockId) -> bool {
        let last = match id.kind {
            BlockKind::DataBlock => self.cpu_type.db_number_max,
            BlockKind::OrganizationBlock => self.cpu_type.organization_blocks.iter().map(|&(_, last)| last).max().unwrap_or(0),
            _ => self.cpu_type.fc_number_max,
        };
        id.number <= last
    }

    fn code(&self, id: BlockId) -> Option<BlockView> {
        let block = self.program.code.get(&id)?;
        Some(BlockView {
            id,
            attributes: self.program.attributes.get(&id).cloned().unwrap_or_default(),
            local_bytes: block.local_size,
            code_bytes: block.mc7_bytes,
            data_bytes: 0,
            load_memory_bytes: block.mc7_bytes,
            based_on: None,
            read_only: false,
            non_retain: false,
            unlinked: false,
            loaded: self.times.of(id),
        })
    }

    fn data(&self, id: BlockId) -> Option<BlockView> {
        let view = |language: BlockLanguage, bytes: u32| BlockView {
            id,
            attributes: self.program.attributes.get(&id).cloned().unwrap_or(BlockAttributes::of(language)),
            local_bytes: 0,
            code_bytes: None,
            data_bytes: bytes,
            load_memory_bytes: None,
            based_on: None,
            read_only: false,
            non_retain: false,
            unlinked: false,
            loaded: self.times.of(id),
        };
        if let Some(block) = self.program.data.get(&id.number) {
            let bytes = u32::try_from(block.image.len()).unwrap_or(u32::MAX);
            return Some(BlockView {
                load_memory_bytes: Some(bytes),
                based_on: block.based_on,
                read_only: block.read_only,
                non_retain: block.non_retain,
                unlinked: block.unlinked,
                ..view(BlockLanguage::Data, bytes)
            });
        }
        let entry = self.machine.memory.data_block(u64::from(id.number))?;
        let non_retain = self.non_retain.contains(&id.number);
        Some(BlockView { read_only: entry.read_only, non_retain, ..view(BlockLanguage::CreatedData, entry.length) })
    }
}
