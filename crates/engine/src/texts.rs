//! Texts in data memory: the greatest length, the actual length, then the characters; a byte each in a STRING, a word each in a WSTRING.

use std::cmp::Ordering;
use std::ops::Range;

use sieben_model::address::Width;

use crate::access::{File, Target, bytes_far, locate_far};
use crate::fault::Fault;
use crate::ir::{Place, TextAction, TextRoom};
use crate::machine::Machine;
use crate::numbers_in_texts::{CHARACTERS_MAX, Characters, read};

/// Bytes of a number that was read from a text.
const NUMBER_BYTES: usize = TextRoom::NUMBER.bytes() as usize;

/// A text and how many of its characters count.
#[derive(Clone, Copy, Debug)]
pub struct Text {
    /// Its first byte.
    pub place: Place,
    /// What it has room for.
    pub room: TextRoom,
}

/// A text that lies inside its area, as far as it counts.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// The arena byte where it begins.
    pub start: usize,
    /// What it has room for.
    pub room: TextRoom,
}

/// The two texts of an instruction.
#[derive(Clone, Copy, Debug)]
pub struct Both {
    /// What is written, or compared, or searched.
    pub to: Found,
    /// What is read.
    pub from: Found,
}

/// Which characters of a text: what is not there does not count, and a negative number is 0.
#[derive(Clone, Copy, Debug, Default)]
struct Piece {
    /// The first one, counted from 0.
    first: i32,
    /// How many.
    count: i32,
}

/// Finds the texts of an instruction. `local` is that of [`locate_far`].
///
/// # Errors
/// The programming error of a text that lies outside its area.
pub fn find(
    machine: &Machine,
    file: &File,
    local: &dyn Fn(usize) -> Range<usize>,
    action: TextAction,
    [to, from]: [Text; 2],
    word: u64,
) -> Result<Both, Fault> {
    if let Some(both) = find_whole(machine, file, local, action, [to, from]) {
        return Ok(both);
    }
    let from = if action.takes_number() { to } else { from };
    let text = |text: Text, write: bool| {
        let start = start(machine, file, local, text.place, text.room.head(), write)?;
        Ok(Found { start, room: text.room })
    };
    let arena = &machine.memory.arena;
    let inside = |text: Text, characters: usize, write: bool| {
        start(machine, file, local, text.place, text.room.head() + characters as u32 * text.room.unit(), write)?;
        Ok(())
    };
    let source = text(from, false)?;
    let length = source.length(arena);
    inside(from, length, false)?;
    let target = match action {
        TextAction::Length => source,
        TextAction::Compare | TextAction::Find => {
            let target = text(to, false)?;
            inside(to, target.length(arena), false)?;
            target
        }
        TextAction::Assign | TextAction::Piece | TextAction::Append => {
            let target = text(to, true)?;
            let there = if action == TextAction::Append { target.length(arena) } else { 0 };
            let piece = if action == TextAction::Assign { Piece::ALL } else { Piece::of(word) };
            let count = piece.within(length).len().min(target.most(arena) - there);
            inside(to, there + count, true)?;
            target
        }
        TextAction::Number => Found { start: start(machine, file, local, to.place, NUMBER_BYTES as u32, true)?, room: to.room },
        _ => {
            let target = text(to, true)?;
            let count = Characters::of(action, word).as_bytes().len().min(target.most(arena));
            inside(to, count, true)?;
            target
        }
    };
    Ok(Both { to: target, from: source })
}

/// The texts of an instruction whose declared length says how many bytes they take, if all of those are there.
fn find_whole(
    machine: &Machine,
    file: &File,
    local: &dyn Fn(usize) -> Range<usize>,
    action: TextAction,
    [to, from]: [Text; 2],
) -> Option<Both> {
    let text = |Text { place, room }: Text, write: bool| {
        let whole = !room.is_unknown();
        whole.then(|| bytes_far(machine, file, local, place, room.bytes(), write)).flatten().map(|start| Found { start, room })
    };
    let target = |write: bool| text(to, write);
    let both = |to: Found, from: Found| Some(Both { to, from });
    match action {
        TextAction::Length => text(from, false).and_then(|from| both(from, from)),
        _ if action.takes_number() => target(true).and_then(|to| both(to, to)),
        _ => both(target(action.writes())?, text(from, false)?),
    }
}

impl Both {
    /// Does what a text instruction says; its result.
    pub fn run(self, arena: &mut [u8], action: TextAction, word: u64) -> u64 {
        if self.to.room.wide || self.from.room.wide {
            return self.run_as_they_are(arena, action, word);
        }
        // Nearly all texts are STRINGs: for them the compiler leaves out what others need.
        let narrow = |found: Found| Found { room: TextRoom { wide: false, ..found.room }, ..found };
        let Self { to, from } = self;
        Self { to: narrow(to), from: narrow(from) }.run_as_they_are(arena, action, word)
    }

    #[inline(always)]
    fn run_as_they_are(self, arena: &mut [u8], action: TextAction, word: u64) -> u64 {
        let Self { to, from } = self;
        match action {
            TextAction::Length => from.length(arena) as u64,
            // The order of words is that of their bytes.
            TextAction::Compare if to.room.wide == from.room.wide => order(to.bytes(arena).cmp(from.bytes(arena))),
            TextAction::Compare => order(to.characters(arena).cmp(from.characters(arena))),
            TextAction::Find if !to.room.wide && !from.room.wide => position(to.bytes(arena), from.bytes(arena)) as u64,
            TextAction::Find => wide_position(to, from, arena) as u64,
            TextAction::Assign => {
                let length = from.length(arena);
                let foreign = from.room.wide && !to.room.wide && from.characters(arena).any(|character| character > u16::from(u8::MAX));
                u64::from(to.put(arena, 0, from, 0..length) < length || foreign)
            }
            TextAction::Piece | TextAction::Append => {
                let behind = if action == TextAction::Append { to.length(arena) } else { 0 };
                let piece = Piece::of(word).within(from.length(arena));
                let count = piece.len();
                to.put(arena, behind, from, piece);
                count as u64
            }
            TextAction::Number => {
                let (number, good) = match from.room.wide {
                    false => read(from.bytes(arena), word),
                    true => {
                        let narrow = |character| u8::try_from(character).unwrap_or(b'?');
                        let characters: Vec<u8> = from.characters(arena).map(narrow).take(CHARACTERS_MAX).collect();
                        read(&characters, word)
                    }
                };
                arena[to.start..to.start + NUMBER_BYTES].copy_from_slice(&number.to_be_bytes());
                good.into()
            }
            _ => {
                let characters = Characters::of(action, word);
                to.write(arena, characters.as_bytes());
                characters.as_bytes().len() as u64
            }
        }
    }
}

/// An order as a number of 32 bits.
fn order(order: Ordering) -> u64 {
    u64::from(order as i32 as u32)
}

impl Found {
    /// The greatest (0) or the actual (1) length, as it stands there.
    #[inline(always)]
    fn head(self, arena: &[u8], which: usize) -> usize {
        match self.room.wide {
            false => usize::from(arena[self.start + which]),
            true => usize::from(u16::from_be_bytes([arena[self.start + 2 * which], arena[self.start + 2 * which + 1]])),
        }
    }

    /// How many characters there is room for.
    #[inline(always)]
    fn most(self, arena: &[u8]) -> usize {
        if self.room.is_unknown() { self.head(arena, 0) } else { usize::from(self.room.characters_max) }
    }

    /// How many characters count.
    #[inline(always)]
    fn length(self, arena: &[u8]) -> usize {
        self.head(arena, 1).min(self.most(arena))
    }

    /// The arena byte of a character.
    #[inline(always)]
    fn byte_of(self, character: usize) -> usize {
        self.start + (self.room.head() as usize) + character * self.room.unit() as usize
    }

    /// The characters that count, as they lie there.
    #[inline(always)]
    fn bytes(self, arena: &[u8]) -> &[u8] {
        &arena[self.byte_of(0)..self.byte_of(self.length(arena))]
    }

    /// The same, each as a number.
    fn characters(self, arena: &[u8]) -> impl Iterator<Item = u16> {
        self.bytes(arena).chunks_exact(self.room.unit() as usize).map(|character| match *character {
            [high, low] => u16::from_be_bytes([high, low]),
            _ => u16::from(character[0]),
        })
    }

    /// Writes characters of another text behind so many of this one, and both lengths; how many there was room for.
    #[inline(always)]
    fn put(self, arena: &mut [u8], behind: usize, from: Self, piece: Range<usize>) -> usize {
        let most = self.most(arena);
        let count = piece.len().min(most - behind);
        if self.room.wide == from.room.wide {
            // The characters first: both texts may overlap.
            let (first, end) = (from.byte_of(piece.start), from.byte_of(piece.start + count));
            arena.copy_within(first..end, self.byte_of(behind));
        } else {
            for index in 0..count {
                let (source, target) = (from.byte_of(piece.start + index), self.byte_of(behind + index));
                match self.room.wide {
                    true => [arena[target], arena[target + 1]] = [0, arena[source]],
                    false => arena[target] = if arena[source] == 0 { arena[source + 1] } else { b'?' },
                }
            }
        }
        self.put_lengths(arena, [most, behind + count]);
        count
    }

    /// Writes characters that no text has, and both lengths.
    fn write(self, arena: &mut [u8], characters: &[u8]) {
        let most = self.most(arena);
        let count = characters.len().min(most);
        let target = &mut arena[self.byte_of(0)..self.byte_of(count)];
        match self.room.wide {
            false => target.copy_from_slice(&characters[..count]),
            true => {
                for (word, &character) in target.chunks_exact_mut(2).zip(characters) {
                    word.copy_from_slice(&[0, character]);
                }
            }
        }
        self.put_lengths(arena, [most, count]);
    }

    /// Writes both lengths.
    #[inline(always)]
    fn put_lengths(self, arena: &mut [u8], lengths: [usize; 2]) {
        for (which, length) in lengths.into_iter().enumerate() {
            match self.room.wide {
                false => arena[self.start + which] = length as u8,
                true => arena[self.start + 2 * which..][..2].copy_from_slice(&(length as u16).to_be_bytes()),
            }
        }
    }
}

impl Piece {
    /// All characters.
    const ALL: Self = Self { first: 0, count: i32::MAX };

    /// That of an instruction: the first character in the low half, how many in the high half.
    fn of(word: u64) -> Self {
        Self { first: word as u32 as i32, count: (word >> 32) as u32 as i32 }
    }

    /// Those of so many characters.
    fn within(self, length: usize) -> Range<usize> {
        let first = usize::try_from(self.first).unwrap_or(0).min(length);
        let count = usize::try_from(self.count).unwrap_or(0).min(length - first);
        first..first + count
    }
}

/// Where characters stand in others first, counted from 1; 0 = nowhere.
fn position(all: &[u8], wanted: &[u8]) -> usize {
    let Some((&first, rest)) = wanted.split_first() else { return 0 };
    let mut from = 0;
    while let Some(next) = all[from..].iter().position(|&character| character == first) {
        from += next + 1;
        if all[from..].starts_with(rest) {
            return from;
        }
    }
    0
}

/// The same of texts that are not both STRINGs.
fn wide_position(all: Found, wanted: Found, arena: &[u8]) -> usize {
    let (length, count) = (all.length(arena), wanted.length(arena));
    if count == 0 || count > length {
        return 0;
    }
    let starts = |first: &usize| all.characters(arena).skip(*first).zip(wanted.characters(arena)).all(|(a, b)| a == b);
    (0..=length - count).find(starts).map_or(0, |first| first + 1)
}

/// The arena byte at which so many bytes begin, all of them inside their area.
fn start(
    machine: &Machine,
    file: &File,
    local: &dyn Fn(usize) -> Range<usize>,
    place: Place,
    bytes: u32,
    write: bool,
) -> Result<usize, Fault> {
    let mut first = 0;
    for place in [place.moved(bytes.saturating_sub(1)), place] {
        first = match locate_far(machine, file, local, place, Width::Byte, write)? {
            Target::Arena(at, _) => at,
            Target::Peripheral(byte) => return Err(Fault::IoAccess { write, width: Width::Byte, byte }),
        };
    }
    Ok(first)
}
