//! Operating modes, the clock, the load memory and the status lists.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use sieben_comm::s7comm::job::{Job, Reply};
use sieben_comm::s7comm::wire::codes::Refusal;
use sieben_cpu::{DateAndTime, OperatingMode, Requester, Restart};
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, Gate, Surroundings};

use crate::Station;

#[test]
fn status_lists_answer_what_clients_ask_for() {
    let mut station = Station::new();
    let mut list = |id: u16, index: u16| match station.ends(&Job::SystemStatus { id, index }) {
        Reply::SystemStatus(list) => Ok((list.index, list.count, list.records.first().map(|record| record[1]))),
        Reply::Refused(refusal) => Err(refusal),
        reply => panic!("{reply:?}"),
    };
    // Index 0 means the only one that clients can mean.
    assert_eq!(list(0x0131, 0), Ok((0, 1, Some(1))));
    assert_eq!(list(0x0131, 1), Ok((1, 1, Some(1))));
    assert_eq!(list(0x0232, 0), Ok((0, 1, Some(4))));
    assert_eq!(list(0x0232, 4), Ok((4, 1, Some(4))));
    assert_eq!(list(0x0232, 1), Err(Refusal::UnknownListIndex));
    // An index without a meaning is not looked at.
    for index in [0, 1, 0xFFFF] {
        assert_eq!(list(0x0011, index), Ok((index, 3, Some(1))));
        assert_eq!(list(0x001C, index), Ok((index, 10, Some(1))));
    }
    assert_eq!(list(0x0111, 7), Ok((7, 1, Some(7))));
    for id in [0x0025, 0x001A, 0x7777] {
        assert_eq!(list(id, 0), Err(Refusal::UnknownListId));
    }
}

#[test]
fn the_diagnostic_buffer_is_read_whole() {
    let mut station = Station::new();
    for _ in 0..20 {
        station.plant.cpu.restart(Restart::Warm);
    }
    let Reply::SystemStatus(list) = station.ends(&Job::SystemStatus { id: 0x00A0, index: 0 }) else { panic!("no list") };
    assert_eq!(list.records.len(), station.plant.cpu.diagnostic_buffer().entries().len());
    assert!(list.records.len() > 40);
}

#[test]
fn the_clock_is_set_and_read() {
    let mut station = Station::new();
    let wanted = DateAndTime::from_bytes([0x26, 0x11, 0x28, 0x18, 0x05, 0x09, 0x12, 0x37]).expect("a time");
    assert!(matches!(station.ends(&Job::SetClock(wanted)), Reply::Done));
    assert!(matches!(station.ends(&Job::Clock), Reply::Clock(time) if time == wanted));
    let beyond = DateAndTime::from_ms_since_1990(u64::MAX);
    assert_eq!(station.refusal(&Job::SetClock(beyond)), Some(Refusal::WrongTime));
    assert!(matches!(station.ends(&Job::Clock), Reply::Clock(time) if time == wanted));
}

#[test]
fn the_values_are_copied_to_the_load_memory() {
    let mut station = Station::new();
    station.scan(10);
    assert!(matches!(station.ends(&Job::CopyRamToRom), Reply::Done));
    assert!(matches!(station.ends(&Job::Compress), Reply::Done));
    station.scan(20);
    assert_eq!(station.refusal(&Job::MemoryReset), Some(Refusal::CannotPerform), "in RUN");
    assert!(matches!(station.ends(&Job::Stop), Reply::Done));
    assert_eq!(station.values(1).map(|values| values[1]), Some(8));
    assert!(matches!(station.ends(&Job::MemoryReset), Reply::Done));
    assert_eq!(station.values(1).map(|values| values[1]), Some(7));
}

#[derive(Default)]
struct Around(AtomicBool);

impl Surroundings for &Around {
    fn is_ended(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Ends the run whatever becomes of the test.
struct End<'g>(&'g Gate, &'g Around);

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.1.0.store(true, Ordering::Relaxed);
        self.0.wake();
    }
}

/// What a job comes to while another thread scans.
fn ends(gate: &Gate, around: &mut sieben_comm::s7comm::answer::Surroundings, job: &Job, by: Requester) -> Reply {
    let reply = gate.enter(|plant| sieben_comm::s7comm::answer::perform(job, plant, around, by)).expect("the run goes on");
    let Reply::Later(mut pending) = reply else { return reply };
    let begin = Instant::now();
    while begin.elapsed() < Duration::from_secs(20) {
        if let Some(reply) = gate.enter(|plant| pending.poll(plant, around)).expect("the run goes on") {
            return reply;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    panic!("{job:?} does not end");
}

#[test]
fn a_cpu_that_is_switched_on_is_stopped_before_its_first_scan() {
    let Station { mut plant, mut around } = Station::new();
    plant.switch_on(Restart::Warm);
    let begin = Instant::now();
    let gate = Arc::new(Gate::new(plant, Box::new(move || begin.elapsed().as_micros() as u64)));
    let (over, desk) = (Around::default(), Desk::default());
    let by = Requester::default();
    assert!(matches!(ends(&gate, &mut around, &Job::Stop, by), Reply::Done));
    assert!(matches!(ends(&gate, &mut around, &Job::Stop, by), Reply::Already));
    std::thread::scope(|scope| {
        scope.spawn(|| Driver::new(&gate, &desk, &mut &over).go_on());
        let _end = End(&gate, &over);
        assert!(matches!(ends(&gate, &mut around, &Job::Start(Restart::Warm), by), Reply::Done));
        assert!(matches!(ends(&gate, &mut around, &Job::Start(Restart::Warm), by), Reply::Already));
        // A start that is still to come is taken back by a STOP.
        gate.enter(|plant| {
            plant.stop(by);
            plant.ask_for_start(Restart::Warm, by);
            assert!(matches!(sieben_comm::s7comm::answer::perform(&Job::Stop, plant, &mut around, by), Reply::Done));
            assert!(plant.is_stopped());
        })
        .expect("the run goes on");
        let points = gate.points();
        while gate.points() < points + 3 {
            std::thread::yield_now();
        }
        assert!(gate.enter(|plant| plant.is_stopped()).expect("the run goes on"));
    });
}

#[test]
fn a_cpu_is_stopped_and_started_and_keeps_who_asked() {
    let Station { plant, mut around } = Station::new();
    let begin = Instant::now();
    let gate = Arc::new(Gate::new(plant, Box::new(move || begin.elapsed().as_micros() as u64)));
    let (over, desk) = (Around::default(), Desk::default());
    let by = Requester { address: Some("192.0.2.7".parse().expect("an address")) };
    std::thread::scope(|scope| {
        scope.spawn(|| Driver::new(&gate, &desk, &mut &over).run(Restart::Warm));
        let _end = End(&gate, &over);
        let mode = || gate.enter(|plant| plant.cpu.mode()).expect("the run goes on");
        let began = Instant::now();
        // The run begins with a start of its own.
        while gate.points() < 2 && began.elapsed() < Duration::from_secs(20) {
            std::thread::yield_now();
        }
        for restart in [Restart::Warm, Restart::Cold] {
            assert!(matches!(ends(&gate, &mut around, &Job::Start(restart), by), Reply::Already));
            assert!(matches!(ends(&gate, &mut around, &Job::Stop, by), Reply::Done));
            assert_eq!(mode(), OperatingMode::Stop);
            assert!(matches!(ends(&gate, &mut around, &Job::Stop, by), Reply::Already));
            assert!(matches!(ends(&gate, &mut around, &Job::Start(restart), by), Reply::Done));
            assert_eq!(mode(), OperatingMode::Run);
        }
        let texts: Vec<String> = gate
            .enter(|plant| plant.cpu.diagnostic_buffer().entries().map(|entry| format!("{:04X} {}", entry.event(), entry.text())).collect())
            .expect("the run goes on");
        for event in ["4304", "1381", "1385"] {
            assert!(texts.iter().any(|text| text.starts_with(event) && text.contains("192.0.2.7")), "{event}: {texts:?}");
        }
    });
}
