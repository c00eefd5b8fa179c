//! The one vocabulary in which everyone outside talks to a CPU.

use std::fmt;

use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::item::Item;
use sieben_model::value::Value;

use crate::cycle::CycleTimes;
use crate::diagnostic_buffer::DiagnosticBuffer;
use crate::mode::{OperatingMode, Restart, StopCause};

/// Why an operand cannot be read or written from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccessError {
    /// The address lies outside its area, data block, or the timers and counters of the CPU type.
    Outside,
    /// The data block is not loaded.
    NotLoaded,
    /// No module answers at this peripheral address.
    NoModule,
    /// Local data and blocks have no value to show between two scans; peripheral outputs cannot be read by a program but are shown.
    NotAccessible,
    /// The value does not fit: a counter holds 0 to 999, a timer an S5TIME of three BCD digits.
    Value,
    /// The CPU type does not force this operand: an S7-300 forces inputs and outputs, an S7-400 bit memory too.
    NotForced,
    /// The variable belongs to a block that does not run at this moment.
    NotRunning(BlockId),
    /// The CPU type has only the accumulators 1 and 2.
    NoRegister,
    /// It can be read and not set: the status of a timer, what a caller gave, the registers of an open data block.
    ReadOnly,
}

impl fmt::Display for AccessError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotRunning(block) => return write!(f, "`{block}` is not the block that runs"),
            Self::NoRegister => "the CPU has only the accumulators 1 and 2; the S7-400 has four",
            Self::ReadOnly => "it can only be read",
            Self::Outside => "the address lies outside what the CPU type or the data block has",
            Self::NotLoaded => "the data block is not loaded",
            Self::NoModule => "no module answers at this address",
            Self::NotAccessible => {
                "only inputs, outputs, bit memory, timers, counters, data blocks and peripheral addresses have a value between two scans"
            }
            Self::NotForced => "a CPU of the S7-300 forces inputs and outputs (I, Q), one of the S7-400 bit memory (M) too",
            Self::Value => "the value does not fit: a counter holds 0 to 999, a timer an S5TIME with three BCD digits",
        })
    }
}

impl std::error::Error for AccessError {}

/// A timer as it stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TimerReading {
    /// The status bit that `A T n` scans.
    pub status: bool,
    /// The remaining value in units of the time base, as `L T n` delivers it.
    pub value: u16,
    /// The time base, 0 to 3: 10 ms, 100 ms, 1 s, 10 s.
    pub base: u8,
    /// Whether it counts down.
    pub running: bool,
}

/// What can be asked of a CPU and done to it from outside. Everything takes effect at the cycle control point.
pub trait Station {
    /// What the CPU is.
    fn cpu_type(&self) -> &'static CpuType;
    /// What it is doing.
    fn mode(&self) -> OperatingMode;
    /// Reads an operand: raw bits for addresses, the remaining value for a timer, the count for a counter.
    /// I and Q are the process image, PI the module itself, PQ what was last put out.
    ///
    /// # Errors
    /// Nothing is there to be read.
    fn read(&self, operand: &Operand) -> Result<u32, AccessError>;
    /// Modifies an operand: raw bits for addresses, an S5TIME word for a timer, the count for a counter.
    /// An I or PI of a simulated module is set in the module and stays; any other I holds for one scan.
    ///
    /// # Errors
    /// Nothing is there to be modified.
    fn modify(&mut self, operand: &Operand, value: u32) -> Result<(), AccessError>;
    /// Reads items, each for itself, all at the same cycle control point. Registers are those after the last statement of OB 1.
    fn read_items(&self, items: &[Item]) -> Vec<Result<Value, AccessError>>;
    /// Gives items values, one after the other at the same cycle control point: an input in its module, a register for the beginning of OB 1
    /// in the next scan, anything else in place. One that cannot be set leaves the others alone.
    fn write_items(&mut self, values: &[(Item, Value)]) -> Vec<Result<(), AccessError>>;
    /// A timer as it stands.
    fn timer(&self, number: u16) -> Option<TimerReading>;
    /// The diagnostic buffer.
    fn diagnostic_buffer(&self) -> &DiagnosticBuffer;
    /// Why the CPU is in STOP; `None` in other modes and before the first start.
    fn stop_cause(&self) -> Option<&StopCause>;
    /// How long the cycle takes.
    fn cycle_times(&self) -> CycleTimes;
    /// Sends the CPU to STOP on behalf of a programming device.
    fn stop(&mut self);
    /// Starts the CPU on behalf of a programming device.
    fn restart(&mut self, restart: Restart) -> OperatingMode;
}
