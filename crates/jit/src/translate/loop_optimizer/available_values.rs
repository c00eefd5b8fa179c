//! Load elimination and store forwarding inside an iteration, at computed addresses: what it has loaded or stored is not loaded again, and
//! what it stores is stored once, before another access may alias it or the iteration ends.

use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::kernel::{Access, Definition, Effect, Kernel, Node, PointedPart, StructureCopy};
use super::path_predicates::PathPredicates;
use super::ssa_construction::SsaBuilder;

/// Variables at computed addresses.
#[derive(Default)]
pub(super) struct AvailableValues(Vec<Entry>);

struct Entry {
    /// An access that reads or writes exactly this variable.
    access: Access,
    value: Node,
    /// Memory does not hold the value yet.
    waits: bool,
    /// Where the address is known to be inside its area on some ways only: which, and whether one of them led there.
    unsure: Option<(PathPredicates, Node)>,
}

impl AvailableValues {
    pub(super) fn forget(&mut self) {
        self.0.clear();
    }
}

impl AvailableValues {
    /// Forgets what a copy may write. Nothing waits.
    pub(super) fn forget_copied(&mut self, copied: &StructureCopy) {
        self.0.retain(|entry| !entry.access.may_meet_copied(&copied.to, copied.bytes));
    }
}

impl Access {
    /// Whether another access goes to exactly the same variable.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        (self.area, self.pointer, self.offset, self.width) == (other.area, other.pointer, other.offset, other.width)
    }

    /// Whether another access may go to some of the same bits.
    pub(super) fn may_meet(&self, other: &Self) -> bool {
        self.may_meet_bits(other, if other.width == Width::Bit { 1 } else { other.width.bytes() * 8 })
    }

    /// Whether it may go to some of the bytes of one end of a copy.
    pub(super) fn may_meet_copied(&self, end: &Self, bytes: u32) -> bool {
        self.may_meet_bits(end, 8 * bytes)
    }

    fn may_meet_bits(&self, other: &Self, bits: u32) -> bool {
        if self.area == other.area && self.pointer == other.pointer {
            let own = if self.width == Width::Bit { 1 } else { self.width.bytes() * 8 };
            // Positions have 24 bits.
            let ahead = other.offset.wrapping_sub(self.offset) & 0x00FF_FFFF;
            let behind = self.offset.wrapping_sub(other.offset) & 0x00FF_FFFF;
            return ahead < own || behind < bits;
        }
        self.may_share(other) && !self.is_beside(other)
    }
}

impl SsaBuilder<'_, '_> {
    /// What a variable at a computed address holds.
    pub(super) fn read_at(&mut self, access: Access, steps: &mut Vec<Effect>) -> Node {
        let at = match self.place_of(&access, steps) {
            Some(at) => at,
            None => self.hold(access, steps),
        };
        self.known_here(self.held.0[at].value)
    }

    /// What a variable at a computed address holds that is written again before anybody reads it.
    pub(super) fn take_held(&mut self, access: Access, steps: &mut Vec<Effect>) -> Node {
        let value = self.read_at(access.clone(), steps);
        for entry in self.held.0.iter_mut().filter(|entry| entry.access.is_same(&access)) {
            entry.waits = false;
        }
        value
    }

    /// Writes a variable at a computed address on the ways that led here.
    pub(super) fn write_at(&mut self, access: Access, value: Node, steps: &mut Vec<Effect>) {
        let at = match self.place_of(&access, steps) {
            Some(at) => at,
            // On other ways it holds what it held.
            None if !self.is_always_reached() => self.hold(access, steps),
            None => {
                self.write_what_meets(&access, steps);
                self.held.0.push(Entry { access, value, waits: true, unsure: None });
                self.held.0.len() - 1
            }
        };
        let access = self.held.0[at].access.clone();
        let before = self.held.0[at].value;
        let value = self.chosen(value, before);
        self.write_what_meets(&access, steps);
        let own = |entry: &Entry| entry.access.is_same(&access);
        self.held.0.retain(|entry| own(entry) || !entry.access.may_meet(&access));
        for entry in self.held.0.iter_mut().filter(|entry| own(entry)) {
            (entry.value, entry.waits) = (value, true);
        }
    }

    /// The place in the list of a variable that is there.
    fn place_of(&mut self, access: &Access, steps: &mut Vec<Effect>) -> Option<usize> {
        let at = self.held.0.iter().position(|entry| entry.access.is_same(access))?;
        match &self.held.0[at].unsure {
            // Its address was known to be inside on other ways than these.
            Some((ways, _)) if !self.ways.are_all_among(ways) => {
                self.write_where(|entry| entry.access.is_same(access), steps);
                self.held.0.remove(at);
                None
            }
            _ => Some(at),
        }
    }

    /// Reads a variable; its place in the list.
    fn hold(&mut self, access: Access, steps: &mut Vec<Effect>) -> usize {
        self.write_what_meets(&access, steps);
        let unsure = (!access.sure && access.inside.is_some()).then(|| {
            let [no, yes] = [0, 1].map(|value| self.constant(value));
            (self.ways.clone(), self.chosen(yes, no))
        });
        let value = self.access(access.clone(), unsure.as_ref().map(|&(_, reached)| reached), steps);
        self.held.0.push(Entry { access, value, waits: false, unsure });
        self.held.0.len() - 1
    }

    /// Writes what waits and may share bits with an access, but not the same variable.
    fn write_what_meets(&mut self, access: &Access, steps: &mut Vec<Effect>) {
        self.write_where(|entry| !entry.access.is_same(access) && entry.access.may_meet(access), steps);
    }

    /// Writes all that waits.
    pub(super) fn write_held(&mut self, steps: &mut Vec<Effect>) {
        self.write_where(|_| true, steps);
    }

    fn write_where(&mut self, wanted: impl Fn(&Entry) -> bool, steps: &mut Vec<Effect>) {
        for at in 0..self.held.0.len() {
            if self.write_byte(at, &wanted, steps) {
                continue;
            }
            let entry = &mut self.held.0[at];
            if entry.waits && wanted(entry) {
                entry.waits = false;
                let access = Access { value: Some(entry.value), ..entry.access.clone() };
                let reached = entry.unsure.as_ref().map(|&(_, reached)| reached);
                self.access(access, reached, steps);
            }
        }
    }

    /// Writes the bits of a byte at once, if more than one of them waits with the bit at a place in the list; whether it did.
    fn write_byte(&mut self, at: usize, wanted: &impl Fn(&Entry) -> bool, steps: &mut Vec<Effect>) -> bool {
        let first = self.held.0[at].access.clone();
        let Some(part) = first.part else { return false };
        let is_one = |entry: &Entry| {
            let access = &entry.access;
            let same_byte = (access.area, access.pointer, access.offset & !7) == (first.area, first.pointer, first.offset & !7);
            let known = access.part.is_some() && access.sure && entry.unsure.is_none();
            entry.waits && access.width == Width::Bit && same_byte && known && wanted(entry)
        };
        let bits: Vec<usize> = (at..self.held.0.len()).filter(|&other| is_one(&self.held.0[other])).collect();
        if bits.len() < 2 || bits[0] != at {
            return false;
        }
        let around = first.around.iter().map(|around| around.whole_bytes()).collect();
        let whole = Access { offset: first.offset & !7, width: Width::Byte, part: Some(PointedPart { bit: 0, ..part }), around, ..first };
        let mut value = self.access(whole.clone(), None, steps);
        let mut others = 0xFF;
        let mut new = Vec::new();
        for other in bits {
            let entry = &mut self.held.0[other];
            entry.waits = false;
            let bit = entry.access.offset % 8;
            others &= !(1 << bit);
            new.push((bit, entry.value));
        }
        let others = self.constant(others);
        value = self.compute(Op::AndU32, [value, others, value, value]);
        for (bit, set) in new {
            let bit = self.constant(u64::from(bit));
            let moved = self.compute(Op::Shl32, [set, bit, set, set]);
            value = self.compute(Op::OrU32, [value, moved, value, value]);
        }
        self.access(Access { value: Some(value), ..whole }, None, steps);
        true
    }
}

impl Kernel {
    /// What a byte was before bits of it were set together, these bits cleared, and the bits from the lowest one on with what they are.
    pub(super) fn bits_set_in(&self, node: Node) -> Option<(Node, Vec<(u32, Node)>)> {
        let mut bits = Vec::new();
        // A byte is cut out of a number where a program makes it.
        let mut rest = match self.what(node) {
            Definition::Compute(Op::Low8, [of, ..]) => of,
            _ => node,
        };
        while let Definition::Compute(Op::OrU32, [others, moved, ..]) = self.what(rest)
            && let Definition::Compute(Op::Shl32, [set, bit, ..]) = self.what(moved)
        {
            let bit = self.constant(bit).filter(|&bit| bit < 8)?;
            bits.push((bit as u32, set));
            rest = others;
        }
        bits.sort();
        let are_bits = bits.iter().all(|&(_, set)| self.constant(set).is_some_and(|set| set <= 1) || self.is_bit(set));
        let once = bits.windows(2).all(|pair| pair[0].0 != pair[1].0);
        (bits.len() > 1 && once && are_bits).then_some((rest, bits))
    }
}
