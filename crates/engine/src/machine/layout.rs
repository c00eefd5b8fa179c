//! Where the areas of a CPU lie in its arena.

use std::collections::BTreeMap;
use std::ops::Range;

use sieben_model::address::Area;
use sieben_model::block::BlockKind;
use sieben_model::cpu_type::CpuType;

use crate::program::Program;

/// Bytes kept free behind the data blocks for blocks created at run time.
pub const RESERVE: usize = 64 * 1024;

/// Priority classes of the largest CPU, 0 to 28.
const PRIORITY_CLASSES: usize = 29;

/// Places of all areas; fixed while a program is loaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Process image of the inputs.
    pub inputs: Range<usize>,
    /// Process image of the outputs.
    pub outputs: Range<usize>,
    /// Bit memory.
    pub bit_memory: Range<usize>,
    /// Local data of all priority classes.
    pub local: Range<usize>,
    /// Bytes of it that one priority class may use.
    pub local_class: usize,
    /// Data blocks by number.
    pub data_blocks: BTreeMap<u16, Range<usize>>,
    /// Data blocks that the program may not write.
    pub read_only: Vec<u16>,
    /// Bytes of the whole arena.
    pub size: usize,
    /// Number of timers.
    pub timers: u16,
    /// Number of counters.
    pub counters: u16,
    /// Bytes of peripheral addresses, inputs and outputs each.
    pub peripheral: u32,
    /// Greatest number of a data block.
    pub db_number_max: u16,
    /// Greatest number of an FC or FB.
    pub fc_number_max: u16,
    /// Nested block calls per priority class.
    pub nesting_depth: u8,
    /// Additional nested block calls inside a synchronous-error OB.
    pub nesting_depth_error: u8,
}

impl Layout {
    /// The layout of a program on a CPU type.
    pub fn new(cpu: &CpuType, program: &Program) -> Self {
        let mut size = 0;
        let mut take = |bytes: usize| {
            let start = size;
            size += bytes.next_multiple_of(8);
            start..start + bytes
        };
        let inputs = take(cpu.process_image as usize);
        let outputs = take(cpu.process_image as usize);
        let bit_memory = take(cpu.bit_memory as usize);
        let local_class = cpu.local_data as usize;
        // A class is interrupted by one of each organization block at most.
        let blocks = program.code.keys().filter(|block| block.kind == BlockKind::OrganizationBlock).count();
        let classes = if cpu.local_data_shared { 1 } else { blocks.clamp(1, PRIORITY_CLASSES) };
        let local = take(local_class * classes);
        let data_blocks = program.data.iter().filter(|(_, db)| !db.unlinked).map(|(&number, db)| (number, take(db.image.len()))).collect();
        take(RESERVE);
        let read_only = program.data.values().filter(|db| db.read_only).map(|db| db.number).collect();
        Self {
            read_only,
            inputs,
            outputs,
            bit_memory,
            local,
            local_class,
            data_blocks,
            size,
            timers: cpu.timers,
            counters: cpu.counters,
            peripheral: cpu.peripheral,
            db_number_max: cpu.db_number_max,
            fc_number_max: cpu.fc_number_max,
            nesting_depth: cpu.nesting_depth,
            nesting_depth_error: cpu.nesting_depth_error,
        }
    }

    /// The arena range of an area that is not local and not in a data block.
    pub fn area(&self, area: Area) -> Option<Range<usize>> {
        match area {
            Area::Input => Some(self.inputs.clone()),
            Area::Output => Some(self.outputs.clone()),
            Area::BitMemory => Some(self.bit_memory.clone()),
            _ => None,
        }
    }
}
