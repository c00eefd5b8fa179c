//! Operands of statements after all names are resolved: what the meanings work on.

use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;
use sieben_model::literal::Value;
use sieben_model::types::DataType;

/// The operand of a statement.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Operand {
    /// None.
    #[default]
    None,
    /// A bit, byte, word or double word in memory.
    Memory(Access),
    /// A timer.
    Timer(NumberOperand),
    /// A counter.
    Counter(NumberOperand),
    /// A scan of the status word: `==0`, `OV`, `BR` …
    Status(StatusScan),
    /// `STW`.
    StatusWord,
    /// `DBLG`, `DBNO`, `DILG`, `DINO`.
    DataBlockInfo(DataBlockInfo),
    /// A constant.
    Constant(Value),
    /// `AR2`, the operand of `LAR1 AR2` and `TAR1 AR2`.
    AddressRegister2,
    /// A label: the index of its statement in the block.
    Label(u32),
    /// The block of `UC`, `CC`, `OPN`.
    Block(BlockOperand),
    /// A call with parameters.
    Call(Box<Call>),
    /// `P##name` of a parameter of a function: the pointer that the caller gave (all other `P##name` are constants).
    ParameterAddress(u16),
}

/// A memory access.
#[derive(Clone, Debug, PartialEq)]
pub struct Access {
    /// How much.
    pub width: Width,
    /// Where.
    pub location: Location,
}

/// Where an access goes; positions in bits (byte × 8 + bit).
#[derive(Clone, Debug, PartialEq)]
pub enum Location {
    /// `I 0.0`, `MW 10`, `DBX 2.5`, `PIW 256`, `#temp` (then in L).
    Fixed {
        /// Which area.
        area: Area,
        /// The position.
        position: u32,
    },
    /// `DB10.DBW 2`, `"DB".field`: opens the block in the DB register, then accesses it.
    InDataBlock {
        /// Its number.
        db: u16,
        /// The position.
        position: u32,
    },
    /// `DI10.DIW 2`: the same with the DI register.
    InInstanceBlock {
        /// Its number.
        db: u16,
        /// The position.
        position: u32,
    },
    /// `MW [MD 4]`: the pointer lies in a double word of M, L, DB or DI.
    MemoryIndirect {
        /// The area that is accessed.
        area: Area,
        /// Where the pointer lies.
        pointer: Box<Location>,
    },
    /// `MW [AR1,P#2.0]`, or with the area in the register: `W [AR1,P#2.0]` (then `area` is `None`).
    RegisterIndirect {
        /// The area, if it is written.
        area: Option<Area>,
        /// AR1 or AR2.
        register: AddressRegister,
        /// The offset of the statement, in bits.
        offset: u32,
    },
    /// A parameter of a function, elementary or the start of a complex one: through the pointer that the caller gave.
    Parameter {
        /// Its index.
        index: u16,
        /// Inside a complex parameter: the position of the element.
        offset: u32,
        /// Whether the caller gave a pointer to a POINTER or ANY in its local data (complex types).
        complex: bool,
    },
    /// A parameter or static variable of a function block: `DIX[AR2,P#position]`.
    Instance {
        /// The position in the instance.
        position: u32,
    },
    /// Inside a complex VAR_IN_OUT of a function block: through the POINTER that lies in the instance.
    InstancePointer {
        /// The position of the POINTER in the instance.
        position: u32,
        /// The position of the element behind what it points to.
        offset: u32,
    },
}

/// AR1 or AR2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AddressRegister {
    /// Address register 1.
    Ar1,
    /// Address register 2.
    Ar2,
}

/// The number of a timer, counter or block.
#[derive(Clone, Debug, PartialEq)]
pub enum NumberOperand {
    /// `T 5`.
    Fixed(u16),
    /// `T [MW 10]`: the number lies in a word of M, L, DB or DI; also a TIMER, COUNTER or BLOCK parameter of an FB.
    Indirect(Box<Location>),
    /// A TIMER, COUNTER or BLOCK parameter of a function: the caller passes the number itself.
    Parameter(u16),
}

/// What a scan of the status word asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StatusScan {
    /// `==0`: CC 1 = 0 and CC 0 = 0.
    Zero,
    /// `<>0`: CC 1 ≠ CC 0.
    NonZero,
    /// `>0`: CC 1 = 1, CC 0 = 0.
    Positive,
    /// `<0`: CC 1 = 0, CC 0 = 1.
    Negative,
    /// `>=0`: CC 0 = 0.
    NotNegative,
    /// `<=0`: CC 1 = 0.
    NotPositive,
    /// `UO`: CC 1 = 1 and CC 0 = 1.
    Unordered,
    /// `OV`.
    Overflow,
    /// `OS`.
    StoredOverflow,
    /// `BR`.
    BinaryResult,
}

/// What `L DBLG` and its like ask.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DataBlockInfo {
    /// `DBLG`.
    SharedLength,
    /// `DBNO`.
    SharedNumber,
    /// `DILG`.
    InstanceLength,
    /// `DINO`.
    InstanceNumber,
}

/// The block of `UC`, `CC` and `OPN`.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockOperand {
    /// FC, FB, SFC, SFB, DB.
    pub kind: BlockKind,
    /// `OPN DI`: the DI register.
    pub instance: bool,
    /// Its number.
    pub number: NumberOperand,
}

/// A `CALL`.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// What is called.
    pub callee: BlockId,
    /// The instance: none for a function.
    pub instance: Option<CallInstance>,
    /// The parameters in the order of the callee's interface.
    pub parameters: Vec<CallParameter>,
}

/// The instance of a called function block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CallInstance {
    /// `CALL FB 1, DB 2`.
    DataBlock(u16),
    /// `CALL #inst`: a multi-instance at this position (bits) of the caller's own instance.
    Multi(u32),
}

/// One parameter of a `CALL`.
#[derive(Clone, Debug, PartialEq)]
pub struct CallParameter {
    /// Its section in the callee.
    pub section: Section,
    /// Its type in the callee.
    pub data_type: DataType,
    /// FB: its position in the instance, in bits. FC: its index.
    pub position: u32,
    /// What the caller gives; `None` = omitted (only with an instance).
    pub actual: Option<Actual>,
}

/// An actual parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Actual {
    /// An elementary value in memory.
    Memory(Access),
    /// A constant (elementary: its bits fit the type; POINTER and ANY literals too).
    Constant(Value),
    /// A timer number.
    Timer(NumberOperand),
    /// A counter number.
    Counter(NumberOperand),
    /// A block number.
    Block(NumberOperand),
    /// A complex variable (ARRAY, STRUCT, STRING, DATE_AND_TIME) or one passed to POINTER or ANY, by place and type.
    Complex {
        /// Where it lies.
        location: Location,
        /// Its type.
        data_type: DataType,
    },
}
