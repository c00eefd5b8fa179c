//! Which operation of the engine an operator or a conversion is for each kind of number.

use sieben_engine::ir::Op;

use crate::st::tree::{Scalar, Value, ValueKind};

/// What is computed with numbers, bit strings and BOOLs, whatever it is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)] // The names say it.
pub enum Operation {
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    /// The base to the power of an exponent of the same type.
    Power,
    Negate,
    Absolute,
    Minimum,
    Maximum,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    Xor,
    Not,
    /// The second operand is a count from 0 to 255 ([`Op::ShiftCount`]).
    ShiftLeft,
    /// Zeros come in from the left, or copies of the sign where the type has one.
    ShiftRight,
    RotateLeft,
    RotateRight,
    SquareRoot,
    Exponential,
    /// 10 to the power of the operand.
    TenToThe,
    NaturalLogarithm,
    /// To base 10.
    Logarithm,
    Sine,
    Cosine,
    Tangent,
    ArcSine,
    ArcCosine,
    ArcTangent,
    /// Of a point: first y, then x.
    ArcTangent2,
}

/// The columns of the table below, in this order.
const COLUMNS: [Scalar; 11] = [
    Scalar::Bool,
    Scalar::U8,
    Scalar::U16,
    Scalar::U32,
    Scalar::U64,
    Scalar::I8,
    Scalar::I16,
    Scalar::I32,
    Scalar::I64,
    Scalar::F32,
    Scalar::F64,
];

macro_rules! table {
    ($( $Operation:ident: [$($op:tt)*]; )*) => {
        fn row(operation: Operation) -> [Option<Op>; 11] {
            match operation { $( Operation::$Operation => [$(table!(@ $op)),*], )* }
        }
    };
    (@ -) => { None };
    (@ $op:ident) => { Some(Op::$op) };
}

#[rustfmt::skip] // A table.
table! {
    //           Bool U8 U16 U32 U64 I8 I16 I32 I64 F32 F64
    Add:              [- AddU8 AddU16 AddU32 AddU64 AddU8 AddU16 AddU32 AddU64 AddF32 AddF64];
    Subtract:         [- SubU8 SubU16 SubU32 SubU64 SubU8 SubU16 SubU32 SubU64 SubF32 SubF64];
    Multiply:         [- MulU8 MulU16 MulU32 MulU64 MulU8 MulU16 MulU32 MulU64 MulF32 MulF64];
    Divide:           [- DivU64 DivU64 DivU64 DivU64 DivI8 DivI16 DivI32 DivI64 DivF32 DivF64];
    Modulo:           [- RemU64 RemU64 RemU64 RemU64 RemI8 RemI16 RemI32 RemI64 - -];
    Power:            [- - - - - - - - - PowF32 PowF64];
    Negate:           [- NegI8 NegI16 NegI32 NegI64 NegI8 NegI16 NegI32 NegI64 NegF32 NegF64];
    Absolute:         [- Copy Copy Copy Copy AbsI8 AbsI16 AbsI32 AbsI64 AbsF32 AbsF64];
    Minimum:          [And MinU64 MinU64 MinU64 MinU64 MinI8 MinI16 MinI32 MinI64 MinF32 MinF64];
    Maximum:          [Or MaxU64 MaxU64 MaxU64 MaxU64 MaxI8 MaxI16 MaxI32 MaxI64 MaxF32 MaxF64];
    Less:             [Below Below Below Below Below LtI8 LtI16 LtI32 LtI64 LtF32 LtF64];
    LessEqual:        [LeU64 LeU64 LeU64 LeU64 LeU64 LeI8 LeI16 LeI32 LeI64 LeF32 LeF64];
    Greater:          [GtU64 GtU64 GtU64 GtU64 GtU64 GtI8 GtI16 GtI32 GtI64 GtF32 GtF64];
    GreaterEqual:     [GeU64 GeU64 GeU64 GeU64 GeU64 GeI8 GeI16 GeI32 GeI64 GeF32 GeF64];
    Equal:            [Equal Equal Equal Equal Equal Equal Equal Equal Equal EqF32 EqF64];
    NotEqual:         [Differ Differ Differ Differ Differ Differ Differ Differ Differ DifferF32 DifferF64];
    And:              [And AndU64 AndU64 AndU64 AndU64 AndU64 AndU64 AndU64 AndU64 - -];
    Or:               [Or OrU64 OrU64 OrU64 OrU64 OrU64 OrU64 OrU64 OrU64 - -];
    Xor:              [Xor XorU64 XorU64 XorU64 XorU64 XorU64 XorU64 XorU64 XorU64 - -];
    Not:              [Not NotU8 NotU16 NotU32 NotU64 NotU8 NotU16 NotU32 NotU64 - -];
    ShiftLeft:        [- Shl8 Shl16 Shl32 Shl64 Shl8 Shl16 Shl32 Shl64 - -];
    ShiftRight:       [- Shr8 Shr16 Shr32 Shr64 Sar8 Sar16 Sar32 Sar64 - -];
    RotateLeft:       [- Rol8 Rol16 Rol32 Rol64 Rol8 Rol16 Rol32 Rol64 - -];
    RotateRight:      [- Ror8 Ror16 Ror32 Ror64 Ror8 Ror16 Ror32 Ror64 - -];
    SquareRoot:       [- - - - - - - - - SqrtF32 SqrtF64];
    Exponential:      [- - - - - - - - - ExpF32 ExpF64];
    TenToThe:         [- - - - - - - - - Exp10F32 Exp10F64];
    NaturalLogarithm: [- - - - - - - - - LogF32 LogF64];
    Logarithm:        [- - - - - - - - - Log10F32 Log10F64];
    Sine:             [- - - - - - - - - SinF32 SinF64];
    Cosine:           [- - - - - - - - - CosF32 CosF64];
    Tangent:          [- - - - - - - - - TanF32 TanF64];
    ArcSine:          [- - - - - - - - - AsinF32 AsinF64];
    ArcCosine:        [- - - - - - - - - AcosF32 AcosF64];
    ArcTangent:       [- - - - - - - - - AtanF32 AtanF64];
    ArcTangent2:      [- - - - - - - - - Atan2F32 Atan2F64];
}

/// The operation of the engine that does this with operands of one kind; `None` where there is none (`MOD` of REALs). Results have the
/// kind of the operands, those of comparisons are BOOL. Integers wrap; a quotient or rest by 0 is 0.
pub fn op_for(operation: Operation, scalar: Scalar) -> Option<Op> {
    let column = COLUMNS.iter().position(|&column| column == scalar)?;
    row(operation)[column]
}

/// Whether the operation compares: its result is BOOL.
pub fn compares(operation: Operation) -> bool {
    use Operation as O;
    matches!(operation, O::Less | O::LessEqual | O::Greater | O::GreaterEqual | O::Equal | O::NotEqual)
}

/// Whether a result was lost: an operation that takes the same operands and is true if the result did not fit, or the divisor was 0.
/// `None` where that cannot be (also for REAL: [`lost_real`] looks at the result).
#[rustfmt::skip] // A table.
pub fn failed_op(operation: Operation, scalar: Scalar) -> Option<Op> {
    use {Operation as O, Scalar as S};
    Some(match (operation, scalar) {
        (O::Add, S::I8) => Op::AddOverflowsI8,
        (O::Add, S::I16) => Op::AddOverflowsI16,
        (O::Add, S::I32) => Op::AddOverflowsI32,
        (O::Add, S::I64) => Op::AddOverflowsI64,
        (O::Add, S::U8) => Op::AddOverflowsU8,
        (O::Add, S::U16) => Op::AddOverflowsU16,
        (O::Add, S::U32) => Op::AddOverflowsU32,
        (O::Add, S::U64) => Op::AddOverflowsU64,
        (O::Subtract, S::I8) => Op::SubOverflowsI8,
        (O::Subtract, S::I16) => Op::SubOverflowsI16,
        (O::Subtract, S::I32) => Op::SubOverflowsI32,
        (O::Subtract, S::I64) => Op::SubOverflowsI64,
        (O::Subtract, S::U8) => Op::SubOverflowsU8,
        (O::Subtract, S::U16) => Op::SubOverflowsU16,
        (O::Subtract, S::U32) => Op::SubOverflowsU32,
        (O::Subtract, S::U64) => Op::SubOverflowsU64,
        (O::Multiply, S::I8) => Op::MulOverflowsI8,
        (O::Multiply, S::I16) => Op::MulOverflowsI16,
        (O::Multiply, S::I32) => Op::MulOverflowsI32,
        (O::Multiply, S::I64) => Op::MulOverflowsI64,
        (O::Multiply, S::U8) => Op::MulOverflowsU8,
        (O::Multiply, S::U16) => Op::MulOverflowsU16,
        (O::Multiply, S::U32) => Op::MulOverflowsU32,
        (O::Multiply, S::U64) => Op::MulOverflowsU64,
        (O::Divide, S::I8) => Op::DivFailsI8,
        (O::Divide, S::I16) => Op::DivFailsI16,
        (O::Divide, S::I32) => Op::DivFailsI32,
        (O::Divide, S::I64) => Op::DivFailsI64,
        (O::Negate | O::Absolute, S::I8) => Op::NegOverflowsI8,
        (O::Negate | O::Absolute, S::I16) => Op::NegOverflowsI16,
        (O::Negate | O::Absolute, S::I32) => Op::NegOverflowsI32,
        (O::Negate | O::Absolute, S::I64) => Op::NegOverflowsI64,
        (O::Divide, S::U8 | S::U16 | S::U32 | S::U64) | (O::Modulo, _) => Op::DivisorIsZero,
        _ => return None,
    })
}

/// Whether an operation of [`failed_op`] asks for a division by 0, or a quotient that does not fit.
pub fn fails_of_division(failed: Op) -> bool {
    matches!(failed, Op::DivFailsI8 | Op::DivFailsI16 | Op::DivFailsI32 | Op::DivFailsI64 | Op::DivisorIsZero)
}

/// Whether a division may fail, by its divisor: a constant that is neither 0 nor -1 always divides.
pub fn may_divide_wrong(failed: Op, divisor: &Value) -> bool {
    let ValueKind::Constant(bits) = divisor.kind else { return true };
    let all = u64::MAX >> (64 - divisor.scalar.bits().clamp(1, 64));
    bits & all == 0 || failed != Op::DivisorIsZero && bits & all == all
}

/// Whether the result of a computation with REAL or LREAL, its operand, is infinite or no number.
pub fn lost_real(scalar: Scalar) -> Option<Op> {
    match scalar {
        Scalar::F32 => Some(Op::OverflowsF32),
        Scalar::F64 => Some(Op::OverflowsF64),
        _ => None,
    }
}

/// How a REAL becomes an integer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest one, halves to the even one: 2.5 → 2.
    HalfEven,
    /// To the nearest one, halves away from 0: 2.5 → 3.
    HalfAway,
    /// Towards 0.
    Zero,
    /// Up.
    Up,
    /// Down.
    Down,
}

impl Rounding {
    fn op(self) -> Op {
        match self {
            Self::HalfEven => Op::RoundF64,
            Self::HalfAway => Op::RoundAwayF64,
            Self::Zero => Op::TruncF64,
            Self::Up => Op::CeilF64,
            Self::Down => Op::FloorF64,
        }
    }
}

/// What a REAL beyond the integers of a type becomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// The nearest integer of the type; 0 for what is no number.
    Nearest,
    /// The low bits of the integer with 64 bits.
    LowBits,
}

/// Steps that make a number of one kind one of another, each an operation with one operand. Integers keep their low bits, a BOOL counts
/// as 0 or 1 and is made of the lowest bit; REAL and LREAL keep the value as well as they can.
pub fn convert(from: Scalar, to: Scalar, rounding: Rounding, beyond: Beyond) -> Vec<Op> {
    use Scalar as S;
    if from == to {
        return Vec::new();
    }
    match (from, to) {
        (S::F32, S::F64) => vec![Op::F32ToF64],
        (S::F64, S::F32) => vec![Op::F64ToF32],
        (S::F32 | S::F64, _) => {
            let mut steps = if from == S::F32 { vec![Op::F32ToF64] } else { Vec::new() };
            steps.push(rounding.op());
            match beyond {
                Beyond::Nearest if to != S::Bool => steps.push(from_f64(to)),
                _ => {
                    steps.push(Op::F64ToI64);
                    steps.extend(resize(S::I64, to));
                }
            }
            steps
        }
        (_, S::F32 | S::F64) => {
            // All unsigned numbers stand zero-extended in 64 bits.
            let signed = is_signed(from);
            let mut steps = if signed { resize(from, S::I64) } else { Vec::new() };
            steps.push(match (signed, to) {
                (true, S::F32) => Op::I64ToF32,
                (true, _) => Op::I64ToF64,
                (false, S::F32) => Op::U64ToF32,
                (false, _) => Op::U64ToF64,
            });
            steps
        }
        _ => resize(from, to),
    }
}

/// Whether an integer type has a sign.
pub fn is_signed(scalar: Scalar) -> bool {
    matches!(scalar, Scalar::I8 | Scalar::I16 | Scalar::I32 | Scalar::I64)
}

/// Whether the kind is REAL or LREAL.
pub fn is_real(scalar: Scalar) -> bool {
    matches!(scalar, Scalar::F32 | Scalar::F64)
}

fn from_f64(to: Scalar) -> Op {
    match to {
        Scalar::U8 => Op::F64ToU8,
        Scalar::U16 => Op::F64ToU16,
        Scalar::U32 => Op::F64ToU32,
        Scalar::U64 => Op::F64ToU64,
        Scalar::I8 => Op::F64ToI8,
        Scalar::I16 => Op::F64ToI16,
        Scalar::I32 => Op::F64ToI32,
        _ => Op::F64ToI64,
    }
}

/// An integer with more or fewer bits: extended by its sign if it has one, or cut.
fn resize(from: Scalar, to: Scalar) -> Vec<Op> {
    let (old, new) = (from.bits(), to.bits());
    if new > old && is_signed(from) {
        return vec![match (old, new) {
            (8, 16) => Op::ExtendI8I16,
            (8, 32) => Op::ExtendI8I32,
            (8, _) => Op::ExtendI8I64,
            (16, 32) => Op::Extend16,
            (16, _) => Op::ExtendI16I64,
            _ => Op::ExtendI32I64,
        }];
    }
    if new >= old {
        return Vec::new();
    }
    match new {
        1 => vec![Op::LowestBit],
        8 => vec![Op::Low8],
        16 => vec![Op::Low16],
        _ => vec![Op::Low32],
    }
}

/// The smallest and the greatest number of an integer kind; 0 and 1 of BOOL.
pub fn limits(scalar: Scalar) -> (i128, i128) {
    match scalar {
        Scalar::Bool => (0, 1),
        Scalar::F32 | Scalar::F64 => (i128::MIN, i128::MAX),
        _ if is_signed(scalar) => (-(1 << (scalar.bits() - 1)), (1 << (scalar.bits() - 1)) - 1),
        _ => (0, (1 << scalar.bits()) - 1),
    }
}

/// How to find out whether a number does not fit another kind: `steps` one after the other on the number, then `failed` of that with
/// `operands` behind it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RangeCheck {
    /// Operations with one operand.
    pub steps: Vec<Op>,
    /// True if the number does not fit.
    pub failed: Op,
    /// Its further operands.
    pub operands: Vec<u64>,
}

/// How to find out whether a conversion loses the number; `None` if it never does. REALs are looked at as they are rounded.
pub fn range_check(from: Scalar, to: Scalar, rounding: Rounding) -> Option<RangeCheck> {
    if is_real(to) {
        return (from == Scalar::F64 && to == Scalar::F32).then(|| RangeCheck {
            steps: vec![Op::F64ToF32],
            failed: Op::OverflowsF32,
            operands: Vec::new(),
        });
    }
    let (least, most) = limits(to);
    if is_real(from) {
        let mut steps = if from == Scalar::F32 { vec![Op::F32ToF64] } else { Vec::new() };
        steps.push(rounding.op());
        // The greatest integers of 64 bits are no LREALs: these are the greatest that fit.
        let most = match to {
            Scalar::I64 => 9_223_372_036_854_774_784.0,
            Scalar::U64 => 18_446_744_073_709_549_568.0,
            _ => most as f64,
        };
        return Some(RangeCheck { steps, failed: Op::OutsideF64, operands: vec![(least as f64).to_bits(), most.to_bits()] });
    }
    let (from_least, from_most) = limits(from);
    if from_least >= least && from_most <= most {
        return None;
    }
    if !is_signed(from) {
        return Some(RangeCheck { steps: Vec::new(), failed: Op::GtU64, operands: vec![most as u64] });
    }
    let most = most.min(i128::from(i64::MAX)) as i64;
    Some(RangeCheck { steps: resize(from, Scalar::I64), failed: Op::OutsideI64, operands: vec![least as i64 as u64, most as u64] })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The word of a number of a kind.
    fn word(value: f64, scalar: Scalar) -> u64 {
        match scalar {
            Scalar::F32 => u64::from((value as f32).to_bits()),
            Scalar::F64 => value.to_bits(),
            _ => (value as i128 as u64) & (u64::MAX >> (64 - scalar.bits())),
        }
    }

    fn number(word: u64, scalar: Scalar) -> f64 {
        match scalar {
            Scalar::F32 => f64::from(f32::from_bits(word as u32)),
            Scalar::F64 => f64::from_bits(word),
            _ if is_signed(scalar) => ((word << (64 - scalar.bits())) as i64 >> (64 - scalar.bits())) as f64,
            _ => word as f64,
        }
    }

    fn run(steps: &[Op], value: u64) -> u64 {
        steps.iter().fold(value, |value, op| op.eval([value, 0, 0, 0]))
    }

    #[test]
    fn a_conversion_keeps_what_its_range_check_lets_through() {
        let numbers = [
            0.0,
            1.0,
            -1.0,
            100.0,
            -100.0,
            127.0,
            128.0,
            -128.0,
            -129.0,
            255.0,
            256.0,
            32767.0,
            32768.0,
            -32768.0,
            -32769.0,
            65535.0,
            65536.0,
            2147483647.0,
            2147483648.0,
            -2147483648.0,
            -2147483649.0,
            4294967295.0,
            4294967296.0,
            9.2e18,
            9.3e18,
            -9.3e18,
            1.8e19,
            1.9e19,
            1.0e30,
        ];
        let mut fitting = 0;
        for from in COLUMNS {
            let (least, most) = limits(from);
            for value in numbers.into_iter().filter(|&value| (least as f64..=most as f64).contains(&value)) {
                let value = word(value, from);
                for to in COLUMNS.into_iter().filter(|&to| to != Scalar::Bool) {
                    let failed = range_check(from, to, Rounding::HalfEven).is_some_and(|check| {
                        let mut args = [run(&check.steps, value), 0, 0, 0];
                        args[1..=check.operands.len()].copy_from_slice(&check.operands);
                        check.failed.eval(args) != 0
                    });
                    let result = run(&convert(from, to, Rounding::HalfEven, Beyond::Nearest), value);
                    let (old, new) = (number(value, from), number(result, to));
                    // REAL has 24 bits: what is beyond is near, not equal.
                    let kept = old == new || is_real(to) && (old - new).abs() <= old.abs() * 1.0e-7;
                    assert_eq!(kept, !failed, "{from:?} {old} to {to:?} {new}");
                    fitting += u32::from(kept);
                }
            }
        }
        assert!(fitting > 500, "{fitting}");
    }

    #[test]
    fn halves_are_rounded_as_asked() {
        let rounded = |value: f32, rounding| {
            number(run(&convert(Scalar::F32, Scalar::I16, rounding, Beyond::Nearest), u64::from(value.to_bits())), Scalar::I16)
        };
        use Rounding as R;
        assert_eq!([2.5, 3.5, -2.5].map(|value| rounded(value, R::HalfEven)), [2.0, 4.0, -2.0]);
        assert_eq!([2.5, 3.5, -2.5].map(|value| rounded(value, R::HalfAway)), [3.0, 4.0, -3.0]);
        assert_eq!([2.5, -2.5].map(|value| rounded(value, R::Zero)), [2.0, -2.0]);
        assert_eq!([2.5, -2.5].map(|value| rounded(value, R::Up)), [3.0, -2.0]);
        assert_eq!([2.5, -2.5].map(|value| rounded(value, R::Down)), [2.0, -3.0]);
        assert_eq!([1.0e6, -1.0e6, f32::NAN].map(|value| rounded(value, R::Zero)), [32767.0, -32768.0, 0.0]);
        let cut = run(&convert(Scalar::F32, Scalar::I16, R::Zero, Beyond::LowBits), u64::from(1.0e6_f32.to_bits()));
        assert_eq!(cut, 16960);
    }

    #[test]
    fn what_can_fail_takes_the_operands_of_what_it_belongs_to() {
        use Operation as O;
        for operation in [O::Add, O::Subtract, O::Multiply, O::Divide, O::Modulo, O::Negate, O::Absolute] {
            for scalar in COLUMNS {
                if let (Some(op), Some(failed)) = (op_for(operation, scalar), failed_op(operation, scalar)) {
                    assert_eq!(op.arity(), failed.arity(), "{operation:?} {scalar:?}");
                }
            }
        }
        assert_eq!(failed_op(O::Add, Scalar::I16), Some(Op::AddOverflowsI16));
    }
}
