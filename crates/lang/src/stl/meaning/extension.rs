//! Extension words of self-checking programs. A true assertion is a comparison and a jump; only a false one asks the CPU.

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Callee, Inst, OnFault, Op, Place, Var};
use sieben_engine::machine::Register;
use sieben_engine::machine::registers::STATUS_BITS;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::extension::{ASSERT_BYTES, ASSERTION_FAILED, Compared as Widths, REAL_TOLERANCE, Relation, SLEEP};
use sieben_model::literal::Value;
use sieben_model::types::DataType;

use super::WRONG_OPERAND;
use super::bit_logic::status_scan;
use super::data_blocks::register_of;
use super::load_transfer::{into_accumulator, status_word};
use super::logic_control::{build_pointer, split};
use crate::calling::pointers::CALLER_LOCAL;
use crate::stl::extension::{Compared, Extension, Property};
use crate::stl::lower::Lowering;
use crate::stl::operands::Operand;

/// Status bits that the end of a call changes.
const CHANGED_BY_CALLS: [Register; 4] = [Register::Os, Register::Or, Register::Sta, Register::Fc];
/// Turns a comparison of signed numbers into one of unsigned numbers.
const SIGN: u64 = 0x8000_0000;

/// Writes what an extension word does.
pub(crate) fn lower(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::Extension(extension) = operand else { unreachable!("{WRONG_OPERAND}") };
    match &**extension {
        Extension::Assert { relation, sides: [Compared::Number(left, left_bits), Compared::Number(right, right_bits)] } => {
            let bits = [*left_bits, *right_bits];
            assert_numbers(l, Widths { relation: *relation, bits }, left, right);
        }
        Extension::Assert { relation, sides } => assert_bytes(l, *relation, sides),
        Extension::StatusReset => STATUS_BITS.iter().for_each(|&bit| l.b.set(bit, 0)),
        Extension::Sleep(time) => {
            let time = number(l, time);
            call(l, SLEEP, &[time]);
        }
        Extension::Feature { property, value } => feature(l, *property, *value),
    }
}

/// An operand of at most 32 bits as an unsigned number.
fn number(l: &mut Lowering<'_>, operand: &Operand) -> Var {
    match operand {
        Operand::Memory(access) => l.load(access, OnFault::SkipStatement),
        Operand::Constant(Value::Bool(bit)) => l.b.constant(u64::from(*bit)),
        Operand::Constant(value) => l.b.constant(u64::from(value.accumulator().unwrap_or_else(|| unreachable!("{WRONG_OPERAND}")))),
        Operand::Timer(timer) => {
            let timer = l.number(timer);
            l.b.intrinsic(Intrinsic::TimerValue, &[timer])
        }
        Operand::Counter(counter) => {
            let counter = l.number(counter);
            l.b.intrinsic(Intrinsic::CounterValue, &[counter])
        }
        Operand::Status(scan) => status_scan(l, *scan),
        Operand::StatusWord => status_word(l),
        Operand::DataBlockInfo(info) => register_of(*info).into(),
        Operand::AddressRegister2 => Register::Ar2.into(),
        Operand::Register(register) => (*register).into(),
        Operand::ParameterAddress(index) => {
            let dst = l.b.temporary();
            l.b.push(Inst::Parameter { dst, index: *index });
            dst
        }
        _ => unreachable!("{WRONG_OPERAND}"),
    }
}

fn assert_numbers(l: &mut Lowering<'_>, widths: Widths, left: &Operand, right: &Operand) {
    let left = number(l, left);
    let right = number(l, right);
    let holds = match widths.relation {
        Relation::Equal => l.b.compute(Op::EqI32, &[left, right]),
        Relation::NotEqual => l.b.compute(Op::NeI32, &[left, right]),
        Relation::Less => unsigned(l, Op::LtI32, left, right),
        Relation::Greater => unsigned(l, Op::GtI32, left, right),
        Relation::LessEqual => unsigned(l, Op::LeI32, left, right),
        Relation::GreaterEqual => unsigned(l, Op::GeI32, left, right),
        Relation::EqualReal => {
            // Two infinities of one sign have no difference, but are the same.
            let same = l.b.compute(Op::EqI32, &[left, right]);
            let difference = l.b.compute(Op::SubF32, &[left, right]);
            let difference = l.b.compute(Op::AbsF32, &[difference]);
            let tolerance = l.b.constant(u64::from(REAL_TOLERANCE.to_bits()));
            let near = l.b.compute(Op::LtF32, &[difference, tolerance]);
            l.b.compute(Op::Or, &[same, near])
        }
    };
    // A side may be the status bit that changes now.
    let (left, right) = (l.b.compute(Op::Copy, &[left]), l.b.compute(Op::Copy, &[right]));
    l.b.set(Register::Fc, 0);
    let to = l.b.next();
    l.b.push(Inst::Branch { condition: holds, to });
    let what = l.b.constant(u64::from(widths.to_word()));
    for src in [what, left, right] {
        l.b.push(Inst::PassParameter { src });
    }
    l.b.push(Inst::Call { callee: Callee::Block(ASSERTION_FAILED), parameters: 3 });
}

fn unsigned(l: &mut Lowering<'_>, op: Op, left: Var, right: Var) -> Var {
    let sign = l.b.constant(SIGN);
    let left = l.b.compute(Op::XorU32, &[left, sign]);
    let right = l.b.compute(Op::XorU32, &[right, sign]);
    l.b.compute(op, &[left, right])
}

/// What is longer than 32 bits is compared by the CPU, byte by byte.
fn assert_bytes(l: &mut Lowering<'_>, relation: Relation, sides: &[Compared; 2]) {
    let mut arguments = vec![u32::from(relation.code())];
    for side in sides {
        let (pointer, bytes) = match side {
            Compared::Bytes(location, bytes) => (build_pointer(l, location, &DataType::Void, false), *bytes),
            Compared::Constant(bytes) => (pointer_to(l, bytes), bytes.len() as u32),
            Compared::Number(operand, bits) => {
                let value = number(l, operand);
                let at = l.hidden(4);
                l.b.store(Place::Fixed { area: Area::Local, position: at }, Width::DoubleWord, value);
                let bytes = u32::from(*bits).div_ceil(8);
                (pointer_to_local(l, at + 8 * (4 - bytes)), bytes)
            }
        };
        l.b.release_temporaries();
        arguments.extend([CALLER_LOCAL | pointer, bytes]);
    }
    let arguments: Vec<Var> = arguments.into_iter().map(|value| l.b.constant(u64::from(value))).collect();
    call(l, ASSERT_BYTES, &arguments);
    l.b.set(Register::Fc, 0);
}

/// Stores bytes in hidden local data; the position of a POINTER to them.
fn pointer_to(l: &mut Lowering<'_>, bytes: &[u8]) -> u32 {
    let position = l.hidden(bytes.len() as u32);
    let mut at = position;
    for chunk in bytes.chunks(4) {
        for (part, width) in split(chunk) {
            let value = l.b.constant(u64::from(part));
            l.b.store(Place::Fixed { area: Area::Local, position: at }, width, value);
            l.b.release_temporaries();
            at += width.bits();
        }
    }
    pointer_to_local(l, position)
}

/// A POINTER to a place in the local data; its position.
fn pointer_to_local(l: &mut Lowering<'_>, position: u32) -> u32 {
    let at = l.hidden(6);
    let none = l.b.constant(0);
    l.b.store(Place::Fixed { area: Area::Local, position: at }, Width::Word, none);
    let pointer = l.b.constant(u64::from(CALLER_LOCAL | position));
    l.b.store(Place::Fixed { area: Area::Local, position: at + 16 }, Width::DoubleWord, pointer);
    l.b.release_temporaries();
    at
}

/// Asks the CPU. The status word stays as it was, which the end of a call would change.
fn call(l: &mut Lowering<'_>, callee: BlockId, arguments: &[Var]) {
    let saved = l.hidden(1);
    let place = |index: u32| Place::Fixed { area: Area::Local, position: saved + index };
    for (index, bit) in (0..).zip(CHANGED_BY_CALLS) {
        l.b.store(place(index), Width::Bit, bit);
    }
    for &src in arguments {
        l.b.push(Inst::PassParameter { src });
    }
    let parameters = u16::try_from(arguments.len()).unwrap_or(u16::MAX);
    l.b.push(Inst::Call { callee: Callee::Block(callee), parameters });
    l.b.release_temporaries();
    for (index, bit) in (0..).zip(CHANGED_BY_CALLS) {
        let old = l.b.load(place(index), Width::Bit, OnFault::SkipStatement);
        l.b.copy(bit, old);
    }
}

/// Code is made for one number of accumulators, so that a change is known when the program is compiled.
fn feature(l: &mut Lowering<'_>, property: Property, value: Option<u32>) {
    let value = match (property, value) {
        (Property::Accumulators, Some(accumulators)) => {
            l.accumulators = if accumulators == 4 { 4 } else { 2 };
            u64::from(l.accumulators)
        }
        (Property::Accumulators, None) => u64::from(l.accumulators),
        (Property::StartInformation, value) => u64::from(value.unwrap_or(1)),
    };
    let value = l.b.constant(value);
    into_accumulator(l, value);
}
