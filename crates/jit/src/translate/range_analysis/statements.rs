//! Transfer functions of statements: the facts after a statement, from those before it.

use std::collections::BTreeMap;

use sieben_engine::fault::NOTED;
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{DataRegister, Inst, OnFault, Op, Place, Target, TextAction, TextRoom, Var};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::interval::{self, Interval, Number, Relation, comparison};
use super::{AbstractValue, Analysis, Origin, Reach, Span, State, StringPlace, ValueNumber};
use crate::jit::end;
use crate::translate::scalar_promotion::Base;

/// How many origins of a value are looked at when something is found out about it.
const ORIGINS_MAX: usize = 6;

/// Whether a statement that has done so much can begin again, as if it had done nothing: it has read what did not fail, and written nothing
/// but its own local data, which it did not read before. A data block that it has opened it opens again, before what it reads there.
fn can_begin_again(done: &[Inst]) -> bool {
    let (mut read, mut reads_shared, mut opened) = (Vec::new(), false, false);
    done.iter().all(|inst| match *inst {
        Inst::Constant { dst, .. } | Inst::Compute { dst, .. } | Inst::Parameter { dst, .. } => dst.register().is_none(),
        Inst::Load { dst, place, on_fault: OnFault::SkipStatement, .. } => {
            let is_known = match place {
                Place::Fixed { area: Area::Local, position } => {
                    read.push(position);
                    true
                }
                Place::Fixed { area, .. } | Place::Indirect { area, .. } => {
                    reads_shared |= area == Area::SharedData && !opened;
                    !matches!(area, Area::Local | Area::PeripheralInput | Area::PeripheralOutput)
                }
                Place::Crossing { .. } => {
                    reads_shared |= !opened;
                    true
                }
            };
            is_known && dst.register().is_none()
        }
        Inst::Store { place: Place::Fixed { area: Area::Local, position }, width, .. } => {
            let end = position + width.bits();
            !read.iter().any(|&at| position < at + 64 && at < end)
        }
        Inst::Open { register: DataRegister::Shared, .. } => {
            opened = true;
            !reads_shared
        }
        Inst::Require { .. } => true,
        _ => false,
    })
}

impl Analysis<'_> {
    /// Follows the instructions of a statement.
    pub(super) fn statement(&mut self, statement: u32, mut state: State, notes: bool) {
        let code = self.code;
        let first = code.statements[statement as usize];
        let registers = state.registers.clone();
        self.computed.clear();
        self.given_variables.clear();
        self.passes_elements = self.passes_elements(code.statement(statement as usize));
        let mut temporaries: BTreeMap<u8, AbstractValue> = BTreeMap::new();
        let mut passed = Vec::new();
        let mut ended = false;
        for (index, inst) in (first..).zip(code.statement(statement as usize)) {
            let mut fails = false;
            match *inst {
                Inst::Constant { dst, value } => {
                    let known = self.value(Interval::constant(value));
                    put(&mut state, &mut temporaries, dst, known);
                }
                Inst::Compute { op, dst, args } => {
                    let mut args = args.map(|arg| self.get(&state, &temporaries, arg));
                    if self.around.relative.is_some_and(|relative| relative.uses.positions.contains(&index)) {
                        args[0] = self.value(self.really(args[0].range));
                    }
                    let pointer = args[0].range;
                    if notes && op == Op::PassOnPointer && pointer.bits <= 32 && pointer.leads_elsewhere() {
                        self.found.passed_on.insert(index);
                    }
                    let known = self.compute(op, args);
                    put(&mut state, &mut temporaries, dst, known);
                }
                Inst::Load { dst, place, width, on_fault } => {
                    let known = self.load(&mut state, &temporaries, (place, width), on_fault, &mut fails, notes.then_some(index));
                    put(&mut state, &mut temporaries, dst, known);
                }
                Inst::Store { place, width, src } => {
                    let value = match self.around.relative {
                        // AR2 is somewhere else than what is said of it.
                        Some(relative) if relative.uses.pointers.contains(&index) => self.value(Interval::any(32)),
                        _ => self.get(&state, &temporaries, src),
                    };
                    let role = notes.then_some((index, true));
                    let reach = self.reach(&state, &temporaries, place, Span::Width(width), true, role);
                    let pointer = match place {
                        Place::Indirect { pointer, .. } => self.get(&state, &temporaries, pointer),
                        _ => value,
                    };
                    self.store(&mut state, reach, (place, width), [pointer, value], &mut fails, notes.then_some(index));
                }
                Inst::Move { from, to, bytes } => {
                    let roles = [false, true].map(|write| notes.then_some((index, write)));
                    let read = self.reach(&state, &temporaries, from, Span::Bytes(bytes), false, roles[0]).bytes(bytes);
                    let write = self.reach(&state, &temporaries, to, Span::Bytes(bytes), true, roles[1]);
                    match (read, write.bytes(bytes)) {
                        (Some(read), Some(write)) if notes => drop(self.found.moves.insert(index, [read, write])),
                        (Some(_), Some(_)) => {}
                        _ => fails = true,
                    }
                    match write {
                        Reach::Variable(base, offset) => state.forget(base, &(i64::from(offset)..i64::from(offset) + i64::from(bytes))),
                        Reach::Inside(base, range) | Reach::Bytes(base, range) => state.forget(base, &range),
                        Reach::Anything => state.forget_memory(),
                    }
                }
                Inst::Text { action, dst, to, to_room, from, from_room, .. } => {
                    let mut bytes = |place: Place, room: TextRoom, write: bool| {
                        let text = self.text(&state, &temporaries, (place, room), write)?;
                        fails |= text.there < text.room.bytes();
                        Some(text)
                    };
                    let is_read = !action.takes_number();
                    let read = if is_read { bytes(from, from_room, false) } else { None };
                    let other = if action == TextAction::Length { None } else { bytes(to, to_room, action.writes()) };
                    let inside = (read.is_some() || !is_read) && (other.is_some() || action == TextAction::Length);
                    fails |= !inside;
                    match &other {
                        // Wherever the text is that is read: reading it changes nothing.
                        Some(StringPlace { bytes, there, room, .. }) if action.writes() => {
                            let (base, range) = bytes;
                            let begins = *base == Base::Local && range.end - range.start == i64::from(room.bytes());
                            let says =
                                (begins || self.said_room(&state, bytes, *there).is_some()) && !room.wide && action != TextAction::Number;
                            state.forget(*base, range);
                            if says && !room.is_unknown() {
                                // It says so now.
                                let most = self.value(Interval::constant(room.characters_max.into()));
                                state.variables.insert((*base, range.start as i32, Width::Byte), most);
                            }
                        }
                        _ if action.writes() => state.forget_memory(),
                        _ => {}
                    }
                    let counted = match action {
                        TextAction::Length | TextAction::Piece | TextAction::Append => Some((&read, from_room)),
                        TextAction::Find => Some((&other, to_room)),
                        _ => None,
                    };
                    let any = Interval::any(32);
                    let range = counted.map_or(any, |(text, room)| {
                        let room = text.as_ref().map_or(room, |text| text.room);
                        let most = if room.wide { i32::MAX as u32 } else { room.bytes() - room.head() };
                        any.limited(Number::Unsigned(32), (0, most.into()))
                    });
                    if notes {
                        self.found.texts.insert(index, [read, other]);
                    }
                    let known = self.value(range);
                    put(&mut state, &mut temporaries, dst, known);
                }
                Inst::Parameter { dst, index } => {
                    let given = self.around.parameters.get(usize::from(index)).copied().flatten();
                    let known = self.value(given.map_or(Interval::any(32), Interval::constant));
                    put(&mut state, &mut temporaries, dst, known);
                }
                Inst::PassParameter { src } => passed.push(self.get(&state, &temporaries, src)),
                Inst::Intrinsic { dst, intrinsic, .. } => {
                    fails = intrinsic != Intrinsic::Clock;
                    let known = self.value(Interval::any(64));
                    put(&mut state, &mut temporaries, dst, known);
                }
                Inst::Require { condition: var, code: noted, .. } if noted & NOTED != 0 => {
                    let condition = self.get(&state, &temporaries, var);
                    if condition.range.exact().is_some_and(|value| value & 1 != 0) {
                        if notes {
                            self.found.met.insert(index);
                        }
                    } else if can_begin_again(&code.insts[first as usize..index as usize]) {
                        if notes {
                            self.found.interpreted.insert(index);
                        }
                        self.refine(&mut state, &mut temporaries, condition.number, true);
                        let holds = self.value(Interval::constant(1));
                        put(&mut state, &mut temporaries, var, holds);
                    }
                }
                Inst::Require { condition, .. } => {
                    let condition = self.get(&state, &temporaries, condition);
                    if condition.range.exact().is_some_and(|value| value & 1 != 0) {
                        if notes {
                            self.found.met.insert(index);
                        }
                    } else {
                        fails = true;
                    }
                    if fails {
                        self.arrive_failed(statement, &registers, &state);
                        fails = false;
                    }
                    self.refine(&mut state, &mut temporaries, condition.number, true);
                }
                Inst::RequireStack { .. } => {}
                Inst::Open { register, number } => {
                    let number = self.get(&state, &temporaries, number);
                    fails |= !self.open(&mut state, register, number.range.exact());
                }
                Inst::Jump { to: Target(to) } => {
                    self.arrive(to, &state, Some(statement));
                    ended = true;
                }
                Inst::Branch { condition, to: Target(to) } => {
                    let condition = self.get(&state, &temporaries, condition);
                    let exact = condition.range.exact().map(|value| value & 1);
                    if exact != Some(0) {
                        let (mut taken, mut other) = (state.clone(), temporaries.clone());
                        self.refine(&mut taken, &mut other, condition.number, true);
                        self.arrive(to, &taken, Some(statement));
                    }
                    if exact == Some(1) {
                        ended = true;
                    } else {
                        self.refine(&mut state, &mut temporaries, condition.number, false);
                    }
                }
                Inst::JumpTable { first, count, otherwise: Target(to), .. } => {
                    self.arrive(to, &state, Some(statement));
                    for &Target(to) in &code.tables[first as usize..(first + count) as usize] {
                        self.arrive(to, &state, Some(statement));
                    }
                    ended = true;
                }
                Inst::Call { .. } => {
                    fails = !self.call(index, inst, &mut state, &mut passed, notes);
                    temporaries.clear();
                }
                Inst::Return => {
                    if let Some(end) = end(code).filter(|&end| end != statement) {
                        self.arrive(end, &state, Some(statement));
                    }
                    ended = true;
                }
            }
            if fails {
                self.arrive_failed(statement, &registers, &state);
            }
            if sieben_engine::ir::verify::writes(inst) == Some(Register::Ar2.into())
                && let Some(pointer) = (self.around.instance[1])(index)
            {
                let known = self.value(Interval::constant(pointer));
                state.registers.insert(Register::Ar2 as u8, known);
            }
            if notes && let Some(dst) = sieben_engine::ir::verify::writes(inst) {
                let range = self.get(&state, &temporaries, dst).range;
                let (least, most) = range.unsigned(64);
                if matches!(inst, Inst::Load { .. })
                    && range.zeros >= 3
                    && let (Ok(least @ 0x8000_0000..), Ok(most)) = (u32::try_from(least), u32::try_from(most))
                    && least >> 24 == most >> 24
                {
                    self.found.pointers.insert(index, (least, most));
                }
                if let (Ok(least), Ok(most)) = (u32::try_from(least), u32::try_from(most))
                    && (least == most || most <= i32::MAX as u32)
                {
                    self.found.results.insert(index, (least, most));
                }
            }
            if ended {
                return;
            }
        }
        self.arrive(statement + 1, &state, Some(statement));
    }

    /// A statement that failed counts as NOP: its registers are as before, but for what it called.
    pub(super) fn arrive_failed(&mut self, statement: u32, registers: &BTreeMap<u8, AbstractValue>, state: &State) {
        let before = State { registers: registers.clone(), variables: state.variables.clone(), elements: Vec::new() };
        // Behind a call that failed other registers may have changed too.
        let failed = self.joined(&before, state);
        self.arrive(statement + 1, &failed, Some(statement));
    }

    pub(super) fn get(&mut self, state: &State, temporaries: &BTreeMap<u8, AbstractValue>, var: Var) -> AbstractValue {
        let known = match var.register() {
            Some(register) => state.registers.get(&(register as u8)),
            None => temporaries.get(&var.0),
        };
        match known {
            Some(known) => *known,
            None => self.value(Interval::any(64)),
        }
    }

    pub(super) fn compute(&mut self, op: Op, [a, b, c, d]: [AbstractValue; 4]) -> AbstractValue {
        let exact = |known: AbstractValue| known.range.exact().map(|value| value & 1 != 0);
        let is_bit = |known: AbstractValue| known.range.unsigned(64).1 <= 1;
        match op {
            Op::Copy => return a,
            Op::Low8 if a.range.bits <= 8 => return a,
            Op::Low16 if a.range.bits <= 16 => return a,
            Op::Low32 if a.range.bits <= 32 => return a,
            Op::PassOnPointer if a.range.bits <= 32 && a.range.leads_elsewhere() => return a,
            Op::Select => match exact(a) {
                Some(true) => return b,
                Some(false) => return c,
                None => {}
            },
            Op::Gate if exact(b) == Some(true) => return a,
            Op::AndNot if exact(b) == Some(false) && is_bit(a) => return a,
            Op::And if exact(b) == Some(true) && is_bit(a) => return a,
            Op::And if exact(a) == Some(true) && is_bit(b) => return b,
            Op::MulU32 if a.range.exact() == Some(1) && b.range.bits <= 32 => return b,
            Op::MulU32 if b.range.exact() == Some(1) && a.range.bits <= 32 => return a,
            Op::AddU32 if b.range.exact() == Some(0) && a.range.bits <= 32 => return a,
            _ => {}
        }
        let words = [a, b, c, d].map(|known| known.range.exact());
        if words[..op.arity()].iter().all(Option::is_some) {
            let value = Op::eval(op, words.map(Option::unwrap_or_default));
            return self.value(Interval::constant(value));
        }
        let mut range = interval::result(op, [a.range, b.range, c.range]);
        if op == Op::Gate
            && let Some((number, relation, right)) = self.compared_where(b.number, a)
        {
            // What passes the gate has passed the comparison.
            let passed = a.range.limited(number, relation.limits(number.of(&right.range)));
            let passed = interval::result(Op::Gate, [passed, b.range, c.range]);
            if passed.most.saturating_sub(passed.least) <= range.most.saturating_sub(range.least) {
                range = passed;
            }
        }
        let origin = match op {
            Op::Not => Origin::Not(a.number),
            Op::AndNot => Origin::AndNot(a.number, b.number),
            Op::And => Origin::And(a.number, b.number),
            Op::Or => Origin::Or(a.number, b.number),
            Op::MulU32 if a.number == b.number || self.extends_the_same(a, b) => Origin::Square(a),
            Op::Extend16 => Origin::Extended(16, a),
            Op::ExtendI8I16 | Op::ExtendI8I32 | Op::ExtendI8I64 => Origin::Extended(8, a),
            Op::ExtendI16I64 => Origin::Extended(16, a),
            Op::ExtendI32I64 => Origin::Extended(32, a),
            Op::AddU16 | Op::AddU32 | Op::SubU16 | Op::SubU32 => sum(op, a, b),
            _ => match comparison(op) {
                Some((number, relation)) => Origin::Comparison(number, relation, a, b),
                None => Origin::Other,
            },
        };
        let known = self.value_from(range, origin);
        if op.arity() > 3 || !self.passes_elements {
            return known;
        }
        let mut same = [ValueNumber::Constant(0); 3];
        for (same, arg) in same.iter_mut().zip([a, b, c]).take(op.arity()) {
            *same = ValueNumber::of(arg);
        }
        AbstractValue { range, number: *self.computed.entry((op, same)).or_insert(known.number) }
    }

    /// A comparison of a value that is true where a condition holds: how it is compared, and with what.
    fn compared_where(&self, condition: u32, value: AbstractValue) -> Option<(Number, Relation, AbstractValue)> {
        match self.origins[condition as usize] {
            Origin::Comparison(number, relation, left, right) if left.number == value.number => Some((number, relation, right)),
            Origin::And(a, b) => self.compared_where(a, value).or_else(|| self.compared_where(b, value)),
            Origin::AndNot(a, _) => self.compared_where(a, value),
            _ => None,
        }
    }

    /// What a branch that was taken, or not, tells about the values that were compared.
    pub(super) fn refine(&mut self, state: &mut State, temporaries: &mut BTreeMap<u8, AbstractValue>, condition: u32, holds: bool) {
        match self.origins[condition as usize] {
            Origin::Not(inner) => self.refine(state, temporaries, inner, !holds),
            Origin::Comparison(number, relation, a, b) => {
                let relation = if holds { relation } else { relation.inverted() };
                // What is known of them may have become more since.
                let [a, b] = [a, b].map(|known| AbstractValue { range: current(state, known), ..known });
                self.limit(state, temporaries, a, number, relation.limits(number.of(&b.range)));
                self.limit(state, temporaries, b, number, relation.mirrored().limits(number.of(&a.range)));
            }
            Origin::And(a, b) if holds => {
                self.refine(state, temporaries, a, true);
                self.refine(state, temporaries, b, true);
            }
            Origin::AndNot(a, b) if holds => {
                self.refine(state, temporaries, a, true);
                self.refine(state, temporaries, b, false);
            }
            Origin::Or(a, b) if !holds => {
                self.refine(state, temporaries, a, false);
                self.refine(state, temporaries, b, false);
            }
            Origin::And(..) | Origin::AndNot(..) | Origin::Or(..) => {}
            Origin::Square(_) | Origin::Extended(..) | Origin::Sum(..) | Origin::Other => {}
        }
    }

    /// Whether two values are the same bits as a number with sign.
    fn extends_the_same(&self, a: AbstractValue, b: AbstractValue) -> bool {
        match [a, b].map(|known| self.origins[known.number as usize]) {
            [Origin::Extended(bits, a), Origin::Extended(others, b)] => bits == others && a.number == b.number,
            _ => false,
        }
    }

    /// Notes that a value lies in a range, and what follows for the values from which it was computed.
    pub(super) fn limit(
        &mut self,
        state: &mut State,
        temporaries: &mut BTreeMap<u8, AbstractValue>,
        mut of: AbstractValue,
        mut number: Number,
        mut range: (i128, i128),
    ) {
        for _ in 0..ORIGINS_MAX {
            let limited = of.range.limited(number, range);
            let all = state.registers.values_mut().chain(state.variables.values_mut()).chain(temporaries.values_mut());
            for known in all.filter(|known| known.number == of.number) {
                // What is held in fewer bits is another form of it.
                if known.range.bits == limited.bits {
                    known.range = limited;
                } else {
                    known.range = known.range.limited(number, range);
                }
            }
            let inner;
            (inner, number, range) = match self.origins[of.number as usize] {
                Origin::Extended(bits, inner) if inner.range.bits <= bits => (inner, Number::Signed(bits), limited.signed(limited.bits)),
                Origin::Sum(bits, inner, added) if inner.range.bits <= bits && limited.bits == bits => {
                    let summand = Interval { least: limited.least - added, most: limited.most - added, ..Interval::any(bits) };
                    let signed = summand.signed(bits);
                    if signed.1 - signed.0 < (1 << bits) - 1 {
                        (inner, Number::Signed(bits), signed)
                    } else {
                        (inner, Number::Unsigned(bits), summand.unsigned(bits))
                    }
                }
                Origin::Square(root) => {
                    let now = current(state, root);
                    let (least, most) = now.signed(32);
                    let (_, square) = limited.signed(32);
                    // The square is exact: its root is no greater than that of the limit.
                    if least < 0 || most > 46_340 || square < 0 {
                        return;
                    }
                    (root, Number::Signed(32), (0, i128::from((square as u64).isqrt())))
                }
                _ => return,
            };
            of = AbstractValue { range: current(state, inner), ..inner };
        }
    }
}

/// A sum of a value and a constant, or a difference.
fn sum(op: Op, a: AbstractValue, b: AbstractValue) -> Origin {
    let bits = if matches!(op, Op::AddU16 | Op::SubU16) { 16 } else { 32 };
    let constant = |known: AbstractValue| (known.range.least == known.range.most).then_some(known.range.least);
    match (op, constant(a), constant(b)) {
        (Op::SubU16 | Op::SubU32, _, Some(b)) => Origin::Sum(bits, a, b.wrapping_neg()),
        (Op::AddU16 | Op::AddU32, _, Some(b)) => Origin::Sum(bits, a, b),
        (Op::AddU16 | Op::AddU32, Some(a), _) => Origin::Sum(bits, b, a),
        _ => Origin::Other,
    }
}

/// What is known of a value now.
fn current(state: &State, known: AbstractValue) -> Interval {
    let mut all = state.variables.values().chain(state.registers.values());
    all.find(|other| other.number == known.number && other.range.bits == known.range.bits).map_or(known.range, |other| other.range)
}

fn put(state: &mut State, temporaries: &mut BTreeMap<u8, AbstractValue>, dst: Var, known: AbstractValue) {
    match dst.register() {
        Some(register) => state.registers.insert(register as u8, known),
        None => temporaries.insert(dst.0, known),
    };
}
