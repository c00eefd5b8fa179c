//! What a connection may do: functions, areas and data blocks.

use std::ops::RangeInclusive;

use sieben_cpu::ProtectionLevel;
use sieben_model::cpu_type::CpuType;

/// The rules that a server has for all its connections.
#[derive(Clone, Debug, PartialEq)]
pub struct Rules {
    /// The CPU that is behind it: it says how long a PDU is.
    pub cpu: &'static CpuType,
    /// The protection level of the CPU.
    pub protection: ProtectionLevel,
    /// The password that lifts it, filled up with spaces to eight characters.
    pub password: Option<[u8; 8]>,
    /// Whether anything may be changed at all.
    pub writing: Writing,
    /// The areas that may be reached; `None` for all.
    pub allow: Option<Vec<Allowed>>,
    /// As a real CPU where that makes tests harder: no cold start on an S7-300.
    pub strict: bool,
    /// Only connections to the slot of the CPU.
    pub strict_slot: bool,
}

/// Whether clients may change anything.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Writing {
    /// They may, as far as the protection level allows it.
    #[default]
    Allowed,
    /// They may not: every write is refused.
    ReadOnly,
}

/// An area that may be reached.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Allowed {
    /// Which area.
    pub area: AllowedArea,
    /// Whether it may be written as well.
    pub writing: Writing,
}

/// An area in an allow-list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AllowedArea {
    /// Peripheral inputs and outputs.
    Peripheral,
    /// Inputs.
    Inputs,
    /// Outputs.
    Outputs,
    /// Bit memory.
    BitMemory,
    /// Timers.
    Timers,
    /// Counters.
    Counters,
    /// Data blocks with these numbers.
    DataBlocks(RangeInclusive<u16>),
}

/// What clients ask for, as it is guarded and counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
    /// Setup of the connection.
    Setup,
    /// Reading variables.
    Read,
    /// Writing variables.
    Write,
    /// System status lists.
    SystemStatus,
    /// Reading the clock.
    Clock,
    /// Setting the clock.
    SetClock,
    /// Lists of blocks and their headers.
    BlockLists,
    /// Upload.
    Upload,
    /// Download.
    Download,
    /// Linking.
    Link,
    /// Deleting.
    Delete,
    /// STOP.
    Stop,
    /// A start.
    Start,
    /// Copy RAM to ROM.
    CopyRamToRom,
    /// Compressing the memory.
    Compress,
    /// Memory reset.
    MemoryReset,
    /// Entering and clearing a password.
    Password,
    /// Everything else.
    Other,
}

impl Function {
    /// All of them.
    pub const ALL: [Self; 18] = [
        Self::Setup,
        Self::Read,
        Self::Write,
        Self::SystemStatus,
        Self::Clock,
        Self::SetClock,
        Self::BlockLists,
        Self::Upload,
        Self::Download,
        Self::Link,
        Self::Delete,
        Self::Stop,
        Self::Start,
        Self::CopyRamToRom,
        Self::Compress,
        Self::MemoryReset,
        Self::Password,
        Self::Other,
    ];
}
