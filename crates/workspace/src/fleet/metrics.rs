//! What a fleet says about its controllers in numbers, in the text format of OpenMetrics.

use super::summary::{Row, Summary};
use crate::metrics::{escaped, head, sample};

/// A family of samples: name, kind, sentence, the end of the names of its samples, value.
type Family = (&'static str, &'static str, &'static str, &'static str, fn(&Row) -> String);

const FAMILIES: &[Family] = &[
    ("sieben_fleet_scans", "counter", "Scans since the beginning of the run.", "_total", |row| row.counts.scans.to_string()),
    ("sieben_fleet_stopped", "gauge", "Whether the controller is in STOP.", "", |row| u8::from(row.stop.is_some()).to_string()),
    ("sieben_fleet_longest_scan_seconds", "gauge", "The longest scan, in real time.", "", |row| {
        (row.counts.longest_ns as f64 / 1e9).to_string()
    }),
    ("sieben_fleet_failed_statements", "counter", "Statements that failed while the program went on.", "_total", |row| {
        row.failed_statements.to_string()
    }),
    ("sieben_fleet_bytes", "gauge", "Bytes that the controller takes for itself.", "", |row| row.bytes.to_string()),
    ("sieben_fleet_messages_sent", "counter", "Messages that it has sent.", "_total", |row| row.counts.sent.to_string()),
    ("sieben_fleet_messages_received", "counter", "Messages that have arrived.", "_total", |row| row.counts.received.to_string()),
];

/// The text.
pub fn text(summary: &Summary) -> String {
    let mut out = String::new();
    for (name, kind, help, end, value) in FAMILIES {
        head(&mut out, name, kind, help);
        let name = format!("{name}{end}");
        for row in &summary.rows {
            labelled(&mut out, &name, row, &[], &value(row));
        }
    }
    let name = "sieben_fleet_stop";
    head(&mut out, name, "info", "Why a controller is in STOP.");
    for row in summary.stopped() {
        let cause = row.stop.as_ref().and_then(|stop| stop.cause.as_ref());
        let event = cause.map_or(String::new(), |cause| format!("16#{:04X}", cause.event));
        let text = cause.map_or(String::new(), |cause| escaped(&cause.text));
        labelled(&mut out, "sieben_fleet_stop_info", row, &[("event", &event), ("cause", &text)], "1");
    }
    out.push_str("# EOF\n");
    out
}

fn labelled(out: &mut String, name: &str, row: &Row, more: &[(&str, &str)], value: &str) {
    let index = row.index.map(|index| index.to_string());
    let mut labels = vec![("controller", row.controller.as_str())];
    labels.extend(index.as_ref().map(|index| ("index", index.as_str())));
    labels.extend(more);
    sample(out, name, &labels, value);
}
