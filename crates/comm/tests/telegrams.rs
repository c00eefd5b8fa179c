//! Runs the pages of spec/comm: frames that are sent to a server, and what it has to answer, byte by byte.

mod page;

use std::fs;
use std::path::Path;

use page::Section;

/// Every section of every page.
fn sections() -> Vec<Section> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/comm");
    let mut files: Vec<_> = fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect();
    files.sort();
    let mut sections = Vec::new();
    for file in files {
        let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{name}: {error}"));
        let found = page::sections(&format!("spec/comm/{name}"), &text);
        assert!(found.iter().any(|section| !section.telegrams.is_empty()), "{name} proves nothing");
        sections.extend(found);
    }
    sections
}

#[test]
fn the_pages_of_telegrams_come_true() {
    let sections = sections();
    let failures: Vec<String> = sections.iter().flat_map(page::failures).collect();
    assert!(failures.is_empty(), "telegrams that are not answered as the pages say:\n\n{}", failures.join("\n\n"));
}

/// A stream may come in any pieces.
#[test]
fn the_same_bytes_one_by_one_are_answered_in_the_same_way() {
    let sections = sections();
    let failures: Vec<String> = sections.iter().flat_map(page::failures_byte_by_byte).collect();
    assert!(failures.is_empty(), "byte by byte it is answered in another way:\n\n{}", failures.join("\n\n"));
}
