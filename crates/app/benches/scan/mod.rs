//! A scan of about a millisecond in a cycle of 10 ms: what the measurements of those outside share.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

use rustix::time::{ClockId, clock_gettime};
use sieben_cpu::{Cpu, Rack, Restart, Settings, TimeSource};
use sieben_jit::{Jit, StatusBits};
use sieben_lang::{Options, compile};
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_workspace::{Plant, Surroundings};

/// From one scan to the next.
pub(crate) const CYCLE_US: u64 = 10_000;
/// What a scan is to take.
const SCAN_US: f64 = 1_000.0;

/// `rounds` times 100 iterations over 4,000 bytes of DB 1 and some bit memory.
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

/// A CPU with the program, in machine code and real time.
pub(crate) fn cpu(rounds: u32) -> Cpu {
    let cpu_type = &CpuType::ALL[0];
    let mut sources = Sources::default();
    sources.add("scan.awl", source(rounds));
    let compiled = compile(&sources, &SymbolTable::default(), &Options { cpu: Some(cpu_type), ..Options::default() });
    assert!(compiled.diagnostics.is_empty(), "{:?}", compiled.diagnostics);
    let settings = Settings { time: TimeSource::Real, watchdog: Duration::from_secs(5), ..Settings::default() };
    let load = |program: &_, layout: &_| Jit::compiled(program, layout, StatusBits::Needed).expect("machine code");
    Cpu::load(cpu_type, compiled.program.into(), load, Rack::simulated(cpu_type), settings)
}

/// Rounds of a scan of about a millisecond.
pub(crate) fn rounds() -> u32 {
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

/// CPU time of this thread in microseconds.
pub(crate) fn thread_us() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e6 + time.tv_nsec as f64 / 1e3
}

/// CPU time of each scan with all that the gate makes its thread do, by what went on outside; noted at the cycle control point.
pub(crate) struct ScanTimes {
    last: Option<(usize, f64, u64)>,
    /// By the number of what went on, in microseconds.
    pub(crate) us: Vec<Vec<f64>>,
}

impl ScanTimes {
    /// For so many kinds of what goes on.
    pub(crate) fn new(kinds: usize) -> Self {
        Self { last: None, us: vec![Vec::new(); kinds] }
    }

    /// `scans` have ended, and this goes on outside.
    pub(crate) fn at_point(&mut self, kind: usize, scans: u64) {
        let us = thread_us();
        match self.last {
            // What comes between two scans is a part of the next one.
            Some((before, _, counted)) if before == kind && counted == scans => {}
            // The scan in which another kind begins is not counted.
            Some((before, then, counted)) if before == kind && counted + 1 == scans => {
                self.us[kind].push(us - then);
                self.last = Some((kind, us, scans));
            }
            _ => self.last = Some((kind, us, scans)),
        }
    }

    /// A line for each kind, beside the first.
    pub(crate) fn lines(&mut self, names: &[&str]) -> String {
        let mut lines = String::new();
        let mut alone = None;
        for (name, us) in names.iter().zip(&mut self.us).filter(|(_, us)| !us.is_empty()) {
            us.sort_by(f64::total_cmp);
            let (mean, median) = (us.iter().sum::<f64>() / us.len().max(1) as f64, at(us, 0.5));
            let (alone_mean, alone_median) = *alone.get_or_insert((mean, median));
            let more = |us: f64, alone: f64| (us / alone - 1.0) * 100.0;
            let (mean_more, median_more) = (more(mean, alone_mean), more(median, alone_median));
            lines += &format!(
                "{name:45} mean {mean:8.1} µs  {mean_more:+5.1} %   median {median:8.1} µs  {median_more:+5.1} %  {} scans\n",
                us.len()
            );
        }
        lines
    }
}

/// Scans and CPU time of each kind of what goes on outside; looked at where a scan is about to begin.
pub(crate) struct Around<'a> {
    /// The number of what goes on.
    pub(crate) kind: &'a AtomicUsize,
    /// Whether the measurement is over.
    pub(crate) over: &'a AtomicBool,
    pub(crate) times: ScanTimes,
}

impl Surroundings for Around<'_> {
    fn at_point(&mut self, plant: &mut Plant) {
        self.times.at_point(self.kind.load(Ordering::Relaxed), plant.scans);
    }

    fn is_ended(&self) -> bool {
        self.over.load(Ordering::Relaxed)
    }
}

/// The value below which this part of them lies.
pub(crate) fn at(sorted: &[f64], part: f64) -> f64 {
    sorted.get((sorted.len() as f64 * part) as usize).copied().unwrap_or_default()
}
