//! Takes an image of retentive data back into a CPU that has not started yet.

use std::fmt;

use sieben_engine::Machine;
use sieben_model::address::Area;

use super::areas::RetentiveAreas;
use super::declaration::{Declarations, Initial};
use super::image::{self, Parsed, Part, RetainImage};
use crate::created_data_blocks;
use crate::system_state;

/// What to do with the image of a program with other data blocks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Adoption {
    /// It is refused: its bytes could mean something else now.
    #[default]
    SameProgram,
    /// What has the same declaration is taken, and the rest is left out.
    WhatFits,
}

/// What was taken back.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Restored {
    /// The scan that the data is from.
    pub scan: u64,
    /// Bytes of bit memory.
    pub bit_memory_bytes: usize,
    /// Number of timers.
    pub timers: usize,
    /// Number of counters.
    pub counters: usize,
    /// Data blocks by number, created ones too.
    pub data_blocks: Vec<u16>,
    /// Data blocks of the image that the program does not have or declares differently.
    pub left_out: Vec<u16>,
    /// Retentive data blocks of the program that begin with their initial values.
    pub initial: Vec<u16>,
}

/// Why an image is not taken back. Nothing has changed then.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The bytes cannot be read.
    Damaged,
    /// It is the image of a program with other data blocks.
    OtherProgram {
        /// Data blocks that only the image has, or that are declared differently.
        left_out: Vec<u16>,
        /// Data blocks that only the program has, or that are declared differently.
        initial: Vec<u16>,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Damaged => f.write_str("it is damaged"),
            Self::OtherProgram { left_out, initial } => {
                let mut numbers: Vec<u16> = left_out.iter().chain(initial).copied().collect();
                numbers.sort_unstable();
                numbers.dedup();
                write!(f, "it belongs to a program with other data blocks ({})", data_blocks(&numbers))
            }
        }
    }
}

impl std::error::Error for Refusal {}

/// Most numbers that a message lists.
const LISTED_MAX: usize = 5;

/// `DB 1, DB 2`; of very many the first.
pub fn data_blocks(numbers: &[u16]) -> String {
    let mut text = numbers.iter().take(LISTED_MAX).map(|number| format!("DB {number}")).collect::<Vec<_>>().join(", ");
    if numbers.len() > LISTED_MAX {
        text.push_str(&format!(" and {} more", numbers.len() - LISTED_MAX));
    }
    text
}

/// An image that was read and found to fit.
pub(crate) struct Judged<'a> {
    clock_us: u64,
    meters_us: [u64; image::METERS],
    parts: Vec<Part<'a>>,
    restored: Restored,
}

/// Reads all of an image and judges it; nothing changes yet.
pub(crate) fn judge<'a>(
    image: &'a RetainImage,
    adoption: Adoption,
    machine: &Machine,
    declarations: &Declarations,
) -> Result<Judged<'a>, Refusal> {
    let Parsed { clock_us, meters_us, mut parts } = image::parse(&image.bytes).ok_or(Refusal::Damaged)?;
    let mut restored = Restored { scan: image.scan, ..Restored::default() };
    let created = parts.iter().filter_map(|part| match part {
        Part::Created { number, bytes, .. } => Some((*number, bytes.len())),
        _ => None,
    });
    // Created data blocks belong together: the program made them in one memory.
    let created_fit =
        created.clone().all(|(number, _)| !declarations.all.contains_key(&number)) && created_data_blocks::fit(machine, created);
    // What the program wrote to the load memory goes when the program brings other values there.
    parts.retain(|part| match part {
        Part::Loaded { number, initial, bytes } => declarations.all.get(number) == Some(&Initial { hash: *initial, length: bytes.len() }),
        _ => true,
    });
    parts.retain(|part| {
        let (number, fits) = match part {
            Part::DataBlock { number, declaration, bytes } => {
                let entry = machine.memory.data_block(u64::from(*number));
                let same = declarations.blocks.get(number) == Some(declaration);
                (*number, same && entry.is_some_and(|entry| entry.length as usize == bytes.len()))
            }
            Part::Created { number, .. } => (*number, created_fit),
            _ => return true,
        };
        if !fits {
            restored.left_out.push(number);
        }
        fits
    });
    let has = |number: u16| parts.iter().any(|part| matches!(part, Part::DataBlock { number: other, .. } if *other == number));
    restored.initial = declarations.blocks.keys().copied().filter(|&number| !has(number)).collect();
    let gone = |number: &u16| parts.iter().any(|part| matches!(part, Part::Gone { number: other } if other == number));
    let same = image.layout == declarations.hash && restored.left_out.is_empty() && restored.initial.iter().all(gone);
    if !same && adoption == Adoption::SameProgram {
        return Err(Refusal::OtherProgram { left_out: restored.left_out, initial: restored.initial });
    }
    Ok(Judged { clock_us, meters_us, parts, restored })
}

impl Judged<'_> {
    /// Puts everything into a machine whose work memory was cleared.
    pub(crate) fn put(self, machine: &mut Machine, state: &mut system_state::State, areas: &RetentiveAreas) -> Restored {
        let Self { clock_us, meters_us, parts, mut restored } = self;
        machine.clock_us = clock_us;
        state.load_memory.clear();
        for (meter, shown_us) in state.meters.iter_mut().zip(meters_us) {
            *meter = system_state::Meter { shown_us, since_us: None };
        }
        for part in parts {
            put(part, machine, state, areas, &mut restored);
        }
        restored.data_blocks.sort_unstable();
        restored.data_blocks.dedup();
        restored
    }
}

fn put(part: Part<'_>, machine: &mut Machine, state: &mut system_state::State, areas: &RetentiveAreas, restored: &mut Restored) {
    match part {
        Part::BitMemory { first, bytes } => {
            let memory = machine.memory.area_mut(Area::BitMemory);
            for (number, &byte) in (first..=u16::MAX).zip(bytes) {
                if let Some(to) = memory.get_mut(usize::from(number)).filter(|_| areas.bit_memory.contains(number)) {
                    *to = byte;
                    restored.bit_memory_bytes += 1;
                }
            }
        }
        Part::Timer { number, timer } => {
            if let Some(to) = machine.timers.get_mut(usize::from(number)).filter(|_| areas.timers.contains(number)) {
                *to = timer;
                restored.timers += 1;
            }
        }
        Part::Counter { number, counter } => {
            if let Some(to) = machine.counters.get_mut(usize::from(number)).filter(|_| areas.counters.contains(number)) {
                *to = counter;
                restored.counters += 1;
            }
        }
        Part::DataBlock { number, bytes, .. } => {
            let entry = machine.memory.data_block(u64::from(number)).expect("a part that fits has its data block");
            let start = entry.base as usize;
            machine.memory.arena[start..start + bytes.len()].copy_from_slice(bytes);
            restored.data_blocks.push(number);
        }
        Part::Created { number, attributes, bytes } => {
            created_data_blocks::create(machine, number, bytes, attributes.read_only);
            if attributes.non_retain {
                state.non_retain.insert(number);
            }
            restored.data_blocks.push(number);
        }
        Part::Loaded { number, bytes, .. } => {
            state.load_memory.insert(number, bytes.to_vec());
        }
        // It has its initial values, as the machine was cleared.
        Part::Gone { .. } => {}
    }
}
