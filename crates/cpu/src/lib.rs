//! The controller: cycle, organization blocks, process image, system functions.
//!
//! It is deterministic and asks the operating system for nothing: time comes in as an argument, modules
//! through [`IoModule`], everyone who looks from outside through [`Station`].
#![forbid(unsafe_code)]

mod cpu;
mod created_data_blocks;
mod data_block_change;
mod data_block_replacement;
mod diagnostic_events;
mod failed_statements;
pub mod histogram;
mod host;
mod loaded_blocks;
mod reactions;
mod slots;
mod system_state;
mod tape;

pub mod clock;
pub mod communication;
pub mod cycle;
pub mod diagnostic_buffer;
pub mod forcing;
pub mod interrupts;
pub mod io;
pub mod items;
pub mod listening;
pub mod mode;
pub mod online_change;
pub mod organization_blocks;
pub mod process_image;
pub mod retain;
pub mod settings;
pub mod start_information;
pub mod station;
pub mod system;
pub mod system_status_list;

pub use clock::{ClockRefused, DateAndTime, TimeSource};
pub use communication::{Communication, ProtectionLevel, Requester};
pub use cpu::{
    ChangeRefused, Cpu, CpuBytes, DataLoss, EndState, Loaded, NotReplayed, RecordedScan, RecordedStep, Recording, Replayer, ScanReport,
    Snapshot, Step, StopRequest, TestStep,
};
pub use cycle::CycleTimes;
pub use data_block_change::{DataBlockChange, DataBlockInUse, undeclared};
pub use data_block_replacement::ReplaceRefused;
pub use diagnostic_buffer::{DiagnosticBuffer, DiagnosticEntry};
pub use failed_statements::{FailedStatement, FailedStatements};
pub use forcing::{Forced, Forces};
pub use histogram::Histogram;
pub use host::BUDGET_MAX;
pub use interrupts::{Coming, CyclicInterrupt, Interrupt};
pub use io::{IoModule, Rack, RackError, SimulatedModule};
pub use items::Moment;
pub use loaded_blocks::BlockView;
pub use mode::{NotInStop, OperatingMode, Restart, StartRefused, StopCause};
pub use online_change::OnlineChange;
pub use retain::{RetainImage, RetentiveAreas};
pub use settings::{ImageErrors, Settings};
pub use station::{AccessError, Station, TimerReading};
pub use system_state::Asked;
pub use system_status_list::{NoList, PartialList};
