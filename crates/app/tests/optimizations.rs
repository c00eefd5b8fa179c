//! Machine code without any one of its optimizations, and without all of them, does what it does with them.

use std::fs;

use sieben_engine::{Interpreter, Program};
use sieben_jit::{Jit, Pass, PassSet, StatusBits};

#[path = "../benches/structured_text/corpus.rs"]
mod corpus;
#[allow(dead_code)] // The measurements need more of it.
#[path = "../benches/structured_text/programs.rs"]
mod programs;
#[allow(dead_code)] // The measurements need more of it.
#[path = "../benches/side_by_side/mod.rs"]
mod side_by_side;

/// Scans that are compared.
const SCANS: usize = 12;

/// Runs a program with some optimizations: outside of local data, memory is that of the interpreter after each scan.
fn same_as_interpreted(name: &str, program: &Program, passes: PassSet) {
    let mut expected = side_by_side::load(program, Interpreter::load);
    let mut made = side_by_side::load(program, |program, layout| {
        Jit::compiled_with(program, layout, StatusBits::Needed, passes).expect("machine code")
    });
    let local = expected.machine.memory.layout.local.clone();
    for scan in 0..SCANS {
        expected.scan(None);
        made.scan(None);
        let [expected, made] = [&expected, &made].map(|loaded| &loaded.machine.memory.arena[..]);
        for part in [0..local.start, local.end..expected.len()] {
            let differs = part.clone().find(|&at| expected[at] != made[at]);
            assert_eq!(differs, None, "{name}: {passes:?}, scan {scan}");
        }
    }
}

#[test]
fn each_of_our_programs_is_the_same_without_each_optimization() {
    // The two largest are nothing but networks, which the others have, too.
    for case in programs::all().into_iter().filter(|case| !matches!(case.name, "bool" | "timers")) {
        let program = side_by_side::compiled("bench.st", &case.st).expect("it compiles");
        for &pass in Pass::ALL {
            same_as_interpreted(case.name, &program, PassSet::default().without(pass));
        }
    }
}

#[test]
fn programs_of_the_corpus_are_the_same_without_some_and_without_all() {
    let none = PassSet::default().without_all(Pass::ALL);
    for (index, (name, file)) in corpus::all().into_iter().enumerate() {
        let program = side_by_side::compiled("bench.st", &fs::read_to_string(file).expect("a text")).expect("it compiles");
        let every_fourth = PassSet::default().without_all(Pass::ALL.iter().skip(index % 4).step_by(4));
        for passes in [none, every_fourth] {
            same_as_interpreted(&name, &program, passes);
        }
    }
}
