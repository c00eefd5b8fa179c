//! What variables and expressions of Structured Text hold at a moment, as far as the machine tells without running anything.

use std::collections::BTreeMap;

use sieben_engine::ir::Place as IrPlace;
use sieben_engine::program::CodeBlock;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::source::Span;

use crate::access::Location;
use crate::declarations::interface::is_complex;
use crate::sentences::memory::{Found, Reader};
use crate::sentences::text::{Words, one_line, real};
use crate::sentences::{Moment, Surroundings};
use crate::st::tree::visit::{self, Extent, Use, Visit};
use crate::st::tree::{Base, Bounds, Index, Place, Scalar, Value, ValueKind};

/// Depth of expressions that are looked into; the parser allows more than anyone reads.
const DEPTH_MAX: u32 = 32;

/// Reads variables around one step.
pub(super) struct Values<'a> {
    around: Surroundings<'a>,
    moment: Moment<'a>,
    /// Position in the local data of each parameter of a function that was copied there.
    copies: BTreeMap<u16, u32>,
}

impl<'a> Values<'a> {
    pub(super) fn new(around: Surroundings<'a>, moment: &Moment<'a>, code: &CodeBlock) -> Self {
        Self { around, moment: *moment, copies: code.copied_parameters() }
    }

    pub(super) fn slice(&self, span: Span) -> &'a str {
        self.around.slice(span)
    }

    pub(super) fn has_before(&self) -> bool {
        self.moment.before.is_some()
    }

    /// `FC 1 "Dosing"`, or what the block is called in the source.
    pub(super) fn block_name(&self, block: BlockId) -> String {
        match self.around.block_names.get(&block) {
            Some(name) => name.clone(),
            None => block.to_string(),
        }
    }

    /// The machine before the step, or else the one behind it.
    fn before(&self) -> Reader<'a> {
        let event = self.moment.event;
        Reader::new(self.moment.before.unwrap_or(self.moment.after), &event.before, event.place.block, false)
    }

    /// Where a step writes a place that has a constant address.
    pub(super) fn constant_place(&self, place: &Place) -> Option<IrPlace> {
        let (area, position) = match place.base {
            Base::Area(area) => (area, place.offset),
            Base::Parameter(index) => (Area::Local, self.copies.get(&index)? + place.offset),
            _ => return None,
        };
        place.indexes.is_empty().then_some(IrPlace::Fixed { area, position })
    }

    /// What a place holds behind the step.
    pub(super) fn read_behind(&self, place: &Place, scalar: Scalar) -> Option<u64> {
        let event = self.moment.event;
        let reader = Reader::new(self.moment.after, &event.before, event.place.block, false);
        let found = self.find(place, 0)?;
        reader.read(&found, width(scalar))
    }

    /// The variables that an expression reads, with their values before the step. What the step itself may have changed is left out
    /// where the machine before it was not kept.
    pub(super) fn read_by(&self, value: &Value, target: Option<&Place>) -> Vec<(String, Words)> {
        let mut loads = Loads { depth: 0, found: Vec::new() };
        loads.value(value);
        let written = target.and_then(|target| self.find(target, 0));
        let mut out: Vec<(String, Words)> = Vec::new();
        for (place, scalar) in loads.found {
            let name = one_line(self.slice(place.span));
            if name.is_empty() || out.iter().any(|(other, _)| *other == name) {
                continue;
            }
            let Some(found) = self.find(place, 0) else { continue };
            if !self.has_before() && written.is_some_and(|written| written.area == found.area && written.db == found.db) {
                continue;
            }
            if let Some(bits) = self.before().read(&found, width(scalar)) {
                out.push((name, format_scalar(scalar, bits)));
            }
        }
        out
    }

    /// What an expression comes to, if that shows without running anything but operations.
    pub(super) fn compute(&self, value: &Value) -> Option<u64> {
        self.value(value, 0)
    }

    fn value(&self, value: &Value, depth: u32) -> Option<u64> {
        if depth > DEPTH_MAX {
            return None;
        }
        let of = |value: &Value| self.value(value, depth + 1);
        match &value.kind {
            ValueKind::Constant(bits) => Some(*bits),
            ValueKind::Load(place) => {
                // Without the machine before the step its own result could be taken for what it read.
                let found = self.find(place, depth + 1)?;
                self.before().read(&found, width(value.scalar))
            }
            ValueKind::Compute { op, args } | ValueKind::Checked { op, args, .. } => {
                let mut values = [0; 4];
                for (slot, arg) in values.iter_mut().zip(args.iter().take(op.arity())) {
                    *slot = of(arg)?;
                }
                Some(op.eval(values))
            }
            ValueKind::AndThen(a, b) => {
                if of(a)? & 1 == 0 {
                    Some(0)
                } else {
                    of(b)
                }
            }
            ValueKind::OrElse(a, b) => {
                if of(a)? & 1 == 1 {
                    Some(1)
                } else {
                    of(b)
                }
            }
            ValueKind::Choose { condition, a, b } => {
                if of(condition)? & 1 == 1 {
                    of(a)
                } else {
                    of(b)
                }
            }
            _ => None,
        }
    }

    /// The first index of a place that is outside its array, with what it is.
    pub(super) fn index_outside<'p>(&self, place: &'p Place) -> Option<(&'p Index, i64)> {
        place.indexes.iter().filter(|index| matches!(index.check, Bounds::Fault | Bounds::Skip)).find_map(|index| {
            let bits = self.value(&index.value, 0)?;
            let number = if index.value.scalar == Scalar::I64 { bits as i64 } else { i64::from(bits as u32 as i32) };
            let inside = number >= index.low && (number.saturating_sub(index.low) as u64) < index.count;
            (!inside).then_some((index, number))
        })
    }

    /// Whether the caller gave a POINTER for a parameter of the function.
    fn is_by_pointer(&self, index: u16) -> bool {
        let block = self.around.program.code.get(&self.moment.event.place.block);
        let mut parameters = block.into_iter().flat_map(|code| code.interface.parameters());
        parameters.any(|parameter| parameter.offset == u32::from(index) && is_complex(&parameter.data_type))
    }

    /// The address of a place.
    fn find(&self, place: &Place, depth: u32) -> Option<Found> {
        if depth > DEPTH_MAX {
            return None;
        }
        let registers = &self.moment.event.before;
        let mut offset = i64::from(place.offset);
        for index in &place.indexes {
            let bits = self.value(&index.value, depth + 1)?;
            let number = if index.value.scalar == Scalar::I64 { bits as i64 } else { i64::from(bits as u32 as i32) };
            let inside = index.count == 0 || (number >= index.low && ((number - index.low) as u64) < index.count);
            if !inside && index.check != Bounds::None {
                return None;
            }
            offset = offset.checked_add(number.checked_sub(index.low)?.checked_mul(i64::from(index.step))?)?;
        }
        let offset = u32::try_from(offset).ok()?;
        match &place.base {
            Base::Area(area) => Some(Found { area: *area, position: offset, db: 0 }),
            Base::DataBlock(db) => Some(Found { area: Area::SharedData, position: offset, db: *db }),
            Base::Instance => {
                let position = (registers.ar2 as u32 & 0x00FF_FFFF).checked_add(offset)?;
                Some(Found { area: Area::InstanceData, position, db: registers.di_number as u16 })
            }
            Base::Parameter(index) => match self.copies.get(index) {
                Some(position) => Some(Found { area: Area::Local, position: position.checked_add(offset)?, db: 0 }),
                // One that is used once is not copied: it lies where the caller's pointer leads.
                None => {
                    let location = Location::Parameter { index: *index, offset, complex: self.is_by_pointer(*index) };
                    self.before().find(&location, false).ok()
                }
            },
            _ => None,
        }
    }
}

/// The places that an expression loads, from left to right; what calls and texts do with theirs is not looked into.
struct Loads<'v> {
    depth: u32,
    found: Vec<(&'v Place, Scalar)>,
}

impl<'v> Visit<'v> for Loads<'v> {
    fn value(&mut self, value: &'v Value) {
        let is_closed = matches!(
            value.kind,
            ValueKind::Call(_) | ValueKind::CompareTexts(..) | ValueKind::Length(_) | ValueKind::AddressOf(_) | ValueKind::After(..)
        );
        if !is_closed && self.depth <= DEPTH_MAX {
            self.depth += 1;
            visit::value(self, value);
            self.depth -= 1;
        }
    }

    fn place(&mut self, place: &'v Place, _: Use, extent: Extent<'v>) {
        visit::indexes(self, place);
        if let Extent::Scalar(scalar) = extent {
            self.found.push((place, scalar));
        }
    }
}

fn width(scalar: Scalar) -> Width {
    match scalar.bits() {
        1 => Width::Bit,
        8 => Width::Byte,
        16 => Width::Word,
        32 => Width::DoubleWord,
        _ => Width::QuadWord,
    }
}

/// A value as Structured Text would write it.
pub(super) fn format_scalar(scalar: Scalar, bits: u64) -> Words {
    match scalar {
        Scalar::Bool => if bits & 1 == 1 { "TRUE" } else { "FALSE" }.into(),
        Scalar::I8 => (bits as u8 as i8).to_string().into(),
        Scalar::I16 => (bits as u16 as i16).to_string().into(),
        Scalar::I32 => (bits as u32 as i32).to_string().into(),
        Scalar::I64 => (bits as i64).to_string().into(),
        Scalar::F32 => real(bits).into(),
        Scalar::F64 => format!("{:?}", f64::from_bits(bits)).into(),
        // A number without sign may as well be a pattern of bits.
        Scalar::U8 | Scalar::U16 | Scalar::U32 | Scalar::U64 => match bits {
            0..=9 => bits.to_string().into(),
            _ => format!("{bits} (16#{bits:X})").into(),
        },
    }
}
