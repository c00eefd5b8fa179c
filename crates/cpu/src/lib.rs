//! The controller: cycle, organization blocks, process image, system functions.
//!
//! It is deterministic and asks the operating system for nothing: time comes in as an argument, modules
//! through [`IoModule`], everyone who looks from outside through [`Station`].
#![forbid(unsafe_code)]

mod cpu;
mod created_data_blocks;
mod diagnostic_events;
mod failed_statements;
mod host;
mod reactions;
mod slots;
mod system_state;
mod tape;

pub mod clock;
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

pub use clock::DateAndTime;
pub use cpu::{
    ChangeRefused, Cpu, DataLoss, EndState, Loaded, NotReplayed, RecordedScan, Replayer, ScanReport, Snapshot, StopRequest, TestStep,
};
pub use cycle::CycleTimes;
pub use diagnostic_buffer::{DiagnosticBuffer, DiagnosticEntry};
pub use failed_statements::{FailedStatement, FailedStatements};
pub use forcing::Forced;
pub use host::BUDGET_MAX;
pub use interrupts::{Coming, CyclicInterrupt, Interrupt};
pub use io::{IoModule, Rack, RackError, SimulatedModule};
pub use items::Moment;
pub use mode::{OperatingMode, Restart, StopCause};
pub use online_change::OnlineChange;
pub use retain::{RetainImage, RetentiveAreas};
pub use settings::{ImageErrors, Settings, TimeSource};
pub use station::{AccessError, Station, TimerReading};
pub use system_state::Asked;
