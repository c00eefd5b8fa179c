//! The past of a run: every scan that is kept is, in the interpreter, what it was in machine code.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use sieben_cpu::{Cpu, IoModule, OperatingMode, Rack, Replayer, Requester, Restart, Settings, TimeSource};
use sieben_engine::{Machine, StatementEvent, Tracer};
use sieben_jit::{Jit, StatusBits};
use sieben_sim::names::{Name, Setting};
use sieben_sim::wrap::{self, Fault};
use sieben_workspace::controller;
use sieben_workspace::past::{BYTES_MAX, Goes, LastWriter, NotKept, TIME_US_MAX, Visited, Visitor};
use sieben_workspace::project::{Build, Overrides, Project};
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, End, Gate, Pace, Plant, Speed, Surroundings};

/// A module that cannot be copied: its inputs count what it is told and how time passes.
struct Wild(u8);

impl IoModule for Wild {
    fn name(&self) -> &str {
        "wild"
    }
    fn inputs(&self) -> std::ops::Range<u32> {
        100..102
    }
    fn outputs(&self) -> std::ops::Range<u32> {
        100..102
    }
    fn read(&self, _: u32, into: &mut [u8]) {
        into.fill(self.0);
    }
    fn write(&mut self, _: u32, from: &[u8]) {
        self.0 = self.0.wrapping_mul(31).wrapping_add(from[0]) | 1;
    }
    fn advance(&mut self, dt_us: u64) {
        self.0 = self.0.wrapping_add(dt_us as u8);
    }
}

/// What a CPU was at the end of each scan.
#[derive(Default)]
struct Seen {
    most: u64,
    machines: BTreeMap<u64, Machine>,
    times: BTreeMap<u64, u64>,
}

impl Surroundings for Seen {
    fn after_scan(&mut self, plant: &mut Plant) {
        if plant.cpu.mode() != OperatingMode::Stop {
            self.machines.insert(plant.scans, plant.cpu.machine().clone());
            self.times.insert(plant.scans, plant.cpu.time_us());
        }
        self.most = self.most.saturating_sub(1);
    }
    fn is_ended(&self) -> bool {
        self.most == 0
    }
}

fn example(name: &str) -> Build {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    let read = |file: &str| std::fs::read(folder.join(file)).unwrap_or_else(|error| panic!("{name}/{file}: {error}"));
    let mut project = Project::default();
    project.add_settings(Path::new("sieben.toml"), &read("sieben.toml"));
    for file in project.settings.sources.clone().unwrap_or_default() {
        project.add_source(Path::new(&file.text), &read(&file.text));
    }
    project.add_symbols(Path::new("symbols.csv"), &read("symbols.csv")).expect("the assignment table can be read");
    let build = project.compile(Overrides::default(), false);
    assert!(!sieben_workspace::finding::has_errors(&build.findings), "{:?}", build.findings);
    build
}

/// What is plugged.
#[derive(Clone, Copy)]
enum Modules {
    OfTheProject,
    Wild,
}

/// A gate whose clock is late again and again, before a project that runs in machine code and real time.
fn gate(build: &Build, modules: Modules) -> Gate {
    let settings = Settings { time: TimeSource::Real, ..controller::settings(build) };
    let engine = |program: &_, layout: &_| Jit::compiled(program, layout, StatusBits::Needed).expect("the example becomes machine code");
    let rack = match modules {
        Modules::OfTheProject => controller::rack(build),
        Modules::Wild => Rack::with_background(build.cpu, vec![Box::new(Wild(3))]).expect("the rack is empty"),
    };
    let cpu = Cpu::new(controller::loaded(build, engine), rack, settings);
    let looks = AtomicU64::new(0);
    let clock = move || {
        let look = looks.fetch_add(1, Ordering::Relaxed);
        look * 900 + look / 17 * 12_000
    };
    let mut plant = Plant::new(cpu, Pace::new(Speed::Factor(1.0), 10_000, u64::MAX, 0));
    plant.stay_in_stop();
    Gate::new(plant, Box::new(clock))
}

fn go_on(gate: &Gate, desk: &Desk, seen: &mut Seen, scans: u64) {
    seen.most = scans;
    assert_eq!(Driver::new(gate, desk, seen).go_on(), End::Ended);
}

/// What a program can see of two machines is the same.
fn is_same(one: &Machine, other: &Machine) -> bool {
    one.memory.arena == other.memory.arena && one.timers == other.timers && one.counters == other.counters && one.clock_us == other.clock_us
}

/// Counts statements, and tells how the CPU stands at the end of each scan.
struct Look<F> {
    statements: u64,
    ended: F,
}

impl<F> Tracer for Look<F> {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {
        self.statements += 1;
    }
}

impl<F: FnMut(&Cpu, Visited, u64) -> Goes> Visitor for Look<F> {
    fn tracer(&mut self) -> &mut dyn Tracer {
        self
    }
    fn ended(&mut self, cpu: &Cpu, visited: Visited) -> Goes {
        (self.ended)(cpu, visited, std::mem::take(&mut self.statements))
    }
}

fn visit(desk: &Desk, from: u64, to: u64, replayer: &mut Replayer, ended: impl FnMut(&Cpu, Visited, u64) -> Goes) -> Result<(), NotKept> {
    desk.past.visit(from, to, replayer, &mut Look { statements: 0, ended })
}

/// Each scan that was seen is what it was, one by one and all in a row.
fn check(desk: &Desk, seen: &Seen, what: &str) {
    let mut replayer = Replayer::default();
    let compare = |cpu: &Cpu, visited: Visited| {
        assert_eq!(visited.time_us, seen.times[&visited.scan], "{what}, scan {}", visited.scan);
        assert!(is_same(cpu.machine(), &seen.machines[&visited.scan]), "{what}, scan {}", visited.scan);
    };
    // Back and forth, as a hand on a timeline.
    for &scan in seen.machines.keys().rev().step_by(7).chain(seen.machines.keys().step_by(3)) {
        let mut found = Vec::new();
        let ended = |cpu: &Cpu, visited: Visited, _| {
            found.push(visited.scan);
            compare(cpu, visited);
            Goes::No
        };
        assert_eq!(visit(desk, scan, scan, &mut replayer, ended), Ok(()), "{what}, scan {scan}");
        assert_eq!(found, [scan], "{what}");
    }
    let mut all = Vec::new();
    let ended = |cpu: &Cpu, visited: Visited, _| {
        all.push(visited.scan);
        compare(cpu, visited);
        Goes::On
    };
    assert_eq!(visit(desk, 0, u64::MAX, &mut replayer, ended), Ok(()), "{what}");
    assert!(all.iter().eq(seen.machines.keys()), "{what}: {all:?}");
}

fn set(gate: &Gate, name: &str, value: &str) {
    let build = gate.look(|plant| plant.cpu.program().clone()).expect("the gate is open");
    let name = Name::parse(name, &sieben_model::symbols::SymbolTable::default(), &build).expect("a name");
    let setting = Setting::new(name, value).expect("a value");
    gate.enter(|plant| setting.apply(&mut plant.cpu)).expect("the gate is open").expect("it can be set");
}

#[test]
fn each_scan_of_the_examples_can_be_seen_again() {
    for name in
        ["car-park", "conveyor", "decade-switches", "dosing", "elevator", "heater", "packing", "star-delta", "tank", "traffic-light"]
    {
        for modules in [Modules::OfTheProject, Modules::Wild] {
            let gate = gate(&example(name), modules);
            let (desk, mut seen) = (Desk::default(), Seen { most: 150, ..Seen::default() });
            desk.past.switch_on();
            assert_eq!(Driver::new(&gate, &desk, &mut seen).run(Restart::Warm), End::Ended);
            for (input, value) in [("I0.0", "1"), ("I0.1", "1"), ("I0.0", "0"), ("MW200", "16#1234"), ("I0.2", "1")] {
                set(&gate, input, value);
                go_on(&gate, &desk, &mut seen, 60);
            }
            gate.enter(|plant| plant.stop(Requester::default())).expect("the gate is open");
            go_on(&gate, &desk, &mut seen, 30);
            gate.enter(|plant| plant.ask_for_start(Restart::Warm, Requester::default())).expect("the gate is open");
            go_on(&gate, &desk, &mut seen, 150);
            check(&desk, &seen, name);
        }
    }
}

#[test]
fn faults_and_forces_belong_to_the_past() {
    let gate = gate(&example("tank"), Modules::OfTheProject);
    let (desk, mut seen) = (Desk::default(), Seen { most: 50, ..Seen::default() });
    desk.past.switch_on();
    assert_eq!(Driver::new(&gate, &desk, &mut seen).run(Restart::Warm), End::Ended);
    let fault = Fault::parse("tank.level stuck=0").expect("a fault");
    gate.enter(|plant| wrap::inject(plant.cpu.rack_mut(), &fault).map(drop)).expect("the gate is open").expect("the tank has a level");
    go_on(&gate, &desk, &mut seen, 120);
    let output = sieben_model::address::Operand::parse("Q 0.0").expect("an operand");
    gate.enter(|plant| plant.cpu.force(&output, 1)).expect("the gate is open").expect("outputs can be forced");
    go_on(&gate, &desk, &mut seen, 120);
    gate.enter(|plant| plant.cpu.unforce_all()).expect("the gate is open");
    go_on(&gate, &desk, &mut seen, 120);
    check(&desk, &seen, "tank");
    let is_forced = |scan| {
        let mut forced = false;
        let ended = |cpu: &Cpu, _: Visited, _| {
            forced = !cpu.forced().is_empty();
            Goes::No
        };
        visit(&desk, scan, scan, &mut Replayer::default(), ended).expect("it is kept");
        forced
    };
    assert_eq!([40, 160, 200, 400].map(is_forced), [false, false, true, false]);
}

#[test]
fn one_scan_is_told_statement_by_statement() {
    let gate = gate(&example("dosing"), Modules::OfTheProject);
    let (desk, mut seen) = (Desk::default(), Seen { most: 200, ..Seen::default() });
    desk.past.switch_on();
    assert_eq!(Driver::new(&gate, &desk, &mut seen).run(Restart::Warm), End::Ended);
    let mut replayer = Replayer::default();
    for scan in [1, 7, 100, 101, 102, 101, 199, 3] {
        let ended = |_: &Cpu, _: Visited, statements| {
            assert!((10..100).contains(&statements), "scan {scan}: {statements} statements");
            Goes::No
        };
        visit(&desk, scan, scan, &mut replayer, ended).expect("it is kept");
    }
    assert_eq!(visit(&desk, 201, 300, &mut replayer, |_, _, _| Goes::On), Err(NotKept::Outside));
    assert_eq!(desk.past.scan_at(seen.times[&77]), Some(77));
    let program = gate.look(|plant| plant.cpu.program().clone()).expect("the gate is open");
    let name = Name::parse("QW4", &sieben_model::symbols::SymbolTable::default(), &program).expect("a name");
    for to in [50, 200] {
        let mut writer = LastWriter::of(&name);
        desk.past.visit(1, to, &mut replayer, &mut writer).expect("they are kept");
        assert_eq!(writer.found.map(|writer| writer.scan), Some(to), "the display is written in every scan");
    }
}

#[test]
fn the_past_has_bounds() {
    let gate = gate(&example("dosing"), Modules::OfTheProject);
    let (desk, mut seen) = (Desk::default(), Seen { most: 1, ..Seen::default() });
    assert_eq!(Driver::new(&gate, &desk, &mut seen).run(Restart::Warm), End::Ended);
    assert_eq!(desk.past.extent(), None, "it is not kept without being asked");
    desk.past.switch_on();
    let quicker = |plant: &mut Plant| {
        plant.pace.set_speed(Speed::Max, 0);
        plant.pace.cycle_us = 100_000;
    };
    gate.enter(quicker).expect("the gate is open");
    // Twenty minutes of the plant, with something that comes in each second of the first five.
    for _ in 0..300 {
        set(&gate, "MW200", "7");
        go_on(&gate, &desk, &mut Seen::default(), 10);
    }
    go_on(&gate, &desk, &mut Seen::default(), 9_000);
    let (oldest, newest) = desk.past.extent().expect("a past");
    assert!(newest.time_us - oldest.time_us <= TIME_US_MAX + 2_000_000, "{oldest:?} to {newest:?}");
    assert!(newest.time_us - oldest.time_us >= TIME_US_MAX - 2_000_000, "{oldest:?} to {newest:?}");
    assert!(desk.past.bytes() <= BYTES_MAX, "{}", desk.past.bytes());
    let before = visit(&desk, 0, oldest.scan - 1, &mut Replayer::default(), |_, _, _| Goes::On);
    assert_eq!(before, Err(NotKept::Outside));
    desk.past.switch_off();
    go_on(&gate, &desk, &mut Seen::default(), 10);
    assert_eq!((desk.past.extent(), desk.past.bytes()), (None, 0));
}
