//! Error codes of the protocol.

/// Why a job as a whole is refused: class and code in the header, or the error word of a userdata answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u16)]
pub enum Refusal {
    /// The service does not exist.
    UnknownService = 0x8100,
    /// The service is not implemented, or an error in the frame; what a CPU answers whose PUT and GET are off.
    NotImplemented = 0x8104,
    /// The type of a block or operand does not fit.
    TypeInconsistent = 0x8204,
    /// Not enough memory.
    NoMemory = 0x8301,
    /// Not enough resources: too many uploads, remainders, jobs.
    NoResource = 0x8302,
    /// No more uploads at the same time.
    NoParallelUpload = 0x8304,
    /// The function is not available, as in this operating mode.
    NotAvailable = 0x8305,
    /// The wrong moment in a sequence of jobs.
    WrongSequence = 0x8401,
    /// The state of the object does not allow it.
    WrongState = 0x8402,
    /// It cannot be performed.
    CannotPerform = 0x8404,
    /// The frame is wrong, or the answer longer than the PDU.
    WrongFrame = 0x8500,
    /// The address is wrong.
    WrongAddress = 0x8701,
    /// The access is not supported.
    AccessNotSupported = 0x8702,
    /// The access is refused.
    AccessRefused = 0x8703,
    /// The object is damaged.
    ObjectDamaged = 0x8704,
    /// A test function that is not possible in this mode.
    TestNotPossible = 0xD002,
    /// A test function that this CPU does not have.
    TestNotSupported = 0xD0CC,
    /// The syntax of a block name.
    BlockNameSyntax = 0xD201,
    /// The syntax of a parameter of a block function.
    BlockParameterSyntax = 0xD202,
    /// A linked block of this name is there.
    LinkedBlockExists = 0xD205,
    /// A passive block of this name is there.
    PassiveBlockExists = 0xD206,
    /// There is no such block.
    BlockNotFound = 0xD209,
    /// There is no further block of this type.
    NoFurtherBlock = 0xD20E,
    /// The block is too large for the CPU.
    BlockTooLarge = 0xD20F,
    /// A block of this type cannot have such a number.
    BlockNumber = 0xD210,
    /// An attribute of the block.
    BlockAttribute = 0xD212,
    /// The lengths in the block contradict one another.
    BlockLengths = 0xD219,
    /// Too much local data.
    LocalDataTooLong = 0xD21A,
    /// The language of the block.
    BlockLanguage = 0xD220,
    /// The instance and its block do not fit.
    InstanceMismatch = 0xD223,
    /// The structure of the block is wrong.
    BlockStructure = 0xD226,
    /// The checksum of the block is wrong.
    BlockChecksum = 0xD235,
    /// The block has no checksum.
    NoBlockChecksum = 0xD236,
    /// The block is in use by another job.
    BlockCoordination = 0xD240,
    /// The protection level does not allow it.
    Protected = 0xD241,
    /// Another block function runs.
    BlockFunctionBusy = 0xD2A1,
    /// No list of this SZL_ID.
    UnknownListId = 0xD401,
    /// No list under this INDEX.
    UnknownListIndex = 0xD402,
    /// The syntax of a request for a system status list or a message.
    ListSyntax = 0xD405,
    /// The information is not available.
    ListNotAvailable = 0xD406,
    /// The syntax of a password.
    PasswordSyntax = 0xD601,
    /// The password is wrong.
    WrongPassword = 0xD602,
    /// The connection is legitimated already.
    AlreadyLegitimated = 0xD603,
    /// The connection was open anyway.
    AlreadyEnabled = 0xD604,
    /// No password is needed.
    NoPasswordNeeded = 0xD605,
    /// The syntax of a cyclic job.
    CyclicSyntax = 0xD801,
    /// No further cyclic job.
    TooManyCyclicJobs = 0xD803,
    /// The time base of a cyclic job.
    CyclicTimeBase = 0xD804,
    /// There is no such cyclic job.
    NoCyclicJob = 0xD806,
    /// The clock does not show such a time.
    WrongTime = 0xDC01,
    /// There is no such ID of an upload or download.
    WrongTransferId = 0xEF01,
}

impl Refusal {
    /// The number that is sent.
    pub const fn code(self) -> u16 {
        self as u16
    }
}

/// What is said of one variable of a read or write job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum ItemCode {
    /// A module does not answer.
    HardwareFault = 0x01,
    /// The access is not allowed.
    AccessRefused = 0x03,
    /// The address lies outside.
    OutOfRange = 0x05,
    /// The data type is not supported there.
    TypeNotSupported = 0x06,
    /// The data type and the bytes that came do not fit.
    TypeInconsistent = 0x07,
    /// The object does not exist.
    NotThere = 0x0A,
    /// It is done.
    Done = 0xFF,
}

impl ItemCode {
    /// The number that is sent.
    pub const fn code(self) -> u8 {
        self as u8
    }
}
