//! How much memory a CPU takes for itself, beside what it shares with others that run the same program.

use sieben_engine::machine::memory::DataBlockEntry;
use sieben_engine::machine::{Counter, Frame, Timer};

use super::Cpu;
use crate::diagnostic_buffer::DiagnosticEntry;

/// Bytes that one CPU takes, by what they are for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CpuBytes {
    /// Data blocks with their table, also those that were created at run time.
    pub data_blocks: usize,
    /// Modules with a life of their own; what they keep behind pointers does not count.
    pub plants: usize,
    /// All else: process images, bit memory, local data, timers and counters, what is put out and set at the modules, diagnostic buffer.
    pub own: usize,
}

impl CpuBytes {
    /// All of them.
    pub fn total(&self) -> usize {
        self.data_blocks + self.plants + self.own
    }
}

impl Cpu {
    /// What the CPU takes for itself. The program, its code and its layout are not in it: any number of CPUs share them.
    pub fn bytes(&self) -> CpuBytes {
        let memory = &self.machine.memory;
        let layout = &memory.layout;
        let of_program: usize = layout.data_blocks.values().map(ExactSizeIterator::len).sum();
        let table = memory.data_blocks.capacity() * size_of::<Option<DataBlockEntry>>();
        let data_blocks = of_program + memory.reserve().len();
        let (plants, simulated) = self.rack.bytes();
        let lists = self.machine.timers.capacity() * size_of::<Timer>()
            + self.machine.counters.capacity() * size_of::<Counter>()
            + self.machine.frames.capacity() * size_of::<Frame>()
            + self.machine.parameters.capacity() * size_of::<u32>();
        let entries = self.diagnostics.entries().len() * size_of::<DiagnosticEntry>();
        let own = size_of::<Self>() + memory.arena.capacity().saturating_sub(data_blocks) + lists + entries + simulated;
        CpuBytes { data_blocks: data_blocks + table, plants, own }
    }
}
