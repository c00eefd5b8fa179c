//! How far a run of a campaign is.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::json;

use crate::campaign::collected::Collected;
use crate::campaign::said;
use crate::output;

/// A bar where a terminal is, lines of JSON where they are asked for, else a line a second.
pub(super) struct Progress {
    of: u64,
    bar: Option<ProgressBar>,
    json: bool,
    quiet: bool,
    told: Instant,
}

impl Progress {
    /// Of so many scenarios.
    pub(super) fn new(of: u64, json: bool, quiet: bool) -> Self {
        let bar = (std::io::stderr().is_terminal() && !quiet && !json).then(|| {
            let bar = ProgressBar::with_draw_target(Some(of), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{bar:30} {pos}/{len} scenarios, {per_sec}, {eta} left{msg}");
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            bar
        });
        Self { of, bar, json, quiet, told: Instant::now() }
    }

    /// Tells what all came to so far.
    pub(super) fn tell(&mut self, collected: &Collected) {
        let (tally, failed) = (&collected.tally, collected.failures());
        if let Some(bar) = &self.bar {
            bar.set_position(tally.run());
            bar.set_message(if failed > 0 { format!(", {failed} did not pass") } else { String::new() });
            return;
        }
        if self.quiet || self.told.elapsed() < Duration::from_secs(1) {
            return;
        }
        self.told = Instant::now();
        if self.json {
            // Who does not listen any more is told by the result.
            let _ = output::print_json(&json!({ "progress": { "done": tally.run(), "of": self.of, "failed": failed } }), false);
        } else {
            output::message(&format!("{} of {}, {failed} did not pass\n", tally.run(), said::scenarios(self.of)));
        }
    }

    /// There is no more.
    pub(super) fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
