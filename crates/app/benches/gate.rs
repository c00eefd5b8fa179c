//! What those who come in from outside cost a scan: `cargo bench -p sieben-app --bench gate [-- SECONDS]`.
//!
//! A scan of about 1 ms CPU time in a cycle of 10 ms runs alone, beside one reader at full speed and eight that ask 1,000 times a second, and
//! while its status is looked at. The kinds take turns, a second each, so that other work on the machine meets them alike. A figure is CPU
//! time of the thread that scans, with all that the gate makes it do.
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

/// What goes on outside.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Outside {
    Nobody,
    Readers,
    Status,
    ReadersAndStatus,
}

const KINDS: [(&str, Outside); 4] = [
    ("nobody", Outside::Nobody),
    ("one reader at full speed, eight at 1,000/s", Outside::Readers),
    ("the status of a scan is looked at", Outside::Status),
    ("all of them", Outside::ReadersAndStatus),
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
    used_us: [f64; KINDS.len()],
    scans: [u64; KINDS.len()],
}

impl Surroundings for Around<'_> {
    fn at_point(&mut self, plant: &mut Plant) {
        let (kind, us, scans) = (self.kind.load(Ordering::Relaxed), thread_us(), plant.scans);
        // The scan in which a turn begins belongs to nobody.
        if let Some((before, then, counted)) = self.last
            && before == kind
        {
            self.used_us[kind] += us - then;
            self.scans[kind] += scans - counted;
        }
        self.last = Some((kind, us, scans));
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

fn main() {
    let seconds = std::env::args().filter_map(|argument| argument.parse::<u64>().ok()).next_back().unwrap_or(240);
    let begin = Instant::now();
    let clock = move || begin.elapsed().as_micros() as u64;
    let gate = Gate::new(Plant::new(cpu(rounds()), Pace::new(Speed::Factor(1.0), CYCLE_US, u64::MAX, clock())), Box::new(clock));
    let (desk, kind, over) = (Desk::default(), AtomicUsize::new(0), AtomicBool::new(false));
    let wants = |kinds: [Outside; 2]| kinds.contains(&KINDS[kind.load(Ordering::Relaxed)].1);
    let reads = || wants([Outside::Readers, Outside::ReadersAndStatus]);
    let goes_on = || !over.load(Ordering::Relaxed);
    let mut around = Around { kind: &kind, over: &over, last: None, used_us: [0.0; 4], scans: [0; 4] };
    let mut waits = std::thread::scope(|scope| {
        scope.spawn(|| desk.replay(|| !goes_on()));
        let readers: Vec<_> = (0..=READERS)
            .map(|reader| {
                let (gate, reads, goes_on) = (&gate, &reads, &goes_on);
                scope.spawn(move || {
                    let items = [Item::area(Area::BitMemory, 0, 64), Item::data(1, 0, 222)];
                    let mut waits = Vec::new();
                    while goes_on() {
                        if !reads() {
                            std::thread::sleep(Duration::from_millis(20));
                            continue;
                        }
                        let asked = Instant::now();
                        if gate.read(&items).is_err() {
                            break;
                        }
                        waits.push(asked.elapsed().as_secs_f64() * 1e6);
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
                if !wants([Outside::Status, Outside::ReadersAndStatus]) {
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
    let mean = |kind: usize| around.used_us[kind] / around.scans[kind].max(1) as f64;
    println!("cycle {} ms, {seconds} s", CYCLE_US / 1_000);
    for (index, (text, _)) in KINDS.iter().enumerate() {
        let (scans, us) = (around.scans[index], mean(index));
        println!("{text:45} {us:8.1} µs a scan  {:+5.1} %  {scans} scans", (us / mean(0) - 1.0) * 100.0);
    }
    waits.sort_by(f64::total_cmp);
    let at = |part: f64| waits.get((waits.len() as f64 * part) as usize).copied().unwrap_or_default();
    println!("{} reads of 286 bytes; they took {:.1} µs (median), {:.1} µs (99 %)", waits.len(), at(0.5), at(0.99));
    println!("longest cycle {} µs", gate.finish(|plant| plant.cpu.cycle_times().max));
}
