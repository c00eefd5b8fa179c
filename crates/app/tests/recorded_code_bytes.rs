//! The nine programs of the measurement become as many bytes of machine code as were written down, within two per cent.
#![cfg(target_arch = "x86_64")]

use sieben_engine::Interpreter;
use sieben_jit::Jit;

#[allow(dead_code)] // The measurements need more of it.
#[path = "../benches/structured_text/programs.rs"]
mod programs;
#[allow(dead_code)] // The measurements need more of it.
#[path = "../benches/side_by_side/mod.rs"]
mod side_by_side;

/// Bytes that were written down: `SIEBEN_GENERATE=1` writes them again.
const FILE: &str = "benches/code-bytes.txt";

#[test]
fn the_nine_programs_are_as_large_as_they_were() {
    let path = side_by_side::root().join(FILE);
    let bytes: Vec<(&str, usize)> = programs::all()
        .iter()
        .map(|case| {
            let program = side_by_side::compiled("bench.st", &case.st).expect("it compiles");
            let layout = side_by_side::load(&program, Interpreter::load).machine.memory.layout.clone();
            (case.name, Jit::counted_bytes(&program, &layout).expect("machine code"))
        })
        .collect();
    if std::env::var_os("SIEBEN_GENERATE").is_some() {
        let text: String = bytes.iter().map(|(name, bytes)| format!("{name} {bytes}\n")).collect();
        return std::fs::write(&path, text).expect("the file can be written");
    }
    let text = std::fs::read_to_string(&path).expect("the file is there");
    for (line, (name, bytes)) in text.lines().zip(&bytes) {
        let (known, before) = line.split_once(' ').expect("a name and a number");
        let before: usize = before.parse().expect("a number");
        assert_eq!(known, *name);
        assert!(bytes.abs_diff(before) * 50 <= before, "{name}: {bytes} bytes, and {before} were written down in {FILE}");
    }
    assert_eq!(text.lines().count(), bytes.len());
}
