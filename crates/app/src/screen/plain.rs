//! What changed without a screen: one line for each change.

use sieben_workspace::observed::{Entry, Event};

use super::numbers::{clock, thousands};

/// `scan 1,204 (12.04 s): Q 0.0 0→1 (Dosing valve)`, with its end.
pub(crate) fn line(entry: &Entry) -> String {
    let place = format!("scan {} ({})", thousands(entry.scan), clock(entry.time_us / 1_000));
    match &entry.event {
        Event::Change { address, before, after, comment, .. } if comment.is_empty() => format!("{place}: {address} {before}→{after}\n"),
        Event::Change { address, before, after, comment, .. } => format!("{place}: {address} {before}→{after} ({comment})\n"),
        Event::Note(text) => format!("{place}: {text}\n"),
    }
}
