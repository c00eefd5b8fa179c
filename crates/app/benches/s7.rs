//! The S7 server beside the native server of Snap7: `cargo bench -p sieben-app --bench s7 [-- SECONDS]`.
//!
//! Clients read 4 bytes, 200 bytes and 19 items, one client and eight, each at full speed. Both servers run all the time; they are asked
//! alternately, half a second each, so that other work on the machine meets them alike, while a CPU scans 1 ms in a cycle of 10 ms. The native server is that of
//! `cargo xtask clients`; without it only ours is measured.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

#[path = "s7/client.rs"]
mod client;
mod scan;

use std::io::{BufRead, BufReader};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use client::{Client, Item, job};
use rustix::net::{AddressFamily, SocketType};
use scan::{Around, CYCLE_US, ScanTimes, at, cpu, rounds};
use sieben_comm::config::Config;
use sieben_comm::recording::Recorders;
use sieben_comm::s7comm::session::Shared;
use sieben_comm::server::{Server, Setup, listen};
use sieben_cpu::{Communication, Restart};
use sieben_model::cpu_type::CpuType;
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, Gate, Pace, Plant, Speed};

/// The allocator of the command line.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// How long one server is asked at a time.
const SLICE: Duration = Duration::from_millis(500);
/// What is noted with the scans: nothing goes on, ours is asked by eight, the other one is.
const SCANS: [&str; 4] = ["nothing", "eight clients of our server", "eight clients of the native server", "one client of either"];
/// Connections at once, from two addresses.
const MANY: usize = 64;

/// What is read at a time.
fn work() -> [(&'static str, Vec<Item>); 3] {
    let items = (0..19).map(|index| Item { area: 0x84, db: 1, byte: index * 40, length: 4 }).collect();
    [
        ("4 bytes", vec![Item { area: 0x83, db: 0, byte: 0, length: 4 }]),
        ("200 bytes", vec![Item { area: 0x84, db: 1, byte: 100, length: 200 }]),
        ("19 items", items),
    ]
}

/// The native server, while it runs.
struct Native(Child, SocketAddr);

impl Native {
    fn start() -> Option<Self> {
        let project = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let free = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).and_then(|listener| listener.local_addr()).ok()?;
        let mut child = Command::new(project.join("target/clients/native-snap7/bin/python"))
            .arg(project.join("crates/app/benches/s7/native_server.py"))
            .arg(free.port().to_string())
            .stdout(Stdio::piped())
            .spawn()
            .ok()?;
        let mut line = String::new();
        BufReader::new(child.stdout.take()?).read_line(&mut line).ok()?;
        let native = Self(child, free);
        (line.trim() == "ready").then_some(native)
    }
}

impl Drop for Native {
    fn drop(&mut self) {
        // One that has ended by itself is as good.
        let _ = self.0.kill().and_then(|()| self.0.wait());
    }
}

/// Answers of one server in one cell, and how long it was asked.
#[derive(Default)]
struct Cell {
    waits: Vec<f64>,
    seconds: f64,
}

impl Cell {
    fn per_second(&self) -> f64 {
        self.waits.len() as f64 / self.seconds.max(1e-9)
    }

    /// The clients ask for one slice of the time.
    fn ask(&mut self, clients: &mut [Client], items: &[Item]) {
        let (job, begin) = (job(items), Instant::now());
        let end = begin + SLICE;
        let waits = std::thread::scope(|scope| {
            let asked: Vec<_> = clients.iter_mut().map(|client| scope.spawn(|| client.read_until(end, &job, items))).collect();
            asked.into_iter().flat_map(|thread| thread.join().expect("a client")).collect::<Vec<f64>>()
        });
        self.seconds += begin.elapsed().as_secs_f64();
        self.waits.extend(waits);
    }

    fn text(&mut self) -> String {
        self.waits.sort_by(f64::total_cmp);
        format!("{:9.0}/s  {:6.1} µs (median) {:7.1} µs (99 %)", self.per_second(), at(&self.waits, 0.5), at(&self.waits, 0.99))
    }
}

/// Memory of this process that is in use, in KiB.
fn resident() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    line.and_then(|line| line.split_whitespace().next()?.parse().ok()).unwrap_or_default()
}

/// A socket from one of the addresses of this computer.
fn socket_from(address: Ipv4Addr, to: SocketAddr) -> TcpStream {
    let socket = rustix::net::socket(AddressFamily::INET, SocketType::STREAM, None).expect("a socket");
    rustix::net::bind(&socket, &SocketAddr::from((address, 0))).expect("an address of this computer");
    rustix::net::connect(&socket, &to).expect("the server listens");
    TcpStream::from(socket)
}

/// Asks both servers alternately until the time is over, and prints what each cell gave.
fn measure(ours: SocketAddr, native: Option<&Native>, seconds: u64, kind: &AtomicUsize) {
    let work = work();
    let servers: Vec<(&str, SocketAddr)> = std::iter::once(("ours", ours)).chain(native.map(|native| ("native", native.1))).collect();
    let mut clients: Vec<Vec<Client>> = servers.iter().map(|(_, address)| (0..8).map(|_| Client::connect(*address)).collect()).collect();
    let mut cells: Vec<Vec<Cell>> = servers.iter().map(|_| (0..2 * work.len()).map(|_| Cell::default()).collect()).collect();
    let end = Instant::now() + Duration::from_secs(seconds);
    while Instant::now() < end {
        for cell in 0..2 * work.len() {
            let (items, many) = (&work[cell / 2].1, if cell % 2 == 0 { 1 } else { 8 });
            for (server, clients) in clients.iter_mut().enumerate() {
                kind.store(if many == 1 { 3 } else { 1 + server }, Ordering::Relaxed);
                cells[server][cell].ask(&mut clients[..many], items);
            }
            kind.store(0, Ordering::Relaxed);
            std::thread::sleep(SLICE);
        }
    }
    let (mut product, mut worst) = (1.0, f64::INFINITY);
    for cell in 0..2 * work.len() {
        let name = format!("{}, {}", work[cell / 2].0, if cell % 2 == 0 { "1 client" } else { "8 clients" });
        for ((server, _), cells) in servers.iter().zip(&mut cells) {
            println!("{name:22} {server:7} {}", cells[cell].text());
        }
        if let [ours, native] = &cells[..] {
            let ratio = ours[cell].per_second() / native[cell].per_second();
            product *= ratio;
            worst = ratio.min(worst);
            println!("{name:22} ratio   {ratio:9.2}");
        }
    }
    match native {
        Some(_) => {
            println!("geometric mean of the ratios {:.2}, the smallest {worst:.2}", f64::powf(product, 1.0 / (2.0 * work.len() as f64)))
        }
        None => println!("the native server is not installed: `cargo xtask clients`"),
    }
}

/// Connections at once, each of which reads the largest job.
fn measure_memory(ours: SocketAddr) {
    let [_, _, (_, items)] = work();
    let (before, job) = (resident(), job(&items));
    let address = |index: usize| if index.is_multiple_of(2) { Ipv4Addr::LOCALHOST } else { Ipv4Addr::new(127, 0, 0, 2) };
    let mut many: Vec<Client> = (0..MANY).map(|index| Client::new(socket_from(address(index), ours))).collect();
    many.iter_mut().for_each(|client| client.read(&job, &items));
    println!("{MANY} connections: {:.2} MiB more, their clients included", (resident() - before) / 1_024.0);
    drop(many);
    // Their places are free again for those who come next.
    std::thread::sleep(SLICE);
}

fn main() {
    let seconds = std::env::args().filter_map(|argument| argument.parse::<u64>().ok()).next_back().unwrap_or(180);
    let begin = Instant::now();
    let clock = move || begin.elapsed().as_micros() as u64;
    let gate = Arc::new(Gate::new(Plant::new(cpu(rounds()), Pace::new(Speed::Factor(1.0), CYCLE_US, u64::MAX, clock())), Box::new(clock)));
    let (desk, kind, over) = (Desk::default(), AtomicUsize::new(0), AtomicBool::new(false));
    let listener = listen(SocketAddr::from((Ipv4Addr::LOCALHOST, 0))).expect("a free port");
    let setup = Setup {
        config: Config::default(),
        shared: Shared::default(),
        names: Communication::default(),
        recorders: Recorders::default(),
        clock: Box::new(move || begin.elapsed().as_micros() as u64),
    };
    let server = Server::start(listener, &CpuType::ALL[0], Arc::clone(&gate), setup).expect("a server");
    let native = Native::start();
    let mut around = Around { kind: &kind, over: &over, times: ScanTimes::new(SCANS.len()) };
    println!("cycle {} ms, {seconds} s", CYCLE_US / 1_000);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            measure_memory(server.address());
            measure(server.address(), native.as_ref(), seconds, &kind);
            over.store(true, Ordering::Relaxed);
            gate.wake();
        });
        Driver::new(&gate, &desk, &mut around).run(Restart::Warm);
    });
    drop(server);
    gate.close();
    print!("{}", around.times.lines(&SCANS));
}
