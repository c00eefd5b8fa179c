//! The file of a campaign as a target of the fuzzer.

use sieben_model::source::FileId;

use crate::given::Given;
use crate::numbering::Numbering;
use crate::packed::Packed;
use crate::parse::parse;

/// Longest time of a scenario that is drawn: a walk has a change at each of its times.
const FOR_MAX_US: u64 = 3_600_000_000;

/// Reads the input, and makes some of its scenarios twice.
pub fn fuzz(data: &[u8]) {
    if let Some(packed) = Packed::read(data) {
        assert_eq!(Packed::read(&packed.bytes()), Some(packed), "it is read as it was written");
    }
    let text = String::from_utf8_lossy(data);
    let (spec, diagnostics) = parse(&text, FileId(0));
    assert_eq!(spec.is_some(), diagnostics.is_empty(), "without a diagnostic there is a campaign");
    for diagnostic in &diagnostics {
        assert!(text.get(diagnostic.span.start as usize..diagnostic.span.end as usize).is_some(), "a place is in the text");
    }
    let Some(spec) = spec.filter(|spec| spec.for_us.unwrap_or(0) <= FOR_MAX_US) else { return };
    let Ok(numbering) = Numbering::new(&spec, spec.exhaustive.as_ref().map_or(0, |exhaustive| exhaustive.inputs.len())) else { return };
    let last = numbering.count() - 1;
    for number in [0, last / 2, last] {
        let given = Given::of(&spec, &numbering, number);
        assert_eq!(format!("{given:?}"), format!("{:?}", Given::of(&spec, &numbering, number)), "a scenario depends on its number alone");
    }
}
