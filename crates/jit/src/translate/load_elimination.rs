//! Redundant-load elimination at computed addresses: numbers, in the instance of a function block in an array mostly, lengths of strings,
//! and bytes of structures that were copied. What was stored or loaded there is not loaded again as long as no store may alias it and there
//! is no slow path.

use std::ops::Range;

use cranelift_codegen::ir::Value;
use sieben_engine::ir::TextRoom;
use sieben_model::address::Width;

use super::Translator;
use super::memory::Address;
use super::scalar_promotion::Base;
use super::string_comparison::WORD;
use super::strings::InBoundsString;
use super::value::Val;
use crate::passes::Pass;

/// Numbers that are remembered, the newest ones: more would keep registers that the code needs.
const KNOWN_MAX: usize = 24;
/// The same of lengths.
const LENGTHS_MAX: usize = 6;
/// Copies that are remembered, the newest ones.
const COPIES_MAX: usize = 2;
/// Bytes of a copy that is remembered: a longer one and what is copied in between would not stay in registers.
pub(super) const COPIED_BYTES_MAX: u32 = 96;

/// What is known of numbers at computed addresses: base, offset, width, and the value as a load would have it. No two may share bytes
/// unless both were read.
#[derive(Clone, Debug, Default)]
pub(super) struct AvailableLoads(Vec<(Base, i32, Width, Val)>, Lengths, Vec<AvailableCopy>);

/// Bytes that were copied, and what they are: base, offset, and pieces as they were read, one behind the other.
#[derive(Clone, Debug, PartialEq)]
struct AvailableCopy {
    base: Base,
    offset: i32,
    bytes: u32,
    pieces: Vec<Value>,
}

/// How many characters count in texts that begin at an offset behind a base and have so much room.
pub(super) type Lengths = Vec<(Base, i32, TextRoom, Characters)>;

/// What is known of the characters of a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Characters {
    /// How many count.
    pub(super) length: Value,
    /// The only one, in 32 bits, if there is never more than one; anything if there is none.
    pub(super) only: Option<Value>,
    /// All of them, the first one in the lowest byte, with 0 behind, if there are never more than eight.
    pub(super) word: Option<Value>,
}

impl Characters {
    /// How many characters, if not more.
    pub(super) fn some(length: Value) -> Self {
        Self { length, only: None, word: None }
    }

    /// The bytes of a text that say so.
    fn bytes(&self, room: TextRoom) -> u32 {
        let characters = if self.word.is_some() { WORD } else { u32::from(self.only.is_some()) };
        room.head() + characters.min(room.characters_max.into())
    }
}

impl AvailableLoads {
    /// Keeps what others know, too.
    pub(super) fn keep_common(&mut self, other: &Self) {
        self.0.retain(|known| other.0.contains(known));
        self.1.retain(|known| other.1.contains(known));
        self.2.retain(|known| other.2.contains(known));
    }

    /// Forgets what may share bytes with these.
    pub(super) fn forget(&mut self, base: Base, bytes: &Range<i32>) {
        let bytes = i64::from(bytes.start)..i64::from(bytes.end);
        self.0.retain(|&(own, at, width, _)| {
            let at = i64::from(at);
            !own.may_share(&(at..at + i64::from(width.bytes())), base, &bytes)
        });
        self.1.retain(|&(own, at, room, characters)| {
            let at = i64::from(at);
            !own.may_share(&(at..at + i64::from(characters.bytes(room))), base, &bytes)
        });
        self.2.retain(|copied| {
            let at = i64::from(copied.offset);
            !copied.base.may_share(&(at..at + i64::from(copied.bytes)), base, &bytes)
        });
    }

    /// What is known of lengths, which a text instruction keeps.
    pub(super) fn take_lengths(&mut self) -> Lengths {
        std::mem::take(&mut self.1)
    }

    pub(super) fn keep_lengths(&mut self, lengths: Lengths) {
        self.1 = lengths;
    }

    /// Whether nothing is known.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty() && self.1.is_empty() && self.2.is_empty()
    }

    /// Forgets everything.
    pub(super) fn clear(&mut self) {
        self.0.clear();
        self.1.clear();
        self.2.clear();
    }
}

impl Translator<'_> {
    /// The number at a computed address, if it is known.
    pub(super) fn known_number(&self, address: Address, width: Width) -> Option<Val> {
        let base = self.base_of_number(address)?;
        let is_it = |known: &&(Base, i32, Width, Val)| (known.0, known.1, known.2) == (base, address.offset, width);
        self.bytes.numbers.0.iter().find(is_it).map(|known| known.3)
    }

    /// The number of which a byte is part, if one of 16 or 32 bits is known there: where it begins, its width, and itself.
    pub(super) fn number_around(&self, address: Address) -> Option<(i32, Width, Val)> {
        let is_around = |at: i32, width: Width| {
            matches!(width, Width::Word | Width::DoubleWord) && (at..at + width.bytes() as i32).contains(&address.offset)
        };
        let Some(base) = self.base_of_number(address) else { return self.word_around(is_around) };
        let numbers = self.bytes.numbers.0.iter().rev();
        { numbers }.find(|&&(own, at, width, _)| own == base && is_around(at, width)).map(|&(_, at, width, value)| (at, width, value))
    }

    /// Remembers what was read or written at a computed address. What shares bytes with it is forgotten already if it was written.
    pub(super) fn remember_number(&mut self, address: Address, width: Width, value: Val) {
        if width == Width::Bit || !self.options.does(Pass::LoadElimination) || self.cold.is_some() {
            return;
        }
        let Some(base) = self.base_of_number(address) else { return };
        let value = self.as_read_there(width, value);
        if self.bytes.numbers.0.len() == KNOWN_MAX {
            self.bytes.numbers.0.remove(0);
        }
        self.bytes.numbers.0.push((base, address.offset, width, value));
    }

    /// What the address of a number that is remembered is counted from: those in local data are in `words`.
    fn base_of_number(&self, address: Address) -> Option<Base> {
        Some(self.known_base(address.base)).filter(|&base| base != Base::Local)
    }

    /// The pieces of which bytes are made that were copied to an address.
    pub(super) fn known_copy(&self, address: Address, bytes: u32) -> Option<Vec<Value>> {
        let base = self.base_of_copy(address, bytes)?;
        let is_it = |known: &&AvailableCopy| (known.base, known.offset, known.bytes) == (base, address.offset, bytes);
        self.bytes.numbers.2.iter().find(is_it).map(|known| known.pieces.clone())
    }

    /// Remembers what was copied to an address. What shares bytes with it is forgotten already.
    pub(super) fn remember_copy(&mut self, address: Address, bytes: u32, pieces: Vec<Value>) {
        let Some(base) = self.base_of_copy(address, bytes) else { return };
        let copies = &mut self.bytes.numbers.2;
        if copies.len() == COPIES_MAX {
            copies.remove(0);
        }
        copies.push(AvailableCopy { base, offset: address.offset, bytes, pieces });
    }

    /// What the address of bytes that are remembered is counted from: it is known, and no register stands for any of them.
    fn base_of_copy(&self, address: Address, bytes: u32) -> Option<Base> {
        let is_known = address.base == self.local || address.base == self.arena || self.computed.contains_key(&address.base);
        if !is_known || bytes > COPIED_BYTES_MAX || !self.options.does(Pass::LoadElimination) || self.cold.is_some() {
            return None;
        }
        let base = self.known_base(address.base);
        let first = i64::from(address.offset);
        (!self.keeps_some_of((base, first..first + i64::from(bytes)))).then_some(base)
    }

    /// What is known of the characters of a text.
    pub(super) fn known_characters(&self, text: &InBoundsString) -> Option<Characters> {
        if self.cold.is_some() {
            // Somebody may have been asked.
            return None;
        }
        let base = self.base_of_text(text)?;
        let is_it = |known: &&(Base, i32, TextRoom, Characters)| (known.0, known.1, known.2) == (base, text.address.offset, text.room);
        self.bytes.numbers.1.iter().find(is_it).map(|known| known.3)
    }

    /// Remembers how many characters of a text count. What shares bytes with it is forgotten already if they were written.
    pub(super) fn remember_characters(&mut self, text: &InBoundsString, characters: Characters) {
        let Some(base) = self.base_of_text(text) else { return };
        if !self.options.does(Pass::LoadElimination) || self.cold.is_some() {
            return;
        }
        let lengths = &mut self.bytes.numbers.1;
        if lengths.len() == LENGTHS_MAX {
            lengths.remove(0);
        }
        lengths.push((base, text.address.offset, text.room, characters));
    }

    /// What a text is counted from that does not say itself how much room it has, and of which the place is known.
    fn base_of_text(&self, text: &InBoundsString) -> Option<Base> {
        let base = text.address.base;
        let is_known = base == self.local || base == self.arena || self.computed.contains_key(&base);
        (is_known && text.most.is_none()).then(|| self.known_base(base))
    }
}
