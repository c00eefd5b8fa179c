//! Block calls and block ends.

use sieben_engine::ir::{Callee, DataRegister, Inst, OnFault, Op, Place, Var};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};
use sieben_model::interface::Section;
use sieben_model::literal::Value;
use sieben_model::types::DataType;

use super::WRONG_OPERAND;
use crate::calling::pointers::{
    ADDRESS_MASK, ANY_BYTES, ANY_OF_S7, ANY_PARTS, AREA_SHIFT, CALLER_LOCAL, IN_DATA_BLOCK, POINTER_BYTES, any_type, bytes_of,
};
use crate::calling::registers::{INSTANCE_START, REGISTER_PAIRS};
use crate::declarations::interface::is_complex;
use crate::declarations::values::write;
use crate::stl::lower::Lowering;
use crate::stl::operands::{Access, Actual, BlockOperand, Call, CallInstance, CallParameter, Location, NumberOperand, Operand};

/// `UC`.
pub(crate) fn unconditional(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::Block(block) = operand else { unreachable!("{WRONG_OPERAND}") };
    let callee = callee(l, block);
    l.b.push(Inst::Call { callee, parameters: 0 });
}

/// `CC`: the status changes, called or not.
pub(crate) fn conditional(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::Block(block) = operand else { unreachable!("{WRONG_OPERAND}") };
    let callee = callee(l, block);
    let skip = l.b.compute(Op::Not, &[Register::Rlo.into()]);
    l.b.set(Register::Os, 0);
    l.b.set(Register::Or, 0);
    l.b.set(Register::Sta, 1);
    l.b.set(Register::Rlo, 1);
    l.b.set(Register::Fc, 0);
    let to = l.b.next();
    l.b.push(Inst::Branch { condition: skip, to });
    l.b.push(Inst::Call { callee, parameters: 0 });
}

fn callee(l: &mut Lowering<'_>, block: &BlockOperand) -> Callee {
    match block.number {
        NumberOperand::Fixed(number) => Callee::Block(sieben_model::block::BlockId::new(block.kind, number)),
        _ => Callee::Number(block.kind, l.number(&block.number)),
    }
}

/// `BEC`: the status of a taken block end is that of the return.
pub(crate) fn block_end_conditional(l: &mut Lowering<'_>) {
    let end = l.end();
    l.b.push(Inst::Branch { condition: Register::Rlo.into(), to: end });
    l.b.set(Register::Or, 0);
    l.b.set(Register::Sta, 1);
    l.b.set(Register::Rlo, 1);
    l.b.set(Register::Fc, 0);
}

/// `CALL`.
pub(crate) fn call(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::Call(call) = operand else { unreachable!("{WRONG_OPERAND}") };
    match call.instance {
        None => call_function(l, call),
        Some(CallInstance::DataBlock(db)) => call_with_instance(l, call, db),
        Some(CallInstance::Multi(position)) => call_multi_instance(l, call, position),
    }
}

/// What a function receives for one parameter.
enum Pass {
    /// A pointer or number that is known.
    Known(u32),
    /// A number that lies in the hidden local data, as a word.
    Hidden(u32),
}

/// A function gets a pointer per parameter. What lies in I, Q, M, the peripheral or the local data is passed by
/// reference; everything else goes through hidden local data of the caller, before and (outputs) after the call.
fn call_function(l: &mut Lowering<'_>, call: &Call) {
    let mut passed = Vec::with_capacity(call.parameters.len());
    let mut copies_back: Vec<(u32, &Access)> = Vec::new();
    for parameter in &call.parameters {
        let pass = match &parameter.actual {
            None => Pass::Known(0),
            Some(Actual::Memory(access)) => match direct_pointer(&access.location) {
                Some(pointer) => Pass::Known(pointer),
                None => {
                    let hidden = l.hidden(access.width.bytes());
                    if reads(parameter) {
                        copy(l, access, &local(hidden, access.width));
                    }
                    if writes(parameter) {
                        copies_back.push((hidden, access));
                    }
                    Pass::Known(CALLER_LOCAL | hidden)
                }
            },
            Some(Actual::Constant(value)) => {
                let hidden = store_constant(l, value, &parameter.data_type);
                let passed = match is_complex(&parameter.data_type) {
                    true => build_pointer(l, &Location::Fixed { area: Area::Local, position: hidden }, &parameter.data_type, false),
                    false => hidden,
                };
                Pass::Known(CALLER_LOCAL | passed)
            }
            Some(Actual::Timer(number) | Actual::Counter(number) | Actual::Block(number)) => match number {
                NumberOperand::Fixed(number) => Pass::Known(u32::from(*number)),
                other => {
                    let number = l.number(other);
                    let hidden = l.hidden(2);
                    l.b.store(Place::Fixed { area: Area::Local, position: hidden }, Width::Word, number);
                    Pass::Hidden(hidden)
                }
            },
            Some(Actual::Complex { location, data_type }) => {
                let hidden = match ready_any(l, parameter, location, data_type) {
                    Some(ready) => ready,
                    None => build_pointer(l, location, data_type, parameter.data_type == DataType::Any),
                };
                Pass::Known(CALLER_LOCAL | hidden)
            }
        };
        l.b.release_temporaries();
        passed.push(pass);
    }
    for pass in &passed {
        let src = match pass {
            Pass::Known(pointer) => l.b.constant(u64::from(*pointer)),
            Pass::Hidden(position) => {
                l.b.load(Place::Fixed { area: Area::Local, position: *position }, Width::Word, OnFault::SkipStatement)
            }
        };
        l.b.push(Inst::PassParameter { src });
        l.b.release_temporaries();
    }
    let parameters = u16::try_from(passed.len()).unwrap_or(u16::MAX);
    l.b.push(Inst::Call { callee: Callee::Block(call.callee), parameters });
    for (hidden, access) in copies_back {
        copy(l, &local(hidden, access.width), access);
    }
}

/// The macro of `CALL FB n, DB m`: CDB, OPN DI m, write the inputs, AR2 := P#DBX 0.0, UC FB n, AR2 back, read the outputs,
/// CDB. The called block finds the caller's instance in the DB register; behind the call that register holds DB m.
fn call_with_instance(l: &mut Lowering<'_>, call: &Call, db: u16) {
    // What depends on the caller's own DB, DI or parameters is fetched before DI changes.
    let mut prepared = Vec::with_capacity(call.parameters.len());
    for parameter in &call.parameters {
        prepared.push(prepare(l, parameter));
        l.b.release_temporaries();
    }
    let saved_ar2 = l.hidden(4);
    l.b.store(Place::Fixed { area: Area::Local, position: saved_ar2 }, Width::DoubleWord, Register::Ar2);
    let number = l.b.constant(u64::from(db));
    let old: Vec<Var> = REGISTER_PAIRS.iter().map(|&(_, instance)| l.b.compute(Op::Copy, &[instance.into()])).collect();
    l.b.push(Inst::Open { register: DataRegister::Instance, number });
    for (&(shared, _), old) in REGISTER_PAIRS.iter().zip(old) {
        l.b.copy(shared, old);
    }
    l.b.release_temporaries();
    let instance = |position| Location::Fixed { area: Area::InstanceData, position };
    for (parameter, prepared) in call.parameters.iter().zip(&prepared) {
        write_input(l, parameter, prepared.as_ref(), &instance);
    }
    l.b.set(Register::Ar2, INSTANCE_START);
    l.b.push(Inst::Call { callee: Callee::Block(call.callee), parameters: 0 });
    let ar2 = l.b.load(Place::Fixed { area: Area::Local, position: saved_ar2 }, Width::DoubleWord, OnFault::SkipStatement);
    l.b.copy(Register::Ar2, ar2);
    l.b.release_temporaries();
    let mut dependent = Vec::new();
    for parameter in call.parameters.iter().filter(|parameter| writes(parameter)) {
        let (Some(actual), from) = (&parameter.actual, instance(parameter.position)) else { continue };
        match actual {
            Actual::Memory(access) if direct_pointer(&access.location).is_some() => {
                copy(l, &Access { width: access.width, location: from }, access);
            }
            Actual::Memory(access) => {
                let hidden = l.hidden(access.width.bytes());
                copy(l, &Access { width: access.width, location: from }, &local(hidden, access.width));
                dependent.push((hidden, parameter));
            }
            Actual::Complex { data_type, .. } if parameter.section == Section::Output => {
                let bytes = bytes_of(data_type);
                let hidden = l.hidden(bytes);
                copy_bytes(l, &from, &Location::Fixed { area: Area::Local, position: hidden }, bytes);
                dependent.push((hidden, parameter));
            }
            _ => {}
        }
    }
    super::data_blocks::swap(l);
    l.b.release_temporaries();
    if dependent.is_empty() {
        return;
    }
    for (hidden, parameter) in dependent {
        match &parameter.actual {
            Some(Actual::Memory(access)) => copy(l, &local(hidden, access.width), access),
            Some(Actual::Complex { location, data_type }) => {
                copy_bytes(l, &Location::Fixed { area: Area::Local, position: hidden }, location, bytes_of(data_type));
            }
            _ => {}
        }
    }
    let number = l.b.constant(u64::from(db));
    l.b.push(Inst::Open { register: DataRegister::Shared, number });
    l.b.release_temporaries();
}

/// The macro of `CALL #instance`: the DB register gets the instance data block as well, write the inputs, AR2 moved to the part of the
/// called block, UC FB n, AR2 back, read the outputs, TDB. Inside DB and DI are the instance; behind the call DB is.
fn call_multi_instance(l: &mut Lowering<'_>, call: &Call, position: u32) {
    let part = |inner: u32| Location::Instance { position: position + inner };
    // What depends on the caller's own DB is fetched before DB changes.
    let mut prepared = Vec::with_capacity(call.parameters.len());
    for parameter in &call.parameters {
        prepared.push(prepare(l, parameter));
        l.b.release_temporaries();
    }
    share_instance(l);
    for (parameter, prepared) in call.parameters.iter().zip(&prepared) {
        write_input(l, parameter, prepared.as_ref(), &part);
    }
    let saved_ar2 = l.hidden(4);
    l.b.store(Place::Fixed { area: Area::Local, position: saved_ar2 }, Width::DoubleWord, Register::Ar2);
    let offset = l.b.constant(u64::from(position));
    l.b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), offset]);
    l.b.release_temporaries();
    l.b.push(Inst::Call { callee: Callee::Block(call.callee), parameters: 0 });
    let ar2 = l.b.load(Place::Fixed { area: Area::Local, position: saved_ar2 }, Width::DoubleWord, OnFault::SkipStatement);
    l.b.copy(Register::Ar2, ar2);
    l.b.release_temporaries();
    let mut opened = false;
    for parameter in call.parameters.iter().filter(|parameter| writes(parameter)) {
        match &parameter.actual {
            Some(Actual::Memory(access)) => {
                copy(l, &Access { width: access.width, location: part(parameter.position) }, access);
                opened |= direct_pointer(&access.location).is_none();
            }
            Some(Actual::Complex { location, data_type }) if parameter.section == Section::Output => {
                copy_bytes(l, &part(parameter.position), location, bytes_of(data_type));
                opened |= direct_pointer(location).is_none();
            }
            _ => {}
        }
    }
    if opened {
        share_instance(l);
    }
}

/// The data block of the DI register in the DB register as well.
fn share_instance(l: &mut Lowering<'_>) {
    for (shared, instance) in REGISTER_PAIRS {
        l.b.copy(shared, instance);
    }
}

/// What was fetched for an input of a function block before DI changed: its place in the hidden local data.
struct Prepared {
    position: u32,
    bytes: u32,
    width: Option<Width>,
}

fn prepare(l: &mut Lowering<'_>, parameter: &CallParameter) -> Option<Prepared> {
    match parameter.actual.as_ref()? {
        Actual::Memory(access) if reads(parameter) && direct_pointer(&access.location).is_none() => {
            let position = l.hidden(access.width.bytes());
            copy(l, access, &local(position, access.width));
            Some(Prepared { position, bytes: access.width.bytes(), width: Some(access.width) })
        }
        Actual::Timer(number) | Actual::Counter(number) | Actual::Block(number) => {
            let number = l.number(number);
            let position = l.hidden(2);
            l.b.store(Place::Fixed { area: Area::Local, position }, Width::Word, number);
            Some(Prepared { position, bytes: 2, width: Some(Width::Word) })
        }
        Actual::Constant(value) if reads(parameter) => {
            let position = store_constant(l, value, &parameter.data_type);
            let width = elementary_width(&parameter.data_type);
            Some(Prepared { position, bytes: bytes_of(&parameter.data_type), width })
        }
        Actual::Complex { location, data_type } => {
            let by_value = parameter.section == Section::Input && !matches!(parameter.data_type, DataType::Any | DataType::Pointer);
            if by_value {
                let bytes = bytes_of(&parameter.data_type);
                let position = l.hidden(bytes);
                copy_bytes(l, location, &Location::Fixed { area: Area::Local, position }, bytes);
                Some(Prepared { position, bytes, width: None })
            } else if parameter.section == Section::Output {
                None
            } else {
                let any = parameter.data_type == DataType::Any;
                let position = match ready_any(l, parameter, location, data_type) {
                    Some(ready) => ready,
                    None => build_pointer(l, location, data_type, any),
                };
                Some(Prepared { position, bytes: if any { ANY_BYTES } else { POINTER_BYTES }, width: None })
            }
        }
        _ => None,
    }
}

/// Writes an input or in-out parameter into the instance.
fn write_input(l: &mut Lowering<'_>, parameter: &CallParameter, prepared: Option<&Prepared>, instance: &dyn Fn(u32) -> Location) {
    let to = instance(parameter.position);
    match (prepared, &parameter.actual) {
        (Some(Prepared { position, width: Some(width), .. }), _) => {
            copy(l, &local(*position, *width), &Access { width: *width, location: to });
        }
        (Some(Prepared { position, bytes, width: None }), _) => {
            copy_bytes(l, &Location::Fixed { area: Area::Local, position: *position }, &to, *bytes);
        }
        (None, Some(Actual::Memory(access))) if reads(parameter) => {
            copy(l, access, &Access { width: access.width, location: to });
        }
        _ => {}
    }
    l.b.release_temporaries();
}

fn reads(parameter: &CallParameter) -> bool {
    matches!(parameter.section, Section::Input | Section::InOut)
}

fn writes(parameter: &CallParameter) -> bool {
    matches!(parameter.section, Section::Output | Section::InOut | Section::Return)
}

fn local(position: u32, width: Width) -> Access {
    Access { width, location: Location::Fixed { area: Area::Local, position } }
}

fn elementary_width(data_type: &DataType) -> Option<Width> {
    match data_type.bits() {
        1 => Some(Width::Bit),
        8 => Some(Width::Byte),
        16 => Some(Width::Word),
        32 if data_type.is_elementary() => Some(Width::DoubleWord),
        _ => None,
    }
}

/// A pointer that the called block can use as it is, if the place does not depend on DB, DI, AR or parameters.
fn direct_pointer(location: &Location) -> Option<u32> {
    match location {
        Location::Fixed { area: Area::Local, position } => Some(CALLER_LOCAL | position),
        Location::Fixed { area: Area::SharedData | Area::InstanceData | Area::CallerLocal, .. } => None,
        Location::Fixed { area, position } => Some(u32::from(area.pointer_code()) << AREA_SHIFT | position),
        _ => None,
    }
}

/// Copies one elementary value.
fn copy(l: &mut Lowering<'_>, from: &Access, to: &Access) {
    let value = l.load(from, OnFault::SkipStatement);
    let place = l.place(&to.location);
    l.b.store(place, to.width, value);
    l.b.release_temporaries();
}

/// Copies a complex value. At most one of the two places needs a data block or AR1 of its own.
fn copy_bytes(l: &mut Lowering<'_>, from: &Location, to: &Location, bytes: u32) {
    let from = l.place(from);
    let to = l.place(to);
    l.b.push(Inst::Move { from, to, bytes });
    l.b.release_temporaries();
}

/// Stores a constant in hidden local data; its position. A STRING or DATE_AND_TIME takes no constant, the check has refused it.
fn store_constant(l: &mut Lowering<'_>, value: &Value, data_type: &DataType) -> u32 {
    let bytes: Vec<u8> = match value {
        Value::Any(bytes) => bytes.to_vec(),
        Value::DataPointer { db, pointer } => db.to_be_bytes().into_iter().chain(pointer.to_be_bytes()).collect(),
        Value::Pointer(pointer) if *data_type == DataType::Pointer => [0, 0].into_iter().chain(pointer.to_be_bytes()).collect(),
        Value::Bool(bit) => vec![u8::from(*bit)],
        Value::DateAndTime(bytes) => bytes.to_vec(),
        Value::Characters(_) if is_complex(data_type) => {
            let mut image = vec![0; bytes_of(data_type) as usize];
            write(&mut image, 0, data_type, value);
            image
        }
        other => {
            let bits = other.accumulator().unwrap_or_default();
            let bytes = data_type.bits().div_ceil(8).clamp(1, 4) as usize;
            bits.to_be_bytes()[4 - bytes..].to_vec()
        }
    };
    let position = l.hidden(bytes.len() as u32);
    for (chunk, at) in bytes.chunks(4).zip((position..).step_by(32)) {
        let mut done = 0;
        for (part, width) in split(chunk) {
            let value = l.b.constant(u64::from(part));
            let place = Place::Fixed { area: Area::Local, position: at + done };
            l.b.store(place, width, value);
            l.b.release_temporaries();
            done += width.bits();
        }
    }
    position
}

/// Up to four bytes as double word, word and byte.
pub(super) fn split(bytes: &[u8]) -> Vec<(u32, Width)> {
    match *bytes {
        [a, b, c, d] => vec![(u32::from_be_bytes([a, b, c, d]), Width::DoubleWord)],
        [a, b, c] => vec![(u32::from(u16::from_be_bytes([a, b])), Width::Word), (u32::from(c), Width::Byte)],
        [a, b] => vec![(u32::from(u16::from_be_bytes([a, b])), Width::Word)],
        [a] => vec![(u32::from(a), Width::Byte)],
        _ => Vec::new(),
    }
}

/// Where an ANY lies in the local data that is passed as it is: a variable of VAR_TEMP that the program has put together, or
/// a parameter passed on. A pointer to it would mean the ten bytes themselves.
fn ready_any(l: &mut Lowering<'_>, parameter: &CallParameter, location: &Location, data_type: &DataType) -> Option<u32> {
    if parameter.data_type != DataType::Any || *data_type != DataType::Any {
        return None;
    }
    match location {
        Location::Fixed { area: Area::Local, position } => Some(*position),
        Location::Parameter { index, .. } => {
            let own = l.b.temporary();
            l.b.push(Inst::Parameter { dst: own, index: *index });
            Some(copied_any(l, own, |pointer, offset| Place::Crossing { pointer, offset }))
        }
        Location::Instance { position } => {
            let start = *position;
            let base = Register::Ar2.into();
            Some(copied_any(l, base, |pointer, offset| Place::Indirect { area: Area::InstanceData, pointer, offset: start + offset }))
        }
        _ => None,
    }
}

/// Copies the ten bytes of an ANY that is passed on into hidden local data; their position.
fn copied_any(l: &mut Lowering<'_>, base: Var, at: impl Fn(Var, u32) -> Place) -> u32 {
    let position = l.hidden(ANY_BYTES);
    for (offset, width) in ANY_PARTS {
        let mut value = l.b.load(at(base, offset), width, OnFault::SkipStatement);
        if offset == 48 {
            value = l.b.compute(Op::PassOnPointer, &[value]);
        }
        l.b.store(Place::Fixed { area: Area::Local, position: position + offset }, width, value);
    }
    l.b.release_temporaries();
    position
}

/// Builds a POINTER (6 bytes) or ANY (10 bytes) to a place in hidden local data; its position.
pub(super) fn build_pointer(l: &mut Lowering<'_>, location: &Location, data_type: &DataType, any: bool) -> u32 {
    let position = l.hidden(if any { ANY_BYTES } else { POINTER_BYTES });
    let at = |offset: u32| Place::Fixed { area: Area::Local, position: position + offset };
    let start = if any {
        let (code, count) = any_type(data_type);
        let head = l.b.constant(ANY_OF_S7 | u64::from(code));
        l.b.store(at(0), Width::Word, head);
        let count = l.b.constant(u64::from(count));
        l.b.store(at(16), Width::Word, count);
        32
    } else {
        0
    };
    let (number, pointer): (Var, Var) = match location {
        Location::Fixed { area: Area::SharedData, position } => {
            (Register::DbNumber.into(), l.b.constant(u64::from(IN_DATA_BLOCK | *position)))
        }
        Location::Fixed { area: Area::InstanceData, position } => {
            (Register::DiNumber.into(), l.b.constant(u64::from(IN_DATA_BLOCK | *position)))
        }
        Location::InDataBlock { db, position } | Location::InInstanceBlock { db, position } => {
            (l.b.constant(u64::from(*db)), l.b.constant(u64::from(IN_DATA_BLOCK | *position)))
        }
        // A parameter of type POINTER is passed on, not the address of its six bytes.
        Location::Instance { position } if *data_type == DataType::Pointer && !any => through_instance(l, *position, 0),
        Location::Instance { position } => {
            let mask = l.b.constant(ADDRESS_MASK);
            let base = l.b.compute(Op::AndU32, &[Register::Ar2.into(), mask]);
            let position = l.b.constant(u64::from(IN_DATA_BLOCK | *position));
            (Register::DiNumber.into(), l.b.compute(Op::AddU32, &[base, position]))
        }
        Location::Parameter { index, offset, complex } => {
            let own = l.b.temporary();
            l.b.push(Inst::Parameter { dst: own, index: *index });
            let offset = l.b.constant(u64::from(*offset));
            let (number, pointer) = if *complex {
                let number = l.b.load(Place::Crossing { pointer: own, offset: 0 }, Width::Word, OnFault::SkipStatement);
                (number, l.b.load(Place::Crossing { pointer: own, offset: 16 }, Width::DoubleWord, OnFault::SkipStatement))
            } else {
                (l.b.constant(0), own)
            };
            let moved = l.b.compute(Op::AddU32, &[pointer, offset]);
            (number, l.b.compute(Op::PassOnPointer, &[moved]))
        }
        Location::InstancePointer { position, offset } => through_instance(l, *position, *offset),
        other => {
            let pointer = direct_pointer(other).unwrap_or_default();
            (l.b.constant(0), l.b.constant(u64::from(pointer)))
        }
    };
    l.b.store(at(start), Width::Word, number);
    l.b.store(at(start + 16), Width::DoubleWord, pointer);
    l.b.release_temporaries();
    position
}

/// Data block and pointer of a POINTER that lies in the instance, moved by an offset, for a block that is called.
fn through_instance(l: &mut Lowering<'_>, position: u32, offset: u32) -> (Var, Var) {
    let at = |position| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: position };
    let number = l.b.load(at(position), Width::Word, OnFault::SkipStatement);
    let pointer = l.b.load(at(position + 16), Width::DoubleWord, OnFault::SkipStatement);
    let offset = l.b.constant(u64::from(offset));
    let moved = l.b.compute(Op::AddU32, &[pointer, offset]);
    (number, l.b.compute(Op::PassOnPointer, &[moved]))
}
