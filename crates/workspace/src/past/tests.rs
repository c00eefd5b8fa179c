//! Scans of the past, run again.

use sieben_cpu::{Rack, Settings, Station};
use sieben_engine::Interpreter;
use sieben_model::address::Operand;
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Name;

use super::*;
use crate::driver::{Driver, Surroundings};
use crate::gate::Gate;
use crate::pace::{Pace, Speed};
use crate::status::Desk;

/// A counter, and a word that follows a word from outside.
const PROGRAM: &str =
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW 10;\nL 1;\n+I;\nT MW 10;\nL MW 20;\nT MW 30;\nA I 0.0;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n";

struct Counted(u64);

impl Surroundings for Counted {
    fn before_scan(&mut self, _: &mut Plant) {
        self.0 = self.0.saturating_sub(1);
    }
    fn is_ended(&self) -> bool {
        self.0 == 0
    }
}

fn gate() -> (Gate, Desk) {
    let mut sources = Sources::default();
    sources.add("main.awl", PROGRAM);
    let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &sieben_lang::Options::default());
    let rack = Rack::with_background(&CpuType::ALL[0], Vec::new()).expect("an empty rack");
    let cpu = Cpu::load(&CpuType::ALL[0], Arc::new(compiled.program), Interpreter::load, rack, Settings::default());
    let desk = Desk::default();
    desk.past.switch_on();
    (Gate::new(Plant::new(cpu, Pace::new(Speed::Max, 10_000, u64::MAX, 0)), Box::new(|| 0)), desk)
}

fn run(gate: &Gate, desk: &Desk, scans: u64, is_first: bool) {
    let mut around = Counted(scans);
    let mut driver = Driver::new(gate, desk, &mut around);
    if is_first {
        driver.run(sieben_cpu::Restart::Warm)
    } else {
        driver.go_on()
    };
}

/// Values at the end of each scan.
struct Values<'n>(&'n [&'n str], Vec<(u64, Vec<u32>)>, Deaf);

impl Visitor for Values<'_> {
    fn tracer(&mut self) -> &mut dyn Tracer {
        &mut self.2
    }
    fn ended(&mut self, cpu: &Cpu, visited: Visited) -> Goes {
        let value = |name: &&str| cpu.read(&Operand::parse(name).expect("an address")).expect("a value");
        self.1.push((visited.scan, self.0.iter().map(value).collect()));
        Goes::On
    }
}

fn values(desk: &Desk, from: u64, to: u64, names: &[&str]) -> Vec<(u64, Vec<u32>)> {
    let mut values = Values(names, Vec::new(), Deaf);
    desk.past.visit(from, to, &mut Replayer::default(), &mut values).expect("they are kept");
    values.1
}

#[test]
fn every_scan_is_what_it_was_and_what_came_from_outside_comes_again() {
    let (gate, desk) = gate();
    run(&gate, &desk, 250, true);
    let word = |text: &str| Operand::parse(text).expect("an address");
    gate.enter(|plant| plant.cpu.modify(&word("MW 20"), 7).expect("bit memory")).expect("it runs");
    run(&gate, &desk, 30, false);
    gate.enter(|plant| {
        plant.cpu.modify(&word("MW 20"), 9).expect("bit memory");
        plant.cpu.modify(&word("MW 10"), 1_000).expect("bit memory");
    })
    .expect("it runs");
    run(&gate, &desk, 20, false);
    let (first, last) = desk.past.extent().expect("a past");
    assert_eq!((first.scan, last.scan), (1, 300));
    for (scan, seen) in values(&desk, 1, 300, &["MW 10", "MW 30"]) {
        let expected = match scan {
            1..=250 => [scan as u32, 0],
            251..=280 => [scan as u32, 7],
            _ => [1_000 + (scan as u32 - 280), 9],
        };
        assert_eq!(seen, expected, "scan {scan}");
    }
    // The same seen one by one, in any order.
    for scan in [300, 1, 281, 280, 100, 101, 102, 251] {
        assert_eq!(values(&desk, scan, scan, &["MW 10"]).len(), 1, "scan {scan}");
    }
    let outside = desk.past.visit(301, 400, &mut Replayer::default(), &mut Values(&[], Vec::new(), Deaf));
    assert_eq!(outside, Err(NotKept::Outside));
}

#[test]
fn the_statement_that_stored_last_is_found() {
    let (gate, desk) = gate();
    run(&gate, &desk, 20, true);
    let program = gate.enter(|plant| Arc::clone(plant.cpu.program())).expect("it runs");
    let name = |text: &str| Name::parse(text, &SymbolTable::default(), &program).expect("a name");
    let found = |text: &str, to: u64| {
        let name = name(text);
        let mut writer = LastWriter::of(&name);
        desk.past.visit(1, to, &mut Replayer::default(), &mut writer).expect("they are kept");
        writer.found.map(|writer| (writer.place.statement, writer.scan))
    };
    assert_eq!(found("MW 10", 20), Some((3, 20)));
    assert_eq!(found("MB 31", 12), Some((5, 12)));
    assert_eq!(found("Q 0.0", 20), Some((7, 20)));
    assert_eq!(found("MW 20", 20), None);
}

#[test]
fn what_is_too_old_goes_with_all_that_needs_it() {
    let (gate, desk) = gate();
    gate.enter(|plant| plant.pace.cycle_us = 1_000_000).expect("it runs");
    run(&gate, &desk, 1_000, true);
    let (first, last) = desk.past.extent().expect("a past");
    assert_eq!(last.scan, 1_000);
    assert!(last.time_us - first.time_us <= KEPT_US_MAX && first.scan <= 1_000 - 600 + APART + 1, "{first:?}");
    assert_eq!(values(&desk, 0, 1_000, &["MW 10"]).first(), Some(&(first.scan, vec![first.scan as u32])));
    assert!(desk.past.bytes() <= KEPT_BYTES_MAX);
}
