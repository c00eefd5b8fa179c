//! The file of a fleet as a target of the fuzzer.

use sieben_model::source::FileId;

use super::parse::parse;
use super::windows::Windows;

/// Reads the input, and looks at the windows that it makes.
pub fn fuzz(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let (spec, diagnostics) = parse(&text, FileId(0));
    assert_eq!(spec.is_some(), diagnostics.is_empty(), "without a diagnostic there is a fleet");
    for diagnostic in &diagnostics {
        assert!(text.get(diagnostic.span.start as usize..diagnostic.span.end as usize).is_some(), "a place is in the text");
    }
    let Some(spec) = spec else { return };
    let least = spec.links.iter().map(|link| link.latency_us).min();
    let windows = Windows::new(spec.cycle_us.unwrap_or(10_000), 1000, least, 64);
    let last = (0..).map_while(|number| windows.get(number)).last();
    assert_eq!(last.map(|window| window.to), Some(1000), "the last window ends with the last scan");
}
