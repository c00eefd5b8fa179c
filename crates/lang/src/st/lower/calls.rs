//! Calls of functions and function blocks, with the conventions of `CALL` in STL, so that both languages call each other.

use std::collections::BTreeSet;

use sieben_engine::ir::{Callee as Called, DataRegister, Inst, Op, Var};
use sieben_engine::machine::Register;
use sieben_model::address::Width;
use sieben_model::block::BlockId;
use sieben_model::interface::{Section, Variable};
use sieben_model::types::DataType;

use super::pointers::{at, holds_address, is_address};
use super::{Lowering, bytes, width, width_of_bits};
use crate::calling::pointers::{CALLER_LOCAL, POINTER_BYTES, any_type};
use crate::calling::registers::{INSTANCE_START, REGISTER_PAIRS};
use crate::st::tree::{Argument, Base, Call, Callee, Dispatch, Place, Scalar, TextRoom, ValueKind, room_of};

/// No value has more bytes: a data block has at most so many.
const VALUE_BYTES_MAX: u32 = 65_536;

/// No CPU has a block of this number: an instance that is none of what it should be has nothing to call.
const NO_BLOCK: u16 = u16::MAX;
/// The programming error of a function that is not loaded.
const NOT_LOADED: u8 = 0x3C;

/// The instance that a method works on.
struct Enter {
    instance: Place,
    /// The function, if the instance says it.
    chosen: Option<Chosen>,
}

/// The block that an instance wants to be called.
struct Chosen {
    /// Where the hidden local data hold its number as a word.
    position: u32,
    /// What the number may be, each once.
    targets: Vec<u16>,
}

impl Chosen {
    /// The blocks, if they are few enough to be called by name.
    fn few(&self) -> Option<&[u16]> {
        (1..=BY_NAME_MAX).contains(&self.targets.len()).then_some(&self.targets)
    }
}

/// So many blocks among which an instance chooses are called by name: each takes an instruction or two, and room for its call.
const BY_NAME_MAX: usize = 12;

/// What a function gets for one parameter.
#[derive(Clone, Copy)]
enum Pass {
    /// A pointer or number that is known.
    Known(u32),
    /// A number in the hidden local data, as a word.
    Number(u32),
}

/// What is done behind a call.
enum Behind<'c> {
    /// The value that the block left at the place goes where the argument says.
    Take(Place, &'c Argument),
    /// The value goes back to the place that was passed by copying.
    Return { hidden: Place, place: Place, width: Width },
    /// The addresses in what was passed are seen from here again.
    TakeBack { place: Place, data_type: DataType },
}

impl Lowering<'_> {
    /// A call with its EN and ENO. The place of the result is left in `self.result`.
    pub(super) fn call(&mut self, call: &Call) {
        self.call_into(call, None);
    }

    /// The same. The result of a function of texts may go to a target with room for so many characters; whether it did.
    pub(super) fn call_into(&mut self, call: &Call, target: Option<(&Place, TextRoom)>) -> bool {
        if let (Some(function), None) = (call.written_out, &call.enable)
            && let Some(is_there) = self.write_out(function, call, target)
        {
            self.clear_ok_behind(call);
            // BR has changed: nothing may fail in the same statement.
            self.part();
            return is_there;
        }
        let skip = self.label();
        let done = self.label();
        let result = self.result_place(&call.result);
        let mut decision = call.enable.as_ref().and_then(|enable| self.decision_of("EN :=", enable));
        if let Some(enable) = &call.enable {
            self.branch(enable, skip, false);
            self.part();
            self.came(&mut decision, 1);
        }
        match &call.callee {
            Callee::Function(block) => self.call_function(*block, None, call, result.as_ref()),
            Callee::Method { block, instance, dispatch } => {
                let instance = self.freeze(instance);
                let enter = Enter { chosen: self.dispatched(dispatch.as_ref(), &instance), instance };
                self.call_function(*block, Some(enter), call, result.as_ref());
            }
            Callee::Instance { block, instance, dispatch } => self.call_instance(*block, instance, dispatch.as_ref(), call),
        }
        if let (Some(place), true) = (&result, holds_address(&call.result)) {
            self.take_back_addresses(place, &call.result);
        }
        self.clear_ok_behind(call);
        if call.enable.is_some() {
            self.part();
            self.leave_to(done);
            self.bind(skip);
            self.came(&mut decision, 0);
            self.decided(decision);
            self.push(Inst::Constant { dst: Register::Br.into(), value: 0 });
            self.bind(done);
        }
        for argument in &call.arguments {
            if let Argument::Eno { target } = argument {
                let eno = self.compute_from(Op::Copy, &[Register::Br.into()]);
                self.store_value(target, Width::Bit, eno);
            }
        }
        self.result = result.map(|place| place.offset);
        false
    }

    /// ENO/OK is cleared if a call that clears it left BR = 0.
    fn clear_ok_behind(&mut self, call: &Call) {
        if call.clears_ok && self.ok.is_some() {
            let failed = self.compute_from(Op::Not, &[Register::Br.into()]);
            self.clear_ok_if(failed);
            self.release(failed);
        }
    }

    /// Room for a result, cleared: what a function leaves unset is 0 or empty.
    fn result_place(&mut self, data_type: &DataType) -> Option<Place> {
        (*data_type != DataType::Void).then(|| self.cleared(data_type))
    }

    /// Room for a value in hidden local data that a called block sees, cleared.
    fn cleared(&mut self, data_type: &DataType) -> Place {
        if let Some(room) = room_of(data_type) {
            return self.empty_text(room);
        }
        let size = bytes(data_type).clamp(1, VALUE_BYTES_MAX);
        let place = self.hidden_bytes(size);
        match data_type.bits() {
            bits @ (1 | 8 | 16 | 32 | 64) => {
                let zero = self.constant(0);
                self.store_local(place.offset, width_of_bits(bits as u32), zero);
            }
            _ => self.store_bytes(place.offset, &vec![0; size as usize]),
        }
        place
    }

    // Functions.

    /// The block that an instance wants to be called.
    fn dispatched(&mut self, dispatch: Option<&Dispatch>, instance: &Place) -> Option<Chosen> {
        let dispatch = dispatch?;
        let of = self.load(instance, Width::Word);
        let mut number = self.constant(u64::from(NO_BLOCK));
        for &(one, target) in &dispatch.targets {
            let one = self.constant(u64::from(one));
            let is = self.compute_from(Op::Equal, &[of, one]);
            self.release(one);
            let target = self.constant(u64::from(target));
            number = self.compute(Op::Select, &[is, target, number]);
        }
        self.release(of);
        // Before any register has changed: a call that failed would leave the own instance behind.
        let none = self.constant(u64::from(NO_BLOCK));
        let equal = self.compute_from(Op::Equal, &[number, none]);
        self.release(none);
        let known = self.compute(Op::Not, &[equal]);
        self.fallible = true;
        self.push(Inst::Require { condition: known, code: NOT_LOADED, register: number });
        self.release(known);
        let targets: BTreeSet<u16> = dispatch.targets.iter().map(|&(_, target)| target).collect();
        Some(Chosen { position: self.spill(number, Width::Word), targets: targets.into_iter().collect() })
    }

    fn call_function(&mut self, block: BlockId, enter: Option<Enter>, call: &Call, result: Option<&Place>) {
        let interface = (self.known.interface)(block);
        let formals: Vec<&Variable> = interface.iter().flat_map(|interface| interface.parameters()).collect();
        let mut passed: Vec<Option<Pass>> = vec![None; formals.len()];
        let mut behind = Vec::new();
        let last_change = call.arguments.iter().rposition(|argument| self.argument_changes(argument));
        for (position, argument) in call.arguments.iter().enumerate() {
            let Some((index, formal)) = argument.parameter().and_then(|index| Some((index as usize, *formals.get(index as usize)?))) else {
                continue;
            };
            let changes = last_change.is_some_and(|last| last > position);
            passed[index] = Some(match argument {
                Argument::Text { text, .. } if changes => {
                    let place = self.kept_text(text).0;
                    self.pass_place(&place, formal)
                }
                Argument::Aggregate { source, data_type, .. } if changes => {
                    let place = self.hidden_bytes(bytes(data_type).clamp(1, VALUE_BYTES_MAX));
                    self.copy_typed(&place, source, data_type);
                    self.pass_pointer(&place, data_type, None)
                }
                _ => self.pass(argument, formal, &mut behind),
            });
        }
        for (index, formal) in formals.iter().enumerate() {
            if passed[index].is_none() {
                passed[index] = Some(match (formal.section, result) {
                    (Section::Return, Some(result)) => self.pass_place(result, formal),
                    _ => self.pass_default(formal),
                });
            }
        }
        match enter {
            None => {
                let parameters = self.pass_all(&passed);
                self.push(Inst::Call { callee: Called::Block(block), parameters });
                self.called();
            }
            Some(enter) => self.enter_chosen(block, &enter.instance, enter.chosen, &passed),
        }
        for action in behind {
            match action {
                Behind::Take(place, argument) => self.take_out(&place, argument),
                Behind::Return { hidden, place, width } => self.copy_value(&place, &hidden, width),
                Behind::TakeBack { place, data_type } => self.take_back_addresses(&place, &data_type),
            }
        }
    }

    /// Gives the parameters to the call that follows; how many they are.
    fn pass_all(&mut self, passed: &[Option<Pass>]) -> u16 {
        for pass in passed.iter().flatten() {
            let src = match *pass {
                Pass::Known(pointer) => self.constant(u64::from(pointer)),
                Pass::Number(position) => self.load_local(position, Width::Word),
            };
            self.push(Inst::PassParameter { src });
            self.release(src);
        }
        u16::try_from(passed.len()).unwrap_or(u16::MAX)
    }

    /// No temporary outlives a call, and nobody knows which data block is open.
    fn called(&mut self) {
        self.free.clear();
        self.temporaries = 0;
        self.open = None;
    }

    fn pass<'c>(&mut self, argument: &'c Argument, formal: &Variable, behind: &mut Vec<Behind<'c>>) -> Pass {
        match argument {
            Argument::Value { value, .. } | Argument::Number { value, .. } if formal.data_type.is_number() => match value.kind {
                ValueKind::Constant(number) => Pass::Known(number as u32 & 0xFFFF),
                _ => {
                    let number = self.value(value);
                    Pass::Number(self.spill(number, Width::Word))
                }
            },
            Argument::Value { value, .. } | Argument::Number { value, .. } => {
                let var = if is_address(&formal.data_type) { self.passed_pointer(value) } else { self.value(value) };
                // The value of a POINTER: its two parts.
                if formal.data_type == DataType::Pointer {
                    let hidden = self.hidden_bytes(POINTER_BYTES);
                    let (number, pointer) = self.reference_parts(var);
                    self.store_pointer(&hidden, number, pointer);
                    return Pass::Known(CALLER_LOCAL + hidden.offset);
                }
                let place = self.hidden_bytes(width(value.scalar).bytes());
                self.store_local(place.offset, width(value.scalar), var);
                self.pass_place(&place, formal)
            }
            Argument::Text { text, .. } => {
                let (place, _) = self.text(text);
                self.pass_place(&place, formal)
            }
            Argument::Aggregate { source, data_type, .. } if holds_address(data_type) => {
                let copy = self.hidden_bytes(bytes(data_type).clamp(1, VALUE_BYTES_MAX));
                self.copy_typed(&copy, source, data_type);
                self.pass_addresses(&copy, data_type);
                self.pass_pointer(&copy, data_type, None)
            }
            Argument::OutputAggregate { target, data_type, .. } if holds_address(data_type) => {
                let target = self.freeze(target);
                behind.push(Behind::TakeBack { place: target.clone(), data_type: data_type.clone() });
                self.pass_pointer(&target, data_type, None)
            }
            Argument::Aggregate { source, data_type, .. } | Argument::OutputAggregate { target: source, data_type, .. } => {
                self.pass_pointer(source, data_type, None)
            }
            Argument::Output { scalar, .. } => {
                let place = self.hidden_bytes(width(*scalar).bytes());
                let zero = self.constant(0);
                self.store_local(place.offset, width(*scalar), zero);
                if is_address(&formal.data_type) {
                    behind.push(Behind::TakeBack { place: place.clone(), data_type: formal.data_type.clone() });
                }
                behind.push(Behind::Take(place.clone(), argument));
                self.pass_place(&place, formal)
            }
            Argument::OutputText { room, .. } => {
                let place = self.empty_text(*room);
                behind.push(Behind::Take(place.clone(), argument));
                self.pass_place(&place, formal)
            }
            Argument::InOut { place, data_type, .. } if is_elementary(&formal.data_type) => match self.direct_pointer(place) {
                Some(pointer) => Pass::Known(pointer),
                None => {
                    let frozen = self.freeze(place);
                    let width = width_of_bits(data_type.bits() as u32);
                    let hidden = self.hidden_bytes(width.bytes());
                    self.copy_value(&hidden, &frozen, width);
                    let pointer = CALLER_LOCAL + hidden.offset;
                    behind.push(Behind::Return { hidden, place: frozen, width });
                    Pass::Known(pointer)
                }
            },
            Argument::InOut { place, data_type, .. } if self.may_lead_here(place, data_type) => {
                let place = self.freeze(place);
                let is_new = !behind.iter().any(|one| matches!(one, Behind::TakeBack { place: other, .. } if *other == place));
                if is_new {
                    self.pass_addresses(&place, data_type);
                    behind.push(Behind::TakeBack { place: place.clone(), data_type: data_type.clone() });
                }
                self.pass_pointer(&place, data_type, any_of(&formal.data_type, data_type))
            }
            Argument::InOut { place, data_type, .. } => self.pass_pointer(place, data_type, any_of(&formal.data_type, data_type)),
            Argument::Pointer { place, data_type, any, .. } => self.pass_pointer(place, data_type, *any),
            Argument::Eno { .. } => Pass::Known(0),
        }
    }

    /// A place in the hidden local data as actual parameter.
    fn pass_place(&mut self, place: &Place, formal: &Variable) -> Pass {
        if is_elementary(&formal.data_type) {
            let bits = u32::try_from(formal.data_type.bits()).unwrap_or(u32::MAX);
            self.seen.show(place.offset..place.offset.saturating_add(bits));
            match self.hidden_pointer_of(place) {
                Some(pointer) => Pass::Known(pointer),
                None => self.pass_pointer(place, &formal.data_type, None),
            }
        } else {
            self.pass_pointer(place, &formal.data_type, any_of(&formal.data_type, &formal.data_type))
        }
    }

    fn hidden_pointer_of(&self, place: &Place) -> Option<u32> {
        let local = place.base == Base::Area(sieben_model::address::Area::Local) && place.indexes.is_empty();
        local.then_some(CALLER_LOCAL + place.offset)
    }

    fn pass_pointer(&mut self, place: &Place, data_type: &DataType, any: Option<(u8, u32)>) -> Pass {
        Pass::Known(self.hidden_pointer(place, data_type, any))
    }

    /// A parameter that the call leaves out.
    fn pass_default(&mut self, formal: &Variable) -> Pass {
        if formal.data_type.is_number() {
            return Pass::Known(0);
        }
        let place = self.cleared(&formal.data_type);
        if matches!(formal.data_type, DataType::Pointer | DataType::Any) {
            return Pass::Known(CALLER_LOCAL + place.offset);
        }
        self.pass_place(&place, formal)
    }

    /// Takes a value out of the place where a called block left it.
    fn take_out(&mut self, from: &Place, argument: &Argument) {
        match argument {
            Argument::Output { scalar, target, convert, converted, .. } => self.take_value(from, *scalar, target, convert, *converted),
            Argument::OutputText { room, target, target_room, .. } => {
                let text = crate::st::tree::Text::Place { place: from.clone(), room: *room };
                self.assign_text(target, *target_room, &text);
            }
            Argument::OutputAggregate { target, data_type, .. } => self.copy_typed(target, from, data_type),
            _ => {}
        }
    }

    fn take_value(&mut self, from: &Place, scalar: Scalar, target: &Place, convert: &[Op], converted: Scalar) {
        let [from, target] = self.settle([from, target]);
        let mut value = self.load(&from, width(scalar));
        for &op in convert {
            value = self.compute(op, &[value]);
        }
        self.store(&target, width(converted), value);
        self.release(value);
    }

    // Function blocks.

    fn call_instance(&mut self, block: BlockId, instance: &Place, dispatch: Option<&Dispatch>, call: &Call) {
        let instance = self.freeze(instance);
        let chosen = self.dispatched(dispatch, &instance);
        let interface = (self.known.interface)(block);
        let takes_address = |parameter: u32| {
            let formal = interface.iter().flat_map(|interface| interface.parameters()).find(|formal| formal.offset == parameter);
            formal.is_some_and(|formal| is_address(&formal.data_type))
        };
        let mut behind: Vec<&Argument> = Vec::new();
        let mut values: Vec<(Place, Place, Width)> = Vec::new();
        let mut shared: Vec<(Place, &DataType)> = Vec::new();
        for argument in &call.arguments {
            match argument {
                Argument::Value { parameter, value } => {
                    let var = match value.kind {
                        ValueKind::AddressOf(_) => self.passed_pointer(value),
                        _ if value.scalar == Scalar::U64 && takes_address(*parameter) => self.passed_pointer(value),
                        _ => self.value(value),
                    };
                    self.store(&at(&instance, *parameter), width(value.scalar), var);
                    self.release(var);
                }
                Argument::Number { parameter, value } => {
                    let var = self.value(value);
                    self.store(&at(&instance, *parameter), Width::Word, var);
                    self.release(var);
                }
                Argument::Text { parameter, text, room } => self.assign_text(&at(&instance, *parameter), *room, text),
                Argument::Aggregate { parameter, source, data_type } => {
                    let inside = at(&instance, *parameter);
                    self.copy_typed(&inside, source, data_type);
                    self.pass_addresses(&inside, data_type);
                }
                Argument::InOut { parameter, place, data_type } if is_elementary(data_type) => {
                    let frozen = self.freeze(place);
                    let width = width_of_bits(data_type.bits() as u32);
                    let inside = at(&instance, *parameter);
                    self.copy_value(&inside, &frozen, width);
                    values.push((frozen, inside, width));
                }
                Argument::InOut { parameter, place, data_type } if self.may_lead_here(place, data_type) => {
                    let frozen = self.freeze(place);
                    if !shared.iter().any(|(other, _)| *other == frozen) {
                        self.pass_addresses(&frozen, data_type);
                        shared.push((frozen.clone(), data_type));
                    }
                    self.write_pointer(&at(&instance, *parameter), &frozen, data_type, any_of(data_type, data_type));
                }
                Argument::InOut { parameter, place, data_type } => {
                    self.write_pointer(&at(&instance, *parameter), place, data_type, any_of(data_type, data_type));
                }
                Argument::Pointer { parameter, place, data_type, any } => {
                    self.write_pointer(&at(&instance, *parameter), place, data_type, *any);
                }
                Argument::Output { .. } | Argument::OutputText { .. } | Argument::OutputAggregate { .. } => behind.push(argument),
                Argument::Eno { .. } => {}
            }
        }
        self.enter_chosen(block, &instance, chosen, &[]);
        for (place, data_type) in shared {
            self.take_back_addresses(&place, data_type);
        }
        for (place, inside, width) in values {
            self.copy_value(&place, &inside, width);
        }
        for argument in behind {
            let Some(position) = argument.parameter() else { continue };
            let from = at(&instance, position);
            match argument {
                Argument::OutputAggregate { target, data_type, .. } if holds_address(data_type) => {
                    let target = self.freeze(target);
                    self.copy_typed(&target, &from, data_type);
                    self.take_back_addresses(&target, data_type);
                }
                Argument::Output { target, scalar: Scalar::U64, parameter, .. } if takes_address(*parameter) => {
                    let target = self.freeze(target);
                    self.copy_value(&target, &from, Width::QuadWord);
                    self.take_back_address(&target);
                }
                _ => self.take_out(&from, argument),
            }
        }
    }

    /// Calls a function block or a method, or the one that the instance has chosen. Few ones are compared with its number and called by
    /// name: what is known of the block that is called is known of the call.
    fn enter_chosen(&mut self, block: BlockId, instance: &Place, chosen: Option<Chosen>, passed: &[Option<Pass>]) {
        let Some(chosen) = chosen else { return self.enter_instance(block, instance, None, passed) };
        let Some((last, others)) = chosen.few().and_then(<[u16]>::split_last) else {
            return self.enter_instance(block, instance, Some(chosen.position), passed);
        };
        let done = self.label();
        self.part();
        for &target in others {
            let next = self.label();
            let number = self.load_local(chosen.position, Width::Word);
            let one = self.constant(u64::from(target));
            let differs = self.compute(Op::Differ, &[number, one]);
            self.branch_on(differs, next, true);
            self.release(differs);
            self.fresh();
            self.enter_instance(BlockId { number: target, ..block }, instance, None, passed);
            self.leave_unless_failed(done);
            self.bind(next);
        }
        // The number was one of them.
        self.enter_instance(BlockId { number: *last, ..block }, instance, None, passed);
        self.leave_unless_failed(done);
        self.bind(done);
    }

    /// Calls a function block, or a method with its parameters, with its instance in DI and AR2. A block with an instance of its own
    /// has it again behind the call. `number` is where the hidden local data hold the number of the block, if the instance says it.
    fn enter_instance(&mut self, block: BlockId, instance: &Place, number: Option<u32>, passed: &[Option<Pass>]) {
        let ar2 = Var::from(Register::Ar2);
        if !self.has_instance {
            // Whoever called a function may need AR2 for its own instance.
            let saved = self.is_function.then(|| self.save_ar2());
            self.open_instance(instance);
            self.enter(block, number, passed);
            saved.into_iter().for_each(|saved| self.restore_ar2(saved));
            return;
        }
        // A method of the own instance, or the statements of the base.
        if instance.base == Base::Instance && instance.offset == 0 && instance.indexes.is_empty() {
            return self.enter(block, number, passed);
        }
        let saved = self.save_ar2();
        if instance.base == Base::Instance {
            // As in the macro of CALL: inside, the DB register holds the instance data block too. Blocks of ST never look at it.
            if number.is_none() && (self.known.is_stl)(block) {
                for (shared, instance) in REGISTER_PAIRS {
                    self.copy_var(shared.into(), instance.into());
                }
            }
            let indexed = self.indexes(instance, false, false);
            if let Some(index) = indexed.pointer {
                self.push(Inst::Compute { op: Op::AddU32, dst: ar2, args: super::arguments(&[ar2, index]) });
                self.release(index);
            }
            let offset = self.constant(u64::from(indexed.offset));
            self.push(Inst::Compute { op: Op::AddU32, dst: ar2, args: super::arguments(&[ar2, offset]) });
            self.release(offset);
            self.enter(block, number, passed);
            self.restore_ar2(saved);
            return;
        }
        // The DB register keeps the own instance over the call, as behind CDB.
        let own = REGISTER_PAIRS.map(|(_, instance)| self.compute_from(Op::Copy, &[instance.into()]));
        self.open_instance(instance);
        for ((shared, _), own) in REGISTER_PAIRS.into_iter().zip(own) {
            self.copy_var(shared.into(), own);
            self.release(own);
        }
        self.enter(block, number, passed);
        self.restore_ar2(saved);
        for (shared, instance) in REGISTER_PAIRS {
            self.copy_var(instance.into(), shared.into());
        }
    }

    /// Keeps AR2 in the hidden local data.
    fn save_ar2(&mut self) -> u32 {
        let position = self.hidden.scalar(Width::DoubleWord);
        let place = sieben_engine::ir::Place::Fixed { area: sieben_model::address::Area::Local, position };
        self.push(Inst::Store { place, width: Width::DoubleWord, src: Register::Ar2.into() });
        position
    }

    fn restore_ar2(&mut self, position: u32) {
        let old = self.load_local(position, Width::DoubleWord);
        self.copy_var(Register::Ar2.into(), old);
        self.release(old);
    }

    /// Enters the block, or the one of its kind whose number was found.
    fn enter(&mut self, block: BlockId, number: Option<u32>, passed: &[Option<Pass>]) {
        let parameters = self.pass_all(passed);
        let callee = match number {
            Some(position) => Called::Number(block.kind, self.load_local(position, Width::Word)),
            None => Called::Block(block),
        };
        self.push(Inst::Call { callee, parameters });
        self.called();
    }

    /// Opens the data block of an instance as DI and points AR2 at its begin.
    fn open_instance(&mut self, instance: &Place) {
        let ar2 = Var::from(Register::Ar2);
        let (number, pointer) = match &instance.base {
            Base::DataBlock(number) if instance.indexes.is_empty() => {
                (self.constant(u64::from(*number)), self.constant(INSTANCE_START + u64::from(instance.offset)))
            }
            _ => self.pointer_to(instance, false),
        };
        self.push(Inst::Open { register: DataRegister::Instance, number });
        self.release(number);
        self.copy_var(ar2, pointer);
        self.release(pointer);
    }
}

/// Whether a function gets a pointer to the value itself.
fn is_elementary(data_type: &DataType) -> bool {
    data_type.is_elementary()
}

/// What an ANY says of a value; `None` where the parameter is none.
fn any_of(formal: &DataType, data_type: &DataType) -> Option<(u8, u32)> {
    (*formal == DataType::Any).then(|| any_type(data_type))
}
