//! What changed without a screen: one line for each change.

use sieben_workspace::Plant;
use sieben_workspace::observed::{Event, Observer};

use super::numbers::{clock, thousands};

/// A line for each value that changed in the last scan.
pub(crate) fn changed(observer: &mut Observer, plant: &Plant, time_us: u64) -> Vec<String> {
    let mut lines = Vec::new();
    observer.observe(&plant.cpu, time_us, &mut |event| lines.push(line(plant, time_us, &event)));
    lines
}

/// `scan 1,204 (12.04 s): Q 0.0 0→1 (Dosing valve)`, with its end.
pub(super) fn line(plant: &Plant, time_us: u64, event: &Event) -> String {
    let place = format!("scan {} ({})", thousands(plant.scans), clock(time_us / 1_000));
    match event {
        Event::Change { address, before, after, comment, .. } if comment.is_empty() => format!("{place}: {address} {before}→{after}\n"),
        Event::Change { address, before, after, comment, .. } => format!("{place}: {address} {before}→{after} ({comment})\n"),
        Event::Note(text) => format!("{place}: {text}\n"),
    }
}
