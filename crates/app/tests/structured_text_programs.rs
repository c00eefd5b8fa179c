//! The programs of `cargo bench -p sieben-app --bench structured_text` come to the same results as the same work in C, on all engines.

#[allow(dead_code)] // The tests of whole programs need more of it.
mod program;
#[allow(dead_code)] // The measurements need more of it.
#[path = "../benches/structured_text/programs.rs"]
mod programs;
#[allow(dead_code)] // The measurements need more of it.
#[path = "../benches/side_by_side/mod.rs"]
mod side_by_side;

#[test]
fn all_engines_count_what_c_counts() {
    for case in programs::all() {
        let compiled = side_by_side::compiled("bench.st", &case.st);
        for (engine, load) in program::ENGINES {
            let mut loaded = side_by_side::load(&compiled, load);
            (0..programs::CHECKED_SCANS).for_each(|_| loaded.scan(None));
            assert_eq!(programs::check(&compiled, &loaded), case.check, "{}, {engine}", case.name);
        }
    }
}
