//! The timing diagram of a test that failed, as lines and for a file.

use sieben_sim::timing_diagram::{self, Options};
use sieben_sim::trace::Trace;

use super::Conditions;

/// Its width in characters: that of a terminal without what stands before it.
const WIDTH: usize = 72;

/// The trail of a test as text, and for a file if the user wants one.
pub(super) fn lines(trail: &Trace, name: &str, options: &Options, conditions: &Conditions) -> Vec<String> {
    if trail.summary().scans < 2 {
        return Vec::new();
    }
    let text = timing_diagram::text(trail, &Options { width: WIDTH, ..options.clone() });
    let mut lines: Vec<String> = text.map_or_else(|_| Vec::new(), |text| text.lines().map(str::to_owned).collect());
    let plain = |c: char| if c.is_alphanumeric() { c } else { '-' };
    let file = format!("{}.svg", name.chars().map(plain).take(80).collect::<String>());
    let draw = || {
        let options = Options { width: timing_diagram::SVG_WIDTH, ..options.clone() };
        timing_diagram::svg(trail, &options).map_err(|error| error.to_string())
    };
    lines.extend(conditions.outside.keep_diagram(&file, &draw));
    lines
}
