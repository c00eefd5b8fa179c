//! Loops over memory on all engines: variables that machine code keeps in registers are in memory whenever somebody looks, and what
//! somebody changes is seen.

use std::fmt::Write as _;
use std::sync::Arc;

use program::compile_sources;
use sieben_cpu::{Cpu, DiagnosticEntry, OperatingMode, Rack, Restart, Settings};
use sieben_engine::{Engine, Interpreter, Layout, Program};
use sieben_jit::{Jit, StatusBits};
use sieben_lang::st::dialect::Dialect;
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;

#[allow(dead_code)] // The pages need more of it.
mod program;

/// Programs that are compared.
const PROGRAMS: u64 = 60;
/// Scans of each.
const SCANS: u64 = 3;
/// Safe points of a scan: a loop whose counter an access overwrote ends there.
const SAFE_POINTS_MAX: i64 = 400;

/// A sequence without pattern.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit
    }
    fn of<'t>(&mut self, words: &[&'t str]) -> &'t str {
        words[self.below(words.len())]
    }
}

/// Variables of words and double words, some of which share bytes.
const WORDS: &[&str] = &["MW 44", "MW 46", "MD 40", "MD 48", "MB 45", "LW 40", "LD 42", "LB 41", "DBW 0", "DBW 2", "DBD 4", "DB2.DBW 2"];
const BITS: &[&str] = &["M 44.1", "M 52.3", "M 52.4", "L 46.0", "DBX 0.1", "Q 4.2"];
/// Pointers into these areas leave them sooner or later.
const INDIRECT: &[&str] =
    &["DBW [MD 40]", "MW [MD 40]", "LW [LD 42]", "DBB [MD 48]", "W [AR1, P#0.0]", "MW [AR1, P#40.0]", "DBW [AR1, P#2.0]"];
/// Variables of the function block.
const STATIC: &[&str] = &["#a", "#b", "#d", "#sum"];

/// A piece of a loop's body.
fn piece(random: &mut Random, text: &mut String, variables: &[&str], inside: usize) {
    let word = random.of(variables);
    let _ = match random.below(14) {
        0 | 1 => writeln!(text, "L {word};"),
        2 | 3 => writeln!(text, "T {word};"),
        4 => writeln!(
            text,
            "L {}; {}; T {word};",
            random.of(variables),
            random.of(&["+I", "-I", "*I", "+D", "INC 1", "SLW 2", "+ 5", "TAK"])
        ),
        5 => writeln!(
            text,
            "{} {}; {} {};",
            random.of(&["A", "AN", "O"]),
            random.of(BITS),
            random.of(&["=", "=", "S", "R", "FP"]),
            random.of(BITS)
        ),
        6 => writeln!(text, "L {};", random.of(INDIRECT)),
        7 => writeln!(text, "T {};", random.of(INDIRECT)),
        8 | 9 => writeln!(text, "L MD 40; L P#{}.0; +D; T MD 40;", 2 * random.below(9)),
        10 => writeln!(text, "L {};", random.of(&["3", "-7", "L#100000", "P#2.0", "W#16#FF"])),
        11 => writeln!(text, "{};", random.of(&["LAR1 MD 40", "LAR1 P#DBX 2.0", "+AR1 P#1.0", "LAR1 P#M 40.0", "OPN DB 1", "OPN DB 2"])),
        12 => writeln!(text, "L {word}; L 50; <I; JC s{inside};"),
        _ => writeln!(text, "A {}; JC e{inside};", random.of(BITS)),
    };
}

/// A loop, perhaps with another one in it; `number` counts the loops of the block.
fn turns(random: &mut Random, text: &mut String, variables: &[&str], number: &mut usize, depth: usize) {
    let own = *number;
    *number += 1;
    let counter = format!("MW {}", 80 + 2 * own);
    let _ = writeln!(text, "L {};\nl{own}: T {counter};", 1 + random.below(12));
    let pieces = 1 + random.below(7);
    for _ in 0..pieces {
        piece(random, text, variables, own);
        if depth < 2 && random.below(8) == 0 {
            turns(random, text, variables, number, depth + 1);
        }
    }
    let _ = writeln!(text, "s{own}: NOP 0;");
    piece(random, text, &variables[..4], own);
    let _ = writeln!(text, "L {counter}; LOOP l{own};\ne{own}: NOP 0;");
}

fn text(seed: u64) -> String {
    let mut random = Random(seed);
    let mut text = String::from(
        "DATA_BLOCK DB 1\nSTRUCT a : ARRAY [0..15] OF INT; END_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
         DATA_BLOCK DB 2\nSTRUCT a : ARRAY [0..9] OF INT; END_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
         FUNCTION_BLOCK FB 1\nVAR\n a : INT;\n b : INT;\n d : DINT;\n sum : INT;\nEND_VAR\nVAR_TEMP\n t : ARRAY [0..59] OF BYTE;\nEND_VAR\nBEGIN\nOPN DB 1;\n",
    );
    let variables: Vec<&str> = STATIC.iter().chain(WORDS).copied().collect();
    let mut number = 0;
    turns(&mut random, &mut text, &variables, &mut number, 0);
    text.push_str("END_FUNCTION_BLOCK\nDATA_BLOCK DB 4\nFB 1\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nVAR_TEMP\n t : ARRAY [0..59] OF BYTE;\nEND_VAR\nBEGIN\n");
    text.push_str("L 0; T LD 40; T LD 44; L P#4.0; T MD 40; T LD 42; OPN DB 1;\n");
    let mut number = 4;
    turns(&mut random, &mut text, WORDS, &mut number, 0);
    text.push_str("CALL FB 1, DB 4;\n");
    turns(&mut random, &mut text, WORDS, &mut number, 1);
    text.push_str("END_ORGANIZATION_BLOCK\n");
    if random.below(4) > 0 {
        text.push_str("ORGANIZATION_BLOCK OB 121\nVAR_TEMP\n t : ARRAY [0..19] OF BYTE;\nEND_VAR\nBEGIN\n");
        text.push_str("L MB 70; INC 1; T MB 70; L MD 40; T MD 60; L MW 44; T MW 64; L DB4.DBW 6; T MW 66; L MW 80; T MW 68;\n");
        text.push_str(random.of(&[
            "",
            "L MW 44; + 3; T MW 44; S M 52.3;\n",
            "L P#1.0; T MD 40; L 9; T DB4.DBW 0;\n",
            "L 2; T DB1.DBW 0; R Q 4.2;\n",
        ]));
        text.push_str("END_ORGANIZATION_BLOCK\n");
    }
    text
}

fn load(program: &Arc<Program>, engine: impl FnOnce(&Program, &Layout) -> Arc<dyn Engine>) -> Cpu {
    let cpu_type = &CpuType::ALL[0];
    let settings = Settings { virtual_safe_points: SAFE_POINTS_MAX, ..Settings::default() };
    let mut cpu = Cpu::load(cpu_type, Arc::clone(program), engine, Rack::simulated(cpu_type), settings);
    cpu.restart(Restart::Warm);
    cpu
}

#[test]
fn what_a_loop_keeps_in_registers_is_in_memory_when_somebody_looks() {
    let (mut faults, mut ran) = (0, 0);
    for seed in 0..PROGRAMS {
        let text = text(seed);
        let program =
            Arc::new(program::compile(&text, Mnemonics::English, &CpuType::ALL[0]).unwrap_or_else(|why| panic!("{why}\n{text}")).program);
        let mut expected = load(&program, Interpreter::load);
        let mut others = [StatusBits::All, StatusBits::Needed].map(|status| {
            load(&program, |program, layout| Jit::compiled(program, layout, status).unwrap_or_else(|why| panic!("{why}\n{text}")))
        });
        for scan in 0..SCANS {
            expected.scan(scan * 10_000);
            for (other, status) in others.iter_mut().zip(["all", "needed"]) {
                other.scan(scan * 10_000);
                assert_eq!(expected.mode(), other.mode(), "seed {seed}, scan {scan}, {status}:\n{text}");
                let [left, right] = [&expected, other].map(|cpu| &cpu.machine().memory);
                let differs = left.arena.iter().zip(&right.arena).position(|(left, right)| left != right);
                assert_eq!(differs, None, "seed {seed}, scan {scan}, {status}: arena byte\n{text}");
                assert_eq!(expected.machine().budget, other.machine().budget, "seed {seed}, scan {scan}, {status}: budget\n{text}");
                for register in ["accu1", "accu2", "ar1", "ar2", "rlo", "br"] {
                    let value = |cpu: &Cpu| {
                        let registers = &cpu.machine().registers;
                        let all = sieben_engine::machine::Register::ALL.iter().find(|it| it.name() == register).expect("a register");
                        registers.get(*all)
                    };
                    assert_eq!(value(&expected), value(other), "seed {seed}, scan {scan}, {status}: {register}\n{text}");
                }
            }
            ran += u64::from(expected.mode() == OperatingMode::Run);
        }
        faults += u64::from(expected.machine().memory.area(sieben_model::address::Area::BitMemory)[70] > 0);
    }
    assert!(faults > PROGRAMS / 5 && ran > PROGRAMS, "{faults} programs with faults, {ran} scans to their end");
}

#[test]
fn an_element_that_nobody_needs_is_looked_for_and_noted() {
    // In each third scan the index that the array `t` has is outside of `a`.
    let text = "FUNCTION_BLOCK Reader
VAR t, a, b, c : ARRAY[0..99] OF DINT; i, y, scans : DINT; END_VAR
scans := scans + 1;
IF scans MOD 3 = 0 THEN t[50] := 200; ELSE t[50] := 7; END_IF;
FOR i := 0 TO 99 DO
  y := a[t[i]];
  y := b[i];
  c[i] := y;
END_FOR;
END_FUNCTION_BLOCK
PROGRAM Main
VAR reader : Reader; END_VAR
reader();
END_PROGRAM
";
    let cpu_type = CpuType::by_name("315-2PN/DP").expect("a CPU type");
    let compiled = compile_sources(&[("reader.st", text)], None, Some(Dialect::Iec), cpu_type).expect("the program compiles");
    let program = Arc::new(compiled.program);
    let noted = |engine: fn(&Program, &Layout) -> Arc<dyn Engine>| {
        let mut cpu = load(&program, engine);
        for scan in 0..9 {
            cpu.scan(scan * 10_000);
        }
        cpu.diagnostic_buffer().entries().map(DiagnosticEntry::event).collect::<Vec<u16>>()
    };
    let expected = noted(Interpreter::load);
    assert_eq!(expected.iter().filter(|&&event| event == 0x2522).count(), 3);
    for status in [StatusBits::All, StatusBits::Needed] {
        let found = match status {
            StatusBits::All => noted(|program, layout| Jit::compiled(program, layout, StatusBits::All).expect("machine code")),
            StatusBits::Needed => noted(|program, layout| Jit::compiled(program, layout, StatusBits::Needed).expect("machine code")),
        };
        assert_eq!(found, expected, "{status:?}");
    }
}
