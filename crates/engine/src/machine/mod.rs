//! All state that a program can touch, as plain data.

pub mod counters;
pub mod data_block_table;
pub mod known_layout;
pub mod layout;
mod local_need;
pub mod memory;
pub mod timers;

use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};

use crate::fault::Abort;

pub use counters::Counter;
pub use layout::Layout;
pub use memory::Memory;
pub use sieben_model::registers::{self, Register, Registers, StatusWord};
pub use timers::{Timer, TimerKind};

/// In a pointer to V, the bits from this one to bit 23 count the calls that it was passed on over.
pub const CALLS_SHIFT: u32 = 19;

/// The address in a pointer to V, without that count.
pub const CALLS_MASK: u32 = (1 << CALLS_SHIFT) - 1;

/// One CPU's state.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    /// The CPU registers.
    pub registers: Registers,
    /// All areas and data blocks.
    pub memory: Memory,
    /// The S5 timers.
    pub timers: Vec<Timer>,
    /// The S5 counters.
    pub counters: Vec<Counter>,
    /// Blocks that are being executed, outermost first.
    pub frames: Vec<Frame>,
    /// Parameter pointers of those blocks.
    pub parameters: Vec<u32>,
    /// Time that the CPU has spent in STARTUP and RUN, in microseconds: what timers count by.
    pub clock_us: u64,
    /// Safe points, by weight, until the Host is asked again.
    pub budget: i64,
}

/// A block being executed, with what its end restores.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The block.
    pub block: BlockId,
    /// The block in the engine's own list.
    pub code: u32,
    /// Where it goes on: an index into the engine's own code.
    pub resume: u32,
    /// First byte of its local data in the local data of the priority class.
    pub local_base: u32,
    /// Bytes of its local data.
    pub local_size: u32,
    /// First of its parameters.
    pub parameters: u32,
    /// One behind the last of its parameters; what lies above is being passed on.
    pub parameters_end: u32,
    /// How many blocks of its priority class it is nested in.
    pub depth: u8,
    /// First byte of the local data of its priority class.
    pub class_base: u32,
    /// Whether it runs on behalf of a synchronous error (OB 121, OB 122): those may nest deeper.
    pub in_error: bool,
    /// How it was entered.
    pub origin: Origin,
}

impl Frame {
    /// `resume` of a block that was interrupted at its first statement, whose safe point has been counted already.
    pub const ENTERED: u32 = u32::MAX;

    /// Whether a priority class begins with it. The blocks of synchronous errors belong to the class of their cause.
    pub fn begins_class(&self) -> bool {
        match self.origin {
            Origin::Start => true,
            Origin::Interrupt { .. } => !is_error_block(self.block),
            Origin::Call(_) => false,
        }
    }
}

/// Whether it is the organization block of a synchronous error.
fn is_error_block(block: BlockId) -> bool {
    block.kind == BlockKind::OrganizationBlock && matches!(block.number, 121 | 122)
}

/// How a block was entered.
#[derive(Clone, Debug, PartialEq)]
pub enum Origin {
    /// By the CPU, as an organization block of a fresh priority class.
    Start,
    /// By a call; the end of the block restores these registers of the caller.
    Call(CallerRegisters),
    /// By a fault or interrupt; the end restores everything.
    Interrupt {
        /// All registers of the interrupted block.
        registers: Box<Registers>,
        /// A variable that receives a value on return, for a failed load.
        deliver: Option<(u8, u32)>,
    },
}

/// What the end of a called block restores.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CallerRegisters {
    /// DB register: number, base, length.
    pub shared: [u64; 3],
    /// DI register: number, base, length.
    pub instance: [u64; 3],
    /// Whether the MCR was active.
    pub mcr_active: u64,
    /// The nesting stack.
    pub nesting: u64,
}

impl Machine {
    /// Pushes the frame of a block that is entered; what both engines do. Its parameters are the newest `parameters` ones.
    ///
    /// # Errors
    /// The priority class has no local data left, or too many blocks are nested in it.
    pub fn push_frame(&mut self, block: BlockId, code: u32, local_size: u32, parameters: u16, origin: Origin) -> Result<(), Abort> {
        let layout = &self.memory.layout;
        let error_block = is_error_block(block) && matches!(origin, Origin::Interrupt { .. });
        let (local_base, class_base, depth, in_error) = match self.frames.last() {
            // A block that interrupts another one begins a priority class of its own behind it.
            Some(below) if matches!(origin, Origin::Interrupt { .. }) && !error_block => {
                let base = below.local_base + below.local_size;
                (base, base, 0, false)
            }
            Some(caller) => {
                let in_error = caller.in_error || error_block;
                (caller.local_base + caller.local_size, caller.class_base, caller.depth.saturating_add(1), in_error)
            }
            None => (0, 0, 0, false),
        };
        let limit = layout.nesting_depth.saturating_add(if in_error { layout.nesting_depth_error } else { 0 });
        if depth > limit && !error_block {
            return Err(Abort::BlockStack);
        }
        let end = (local_base + local_size) as usize;
        if end - class_base as usize > layout.local_class || end > layout.local.len() {
            return Err(Abort::LocalData);
        }
        let end = self.parameters.len() as u32;
        self.frames.push(Frame {
            block,
            code,
            resume: 0,
            local_base,
            local_size,
            parameters: end.saturating_sub(u32::from(parameters)),
            parameters_end: end,
            depth,
            class_base,
            in_error,
            origin,
        });
        Ok(())
    }

    /// A machine with cleared memory in this layout.
    pub fn new(layout: Arc<Layout>) -> Self {
        Self {
            registers: Registers::fresh(),
            timers: vec![Timer::default(); usize::from(layout.timers)],
            counters: vec![Counter::default(); usize::from(layout.counters)],
            memory: Memory::new(layout),
            frames: Vec::new(),
            parameters: Vec::new(),
            clock_us: 0,
            budget: 0,
        }
    }

    /// The arena bytes of the local data of the running block (`outwards` = 0), its caller (1), the caller of that (2) …
    /// An organization block has no caller.
    pub fn local_data(&self, outwards: usize) -> std::ops::Range<usize> {
        let local = self.memory.layout.local.start;
        let frame = self.frames.len().checked_sub(outwards + 1).map(|index| &self.frames[index..]);
        match frame {
            Some([frame, inner @ ..]) if inner.iter().all(|inner| matches!(inner.origin, Origin::Call(_))) => {
                local + frame.local_base as usize..local + (frame.local_base + frame.local_size) as usize
            }
            _ => 0..0,
        }
    }
}
