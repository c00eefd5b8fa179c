//! The one vocabulary in which everyone outside talks to a CPU.

use std::fmt;

use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::item::Item;
use sieben_model::program::DataBlock;
use sieben_model::value::Value;

use crate::clock::{ClockRefused, DateAndTime};
use crate::communication::{Communication, Requester};
use crate::cycle::CycleTimes;
use crate::data_block_replacement::ReplaceRefused;
use crate::diagnostic_buffer::DiagnosticBuffer;
use crate::forcing::Forced;
use crate::loaded_blocks::BlockView;
use crate::mode::{NotInStop, OperatingMode, Restart, StartRefused, StopCause};
use crate::system_status_list::{NoList, PartialList};

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
    /// The data block is READ_ONLY: neither the program nor anyone outside writes its values.
    WriteProtected,
}

impl fmt::Display for AccessError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotRunning(block) => return write!(f, "`{block}` is not the block that runs"),
            Self::NoRegister => "the CPU has only the accumulators 1 and 2; the S7-400 has four",
            Self::ReadOnly => "it can only be read",
            Self::WriteProtected => "the data block is READ_ONLY; its values come with the program, or with a download of the block",
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
    /// An I or PI of a simulated module is set in the module and stays; any other I holds for one scan. A READ_ONLY data block is not written.
    ///
    /// # Errors
    /// Nothing is there to be modified, or it is protected.
    fn modify(&mut self, operand: &Operand, value: u32) -> Result<(), AccessError>;
    /// Reads items, each for itself, all at the same cycle control point. Registers are those after the last statement of OB 1.
    fn read_items(&self, items: &[Item]) -> Vec<Result<Value, AccessError>>;
    /// Gives items values, one after the other at the same cycle control point: an input in its module, a register for the beginning of OB 1
    /// in the next scan, anything else in place. One that cannot be set leaves the others alone; a READ_ONLY data block is not written.
    fn write_items(&mut self, values: &[(Item, Value)]) -> Vec<Result<(), AccessError>>;
    /// What is forced.
    fn forced(&self) -> &Forced;
    /// Forces an operand to a value (raw bits) from the next cycle control point on, until [`Self::unforce`]; a restart does not end it.
    ///
    /// # Errors
    /// The CPU type does not force this operand, or it lies outside its area.
    fn force(&mut self, operand: &Operand, value: u32) -> Result<(), AccessError>;
    /// Ends the forcing of an operand, or of its bits that are forced; `false` if none of it was. It keeps the value until something writes it.
    ///
    /// # Errors
    /// The CPU type does not force this operand, or it lies outside its area.
    fn unforce(&mut self, operand: &Operand) -> Result<bool, AccessError>;
    /// Ends all forcing.
    fn unforce_all(&mut self);
    /// A timer as it stands.
    fn timer(&self, number: u16) -> Option<TimerReading>;
    /// The diagnostic buffer.
    fn diagnostic_buffer(&self) -> &DiagnosticBuffer;
    /// Why the CPU is in STOP; `None` in other modes and before the first start.
    fn stop_cause(&self) -> Option<&StopCause>;
    /// How long the cycle takes.
    fn cycle_times(&self) -> CycleTimes;
    /// Sends the CPU to STOP on behalf of a programming device.
    fn stop(&mut self) {
        self.stop_by(Requester::default());
    }
    /// The same; the diagnostic buffer keeps who asked (16#4304). In STOP nothing happens.
    fn stop_by(&mut self, by: Requester);
    /// Starts the CPU on behalf of a programming device; one that runs goes to STOP first.
    fn restart(&mut self, restart: Restart) -> OperatingMode;
    /// Starts the CPU from STOP; the diagnostic buffer keeps who asked (16#1381 and its like). A hot restart where none is possible is a
    /// warm restart: on an S7-300, after loading and after a memory reset. The startup block runs at the time of the last scan; with a clock of
    /// its own: [`crate::Cpu::start_with`].
    ///
    /// # Errors
    /// The CPU is not in STOP.
    fn start(&mut self, restart: Restart, by: Requester) -> Result<OperatingMode, StartRefused>;
    /// All memory as if the program had just been loaded; the diagnostic buffer, which keeps who asked, the clock and the run-time meters stay.
    ///
    /// # Errors
    /// The CPU is not in STOP.
    fn memory_reset(&mut self, by: Requester) -> Result<(), NotInStop>;
    /// The time of day at the last scan.
    fn clock(&self) -> DateAndTime;
    /// Sets the time of day that it was at the last scan, as SFC 0 does: time-of-day interrupts that are skipped are a time error.
    ///
    /// # Errors
    /// The clock does not show such a time.
    fn set_clock(&mut self, wanted: DateAndTime) -> Result<(), ClockRefused>;
    /// The blocks with statements and the data blocks by kind and number, those too that the program made.
    fn blocks(&self) -> Vec<BlockId>;
    /// One of them.
    fn block(&self, id: BlockId) -> Option<BlockView>;
    /// Gives a data block of the program these values, and the load memory too: what comes back at a cold restart, a memory reset or, if it is
    /// NON_RETAIN, a warm restart. Another length, a block that is new or one to delete are an online change.
    ///
    /// # Errors
    /// The values cannot take the place of those that are there.
    fn replace_data_block(&mut self, block: &DataBlock) -> Result<(), ReplaceRefused>;
    /// The values of a data block as they are now: those of the work memory, or of the load memory if it is UNLINKED.
    fn data_block_values(&self, number: u16) -> Option<Vec<u8>>;
    /// Deletes a data block that the program made at run time, as SFC 23 does; `false` if there is none of this number. One of the program goes
    /// with an online change.
    fn delete_created_data_block(&mut self, number: u16) -> bool;
    /// Copies RAM to ROM: the values of the data blocks of the program become those of the load memory, which come back at a cold restart, a
    /// memory reset or, if a block is NON_RETAIN, a warm restart. Answers how many have changed there.
    fn copy_ram_to_rom(&mut self) -> usize;
    /// A system status list as SFC 51 reads it; of the diagnostic buffer all entries, also on an S7-300.
    ///
    /// # Errors
    /// There is no such list.
    fn status_list(&self, id: u16, index: u16) -> Result<PartialList, NoList>;
    /// Tells what the status lists show of servers: connections, protection, names.
    fn set_communication(&mut self, communication: Communication);
}
