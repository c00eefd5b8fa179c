//! Gathers for four iterations in lanes: consecutive bits, as those of an array of BOOL, and loads and stores at addresses that each
//! iteration computes.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I32X4};
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_model::address::Width;

use super::super::Translator;
use super::super::memory::{Address, Bit, data};
use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::emission::Emitter;
use super::kernel::{Access, Kernel, Level, Node};
use super::scalar_evolution::Shape;
use super::vectorization::Lanes;
use crate::passes::Pass;

/// Vectorized iterations.
const ITERATIONS: u32 = 4;

impl Kernel {
    /// Whether iterations read or write bits that follow one another, and work with other variables, too: bits alone are done in bytes.
    pub(super) fn is_row_of_bits(&self, access: &Access) -> bool {
        let (base, bytes) = access.bytes();
        let is_row = self.passes.has(Pass::GatheredBits)
            && access.width == Width::Bit
            && access.part.is_none()
            && self.inner.is_none()
            && self.line(access.pointer, Level::Outer).is_some_and(|line| line.bits == 32 && line.step == 1);
        // The bits of four iterations may lie in two bytes.
        is_row
            && base == Base::Arena
            && usize::try_from(bytes.end + 1).is_ok_and(|end| end <= self.size)
            && (self.accesses.iter().any(|access| access.width != Width::Bit) || self.accesses.iter().all(|access| access.value.is_none()))
    }

    /// Whether iterations read something at addresses that are neither the same nor at equal distances.
    pub(super) fn is_gathered(&self, access: &Access) -> bool {
        access.value.is_none() && self.lies_anywhere(access)
    }

    /// Whether iterations write something at such addresses.
    pub(super) fn is_scattered(&self, access: &Access) -> bool {
        access.value.is_some() && access.width != Width::Bit && self.lies_anywhere(access)
    }

    fn lies_anywhere(&self, access: &Access) -> bool {
        let may = self.passes.has(Pass::GatheredBits) && self.inner.is_none() && access.sure && access.inside.is_some();
        may && match self.shape(access.pointer) {
            Some(Shape::Words) => true,
            Some(Shape::Affine(line)) => {
                let follows = access.width != Width::Bit && line.step == access.width.bytes() * 8;
                line.bits == 32 && !line.is_same() && !follows && self.apart(access).is_none() && !self.is_row_of_bits(access)
            }
            _ => false,
        }
    }

    /// Whether iterations are done four at a time.
    pub(super) fn is_by_four(&self) -> bool {
        let one = |access: &Access| self.is_row_of_bits(access) || self.is_gathered(access) || self.is_scattered(access);
        self.is_spread() || !self.in_order.nodes.is_empty() || self.accesses.iter().any(one)
    }

    /// Whether bits that an iteration touches later are none that one of the iterations beside it has touched before, which is done first
    /// then.
    pub(super) fn bits_stay_apart(&self, later: &Access, earlier: &Access) -> bool {
        let same = later.area == earlier.area && later.pointer == earlier.pointer;
        // Positions have 24 bits.
        let ahead = (later.offset.wrapping_sub(earlier.offset) << 8) as i32 >> 8;
        same && self.is_row_of_bits(later) && self.is_row_of_bits(earlier) && !(1..ITERATIONS as i32).contains(&ahead)
    }
}

impl Emitter<'_, '_, '_> {
    /// Reads or writes the bits of four iterations.
    pub(super) fn access_row_of_bits(&mut self, number: usize, level: Level) {
        let access = &self.kernel.accesses[number];
        let pointer = self.first(access.pointer, level);
        let address = self.address_at(access, pointer);
        let bits = self.t.row_of_bits(address);
        let Some(value) = access.value else {
            let node = self.kernel.read_of(number);
            let mask = self.t.mask_of_bits(bits);
            self.scope(level).values.insert(node, Lanes::Mask(vec![mask]));
            return;
        };
        let value = self.value(value, level);
        self.t.write_row_of_bits(address, bits, &value);
        self.forget_bytes(number, address, level);
    }

    /// Reads what each iteration needs at its own address.
    pub(super) fn gather(&mut self, number: usize, level: Level) {
        let access = &self.kernel.accesses[number];
        let pointers = self.value(access.pointer, level);
        let mut values: Vec<Val> = Vec::new();
        for lane in 0..self.lanes {
            let pointer = self.t.of_lane(&pointers, lane);
            let address = self.address_at(access, pointer);
            values.push(self.t.read(address, access.width));
        }
        let node = self.kernel.read_of(number);
        let value = self.t.side_by_side(self.kernel.shape_by_width(node), &values);
        self.scope(level).values.insert(node, value);
    }

    /// Writes what each iteration leaves at its own address.
    pub(super) fn scatter(&mut self, number: usize, value: Node, level: Level) {
        let access = &self.kernel.accesses[number];
        let pointers = self.value(access.pointer, level);
        let value = self.value(value, level);
        for lane in 0..self.lanes {
            let pointer = self.t.of_lane(&pointers, lane);
            let address = self.address_at(access, pointer);
            let own = self.t.of_lane(&value, lane);
            self.t.write(address, access.width, own);
            self.forget_bytes(number, address, level);
        }
        self.forget_around(number);
    }
}

impl Translator<'_> {
    /// The number of the first bit in its byte, and two bytes from there.
    fn row_of_bits(&mut self, Address { base, offset, bit }: Address) -> (Value, Value) {
        let number = match bit {
            Bit::Computed(number) => number,
            Bit::Number(number) => self.b.ins().iconst(I32, i64::from(number)),
        };
        (number, self.b.ins().uload16(I32, data(), base, offset))
    }

    fn mask_of_bits(&mut self, (number, bytes): (Value, Value)) -> Value {
        let bits = self.b.ins().ushr(bytes, number);
        let all = self.b.ins().splat(I32X4, bits);
        let own = self.constant_vector(I32X4, (0..ITERATIONS).flat_map(|lane| (1_u32 << lane).to_le_bytes()).collect());
        let alone = self.b.ins().band(all, own);
        self.b.ins().icmp(IntCC::Equal, alone, own)
    }

    fn write_row_of_bits(&mut self, Address { base, offset, .. }: Address, (number, bytes): (Value, Value), value: &Lanes) {
        let all = self.b.ins().iconst(I32, (1 << ITERATIONS) - 1);
        let bits = match value {
            Lanes::One(bit) => {
                let flag = self.flag(*bit);
                let every = self.b.ins().ineg(flag);
                self.b.ins().band(every, all)
            }
            value => {
                let masks = self.masks(value, ITERATIONS);
                self.b.ins().vhigh_bits(I32, masks[0])
            }
        };
        let [own, new] = [all, bits].map(|bits| self.b.ins().ishl(bits, number));
        let others = self.b.ins().band_not(bytes, own);
        let both = self.b.ins().bor(others, new);
        self.b.ins().istore16(data(), both, base, offset);
    }
}
