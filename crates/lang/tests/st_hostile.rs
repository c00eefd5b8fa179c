//! Sources of ST with something missing or doubled are answered with diagnostics, not with a panic.

use sieben_lang::{Options, compile};
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// Compiles a source; the code that comes out keeps the rules of the IR.
fn compiled(name: &str, text: &str) {
    let mut sources = Sources::default();
    sources.add(name, text);
    let compiled = compile(&sources, &SymbolTable::default(), &Options::default());
    for (id, block) in &compiled.program.code {
        assert_eq!(sieben_engine::ir::verify(&block.code), Ok(()), "{id} of {text}");
    }
}

const IEC: &str = "TYPE Color : (Red, Green := 5, Blue) := Green; P : STRUCT x, y : INT := 2; c : Color; END_STRUCT; R : INT (0 .. 9); END_TYPE
VAR_GLOBAL CONSTANT N : INT := 4; M : INT := N * 2; END_VAR
VAR_GLOBAL RETAIN g : ARRAY[0 .. N, 1 .. 2] OF P := [ 3 ( ( x := 1 , y := M ) ) ]; q AT %QX0.1 : BOOL; END_VAR
FUNCTION F : STRING [ 10 ] VAR_INPUT a : LINT; END_VAR VAR_OUTPUT o : DATE; END_VAR VAR t : TIME := T#1s; END_VAR F := 'x'; o := D#2024-01-31; END_FUNCTION
FUNCTION_BLOCK B VAR_INPUT i : INT := 3; END_VAR VAR_IN_OUT p : P; END_VAR VAR_OUTPUT e : INT; END_VAR VAR CONSTANT K : REAL := 1.5; END_VAR
VAR s : REF_TO INT := NULL; z : STRING := 'abc'; END_VAR e := i + p.x; END_FUNCTION_BLOCK
PROGRAM Main VAR b : B := ( i := 7 ); k : ARRAY[1 .. 3] OF B; pp : P := ( c := Red ); w : WSTRING [ 5 ] := \"ab\"; END_VAR VAR_EXTERNAL q : BOOL; END_VAR
b ( p := pp ); k [ 2 ] ( p := g [ 1 , 1 ] ); q := b.e > 1; FOR b.i := 1 TO N DO pp.y := pp.y + b.i; END_FOR; END_PROGRAM
CONFIGURATION c RESOURCE r ON PLC TASK t ( INTERVAL := T#10ms ); PROGRAM m WITH t : Main; END_RESOURCE END_CONFIGURATION
";

const SCL: &str = "TYPE UDT1 STRUCT a : INT := 4; n : ARRAY[1..2] OF WORD := W#16#1, W#16#2; END_STRUCT END_TYPE
FUNCTION FC1 : VOID VAR_INPUT t : TIMER; d : BLOCK_DB; p : POINTER; x : ANY; END_VAR VAR_TEMP v : UDT1; b AT v : ARRAY[0..5] OF BYTE; END_VAR v.a := 1; END_FUNCTION
FUNCTION_BLOCK FB1 CONST C := 5; D := C + 1; END_CONST VAR_INPUT i : INT; END_VAR VAR s : SFB4; u : UDT1; w : WORD; l AT w : ARRAY[0..15] OF BOOL; END_VAR
s ( IN := l [ 3 ] , PT := T#1s ); u.a := C * i; END_FUNCTION_BLOCK
DATA_BLOCK DB1 FB1 BEGIN i := 3; u.n [ 2 ] := W#16#7; END_DATA_BLOCK
DATA_BLOCK DB2 STRUCT r : REAL := 1.0; f : ARRAY[1..3] OF STRING [ 4 ] := 3 ( 'ab' ); END_STRUCT BEGIN f [ 1 ] := 'c'; END_DATA_BLOCK
ORGANIZATION_BLOCK OB1 VAR_TEMP i : ARRAY[0..19] OF BYTE; END_VAR FB1.DB1 ( i := 2 ); FB1.DB9 ( i := 2 ); DB2.r := 2.0; MW0 := DB1.w; END_ORGANIZATION_BLOCK
";

#[test]
fn a_missing_or_doubled_word_is_no_panic() {
    for (name, text) in [("a.st", IEC), ("a.scl", SCL)] {
        compiled(name, text);
        let words: Vec<&str> = text.split(' ').collect();
        for skipped in 0..words.len() {
            let without: Vec<&str> = words.iter().enumerate().filter(|(index, _)| *index != skipped).map(|(_, word)| *word).collect();
            compiled(name, &without.join(" "));
            let mut twice = words.clone();
            twice.insert(skipped, words[(skipped * 7 + 3) % words.len()]);
            compiled(name, &twice.join(" "));
        }
        for cut in (0..text.len()).step_by(5).filter(|&cut| text.is_char_boundary(cut)) {
            compiled(name, &text[..cut]);
        }
    }
}

#[test]
fn declarations_without_end_or_measure_end_soon() {
    let chain = |count: usize| (0..count).map(|n| format!("T{n} : ARRAY[0..9] OF T{};", n + 1)).collect::<String>();
    let constants = |count: usize| (0..count).map(|n| format!("C{n} : INT := C{};", n + 1)).collect::<String>();
    let types = |count: usize| (0..count).map(|n| format!("T{n} : STRUCT a : T{}; b : T{}; END_STRUCT;", n + 1, n + 1)).collect::<String>();
    for text in [
        "TYPE T : STRUCT x : T; END_STRUCT; END_TYPE".to_owned(),
        "TYPE A : B; B : A; END_TYPE VAR x : A; END_VAR x := 1;".to_owned(),
        format!("TYPE {} T500 : INT; END_TYPE VAR x : T0; END_VAR ;", chain(500)),
        format!("TYPE {} T60 : BOOL; END_TYPE VAR x : T0; END_VAR ;", types(60)),
        format!("VAR_GLOBAL CONSTANT {} C500 : INT := 1; END_VAR VAR x : ARRAY[0..C0] OF INT; END_VAR ;", constants(500)),
        "VAR_GLOBAL CONSTANT A : INT := B; B : INT := A; END_VAR VAR x : ARRAY[0..A] OF INT; END_VAR ;".to_owned(),
        "VAR CONSTANT A : INT := B; B : INT := A; END_VAR VAR x : ARRAY[0..A] OF INT; END_VAR ;".to_owned(),
        "VAR x : ARRAY[0..2147483647, 0..2147483647, -2147483648..2147483647] OF LREAL; END_VAR ;".to_owned(),
        "VAR x : ARRAY[0..9] OF INT := [2000000000(2000000000(1))]; END_VAR ;".to_owned(),
        "VAR x : ARRAY[0..9] OF INT := [2000000000()]; y : ARRAY[0..60000] OF BOOL := [70000(TRUE)]; END_VAR ;".to_owned(),
        "FUNCTION_BLOCK A VAR b : B; END_VAR END_FUNCTION_BLOCK FUNCTION_BLOCK B VAR a : A; END_VAR END_FUNCTION_BLOCK".to_owned(),
        "VAR CONSTANT X : LINT := 9223372036854775807 * 9223372036854775807 * 9223372036854775807 ** 99; END_VAR ;".to_owned(),
        "VAR x : INT(-32768..32767) := 5; y : UINT(70000..80000); z : STRING[99999999999]; END_VAR ;".to_owned(),
        "VAR a AT %MX99999999999.9 : BOOL; b AT %MW : WORD; c AT %M* : BOOL; END_VAR ;".to_owned(),
    ] {
        compiled("a.st", &text);
        compiled("a.scl", &text);
    }
}
