//! What a CPU keeps over restarts, hands out and takes back.

mod script;

use std::sync::Arc;

use script::{Script, Step, cpu, cpu_of, cpu_type, operand};
use sieben_cpu::retain::{Adoption, Numbers, Refusal};
use sieben_cpu::{
    Cpu, DataLoss, DiagnosticEntry, Loaded, OperatingMode, Rack, Restart, RetainImage, RetentiveAreas, Settings, Station, TimeSource,
    undeclared,
};
use sieben_engine::Program;
use sieben_model::program::DataBlock;

fn events(cpu: &Cpu) -> Vec<u16> {
    cpu.diagnostic_buffer().entries().map(DiagnosticEntry::event).collect()
}

fn values(cpu: &Cpu, names: &[&str]) -> Vec<u32> {
    names.iter().map(|name| cpu.read(&operand(name)).unwrap_or_else(|error| panic!("{name}: {error}"))).collect()
}

#[test]
fn each_restart_keeps_what_the_table_says() {
    const NAMES: &[&str] = &["MB 0", "MB 15", "MB 16", "MB 2047", "C 0", "C 7", "C 8", "T 0", "T 1", "QB 0"];
    // Retentive: MB 0 to 15, C 0 to 7, and T 1 by the settings.
    for (name, restart, expected) in [
        ("315-2PN/DP", Restart::Warm, [9, 9, 0, 0, 9, 9, 0, 0, 9, 0]),
        ("315-2PN/DP", Restart::Cold, [0; 10]),
        ("315-2PN/DP", Restart::Hot, [9, 9, 0, 0, 9, 9, 0, 0, 9, 0]),
        ("416-3", Restart::Warm, [9, 9, 0, 0, 9, 9, 0, 0, 9, 0]),
        ("416-3", Restart::Cold, [0; 10]),
        ("416-3", Restart::Hot, [9; 10]),
    ] {
        let retain = RetentiveAreas { timers: Numbers::range(1..=1), ..RetentiveAreas::default() };
        let mut cpu = cpu_of(name, &[(1, &[])], Settings { retain, ..Settings::default() });
        cpu.restart(Restart::Warm);
        for name in NAMES {
            cpu.modify(&operand(name), 9).unwrap();
        }
        cpu.restart(restart);
        assert_eq!(values(&cpu, NAMES), expected, "{name} {restart:?}");
    }
}

fn with_db(bytes: usize) -> Cpu {
    let block = DataBlock {
        number: 1,
        based_on: None,
        structure: Arc::default(),
        image: vec![1; bytes],
        read_only: false,
        non_retain: false,
        unlinked: false,
    };
    let program = Program { data: [(1, block)].into(), ..Program::default() };
    let cpu_type = cpu_type("315-2PN/DP");
    Cpu::load(cpu_type, Arc::new(program), |_, _| Arc::new(Script::new(&[(1, &[])])), Rack::simulated(cpu_type), Settings::default())
}

fn image_of_a_run() -> RetainImage {
    let mut cpu = with_db(4);
    cpu.restart(Restart::Warm);
    for (name, value) in [("MW 2", 7), ("MW 20", 7), ("DB1.DBW 2", 7), ("C 3", 7)] {
        cpu.modify(&operand(name), value).unwrap();
    }
    cpu.scan(0);
    cpu.scan(10_000);
    cpu.retain_image().unwrap().clone()
}

#[test]
fn data_survives_a_power_failure() {
    let image = image_of_a_run();
    assert_eq!(image.scan, 2);
    let mut cpu = with_db(4);
    let restored = cpu.restore(&image, Adoption::SameProgram).unwrap();
    assert_eq!((restored.scan, restored.bit_memory_bytes, restored.counters, restored.data_blocks), (2, 16, 8, vec![1]));
    cpu.restart(Restart::Warm);
    assert_eq!(values(&cpu, &["MW 2", "MW 20", "DB1.DBW 0", "DB1.DBW 2", "C 3"]), [7, 0, 0x0101, 7, 7]);
    assert_eq!(events(&cpu), [0x4302, 0x4301, 0x4300]);
    assert_eq!(cpu.machine().clock_us, 10_000, "the CPU clock goes on where it stood");
    cpu.restart(Restart::Cold);
    assert_eq!(values(&cpu, &["MW 2", "DB1.DBW 2", "C 3"]), [0, 0x0101, 0]);
    assert!(cpu.retain_image().is_some(), "what a cold restart deleted is deleted in the next image too");
}

#[test]
fn data_blocks_that_came_from_outside_do_not_make_it_another_program() {
    // Number, bytes of what is downloaded; then what is deleted, and what is in DB 1 after the next start.
    for (put, removed, expected) in [(Some((5, 2)), None, 7), (Some((1, 6)), None, 0x0101), (None, Some(1), 0x0101)] {
        let mut cpu = with_db(4);
        cpu.restart(Restart::Warm);
        cpu.modify(&operand("MW 2"), 7).unwrap();
        cpu.modify(&operand("DB1.DBW 2"), 7).unwrap();
        let put = put.map(|(number, bytes)| undeclared(number, vec![3; bytes]));
        let change = cpu.data_block_change(put.into_iter().collect(), removed.into_iter().collect());
        let loaded = Loaded::changed(&change, |_, _| Arc::new(Script::new(&[(1, &[])]))).expect("nothing uses it");
        cpu.change_data_blocks(loaded, &change).expect("the program is the same");
        cpu.scan(0);
        let image = cpu.retain_image().unwrap().clone();
        let mut next = with_db(4);
        let restored = next.restore(&image, Adoption::SameProgram).expect("the sources are as they were");
        assert_eq!(restored.initial.is_empty(), expected == 7);
        next.restart(Restart::Warm);
        assert_eq!(values(&next, &["MW 2", "DB1.DBW 2"]), [7, expected]);
    }
}

#[test]
fn a_refused_image_leaves_the_initial_values_and_an_entry() {
    let image = image_of_a_run();
    let mut cpu = with_db(6);
    assert!(matches!(cpu.restore(&image, Adoption::SameProgram), Err(Refusal::OtherProgram { .. })));
    let damaged = RetainImage { bytes: image.bytes[1..].to_vec(), ..image };
    assert_eq!(cpu.restore(&damaged, Adoption::WhatFits), Err(Refusal::Damaged));
    cpu.retentive_data_lost(DataLoss::Damaged);
    cpu.restart(Restart::Warm);
    assert_eq!(values(&cpu, &["MW 2", "DB1.DBW 2"]), [0, 0x0101]);
    assert_eq!(events(&cpu), [0x4302, 0x4301, 0x430E, 0x4309, 0x430E, 0x4309, 0x430E, 0x4309]);
    let text = cpu.diagnostic_buffer().text();
    assert!(text.contains("memory reset started automatically: retentive data was damaged"), "{text}");
    assert!(text.contains("memory reset started automatically: retentive data belonged to another program"), "{text}");
}

#[test]
fn the_program_goes_on_when_nothing_can_be_kept_and_ob_81_learns_it() {
    let mut without = with_db(4);
    without.restart(Restart::Warm);
    without.backup_failed();
    assert_eq!(without.scan(0).mode, OperatingMode::Run);
    without.backup_works();
    without.scan(10_000);
    assert_eq!(events(&without)[..2], [0x3822, 0x3922]);
    let mut cpu = cpu_of("416-3", &[(1, &[]), (81, &[Step::StartInformation(0, "MW 100")])], Settings::default());
    cpu.restart(Restart::Warm);
    for (event, now) in [(0x3922, 0), (0x3822, 10_000)] {
        if event == 0x3922 {
            cpu.backup_failed();
        } else {
            cpu.backup_works();
        }
        assert_eq!(cpu.scan(now).mode, OperatingMode::Run);
        assert_eq!(values(&cpu, &["MW 100"]), [event]);
    }
}

#[test]
fn a_scan_that_a_stop_from_outside_ends_is_not_handed_out() {
    let settings = Settings { time: TimeSource::Real, watchdog: std::time::Duration::MAX, ..Settings::default() };
    let mut cpu = cpu(&[(1, &[Step::Set("MB 0", 5), Step::Forever])], settings);
    cpu.restart(Restart::Warm);
    assert!(cpu.retain_image().is_some(), "the startup is whole");
    let request = cpu.stop_request();
    let mut now = 0;
    let mut clock = || {
        now += 1;
        if now == 10 {
            request.stop();
        }
        now
    };
    assert_eq!(cpu.scan_with(&mut clock, None).mode, OperatingMode::Stop);
    assert_eq!(values(&cpu, &["MB 0"]), [5]);
    assert!(cpu.retain_image().is_none());
    cpu.restart(Restart::Warm);
    assert!(cpu.retain_image().is_some(), "the CPU itself goes on with what it has");
}

#[test]
fn a_hot_restart_hands_out_nothing_before_the_interrupted_scan_has_ended() {
    let blocks: &[(u16, &[Step])] = &[(1, &[Step::Set("MB 0", 5), Step::Loop(3), Step::Set("MB 1", 5)])];
    let mut cpu = cpu_of("416-3", blocks, Settings::default());
    cpu.restart(Restart::Warm);
    assert!(cpu.retain_image().is_some());
    cpu.stop_request().hold();
    assert_eq!(cpu.scan(0).mode, OperatingMode::Hold);
    Station::stop(&mut cpu);
    assert!(cpu.retain_image().is_none());
    assert_eq!(cpu.restart(Restart::Hot), OperatingMode::Run);
    assert_eq!(values(&cpu, &["MB 0", "MB 1"]), [5, 0]);
    assert!(cpu.retain_image().is_none(), "half a scan");
    cpu.scan(10_000);
    assert_eq!(values(&cpu, &["MB 0", "MB 1"]), [5, 5]);
    assert!(cpu.retain_image().is_some());
}

#[test]
fn hold_hands_out_nothing_and_an_error_what_led_to_it() {
    let mut held = cpu(&[(1, &[Step::Set("MB 0", 5), Step::Loop(3)])], Settings::default());
    held.restart(Restart::Warm);
    held.stop_request().hold();
    assert_eq!(held.scan(0).mode, OperatingMode::Hold);
    assert!(held.retain_image().is_none());
    assert_eq!(held.resume(10_000).mode, OperatingMode::Run);
    assert!(held.retain_image().is_some());
    held.stop_request().hold();
    held.scan(20_000);
    Station::stop(&mut held);
    assert!(held.retain_image().is_none(), "the STOP ended a scan in the middle");

    let mut stopped = cpu(&[(1, &[Step::Set("MB 0", 5), Step::Sfc(46)])], Settings::default());
    stopped.restart(Restart::Warm);
    stopped.retain_image();
    assert_eq!(stopped.scan(0).mode, OperatingMode::Stop);
    assert!(stopped.retain_image().is_some());
    stopped.modify(&operand("MB 1"), 3).unwrap();
    assert!(stopped.retain_image().is_some(), "a programming device may write in STOP");
}

#[test]
fn a_memory_reset_leaves_nothing_but_the_diagnostic_buffer() {
    let mut cpu = with_db(4);
    cpu.restore(&image_of_a_run(), Adoption::SameProgram).unwrap();
    cpu.restart(Restart::Warm);
    cpu.memory_reset();
    assert_eq!(cpu.mode(), OperatingMode::Stop);
    assert_eq!(values(&cpu, &["MW 2", "DB1.DBW 2", "C 3"]), [0, 0x0101, 0]);
    assert_eq!(events(&cpu)[..3], [0x430E, 0x4307, 0x4303]);
    cpu.restart(Restart::Warm);
    assert_eq!(values(&cpu, &["MW 2", "DB1.DBW 2", "C 3"]), [0, 0x0101, 0]);
}
