//! The contract between CPU and engine.

use sieben_model::address::Width;
use sieben_model::block::BlockId;

use crate::fault::{Fault, Place};
use crate::image_writes::ImageWrites;
use crate::machine::{Machine, Registers};
use crate::program::Program;
use crate::tracer::Tracer;

/// What a run works on.
pub struct Context<'a> {
    /// All state that a program can touch.
    pub machine: &'a mut Machine,
    /// Who answers for the CPU.
    pub host: &'a mut dyn Host,
    /// Who watches statements; without one the run pays nothing.
    pub tracer: Option<&'a mut dyn Tracer>,
}

/// Where a run begins.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The organization block.
    pub block: BlockId,
    /// The first 20 bytes of its local data.
    pub start_information: [u8; 20],
    /// Registers at the first statement; `None` = those of a fresh priority class (BR = 1, all else 0).
    pub registers: Option<Box<Registers>>,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Exit {
    /// The organization block ended. The registers are those before the block end took effect.
    Finished,
    /// The Host stopped the CPU. The frames stay as they were: `resume` goes on behind the statement, as a hot restart does.
    Stopped(StopReason),
    /// The Host suspended the run; `resume` goes on.
    Suspended,
    /// The tracer paused the run between two statements; `go_on` goes on as if nothing had happened.
    Paused,
}

/// Why the CPU stops: the event of the diagnostic buffer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StopReason {
    /// Event ID, such as 16#4562.
    pub event: u16,
    /// Where it happened, if a statement caused it.
    pub place: Option<Place>,
}

/// What the Host answers.
#[derive(Clone, Debug, PartialEq)]
pub enum Reaction {
    /// Go on: a failed load delivers 0, any other failed statement counts as NOP.
    Continue,
    /// Go on; a failed load delivers this value (SFC 44).
    Replace(u32),
    /// Run this organization block first, then go on as with `Continue` (or the value it replaced).
    /// Any but OB 121 and OB 122 begins a priority class of its own ([`Machine::push_frame`]).
    Enter {
        /// OB 121, OB 122 or an interrupt OB.
        block: BlockId,
        /// The first 20 bytes of its local data.
        start_information: [u8; 20],
    },
    /// The CPU goes to STOP.
    Stop(StopReason),
    /// Leave the run; it can be resumed at this point.
    Suspend,
    /// Only from [`Host::system_function`]: it failed as a statement does, and the engine asks [`Host::fault`] about it.
    Fail(Fault),
}

/// What a program must ask for. The Host never calls an engine.
pub trait Host {
    /// A statement failed. An [`Fault::Abort`] can only be answered by `Stop`.
    ///
    /// Of one that [is noted](Fault::is_noted) the Host is only told: it changes nothing of the machine but the budget.
    fn fault(&mut self, machine: &mut Machine, fault: &Fault, place: Place) -> Reaction;
    /// Reads a module; `None` = no module answers at this address.
    fn peripheral_read(&mut self, machine: &mut Machine, byte: u32, width: Width) -> Option<u32>;
    /// Writes a module (the process image is the Host's to update); `false` = no module answers at this address.
    fn peripheral_write(&mut self, machine: &mut Machine, byte: u32, width: Width, value: u32) -> bool;
    /// The safe-point budget is used up: refill `machine.budget` or stop.
    /// Asked too, whatever the budget, when an organization block has ended that [`Reaction::Enter`] started between two statements.
    fn safe_point(&mut self, machine: &mut Machine, place: Place) -> Reaction;
    /// Runs system function (block) `block`; its parameters are `machine.parameters[first..]` (pointers), its instance the DI register.
    fn system_function(&mut self, machine: &mut Machine, block: BlockId, first_parameter: usize) -> Reaction;
    /// The bytes of the arena that this system function (block), the last one that was called, has written, whether they changed or not.
    fn written(&self, machine: &Machine, block: BlockId) -> Vec<std::ops::Range<usize>> {
        let _ = (machine, block);
        Vec::new()
    }
    /// Whether the CPU has this system function (block); calling one that it lacks is programming error 3D or 3F.
    fn has_system_function(&self, block: BlockId) -> bool {
        let _ = block;
        true
    }
}

/// Something that runs loaded code.
pub trait Engine: Send + Sync {
    /// Runs an organization block from its beginning.
    fn run(&self, context: &mut Context<'_>, entry: &Entry) -> Exit;
    /// Goes on with the frames of the machine, after [`Exit::Suspended`] and [`Exit::Stopped`]. The place where it goes on is a safe point.
    fn resume(&self, context: &mut Context<'_>) -> Exit;
    /// Goes on after [`Exit::Paused`], with the statement before which the run paused: nothing is asked that the run had asked already.
    fn go_on(&self, context: &mut Context<'_>) -> Exit;
    /// Whether this block is loaded.
    fn has_block(&self, block: BlockId) -> bool;
    /// Bytes of machine code; 0 if the program is interpreted.
    fn code_bytes(&self) -> usize {
        0
    }
    /// Which bytes of the process images it writes while it runs this program.
    fn image_writes(&self, program: &Program) -> ImageWrites {
        ImageWrites::of(program)
    }
    /// A newer generation of the same code, which a CPU takes over between two scans. Every generation gives the same results, and goes
    /// on with frames that another one left.
    fn newer(&self) -> Option<std::sync::Arc<dyn Engine>> {
        None
    }
}
