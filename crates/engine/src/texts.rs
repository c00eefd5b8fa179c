//! STRINGs in data memory: the greatest length, the actual length, then the characters, one byte each.

use std::ops::Range;

use sieben_model::address::Width;

use crate::access::{File, Target, locate_far};
use crate::fault::Fault;
use crate::ir::{Place, TextAction};
use crate::machine::Machine;

/// Bytes before the characters.
const HEAD: u32 = 2;

/// A STRING and how many characters it may have; 0 = as its first byte says.
#[derive(Clone, Copy, Debug)]
pub struct Text {
    /// Its first byte.
    pub place: Place,
    /// The greatest number of characters that count.
    pub characters_max: u8,
}

/// What a text instruction will do, all places found.
#[derive(Clone, Debug)]
pub enum Plan {
    /// Nothing but a result.
    Result(u64),
    /// Writes characters, and the two bytes before them.
    Write {
        /// Arena bytes of the characters that are written.
        from: Range<usize>,
        /// Arena byte of the text.
        to: usize,
        /// Its greatest length.
        room: u8,
        /// Whether characters are left out.
        cut: bool,
    },
}

/// Finds what a text instruction means. `local` is that of [`locate_far`].
///
/// # Errors
/// The programming error of a text that lies outside its area.
pub fn plan(
    machine: &Machine,
    file: &File,
    local: &dyn Fn(usize) -> Range<usize>,
    action: TextAction,
    to: Text,
    from: Text,
) -> Result<Plan, Fault> {
    let source = characters(machine, file, local, from)?;
    match action {
        TextAction::Length => Ok(Plan::Result(source.len() as u64)),
        TextAction::Compare => {
            let first = characters(machine, file, local, to)?;
            let arena = &machine.memory.arena;
            Ok(Plan::Result(u64::from(arena[first].cmp(&arena[source]) as i32 as u32)))
        }
        TextAction::Assign => {
            let head = start(machine, file, local, to.place, HEAD, true)?;
            let room = match to.characters_max {
                0 => machine.memory.arena[head],
                room => room,
            };
            let count = source.len().min(usize::from(room));
            start(machine, file, local, to.place, HEAD + count as u32, true)?;
            let cut = count < source.len();
            Ok(Plan::Write { from: source.start..source.start + count, to: head, room, cut })
        }
    }
}

impl Plan {
    /// Does it; the result of the instruction.
    pub fn run(self, machine: &mut Machine) -> u64 {
        match self {
            Self::Result(result) => result,
            Self::Write { from, to, room, cut } => {
                let count = from.len();
                let arena = &mut machine.memory.arena;
                // The characters first: both texts may overlap.
                arena.copy_within(from, to + HEAD as usize);
                arena[to] = room;
                arena[to + 1] = count as u8;
                u64::from(cut)
            }
        }
    }
}

/// The arena bytes of the characters of a text.
fn characters(machine: &Machine, file: &File, local: &dyn Fn(usize) -> Range<usize>, text: Text) -> Result<Range<usize>, Fault> {
    let head = start(machine, file, local, text.place, HEAD, false)?;
    let [room, length] = [machine.memory.arena[head], machine.memory.arena[head + 1]];
    let count = length.min(if text.characters_max == 0 { room } else { text.characters_max });
    start(machine, file, local, text.place, HEAD + u32::from(count), false)?;
    let first = head + HEAD as usize;
    Ok(first..first + usize::from(count))
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
