//! The column `why` of the instruction table: which kind of reason a row has, and the sentences it can come out as.

use sieben_engine::machine::{Register, TimerKind};
use sieben_model::extension::Relation;

use super::operands::StatusScan;
use crate::coverage::Look;
use crate::sentences::table::Sentence;

/// How a bit is joined with what was there before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Joint {
    /// AND.
    And,
    /// OR.
    Or,
    /// Exclusive OR.
    Xor,
}

impl Joint {
    /// The word in a sentence, in English and German.
    pub(crate) fn words(self) -> [&'static str; 2] {
        match self {
            Self::And => ["AND", "UND"],
            Self::Or => ["OR", "ODER"],
            Self::Xor => ["exclusive OR", "Exklusiv-ODER"],
        }
    }
}

/// Whether a bit is taken as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sense {
    /// As it is.
    Plain,
    /// Inverted.
    Inverted,
}

/// What a number in an accumulator is taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Number {
    /// 16-bit integer in the low word.
    Int,
    /// 32-bit integer.
    Double,
    /// REAL.
    Real,
}

/// A calculation with two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sign {
    /// `+`.
    Add,
    /// `-`.
    Subtract,
    /// `*`.
    Multiply,
    /// `/`.
    Divide,
    /// Remainder.
    Modulo,
}

impl Sign {
    /// The sign between two numbers.
    pub(crate) fn sign(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Modulo => "MOD",
        }
    }
}

/// A way to shift or rotate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Way {
    /// Towards the higher bits.
    Left,
    /// Towards the lower bits.
    Right,
}

impl Way {
    /// The word in a sentence, in English and German.
    pub(crate) fn words(self) -> [&'static str; 2] {
        match self {
            Self::Left => ["left", "links"],
            Self::Right => ["right", "rechts"],
        }
    }
}

/// How a REAL becomes an integer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// To the nearest, halves to the even one.
    Nearest,
    /// To the next greater.
    Up,
    /// To the next smaller.
    Down,
    /// Towards zero.
    Zero,
}

impl Rounding {
    /// The words in a sentence, in English and German.
    pub(crate) fn words(self) -> [&'static str; 2] {
        match self {
            Self::Nearest => ["rounded to the nearest integer", "zur nächsten ganzen Zahl gerundet"],
            Self::Up => ["rounded up", "aufgerundet"],
            Self::Down => ["rounded down", "abgerundet"],
            Self::Zero => ["cut off behind the point", "hinter dem Komma abgeschnitten"],
        }
    }
}

/// The kind of reason of an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Why {
    /// `A`, `ON`, `X` …: a bit is scanned.
    Scan(Joint, Sense),
    /// `O` without operand.
    OrSeparator,
    /// `A(`, `ON(` ….
    Open(Joint, Sense),
    /// `)`.
    Close,
    /// `=`.
    Assign,
    /// `S` of a bit.
    Set,
    /// `R` of a bit.
    Reset,
    /// `NOT`.
    Not,
    /// `SET`, `CLR`.
    ConstantRlo,
    /// `SAVE`.
    Save,
    /// `FP`.
    Rising,
    /// `FN`.
    Falling,
    /// `MCRA`.
    McrActivate,
    /// `MCRD`.
    McrDeactivate,
    /// `MCR(`.
    McrOpen,
    /// `)MCR`.
    McrClose,
    /// `L`.
    Load,
    /// `L STW`.
    LoadStatusWord,
    /// `L DBLG` and its like.
    LoadDataBlockInfo,
    /// `LC`.
    LoadBcd,
    /// `T`.
    Transfer,
    /// `T STW`.
    TransferStatusWord,
    /// `LAR1`, with and without operand.
    LoadPointer(Register),
    /// `TAR1`, with and without operand.
    StorePointer(Register),
    /// `CAR`.
    SwapPointers,
    /// `+AR1`.
    AddPointer(Register),
    /// `TAK`.
    Swap,
    /// `PUSH`.
    Push,
    /// `POP`.
    Pop,
    /// `ENT`.
    Enter,
    /// `LEAVE`.
    Leave,
    /// `CAW`, `CAD`.
    SwapBytes(Number),
    /// `INC`, `DEC`.
    Step(Sign),
    /// `+ 5`, `+ L#5`.
    AddConstant(Number),
    /// `+I`, `/R`, `MOD` ….
    Arithmetic(Number, Sign),
    /// `NEGI`, `NEGD`, `NEGR`.
    Negate(Number),
    /// `INVI`, `INVD`.
    Invert(Number),
    /// A function of a REAL, by its usual name.
    Function(&'static str),
    /// `ABS`.
    Absolute,
    /// `BTI`, `BTD`.
    FromBcd(Number),
    /// `ITB`, `DTB`.
    ToBcd(Number),
    /// `ITD`.
    Widen,
    /// `DTR`.
    ToReal,
    /// `RND` and its like.
    Round(Rounding),
    /// `SLW`, `SRD` …: zeros come in.
    Shift(Number, Way),
    /// `SSI`, `SSD`: the sign comes in.
    ShiftSigned(Number),
    /// `RLD`, `RRD`.
    Rotate(Way),
    /// `RLDA`, `RRDA`.
    RotateThrough(Way),
    /// `AW`, `XOD` ….
    WordLogic(Joint, Number),
    /// `==I`, `<R` ….
    Compare(Number, Relation),
    /// `JU`.
    Jump,
    /// `JC`, `JCB`: if the RLO is 1.
    JumpIfRlo,
    /// `JCN`, `JNB`: if the RLO is 0.
    JumpIfNotRlo,
    /// `JBI`: if BR is 1.
    JumpIfBr,
    /// `JNBI`: if BR is 0.
    JumpIfNotBr,
    /// `JO`.
    JumpIfOverflow,
    /// `JOS`.
    JumpIfStoredOverflow,
    /// `JZ`, `JM` …: by the condition codes.
    JumpIf(StatusScan),
    /// `JL`.
    JumpList,
    /// `LOOP`.
    Loop,
    /// `CALL`.
    Call,
    /// `UC`.
    CallBlock,
    /// `CC`.
    CallIfRlo,
    /// `BE`, `BEU`.
    End,
    /// `BEC`.
    EndIfRlo,
    /// `SP`, `SE`, `SD`, `SS`, `SF`.
    Timer(TimerKind),
    /// `R T`.
    TimerReset,
    /// `FR T`.
    TimerEnable,
    /// `CU`.
    CounterUp,
    /// `CD`.
    CounterDown,
    /// `S C`.
    CounterSet,
    /// `R C`.
    CounterReset,
    /// `FR C`.
    CounterEnable,
    /// `OPN`.
    OpenBlock,
    /// `CDB`.
    SwapDataBlocks,
    /// `NOP`, `BLD`.
    Nothing,
    /// A word of extended programs.
    Extension,
}

impl Why {
    /// What a jump that has a condition looks at: 1 = it is taken.
    pub(crate) fn condition(self) -> Option<Look> {
        Some(match self {
            Self::JumpIfRlo => Look::Set(Register::Rlo),
            Self::JumpIfNotRlo => Look::Clear(Register::Rlo),
            Self::JumpIfBr => Look::Set(Register::Br),
            Self::JumpIfNotBr => Look::Clear(Register::Br),
            Self::JumpIfOverflow => Look::Set(Register::Ov),
            Self::JumpIfStoredOverflow => Look::Set(Register::Os),
            // For CC 1 and CC 0: 00, 01, 10, 11.
            Self::JumpIf(scan) => Look::Conditions(match scan {
                StatusScan::Zero => [true, false, false, false],
                StatusScan::NonZero => [false, true, true, false],
                StatusScan::Positive => [false, false, true, false],
                StatusScan::Negative => [false, true, false, false],
                StatusScan::NotNegative => [true, false, true, false],
                StatusScan::NotPositive => [true, true, false, false],
                _ => [false, false, false, true],
            }),
            Self::Loop => Look::GoesOn,
            _ => return None,
        })
    }

    /// What a statement looks at, if it does one thing or another by it.
    pub(crate) fn looks_at(self) -> Option<Look> {
        match self {
            Self::Assign
            | Self::Set
            | Self::Reset
            | Self::Rising
            | Self::Falling
            | Self::CallIfRlo
            | Self::EndIfRlo
            | Self::McrOpen
            | Self::Timer(_)
            | Self::TimerReset
            | Self::TimerEnable
            | Self::CounterUp
            | Self::CounterDown
            | Self::CounterSet
            | Self::CounterReset
            | Self::CounterEnable
            | Self::JumpIfRlo
            | Self::JumpIfNotRlo => Some(Look::Set(Register::Rlo)),
            Self::JumpList => Some(Look::Entry),
            _ => self.condition(),
        }
    }

    /// The sentences that say why, of which one or a few fit each time; what may stand before them for an address or behind them for
    /// a fault is not among them.
    pub fn forms(self) -> &'static [Sentence] {
        use Sentence as S;
        match self {
            Self::Scan(Joint::And, _) => &[S::ScanFirst, S::AndOne, S::AndBreaks, S::AndZero, S::AndBehindOr],
            Self::Scan(Joint::Or, _) => &[S::ScanFirst, S::OrMakes, S::OrKeeps, S::OrNone],
            Self::Scan(Joint::Xor, _) => &[S::ScanFirst, S::XorDiffers, S::XorEqual],
            Self::OrSeparator => &[S::OrSeparatorOne, S::OrSeparatorZero, S::OrSeparatorEmpty],
            Self::Open(..) => &[S::Open, S::OpenFirst],
            Self::Close => &[S::CloseFirst, S::Close, S::CloseBehindOr],
            Self::Assign => &[S::Assign, S::AssignMcr],
            Self::Set => &[S::SetOne, S::SetNothing, S::SetMcr],
            Self::Reset => &[S::ResetOne, S::SetNothing, S::SetMcr],
            Self::Not => &[S::Not],
            Self::ConstantRlo => &[S::ConstantRlo],
            Self::Save => &[S::Save],
            Self::Rising => &[S::RisingEdge, S::RisingSame, S::RisingLow],
            Self::Falling => &[S::FallingEdge, S::FallingSame, S::FallingHigh],
            Self::McrActivate => &[S::McrActivate],
            Self::McrDeactivate => &[S::McrDeactivate],
            Self::McrOpen => &[S::McrOpenOn, S::McrOpenOff, S::McrNotActive],
            Self::McrClose => &[S::McrClose],
            Self::Load => &[S::LoadMemory, S::LoadConstant, S::LoadTimer, S::LoadCounter, S::LoadRegister],
            Self::LoadStatusWord => &[S::LoadStatusWord],
            Self::LoadDataBlockInfo => &[S::LoadNumber, S::LoadLength, S::LoadNoBlock],
            Self::LoadBcd => &[S::LoadTimerBcd, S::LoadCounterBcd],
            Self::Transfer => &[S::Transfer, S::TransferMcr],
            Self::TransferStatusWord => &[S::TransferStatusWord],
            Self::LoadPointer(_) => &[S::LoadPointer, S::LoadPointerFrom],
            Self::StorePointer(_) => &[S::StorePointer, S::StorePointerTo],
            Self::SwapPointers => &[S::SwapPointers],
            Self::AddPointer(_) => &[S::AddPointer],
            Self::Swap => &[S::Swap],
            Self::Push => &[S::Push],
            Self::Pop => &[S::Pop],
            Self::Enter => &[S::Enter, S::TwoAccumulators],
            Self::Leave => &[S::Leave, S::TwoAccumulators],
            Self::SwapBytes(_) => &[S::SwapBytes],
            Self::Step(_) => &[S::Step],
            Self::AddConstant(_) => &[S::AddConstant],
            Self::Arithmetic(Number::Real, _) => {
                &[S::Calculate, S::Positive, S::Negative, S::Zero, S::RealNone, S::RealInfinite, S::RealTiny]
            }
            Self::Arithmetic(_, Sign::Divide | Sign::Modulo) => {
                &[S::Calculate, S::DivideInt, S::DivideByZero, S::Positive, S::Negative, S::Zero, S::TooLarge]
            }
            Self::Arithmetic(..) => &[S::Calculate, S::Positive, S::Negative, S::Zero, S::TooLarge],
            Self::Negate(_) => &[S::Negate, S::Positive, S::Negative, S::Zero, S::TooLarge],
            Self::Invert(_) => &[S::Invert],
            Self::Function(_) => &[S::Function, S::Positive, S::Negative, S::Zero, S::RealNone, S::RealInfinite, S::RealTiny],
            Self::Absolute => &[S::Function],
            Self::FromBcd(_) => &[S::FromBcd],
            Self::ToBcd(_) => &[S::ToBcd, S::ToBcdTooLarge],
            Self::Widen => &[S::Widen],
            Self::ToReal => &[S::ToReal],
            Self::Round(_) => &[S::Round, S::RoundTooLarge],
            Self::Shift(..) => &[S::Shift, S::ShiftNothing],
            Self::ShiftSigned(_) => &[S::ShiftSigned, S::ShiftNothing],
            Self::Rotate(_) => &[S::Rotate, S::ShiftNothing],
            Self::RotateThrough(_) => &[S::RotateThrough],
            Self::WordLogic(..) => &[S::WordLogicSome, S::WordLogicNone],
            Self::Compare(Number::Real, _) => &[S::CompareTrue, S::CompareFalse, S::CompareNone, S::CompareDifference],
            Self::Compare(..) => &[S::CompareTrue, S::CompareFalse],
            Self::Jump => &[S::Jump],
            Self::JumpIfRlo => &[S::JumpRlo, S::StayRlo],
            Self::JumpIfNotRlo => &[S::JumpRlo, S::StayRlo],
            Self::JumpIfBr | Self::JumpIfNotBr => &[S::JumpBr, S::StayBr],
            Self::JumpIfOverflow => &[S::JumpOv, S::StayOv],
            Self::JumpIfStoredOverflow => &[S::JumpOs, S::StayOs],
            Self::JumpIf(_) => &[S::JumpStatus, S::StayStatus],
            Self::JumpList => &[S::JumpList, S::JumpListBeyond],
            Self::Loop => &[S::LoopAgain, S::LoopEnds],
            Self::Call => &[S::Call, S::CallWith],
            Self::CallBlock => &[S::Call],
            Self::CallIfRlo => &[S::CallRlo, S::CallNot],
            Self::End => &[S::End, S::EndOuter],
            Self::EndIfRlo => &[S::EndRlo, S::EndNot],
            Self::Timer(TimerKind::OffDelay) => &[S::OffDelayRises, S::OffDelayFalls, S::OffDelaySame, S::TimerState],
            Self::Timer(TimerKind::Pulse | TimerKind::OnDelay) => {
                &[S::TimerStarts, S::TimerZero, S::TimerSame, S::TimerStops, S::TimerState]
            }
            Self::Timer(_) => &[S::TimerStarts, S::TimerZero, S::TimerSame, S::TimerGoesOn, S::TimerState],
            Self::TimerReset => &[S::ResetOne0, S::ResetNothing],
            Self::TimerEnable => &[S::TimerEnable, S::EnableNothing, S::EnableState],
            Self::CounterUp => &[S::Counts, S::CountsTop, S::CountSame, S::CountLow, S::CountState],
            Self::CounterDown => &[S::Counts, S::CountsBottom, S::CountSame, S::CountLow, S::CountState],
            Self::CounterSet => &[S::CounterSet, S::CountSame, S::CountLow, S::CountState],
            Self::CounterReset => &[S::ResetOne0, S::ResetNothing],
            Self::CounterEnable => &[S::CounterEnable, S::EnableNothing, S::EnableState],
            Self::OpenBlock => &[S::OpenBlock, S::CloseBlock],
            Self::SwapDataBlocks => &[S::SwapDataBlocks],
            Self::Nothing => &[S::Nothing],
            Self::Extension => &[S::AssertHolds, S::StatusReset, S::Sleep, S::Feature],
        }
    }
}
