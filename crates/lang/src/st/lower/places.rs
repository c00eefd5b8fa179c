//! Where variables lie: addresses, indexes, access.

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{DataRegister, Inst, OnFault, Op, Place as Address, Var};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::{Lowering, arguments};
use crate::st::tree::{Base, Bounds, Index, Place, Scalar, Value};

/// Area length error, reading; one more when writing.
const OUTSIDE: u8 = 0x22;

/// An address that an access can use, once its data block is open.
pub(super) struct Located {
    pub(super) address: Address,
    /// What the DB register must hold.
    pub(super) block: Block,
    /// The access takes place only if this bit is 1.
    pub(super) gate: Option<Var>,
    /// The temporary of the address.
    pub(super) pointer: Option<Var>,
}

/// What the DB register must hold for an access.
pub(super) enum Block {
    /// Anything.
    Any,
    /// This data block.
    Number(u16),
    /// The data block with this number.
    Computed(Var),
}

/// What the indexes of a place add to its offset.
pub(super) struct Indexed {
    /// Bits, as a 32-bit number that may be negative.
    pub(super) pointer: Option<Var>,
    pub(super) offset: u32,
    pub(super) gate: Option<Var>,
}

impl Lowering<'_> {
    /// What a place holds, in a temporary.
    pub(super) fn load(&mut self, place: &Place, width: Width) -> Var {
        let located = self.locate(place, width.bits(), false);
        self.open_block(&located.block);
        let dst = self.temporary();
        self.push(Inst::Load { dst, place: located.address, width, on_fault: OnFault::SkipStatement });
        self.release_pointer(&located);
        match located.gate {
            Some(gate) => self.compute(Op::Gate, &[dst, gate]),
            None => dst,
        }
    }

    /// Writes a value, which stays, to a place.
    pub(super) fn store(&mut self, place: &Place, width: Width, src: Var) {
        if let Some(gate) = self.store_inside(place, width, src) {
            self.release(gate);
        }
    }

    /// The same; the bit that is 1 if an element with an index that may be outside its array is there.
    pub(super) fn store_inside(&mut self, place: &Place, width: Width, src: Var) -> Option<Var> {
        let located = self.locate(place, width.bits(), true);
        self.open_block(&located.block);
        match located.gate {
            // Outside its array the first element gets what it holds.
            Some(gate) => {
                let old = self.temporary();
                self.push(Inst::Load { dst: old, place: located.address, width, on_fault: OnFault::SkipWrite });
                let new = self.compute_from(Op::Select, &[gate, src, old]);
                self.push(Inst::Store { place: located.address, width, src: new });
                self.release(old);
                self.release(new);
            }
            None => self.push(Inst::Store { place: located.address, width, src }),
        }
        self.release_pointer(&located);
        located.gate
    }

    pub(super) fn release_pointer(&mut self, located: &Located) {
        if let Some(pointer) = located.pointer {
            self.release(pointer);
        }
    }

    /// Opens what an access needs, unless it is open.
    pub(super) fn open_block(&mut self, block: &Block) {
        match *block {
            Block::Any => {}
            Block::Number(number) if self.open == Some(number) => {}
            Block::Number(number) => {
                let var = self.constant(u64::from(number));
                self.push(Inst::Open { register: DataRegister::Shared, number: var });
                self.release(var);
                self.open = Some(number);
            }
            Block::Computed(var) => {
                self.push(Inst::Open { register: DataRegister::Shared, number: var });
                self.release(var);
                self.open = None;
            }
        }
    }

    /// The address of a place of so many bits.
    pub(super) fn locate(&mut self, place: &Place, bits: u32, write: bool) -> Located {
        match &place.base {
            Base::Area(area) => {
                if *area == Area::Local {
                    self.note_local(place, bits);
                }
                self.fallible |= matches!(area, Area::PeripheralInput | Area::PeripheralOutput);
                let indexed = self.indexes(place, write, true);
                self.in_area(*area, indexed, Block::Any)
            }
            Base::DataBlock(number) => {
                let indexed = self.indexes(place, write, true);
                self.in_area(Area::SharedData, indexed, Block::Number(*number))
            }
            Base::ComputedDataBlock(number) => {
                self.fallible = true;
                let (number, indexed) = self.with_indexes(number, place, write);
                self.in_area(Area::SharedData, indexed, Block::Computed(number))
            }
            Base::Instance => {
                let indexed = self.indexes(place, write, true);
                let ar2 = Register::Ar2.into();
                let pointer = match indexed.pointer {
                    Some(index) => self.compute(Op::AddU32, &[ar2, index]),
                    None => ar2,
                };
                Located {
                    address: Address::Indirect { area: Area::InstanceData, pointer, offset: indexed.offset },
                    block: Block::Any,
                    gate: indexed.gate,
                    pointer: Some(pointer),
                }
            }
            Base::Parameter(index) => {
                if let Some(copied) = self.copies.get(index) {
                    let offset = copied.position.saturating_add(place.offset);
                    let local = Place { base: Base::Area(Area::Local), offset, ..place.clone() };
                    return self.locate(&local, bits, write);
                }
                let indexed = self.indexes(place, write, false);
                let pointer = self.parameter(*index);
                self.crossing(pointer, indexed, Block::Any)
            }
            Base::ComplexParameter(_) | Base::InstancePointer(_) => {
                self.fallible = true;
                let indexed = self.indexes(place, write, false);
                let (number, pointer) = self.pointer_behind(&place.base);
                self.crossing(pointer, indexed, Block::Computed(number))
            }
            Base::Reference(reference) => {
                self.fallible = true;
                let (reference, indexed) = self.with_indexes(reference, place, write);
                let (number, pointer) = self.reference_parts(reference);
                self.crossing(pointer, indexed, Block::Computed(number))
            }
        }
    }

    fn in_area(&mut self, area: Area, indexed: Indexed, block: Block) -> Located {
        let address = match indexed.pointer {
            Some(pointer) => Address::Indirect { area, pointer, offset: indexed.offset },
            None => Address::Fixed { area, position: indexed.offset },
        };
        Located { address, block, gate: indexed.gate, pointer: indexed.pointer }
    }

    fn crossing(&mut self, pointer: Var, indexed: Indexed, block: Block) -> Located {
        let pointer = match indexed.pointer {
            Some(index) => self.compute(Op::AddU32, &[pointer, index]),
            None => pointer,
        };
        Located { address: Address::Crossing { pointer, offset: indexed.offset }, block, gate: indexed.gate, pointer: Some(pointer) }
    }

    /// The pointer that the caller gave for an elementary parameter.
    pub(super) fn parameter(&mut self, index: u16) -> Var {
        let dst = self.temporary();
        self.push(Inst::Parameter { dst, index });
        dst
    }

    /// Data block number and pointer of the POINTER behind a complex parameter.
    pub(super) fn pointer_behind(&mut self, base: &Base) -> (Var, Var) {
        let (from, offset) = match base {
            Base::ComplexParameter(index) => (Some(self.parameter(*index)), 0),
            Base::InstancePointer(position) => (None, *position),
            _ => unreachable!("only complex parameters have a POINTER"),
        };
        let at = |offset| match from {
            Some(pointer) => Address::Crossing { pointer, offset },
            None => Address::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset },
        };
        let [number, pointer] = [(at(offset), Width::Word), (at(offset + 16), Width::DoubleWord)].map(|(place, width)| {
            let dst = self.temporary();
            self.push(Inst::Load { dst, place, width, on_fault: OnFault::SkipStatement });
            dst
        });
        if let Some(from) = from {
            self.release(from);
        }
        (number, pointer)
    }

    /// Data block number and pointer of a reference, which is used up.
    pub(super) fn reference_parts(&mut self, reference: Var) -> (Var, Var) {
        let shift = self.constant(32);
        let number = self.compute_from(Op::Shr64, &[reference, shift]);
        self.release(shift);
        let pointer = self.compute(Op::Low32, &[reference]);
        (number, pointer)
    }

    /// The value of a base, then the indexes.
    fn with_indexes(&mut self, base: &Value, place: &Place, write: bool) -> (Var, Indexed) {
        if self.is_crowded() || place.indexes.iter().any(|index| self.breaks(&index.value)) {
            let base = self.keep(base);
            let indexed = self.indexes(place, write, false);
            return (self.value(&base), indexed);
        }
        let base = self.value(base);
        (base, self.indexes(place, write, false))
    }

    /// What the indexes add. With `folds` the lowest index may be taken off the offset: the area is known, so that an address
    /// below its begin wraps to one above its end.
    pub(super) fn indexes(&mut self, place: &Place, write: bool, folds: bool) -> Indexed {
        let mut all = Indexed { pointer: None, offset: place.offset, gate: None };
        if place.indexes.is_empty() {
            return all;
        }
        let values: Vec<&Value> = place.indexes.iter().map(|index| &index.value).collect();
        let vars = self.values(&values);
        for (index, var) in place.indexes.iter().zip(vars) {
            let Some(number) = self.index(index, var, write, folds, &mut all) else { continue };
            let bits = match index.step {
                1 => number,
                step if step.is_power_of_two() => self.compute_with(Op::Shl32, number, u64::from(step.trailing_zeros())),
                step => self.compute_with(Op::MulU32, number, u64::from(step)),
            };
            all.pointer = Some(match all.pointer {
                Some(sum) => self.compute(Op::AddU32, &[sum, bits]),
                None => bits,
            });
        }
        if let Some(gate) = all.gate {
            self.keep_ok_if(gate);
        }
        all
    }

    /// The number of the element, counted from the offset, which may move; `None` if the index is a constant and done with.
    fn index(&mut self, index: &Index, var: Var, write: bool, folds: bool, all: &mut Indexed) -> Option<Var> {
        let long = index.value.scalar == Scalar::I64;
        let low = index.low as u32;
        let high = index.low.saturating_add(i64::try_from(index.count).unwrap_or(i64::MAX)).saturating_sub(1);
        match index.check {
            Bounds::None => {
                if let crate::st::tree::ValueKind::Constant(bits) = index.value.kind {
                    let number = bits as u32;
                    let moved = i64::from(all.offset) + i64::from(number.wrapping_sub(low) as i32) * i64::from(index.step);
                    if let Ok(offset) = u32::try_from(moved) {
                        all.offset = offset;
                        self.release(var);
                        return None;
                    }
                }
                let number = if long { self.compute(Op::Low32, &[var]) } else { var };
                let moved = i64::from(all.offset) - index.low.saturating_mul(i64::from(index.step));
                match u32::try_from(moved) {
                    Ok(offset) if folds => {
                        all.offset = offset;
                        Some(number)
                    }
                    _ => Some(self.above(number, low)),
                }
            }
            Bounds::Clamp => {
                let (most, least) = if long { (Op::MinI64, Op::MaxI64) } else { (Op::MinI32, Op::MaxI32) };
                let bits = |limit: i64| if long { limit as u64 } else { u64::from(limit as u32) };
                let var = self.compute_with(least, var, bits(index.low));
                let var = self.compute_with(most, var, bits(high));
                let number = if long { self.compute(Op::Low32, &[var]) } else { var };
                Some(self.above(number, low))
            }
            Bounds::Fault | Bounds::Skip => {
                let number = if long { self.compute_from(Op::Low32, &[var]) } else { var };
                let above = if low == 0 {
                    self.compute_from(Op::Copy, &[number])
                } else {
                    let low = self.constant(u64::from(low));
                    let above = self.compute_from(Op::SubU32, &[number, low]);
                    self.release(low);
                    above
                };
                let count = self.constant(index.count);
                let mut inside = self.compute_from(Op::Below, &[above, count]);
                self.release(count);
                if long {
                    let too_long = self.compute_from(Op::OverflowsI32, &[var]);
                    inside = self.compute(Op::AndNot, &[inside, too_long]);
                }
                let above = if index.check == Bounds::Fault {
                    self.fallible = true;
                    self.push(Inst::Require { condition: inside, code: OUTSIDE + u8::from(write), register: number });
                    self.release(inside);
                    above
                } else {
                    let code = NOTED | (OUTSIDE + u8::from(write));
                    self.push(Inst::Require { condition: inside, code, register: number });
                    let gated = self.compute_from(Op::Gate, &[above, inside]);
                    self.release(above);
                    all.gate = Some(match all.gate {
                        Some(gate) => self.compute(Op::And, &[gate, inside]),
                        None => inside,
                    });
                    gated
                };
                self.release(number);
                self.release(var);
                Some(above)
            }
        }
    }

    /// The distance from the lowest index.
    fn above(&mut self, number: Var, low: u32) -> Var {
        if low == 0 { number } else { self.compute_with(Op::SubU32, number, u64::from(low)) }
    }

    /// A place whose indexes and base are computed now and stay the same until the end of the source statement.
    pub(super) fn freeze(&mut self, place: &Place) -> Place {
        let base = match &place.base {
            Base::ComputedDataBlock(value) => Base::ComputedDataBlock(Box::new(self.keep(value))),
            Base::Reference(value) => Base::Reference(Box::new(self.keep(value))),
            other => other.clone(),
        };
        let indexes = place.indexes.iter().map(|index| Index { value: self.keep(&index.value), ..index.clone() }).collect();
        Place { base, offset: place.offset, indexes, span: place.span }
    }

    /// Local data that an index may reach are seen by more than constant addresses.
    pub(super) fn note_local(&mut self, place: &Place, bits: u32) {
        if place.indexes.is_empty() {
            return;
        }
        let reach = place.indexes.iter().try_fold(0_u64, |reach, index| {
            let last = index.count.checked_sub(1)?;
            Some(reach.saturating_add(last.saturating_mul(u64::from(index.step))))
        });
        match reach.and_then(|reach| u32::try_from(reach.saturating_add(u64::from(bits))).ok()) {
            Some(reach) => self.seen.show(place.offset..place.offset.saturating_add(reach)),
            None => self.seen.show_all(),
        }
    }

    /// `dst := src`, both variables.
    pub(super) fn copy_var(&mut self, dst: Var, src: Var) {
        self.push(Inst::Compute { op: Op::Copy, dst, args: arguments(&[src]) });
    }
}
