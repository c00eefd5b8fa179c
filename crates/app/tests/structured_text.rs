//! Programs of ST and SCL from their text to the values of their variables.

use std::sync::Arc;

use sieben_cpu::{Cpu, Rack, Restart, Settings};
use sieben_engine::{Interpreter, ir};
use sieben_lang::{Options, compile};
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Sources;
use sieben_model::symbols::{Symbol, SymbolTable};
use sieben_sim::names::Name;

/// Compiles sources, runs some scans of 10 ms, and compares what is shown.
fn run(sources: &[(&str, &str)], scans: u64, expected: &[(&str, &str)]) {
    let mut texts = Sources::default();
    for (name, text) in sources {
        texts.add(*name, *text);
    }
    let symbols = SymbolTable::new(vec![Symbol {
        name: "Lamp".to_owned(),
        address: "Q 4.0".to_owned(),
        data_type: "BOOL".to_owned(),
        ..Symbol::default()
    }]);
    let cpu_type = &CpuType::ALL[0];
    let options = Options { cpu: Some(cpu_type), system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let compiled = compile(&texts, &symbols, &options);
    let shown: Vec<String> = compiled
        .diagnostics
        .iter()
        .filter(|diagnostic| diagnostic.severity() == sieben_model::diagnostic::Severity::Error)
        .map(|diagnostic| {
            let (line, column) = texts.line_column(diagnostic.span);
            format!("{line}:{column}: {}: {}", diagnostic.problem.code(), diagnostic.message)
        })
        .collect();
    assert!(shown.is_empty(), "{shown:#?}");
    for (id, block) in &compiled.program.code {
        assert_eq!(ir::verify(&block.code), Ok(()), "the code of {id} keeps the rules of the IR");
    }
    let mut cpu = Cpu::load(cpu_type, Arc::new(compiled.program), Interpreter::load, Rack::simulated(cpu_type), Settings::default());
    cpu.restart(Restart::Warm);
    for scan in 0..scans {
        cpu.scan(scan * 10_000);
        assert_eq!(cpu.stop_cause(), None, "scan {scan}");
    }
    let found: Vec<(String, String)> = expected
        .iter()
        .map(|(name, _)| {
            let parsed = Name::parse(name, &symbols, cpu.program()).unwrap_or_else(|error| panic!("{name}: {error}"));
            (name.to_string(), parsed.read(&cpu).map_or_else(|error| error.to_string(), |shown| shown.to_string()))
        })
        .collect();
    let expected: Vec<(String, String)> = expected.iter().map(|(name, value)| (name.to_string(), value.to_string())).collect();
    assert_eq!(found, expected);
}

#[test]
fn a_program_keeps_its_variables() {
    let text = "PROGRAM Main\nVAR\n  x, y : INT := 3;\n  n : DINT;\n  r : REAL := 1.5;\n  arr : ARRAY[1..5] OF INT := [1, 2, 3(7)];\nEND_VAR\n\
                y := x * 2 + 1;\nn := n + 1;\nIF y > 5 THEN r := r * 2.0; END_IF;\narr[2] := arr[5] + 1;\nEND_PROGRAM\n";
    run(&[("a.st", text)], 2, &[("x", "3"), ("y", "7"), ("n", "2"), ("r", "6.0e+000"), ("arr[2]", "8"), ("Main.y", "7")]);
}

#[test]
fn statements_outside_of_blocks_are_the_body_of_ob_1() {
    let text = "VAR a, b : INT; t1 : SINT; END_VAR\na := a + 2; b := a * a; t1 := -5;\n";
    run(&[("b.st", text)], 3, &[("a", "6"), ("b", "36"), ("t1", "-5")]);
}

#[test]
fn types_globals_constants_and_instances_have_their_initial_values() {
    let text = "TYPE Color : (Red, Green := 5, Blue); END_TYPE
TYPE Point : STRUCT x, y : INT := 2; END_STRUCT; END_TYPE
TYPE Percent : INT (0..100) := 50; END_TYPE
VAR_GLOBAL gCount : DINT := 100; gLamp AT %QX0.3 : BOOL; END_VAR
VAR_GLOBAL CONSTANT N : INT := 4; HALF : INT := N / 2; END_VAR
FUNCTION Add3 : INT
VAR_INPUT a, b : INT; c : INT := 7; END_VAR
VAR t : INT; END_VAR
  t := a + b;
  Add3 := t + c;
END_FUNCTION
FUNCTION_BLOCK Counter
VAR_INPUT step : INT := 1; END_VAR
VAR_OUTPUT value : INT; END_VAR
  value := value + step;
END_FUNCTION_BLOCK
PROGRAM Main
VAR
  c : Color := Green;
  p : Point := (x := 9);
  ps : ARRAY[1..3] OF Point := [(x := 1), (y := 5)];
  q : Percent;
  arr : ARRAY[0..N] OF INT := [N(3)];
  half2 : ARRAY[0..1, 0..1] OF SINT := [[1, 2], [3, HALF]];
  cnt : Counter := (step := 5);
  cnts : ARRAY[1..2] OF Counter;
  l : LINT := -5; lr : LREAL := 1.25; s : STRING[10] := 'abc';
  t : TIME := T#1s500ms; d : DATE := D#2024-02-29;
  r : INT; i : INT; sum : INT;
END_VAR
  cnt();
  cnts[2](step := 3);
  r := Add3(1, 2) + cnt.value;
  gCount := gCount + 1;
  gLamp := r > 3;
  sum := 0;
  FOR i := 0 TO N DO sum := sum + arr[i]; END_FOR;
  CASE c OF Red: r := 1; Green: c := Blue; END_CASE;
END_PROGRAM
";
    let expected = [
        ("c", "Blue"),
        ("p.x", "9"),
        ("p.y", "2"),
        ("ps[1].x", "1"),
        ("ps[1].y", "2"),
        ("ps[2].x", "2"),
        ("ps[2].y", "5"),
        ("q", "50"),
        ("arr[3]", "3"),
        ("arr[4]", "0"),
        ("half2[1,0]", "3"),
        ("half2[1,1]", "2"),
        ("cnt.value", "10"),
        ("cnts[2].value", "6"),
        ("cnts[1].step", "1"),
        ("l", "-5"),
        ("lr", "1.25e+000"),
        ("s", "'abc'"),
        ("t", "T#1S500MS"),
        ("d", "LD#2024-02-29"),
        ("gLamp", "1"),
        ("Q0.3", "1"),
        ("r", "20"),
        ("gCount", "102"),
        ("sum", "12"),
    ];
    run(&[("d.st", text)], 2, &expected);
}

#[test]
fn scl_has_blocks_by_number_symbols_views_and_data_blocks() {
    let text = "TYPE UDT1 STRUCT a : INT := 4; b : WORD := W#16#1234; END_STRUCT END_TYPE
FUNCTION FC10 : INT
VAR_INPUT a, b : INT; END_VAR
  FC10 := a + b;
END_FUNCTION
FUNCTION_BLOCK FB5
CONST LIMIT := 3; END_CONST
VAR_INPUT x : INT; END_VAR
VAR_OUTPUT sum : INT; END_VAR
VAR w : WORD := W#16#A1B2; bytes AT w : ARRAY[0..1] OF BYTE; END_VAR
  IF x > LIMIT THEN sum := sum + x; END_IF;
  IF bytes[0] = B#16#A1 THEN \"Lamp\" := TRUE; END_IF;
END_FUNCTION_BLOCK
DATA_BLOCK DB5 FB5
BEGIN
  sum := 100;
END_DATA_BLOCK
DATA_BLOCK DB7 UDT1
BEGIN
  a := 11;
END_DATA_BLOCK
DATA_BLOCK DB8 STRUCT x : ARRAY[1..4] OF INT := 1, 2, 2(9); s : STRING[6] := 'xy'; END_STRUCT
BEGIN
  x[2] := 20;
END_DATA_BLOCK
ORGANIZATION_BLOCK OB1
VAR_TEMP info : ARRAY[0..19] OF BYTE; END_VAR
  MW0 := INT_TO_WORD(FC10(a := 3, b := 4));
  FB5.DB5(x := 7);
  FB5.DB6(x := 5);
  DB7.a := DB7.a + 1;
END_ORGANIZATION_BLOCK
";
    let expected = [
        ("MW0", "16#0007"),
        ("DB5.sum", "114"),
        ("DB6.sum", "10"),
        ("Lamp", "1"),
        ("DB7.a", "13"),
        ("DB7.b", "16#1234"),
        ("DB8.x[2]", "20"),
        ("DB8.x[4]", "9"),
        ("DB8.s", "'xy'"),
    ];
    run(&[("c.scl", text)], 2, &expected);
}

#[test]
fn blocks_of_stl_and_st_call_each_other() {
    let st = "FUNCTION Twice : INT\nVAR_INPUT v : INT; END_VAR\n  Twice := v * 2;\nEND_FUNCTION\n\
              FUNCTION_BLOCK Ramp\nVAR_INPUT more : INT; END_VAR\nVAR_OUTPUT out : INT; END_VAR\nVAR inner : FromStl; END_VAR\n\
              inner(i := more);\n  out := out + inner.o;\nEND_FUNCTION_BLOCK\n";
    let stl = "FUNCTION_BLOCK FB 20\nNAME : FromStl\nVAR_INPUT\n i : INT;\nEND_VAR\nVAR_OUTPUT\n o : INT;\nEND_VAR\nBEGIN\nL #i;\nL 1;\n+I;\nT #o;\n\
               END_FUNCTION_BLOCK\nDATA_BLOCK DB 30 \"Ramp\"\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n\
               CALL \"Twice\" (v := 21, RET_VAL := MW 10);\nCALL \"Ramp\", DB 30 (more := 4);\nEND_ORGANIZATION_BLOCK\n";
    let st = st.replace("FromStl", "FB20");
    run(&[("a.scl", &st), ("b.awl", stl)], 2, &[("MW 10", "16#002A"), ("DB30.out", "10")]);
}

#[test]
fn library_blocks_are_linked_when_something_needs_them() {
    let text = "VAR t : TON; s : SR; r : R_TRIG; n : INT; END_VAR\nt(IN := TRUE, PT := T#30ms);\ns(S1 := t.Q, R := FALSE);\nr(CLK := s.Q1);\n\
                IF r.Q THEN n := n + 1; END_IF;\n";
    run(&[("t.st", text)], 3, &[("t.Q", "0"), ("n", "0")]);
    run(&[("t.st", text)], 6, &[("t.Q", "1"), ("s.Q1", "1"), ("n", "1")]);
}

#[test]
fn functions_have_results_of_every_kind_and_outputs() {
    let text = "FUNCTION Big : LINT\nVAR_INPUT a : LINT; END_VAR\n  Big := a * 1000000;\nEND_FUNCTION\n\
                FUNCTION Split : BOOL\nVAR_INPUT v : INT; END_VAR\nVAR_OUTPUT tens, ones : INT; END_VAR\n  tens := v / 10;\n  ones := v MOD 10;\n\
                Split := tens > 0;\nEND_FUNCTION\n\
                FUNCTION Greet : STRING[20]\nVAR_INPUT who : STRING[10]; END_VAR\n  Greet := CONCAT('Hi ', who);\nEND_FUNCTION\n\
                FUNCTION Bump : INT\nVAR_IN_OUT list : ARRAY[1..3] OF INT; END_VAR\n  list[2] := list[2] + 1;\n  Bump := list[2];\nEND_FUNCTION\n\
                VAR total : LINT; t, o, b : INT; ok : BOOL; s : STRING[20]; list : ARRAY[1..3] OF INT := [1, 2, 3]; END_VAR\n\
                total := Big(a := 5000);\nok := Split(v := 42, tens => t, ones => o);\ns := Greet('Ann');\nb := Bump(list := list);\n";
    let expected = [("total", "5000000000"), ("ok", "1"), ("t", "4"), ("o", "2"), ("s", "'Hi Ann'"), ("b", "4"), ("list[2]", "4")];
    run(&[("f.st", text)], 2, &expected);
}

#[test]
fn tasks_run_in_cyclic_interrupts() {
    let text = "PROGRAM Slow VAR n : INT; END_VAR n := n + 1; END_PROGRAM\nPROGRAM Each VAR n : INT; END_VAR n := n + 1; END_PROGRAM\n\
                CONFIGURATION c RESOURCE r ON PLC TASK t(INTERVAL := T#100ms, PRIORITY := 1); PROGRAM p WITH t : Slow; PROGRAM q : Each; \
                END_RESOURCE END_CONFIGURATION\n";
    run(&[("c.st", text)], 26, &[("Each.n", "26"), ("Slow.n", "2")]);
}

#[test]
fn tia_quotes_names() {
    let text = "TYPE \"Recipe\"\nVERSION : 0.1\nSTRUCT\n  amount : Int := 3;\nEND_STRUCT;\nEND_TYPE\n\
                FUNCTION_BLOCK \"Motor\"\n{ S7_Optimized_Access := 'FALSE' }\nVERSION : 0.1\nVAR_INPUT\n  on : Bool;\nEND_VAR\nVAR_OUTPUT\n  n : Int;\nEND_VAR\n\
                VAR\n  r : \"Recipe\";\nEND_VAR\nBEGIN\n  IF #on THEN\n    #n := #n + #r.amount;\n  END_IF;\nEND_FUNCTION_BLOCK\n\
                DATA_BLOCK \"Motor_DB\"\n{ S7_Optimized_Access := 'FALSE' }\nVERSION : 0.1\n\"Motor\"\nBEGIN\nEND_DATA_BLOCK\n\
                ORGANIZATION_BLOCK \"Main\"\nVERSION : 0.1\nBEGIN\n  \"Motor_DB\"(on := TRUE);\nEND_ORGANIZATION_BLOCK\n";
    run(&[("m.scl", text)], 3, &[("Motor_DB.n", "9")]);
}

#[test]
fn results_that_are_arrays_and_structures_begin_with_their_initial_values() {
    let source = "TYPE Pt : STRUCT x : INT; y : INT := 5; END_STRUCT END_TYPE\n\
        FUNCTION Mk : Pt VAR_INPUT v : INT; END_VAR IF v > 5 THEN Mk.x := v; END_IF; END_FUNCTION\n\
        FUNCTION Arr : ARRAY[0..6] OF INT VAR_INPUT v : INT; END_VAR Arr[1] := v; END_FUNCTION\n\
        PROGRAM Main VAR q : Pt := (x := 1, y := 9); a : ARRAY[0..6] OF INT := [7(8)]; END_VAR\n\
        q := Mk(v := 7); a := Arr(v := 2); END_PROGRAM";
    run(&[("main.st", source)], 2, &[("q.x", "7"), ("q.y", "5"), ("a[0]", "0"), ("a[1]", "2"), ("a[6]", "0")]);
}
