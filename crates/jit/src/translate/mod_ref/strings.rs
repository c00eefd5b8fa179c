//! Mod/ref summaries of strings that a block writes by pointers that it was given: results of functions, VAR_IN_OUT.
//!
//! Reading strings has no slow path that changes memory. What a string instruction writes begins where its pointer leads, and is at most as
//! many bytes as a string can have.

use std::collections::BTreeMap;

use sieben_engine::ir::{Callee, Inst, Op, Place, TextRoom, Var, verify};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::{ArgumentSource, own_local};
use crate::jit::Native;
use crate::translate::pointer_propagation::InstancePointer;
use crate::translate::strings::NUMBER_SHIFT;

/// A text that a block writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::translate) struct WrittenText {
    /// The number of its data block, 0 for other areas.
    pub(in crate::translate) number: ArgumentSource,
    pub(in crate::translate) pointer: ArgumentSource,
    /// Bits from there to where it begins, or to the first element that it may be.
    pub(in crate::translate) offset: u32,
    /// Bytes from there to behind it, or behind the last element.
    pub(in crate::translate) bytes: u32,
}

impl WrittenText {
    /// Where the block reads what it needs to know.
    pub(in crate::translate) fn sources(&self) -> impl Iterator<Item = (ArgumentSource, Width)> {
        [(self.number, Width::Word), (self.pointer, Width::DoubleWord)].into_iter()
    }
}

/// What a variable of the IR holds.
#[derive(Clone, Copy)]
enum TempValue {
    Constant(u64),
    Parameter(u16),
    Word(ArgumentSource),
    DoubleWord(ArgumentSource),
    /// The number of a data block, where a pointer has it.
    Shifted(ArgumentSource),
    /// A pointer and some bits more: at least and at most so many.
    Moved(ArgumentSource, u32, u32),
    /// Number and pointer, and bits more.
    Text(ArgumentSource, ArgumentSource, u32, u32),
    /// Whether a variable is below a limit.
    Below(Var, u64),
    /// A number that is at most this.
    AtMost(u64),
    Other,
}

impl TempValue {
    /// At least and at most how much it is.
    fn range(self) -> Option<(u32, u32)> {
        match self {
            Self::Constant(value) => u32::try_from(value).ok().map(|value| (value, value)),
            Self::AtMost(most) => u32::try_from(most).ok().map(|most| (0, most)),
            _ => None,
        }
    }

    /// A pointer, and at least and at most how many bits more.
    fn pointer(self) -> Option<(ArgumentSource, u32, u32)> {
        match self {
            Self::DoubleWord(pointer) => Some((pointer, 0, 0)),
            Self::Moved(pointer, least, most) => Some((pointer, least, most)),
            _ => None,
        }
    }

    /// The sum of two numbers, or of a pointer and a number; `None` = nothing is known of it.
    fn add(self, other: Self) -> Option<Self> {
        let (number, pointer) = if self.pointer().is_some() { (other, self) } else { (self, other) };
        let (least, most) = number.range()?;
        match pointer.pointer() {
            Some((pointer, first, last)) => Some(Self::Moved(pointer, first.checked_add(least)?, last.checked_add(most)?)),
            None => Some(Self::AtMost(pointer.range()?.1.checked_add(most)?.into())),
        }
    }
}

/// The texts that a block writes by pointers, beside those in its own local data and its instance; `None` = it may write others.
pub(super) fn written(
    block: &Native,
    pointers: &InstancePointer,
    called: &mut dyn FnMut(&Callee) -> Option<Vec<WrittenText>>,
) -> Option<Vec<WrittenText>> {
    let code = &block.code;
    let mut texts = Vec::new();
    for statement in 0..code.statement_count() {
        let mut held: BTreeMap<u8, TempValue> = BTreeMap::new();
        let mut local: BTreeMap<u32, (Width, u64)> = BTreeMap::new();
        let mut passed: Vec<TempValue> = Vec::new();
        let mut instance = pointers.at(statement as u32);
        for (at, inst) in (code.statements[statement]..).zip(code.statement(statement)) {
            let of = |var: Var| held.get(&var.0).copied().unwrap_or(TempValue::Other);
            let read = |source: ArgumentSource, width: Width| match width {
                Width::Word => TempValue::Word(source),
                Width::DoubleWord => TempValue::DoubleWord(source),
                _ => TempValue::Other,
            };
            let mut result = TempValue::Other;
            match *inst {
                Inst::Constant { value, .. } => result = TempValue::Constant(value),
                Inst::Parameter { index, .. } => result = TempValue::Parameter(index),
                Inst::Compute { op: Op::Copy, args, .. } => result = of(args[0]),
                Inst::Compute { op: Op::Shl64, args, .. } => {
                    if let (TempValue::Word(number), TempValue::Constant(shift)) = (of(args[0]), of(args[1]))
                        && shift == u64::from(NUMBER_SHIFT)
                    {
                        result = TempValue::Shifted(number);
                    }
                }
                Inst::Compute { op: Op::OrU64, args, .. } => {
                    if let (TempValue::Shifted(number), Some((pointer, least, most))) = (of(args[0]), of(args[1]).pointer()) {
                        result = TempValue::Text(number, pointer, least, most);
                    }
                }
                Inst::Compute { op: Op::Below, args, .. } => {
                    if let TempValue::Constant(limit @ 1..) = of(args[1]) {
                        result = TempValue::Below(args[0], limit);
                    }
                }
                Inst::Compute { op: Op::Gate, args, .. } => {
                    if let TempValue::Below(var, limit) = of(args[1])
                        && var == args[0]
                    {
                        result = TempValue::AtMost(limit - 1);
                    }
                }
                Inst::Compute { op: Op::MulU32, args, .. } => {
                    if let (Some((_, a)), Some((_, b))) = (of(args[0]).range(), of(args[1]).range()) {
                        result = a.checked_mul(b).map_or(TempValue::Other, |most| TempValue::AtMost(most.into()));
                    }
                }
                Inst::Compute { op: Op::AddU32, args, .. } => result = of(args[0]).add(of(args[1])).unwrap_or(TempValue::Other),
                Inst::Load { place: Place::Crossing { pointer, offset }, width, .. } => {
                    if let TempValue::Parameter(parameter) = of(pointer) {
                        result = read(ArgumentSource::Given(parameter, offset), width);
                    }
                }
                Inst::Load { place: Place::Indirect { area: Area::InstanceData, pointer, offset }, width, .. }
                    if pointer.register() == Some(Register::Ar2) =>
                {
                    if let Some(added) = instance {
                        result = read(ArgumentSource::Instance(added.wrapping_add(offset)), width);
                    }
                }
                Inst::Store { place: Place::Fixed { area: Area::Local, position }, width, src } => {
                    forget(&mut local, position, width.bits());
                    if let TempValue::Constant(value) = of(src) {
                        local.insert(position, (width, value));
                    }
                }
                Inst::Store { .. } | Inst::Move { .. } => local.clear(),
                Inst::Text { action, to, to_room, .. } if action.writes() => match to {
                    Place::Fixed { area: Area::Local, position } => forget(&mut local, position, 8 * bytes_of(to_room)),
                    Place::Crossing { pointer, offset } => {
                        let TempValue::Text(number, pointer, least, most) = of(pointer) else { return None };
                        let (first, last) = (offset.checked_add(least)?, offset.checked_add(most)?);
                        let bytes = (last - first).div_ceil(8).checked_add(bytes_of(to_room))?;
                        add(&mut texts, WrittenText { number, pointer, offset: first, bytes });
                        local.clear();
                    }
                    _ => local.clear(),
                },
                Inst::PassParameter { src } => passed.push(of(src)),
                Inst::Call { callee, parameters } => {
                    let given = passed.split_off(passed.len().checked_sub(usize::from(parameters))?);
                    for text in called(&callee)? {
                        let own = |source: ArgumentSource, width: Width| own_number(&local, &given, source, width);
                        let (number, pointer) = (own(text.number, Width::Word)?, own(text.pointer, Width::DoubleWord)?);
                        own_local(pointer).filter(|_| number == 0)?;
                    }
                    held.clear();
                    local.clear();
                    // AR2 is kept by most blocks; who needs it knows it behind the instruction.
                    instance = None;
                    continue;
                }
                _ => {}
            }
            if let Some(dst) = verify::writes(inst) {
                held.retain(|_, held| !matches!(held, TempValue::Below(var, _) if *var == dst));
                if matches!(result, TempValue::Below(var, _) if var == dst) {
                    result = TempValue::Other;
                }
                held.insert(dst.0, result);
                if dst == Register::Ar2.into() {
                    instance = pointers.after(at);
                }
            }
        }
    }
    Some(texts)
}

fn forget(local: &mut BTreeMap<u32, (Width, u64)>, position: u32, bits: u32) {
    local.retain(|&other, (width, _)| other + width.bits() <= position || position + bits <= other);
}

/// A number that the statement itself has written to the local data of its block, and to which a parameter of a call points.
fn own_number(local: &BTreeMap<u32, (Width, u64)>, given: &[TempValue], source: ArgumentSource, width: Width) -> Option<u64> {
    let ArgumentSource::Given(parameter, offset) = source else { return None };
    let TempValue::Constant(pointer) = *given.get(usize::from(parameter))? else { return None };
    local.get(&(own_local(pointer)? + offset)).filter(|(written, _)| *written == width).map(|&(_, value)| value)
}

fn add(texts: &mut Vec<WrittenText>, text: WrittenText) {
    if !texts.contains(&text) {
        texts.push(text);
    }
}

/// Bytes that a text has at most.
pub(super) fn bytes_of(room: TextRoom) -> u32 {
    if !room.is_unknown() {
        return room.bytes();
    }
    let most = if room.wide { u32::from(u16::MAX) } else { u32::from(u8::MAX) };
    room.head() + most * room.unit()
}
