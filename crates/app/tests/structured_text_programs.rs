//! The programs of `cargo bench -p sieben-app --bench structured_text` come to the same results as the same work in C, on all engines.

use std::fs;

use sieben_engine::{Interpreter, Layout, Program};
use sieben_jit::{Jit, StatusBits};

#[path = "../benches/structured_text/corpus.rs"]
mod corpus;
#[allow(dead_code)] // The tests of whole programs need more of it.
mod program;
#[allow(dead_code)] // The measurements need more of it.
#[path = "../benches/structured_text/programs.rs"]
mod programs;
#[allow(dead_code)] // The measurements need more of it.
#[path = "../benches/side_by_side/mod.rs"]
mod side_by_side;

/// Sets of nine programs, by the beginning of their names.
const SETS: [&str; 3] = ["glass14", "rail14", "ship13"];
/// More programs would take longer to run than the other tests together.
const PROGRAMS_MAX: usize = 60;
/// Bytes of the corpus, with the twins in C: less than the sources of a crate.
const BYTES_MAX: u64 = 500_000;

#[test]
fn all_engines_count_what_c_counts() {
    for case in programs::all() {
        let compiled = side_by_side::compiled("bench.st", &case.st).expect("it compiles");
        for (engine, load) in program::ENGINES {
            let mut loaded = side_by_side::load(&compiled, load);
            (0..programs::CHECKED_SCANS).for_each(|_| loaded.scan(None));
            assert_eq!(Some(programs::check(&compiled, &loaded)), case.check, "{}, {engine}", case.name);
        }
    }
}

/// Runs a program on all engines; memory is the same after each scan. Optimized machine code does not write what finished blocks leave in
/// their local data, and no program may see it: it finds something else there before each scan, and so does the interpreter.
fn same_on_all_engines(name: &str, text: &str, scans: usize) {
    let compiled = side_by_side::compiled("bench.st", text).expect("it compiles");
    let mut expected = side_by_side::load(&compiled, Interpreter::load);
    let local = expected.machine.memory.layout.local.clone();
    let exact = |program: &Program, layout: &Layout| Jit::compiled(program, layout, StatusBits::All).expect("machine code");
    let needed = |program: &Program, layout: &Layout| Jit::compiled(program, layout, StatusBits::Needed).expect("machine code");
    let mut others = [
        ("status bits as written", side_by_side::load(&compiled, exact), false),
        ("status bits as needed", side_by_side::load(&compiled, needed), true),
        ("interpreter with other local data", side_by_side::load(&compiled, Interpreter::load), true),
    ];
    for scan in 0..scans {
        expected.scan(None);
        for (engine, loaded, forgets) in &mut others {
            if *forgets {
                loaded.machine.memory.arena[local.clone()].fill(0xA5 ^ scan as u8);
            }
            loaded.scan(None);
            let [expected, got] = [&expected, &*loaded].map(|loaded| &loaded.machine.memory.arena[..]);
            let seen = [0..local.start, if *forgets { local.end } else { local.start }..expected.len()];
            let differs = seen.into_iter().filter(|part| expected[part.clone()] != got[part.clone()]);
            let differs = differs.flatten().find(|&at| expected[at] != got[at]);
            assert_eq!(differs, None, "{name}: {engine}, scan {scan}");
        }
    }
}

/// Which test runs a program of the corpus: each set of nine has its own, so that the tests run side by side.
fn part_of(name: &str) -> &str {
    let set = name.split_once('_').map_or("", |(set, _)| set);
    if SETS.contains(&set) { set } else { "regressions" }
}

/// Runs the programs of one part of the corpus on all engines.
fn run_corpus(part: &str) {
    for (name, file) in corpus::all().into_iter().filter(|(name, _)| part_of(name) == part) {
        same_on_all_engines(&name, &fs::read_to_string(&file).expect("a source"), 12);
    }
}

#[test]
fn programs_of_a_glass_works_are_the_same_on_all_engines() {
    run_corpus("glass14");
}

#[test]
fn programs_of_a_railway_depot_are_the_same_on_all_engines() {
    run_corpus("rail14");
}

#[test]
fn programs_of_a_ship_are_the_same_on_all_engines() {
    run_corpus("ship13");
}

#[test]
fn programs_that_stand_for_regressions_are_the_same_on_all_engines() {
    run_corpus("regressions");
}

#[test]
fn the_corpus_is_small_and_each_program_has_a_reason() {
    let programs = corpus::all();
    let reasons = fs::read_to_string(side_by_side::root().join("benches/st/corpus/README.md")).expect("a page");
    for (name, file) in &programs {
        assert!(file.with_extension("c").exists(), "{name} has no twin in C");
        let named = if part_of(name) == "regressions" { format!("| `{name}` |") } else { format!("| `{}_*` |", part_of(name)) };
        assert!(reasons.contains(&named), "the page of the corpus has no line `{named}`");
    }
    let lines = reasons.lines().filter(|line| line.starts_with("| `")).count();
    let alone = programs.keys().filter(|name| part_of(name) == "regressions").count();
    assert_eq!(lines, SETS.len() + alone, "lines of the page for programs that are not there");
    assert!(SETS.iter().all(|set| programs.keys().filter(|name| part_of(name) == *set).count() == 9));
    let bytes: u64 = programs
        .values()
        .flat_map(|file| [file.clone(), file.with_extension("c")])
        .map(|file| file.metadata().map_or(0, |data| data.len()))
        .sum();
    assert!(programs.len() <= PROGRAMS_MAX && bytes <= BYTES_MAX, "{} programs, {bytes} bytes", programs.len());
}

#[test]
fn thousands_of_networks_over_instance_data_become_machine_code() {
    let mut text = String::from(
        "PROGRAM Main\nVAR\n x : ARRAY[0..63] OF BOOL;\n y : ARRAY[0..2499] OF BOOL;\n sr : ARRAY[0..99] OF SR;\n i, state, scans, check : DINT;\nEND_VAR\n\
         FOR i := 0 TO 63 DO state := (state * 75 + 74) MOD 65537; x[i] := state > 32768; END_FOR;\n",
    );
    for network in 0..2500 {
        let [a, b, c] = [7, 11, 13].map(|factor| network * factor % 64);
        text += &format!("y[{network}] := (x[{a}] AND NOT x[{b}]) OR (x[{c}] AND y[{}]);\n", network * 17 % 2500);
    }
    for number in 0..100 {
        text += &format!("sr[{number}](S1 := x[{}], R := y[{}]);\n", number % 64, number * 23 % 2500);
    }
    same_on_all_engines("networks", &(text + "scans := scans + 1;\nEND_PROGRAM\n"), 3);
}

#[test]
fn elements_of_arrays_of_function_blocks_are_where_their_index_says() {
    let long = "sum := sum + raw; ".repeat(150);
    for body in ["sum := sum + raw;", long.as_str()] {
        let text = format!(
            "FUNCTION Twice : DINT\nVAR_INPUT\n v : DINT;\nEND_VAR\nVAR_TEMP\n t : DINT;\nEND_VAR\nt := v; Twice := t + v;\nEND_FUNCTION\n\
             FUNCTION_BLOCK Inner\nVAR_INPUT\n raw : DINT;\n on : BOOL;\nEND_VAR\nVAR_OUTPUT\n sum : DINT;\n done : BOOL;\nEND_VAR\nVAR_TEMP\n t : DINT;\nEND_VAR\n\
             t := Twice(v := raw); {body}\nIF on THEN sum := sum + t + Twice(v := t); done := NOT done; END_IF;\nEND_FUNCTION_BLOCK\n\
             FUNCTION_BLOCK Stage\nVAR_INPUT\n raw : DINT;\nEND_VAR\nVAR_OUTPUT\n value : INT;\nEND_VAR\nVAR\n inner : ARRAY[1..3] OF Inner;\n one : Inner;\n k : DINT;\nEND_VAR\n\
             FOR k := 0 TO 4 DO inner[k](raw := raw + k, on := k MOD 2 = 0); END_FOR;\none(raw := inner[2].sum, on := inner[1].done); value := value + 3;\nEND_FUNCTION_BLOCK\n\
             PROGRAM Main\nVAR\n stages : ARRAY[-2..20] OF Stage;\n i, j, scans : DINT;\n check : DINT;\nEND_VAR\n\
             FOR i := -4 TO 23 DO\n j := i * (scans + 1);\n stages[i](raw := i);\n stages[j](raw := j * 5);\n check := check + stages[j].value;\nEND_FOR;\n\
             stages[scans * 100000000](raw := 1); scans := scans + 1;\nEND_PROGRAM\n"
        );
        same_on_all_engines("arrays of blocks", &text, 4);
    }
}
