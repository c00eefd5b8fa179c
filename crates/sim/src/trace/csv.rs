//! Traces as tables: RFC 4180, one row per scan.

use std::fmt::Write;
use std::ops::RangeInclusive;

use super::{Moment, Trace, TraceError};

/// Which scans get a row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rows {
    /// Every scan.
    #[default]
    All,
    /// The first scan of the range, and those in which a channel changed.
    Changes,
}

/// Writes a table: time in milliseconds, number of the scan, the values as they are shown; an empty field where there is none.
///
/// # Errors
/// The trace cannot be read or the table not be written.
pub fn write(trace: &Trace, range: &RangeInclusive<u64>, rows: Rows, out: &mut dyn Write) -> Result<(), TraceError> {
    out.write_str("time_ms,scan")?;
    for channel in trace.channels() {
        write!(out, ",{}", field(&channel.name))?;
    }
    out.write_str("\r\n")?;
    let mut values = String::new();
    trace.visit(range, &mut |scans| {
        if !scans.changed.is_empty() {
            values.clear();
            for (channel, value) in trace.channels().iter().zip(scans.values) {
                values.push(',');
                if let Some(shown) = value.shown(&channel.kind) {
                    values.push_str(&field(&shown.to_string()));
                }
            }
        }
        for moment in scans.moments().take(if rows == Rows::All { usize::MAX } else { usize::from(!scans.changed.is_empty()) }) {
            write!(out, "{},{}{values}\r\n", Milliseconds(moment), moment.scan)?;
        }
        Ok(())
    })
}

struct Milliseconds(Moment);

impl std::fmt::Display for Milliseconds {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let us = self.0.time_us;
        match us % 1000 {
            0 => write!(f, "{}", us / 1000),
            rest => {
                let digits = format!("{rest:03}");
                write!(f, "{}.{}", us / 1000, digits.trim_end_matches('0'))
            }
        }
    }
}

/// A field, in quotation marks where it needs them.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\r', '\n']) || text.starts_with(' ') || text.ends_with(' ') {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
