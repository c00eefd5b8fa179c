//! What those who come in from outside cost a scan: `cargo bench -p sieben-app --bench gate [-- SECONDS]`.
//!
//! A scan of about 1 ms CPU time in a cycle of 10 ms runs alone, beside one reader at full speed and eight that ask 1,000 times a second,
//! while its status is looked at, and while its past is kept. Eight threads that sleep as often and never come in show what the wake-ups of
//! the computer cost by themselves. The kinds alternate, a second each, so that other work on the machine meets them alike. A figure is CPU
//! time of the thread that scans, with all that the gate makes it do.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

mod scan;

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use sieben_cpu::Restart;
use sieben_model::address::Area;
use sieben_model::block::BlockId;
use sieben_model::item::Item;
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, Gate, Pace, Plant, Speed};

use scan::{Around, CYCLE_US, ScanTimes, at, cpu, rounds};

/// The allocator of the command line.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// How long one kind runs at a time.
const SLICE: Duration = Duration::from_secs(1);
/// Readers that ask 1,000 times a second.
const READERS: usize = 8;

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
    /// Whether the past of the run is kept.
    past: bool,
}

const KINDS: [Kind; 7] = [
    Kind { name: "nothing", full_speed: false, eight: Eight::Rest, status: false, past: false },
    Kind { name: "eight threads that only sleep, 1,000/s", full_speed: false, eight: Eight::Sleep, status: false, past: false },
    Kind { name: "one reader at full speed", full_speed: true, eight: Eight::Rest, status: false, past: false },
    Kind { name: "one reader at full speed, eight at 1,000/s", full_speed: true, eight: Eight::Read, status: false, past: false },
    Kind { name: "the status of a scan is looked at", full_speed: false, eight: Eight::Rest, status: true, past: false },
    Kind { name: "the past is kept", full_speed: false, eight: Eight::Rest, status: false, past: true },
    Kind { name: "one reader, eight, and the status", full_speed: true, eight: Eight::Read, status: true, past: false },
];

fn main() {
    let seconds = std::env::args().filter_map(|argument| argument.parse::<u64>().ok()).next_back().unwrap_or(360);
    let begin = Instant::now();
    let clock = move || begin.elapsed().as_micros() as u64;
    let gate = Gate::new(Plant::new(cpu(rounds()), Pace::new(Speed::Factor(1.0), CYCLE_US, u64::MAX, clock())), Box::new(clock));
    let (desk, kind, over) = (Desk::default(), AtomicUsize::new(0), AtomicBool::new(false));
    let now = || &KINDS[kind.load(Ordering::Relaxed)];
    let goes_on = || !over.load(Ordering::Relaxed);
    let mut around = Around { kind: &kind, over: &over, times: ScanTimes::new(KINDS.len()) };
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
                match now().past {
                    true => desk.past().keep(),
                    false => desk.past().forget(),
                }
                std::thread::sleep(SLICE);
            }
            over.store(true, Ordering::Relaxed);
            gate.wake();
        });
        Driver::new(&gate, &desk, &mut around).run(Restart::Warm);
        gate.close();
        readers.into_iter().flat_map(|reader| reader.join().expect("a reader")).collect::<Vec<f64>>()
    });
    println!("cycle {} ms, {seconds} s", CYCLE_US / 1_000);
    print!("{}", around.times.lines(&KINDS.map(|kind| kind.name)));
    waits.sort_by(f64::total_cmp);
    println!("{} reads of 286 bytes; they took {:.1} µs (median), {:.1} µs (99 %)", waits.len(), at(&waits, 0.5), at(&waits, 0.99));
    println!("longest cycle {} µs", gate.finish(|plant| plant.cpu.cycle_times().max));
}
