//! The rules of the house hold.

use sieben_engine::Machine;
use xtask::tidy;

#[test]
fn the_house_is_tidy() {
    let findings: Vec<String> = tidy::findings().iter().map(ToString::to_string).collect();
    assert!(findings.is_empty(), "\n{}\n", findings.join("\n"));
}

/// A snapshot is a copy, and two snapshots can be compared: steps back, recordings and tests rest on it.
#[test]
fn the_machine_is_plain_data() {
    fn plain<T: Clone + PartialEq + Send + 'static>() {}
    plain::<Machine>();
}
