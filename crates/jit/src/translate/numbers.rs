//! Numbers at computed addresses, in the instance of a function block in an array mostly: what was written there or read is not read again
//! as long as nothing is written that may be the same bytes, and nobody is asked.

use std::ops::Range;

use sieben_model::address::Width;

use super::Translator;
use super::memory::Address;
use super::promote::Base;
use super::value::Val;

/// Numbers that are remembered, the newest ones: more would keep registers that the code needs.
const KNOWN_MAX: usize = 8;

/// What is known of numbers at computed addresses: base, offset, width, and the value as a load would have it. No two may share bytes
/// unless both were read.
#[derive(Clone, Debug, Default)]
pub(super) struct Numbers(Vec<(Base, i32, Width, Val)>);

impl Numbers {
    /// Keeps what others know, too.
    pub(super) fn keep_common(&mut self, other: &Self) {
        self.0.retain(|known| other.0.contains(known));
    }

    /// Forgets what may share bytes with these.
    pub(super) fn forget(&mut self, base: Base, bytes: &Range<i32>) {
        let bytes = i64::from(bytes.start)..i64::from(bytes.end);
        self.0.retain(|&(own, at, width, _)| {
            let at = i64::from(at);
            !own.may_share(&(at..at + i64::from(width.bytes())), base, &bytes)
        });
    }

    /// Forgets everything.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }
}

impl Translator<'_> {
    /// The number at a computed address, if it is known.
    pub(super) fn known_number(&self, address: Address, width: Width) -> Option<Val> {
        let base = Base::Computed(*self.computed.get(&address.base)?);
        let is_it = |known: &&(Base, i32, Width, Val)| (known.0, known.1, known.2) == (base, address.offset, width);
        self.bytes.numbers.0.iter().find(is_it).map(|known| known.3)
    }

    /// Remembers what was read or written at a computed address. What shares bytes with it is forgotten already if it was written.
    pub(super) fn remember_number(&mut self, address: Address, width: Width, value: Val) {
        if width == Width::Bit || !self.options.optimize || self.cold.is_some() {
            return;
        }
        let Some(&computed) = self.computed.get(&address.base) else { return };
        let value = self.as_read_there(width, value);
        if self.bytes.numbers.0.len() == KNOWN_MAX {
            self.bytes.numbers.0.remove(0);
        }
        self.bytes.numbers.0.push((Base::Computed(computed), address.offset, width, value));
    }
}
