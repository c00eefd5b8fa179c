//! The timing diagram of a test that failed, as lines and as a file.

use sieben_sim::timing_diagram::{self, Options};
use sieben_sim::trace::Trace;

use super::Conditions;
use crate::folder::write_named;
use crate::paths::shown;

/// Its width in characters: that of a terminal without what stands before it.
const WIDTH: usize = 72;

/// The trail of a test as text, and as a file if the user wants one.
pub(super) fn lines(trail: &Trace, name: &str, options: &Options, conditions: &Conditions) -> Vec<String> {
    if trail.summary().scans < 2 {
        return Vec::new();
    }
    let text = timing_diagram::text(trail, &Options { width: WIDTH, ..options.clone() });
    let mut lines: Vec<String> = text.map_or_else(|_| Vec::new(), |text| text.lines().map(str::to_owned).collect());
    if let Some(folder) = &conditions.svg {
        let plain = |c: char| if c.is_alphanumeric() { c } else { '-' };
        let file = format!("{}.svg", name.chars().map(plain).take(80).collect::<String>());
        let path = folder.join(&file);
        let drawn = timing_diagram::svg(trail, &Options { width: timing_diagram::SVG_WIDTH, ..options.clone() });
        let written = drawn
            .map_err(|error| error.to_string())
            .and_then(|svg| write_named(folder, &file, svg.as_bytes()).map_err(|error| format!("`{}`: {error}", shown(&path))));
        lines.push(match written {
            Ok(()) => format!("timing diagram: {}", shown(&path)),
            Err(error) => format!("the timing diagram could not be written: {error}"),
        });
    }
    lines
}
