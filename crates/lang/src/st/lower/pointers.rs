//! Pointers to places, and what is reached by them as a whole: arrays, structures, POINTER and ANY.

use std::ops::Range;

use sieben_engine::ir::{Inst, Op, Place as Address, Target, Var};
use sieben_engine::machine::{CALLS_SHIFT, Register};
use sieben_model::address::{Area, Width};
use sieben_model::types::{DataType, ReferenceKind};

use super::places::Located;
use super::{Lowering, bytes, width_of_bits};
use crate::calling::pointers::{
    ADDRESS_MASK, ANY_BYTES, ANY_OF_S7, ANY_PARTS, AREA_SHIFT, CALLER_LOCAL, IN_DATA_BLOCK, POINTER_BYTES, POINTER_PARTS,
};
use crate::st::check::places::element_step;
use crate::st::tree::{Base, Local, Place, Value, ValueKind};

/// The bits of a pointer to the local data of a caller that count the calls to that caller, but the last one.
const CALLED_MASK: u64 = 0x00F8_0000;

/// The bit behind a variable in the local data.
fn end_of(local: &Local) -> u32 {
    local.position.saturating_add(u32::try_from(local.data_type.bits()).unwrap_or(u32::MAX))
}

impl Lowering<'_> {
    /// The data block number and the area-crossing pointer of a place. `outward` is for a block that is called, which sees the local
    /// data of this one as those of its caller.
    pub(super) fn pointer_to(&mut self, place: &Place, outward: bool) -> (Var, Var) {
        let [place] = &self.settle([place]);
        let indexed = self.indexes(place, false, false);
        if let Some(gate) = indexed.gate {
            // A pointer outside an array is that to its first element; the gate has cleared ENO/OK.
            self.release(gate);
        }
        let offset = indexed.offset;
        let (number, start) = match &place.base {
            Base::Area(area) => {
                let code = if *area == Area::Local {
                    self.show_variable(place);
                    if outward { CALLER_LOCAL } else { u32::from(Area::Local.pointer_code()) << 24 }
                } else {
                    u32::from(area.pointer_code()) << 24
                };
                (self.constant(0), self.constant(u64::from(code + offset)))
            }
            Base::DataBlock(number) => (self.constant(u64::from(*number)), self.constant(u64::from(IN_DATA_BLOCK + offset))),
            Base::ComputedDataBlock(number) => (self.value(number), self.constant(u64::from(IN_DATA_BLOCK + offset))),
            Base::Instance => {
                let number = self.compute_from(Op::Copy, &[Register::DiNumber.into()]);
                let address = self.compute_with(Op::AndU32, Register::Ar2.into(), ADDRESS_MASK);
                (number, self.compute_with(Op::AddU32, address, u64::from(IN_DATA_BLOCK + offset)))
            }
            Base::Parameter(index) => {
                let pointer = self.parameter(*index);
                let pointer = self.moved(pointer, offset);
                (self.constant(0), self.passed_on(pointer, outward))
            }
            base @ (Base::ComplexParameter(_) | Base::InstancePointer(_)) => {
                self.fallible = true;
                let (number, pointer) = self.pointer_behind(base);
                let pointer = self.moved(pointer, offset);
                (number, self.passed_on(pointer, outward))
            }
            Base::Reference(reference) => {
                let reference = self.value(reference);
                let (number, pointer) = self.reference_parts(reference);
                (number, self.moved(pointer, offset))
            }
        };
        match indexed.pointer {
            Some(index) => (number, self.compute(Op::AddU32, &[start, index])),
            None => (number, start),
        }
    }

    fn moved(&mut self, pointer: Var, offset: u32) -> Var {
        if offset == 0 { pointer } else { self.compute_with(Op::AddU32, pointer, u64::from(offset)) }
    }

    fn passed_on(&mut self, pointer: Var, outward: bool) -> Var {
        if outward { self.compute(Op::PassOnPointer, &[pointer]) } else { pointer }
    }

    /// All values that the checker keeps, if a position belongs to one of them.
    fn kept_at(&self, position: u32) -> Option<Range<u32>> {
        let first = self.body.locals.iter().map(end_of).max().unwrap_or(0);
        let kept = first..self.body.local_size.saturating_mul(8);
        kept.contains(&position).then_some(kept)
    }

    /// A pointer may lead to the variable in the local data to which this place belongs, or to the piece of hidden local data.
    fn show_variable(&mut self, place: &Place) {
        let position = place.offset;
        let mut variables = self.body.locals.iter().map(|local| local.position..end_of(local));
        let variable = variables.find(|bits| bits.contains(&position));
        match variable.or_else(|| self.kept_at(position)).or_else(|| self.hidden.shown_at(position)) {
            Some(bits) => self.seen.show(bits),
            None => self.seen.show_all(),
        }
    }

    /// The pointer to a place in 64 bits: the number of its data block in bits 32 to 47.
    pub(super) fn address_of(&mut self, place: &Place, outward: bool) -> Var {
        if let (Base::DataBlock(number), true) = (&place.base, place.indexes.is_empty()) {
            return self.constant(u64::from(*number) << 32 | u64::from(IN_DATA_BLOCK + place.offset));
        }
        let (number, pointer) = self.pointer_to(place, outward);
        let high = self.compute_with(Op::Shl64, number, 32);
        self.compute(Op::OrU64, &[high, pointer])
    }

    /// A pointer as the block that is called has to see it: the local data of this one are those of its caller.
    pub(super) fn passed_pointer(&mut self, value: &Value) -> Var {
        let var = match &value.kind {
            ValueKind::Constant(_) => return self.value(value),
            ValueKind::AddressOf(place) if !matches!(place.base, Base::Reference(_)) => return self.address_of(place, true),
            _ => self.value(value),
        };
        self.passed_address(var)
    }

    /// The addresses in a structure or an array that a called block has got a copy of, as that block has to see them.
    pub(super) fn pass_addresses(&mut self, copy: &Place, data_type: &DataType) {
        let mut offsets = Vec::new();
        addresses_in(data_type, 0, &mut offsets);
        for offset in offsets {
            let place = at(copy, offset);
            let address = self.load(&place, Width::QuadWord);
            let passed = self.passed_address(address);
            self.store(&place, Width::QuadWord, passed);
            self.release(passed);
        }
    }

    /// Whether a structure or an array that a called block works on itself may hold addresses of local data.
    pub(super) fn may_lead_here(&self, place: &Place, data_type: &DataType) -> bool {
        let outside = match &place.base {
            Base::Area(area) => *area != Area::Local,
            Base::DataBlock(_) | Base::ComputedDataBlock(_) | Base::Instance => true,
            _ => false,
        };
        // What lies outside has got them from this block.
        holds_address(data_type) && !(outside && self.body.locals.is_empty())
    }

    /// The addresses in what a called block has worked on itself, as this one has to see them: what was its caller's is this block's own.
    /// An address of the called block's own local data leads nowhere.
    pub(super) fn take_back_addresses(&mut self, place: &Place, data_type: &DataType) {
        let mut offsets = Vec::new();
        addresses_in(data_type, 0, &mut offsets);
        offsets.into_iter().for_each(|offset| self.take_back_address(&at(place, offset)));
    }

    /// One of them.
    pub(super) fn take_back_address(&mut self, place: &Place) {
        let address = self.load(place, Width::QuadWord);
        let own = self.taken_back(address);
        self.store(place, Width::QuadWord, own);
        self.release(own);
    }

    fn taken_back(&mut self, var: Var) -> Var {
        let pointer = self.compute_from(Op::Low32, &[var]);
        let shift = self.constant(AREA_SHIFT);
        let area = self.compute_from(Op::Shr32, &[pointer, shift]);
        self.release(shift);
        let lost = self.constant(u64::from(Area::Local.pointer_code()));
        let is_lost = self.compute_from(Op::Equal, &[area, lost]);
        self.release(lost);
        let of_caller = self.compute_with(Op::Equal, area, u64::from(CALLER_LOCAL >> AREA_SHIFT));
        // One call less, or no call any more.
        let counted = self.compute_with(Op::AndU32, pointer, CALLED_MASK);
        let none = self.compute_with(Op::Equal, counted, 0);
        let (own, one) = (self.constant(1 << AREA_SHIFT), self.constant(1 << CALLS_SHIFT));
        let less = self.compute(Op::Select, &[none, own, one]);
        let zero = self.constant(0);
        let less = self.compute(Op::Select, &[of_caller, less, zero]);
        let address = self.compute(Op::SubU64, &[var, less]);
        let nowhere = self.constant(0);
        self.compute(Op::Select, &[is_lost, nowhere, address])
    }

    fn passed_address(&mut self, var: Var) -> Var {
        let (number, pointer) = self.reference_parts(var);
        let shift = self.constant(AREA_SHIFT);
        let area = self.compute_from(Op::Shr32, &[pointer, shift]);
        self.release(shift);
        let own = self.compute_with(Op::Equal, area, u64::from(Area::Local.pointer_code()));
        let passed = self.compute(Op::PassOnPointer, &[pointer]);
        let outward = self.compute_with(Op::Shl32, own, AREA_SHIFT);
        let passed = self.compute(Op::AddU32, &[passed, outward]);
        let high = self.compute_with(Op::Shl64, number, 32);
        self.compute(Op::OrU64, &[high, passed])
    }

    /// The address of several bytes, for a move or a text instruction: data blocks are named in the pointer, nothing is opened.
    /// Behind a wrong index that is to be skipped the rest of the source statement is left out.
    pub(super) fn locate_bytes(&mut self, place: &Place, bytes: u32, write: bool) -> Located {
        let [place] = &self.settle([place]);
        self.fallible |= !matches!(place.base, Base::Area(_) | Base::Instance | Base::DataBlock(_) | Base::Parameter(_));
        let bits = bytes.saturating_mul(8);
        let mut located = match &place.base {
            Base::Area(_) | Base::Instance | Base::Parameter(_) => self.locate(place, bits, write),
            _ => {
                // The indexes are checked for what is done with the place.
                let indexed = self.indexes(place, write, false);
                let bare = Place { offset: indexed.offset, indexes: Vec::new(), ..place.clone() };
                let mut pointer = self.address_of(&bare, false);
                if let Some(index) = indexed.pointer {
                    // The low half alone: an index below the first one must not reach the number of the data block.
                    let low = self.compute_from(Op::AddU32, &[pointer, index]);
                    let shift = self.constant(32);
                    let number = self.compute_from(Op::Shr64, &[pointer, shift]);
                    self.release(pointer);
                    let high = self.compute(Op::Shl64, &[number, shift]);
                    self.release(index);
                    pointer = self.compute(Op::OrU64, &[high, low]);
                }
                Located {
                    address: Address::Crossing { pointer, offset: 0 },
                    block: super::places::Block::Any,
                    gate: indexed.gate,
                    pointer: Some(pointer),
                }
            }
        };
        if let Some(gate) = located.gate.take() {
            let outside = self.compute(Op::Not, &[gate]);
            self.push(Inst::Branch { condition: outside, to: Target(self.behind.0) });
            self.release(outside);
        }
        located
    }

    /// The places, computed as far as needed to use them in one IR statement.
    pub(super) fn settle<const N: usize>(&mut self, places: [&Place; N]) -> [Place; N] {
        let breaks = places.iter().any(|place| self.place_breaks(place));
        places.map(|place| if breaks { self.freeze(place) } else { place.clone() })
    }

    /// `target := source`, so many bytes, as if through a temporary.
    pub(super) fn copy_bytes(&mut self, target: &Place, source: &Place, bytes: u32) {
        if bytes == 0 {
            return;
        }
        let [source, target] = self.settle([source, target]);
        let from = self.locate_bytes(&source, bytes, false);
        let to = self.locate_bytes(&target, bytes, true);
        self.push(Inst::Move { from: from.address, to: to.address, bytes });
        self.release_pointer(&from);
        self.release_pointer(&to);
    }

    /// Writes a POINTER (6 bytes) or ANY (10 bytes) to a place, for a block that is called.
    pub(super) fn write_pointer(&mut self, to: &Place, place: &Place, data_type: &DataType, any: Option<(u8, u32)>) {
        let passes_on = *data_type == if any.is_some() { DataType::Any } else { DataType::Pointer };
        if passes_on && self.copy_pointer(to, place, any.is_some()) {
            return;
        }
        let start = if let Some((code, count)) = any {
            let head = self.constant(ANY_OF_S7 | u64::from(code));
            self.store(to, Width::Word, head);
            self.release(head);
            let count = self.constant(u64::from(count));
            self.store(&at(to, 16), Width::Word, count);
            self.release(count);
            32
        } else {
            0
        };
        let (number, pointer) = self.pointer_to(place, true);
        self.store_pointer(&at(to, start), number, pointer);
    }

    /// Stores the two parts of a POINTER and uses them up.
    pub(super) fn store_pointer(&mut self, to: &Place, number: Var, pointer: Var) {
        for ((offset, width), var) in POINTER_PARTS.into_iter().zip([number, pointer]) {
            self.store(&at(to, offset), width, var);
            self.release(var);
        }
    }

    /// Copies a POINTER or ANY that this block was given or has put together itself: what is passed on is what it points to.
    fn copy_pointer(&mut self, to: &Place, place: &Place, any: bool) -> bool {
        // A parameter of a function points to its six or ten bytes at once.
        if !matches!(place.base, Base::Parameter(_) | Base::Instance | Base::Area(Area::Local)) {
            return false;
        }
        let own = place.base == Base::Area(Area::Local);
        let parts: &[(u32, Width)] = if any { &ANY_PARTS } else { &POINTER_PARTS };
        for &(offset, width) in parts {
            let mut value = self.load(&at(place, offset), width);
            let is_pointer = width == Width::DoubleWord && offset > 0;
            if is_pointer && !own {
                value = self.compute(Op::PassOnPointer, &[value]);
            }
            self.store(&at(to, offset), width, value);
            self.release(value);
        }
        true
    }

    /// Room for a POINTER in hidden local data, and its place there.
    pub(super) fn hidden_bytes(&mut self, bytes: u32) -> Place {
        let offset = self.hidden.shown(bytes);
        self.seen.show(offset..offset.saturating_add(bytes.saturating_mul(8)));
        Place { base: Base::Area(Area::Local), offset, indexes: Vec::new(), span: self.span }
    }

    /// A POINTER or ANY to a place in hidden local data; the pointer to it for a block that is called.
    pub(super) fn hidden_pointer(&mut self, place: &Place, data_type: &DataType, any: Option<(u8, u32)>) -> u32 {
        let hidden = self.hidden_bytes(if any.is_some() { ANY_BYTES } else { POINTER_BYTES });
        self.write_pointer(&hidden, place, data_type, any);
        CALLER_LOCAL + hidden.offset
    }

    /// The pointer that a block that is called can use as it is, if the place does not depend on data blocks, AR2 or parameters.
    pub(super) fn direct_pointer(&mut self, place: &Place) -> Option<u32> {
        let Base::Area(area) = place.base else { return None };
        if !place.indexes.is_empty() || matches!(area, Area::CallerLocal | Area::SharedData | Area::InstanceData) {
            return None;
        }
        if area == Area::Local {
            self.show_variable(place);
            return Some(CALLER_LOCAL + place.offset);
        }
        Some((u32::from(area.pointer_code()) << 24) + place.offset)
    }

    /// Copies an elementary value.
    pub(super) fn copy_value(&mut self, target: &Place, source: &Place, width: Width) {
        let value = self.load(source, width);
        self.store(target, width, value);
        self.release(value);
    }

    /// Copies a value of any type: a number as such, all else as bytes.
    pub(super) fn copy_typed(&mut self, target: &Place, source: &Place, data_type: &DataType) {
        match data_type.bits() {
            bits @ (1 | 8 | 16 | 32 | 64) => self.copy_value(target, source, width_of_bits(bits as u32)),
            _ => self.copy_bytes(target, source, bytes(data_type)),
        }
    }
}

/// The place so many bits further on.
pub(super) fn at(place: &Place, bits: u32) -> Place {
    Place { offset: place.offset.saturating_add(bits), ..place.clone() }
}

/// How many addresses in one parameter are looked at: each is a dozen instructions.
const ADDRESSES_MAX: usize = 64;

/// Whether a value is an address that may lead to local data.
pub(super) fn is_address(data_type: &DataType) -> bool {
    matches!(data_type, DataType::Reference(reference) if matches!(reference.kind, ReferenceKind::Pointer | ReferenceKind::Reference))
}

/// Whether a structure or an array holds such an address.
pub(super) fn holds_address(data_type: &DataType) -> bool {
    let mut offsets = Vec::new();
    addresses_in(data_type, 0, &mut offsets);
    !offsets.is_empty()
}

/// Where addresses lie in a structure or an array, in bits.
pub(super) fn addresses_in(data_type: &DataType, start: u32, offsets: &mut Vec<u32>) {
    match data_type {
        _ if offsets.len() >= ADDRESSES_MAX => {}
        DataType::Struct(structure) => {
            structure.fields.iter().for_each(|field| addresses_in(&field.data_type, start.saturating_add(field.offset), offsets));
        }
        DataType::Array { bounds, element } => {
            let mut of_one = Vec::new();
            addresses_in(element, 0, &mut of_one);
            if of_one.is_empty() {
                return;
            }
            let step = element_step(element);
            let count = bounds.iter().map(|&(low, high)| i64::from(high) - i64::from(low) + 1).product::<i64>();
            for index in 0..u32::try_from(count).unwrap_or(u32::MAX).min(ADDRESSES_MAX as u32) {
                offsets.extend(of_one.iter().map(|offset| start.saturating_add(index.saturating_mul(step)).saturating_add(*offset)));
            }
        }
        _ if is_address(data_type) => offsets.push(start),
        _ => {}
    }
}
