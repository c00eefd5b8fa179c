//! The tests of machine code, in one binary: seventy would each be linked with Cranelift.

mod dice;
mod noting;

mod alike_turns;
mod apart_turns;
mod bits_and_numbers;
mod bits_as_numbers;
mod bits_at_once;
mod bits_in_pieces;
mod bits_of_numbers;
mod caller_elements;
mod callers;
mod cases_in_turns;
mod choices;
mod contract;
mod copied_records;
mod copies_again;
mod copies_in_turns;
mod cut_reals;
mod divided_lines;
mod elements;
mod extremes;
mod growing_texts;
mod handed_by_functions;
mod handed_copies;
mod handed_elements;
mod handed_texts;
mod hostile;
mod idle_turns;
mod indexes_outside;
mod instances;
mod instances_in_instances;
mod interpreted_pieces;
mod intrinsics;
mod kept_extremes;
mod loops_in_called_blocks;
mod loops_in_instances;
mod loops_that_jump;
mod moves;
mod multiplied_matrices;
mod narrow_words;
mod near_bits;
mod nested_turns;
mod networks;
mod open_arrays;
mod operations;
mod own_blocks;
mod own_indexes;
mod own_words;
mod parted_turns;
mod pointers;
mod ranges;
mod series;
mod short_texts;
mod small_blocks;
mod text_ranges;
mod texts;
mod texts_of_called;
mod turns;
mod turns_in_order;
mod turns_in_turns;
mod turns_with_calls;
mod unrolled_turns;
mod unsigned_counters;
mod wide_turns;
mod written_out;

/// A file that is not named here would be no test.
#[test]
#[allow(clippy::disallowed_methods)] // What is looked at is the folder of the tests.
fn every_file_with_tests_is_named() {
    let named: Vec<String> =
        include_str!("main.rs").lines().filter_map(|line| Some(line.strip_prefix("mod ")?.strip_suffix(';')?.to_owned())).collect();
    let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests")).expect("the folder of the tests");
    for file in files.map(|file| file.expect("a file").path()) {
        let name = file.file_stem().expect("a name").to_string_lossy().into_owned();
        assert!(name == "main" || named.contains(&name), "`mod {name};` is missing");
    }
}
