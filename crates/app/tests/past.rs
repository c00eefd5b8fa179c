//! The past of a run: every scan that is kept is, in the interpreter, what it was in machine code.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use sieben_cpu::{Cpu, OperatingMode, Rack, Requester, Restart, Settings, TimeSource};
use sieben_engine::{Machine, StatementEvent, Tracer};
use sieben_jit::{Jit, StatusBits};
use sieben_sim::names::{Name, Setting};
use sieben_sim::wrap::{self, Fault};
use sieben_workspace::controller;
use sieben_workspace::past::{BYTES_MAX, Gone, Mark, TIME_US_MAX, Viewer};
use sieben_workspace::project::{Build, Overrides, Project};
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, End, Gate, Pace, Plant, Speed, Surroundings};

mod wild;

use wild::{Alarms, Wild};

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
    watched_gate(build, modules, || {})
}

/// As [`gate`]; whenever the clock is read, in a scan too, `look` is called.
fn watched_gate(build: &Build, modules: Modules, look: impl Fn() + Send + Sync + 'static) -> Gate {
    let settings = Settings { time: TimeSource::Real, ..controller::settings(build) };
    let engine = |program: &_, layout: &_| Jit::compiled(program, layout, StatusBits::Needed).expect("the example becomes machine code");
    let rack = match modules {
        Modules::OfTheProject => controller::rack(build),
        Modules::Wild => Rack::with_background(build.cpu, vec![Box::new(Wild::new(100..102, Alarms::None, 3))]).expect("the rack is empty"),
    };
    let cpu = Cpu::new(controller::loaded(build, engine), rack, settings);
    let looks = AtomicU64::new(0);
    let clock = move || {
        look();
        let asked = looks.fetch_add(1, Ordering::Relaxed);
        asked * 900 + asked / 17 * 12_000
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

fn check(desk: &Desk, seen: &Seen, what: &str) {
    let past = desk.past();
    let (oldest, newest) = past.range().expect("a past");
    let mut viewer = Viewer::default();
    let mut compared = 0;
    // Back and forth, as a hand on a timeline.
    for &scan in seen.machines.keys().rev().step_by(7).chain(seen.machines.keys()) {
        match viewer.at(past, scan) {
            Err(Gone::NotKept) => assert!(scan < oldest.scan || scan > newest.scan, "{what}, scan {scan} of {oldest:?} to {newest:?}"),
            Err(other) => panic!("{what}, scan {scan}: {other}"),
            Ok(found) => {
                assert_eq!(found.mark, Mark { scan, time_us: seen.times[&scan] }, "{what}");
                assert!(is_same(found.cpu.machine(), &seen.machines[&scan]), "{what}, scan {scan}");
                compared += 1;
            }
        }
    }
    assert!(compared >= seen.machines.len(), "{what}: {compared} of {}", seen.machines.len());
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
            desk.past().keep();
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
    desk.past().keep();
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
    let mut viewer = Viewer::default();
    let forced = |viewer: &mut Viewer, scan| viewer.at(desk.past(), scan).map(|seen| seen.cpu.forced().is_empty()).expect("it is kept");
    assert_eq!([40, 160, 200, 400].map(|scan| forced(&mut viewer, scan)), [true, true, false, true]);
}

/// Counts statements.
struct Counted(u64);

impl Tracer for Counted {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {
        self.0 += 1;
    }
}

#[test]
fn one_scan_is_traced_statement_by_statement() {
    let gate = gate(&example("dosing"), Modules::OfTheProject);
    let (desk, mut seen) = (Desk::default(), Seen { most: 200, ..Seen::default() });
    desk.past().keep();
    assert_eq!(Driver::new(&gate, &desk, &mut seen).run(Restart::Warm), End::Ended);
    let mut viewer = Viewer::default();
    for scan in [1, 7, 100, 101, 102, 101, 199, 3] {
        let mut counted = Counted(0);
        let found = viewer.traced(desk.past(), scan, &mut counted).expect("it is kept");
        assert_eq!(found.mark, Mark { scan, time_us: seen.times[&scan] });
        assert!(is_same(found.cpu.machine(), &seen.machines[&scan]), "scan {scan}");
        assert!((10..100).contains(&counted.0), "scan {scan}: {} statements", counted.0);
    }
    assert_eq!(viewer.at(desk.past(), 201).map(|_| ()), Err(Gone::NotKept));
    let mut values = Vec::new();
    let read = |found: sieben_workspace::past::Seen<'_>| {
        let scan = found.mark.scan;
        values.push((scan, is_same(found.cpu.machine(), &seen.machines[&scan])));
        values.len() < 50
    };
    viewer.each(desk.past(), (90, 1_000), read).expect("all can be replayed");
    assert_eq!(values, (90..140).map(|scan| (scan, true)).collect::<Vec<_>>());
    assert_eq!(desk.past().scan_at(seen.times[&77]), Some(77));
}

#[test]
fn scans_that_ended_are_seen_while_the_next_one_runs() {
    let desk = Arc::new(Desk::default());
    let newest = Arc::new(Mutex::new(Vec::new()));
    let look = {
        let (desk, newest) = (Arc::clone(&desk), Arc::clone(&newest));
        move || newest.lock().expect("one thread").push(desk.past().range().map(|(_, newest)| newest.scan))
    };
    let gate = watched_gate(&example("dosing"), Modules::OfTheProject, look);
    desk.past().keep();
    let mut seen = Seen { most: 250, ..Seen::default() };
    assert_eq!(Driver::new(&gate, &desk, &mut seen).run(Restart::Warm), End::Ended);
    let newest = newest.lock().expect("one thread");
    let looks: Vec<Option<u64>> = newest.iter().copied().skip_while(Option::is_none).collect();
    assert!(looks.len() > 500 && looks.is_sorted() && looks.last() >= Some(&Some(249)), "{looks:?}");
}

#[test]
fn the_past_has_bounds() {
    let gate = gate(&example("dosing"), Modules::OfTheProject);
    let (desk, mut seen) = (Desk::default(), Seen { most: 1, ..Seen::default() });
    assert_eq!(Driver::new(&gate, &desk, &mut seen).run(Restart::Warm), End::Ended);
    assert_eq!(desk.past().range(), None, "it is not kept without being asked");
    desk.past().keep();
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
    let (oldest, newest) = desk.past().range().expect("a past");
    assert!(newest.time_us - oldest.time_us <= TIME_US_MAX + 2_000_000, "{oldest:?} to {newest:?}");
    assert!(newest.time_us - oldest.time_us >= TIME_US_MAX - 2_000_000, "{oldest:?} to {newest:?}");
    assert!(desk.past().bytes() <= BYTES_MAX, "{}", desk.past().bytes());
    assert_eq!(Viewer::default().at(desk.past(), oldest.scan.saturating_sub(1)).map(|_| ()), Err(Gone::NotKept));
    desk.past().forget();
    go_on(&gate, &desk, &mut Seen::default(), 10);
    assert_eq!((desk.past().range(), desk.past().bytes()), (None, 0));
}
