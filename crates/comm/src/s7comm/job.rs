//! Jobs: what a client asks of the CPU, in the words of the CPU, and what it answers.

use std::fmt;

use sieben_cpu::{DateAndTime, PartialList, Restart};
use sieben_model::block::BlockKind;
use sieben_workspace::gate::Plant;

use super::answer::Surroundings;
use super::wire::codes::{ItemCode, Refusal};

/// What a client asks of the CPU. A job is done in one entry of the gate, unless its answer is [`Reply::Later`].
#[derive(Clone, Debug, PartialEq)]
pub enum Job {
    /// Reads variables. One that cannot be read has its code already and keeps its place.
    Read(Vec<Result<Variable, ItemCode>>),
    /// Writes variables, one after the other. One that cannot be written has its code already and keeps its place.
    Write(Vec<Result<Assignment, ItemCode>>),
    /// Reads a system status list.
    SystemStatus {
        /// SZL_ID.
        id: u16,
        /// INDEX.
        index: u16,
    },
    /// Reads the clock.
    Clock,
    /// Sets the clock.
    SetClock(DateAndTime),
    /// How many blocks there are of each type.
    BlockCounts,
    /// The blocks of a type.
    BlockList(BlockType),
    /// What the header of a block says.
    BlockInfo(BlockName),
    /// STOP.
    Stop,
    /// A start from STOP.
    Start(Restart),
    /// The values of all data blocks go into the load memory.
    CopyRamToRom,
    /// Puts the free parts of the work memory together.
    Compress,
    /// All memory as after loading.
    MemoryReset,
    /// The image of a block, whole: the session cuts it into fragments.
    Upload(BlockName),
    /// A block that has come, whole: it is passive until it is linked.
    Download(Download),
    /// `_INSE`: makes blocks active that were downloaded.
    Link(Vec<BlockName>),
    /// `_DELE`: deletes blocks.
    Delete(Vec<BlockName>),
}

impl Job {
    /// Whether it leaves the CPU as it is.
    pub fn only_reads(&self) -> bool {
        match self {
            Self::Read(_) | Self::SystemStatus { .. } | Self::Clock | Self::BlockCounts | Self::BlockList(_) | Self::BlockInfo(_) => true,
            Self::Upload(_) | Self::Compress => true,
            Self::Write(_) | Self::SetClock(_) | Self::Stop | Self::Start(_) | Self::CopyRamToRom | Self::MemoryReset => false,
            Self::Download(_) | Self::Link(_) | Self::Delete(_) => false,
        }
    }
}

/// What is read or written: consecutive elements of an area.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Variable {
    /// The area.
    pub area: VariableArea,
    /// What one element is.
    pub size: TransportSize,
    /// How many elements; 1 for a bit.
    pub count: u16,
    /// Its first bit in the area; the number of a timer or counter.
    pub address: u32,
}

/// A variable with its new value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assignment {
    /// Where it goes.
    pub variable: Variable,
    /// As many bytes as the variable has; a bit is one byte, 0 or 1.
    pub bytes: Box<[u8]>,
}

/// An area as the protocol has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum VariableArea {
    /// Peripheral inputs when read, peripheral outputs when written.
    Peripheral,
    /// Process image of the inputs, I.
    Input,
    /// Process image of the outputs, Q.
    Output,
    /// Bit memory, M.
    BitMemory,
    /// A data block.
    DataBlock(u16),
    /// S5 timers.
    Timer,
    /// S5 counters.
    Counter,
}

/// What one element of a variable is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TransportSize {
    /// One bit.
    Bit,
    /// A byte.
    Byte,
    /// A character.
    Char,
    /// 16 bits.
    Word,
    /// A signed number of 16 bits.
    Int,
    /// 32 bits.
    DoubleWord,
    /// A signed number of 32 bits.
    DoubleInt,
    /// A REAL.
    Real,
    /// An S5 timer.
    Timer,
    /// An S5 counter.
    Counter,
}

/// The type of a block in names of the protocol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BlockType {
    /// OB.
    OrganizationBlock,
    /// DB.
    DataBlock,
    /// SDB.
    SystemDataBlock,
    /// FC.
    Function,
    /// SFC.
    SystemFunction,
    /// FB.
    FunctionBlock,
    /// SFB.
    SystemFunctionBlock,
}

/// The types with their code, which stands in the header of a block and, as two hexadecimal digits, in names; in the order of the list of counts.
#[rustfmt::skip] // A table.
const BLOCK_TYPES: &[(BlockType, u8, Option<BlockKind>)] = &[
    (BlockType::OrganizationBlock,   0x08, Some(BlockKind::OrganizationBlock)),
    (BlockType::FunctionBlock,       0x0E, Some(BlockKind::FunctionBlock)),
    (BlockType::Function,            0x0C, Some(BlockKind::Function)),
    (BlockType::DataBlock,           0x0A, Some(BlockKind::DataBlock)),
    (BlockType::SystemDataBlock,     0x0B, None),
    (BlockType::SystemFunction,      0x0D, Some(BlockKind::SystemFunction)),
    (BlockType::SystemFunctionBlock, 0x0F, Some(BlockKind::SystemFunctionBlock)),
];

impl BlockType {
    /// All types in the order of the list of counts.
    pub fn all() -> impl Iterator<Item = Self> {
        BLOCK_TYPES.iter().map(|row| row.0)
    }

    /// Its code in the header of a block, `0x0A` for a DB.
    pub fn code(self) -> u8 {
        BLOCK_TYPES.iter().find(|row| row.0 == self).map_or(0, |row| row.1)
    }

    /// The type with this code.
    pub fn from_code(code: u8) -> Option<Self> {
        BLOCK_TYPES.iter().find(|row| row.1 == code).map(|row| row.0)
    }

    /// The two characters that stand for it in names, `0A` for a DB.
    pub fn characters(self) -> [u8; 2] {
        let digit = self.code() & 0xF;
        [b'0', if digit < 10 { b'0' + digit } else { b'A' + (digit - 10) }]
    }

    /// The type that these two characters stand for.
    pub fn from_characters(characters: [u8; 2]) -> Option<Self> {
        Self::all().find(|one| one.characters() == characters)
    }

    /// The kind of block; `None` for an SDB, which no program has.
    pub fn kind(self) -> Option<BlockKind> {
        BLOCK_TYPES.iter().find(|row| row.0 == self).and_then(|row| row.2)
    }

    /// The type of this kind of block; `None` for a UDT, which is in no CPU.
    pub fn of_kind(kind: BlockKind) -> Option<Self> {
        BLOCK_TYPES.iter().find(|row| row.2 == Some(kind)).map(|row| row.0)
    }
}

/// Which of the two memories a name means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlockPlace {
    /// `A`: linked, in the work memory.
    Active,
    /// `P`: in the load memory only.
    Passive,
    /// `B`: wherever it is.
    Both,
}

/// A block as a job names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BlockName {
    /// Its type.
    pub block_type: BlockType,
    /// Its number.
    pub number: u16,
    /// Where it is meant.
    pub place: BlockPlace,
}

/// A block that has come, whole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Download {
    /// What the request called it.
    pub name: BlockName,
    /// Its image as it came, header and footer included.
    pub image: Vec<u8>,
    /// Bytes of load memory that the request announced.
    pub load_bytes: u32,
    /// Bytes of MC7 code or values that the request announced.
    pub code_bytes: u32,
}

/// A block in the list of its type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockEntry {
    /// Its number.
    pub number: u16,
    /// Its flags: 16#22 for one that is linked.
    pub flags: u8,
    /// The code of its language.
    pub language: u8,
}

/// What the CPU answers.
#[derive(Debug)]
pub enum Reply {
    /// The job as a whole is refused.
    Refused(Refusal),
    /// It is done; there is nothing to say.
    Done,
    /// It goes on in later entries of the gate; until then the jobs after it in the same connection wait.
    Later(Box<dyn Pending>),
    /// To [`Job::Read`]: the bytes of each variable; a bit is one byte.
    Values(Vec<Result<Box<[u8]>, ItemCode>>),
    /// To [`Job::Write`]: a code for each variable.
    Written(Vec<ItemCode>),
    /// To [`Job::SystemStatus`].
    SystemStatus(PartialList),
    /// To [`Job::Clock`].
    Clock(DateAndTime),
    /// To [`Job::BlockCounts`].
    BlockCounts(Vec<(BlockType, u16)>),
    /// To [`Job::BlockList`].
    BlockList(Vec<BlockEntry>),
    /// To [`Job::BlockInfo`]: the first and the last 36 bytes of the image of the block.
    BlockInfo {
        /// Which block.
        name: BlockName,
        /// The header.
        header: [u8; 36],
        /// The footer.
        footer: [u8; 36],
    },
    /// To [`Job::Upload`]: the image.
    Image(Vec<u8>),
    /// To [`Job::Stop`] in STOP and [`Job::Start`] in RUN: nothing was done.
    Already,
}

/// A job that takes more than one entry of the gate. Dropping it before it has ended gives the job up: nothing of it takes
/// effect later, except a start that was asked for.
pub trait Pending: fmt::Debug + Send {
    /// Looks whether it has ended, and does what can be done now; `None` while it goes on. It is asked about every 5 ms, and
    /// [`super::session::PENDING_US_MAX`] after its beginning it is dropped and refused.
    fn poll(&mut self, plant: &mut Plant, around: &mut Surroundings) -> Option<Reply>;
}
