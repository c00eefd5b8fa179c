//! Sessions under clients that ask for much, read nothing, or wait for a job that takes longer.

use std::net::SocketAddr;
use std::sync::Arc;

use sieben_comm::s7comm::guard::{Function, Rules, Writing};
use sieben_comm::s7comm::session::{Session, Shared, What};
use sieben_cpu::{Cpu, OperatingMode, ProtectionLevel, Rack, Restart, Settings};
use sieben_engine::Interpreter;
use sieben_lang::Options;
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_workspace::{Pace, Plant, Speed};

const PROGRAM: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNOP 0;\nEND_ORGANIZATION_BLOCK\n";
const CONNECT: &[u8] = &[3, 0, 0, 0x16, 0x11, 0xE0, 0, 0, 0, 1, 0, 0xC0, 1, 0x0A, 0xC1, 2, 1, 0, 0xC2, 2, 1, 2];
const SETUP: &[u8] = &[3, 0, 0, 0x19, 2, 0xF0, 0x80, 0x32, 1, 0, 0, 0, 1, 0, 8, 0, 0, 0xF0, 0, 0, 8, 0, 8, 1, 0xE0];
/// Bytes that a server may keep for one client before it reads on.
const OUTPUT_BYTES_MAX: usize = 64 * 1024;

struct Side {
    plant: Plant,
    session: Session,
    shared: Shared,
    now_us: u64,
}

impl Side {
    fn connected() -> Self {
        let cpu_type = &CpuType::ALL[0];
        let mut sources = Sources::default();
        sources.add("page.awl", PROGRAM);
        let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &Options::default());
        let rack = Rack::simulated(cpu_type);
        let mut cpu = Cpu::load(cpu_type, Arc::new(compiled.program), Interpreter::load, rack, Settings::default());
        cpu.restart(Restart::Warm);
        let rules = Rules {
            cpu: cpu_type,
            protection: ProtectionLevel::Open,
            password: None,
            writing: Writing::Allowed,
            allow: None,
            strict: false,
            strict_slot: false,
        };
        let plant = Plant::new(cpu, Pace::new(Speed::Max, 10_000, u64::MAX, 0));
        let peer = SocketAddr::from(([192, 0, 2, 7], 50_000));
        let mut side = Self { plant, session: Session::new(Arc::new(rules), peer, 0), shared: Shared::default(), now_us: 0 };
        side.receive(CONNECT);
        side.receive(SETUP);
        assert!(side.session.is_ready());
        side.sent();
        side.shared.events.clear();
        side
    }

    fn receive(&mut self, bytes: &[u8]) {
        self.session.receive(bytes, &mut self.shared, self.now_us);
        self.serve();
    }

    fn serve(&mut self) {
        while self.session.wants_in() {
            assert!(self.session.serve(&mut self.plant, &mut self.shared, self.now_us));
        }
    }

    /// Takes what waits; the references of the answers.
    fn sent(&mut self) -> Vec<u16> {
        let mut output = self.session.output().to_vec();
        self.session.sent(output.len(), self.now_us);
        let mut references = Vec::new();
        while !output.is_empty() {
            let length = usize::from(u16::from_be_bytes([output[2], output[3]]));
            let frame: Vec<u8> = output.drain(..length).collect();
            if frame[5] == 0xF0 {
                references.push(u16::from_be_bytes([frame[11], frame[12]]));
            }
        }
        references
    }

    fn wait(&mut self, time_us: u64) {
        let until_us = self.now_us + time_us;
        while let Some(wake_us) = self.session.wake_us().filter(|&wake_us| wake_us <= until_us) {
            self.now_us = self.now_us.max(wake_us);
            self.session.tick(&mut self.shared, self.now_us);
            self.serve();
        }
        self.now_us = until_us;
    }
}

fn job(reference: u16, parameters: &[u8]) -> Vec<u8> {
    let (length, parameter_bytes) = (17 + parameters.len() as u16, parameters.len() as u16);
    let mut frame = vec![3, 0];
    frame.extend(length.to_be_bytes());
    frame.extend([2, 0xF0, 0x80, 0x32, 1, 0, 0]);
    frame.extend(reference.to_be_bytes());
    frame.extend(parameter_bytes.to_be_bytes());
    frame.extend([0, 0]);
    frame.extend(parameters);
    frame
}

/// 222 bytes of bit memory.
fn read(reference: u16) -> Vec<u8> {
    job(reference, &[4, 1, 0x12, 10, 0x10, 2, 0, 222, 0, 0, 0x83, 0, 0, 0])
}

const STOP: &[u8] = b"\x29\0\0\0\0\0\x09P_PROGRAM";
const START: &[u8] = b"\x28\0\0\0\0\0\0\xFD\0\0\x09P_PROGRAM";

#[test]
fn jobs_in_one_segment_are_answered_in_their_order_however_many_there_are() {
    let mut side = Side::connected();
    side.receive(&(1..=100).flat_map(read).collect::<Vec<_>>());
    assert_eq!(side.sent(), (1..=100).collect::<Vec<_>>());
    assert_eq!(side.shared.requests.of(Function::Read), 100);
}

#[test]
fn a_client_that_reads_nothing_has_to_wait_and_is_closed_in_the_end() {
    let mut side = Side::connected();
    let mut asked = 0;
    while side.session.reads() {
        asked += 1;
        side.receive(&read(asked));
        assert!(side.session.output().len() < OUTPUT_BYTES_MAX);
    }
    // What had been on its way meanwhile waits.
    side.receive(&read(asked + 1));
    assert!(!side.session.reads());
    side.wait(9_900_000);
    assert!(!side.session.is_over());
    side.wait(200_000);
    assert!(side.session.is_over() && side.session.output().is_empty());
}

#[test]
fn a_client_that_reads_again_gets_all_its_answers() {
    let mut side = Side::connected();
    let mut asked = 0;
    while side.session.reads() {
        asked += 1;
        side.receive(&read(asked));
    }
    side.receive(&read(asked + 1));
    let mut answered = side.sent();
    assert_eq!(side.session.wake_us(), Some(0), "there is room again");
    side.wait(0);
    answered.extend(side.sent());
    assert_eq!(answered, (1..=asked + 1).collect::<Vec<_>>());
}

#[test]
fn a_server_that_reads_on_all_the_same_closes_the_connection_before_its_memory_grows() {
    let mut side = Side::connected();
    let mut bytes = 0;
    while !side.session.is_over() {
        let segment: Vec<u8> = (0..100).flat_map(read).collect();
        bytes += segment.len();
        side.receive(&segment);
        assert!(bytes < 4 << 20 && side.session.output().len() < OUTPUT_BYTES_MAX);
    }
}

#[test]
fn a_start_is_waited_for_and_refused_when_it_does_not_come() {
    let mut side = Side::connected();
    side.receive(&job(1, STOP));
    assert_eq!((side.sent(), side.plant.cpu.mode()), (vec![1], OperatingMode::Stop));
    // The thread that scans would carry it out, and there is none here.
    side.receive(&[job(2, START), read(3)].concat());
    side.wait(2_900_000);
    assert!(side.sent().is_empty(), "the job after it waits as well");
    side.wait(200_000);
    let answer = side.session.output().get(7..19).map(<[u8]>::to_vec);
    assert_eq!(answer.as_deref(), Some(&[0x32, 2, 0, 0, 0, 2, 0, 0, 0, 0, 0x84, 4][..]));
    assert_eq!(side.sent(), [2, 3]);
    let events: Vec<(What, u16)> = side.shared.events.iter().map(|event| (event.what.clone(), event.error)).collect();
    assert_eq!(events, [(What::Stop, 0), (What::Start(Restart::Warm), 0x8404)]);
}

#[test]
fn a_job_that_takes_longer_is_asked_about_every_few_milliseconds_and_not_all_the_time() {
    let mut side = Side::connected();
    side.receive(&job(1, STOP));
    side.receive(&job(2, START));
    let mut looks = 0;
    let until_us = 1_000_000;
    while let Some(wake_us) = side.session.wake_us().filter(|&wake_us| wake_us < until_us) {
        looks += 1;
        assert!(!side.session.wants_in() && wake_us > side.now_us);
        side.wait(wake_us - side.now_us);
    }
    assert!((150..=250).contains(&looks), "{looks} times in a second");
}

#[test]
fn what_has_begun_is_noted_although_its_client_is_gone() {
    let mut side = Side::connected();
    side.receive(&job(1, STOP));
    side.receive(&job(2, START));
    side.receive(b"no frame");
    assert!(side.session.is_over() && side.session.has_begun());
    // The time for connecting is over as well, which must not be all that is looked at.
    side.wait(20_000_000);
    assert!(!side.session.has_begun() && side.session.wake_us().is_none());
    let events: Vec<What> = side.shared.events.iter().map(|event| event.what.clone()).collect();
    assert_eq!(events, [What::Stop, What::Start(Restart::Warm)]);
}
