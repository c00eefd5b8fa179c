//! What a run says about itself in numbers, in the text format of Prometheus.

use std::fmt::{Display, Write as _};

use sieben_cpu::{Histogram, OperatingMode};
use sieben_model::block::BlockId;

use crate::gate::{Closed, Gate};
use crate::scan_times::ScanTimes;

/// What a server has counted.
#[derive(Clone, Debug, Default)]
pub struct Served {
    /// What it speaks: `s7`.
    pub protocol: &'static str,
    /// Those who are connected.
    pub connected: u64,
    /// Connections since the beginning.
    pub connections: u64,
    /// Connections that were refused because of a limit.
    pub refused: u64,
    /// Requests by function.
    pub requests: Vec<(&'static str, u64)>,
    /// Bytes that came.
    pub bytes_in: u64,
    /// Bytes that were sent.
    pub bytes_out: u64,
    /// Records of its log that were lost.
    pub lost: u64,
}

/// What is asked of the CPU, in one entry of the gate.
struct OfCpu {
    mode: OperatingMode,
    scans: u64,
    times: ScanTimes,
    blocks: Vec<(BlockId, Histogram)>,
    cycle: [u64; 3],
    forced: u64,
    events: u64,
}

/// The modes by their word.
const MODES: [(&str, OperatingMode); 4] =
    [("stop", OperatingMode::Stop), ("startup", OperatingMode::Startup), ("run", OperatingMode::Run), ("hold", OperatingMode::Hold)];

/// The text.
///
/// # Errors
/// The run is over.
pub fn text(gate: &Gate, servers: &[Served]) -> Result<String, Closed> {
    let cpu = gate.look(|plant| {
        let cycle = plant.cpu.cycle_times();
        OfCpu {
            mode: plant.cpu.mode(),
            scans: plant.scans,
            times: plant.scan_times.clone(),
            blocks: plant.cpu.block_times().map(|(block, times)| (block, times.clone())).collect(),
            cycle: [cycle.last, cycle.min, cycle.max],
            forced: plant.cpu.forced().bytes().map(|(_, _, mask, _)| u64::from(mask.count_ones())).sum(),
            events: plant.cpu.diagnostic_buffer().newest_number(),
        }
    })?;
    let mut out = String::new();
    of_cpu(&mut out, &cpu);
    of_servers(&mut out, servers);
    Ok(out)
}

fn of_cpu(out: &mut String, cpu: &OfCpu) {
    head(out, "sieben_mode", "gauge", "Operating mode of the CPU: 1 for the one that it is in.");
    for (word, mode) in MODES {
        sample(out, "sieben_mode", &[("mode", word)], u8::from(mode == cpu.mode));
    }
    counter(out, "sieben_scans_total", "Scans since the beginning of the run.", cpu.scans);
    head(out, "sieben_scan_seconds", "histogram", "How long scans took, without the pauses between them.");
    histogram(out, "sieben_scan_seconds", None, &cpu.times.times);
    counter(out, "sieben_scan_overruns_total", "Scans that took longer than their cycle.", cpu.times.overruns);
    if !cpu.blocks.is_empty() {
        let name = "sieben_organization_block_seconds";
        head(out, name, "histogram", "How long organization blocks ran, interruptions included.");
        for (block, times) in &cpu.blocks {
            histogram(out, name, Some(("block", &block.to_string())), times);
        }
    }
    head(out, "sieben_cycle_seconds", "gauge", "Time from one scan to the next: the last, the shortest, the longest since the start.");
    for (word, us) in ["last", "min", "max"].into_iter().zip(cpu.cycle) {
        sample(out, "sieben_cycle_seconds", &[("which", word)], seconds(us));
    }
    head(out, "sieben_forced_bits", "gauge", "Bits that are forced.");
    sample(out, "sieben_forced_bits", &[], cpu.forced);
    counter(out, "sieben_diagnostic_events_total", "Entries of the diagnostic buffer since the beginning of the run.", cpu.events);
}

fn of_servers(out: &mut String, servers: &[Served]) {
    type Row = (&'static str, &'static str, &'static str, fn(&Served) -> u64);
    const ROWS: [Row; 6] = [
        ("sieben_server_connections", "gauge", "Clients that are connected.", |one| one.connected),
        ("sieben_server_connections_total", "counter", "Connections since the beginning of the run.", |one| one.connections),
        ("sieben_server_refused_total", "counter", "Connections that were refused because of a limit.", |one| one.refused),
        ("sieben_server_received_bytes_total", "counter", "Bytes that came.", |one| one.bytes_in),
        ("sieben_server_sent_bytes_total", "counter", "Bytes that were sent.", |one| one.bytes_out),
        ("sieben_server_lost_records_total", "counter", "Records of the audit log and of frames that were lost.", |one| one.lost),
    ];
    if servers.is_empty() {
        return;
    }
    for (name, kind, help, value) in ROWS {
        head(out, name, kind, help);
        for server in servers {
            sample(out, name, &[("protocol", server.protocol)], value(server));
        }
    }
    let name = "sieben_server_requests_total";
    head(out, name, "counter", "Requests by function.");
    for server in servers {
        for (function, count) in &server.requests {
            sample(out, name, &[("protocol", server.protocol), ("function", function)], count);
        }
    }
}

/// All samples of a histogram.
fn histogram(out: &mut String, name: &str, label: Option<(&str, &str)>, times: &Histogram) {
    let labels: Vec<(&str, &str)> = label.into_iter().collect();
    let ends = times.up_to().map(|(end_us, count)| (seconds(end_us), count)).chain([("+Inf".to_owned(), times.count)]);
    for (end, count) in ends {
        let labels: Vec<(&str, &str)> = labels.iter().copied().chain([("le", end.as_str())]).collect();
        sample(out, &format!("{name}_bucket"), &labels, count);
    }
    sample(out, &format!("{name}_sum"), &labels, seconds(times.sum_us));
    sample(out, &format!("{name}_count"), &labels, times.count);
}

fn counter(out: &mut String, name: &str, help: &str, value: u64) {
    head(out, name, "counter", help);
    sample(out, name, &[], value);
}

/// The lines before the samples of a name.
pub(crate) fn head(out: &mut String, name: &str, kind: &str, help: &str) {
    // Writing into a string does not fail.
    let _ = writeln!(out, "# HELP {name} {help}\n# TYPE {name} {kind}");
}

/// A line; what others have written stands [`escaped`] in labels.
pub(crate) fn sample(out: &mut String, name: &str, labels: &[(&str, &str)], value: impl Display) {
    let labels = labels.iter().map(|(key, value)| format!("{key}=\"{value}\"")).collect::<Vec<_>>().join(",");
    let labels = if labels.is_empty() { labels } else { format!("{{{labels}}}") };
    let _ = writeln!(out, "{name}{labels} {value}");
}

/// A text as it stands in a label.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n")
}

fn seconds(us: u64) -> String {
    (us as f64 / 1_000_000.0).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sample_has_its_head_and_every_number_is_one() {
        let mut times = ScanTimes::default();
        times.add(150, 10_000);
        let blocks = vec![(BlockId::ob(35), times.times.clone())];
        let cpu = OfCpu { mode: OperatingMode::Run, scans: 7, times, blocks, cycle: [10_000, 9_000, 12_500], forced: 3, events: 5 };
        let served = Served { protocol: "s7", connected: 2, requests: vec![("read", 9), ("write", 0)], ..Served::default() };
        let mut out = String::new();
        of_cpu(&mut out, &cpu);
        of_servers(&mut out, &[served]);
        for line in [
            "sieben_mode{mode=\"run\"} 1",
            "sieben_mode{mode=\"stop\"} 0",
            "sieben_scan_seconds_bucket{le=\"0.0001\"} 0",
            "sieben_scan_seconds_bucket{le=\"0.0002\"} 1",
            "sieben_scan_seconds_bucket{le=\"+Inf\"} 1",
            "sieben_scan_seconds_sum 0.00015",
            "sieben_organization_block_seconds_bucket{block=\"OB 35\",le=\"0.0002\"} 1",
            "sieben_organization_block_seconds_count{block=\"OB 35\"} 1",
            "sieben_cycle_seconds{which=\"max\"} 0.0125",
            "sieben_server_requests_total{protocol=\"s7\",function=\"read\"} 9",
        ] {
            assert!(out.lines().any(|written| written == line), "{line}\n{out}");
        }
        let mut known = String::new();
        for line in out.lines() {
            match line.strip_prefix("# TYPE ") {
                Some(head) => known = head.split(' ').next().expect("a name").to_owned(),
                None if line.starts_with('#') => {}
                None => {
                    assert!(line.starts_with(&known), "{line} has no head");
                    let value = line.rsplit(' ').next().expect("a value");
                    assert!(value.parse::<f64>().is_ok(), "{line}");
                }
            }
        }
    }
}
