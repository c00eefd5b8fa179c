//! The tests of machine code, in one binary: seventy would each be linked with Cranelift.

mod address_reuse;
mod appended_strings;
mod bit_fill;
mod bit_interleaving;
mod bits_and_numbers;
mod bits_as_numbers;
mod bits_of_numbers;
mod branches_in_loops;
mod caller_elements;
mod callers;
mod cases_in_loops;
mod contract;
mod copied_records;
mod copies_again;
mod copies_by_pointers;
mod copies_in_loops;
mod dice;
mod divided_affine_values;
mod elements_by_pointers;
mod hostile;
mod if_conversion;
mod indexes_out_of_bounds;
mod inlined_branches;
mod instances;
mod instances_in_instances;
mod intrinsics;
mod loop_versioning;
mod loops_in_called_blocks;
mod loops_in_instances;
mod loops_that_jump;
mod loops_with_calls;
mod min_max_of_groups;
mod min_max_reduction;
mod modular_addressing;
mod moves;
mod multiplied_matrices;
mod narrow_words;
mod near_bits;
mod nested_loops;
mod networks;
mod noting;
mod open_arrays;
mod operations;
mod ordered_reduction;
mod pointers;
mod pointers_by_functions;
mod preserved_block;
mod ranges;
mod region_exits;
mod slp_calls;
mod small_blocks;
mod sparse_iterations;
mod strided_access;
mod string_bytes;
mod string_ranges;
mod strings;
mod strings_by_pointers;
mod strings_in_called_blocks;
mod truncated_reals;
mod uniform_branches;
mod unrolled_inner_loops;
mod unrolling;
mod unsigned_counters;
mod vectorized_outer_loops;
mod wide_lanes;

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
