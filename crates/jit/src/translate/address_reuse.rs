//! Common subexpression elimination for addresses: fields of the same element of an array have one base, so that what was read or written
//! of them is available, and bits that share a byte are written together. A block that is called for an element counts from there as well.

use std::ops::Range;

use cranelift_codegen::ir::types::{I16, I32};
use cranelift_codegen::ir::{InstructionData, Opcode, Value};
use sieben_engine::ir::{Callee, Inst};
use sieben_model::address::Width;
use sieben_model::block::BlockKind;

use super::Translator;
use super::bounds_checks::AffineSum;
use super::congruence::Congruence;
use super::memory::{Address, Bit};
use super::scalar_promotion::{Base, ComputedAddress};
use super::value::Val;
use crate::passes::Pass;

/// Elements that are remembered, the newest ones.
const KNOWN_MAX: usize = 6;

/// What an address is made of: the first byte of its area, or the address of the instance of which it is a part; a constant; and values
/// times constants.
#[derive(Clone, Debug, PartialEq, Eq)]
struct AddressSum {
    start: Start,
    constant: u32,
    terms: Vec<(Value, bool, u32)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Start {
    Area(i32),
    Instance(Value),
}

impl AddressSum {
    /// How many bytes it lies behind another one, if that is a constant. Both are inside their area, which is shorter than what positions
    /// count.
    fn behind(&self, other: &Self) -> Option<i32> {
        let distance = (self.constant.wrapping_sub(other.constant) << 8) as i32 >> 8;
        (self.start == other.start && self.terms == other.terms).then_some(distance / 8)
    }
}

/// Elements whose address the running code has computed.
#[derive(Clone, Debug, Default)]
pub(super) struct AvailableAddresses(Vec<(AddressSum, ComputedAddress)>);

impl AvailableAddresses {
    /// Keeps what others know, too.
    pub(super) fn keep_common(&mut self, other: &Self) {
        self.0.retain(|known| other.0.contains(known));
    }

    /// Forgets everything: other code goes on.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }
}

impl Translator<'_> {
    /// The address of a field of an element that is known to stay inside its area, and touches nothing else than these bytes.
    pub(super) fn field(
        &mut self,
        area: (Value, i32, u64),
        (pointer, offset): (Val, u32),
        (width, count): (Width, u32),
        (touched, bytes): &(Base, Range<i64>),
        write: bool,
    ) -> Option<Address> {
        let is_part = offset < 1 << 19 && (width == Width::Bit || offset % 8 == 0);
        if !self.options.does(Pass::AddressReuse) || self.cold.is_some() || !is_part {
            return None;
        }
        let pointer = self.int(pointer);
        let byte = i64::from(offset / 8);
        // A number alone has nothing to be put together with, and one more address would keep a register. What is written before a
        // call is mostly for the called block.
        let pays = |this: &Self| width == Width::Bit || write && this.calls_with_instance() || this.is_in_structure(area.1, pointer, width);
        if let Base::Computed(instance) = touched
            && self.ranges.is_relative()
        {
            let mut sum = self.behind_instance(pointer).filter(|sum| !sum.terms.is_empty())?;
            if self.known_part(instance.address, &sum).is_none() && !pays(self) {
                return None;
            }
            sum.constant = sum.constant.wrapping_add(offset & !7);
            let (element, offset_of_byte, _) = self.part_of_sum(&sum).filter(|&(.., left)| left >= u64::from(count))?;
            return Some(Address { base: element.address, offset: offset_of_byte, bit: Bit::Number((offset % 8) as u8) });
        }
        if touched.area() != Base::Arena || area.0 != self.arena || self.known_element(area.1, pointer).is_none() && !pays(self) {
            return None;
        }
        let there = bytes.start - byte..bytes.end - i64::from(count) - byte;
        let spacing = touched.begin().moved(-byte);
        let (computed, first) = self.element(area, pointer, (there, spacing))?;
        let offset_of_byte = first.checked_add(byte as i32)?;
        Some(Address { base: computed.address, offset: offset_of_byte, bit: Bit::Number((offset % 8) as u8) })
    }

    /// Whether an element of an array is more than a number.
    fn is_in_structure(&self, start: i32, pointer: Value, width: Width) -> bool {
        self.made_of(start, pointer).is_some_and(|made| made.terms.iter().all(|&(.., times)| times > 2 * width.bits()))
    }

    /// Whether the running statement calls a block with an instance.
    fn calls_with_instance(&self) -> bool {
        let calls = |inst: &Inst| matches!(inst, Inst::Call { callee: Callee::Block(id), .. } if id.kind == BlockKind::FunctionBlock);
        self.native().code.statement(self.statement as usize).iter().any(calls)
    }

    /// The first byte of an element to which a pointer goes that is known to lie there: an address, and how many bytes behind that.
    pub(super) fn element(
        &mut self,
        area: (Value, i32, u64),
        pointer: Value,
        (there, spacing): (Range<i64>, Congruence),
    ) -> Option<(ComputedAddress, i32)> {
        if let Some(known) = self.known_element(area.1, pointer) {
            return Some(known);
        }
        let made = self.made_of(area.1, pointer)?;
        let address = self.byte_address(area, pointer)?;
        let computed = ComputedAddress { address, least: there.start, most: there.end, spacing, part_of: None };
        self.remember_element(made, computed);
        Some((computed, 0))
    }

    fn remember_element(&mut self, made: AddressSum, computed: ComputedAddress) {
        self.computed.insert(computed.address, computed);
        if self.elements.0.len() == KNOWN_MAX {
            self.elements.0.remove(0);
        }
        self.elements.0.push((made, computed));
    }

    /// The part of an instance, which begins at an address, that lies as far behind it as a sum without its constant says, if its address
    /// has been computed.
    pub(super) fn known_part(&self, instance: Value, sum: &AffineSum) -> Option<ComputedAddress> {
        let terms = self.terms_of(sum);
        let is_it = |made: &AddressSum| made.start == Start::Instance(instance) && made.terms == terms;
        self.elements.0.iter().rev().find_map(|&(ref made, computed)| is_it(made).then_some(computed))
    }

    /// Notes the address of such a part.
    pub(super) fn remember_part(&mut self, instance: Value, sum: &AffineSum, computed: ComputedAddress) {
        let made = AddressSum { start: Start::Instance(instance), constant: 0, terms: self.terms_of(sum) };
        self.remember_element(made, computed);
    }

    /// An element that is known, or a place a constant behind or before it: other fields, elements of other arrays with the same
    /// index.
    fn known_element(&self, start: i32, pointer: Value) -> Option<(ComputedAddress, i32)> {
        let made = self.made_of(start, pointer)?;
        self.elements.0.iter().rev().find_map(|&(ref known, computed)| Some((computed, made.behind(known)?)))
    }

    /// What the address of a byte is made of, if it is not the same in each iteration of a loop.
    fn made_of(&self, start: i32, pointer: Value) -> Option<AddressSum> {
        let mut sum = AffineSum::default();
        if !self.decompose(pointer, 1, &mut sum, 0) {
            return None;
        }
        let whole = sum.constant % 8 == 0 && sum.terms.iter().all(|&(_, times)| times % 8 == 0);
        let terms = self.terms_of(&sum);
        let start = Start::Area(start);
        (whole && !terms.is_empty()).then_some(AddressSum { start, constant: sum.constant & 0x00FF_FFFF, terms })
    }

    /// The values of a sum and what they are multiplied by, in an order.
    fn terms_of(&self, sum: &AffineSum) -> Vec<(Value, bool, u32)> {
        let term = |&(value, times): &(Value, u32)| {
            let (value, extended) = self.without_extension(value);
            (value, extended, times)
        };
        let mut terms: Vec<(Value, bool, u32)> = sum.terms.iter().map(term).collect();
        terms.sort_unstable();
        terms
    }

    /// The number whose low 16 bits a value is with their sign, if it is: an index is extended in each statement.
    fn without_extension(&self, value: Value) -> (Value, bool) {
        let dfg = &self.b.func.dfg;
        let unary = |value: Value, expected: Opcode| match self.definition(value) {
            Some((_, InstructionData::Unary { opcode, arg })) if opcode == expected => Some(arg),
            _ => None,
        };
        let number =
            unary(value, Opcode::Sextend).filter(|&half| dfg.value_type(half) == I16).and_then(|half| unary(half, Opcode::Ireduce));
        match number.filter(|&number| dfg.value_type(number) == I32) {
            Some(number) => (dfg.resolve_aliases(number), true),
            None => (dfg.resolve_aliases(value), false),
        }
    }
}
