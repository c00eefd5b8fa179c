//! Where the areas of a CPU lie in its arena.

use std::collections::BTreeMap;
use std::ops::Range;

use sieben_model::address::Area;
use sieben_model::block::BlockKind;
use sieben_model::cpu_type::CpuType;

use super::local_need;
use crate::ir::{Callee, Inst};
use crate::program::Program;

/// Bytes for data blocks created at run time.
pub const RESERVE: usize = 64 * 1024;

/// Bytes behind the data blocks: as many as a STRING may have, so that one may be read as a whole wherever it begins, and a word behind it.
const BEHIND: usize = 2 + u8::MAX as usize + 8;

/// Numbers of the system functions that create data blocks: CREAT_DB and CREA_DB.
pub const CREATE_DATA_BLOCKS: [u16; 2] = [22, 85];

/// Priority classes of the largest CPU, 0 to 28.
const PRIORITY_CLASSES: usize = 29;

/// Addresses whose distance is a multiple of this are taken for the same by processors that look at some bits of them only: where one was
/// just written, a load of the other waits (`docs/decisions/271-areas-that-are-no-multiples-apart.md`).
const ALIASES: usize = 1024;

/// Where the process images, bit memory, local data and data blocks begin, modulo [`ALIASES`]: most programs use the first bytes of each.
const APART: [usize; 5] = [0, 0x100, 0x200, 0x300, 0x380];

/// Places of all areas; fixed while a program is loaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Process image of the inputs.
    pub inputs: Range<usize>,
    /// Process image of the outputs.
    pub outputs: Range<usize>,
    /// Bit memory.
    pub bit_memory: Range<usize>,
    /// Local data of all priority classes, as much of it as the program can use.
    pub local: Range<usize>,
    /// Bytes of it that one priority class may use.
    pub local_class: usize,
    /// Data blocks by number.
    pub data_blocks: BTreeMap<u16, Range<usize>>,
    /// Data blocks that the program may not write.
    pub read_only: Vec<u16>,
    /// Where data blocks created at run time begin, behind all others: [`RESERVE`] bytes if the program calls what creates them, else none.
    pub reserve: usize,
    /// Bytes of the whole arena, at least.
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
        let mut place = |bytes: usize, apart: Option<usize>| {
            let gap = apart.map_or(0, |at| (at + ALIASES - size % ALIASES) % ALIASES);
            let start = size + gap;
            size = start + bytes.next_multiple_of(8);
            start..start + bytes
        };
        let [at_inputs, at_outputs, at_bit_memory, at_local, at_data] = APART.map(Some);
        let inputs = place(cpu.process_image as usize, at_inputs);
        let outputs = place(cpu.process_image as usize, at_outputs);
        let bit_memory = place(cpu.bit_memory as usize, at_bit_memory);
        let local_class = cpu.local_data as usize + hidden_local_data(cpu, program);
        // A class is interrupted by one of each organization block at most.
        let blocks = program.code.keys().filter(|block| block.kind == BlockKind::OrganizationBlock).count();
        let classes = if cpu.local_data_shared { 1 } else { blocks.clamp(1, PRIORITY_CLASSES) };
        // No more than the program can use: a CPU without it is a third as large.
        let local = place((local_class * classes).min(local_need::at_most(cpu, program)), at_local);
        place(0, at_data);
        let mut take = |bytes: usize| place(bytes, None);
        let data_blocks = program.data.iter().filter(|(_, db)| !db.unlinked).map(|(&number, db)| (number, take(db.image.len()))).collect();
        take(BEHIND);
        let reserve = take(if creates_data_blocks(program) { RESERVE } else { 0 }).start;
        let read_only = program.data.values().filter(|db| db.read_only).map(|db| db.number).collect();
        Self {
            read_only,
            inputs,
            outputs,
            bit_memory,
            local,
            local_class,
            data_blocks,
            reserve,
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

/// The most bytes of a priority class that count for nothing where only declared local data count: as many blocks inside one another as
/// the CPU allows, each with what the neediest one has beside its declarations.
fn hidden_local_data(cpu: &CpuType, program: &Program) -> usize {
    if !cpu.local_data_declared {
        return 0;
    }
    let hidden = program.code.values().map(|block| block.local_size.saturating_sub(block.interface.local_size)).max().unwrap_or(0);
    hidden as usize * (usize::from(cpu.nesting_depth) + usize::from(cpu.nesting_depth_error) + 1)
}

/// Whether a block of the program calls a system function that creates data blocks.
fn creates_data_blocks(program: &Program) -> bool {
    let creates = |inst: &Inst| match inst {
        Inst::Call { callee: Callee::Block(id), .. } => id.kind == BlockKind::SystemFunction && CREATE_DATA_BLOCKS.contains(&id.number),
        Inst::Call { callee: Callee::Number(kind, _), .. } => *kind == BlockKind::SystemFunction,
        _ => false,
    };
    program.code.values().any(|block| block.code.insts.iter().any(creates))
}

#[cfg(test)]
mod tests {
    use sieben_model::block::BlockId;

    use super::*;
    use crate::ir::Builder;
    use crate::program::CodeBlock;

    #[test]
    fn only_a_program_that_creates_data_blocks_has_room_for_them() {
        let reserve = |callee| {
            let mut builder = Builder::default();
            builder.begin_statement();
            builder.push(Inst::Call { callee, parameters: 0 });
            let block = CodeBlock { code: builder.finish(), ..CodeBlock::default() };
            let program = Program { code: [(BlockId::ob(1), block)].into(), ..Program::default() };
            let layout = Layout::new(&CpuType::ALL[0], &program);
            layout.size - layout.reserve
        };
        for number in CREATE_DATA_BLOCKS {
            assert_eq!(reserve(Callee::Block(BlockId::new(BlockKind::SystemFunction, number))), RESERVE);
            assert_eq!(reserve(Callee::Block(BlockId::fc(number))), 0);
        }
        assert_eq!(reserve(Callee::Block(BlockId::new(BlockKind::SystemFunction, 20))), 0);
    }
}
