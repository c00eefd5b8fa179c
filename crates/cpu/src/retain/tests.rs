//! An image that is taken back gives the data it was made of, and any other is refused.

use std::sync::Arc;

use proptest::prelude::*;
use sieben_engine::machine::TimerKind;
use sieben_engine::{Layout, Machine, Program};
use sieben_model::cpu_type::CpuType;
use sieben_model::program::DataBlock;

use super::*;
use crate::created_data_blocks;
use crate::system_state;

/// A machine of a program with DB 1 (retentive), DB 2 (NON_RETAIN), DB 3 (READ_ONLY) and DB 4 (UNLINKED), 8 bytes each.
struct Plant {
    machine: Machine,
    state: system_state::State,
    areas: RetentiveAreas,
    declarations: Declarations,
    keeper: Keeper,
}

fn program() -> Program {
    let block = |number, read_only, non_retain, unlinked| DataBlock {
        number,
        based_on: None,
        structure: Arc::default(),
        image: vec![0x55; 8],
        read_only,
        non_retain,
        unlinked,
    };
    let blocks = [block(1, false, false, false), block(2, false, true, false), block(3, true, false, false), block(4, false, false, true)];
    Program { data: blocks.into_iter().map(|block| (block.number, block)).collect(), ..Program::default() }
}

impl Plant {
    fn of(program: &Program) -> Self {
        let layout = Arc::new(Layout::new(&CpuType::ALL[0], program));
        let numbers = |text: &str| Numbers::parse(text).unwrap();
        Self {
            machine: Machine::new(layout),
            state: system_state::State::default(),
            areas: RetentiveAreas { bit_memory: numbers("0..15, 100"), timers: numbers("2..3"), counters: numbers("0..7") },
            declarations: Declarations::of(program),
            keeper: Keeper::default(),
        }
    }
    fn new() -> Self {
        Self::of(&program())
    }
    fn image(&mut self) -> Option<RetainImage> {
        self.keeper.image(&self.machine, &self.state, &self.areas, &self.declarations, 7).cloned()
    }
    fn restore(&mut self, image: &RetainImage, adoption: Adoption) -> Result<Restored, Refusal> {
        Ok(judge(image, adoption, &self.machine, &self.declarations)?.put(&mut self.machine, &mut self.state, &self.areas))
    }
    fn data_block(&mut self, number: u64) -> &mut [u8] {
        let entry = self.machine.memory.data_block(number).unwrap();
        &mut self.machine.memory.arena[entry.base as usize..(entry.base + entry.length) as usize]
    }
    /// One with values everywhere.
    fn in_use() -> Self {
        let mut plant = Self::new();
        plant.machine.clock_us = 10_000_000;
        for byte in &mut plant.machine.memory.arena {
            *byte = 0xA5;
        }
        for timer in &mut plant.machine.timers {
            timer.start(TimerKind::OnDelay, true, 0x2015, 7_000_000);
        }
        for counter in &mut plant.machine.counters {
            counter.set(true, 0x0123);
        }
        created_data_blocks::create(&mut plant.machine, 20, &[1, 2, 3, 4, 5, 6], true);
        created_data_blocks::create(&mut plant.machine, 21, &[7; 10], false);
        plant.state.non_retain.insert(21);
        plant.state.load_memory.insert(4, vec![0x77; 8]);
        plant.state.meters[3] = system_state::Meter { shown_us: 5_000_000, since_us: Some(9_000_000) };
        plant
    }
}

#[test]
fn what_is_retentive_comes_back_and_nothing_else() {
    let image = Plant::in_use().image().unwrap();
    let mut plant = Plant::new();
    let restored = plant.restore(&image, Adoption::SameProgram).unwrap();
    let expected = Restored { scan: 7, bit_memory_bytes: 17, timers: 2, counters: 8, data_blocks: vec![1, 20, 21], ..Restored::default() };
    assert_eq!(restored, expected);
    let memory = plant.machine.memory.area(sieben_model::address::Area::BitMemory);
    for (number, &byte) in memory.iter().enumerate() {
        assert_eq!(byte == 0xA5, number < 16 || number == 100, "MB {number}");
    }
    assert_eq!(plant.data_block(1), [0xA5; 8]);
    for number in [2, 3] {
        assert_eq!(plant.data_block(number), [0; 8], "DB {number} is a matter of the load memory");
    }
    assert_eq!((plant.data_block(20).to_vec(), plant.data_block(21).to_vec()), (vec![1, 2, 3, 4, 5, 6], vec![7; 10]));
    let attributes =
        |number| (plant.machine.memory.data_block(number).unwrap().read_only, plant.state.non_retain.contains(&(number as u16)));
    assert_eq!([attributes(20), attributes(21)], [(true, false), (false, true)]);
    assert_eq!(plant.state.load_memory, [(4, vec![0x77; 8])].into());
    // 15 s, of which 3 s have passed.
    let remaining: Vec<u16> = plant.machine.timers[..5].iter().map(|timer| timer.remaining(plant.machine.clock_us)).collect();
    assert_eq!(remaining, [0, 0, 12, 12, 0]);
    assert!(plant.machine.timers[2].running && plant.machine.timers[2].start_edge);
    assert_eq!(plant.machine.counters.iter().filter(|counter| counter.count == 123 && counter.set_edge).count(), 8);
    assert_eq!(plant.state.meters[3], system_state::Meter { shown_us: 6_000_000, since_us: None });
    assert_eq!(plant.image().map(|again| again.bytes), Some(image.bytes), "the image of what was restored is the same image");
}

#[test]
fn an_image_is_handed_out_when_something_has_changed() {
    let mut plant = Plant::in_use();
    plant.machine.timers.fill(Default::default());
    assert!(plant.image().is_some());
    assert!(plant.image().is_none());
    plant.data_block(2)[0] ^= 1;
    plant.machine.memory.area_mut(sieben_model::address::Area::BitMemory)[50] ^= 1;
    plant.machine.counters[8].count = 5;
    assert!(plant.image().is_none(), "what is not retentive does not count");
    plant.data_block(1)[7] ^= 1;
    assert!(plant.image().is_some());
    plant.machine.counters[7].count = 5;
    assert!(plant.image().is_some());
    plant.data_block(21)[9] ^= 1;
    assert!(plant.image().is_some());
    created_data_blocks::delete_created(&mut plant.machine);
    let image = plant.image().unwrap();
    assert!(plant.image().is_none());
    assert_eq!(Plant::new().restore(&image, Adoption::SameProgram).unwrap().data_blocks, [1]);
    plant.machine.clock_us += 999_999;
    assert!(plant.image().is_none());
    plant.machine.clock_us += 1;
    assert!(plant.image().is_some(), "run-time meters lose at most a second");
    plant.machine.timers[2].start(TimerKind::OnDelay, true, 0x2015, plant.machine.clock_us);
    assert!(plant.image().is_some());
    plant.machine.clock_us += 10_000;
    assert!(plant.image().is_some(), "the clock counts while a retentive timer runs");
    plant.keeper.forget();
    assert!(plant.image().is_some());
}

#[test]
fn the_image_of_another_program_is_refused_or_taken_as_far_as_it_fits() {
    let image = Plant::in_use().image().unwrap();
    let mut other = program();
    other.data.get_mut(&1).unwrap().image.push(0);
    other.data.insert(9, DataBlock { number: 9, ..other.data[&1].clone() });
    let mut plant = Plant::of(&other);
    let before = plant.machine.clone();
    let refusal = plant.restore(&image, Adoption::SameProgram).unwrap_err();
    assert_eq!(refusal, Refusal::OtherProgram { left_out: vec![1], initial: vec![1, 9] });
    assert_eq!(refusal.to_string(), "it belongs to a program with other data blocks (DB 1, DB 9)");
    assert_eq!(plant.machine, before, "nothing has changed");
    let restored = plant.restore(&image, Adoption::WhatFits).unwrap();
    assert_eq!((restored.left_out, restored.initial, restored.data_blocks), (vec![1], vec![1, 9], vec![20, 21]));
    assert_eq!(plant.data_block(1), [0; 9]);
    assert_eq!(restored.bit_memory_bytes, 17);
    // A number that the program has meanwhile cannot be created.
    let mut taken = program();
    taken.data.insert(20, DataBlock { number: 20, unlinked: true, ..taken.data[&1].clone() });
    assert_eq!(Plant::of(&taken).restore(&image, Adoption::WhatFits).unwrap().left_out, [20, 21]);
}

#[test]
fn what_was_written_to_the_load_memory_goes_with_new_initial_values() {
    let mut plant = Plant::in_use();
    let image = plant.image().unwrap();
    assert!(plant.image().is_none());
    plant.state.load_memory.get_mut(&4).unwrap()[0] = 0;
    assert!(plant.image().is_some(), "a changed byte");
    plant.state.load_memory.insert(1, vec![0; 8]);
    assert!(plant.image().is_some(), "one block more");
    let mut changed = program();
    changed.data.get_mut(&4).unwrap().image[7] = 0;
    let mut plant = Plant::of(&changed);
    plant.state.load_memory.insert(1, vec![3; 8]);
    plant.restore(&image, Adoption::SameProgram).unwrap();
    assert!(plant.state.load_memory.is_empty());
    // Its part stands last: a length, and the eight bytes. Half of them are not this block.
    let mut shorter = image.clone();
    let end = shorter.bytes.len();
    shorter.bytes[end - 9] = 4;
    shorter.bytes.truncate(end - 4);
    assert!(shorter.is_sound());
    let mut plant = Plant::new();
    plant.restore(&shorter, Adoption::SameProgram).unwrap();
    assert!(plant.state.load_memory.is_empty());
}

#[test]
fn a_run_time_meter_may_show_whatever_the_program_set() {
    for hours in [0, 32_767, u64::from(i32::MAX as u32)] {
        let mut plant = Plant::new();
        plant.state.meters[0] = system_state::Meter { shown_us: hours * 3_600_000_000, since_us: None };
        let image = plant.image().unwrap();
        assert!(image.is_sound(), "{hours} h");
        let mut again = Plant::new();
        again.restore(&image, Adoption::SameProgram).unwrap();
        assert_eq!(again.state.meters, plant.state.meters);
    }
}

#[test]
fn a_changed_retentive_range_takes_what_it_has() {
    let image = Plant::in_use().image().unwrap();
    let mut plant = Plant::new();
    plant.areas.bit_memory = Numbers::parse("8..20, 60000").unwrap();
    plant.areas.counters = Numbers::default();
    let restored = plant.restore(&image, Adoption::SameProgram).unwrap();
    assert_eq!((restored.bit_memory_bytes, restored.counters), (8, 0));
    assert!(plant.image().is_some_and(|image| image.is_sound()));
}

#[test]
fn every_cut_image_is_refused_and_no_changed_byte_panics() {
    let image = Plant::in_use().image().unwrap();
    assert!(image.is_sound());
    let mut refused = 0;
    for at in 0..image.bytes.len() {
        let cut = RetainImage { bytes: image.bytes[..at].to_vec(), ..image.clone() };
        // A cut between two parts leaves an image without the later ones; it is not this program's.
        let answer = Plant::new().restore(&cut, Adoption::SameProgram);
        refused += usize::from(answer.is_err());
        for value in [0, 1, 0x7F, 0xFF, image.bytes[at] ^ 0x10] {
            let mut changed = image.clone();
            changed.bytes[at] = value;
            let mut plant = Plant::new();
            if plant.restore(&changed, Adoption::WhatFits).is_ok() {
                assert!(plant.image().is_some_and(|image| image.is_sound()), "byte {at} = {value}");
            }
        }
    }
    // Only between parts behind DB 1 a cut is an image again: before DB 20, DB 21 and DB 4 of the load memory.
    assert_eq!(image.bytes.len() - refused, 3);
}

#[test]
fn created_data_blocks_that_do_not_fit_are_not_made() {
    let mut image = Plant::new().image().unwrap();
    let created = |number: u16, length: u32| {
        let mut bytes = vec![b'N'];
        bytes.extend(number.to_be_bytes());
        bytes.push(0);
        bytes.extend(length.to_be_bytes());
        bytes.extend(vec![9; length as usize]);
        bytes
    };
    let head = image.bytes.clone();
    for (parts, fits) in [
        (vec![created(30, 65_536)], true),
        (vec![created(30, 65_536), created(31, 2)], false),
        (vec![created(30, 40_000), created(31, 40_000)], false),
        (vec![created(30, 2), created(30, 2)], false),
        (vec![created(0, 2)], false),
        (vec![created(30, 0)], false),
        (vec![created(30, 3)], false),
        (vec![created(1, 2)], false),
        (vec![created(4, 2)], false),
        (vec![created(16_001, 2)], false),
    ] {
        image.bytes = [head.clone(), parts.concat()].concat();
        assert_eq!(Plant::new().restore(&image, Adoption::SameProgram).is_ok(), fits, "{} parts", parts.len());
        let mut plant = Plant::new();
        plant.restore(&image, Adoption::WhatFits).unwrap();
        assert_eq!(created_data_blocks::created(&plant.machine, &plant.state.non_retain).is_empty(), !fits);
    }
}

proptest! {
    #[test]
    fn no_bytes_panic(bytes in prop::collection::vec(any::<u8>(), 0..200), letter in prop::sample::select(b"MTCDNL".to_vec())) {
        fuzz(&bytes);
        let mut image = Plant::new().image().unwrap();
        image.bytes.push(letter);
        image.bytes.extend(bytes);
        fuzz(&image.bytes);
        let _ = Plant::new().restore(&image, Adoption::WhatFits);
    }
}
