//! What those who come in from outside cost a scan: `cargo bench -p sieben-app --bench gate [-- SECONDS]`.
//!
//! A scan of about 1 ms CPU time in a cycle of 10 ms runs alone, beside one reader at full speed and eight that ask 1,000 times a second, and
//! while its status is looked at. Eight threads that sleep as often and never come in show what the wake-ups of the computer cost by
//! themselves. The kinds take turns, a second each, so that other work on the machine meets them alike. A figure is CPU time of the thread
//! that scans, with all that the gate makes it do.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use rustix::time::{ClockId, clock_gettime};
use sieben_cpu::{Cpu, Rack, Restart, Settings, TimeSource};
use sieben_jit::{Jit, StatusBits};
use sieben_lang::{Options, compile};
use sieben_model::address::Area;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::item::Item;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, Gate, Pace, Plant, Speed, Surroundings};

/// The allocator of the command line.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// From one scan to the next.
const CYCLE_US: u64 = 10_000;
/// How long one kind runs at a time.
const TURN: Duration = Duration::from_secs(1);
/// Readers that ask 1,000 times a second.
const READERS: usize = 8;
/// What a scan is to take.
const SCAN_US: f64 = 1_000.0;

/// What one of the eight does 1,000 times a second.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Eight {
    Rest,
    /// They wake up and never come in.
    Sleep,
    Read,
}

/// What goes on outside.
struct Kind {
    name: &'static str,
    /// Whether one reader asks at full speed.
    full_speed: bool,
    eight: Eight,
    /// Whether the status of a scan is looked at.
    status: bool,
}

const KINDS: [Kind; 6] = [
    Kind { name: "nothing", full_speed: false, eight: Eight::Rest, status: false },
    Kind { name: "eight threads that only sleep, 1,000/s", full_speed: false, eight: Eight::Sleep, status: false },
    Kind { name: "one reader at full speed", full_speed: true, eight: Eight::Rest, status: false },
    Kind { name: "one reader at full speed, eight at 1,000/s", full_speed: true, eight: Eight::Read, status: false },
    Kind { name: "the status of a scan is looked at", full_speed: false, eight: Eight::Rest, status: true },
    Kind { name: "one reader, eight, and the status", full_speed: true, eight: Eight::Read, status: true },
];

fn source(rounds: u32) -> String {
    format!(
        "DATA_BLOCK DB 1\nSTRUCT a : ARRAY [0..1999] OF INT; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n\
         ORGANIZATION_BLOCK OB 1\nVAR_TEMP info : ARRAY [0..19] OF BYTE; n : INT; round : INT; END_VAR\nBEGIN\n\
         OPN DB 1; L {rounds};\nrond: T #round; L 100;\nnext: T #n; SLD 4; LAR1; L DBW [AR1, P#0.0]; L #n; +I; T DBW [AR1, P#2.0];\n\
         A M 0.0; XN I 0.1; = M 0.0; L MW 10; L #n; XOW; T MW 10; L #n; LOOP next;\n\
         L #round; LOOP rond;\n\
         L MW 20; L 1; +I; T MW 20;\nEND_ORGANIZATION_BLOCK\n"
    )
}

fn cpu(rounds: u32) -> Cpu {
    let cpu_type = &CpuType::ALL[0];
    let mut sources = Sources::default();
    sources.add("scan.awl", source(rounds));
    let compiled = compile(&sources, &SymbolTable::default(), &Options { cpu: Some(cpu_type), ..Options::default() });
    assert!(compiled.diagnostics.is_empty(), "{:?}", compiled.diagnostics);
    let settings = Settings { time: TimeSource::Real, watchdog: Duration::from_secs(5), ..Settings::default() };
    let load = |program: &_, layout: &_| Jit::compiled(program, layout, StatusBits::Needed).expect("machine code");
    Cpu::load(cpu_type, compiled.program.into(), load, Rack::simulated(cpu_type), settings)
}

/// CPU time of this thread in microseconds.
fn thread_us() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e6 + time.tv_nsec as f64 / 1e3
}

/// Scans and CPU time of each kind; looked at where a scan is about to begin.
struct Around<'a> {
    kind: &'a AtomicUsize,
    over: &'a AtomicBool,
    last: Option<(usize, f64, u64)>,
    /// CPU time of each scan.
    scans_us: [Vec<f64>; KINDS.len()],
}

impl Surroundings for Around<'_> {
    fn at_point(&mut self, plant: &mut Plant) {
        let (kind, us, scans) = (self.kind.load(Ordering::Relaxed), thread_us(), plant.scans);
        match self.last {
            // What comes between two scans is a part of the next one.
            Some((before, _, counted)) if before == kind && counted == scans => {}
            // The scan in which another kind begins is not counted.
            Some((before, then, counted)) if before == kind && counted + 1 == scans => {
                self.scans_us[kind].push(us - then);
                self.last = Some((kind, us, scans));
            }
            _ => self.last = Some((kind, us, scans)),
        }
    }

    fn is_ended(&self) -> bool {
        self.over.load(Ordering::Relaxed)
    }
}

/// Rounds of a scan of about a millisecond.
fn rounds() -> u32 {
    let mut cpu = cpu(100);
    cpu.restart(Restart::Warm);
    for scan in 0..50 {
        cpu.scan(scan);
    }
    let begin = thread_us();
    for scan in 50..250 {
        cpu.scan(scan);
    }
    ((100.0 * SCAN_US * 200.0 / (thread_us() - begin)) as u32).clamp(1, 30_000)
}

/// The value below which this part of them lies.
fn at(sorted: &[f64], part: f64) -> f64 {
    sorted.get((sorted.len() as f64 * part) as usize).copied().unwrap_or_default()
}

fn main() {
    let seconds = std::env::args().filter_map(|argument| argument.parse::<u64>().ok()).next_back().unwrap_or(360);
    let begin = Instant::now();
    let clock = move || begin.elapsed().as_micros() as u64;
    let gate = Gate::new(Plant::new(cpu(rounds()), Pace::new(Speed::Factor(1.0), CYCLE_US, u64::MAX, clock())), Box::new(clock));
    let (desk, kind, over) = (Desk::default(), AtomicUsize::new(0), AtomicBool::new(false));
    let now = || &KINDS[kind.load(Ordering::Relaxed)];
    let goes_on = || !over.load(Ordering::Relaxed);
    let mut around = Around { kind: &kind, over: &over, last: None, scans_us: Default::default() };
    let mut waits = std::thread::scope(|scope| {
        scope.spawn(|| desk.replay(|| !goes_on()));
        let readers: Vec<_> = (0..=READERS)
            .map(|reader| {
                let (gate, now, goes_on) = (&gate, &now, &goes_on);
                scope.spawn(move || {
                    let items = [Item::area(Area::BitMemory, 0, 64), Item::data(1, 0, 222)];
                    let mut waits = Vec::new();
                    while goes_on() {
                        let does = match reader {
                            0 if now().full_speed => Eight::Read,
                            0 => Eight::Rest,
                            _ => now().eight,
                        };
                        if does == Eight::Rest {
                            std::thread::sleep(Duration::from_millis(20));
                            continue;
                        }
                        let asked = Instant::now();
                        if does == Eight::Read {
                            if gate.read(&items).is_err() {
                                break;
                            }
                            waits.push(asked.elapsed().as_secs_f64() * 1e6);
                        }
                        if reader > 0 {
                            std::thread::sleep(Duration::from_millis(1).saturating_sub(asked.elapsed()));
                        }
                    }
                    waits
                })
            })
            .collect();
        scope.spawn(|| {
            while goes_on() {
                if !now().status {
                    std::thread::sleep(Duration::from_millis(20));
                    continue;
                }
                let _look = desk.look([BlockId::ob(1)]);
                drop(desk.wait_for_sample(desk.number(), Duration::from_millis(100)));
            }
        });
        scope.spawn(|| {
            for second in 0..(seconds as usize).max(KINDS.len()) {
                kind.store(second % KINDS.len(), Ordering::Relaxed);
                std::thread::sleep(TURN);
            }
            over.store(true, Ordering::Relaxed);
            gate.wake();
        });
        Driver::new(&gate, &desk, &mut around).run(Restart::Warm);
        gate.close();
        readers.into_iter().flat_map(|reader| reader.join().expect("a reader")).collect::<Vec<f64>>()
    });
    println!("cycle {} ms, {seconds} s", CYCLE_US / 1_000);
    let mut alone = None;
    for (kind, scans_us) in KINDS.iter().zip(&mut around.scans_us) {
        scans_us.sort_by(f64::total_cmp);
        let (mean, median) = (scans_us.iter().sum::<f64>() / scans_us.len().max(1) as f64, at(scans_us, 0.5));
        let (alone_mean, alone_median) = *alone.get_or_insert((mean, median));
        let more = |us: f64, alone: f64| (us / alone - 1.0) * 100.0;
        println!(
            "{:45} mean {mean:8.1} µs  {:+5.1} %   median {median:8.1} µs  {:+5.1} %  {} scans",
            kind.name,
            more(mean, alone_mean),
            more(median, alone_median),
            scans_us.len()
        );
    }
    waits.sort_by(f64::total_cmp);
    println!("{} reads of 286 bytes; they took {:.1} µs (median), {:.1} µs (99 %)", waits.len(), at(&waits, 0.5), at(&waits, 0.99));
    println!("longest cycle {} µs", gate.finish(|plant| plant.cpu.cycle_times().max));
}
