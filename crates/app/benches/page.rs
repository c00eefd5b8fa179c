//! What pages cost a scan: `cargo bench -p sieben-app --bench page [-- SECONDS]`.
//!
//! A scan of about 1 ms CPU time in a cycle of 10 ms runs with a page server: without a page, with one, and with 50, each of which shows the
//! statements of a block with a reason, 20 values, lamps, changes and cycle times, and acknowledges what it is sent. The kinds alternate, two
//! seconds each, so that other work on the machine meets them alike. A figure is CPU time of the thread that scans, with all that pages make it
//! do. Then what one page is sent in a second, and how long a scan is held up by the copy that its status is made of.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

mod scan;
#[path = "../tests/pages/socket.rs"]
mod socket;

use std::net::{SocketAddr, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use scan::{Around, CYCLE_US, ScanTimes, at, cpu, rounds, thread_us};
use serde_json::{Value, json};
use sieben_cpu::Restart;
use sieben_engine::machine::Registers;
use sieben_lang::reason::Language;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_workbench::access::Access;
use sieben_workbench::{Listed, Page, Projects, Reference, Setup, View, listen};
use sieben_workspace::control::{CurrentFacts, Facts};
use sieben_workspace::project::Build;
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, Gate, Pace, Plant, Refusal, Speed};
use socket::Page as Client;

/// The allocator of the command line.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// How long one kind runs at a time.
const SLICE: Duration = Duration::from_secs(2);
/// What is looked at, by how many pages; the last kind is not counted.
const KINDS: [(&str, usize); 4] = [("no page", 0), ("one page", 1), ("50 pages", 50), ("pages come and go", 0)];
/// The number of the kind that is not counted.
const BETWEEN: usize = KINDS.len() - 1;
/// Scans of each sort whose copies are measured.
const COPIES: u64 = 4_000;

/// A run without a project.
struct Nothing;

impl Reference for Nothing {
    fn blocks(&self, _: &Build) -> Value {
        Value::Null
    }
    fn block(&self, _: &Build, _: BlockId, _: (View, Option<Mnemonics>)) -> Result<Value, Refusal> {
        Ok(Value::Null)
    }
    fn symbols(&self, _: &Build) -> Value {
        Value::Null
    }
    fn refs(&self, _: &Build, _: Option<&str>) -> Result<Value, Refusal> {
        Ok(Value::Null)
    }
    fn assignments(&self, _: &Build) -> Value {
        Value::Null
    }
    fn structure(&self, _: &Build) -> Value {
        Value::Null
    }
    fn flow(&self, _: &Arc<Build>, _: (BlockId, u32, View), _: &mut dyn Iterator<Item = (u32, Registers)>) -> Value {
        Value::Null
    }
    fn explain(&self, _: &str, _: Language) -> Option<String> {
        None
    }
}

impl Projects for Nothing {
    fn listed(&self) -> Listed {
        Listed::default()
    }
    fn change(&self, _: &str) -> Result<(), Refusal> {
        Ok(())
    }
    fn watch_tables(&self) -> Result<Vec<String>, Refusal> {
        Ok(Vec::new())
    }
    fn watch_table(&self, _: &str) -> Result<Vec<u8>, Refusal> {
        Ok(Vec::new())
    }
}

/// A page that shows what pages show.
fn client(address: SocketAddr) -> Client {
    let stream = TcpStream::connect(address).expect("the server accepts");
    stream.set_read_timeout(Some(Duration::from_secs(30))).expect("a timeout");
    let mut client = Client::new(stream, "/ws", &address.to_string());
    client.say(&json!({ "t": "hello", "v": 1, "lang": "en" }));
    let names: Vec<String> = (0..20).map(|number| format!("DB1.DBW {}", number * 2)).collect();
    client.say(&json!({ "t": "sub", "id": "r", "what": "rows", "block": "OB1", "from": 0, "to": 40, "reason": 3 }));
    client.say(&json!({ "t": "sub", "id": "t", "what": "tags", "names": names }));
    for what in ["leds", "changes", "cycle", "plant", "forces"] {
        client.say(&json!({ "t": "sub", "id": what, "what": what }));
    }
    client
}

/// Takes messages in until the end; how many bytes came.
fn look_until(client: &mut Client, end: Instant) -> u64 {
    let begin = client.bytes_in;
    while Instant::now() < end {
        client.next().expect("a frame");
    }
    client.bytes_in - begin
}

/// How long a scan is held up by the copies that its recording is made of, in microseconds: what it takes beside one that is not recorded.
fn copies() -> (f64, f64) {
    let mut cpu = cpu(1);
    cpu.restart(Restart::Warm);
    let (mut plain, mut recorded, mut like) = (Vec::new(), Vec::new(), None);
    for scan in 0..2 * COPIES {
        let begin = thread_us();
        if scan % 2 == 0 {
            cpu.scan(scan);
            plain.push(thread_us() - begin);
        } else {
            let (_, record) = cpu.scan_recorded(&mut || scan, like.as_deref());
            recorded.push(thread_us() - begin);
            like = Some(Arc::clone(record.after()));
        }
    }
    [&mut plain, &mut recorded].into_iter().for_each(|us| us.sort_by(f64::total_cmp));
    (at(&recorded, 0.5) - at(&plain, 0.5), at(&recorded, 0.99) - at(&plain, 0.5))
}

fn main() {
    let seconds = std::env::args().filter_map(|argument| argument.parse::<u64>().ok()).next_back().unwrap_or(180);
    let (median, most) = copies();
    println!("the copy of a scan whose status is looked at: median {median:.1} µs, 99 % {most:.1} µs");
    let begin = Instant::now();
    let clock = move || begin.elapsed().as_micros() as u64;
    let cpu = cpu(rounds());
    let facts = Facts { program: Arc::clone(cpu.program()), ..Facts::default() };
    let gate = Arc::new(Gate::new(Plant::new(cpu, Pace::new(Speed::Factor(1.0), CYCLE_US, u64::MAX, clock())), Box::new(clock)));
    let (desk, kind, over) = (Arc::new(Desk::default()), AtomicUsize::new(BETWEEN), AtomicBool::new(false));
    let address = SocketAddr::from(([127, 0, 0, 1], 0));
    let setup = Setup {
        gate: Arc::clone(&gate),
        desk: Arc::clone(&desk),
        facts: Arc::new(CurrentFacts::new(facts)),
        reference: Box::new(Nothing),
        projects: Arc::new(Nothing),
        metrics: Box::new(|| None),
        access: Access { listen: address, exposed: false, tokens: None },
    };
    let page = Page::start(listen(address).expect("a free port"), setup).expect("a server");
    let address = page.address();
    let (bytes, looked) = (AtomicU64::new(0), AtomicU64::new(0));
    let mut around = Around { kind: &kind, over: &over, times: ScanTimes::new(KINDS.len()) };
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let end = Instant::now() + Duration::from_secs(seconds);
            for number in (0..BETWEEN).cycle() {
                if Instant::now() >= end {
                    break;
                }
                let mut clients: Vec<Client> = (0..KINDS[number].1).map(|_| client(address)).collect();
                std::thread::scope(|pages| {
                    let (settled, until) = (Instant::now() + SLICE / 4, Instant::now() + SLICE);
                    for client in &mut clients {
                        let (bytes, looked) = (&bytes, &looked);
                        pages.spawn(move || {
                            look_until(client, settled);
                            let came = look_until(client, until);
                            if number == 1 {
                                bytes.fetch_add(came, Ordering::Relaxed);
                                looked.fetch_add((until - settled).as_micros() as u64, Ordering::Relaxed);
                            }
                        });
                    }
                    std::thread::sleep(settled.saturating_duration_since(Instant::now()));
                    kind.store(number, Ordering::Relaxed);
                    std::thread::sleep(until.saturating_duration_since(Instant::now()));
                    kind.store(BETWEEN, Ordering::Relaxed);
                });
                drop(clients);
                std::thread::sleep(SLICE / 8);
            }
            over.store(true, Ordering::Relaxed);
            gate.wake();
        });
        Driver::new(&gate, &desk, &mut around).run(Restart::Warm);
    });
    gate.close();
    drop(page);
    print!("{}", around.times.lines(&KINDS.map(|(name, _)| name)[..BETWEEN]));
    let per_second = bytes.load(Ordering::Relaxed) as f64 * 1e6 / looked.load(Ordering::Relaxed).max(1) as f64;
    println!("one page is sent {:.1} kB a second", per_second / 1e3);
}
