//! Operands of statements after all names are resolved: what the meanings work on.

use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;
use sieben_model::literal::Value;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::extension::{Extension, is_status_bit};
pub use crate::access::{Access, AddressRegister, Direction, Location, NumberOperand};

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
    /// `__ACCU 1`, `__STW OV`: a register by its name, in extended programs.
    Register(Register),
    /// A statement with an extension word.
    Extension(Box<Extension>),
    /// `P##name` of a parameter of a function: the pointer that the caller gave (all other `P##name` are constants).
    ParameterAddress(u16),
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
    /// Its name in the callee.
    pub name: String,
    /// Where the caller gives it; the callee's name in the call if it is omitted.
    pub span: Span,
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

/// What operand an instruction takes: the operand column of the instruction table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OperandClass {
    /// None.
    None,
    /// A bit, a timer, a counter or a status scan.
    ScanBit,
    /// A bit in memory.
    AssignBit,
    /// What `L` takes: byte, word, double word, timer, counter, constant.
    Load,
    /// What `T` takes: byte, word, double word that can be written.
    Transfer,
    /// `STW`.
    StatusWord,
    /// `DBLG`, `DBNO`, `DILG`, `DINO`.
    DataBlockInfo,
    /// A timer.
    Timer,
    /// A counter.
    Counter,
    /// A timer or a counter.
    TimerOrCounter,
    /// What `LAR1` takes: a double word, a pointer constant or AR2.
    PointerSource,
    /// What `LAR2` takes: a double word or a pointer constant.
    PointerSourceWithoutAr2,
    /// What `TAR1` takes: a double word or AR2.
    PointerTarget,
    /// What `TAR2` takes: a double word.
    PointerTargetWithoutAr2,
    /// Nothing or `P#x.y`.
    OptionalPointerOffset,
    /// A constant from 0 to 255.
    ByteConstant,
    /// A 16-bit integer constant.
    IntConstant,
    /// `L#`.
    DoubleIntConstant,
    /// Nothing or a count from 0 to 15.
    ShiftCount16,
    /// Nothing or a count from 0 to 32.
    ShiftCount32,
    /// Nothing or a 16-bit constant.
    OptionalConstant16,
    /// Nothing or a 32-bit constant.
    OptionalConstant32,
    /// A label.
    Label,
    /// The block of `UC` and `CC`.
    CallBlock,
    /// A block with its parameters.
    Call,
    /// A data block, `DB` or `DI`.
    OpenBlock,
    /// The operands of an extension word.
    Extension,
    /// `0`, of `NOP 0`.
    Zero,
    /// `1`, of `NOP 1`.
    One,
}

impl OperandClass {
    /// What the instructions of this class do with a variable; `None` if the operand is none.
    ///
    /// Edge instructions share a class with assignments: [`super::instructions::Instruction::direction`] knows them.
    pub fn direction(self) -> Option<Direction> {
        match self {
            Self::ScanBit | Self::Load | Self::TimerOrCounter | Self::PointerSource | Self::PointerSourceWithoutAr2 => {
                Some(Direction::Read)
            }
            Self::AssignBit | Self::Transfer | Self::Timer | Self::Counter | Self::PointerTarget | Self::PointerTargetWithoutAr2 => {
                Some(Direction::Write)
            }
            Self::None
            | Self::StatusWord
            | Self::DataBlockInfo
            | Self::OptionalPointerOffset
            | Self::ByteConstant
            | Self::IntConstant
            | Self::DoubleIntConstant
            | Self::ShiftCount16
            | Self::ShiftCount32
            | Self::OptionalConstant16
            | Self::OptionalConstant32
            | Self::Label
            | Self::CallBlock
            | Self::Call
            | Self::OpenBlock
            | Self::Extension
            | Self::Zero
            | Self::One => None,
        }
    }

    /// What it takes, in words for a message: "`L` takes …".
    pub fn describe(self) -> &'static str {
        match self {
            Self::None => "no operand",
            Self::ScanBit => "a bit (I, Q, M, L, DBX, DIX), a timer, a counter or a status scan such as `==0` or `OV`",
            Self::AssignBit => "a bit (I, Q, M, L, DBX, DIX)",
            Self::Load => "a byte, word or double word, a timer, a counter or a constant",
            Self::Transfer => "a byte, word or double word that can be written",
            Self::StatusWord => "`STW`",
            Self::DataBlockInfo => "`DBLG`, `DBNO`, `DILG` or `DINO`",
            Self::Timer => "a timer",
            Self::Counter => "a counter",
            Self::TimerOrCounter => "a timer or a counter",
            Self::PointerSource => "nothing, a double word of M, L, DB or DI, a pointer such as `P#M 10.0`, or `AR2`",
            Self::PointerSourceWithoutAr2 => "nothing, a double word of M, L, DB or DI, or a pointer such as `P#M 10.0`",
            Self::PointerTarget => "nothing, a double word of M, L, DB or DI, or `AR2`",
            Self::PointerTargetWithoutAr2 => "nothing, or a double word of M, L, DB or DI",
            Self::OptionalPointerOffset => "nothing, or an offset from `P#0.0` to `P#4095.7`",
            Self::ByteConstant => "a number from 0 to 255",
            Self::IntConstant => "an integer from -32768 to 32767",
            Self::DoubleIntConstant => "an integer with `L#`",
            Self::ShiftCount16 => "nothing, or a count from 0 to 15",
            Self::ShiftCount32 => "nothing, or a count from 0 to 32",
            Self::OptionalConstant16 => "nothing, or a 16-bit constant such as `W#16#00FF`",
            Self::OptionalConstant32 => "nothing, or a 32-bit constant such as `DW#16#0000_00FF`",
            Self::Label => "a label of the same block",
            Self::CallBlock => "an FC, FB, SFC or SFB",
            Self::Call => "an FC, an FB with its instance, an SFC or SFB, or a multi-instance",
            Self::OpenBlock => "a data block, `DB` or `DI`",
            Self::Extension => "what its own line of the manual says",
            Self::Zero => "`0`",
            Self::One => "`1`",
        }
    }

    /// Whether the instruction takes this operand. Ranges of constants are part of it.
    pub fn accepts(self, operand: &Operand) -> bool {
        match self {
            Self::None => matches!(operand, Operand::None),
            Self::ScanBit => match operand {
                Operand::Timer(_) | Operand::Counter(_) | Operand::Status(_) => true,
                Operand::Register(register) => is_status_bit(*register),
                // TIA scans constants.
                Operand::Constant(value) => matches!(value, Value::Bool(_)),
                _ => Self::AssignBit.accepts(operand),
            },
            Self::AssignBit => matches!(operand, Operand::Memory(access) if access.width == Width::Bit),
            Self::Load => match operand {
                Operand::Memory(access) => access.width != Width::Bit && !access.is_in(Area::PeripheralOutput),
                Operand::Timer(_) | Operand::Counter(_) => true,
                Operand::Constant(value) => value.accumulator().is_some(),
                Operand::ParameterAddress(_) => true,
                Operand::Register(register) => !is_status_bit(*register),
                _ => false,
            },
            Self::Transfer => {
                matches!(operand, Operand::Memory(access) if access.width != Width::Bit && !access.is_in(Area::PeripheralInput))
            }
            Self::StatusWord => matches!(operand, Operand::StatusWord),
            Self::DataBlockInfo => matches!(operand, Operand::DataBlockInfo(_)),
            Self::Timer => matches!(operand, Operand::Timer(_)),
            Self::Counter => matches!(operand, Operand::Counter(_)),
            Self::TimerOrCounter => matches!(operand, Operand::Timer(_) | Operand::Counter(_)),
            Self::PointerSource => match operand {
                Operand::AddressRegister2 => true,
                _ => Self::PointerSourceWithoutAr2.accepts(operand),
            },
            Self::PointerSourceWithoutAr2 => match operand {
                Operand::Constant(value) => matches!(value, Value::Pointer(_)),
                Operand::ParameterAddress(_) => true,
                _ => Self::PointerTargetWithoutAr2.accepts(operand),
            },
            Self::PointerTarget => match operand {
                Operand::AddressRegister2 => true,
                _ => Self::PointerTargetWithoutAr2.accepts(operand),
            },
            Self::PointerTargetWithoutAr2 => matches!(operand, Operand::Memory(access) if access.width == Width::DoubleWord
                && !matches!(access.location, Location::MemoryIndirect { .. } | Location::RegisterIndirect { .. })
                && ![Area::Input, Area::Output, Area::PeripheralInput, Area::PeripheralOutput].iter().any(|&area| access.is_in(area))),
            Self::OptionalPointerOffset => match operand {
                Operand::None => true,
                Operand::Constant(Value::Pointer(pointer)) => *pointer <= 0x7FFF,
                _ => false,
            },
            Self::ByteConstant => matches!(constant_integer(operand), Some(0..=255)),
            Self::IntConstant => matches!(operand, Operand::Constant(Value::Int(_))),
            Self::DoubleIntConstant => matches!(operand, Operand::Constant(Value::DoubleInt(_))),
            Self::ShiftCount16 => matches!(operand, Operand::None) || matches!(constant_integer(operand), Some(0..=15)),
            Self::ShiftCount32 => matches!(operand, Operand::None) || matches!(constant_integer(operand), Some(0..=32)),
            Self::OptionalConstant16 => match operand {
                Operand::None => true,
                Operand::Constant(value) => {
                    matches!(value, Value::Word(_) | Value::Counter(_) | Value::Int(_) | Value::S5Time(_) | Value::Date(_) | Value::Byte(_))
                        || matches!(value, Value::Characters(text) if text.len() <= 2)
                }
                _ => false,
            },
            Self::OptionalConstant32 => match operand {
                Operand::None => true,
                Operand::Constant(value) => {
                    matches!(
                        value,
                        Value::DoubleWord(_)
                            | Value::DoubleInt(_)
                            | Value::Time(_)
                            | Value::TimeOfDay(_)
                            | Value::Real(_)
                            | Value::Word(_)
                            | Value::Pointer(_)
                    ) || matches!(value, Value::Characters(text) if text.len() <= 4)
                }
                _ => false,
            },
            Self::Label => matches!(operand, Operand::Label(_)),
            Self::CallBlock => matches!(operand, Operand::Block(block) if matches!(block.kind,
                BlockKind::Function | BlockKind::FunctionBlock | BlockKind::SystemFunction | BlockKind::SystemFunctionBlock)),
            Self::Call => matches!(operand, Operand::Call(_)),
            Self::OpenBlock => matches!(operand, Operand::Block(block) if block.kind == BlockKind::DataBlock),
            Self::Extension => matches!(operand, Operand::Extension(_)),
            Self::Zero => constant_integer(operand) == Some(0),
            Self::One => constant_integer(operand) == Some(1),
        }
    }
}

impl Access {
    /// Whether the access goes to this area by its own letters.
    pub fn is_in(&self, area: Area) -> bool {
        match &self.location {
            Location::Fixed { area: own, .. } | Location::MemoryIndirect { area: own, .. } => *own == area,
            Location::RegisterIndirect { area: own, .. } => *own == Some(area),
            _ => false,
        }
    }
}

fn constant_integer(operand: &Operand) -> Option<i32> {
    match operand {
        Operand::Constant(Value::Int(value)) => Some(i32::from(*value)),
        _ => None,
    }
}
