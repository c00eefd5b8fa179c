//! Copies the retentive data of a CPU, and only what has changed since the last time.

use std::ops::Range;

use sieben_engine::Machine;

use super::areas::RetentiveAreas;
use super::declaration::Declarations;
use super::image::{self, CLOCK, METERS, RetainImage, VERSION};
use crate::created_data_blocks::{self, Created};
use crate::system_state::State;

/// A clock that is so much older than the last image makes a new one while a retentive timer runs: the unit of the timers.
const TIMER_UNIT_US: u64 = 10_000;
/// The same when none runs: run-time meters count hours, and a second of them may be lost.
const CLOCK_UNIT_US: u64 = 1_000_000;

/// The last image and where its bytes come from.
#[derive(Clone, Debug, Default)]
pub(crate) struct Keeper {
    image: RetainImage,
    /// Arena bytes and where they stand in the image.
    pieces: Vec<(Range<usize>, usize)>,
    /// Timers by number, and where they stand in the image.
    timers: Vec<(u16, usize)>,
    /// Counters by number, and where they stand in the image.
    counters: Vec<(u16, usize)>,
    /// Data blocks as they lay when the pieces were listed.
    created: Vec<Created>,
    /// Data blocks of the load memory that the program wrote, and where they stand in the image.
    loaded: Vec<(u16, usize)>,
    listed: bool,
}

impl Keeper {
    /// Forgets the last image: the next one is new whatever it holds.
    pub(crate) fn forget(&mut self) {
        *self = Self::default();
    }

    /// The image of the retentive data as it is now, if it differs from the last one.
    pub(crate) fn image(
        &mut self,
        machine: &Machine,
        state: &State,
        areas: &RetentiveAreas,
        declarations: &Declarations,
        scan: u64,
    ) -> Option<&RetainImage> {
        let created = created_data_blocks::created(machine, &state.non_retain);
        let mut changed = false;
        let loaded = state.load_memory.keys().eq(self.loaded.iter().map(|(number, _)| number));
        if !self.listed || created != self.created || !loaded {
            self.list(machine, state, areas, declarations, created);
            changed = true;
        }
        changed |= self.copy(machine, state);
        if changed || self.clock_is_old(machine) {
            self.image.scan = scan;
            self.image.layout = declarations.hash;
            self.head(machine, state);
            return Some(&self.image);
        }
        None
    }

    /// Lists where everything comes from, and makes room for it.
    fn list(&mut self, machine: &Machine, state: &State, areas: &RetentiveAreas, declarations: &Declarations, created: Vec<Created>) {
        let mut bytes = vec![0; image::HEAD_BYTES];
        bytes[0] = VERSION;
        (self.pieces, self.timers, self.counters, self.loaded) = Default::default();
        let memory = &machine.memory;
        let mut part = |letter: u8, number: u16, fields: &[u8], length: usize| {
            bytes.push(letter);
            bytes.extend(number.to_be_bytes());
            bytes.extend(fields);
            let at = bytes.len();
            bytes.resize(at + length, 0);
            at
        };
        let bit_memory = &memory.layout.bit_memory;
        for range in areas.bit_memory.below(bit_memory.len()) {
            // A length of 65536 does not fit into its field; no CPU type has so much bit memory.
            let length = range.len().min(usize::from(u16::MAX));
            let at = part(b'M', range.start as u16, &(length as u16).to_be_bytes(), length);
            let start = bit_memory.start + range.start;
            self.pieces.push((start..start + length, at));
        }
        for number in areas.timers.below(machine.timers.len()).flatten() {
            self.timers.push((number as u16, part(b'T', number as u16, &[], image::TIMER_BYTES)));
        }
        for number in areas.counters.below(machine.counters.len()).flatten() {
            self.counters.push((number as u16, part(b'C', number as u16, &[], image::COUNTER_BYTES)));
        }
        for (&number, declaration) in &declarations.blocks {
            let Some(entry) = memory.data_block(u64::from(number)) else { continue };
            let mut fields = declaration.to_be_bytes().to_vec();
            fields.extend(entry.length.to_be_bytes());
            let at = part(b'D', number, &fields, entry.length as usize);
            self.pieces.push((entry.base as usize..(entry.base + entry.length) as usize, at));
        }
        for &number in &declarations.gone {
            part(b'G', number, &[], 0);
        }
        for &Created { number, base, length, attributes } in &created {
            let mut fields = vec![image::attribute_byte(attributes)];
            fields.extend(length.to_be_bytes());
            let at = part(b'N', number, &fields, length as usize);
            self.pieces.push((base as usize..(base + length) as usize, at));
        }
        for (&number, values) in &state.load_memory {
            let mut fields = declarations.all.get(&number).copied().unwrap_or_default().hash.to_be_bytes().to_vec();
            fields.extend((values.len() as u32).to_be_bytes());
            self.loaded.push((number, part(b'L', number, &fields, values.len())));
        }
        self.image.bytes = bytes;
        self.created = created;
        self.listed = true;
    }

    /// Copies what has changed; whether anything has. Comparing costs a fraction of what writing would.
    fn copy(&mut self, machine: &Machine, state: &State) -> bool {
        let mut changed = false;
        let mut copy = |from: &[u8], at: usize, bytes: &mut Vec<u8>| {
            let to = &mut bytes[at..at + from.len()];
            if to != from {
                to.copy_from_slice(from);
                changed = true;
            }
        };
        for (range, at) in &self.pieces {
            copy(&machine.memory.arena[range.clone()], *at, &mut self.image.bytes);
        }
        for &(number, at) in &self.timers {
            copy(&image::timer_bytes(&machine.timers[usize::from(number)]), at, &mut self.image.bytes);
        }
        for &(number, at) in &self.counters {
            copy(&image::counter_bytes(&machine.counters[usize::from(number)]), at, &mut self.image.bytes);
        }
        for (values, &(_, at)) in state.load_memory.values().zip(&self.loaded) {
            copy(values, at, &mut self.image.bytes);
        }
        changed
    }

    fn clock_is_old(&self, machine: &Machine) -> bool {
        let mut clock = [0; 8];
        clock.copy_from_slice(&self.image.bytes[CLOCK]);
        let runs = self.timers.iter().any(|&(number, _)| machine.timers[usize::from(number)].running);
        let unit = if runs { TIMER_UNIT_US } else { CLOCK_UNIT_US };
        machine.clock_us.abs_diff(u64::from_be_bytes(clock)) >= unit
    }

    fn head(&mut self, machine: &Machine, state: &State) {
        self.image.bytes[CLOCK].copy_from_slice(&machine.clock_us.to_be_bytes());
        for (index, meter) in state.meters.iter().enumerate().take(METERS) {
            let at = CLOCK.end + 8 * index;
            self.image.bytes[at..at + 8].copy_from_slice(&meter.now(machine.clock_us).to_be_bytes());
        }
    }
}
