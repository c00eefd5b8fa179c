//! `bench --instances`: many controllers of one program in one process, which share one copy of its code.

use std::fs;
use std::time::Duration;

use serde_json::{Value, json};
use sieben_cpu::{Cpu, Loaded, OperatingMode, Rack, Restart, Settings, SimulatedModule};
use sieben_model::cpu_type::CpuType;

/// Peripheral bytes that the module of each instance has: a station of usual size.
const MODULE_BYTES: u32 = 128;
/// Bytes of a page of memory as `/proc/self/statm` counts them.
const PAGE_BYTES: usize = 4096;

/// What many instances cost.
pub(crate) struct Instances {
    count: usize,
    /// Memory of the process that came with the instances, divided by their number; `None` where it cannot be told.
    bytes_each: Option<usize>,
    scans_per_second: f64,
    code_bytes: usize,
}

/// Memory that this process has in use.
fn resident() -> Option<usize> {
    let text = fs::read_to_string("/proc/self/statm").ok()?;
    text.split_whitespace().nth(1)?.parse::<usize>().ok()?.checked_mul(PAGE_BYTES)
}

/// A rack with one module at the first addresses.
fn rack(cpu_type: &CpuType) -> Rack {
    let bytes = MODULE_BYTES.min(cpu_type.peripheral);
    // One module overlaps nothing.
    Rack::with_only(cpu_type, vec![Box::new(SimulatedModule::new("simulated", 0..bytes))]).unwrap_or_else(|_| Rack::simulated(cpu_type))
}

/// Starts so many CPUs with one loaded program and lets them scan in turn, for at least so long by `clock`; `None` if one of them stops.
pub(crate) fn measure(
    loaded: &Loaded,
    cpu_type: &CpuType,
    settings: &Settings,
    count: usize,
    least: Duration,
    clock: fn() -> Duration,
) -> Option<Instances> {
    let before = resident();
    let start = || {
        let mut cpu = Cpu::new(loaded.clone(), rack(cpu_type), settings.clone());
        cpu.restart(Restart::Warm);
        cpu
    };
    let mut cpus: Vec<Cpu> = (0..count).map(|_| start()).collect();
    let mut round = |number: u64| cpus.iter_mut().all(|cpu| cpu.scan(number * 10_000).mode == OperatingMode::Run);
    // The first round brings the memory of each into use.
    if !round(0) {
        return None;
    }
    let bytes_each = before.zip(resident()).map(|(before, after)| after.saturating_sub(before) / count.max(1));
    let started = clock();
    let mut rounds = 0_u64;
    let time = loop {
        rounds += 1;
        if !round(rounds) {
            return None;
        }
        let time = clock().saturating_sub(started);
        if time >= least {
            break time;
        }
    };
    let scans_per_second = rounds as f64 * count as f64 / time.as_secs_f64();
    Some(Instances { count, bytes_each, scans_per_second, code_bytes: loaded.code_bytes() })
}

impl Instances {
    /// For people.
    pub(crate) fn text(&self) -> String {
        let memory = self.bytes_each.map_or_else(String::new, |bytes| format!(", {:.1} KiB of memory each", bytes as f64 / 1024.0));
        format!(
            "{} instances    {:.0} scans a second on one core{memory}; {} bytes of machine code for all\n",
            self.count, self.scans_per_second, self.code_bytes
        )
    }

    /// For programs.
    pub(crate) fn json(&self) -> Value {
        json!({ "count": self.count, "bytes_each": self.bytes_each, "scans_per_second": self.scans_per_second, "code_bytes": self.code_bytes })
    }
}
