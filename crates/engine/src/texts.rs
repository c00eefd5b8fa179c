//! STRINGs in data memory: the greatest length, the actual length, then the characters, one byte each.

use std::ops::Range;

use sieben_model::address::Width;

use crate::access::{File, Target, locate_far};
use crate::fault::Fault;
use crate::ir::{Place, TextAction};
use crate::machine::Machine;

/// Bytes before the characters.
pub const HEAD: u32 = 2;

/// A STRING and how many characters it may have; 0 = as its first byte says.
#[derive(Clone, Copy, Debug)]
pub struct Text {
    /// Its first byte.
    pub place: Place,
    /// The greatest number of characters that count.
    pub characters_max: u8,
}

/// A STRING that lies inside its area, as far as it counts.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// The arena byte where it begins.
    pub start: usize,
    /// The greatest number of characters that count; 0 = as its first byte says.
    pub characters_max: u8,
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
pub struct Piece {
    /// The first one, counted from 0.
    pub first: i32,
    /// How many.
    pub count: i32,
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
    piece: Piece,
) -> Result<Both, Fault> {
    let text = |text: Text, write: bool| {
        let start = start(machine, file, local, text.place, HEAD, write)?;
        Ok(Found { start, characters_max: text.characters_max })
    };
    let arena = &machine.memory.arena;
    let inside = |text: Text, characters: usize, write: bool| {
        start(machine, file, local, text.place, HEAD + characters as u32, write)?;
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
            let piece = if action == TextAction::Assign { Piece::ALL } else { piece };
            let count = piece.within(length).len().min(target.room(arena) - there);
            inside(to, there + count, true)?;
            target
        }
    };
    Ok(Both { to: target, from: source })
}

impl Both {
    /// Does what a text instruction says; its result.
    pub fn run(self, arena: &mut [u8], action: TextAction, piece: Piece) -> u64 {
        let Self { to, from } = self;
        match action {
            TextAction::Length => from.length(arena) as u64,
            TextAction::Compare => u64::from(to.characters(arena).cmp(from.characters(arena)) as i32 as u32),
            TextAction::Find => position(to.characters(arena), from.characters(arena)) as u64,
            TextAction::Assign => {
                let length = from.length(arena);
                u64::from(to.put(arena, 0, from.start, 0..length) < length)
            }
            TextAction::Piece | TextAction::Append => {
                let behind = if action == TextAction::Append { to.length(arena) } else { 0 };
                let piece = piece.within(from.length(arena));
                let count = piece.len();
                to.put(arena, behind, from.start, piece);
                count as u64
            }
        }
    }
}

impl Found {
    /// How many characters there is room for.
    fn room(self, arena: &[u8]) -> usize {
        usize::from(if self.characters_max == 0 { arena[self.start] } else { self.characters_max })
    }

    /// How many characters count.
    fn length(self, arena: &[u8]) -> usize {
        usize::from(arena[self.start + 1]).min(self.room(arena))
    }

    fn characters(self, arena: &[u8]) -> &[u8] {
        let first = self.start + HEAD as usize;
        &arena[first..first + self.length(arena)]
    }

    /// Writes characters of the text at `from` behind so many of this one, and both length bytes; how many there was room for.
    fn put(self, arena: &mut [u8], behind: usize, from: usize, piece: Range<usize>) -> usize {
        let room = self.room(arena);
        let count = piece.len().min(room - behind);
        let source = from + HEAD as usize + piece.start;
        // The characters first: both texts may overlap.
        arena.copy_within(source..source + count, self.start + HEAD as usize + behind);
        arena[self.start] = room as u8;
        arena[self.start + 1] = (behind + count) as u8;
        count
    }
}

impl Piece {
    /// All characters.
    pub const ALL: Self = Self { first: 0, count: i32::MAX };

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
