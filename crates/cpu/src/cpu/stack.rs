//! All that runs, put aside while something else runs: OB 90 between two scans, the cycle that a hot restart goes on with.

use sieben_engine::machine::{Frame, Registers};

use super::Cpu;
use crate::start_information::StartInformation;
use crate::system_state;

/// Blocks that run, with all that they need to go on.
#[derive(Clone, Debug)]
pub(super) struct Stack {
    frames: Vec<Frame>,
    parameters: Vec<u32>,
    registers: Registers,
    /// The local data of these blocks.
    local: Vec<u8>,
    class: StartInformation,
    running: system_state::Running,
}

impl Cpu {
    /// Puts aside what runs; `None` if nothing does.
    pub(super) fn take_stack(&mut self) -> Option<Stack> {
        let machine = &mut self.machine;
        let newest = machine.frames.last()?;
        let start = machine.memory.layout.local.start;
        let local = machine.memory.arena[start..start + (newest.local_base + newest.local_size) as usize].to_vec();
        Some(Stack {
            frames: std::mem::take(&mut machine.frames),
            parameters: std::mem::take(&mut machine.parameters),
            registers: machine.registers.clone(),
            local,
            class: self.class,
            running: self.system.take_running(),
        })
    }

    /// Brings it back, to be resumed.
    pub(super) fn put_stack(&mut self, stack: Stack) {
        let machine = &mut self.machine;
        let start = machine.memory.layout.local.start;
        machine.memory.arena[start..start + stack.local.len()].copy_from_slice(&stack.local);
        machine.frames = stack.frames;
        machine.parameters = stack.parameters;
        machine.registers = stack.registers;
        self.class = stack.class;
        self.system.put_running(stack.running);
    }
}
