//! The gate: threads that come to a running CPU between two scans, and the status of a scan.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use sieben_cpu::{Cpu, IoModule, OperatingMode, Rack, Requester, Restart, Settings, Station, TimeSource};
use sieben_model::address::Area;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::item::Item;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::value::{Content, Value};
use sieben_workspace::gate::{Closed, ITEMS_MAX, ListError};
use sieben_workspace::pace::Missed;
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, End, Gate, Pace, Plant, Speed, Surroundings};

#[allow(dead_code)] // The pages need more of it.
mod program;
mod wild;

use wild::{Alarms, Wild};

/// Counts scans twice, with work between: whoever looks inside a scan sees two different numbers. What comes in as two equal words has to be
/// equal for the whole scan.
const COUNTS: &str = "
ORGANIZATION_BLOCK OB 1
VAR_TEMP info : ARRAY [0..19] OF BYTE; i : INT; END_VAR
BEGIN
L MW 0; L 1; +I; T MW 0;
L MW 20; T MW 30;
L 200;
next: T #i; L MW 40; L #i; +I; T MW 40; L #i; LOOP next;
L MW 22; L MW 30; <>I; S M 50.0;
L MW 0; T MW 2;
END_ORGANIZATION_BLOCK
";

/// Ends a run.
#[derive(Default)]
struct Around {
    over: AtomicBool,
}

impl Surroundings for &Around {
    fn is_ended(&self) -> bool {
        self.over.load(Ordering::Relaxed)
    }
}

fn cpu(text: &str, name: &str, settings: Settings) -> Cpu {
    cpu_with(text, name, settings, Vec::new())
}

fn cpu_with(text: &str, name: &str, settings: Settings, modules: Vec<Box<dyn IoModule>>) -> Cpu {
    let cpu_type = CpuType::ALL.iter().find(|cpu| cpu.name == name).expect("a CPU type");
    let compiled = program::compile(text, Mnemonics::English, cpu_type).unwrap_or_else(|error| panic!("{error}"));
    let (_, load) = program::ENGINES[1];
    let rack = Rack::with_background(cpu_type, modules).expect("the modules lie in the area");
    Cpu::load(cpu_type, compiled.program.into(), load, rack, settings)
}

fn real_time() -> Settings {
    Settings { time: TimeSource::Real, watchdog: Duration::from_secs(5), ..Settings::default() }
}

/// A run with its threads: `outside` is what happens while it runs; then it is ended.
fn run<R>(cpu: Cpu, speed: Speed, cycle_us: u64, outside: impl FnOnce(&Gate, &Desk) -> R) -> (End, Left, R) {
    let begin = Instant::now();
    let clock = move || begin.elapsed().as_micros() as u64;
    let gate = Gate::new(Plant::new(cpu, Pace::new(speed, cycle_us, u64::MAX, clock())), Box::new(clock));
    let (desk, around) = (Desk::default(), Around::default());
    let (end, answer) = std::thread::scope(|scope| {
        let scans = scope.spawn(|| {
            let mut surroundings = &around;
            let end = Driver::new(&gate, &desk, &mut surroundings).run(Restart::Warm);
            gate.close();
            end
        });
        scope.spawn(|| desk.replay(|| gate.is_closed()));
        let answer = catch_unwind(AssertUnwindSafe(|| outside(&gate, &desk)));
        around.over.store(true, Ordering::Relaxed);
        gate.wake();
        (scans.join().expect("the run ends"), answer.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    });
    let plant = gate.finish(|plant| Left { mode: plant.cpu.mode(), scans: plant.scans, marked: word(&plant.cpu, 50) & 0x100 != 0 });
    (end, plant, answer)
}

/// What is left of a run.
struct Left {
    mode: OperatingMode,
    scans: u64,
    marked: bool,
}

fn item(byte: u32) -> Item {
    Item::area(Area::BitMemory, byte, 2)
}

fn word(cpu: &Cpu, byte: u32) -> u16 {
    cpu.read_items(&[item(byte)]).remove(0).map(|value| number(&value)).unwrap_or_default()
}

fn number(value: &Value) -> u16 {
    match &value.content {
        Content::Bytes(bytes) => bytes.iter().fold(0, |number, &byte| number << 8 | u16::from(byte)),
        Content::Bits(bits) => *bits as u16,
    }
}

fn read(gate: &Gate, bytes: &[u32]) -> Result<(u64, Vec<u16>), ListError> {
    let items: Vec<Item> = bytes.iter().map(|&byte| item(byte)).collect();
    gate.read(&items).map(|(scan, values)| (scan, values.iter().map(|value| number(value.as_ref().expect("bit memory"))).collect()))
}

#[test]
fn what_is_read_belongs_to_one_scan_and_what_is_written_falls_between_two() {
    for (speed, cycle_us) in [(Speed::Factor(1.0), 2_000), (Speed::Factor(1.0), 0), (Speed::Factor(20.0), 10_000), (Speed::Max, 10_000)] {
        let (end, plant, reads) = run(cpu(COUNTS, "315-2PN/DP", real_time()), speed, cycle_us, |gate, _| {
            let until = Instant::now() + Duration::from_millis(150);
            // On a busy computer each of them comes in less often.
            let latest = until + Duration::from_secs(10);
            std::thread::scope(|scope| {
                let readers: Vec<_> = (0..4)
                    .map(|reader| {
                        scope.spawn(move || {
                            let (mut reads, mut last) = (0_u64, 0);
                            while Instant::now() < until || reads <= 3 && Instant::now() < latest {
                                let (scan, values) = read(gate, &[0, 2]).expect("the run goes on");
                                assert_eq!(values[0], values[1], "half of a scan");
                                assert_eq!(values[0], scan as u16, "another scan");
                                assert!(scan >= last, "back in time");
                                last = scan;
                                reads += 1;
                                let both = Value::bytes((reads as u16).to_be_bytes());
                                let write = [(item(20), both.clone()), (item(22), both)];
                                gate.write(&write).expect("the run goes on");
                                if reader == 0 {
                                    std::thread::sleep(Duration::from_micros(300));
                                }
                            }
                            reads
                        })
                    })
                    .collect();
                readers.into_iter().map(|reader| reader.join().expect("a reader")).collect::<Vec<u64>>()
            })
        });
        assert_eq!((end, plant.mode), (End::Ended, OperatingMode::Run));
        assert!(!plant.marked, "{speed:?}: a word was written inside a scan");
        assert!(reads.iter().all(|&reads| reads > 3), "{speed:?}: all of them come in: {reads:?}");
        assert!(plant.scans > 3, "{speed:?}: the scans go on: {}", plant.scans);
    }
}

#[test]
fn a_list_that_is_too_long_and_a_run_that_is_over_are_told() {
    let (_, _, gone) = run(cpu(COUNTS, "315-2PN/DP", real_time()), Speed::Factor(1.0), 1_000, |gate, _| {
        let many: Vec<Item> = (0..=ITEMS_MAX as u32).map(item).collect();
        assert_eq!(gate.read(&many).err(), Some(ListError::TooLong(ITEMS_MAX + 1)));
        let million = vec![(item(20), Value::bytes([1, 1])); 1_000_000];
        assert_eq!(gate.write(&million).err(), Some(ListError::TooLong(1_000_000)));
        assert_eq!(read(gate, &[20]).map(|(_, values)| values), Ok(vec![0]), "nothing was written");
        let jobs = gate.look_for_each(0..1_000_u32, |plant, job| (plant.scans, job)).expect("the run goes on");
        assert_eq!(jobs.iter().map(|&(_, job)| job).collect::<Vec<_>>(), (0..1_000).collect::<Vec<_>>());
        // Somebody who dies inside leaves the lock behind.
        let died = catch_unwind(AssertUnwindSafe(|| gate.enter(|_| std::panic::resume_unwind(Box::new("dies")))));
        assert!(died.is_err());
        let points = gate.points();
        assert!(gate.wait_for_point(points + 2, Duration::from_secs(5)) > points + 2, "the scans go on");
        gate.close();
        gate.enter(|_| ()).err()
    });
    assert_eq!(gone, Some(Closed));
}

#[test]
fn the_time_of_a_run_can_be_held_stepped_and_sped_up() {
    let scans = |gate: &Gate| gate.enter(|plant| (plant.scans, word(&plant.cpu, 0))).expect("the run goes on");
    let (end, plant, ()) = run(cpu(COUNTS, "315-2PN/DP", real_time()), Speed::Factor(1.0), 1_000, |gate, _| {
        gate.wait_for_point(5, Duration::from_secs(5));
        gate.command(|plant| plant.pace.pause(gate.now_us())).expect("the run goes on");
        let before = scans(gate);
        std::thread::sleep(Duration::from_millis(30));
        assert_eq!(scans(gate), before, "time stands still");
        gate.command(|plant| plant.pace.step(3, gate.now_us())).expect("the run goes on");
        let until = Instant::now() + Duration::from_secs(5);
        while scans(gate).0 < before.0 + 3 && Instant::now() < until {
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_millis(20));
        assert_eq!(scans(gate), (before.0 + 3, before.1 + 3));
        gate.command(|plant| {
            plant.pace.set_speed(Speed::Max, gate.now_us());
            plant.pace.go(gate.now_us());
        })
        .expect("the run goes on");
        let points = gate.points();
        gate.wait_for_point(points + 3, Duration::from_secs(5));
        assert!(scans(gate).0 >= before.0 + 100, "64 scans between two points");
        gate.command(|plant| plant.pace.set_speed(Speed::Factor(1.0), gate.now_us())).expect("the run goes on");
        let at = gate.enter(|plant| plant.cpu.time_us()).expect("the run goes on");
        std::thread::sleep(Duration::from_millis(20));
        let later = gate.enter(|plant| plant.cpu.time_us()).expect("the run goes on");
        assert!((10_000..10_000_000).contains(&(later - at)), "real time again: {}", later - at);
    });
    assert_eq!((end, plant.mode), (End::Ended, OperatingMode::Run));
}

#[test]
fn a_stop_from_outside_waits_for_a_start_and_one_of_the_program_ends_the_run() {
    const STOPS: &str = "
ORGANIZATION_BLOCK OB 100
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
L MW 60; L 1; +I; T MW 60;
END_ORGANIZATION_BLOCK
FUNCTION FC 1 : VOID
BEGIN
A M 10.0; CALL SFC 46;
END_FUNCTION
ORGANIZATION_BLOCK OB 1
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
A M 10.0; CC FC 1;
END_ORGANIZATION_BLOCK
";
    let settings = Settings { retain: sieben_cpu::RetentiveAreas::default(), ..real_time() };
    let (end, plant, starts) = run(cpu(STOPS, "416-3", settings), Speed::Factor(1.0), 1_000, |gate, _| {
        gate.wait_for_point(2, Duration::from_secs(5));
        gate.command(|plant| plant.stop(Requester::default())).expect("the run goes on");
        std::thread::sleep(Duration::from_millis(10));
        let mode = || gate.enter(|plant| plant.cpu.mode()).expect("the run goes on");
        assert_eq!(mode(), OperatingMode::Stop);
        gate.command(|plant| plant.ask_for_start(Restart::Warm, Requester::default())).expect("the run goes on");
        let until = Instant::now() + Duration::from_secs(5);
        while mode() != OperatingMode::Run && Instant::now() < until {
            std::thread::sleep(Duration::from_millis(1));
        }
        let events = gate.enter(|plant| plant.cpu.diagnostic_buffer().entries().map(|entry| entry.event()).collect::<Vec<_>>());
        let events = events.expect("the run goes on");
        assert!([0x4304, 0x1381].iter().all(|event| events.contains(event)), "{events:04X?}");
        let starts = read(gate, &[60]).expect("the run goes on").1[0];
        gate.write(&[(Item::area(Area::BitMemory, 10, 1), Value::bytes([1]))]).expect("the run goes on");
        while gate.enter(|_| ()).is_ok() && Instant::now() < until {
            std::thread::sleep(Duration::from_millis(1));
        }
        starts
    });
    assert_eq!((end, plant.mode), (End::Stopped, OperatingMode::Stop));
    assert!(starts >= 1, "{starts}");
}

/// Keeps when the scans were, and ends the run after so many.
#[derive(Default)]
struct Times {
    at_us: Vec<u64>,
    before: usize,
    most: usize,
}

impl Surroundings for Times {
    fn before_scan(&mut self, _: &mut Plant) {
        self.before += 1;
        assert_eq!(self.before, self.at_us.len() + 1, "one before, one after each scan");
    }
    fn after_scan(&mut self, plant: &mut Plant) {
        self.at_us.push(plant.cpu.time_us());
    }
    fn is_ended(&self) -> bool {
        self.at_us.len() >= self.most
    }
}

#[test]
fn every_cycle_is_scanned_at_its_own_time_however_late_the_computer_is() {
    // Each look at the clock of the computer is later than the one before, sometimes by far more than anything that is made up for.
    let looks = AtomicU64::new(0);
    let clock = move || {
        let look = looks.fetch_add(1, Ordering::Relaxed);
        look * 700 + look / 10 * 2_000_000
    };
    let mut pace = Pace::new(Speed::Factor(10.0), 10_000, u64::MAX, 0);
    pace.missed = Missed::MadeUp;
    let mut plant = Plant::new(cpu(COUNTS, "315-2PN/DP", real_time()), pace);
    plant.stay_in_stop();
    let gate = Gate::new(plant, Box::new(clock));
    let (desk, mut times) = (Desk::default(), Times { most: 300, ..Times::default() });
    let check = |times: &Times| {
        let expected: Vec<u64> = (0..times.most as u64).map(|cycle| cycle * 10_000).collect();
        assert_eq!(times.at_us, expected);
    };
    assert_eq!(Driver::new(&gate, &desk, &mut times).run(Restart::Warm), End::Ended);
    check(&times);
    let change = |work: &dyn Fn(&mut Plant)| gate.enter(work).expect("the gate is open");
    // In steps, in virtual time, as fast as the computer, and in STOP, it is the same row of cycles.
    change(&|plant| plant.pace.step(50, gate.now_us()));
    times.most += 50;
    assert_eq!(Driver::new(&gate, &desk, &mut times).go_on(), End::Ended);
    change(&|plant| {
        plant.pace.go(gate.now_us());
        plant.pace.set_speed(Speed::Max, gate.now_us());
    });
    times.most += 200;
    assert_eq!(Driver::new(&gate, &desk, &mut times).go_on(), End::Ended);
    change(&|plant| plant.pace.set_speed(Speed::Factor(1.0), gate.now_us()));
    times.most += 50;
    assert_eq!(Driver::new(&gate, &desk, &mut times).go_on(), End::Ended);
    check(&times);
    change(&|plant| Station::stop(&mut plant.cpu));
    times.most += 50;
    assert_eq!(Driver::new(&gate, &desk, &mut times).go_on(), End::Ended);
    check(&times);
    assert_eq!(gate.enter(|plant| plant.scans), Ok(600), "a CPU in STOP lets its plants live on and does not scan");
    change(&|plant| plant.ask_for_start(Restart::Warm, Requester::default()));
    times.most += 10;
    assert_eq!(Driver::new(&gate, &desk, &mut times).go_on(), End::Ended);
    check(&times);
    assert_eq!(gate.enter(|plant| plant.scans), Ok(610), "a start does not shift the row");
    // The time of a run ends after the last cycle that begins in it.
    change(&|plant| plant.pace.end_us = 6_700_000);
    times.most += 50;
    assert_eq!(Driver::new(&gate, &desk, &mut times).go_on(), End::Over);
    assert_eq!(times.at_us.last(), Some(&6_690_000));
}

#[test]
fn of_the_scans_that_are_asked_for_the_last_one_is_recorded() {
    let mut pace = Pace::new(Speed::Factor(1.0), 1_000, u64::MAX, 0);
    let gate = {
        pace.pause(0);
        Gate::new(Plant::new(cpu(COUNTS, "315-2PN/DP", real_time()), pace), Box::new(|| 7))
    };
    let (desk, mut times) = (Desk::default(), Times::default());
    assert_eq!(Driver::new(&gate, &desk, &mut times).run(Restart::Warm), End::Ended);
    let _look = desk.look([BlockId::ob(1)]);
    for (steps, last) in [(1, 1), (1, 2), (3, 5)] {
        gate.enter(|plant| plant.pace.step(steps, 7)).expect("the gate is open");
        times.most += steps as usize;
        assert_eq!(Driver::new(&gate, &desk, &mut times).go_on(), End::Ended);
        let number = desk.number();
        desk.replay(|| desk.number() > number);
        let (_, sample) = desk.wait_for_sample(number, Duration::ZERO).expect("a sample");
        assert_eq!(sample.map(|sample| (sample.scan, sample.same)), Ok((last, true)), "no time passes between them");
    }
}

#[test]
fn who_comes_before_the_start_waits_for_it() {
    let mut plant = Plant::new(cpu(COUNTS, "315-2PN/DP", real_time()), Pace::new(Speed::Factor(1.0), 2_000, u64::MAX, 0));
    plant.switch_on(Restart::Warm);
    let begin = Instant::now();
    let gate = Gate::new(plant, Box::new(move || begin.elapsed().as_micros() as u64));
    let (desk, around) = (Desk::default(), Around::default());
    std::thread::scope(|scope| {
        let early = scope.spawn(|| gate.look(|plant| (plant.cpu.mode(), plant.scans > 0)));
        // Time for it to come to the gate; if it comes later, it finds the same.
        std::thread::sleep(Duration::from_millis(30));
        // The thread that prepares the run waits neither for the start nor for one who does.
        assert_eq!(gate.enter(|plant| plant.cpu.mode()), Ok(OperatingMode::Stop));
        let scans = scope.spawn(|| {
            let mut surroundings = &around;
            Driver::new(&gate, &desk, &mut surroundings).go_on()
        });
        assert_eq!(early.join().expect("it comes in"), Ok((OperatingMode::Run, true)));
        around.over.store(true, Ordering::Relaxed);
        gate.wake();
        assert_eq!(scans.join().expect("the run ends"), End::Ended);
    });
}

#[test]
fn organization_block_90_lets_everyone_in() {
    const BACKGROUND: &str = "
ORGANIZATION_BLOCK OB 90
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
again: L MW 70; L 1; +I; T MW 70; JU again;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
L MW 0; L 1; +I; T MW 0;
END_ORGANIZATION_BLOCK
";
    let settings = Settings { min_cycle: Duration::from_secs(2), ..real_time() };
    let (_, _, slowest) = run(cpu(BACKGROUND, "416-3", settings), Speed::Factor(1.0), 2_000_000, |gate, _| {
        gate.wait_for_point(1, Duration::from_secs(5));
        let mut slowest = Duration::ZERO;
        let mut values = Vec::new();
        while values.len() <= 10 {
            let begin = Instant::now();
            // A busy computer has other work than OB 90 most of the time, but not for the whole run.
            let Ok((_, value)) = read(gate, &[70]) else { break };
            values.push(value[0]);
            values.dedup();
            slowest = slowest.max(begin.elapsed());
            std::thread::sleep(Duration::from_millis(3));
        }
        assert!(values.len() > 10, "OB 90 goes on: {values:?}");
        slowest
    });
    // Without the end of its slice they would wait for the end of a pause of two seconds.
    assert!(slowest < Duration::from_secs(1), "{slowest:?}");
}

#[test]
fn the_status_of_a_scan_is_that_of_the_real_one() {
    const TIMERS: &str = "
FUNCTION FC 1 : VOID
VAR_INPUT n : INT; END_VAR
BEGIN
L #n; L MW 80; +I; T MW 80;
END_FUNCTION
ORGANIZATION_BLOCK OB 35
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
L MW 90; L 1; +I; T MW 90;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 40
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
L MW 92; L 1; +I; T MW 92; L PIB 1; T MB 94;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
VAR_TEMP info : ARRAY [0..19] OF BYTE; i : INT; END_VAR
BEGIN
L PIB 0; T MB 96; L IB 1; T MB 97; L MB 1; T PQB 1;
AN T 1; L S5T#50MS; SD T 1; A T 1; CU C 1; = Q 0.0;
L 3;
next: T #i; CALL FC 1 (n := #i); L #i; LOOP next;
CALL SFC 64 (RET_VAL := MD 100);
L MW 0; L 1; +I; T MW 0;
END_ORGANIZATION_BLOCK
";
    let (fc, ob) = (BlockId::fc(1), BlockId::ob(1));
    for (text, cpu_name, is_wild) in
        [(TIMERS, "315-2PN/DP", false), (TIMERS, "416-3", false), (COUNTS, "315-2PN/DP", false), (TIMERS, "416-3", true)]
    {
        let modules: Vec<Box<dyn IoModule>> = if is_wild { vec![Box::new(Wild::new(0..2, Alarms::AfterWrites, 1))] } else { Vec::new() };
        let (_, _, samples) = run(cpu_with(text, cpu_name, real_time(), modules), Speed::Factor(1.0), 1_000, |gate, desk| {
            assert!(desk.wait_for_sample(0, Duration::from_millis(60)).is_none(), "nobody looks, nothing is recorded");
            let look = desk.look([fc, ob]);
            let begin = Instant::now();
            let mut samples = Vec::new();
            let mut number = 0;
            while begin.elapsed() < Duration::from_millis(400) {
                let Some((newest, sample)) = desk.wait_for_sample(number, Duration::from_secs(2)) else { break };
                number = newest;
                samples.push(sample.expect("a short scan"));
                gate.write(&[(item(20), Value::bytes([0, samples.len() as u8])), (item(22), Value::bytes([0, samples.len() as u8]))])
                    .expect("the run goes on");
            }
            drop(look);
            samples
        });
        assert!((2..=9).contains(&samples.len()), "20 a second at most: {}", samples.len());
        for (index, sample) in samples.iter().enumerate() {
            assert!(sample.same, "{cpu_name} {is_wild}: sample {index} of scan {} ends differently", sample.scan);
            assert!(index == 0 || sample.scan > samples[index - 1].scan);
        }
        let last = samples.last().expect("a sample");
        let of = |block: BlockId| last.of(block.into()).count();
        assert!(of(ob) > 10, "{:?}", last.statements.keys());
        if text == TIMERS {
            assert_eq!(of(fc), 5, "four statements and the end");
            let load = &last.statements[&(fc.into(), 0)];
            assert_eq!((load.times, load.after.accu1), (3, 1), "executed for 3, 2 and 1");
        }
    }
}
