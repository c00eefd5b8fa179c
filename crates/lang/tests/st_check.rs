//! What each dialect of ST accepts, accepts with a warning and rejects: rows of programs, each with one verdict.

use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Options, compile};
use sieben_model::diagnostic::Severity;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_model::types::DataType;

/// Dialects, declarations, statements, and what is said: `ok`, `warning CODE`, `error CODE`. Exactly one message, and no other.
type Row = (&'static str, &'static str, &'static str, &'static str);

/// Rows of the reference vectors and of the rules of the checker.
const ROWS: &[Row] = &[
    // Precedence and chains.
    ("iec codesys scl tia", "b : BOOL; x : INT;", "b := 1 < x < 3;", "error P6202"),
    ("iec codesys tia", "b : BOOL; x : INT;", "b := 1 < x = TRUE;", "ok"),
    // Implicit conversions.
    ("codesys", "i : INT; d : DINT;", "i := d;", "error P6200"),
    ("iec codesys scl tia", "i : INT; d : DINT;", "d := i;", "ok"),
    ("scl", "d : DINT; r : REAL;", "r := d;", "ok"),
    ("codesys", "d : DINT; r : REAL;", "r := d;", "warning P6201"),
    ("iec", "d : DINT; r : REAL;", "r := d;", "error P6200"),
    ("iec codesys scl tia", "i : INT; r : REAL;", "i := r;", "error P6200"),
    ("iec", "u : UINT; i : INT;", "u := i;", "error P6200"),
    ("codesys", "u : UINT; i : INT;", "u := i;", "warning P6201"),
    ("iec scl", "i : INT; w : WORD;", "i := w;", "error P6200"),
    ("codesys", "i : INT; w : WORD;", "i := w;", "warning P6201"),
    ("iec", "w : WORD; u : UINT;", "w := u;", "error P6200"),
    ("iec codesys scl tia", "dw : DWORD; w : WORD;", "dw := w;", "ok"),
    ("iec codesys scl tia", "w : WORD;", "w := 16#FF;", "ok"),
    ("scl", "w : WORD;", "w := 255;", "error P6050"),
    ("tia", "w : WORD;", "w := 255;", "warning P6051"),
    ("scl tia", "w : WORD; b : BOOL;", "w := b;", "ok"),
    ("iec codesys", "w : WORD; b : BOOL;", "w := b;", "error P6200"),
    ("scl iec", "w : WORD;", "w := w + 1;", "error P6202"),
    ("codesys", "w : WORD;", "w := w + 1;", "ok"),
    ("iec scl", "i : INT;", "i := i AND 1;", "error P6202"),
    ("codesys tia", "i : INT;", "i := i AND 1;", "ok"),
    ("iec", "d : DINT; i : INT;", "d := i * 1.5;", "error P6200"),
    ("iec codesys scl tia", "b : BOOL;", "b := 1;", "ok"),
    ("iec codesys scl tia", "b : BOOL;", "b := 2;", "error P4001"),
    ("iec codesys scl tia", "i : INT;", "i := 32768;", "error P4001"),
    ("iec codesys scl tia", "i : INT;", "i := 20000 + 20000;", "error P4001"),
    ("iec tia", "i : USINT;", "i := -1;", "error P4001"),
    ("codesys", "i : USINT;", "i := -1;", "warning P6201"),
    ("codesys", "i : USINT;", "i := -200;", "error P4001"),
    ("iec codesys scl tia", "r : REAL;", "r := 1;", "ok"),
    ("iec codesys scl tia", "i : INT;", "i := 1.5;", "error P6200"),
    ("iec codesys scl tia", "i : INT;", "i := TRUE;", "error P6200"),
    ("iec codesys scl tia", "i : INT;", "i := 'a';", "error P6200"),
    ("iec codesys scl tia", "t1 : TIME;", "t1 := 5;", "error P6200"),
    ("iec codesys scl tia", "t1 : TIME; i : INT;", "i := t1;", "error P6200"),
    ("iec", "u : UINT; v : UINT;", "u := -v;", "error P6202"),
    // Literals.
    ("iec codesys scl tia", "d1 : DATE;", "d1 := D#2024-02-29;", "ok"),
    ("scl tia", "d1 : DATE;", "d1 := D#1989-12-31;", "error"),
    ("codesys", "t1 : TIME;", "t1 := T#-5s;", "error"),
    ("scl", "s : S5TIME;", "s := S5T#3h;", "error"),
    ("iec codesys scl tia", "i : INT;", "i := 1__0;", "error"),
    ("iec codesys scl tia", "r : REAL;", "r := .5;", "error"),
    ("iec codesys scl tia", "r : REAL;", "r := 5.;", "error"),
    ("iec codesys scl tia", "t1 : TIME;", "t1 := T#5s1h;", "error"),
    ("iec codesys scl tia", "t1 : TIME;", "t1 := T#1.5h20m;", "error"),
    ("iec codesys scl tia", "t1 : TOD;", "t1 := TOD#24:00:00;", "error"),
    ("iec codesys scl tia", "s : STRING;", "s := 'a$zb';", "error"),
    ("iec codesys scl tia", "s : STRING[3];", "s := 'abcd';", "warning P6201"),
    ("scl tia", "s : STRING;", "s := \"abc\";", "error"),
    ("iec", "i : INT;", "(* a (* b *) c *) i := 1;", "ok"),
    ("iec", "i : INT;", "/* a */ i := 1;", "ok"),
    ("scl tia", "i : INT;", "/* a */ i := 1;", "error"),
    // Operators.
    ("iec codesys scl tia", "b : BOOL; i : INT;", "b := b AND i;", "error P6202"),
    ("iec codesys scl tia", "t1 : TIME; t2 : TIME;", "t1 := t1 * t2;", "error P6202"),
    ("iec codesys scl tia", "t1 : TIME;", "t1 := t1 + 5;", "error P6202"),
    ("iec codesys scl tia", "t1 : TIME;", "t1 := t1 + T#1s;", "ok"),
    ("iec codesys scl tia", "t1 : TIME;", "t1 := t1 * 2;", "ok"),
    ("iec codesys scl tia", "r : REAL;", "r := r MOD 2.0;", "error P6202"),
    ("scl", "b : BOOL; c : BOOL;", "b := b < c;", "error P6202"),
    ("iec codesys scl tia", "s : STRING; u : STRING;", "s := s + u;", "error P6202"),
    ("iec codesys scl tia", "t1 : TIME;", "t1 := 5s;", "error P4202"),
    ("iec codesys", "t1 : TON; b : BOOL;", "t1(IN = b, PT := T#1s);", "error P2007"),
    ("iec codesys", "b : BOOL; c : BOOL;", "b := b < c;", "ok"),
    ("iec codesys scl tia", "b : BOOL; i : INT;", "b := i > 40000;", "warning P6221"),
    ("iec codesys scl tia", "b : BOOL; i : INT;", "b := i < 32767;", "ok"),
    ("iec codesys scl tia", "i : INT;", "i := i / 0;", "warning P6227"),
    ("iec", "i : INT;", "i := i DIV 2;", "error"),
    ("scl tia", "i : INT;", "i := i DIV 2;", "ok"),
    ("iec scl tia", "b : BOOL;", "b := b AND_THEN b;", "error"),
    ("codesys", "b : BOOL;", "b := b AND_THEN b;", "ok"),
    // Standard functions.
    ("iec", "i : INT;", "i := SHL(i, 1);", "error"),
    ("iec", "b : BOOL;", "b := NE(1, 2, 3);", "error"),
    ("codesys", "s : STRING;", "s := CONCAT('A','B','C');", "error"),
    ("iec codesys scl tia", "i : INT;", "i := NOSUCH(i);", "error P3008"),
    // Statements.
    ("codesys", "b : BYTE; r : INT;", "FOR b := 0 TO 255 DO r := r + 1; END_FOR;", "warning P6212"),
    ("iec codesys scl tia", "x : REAL;", "FOR x := 1.0 TO 5.0 DO ; END_FOR;", "error P6210"),
    ("iec codesys scl tia", "x : INT; r : INT;", "FOR x := 1 TO 5 BY 0 DO r := r + 1; END_FOR;", "error P6211"),
    ("iec codesys scl tia", "x : INT; r : INT;", "FOR x := 5 TO 1 DO r := r + 1; END_FOR;", "warning P6212"),
    ("iec codesys scl tia", "x : INT; a : ARRAY[2..11] OF INT;", "FOR x := 3 TO 2 DO a[x - 1] := 1; END_FOR;", "warning P6212"),
    ("iec scl", "x : INT;", "FOR x := 1 TO 5 DO x := x + 1; END_FOR;", "warning P6051"),
    ("codesys tia", "x : INT;", "FOR x := 1 TO 5 DO x := x + 1; END_FOR;", "ok"),
    ("iec tia", "x : INT; r : INT;", "CASE x OF 1..5: r := 1; 3: r := 2; END_CASE;", "error P6207"),
    ("scl", "x : INT; r : INT;", "CASE x OF 1..5: r := 1; 3: r := 2; END_CASE;", "warning P6208"),
    ("iec codesys scl tia", "x : INT; r : INT;", "CASE x OF 9..5: r := 1; END_CASE;", "error P6209"),
    ("iec codesys scl tia", "x : INT; r : INT;", "CASE x OF r: r := 1; END_CASE;", "error P6229"),
    ("iec codesys scl tia", "x : REAL; r : INT;", "CASE x OF 1: r := 1; END_CASE;", "error P6233"),
    ("scl", "x : WORD; r : INT;", "CASE x OF 1: r := 1; 2, 3..5: r := 2; END_CASE;", "error P6050"),
    ("iec codesys scl tia", "x : INT; r : INT;", "CASE x OF 1, 3: r := 1; 2: r := 2; ELSE r := 3; END_CASE;", "ok"),
    ("iec", "", "GOTO l1;", "error"),
    ("iec codesys scl tia", "", "EXIT;", "error P6213"),
    ("iec codesys scl tia", "", "CONTINUE;", "error P6213"),
    ("iec codesys scl tia", "x : INT;", "WHILE x < 5 DO x := x + 1; EXIT; x := 3; END_WHILE;", "warning P2208"),
    ("iec codesys scl tia", "x : INT;", "RETURN; x := 3;", "warning P2208"),
    ("iec codesys scl tia", "x : INT;", "IF x THEN x := 1; END_IF;", "error P6203"),
    ("iec codesys scl tia", "x : INT;", "WHILE x + 1 DO x := 1; END_WHILE;", "error P6203"),
    ("iec codesys scl tia", "x : INT;", "x = 5;", "error"),
    ("iec codesys scl tia", "x : INT;", "x + 5;", "error"),
    ("iec scl tia", "x : INT;", "x;", "error P6216"),
    ("codesys", "x : INT;", "x;", "warning P6051"),
    ("iec codesys scl tia", "x, y : INT;", "x := 1 y := 2;", "error"),
    ("iec scl tia", "a : BOOL; x, y : INT;", "IF a THEN x := 1; END_IF y := 2;", "error"),
    ("tia", "x : INT;", "#x += 2;", "ok"),
    ("tia", "x : INT;", "REGION my part\n x := 1;\nEND_REGION", "ok"),
    ("iec scl", "a, b : INT;", "a := b := 7;", "error"),
    ("codesys tia", "a, b : INT;", "a := b := 7;", "ok"),
    ("codesys", "a, b : BOOL;", "a S= b;", "ok"),
    ("codesys", "a : INT; b : BOOL;", "a S= b;", "error P6200"),
    // Names and parts.
    ("iec codesys scl tia", "level : INT;", "levle := 1;", "error P3001"),
    ("iec codesys scl tia", "level : INT;", "level.x := 1;", "error P4010"),
    ("iec codesys scl tia", "level : INT;", "level[1] := 1;", "error P4010"),
    ("iec codesys scl tia", "s : STRUCT x : INT; END_STRUCT;", "s.y := 1;", "error P3007"),
    ("iec codesys scl tia", "s : STRUCT x : INT; END_STRUCT;", "s := 1;", "error P6200"),
    ("iec codesys scl tia", "a : ARRAY[1..3] OF INT;", "a[4] := 1;", "error P4005"),
    ("iec codesys scl tia", "a : ARRAY[1..3] OF INT;", "a[-1] := 1;", "error P4005"),
    ("iec codesys scl tia", "a : ARRAY[1..3, 0..1] OF INT;", "a[1] := 1;", "error P4005"),
    ("iec codesys scl tia", "a : ARRAY[1..3] OF INT; r : REAL;", "a[r] := 1;", "error P6200"),
    ("iec codesys scl tia", "a : ARRAY[1..3] OF INT; b : ARRAY[1..3] OF INT;", "a := b;", "ok"),
    ("iec codesys scl tia", "a : ARRAY[1..3] OF INT; b : ARRAY[1..4] OF INT;", "a := b;", "error P6200"),
    ("iec codesys", "w : WORD; b : BOOL;", "b := w.15;", "ok"),
    ("iec codesys", "w : WORD; b : BOOL;", "b := w.16;", "error P6225"),
    ("iec tia", "w : DWORD; x : WORD;", "x := w.%W1;", "ok"),
    ("iec tia", "w : DWORD; x : WORD;", "x := w.%W2;", "error P6225"),
    ("iec", "s : INT(0..100);", "s := 101;", "error P4001"),
    ("iec", "s : INT(0..100); i : INT;", "s := i;", "ok"),
    // One mistake, one message.
    ("iec codesys scl tia", "x : INT;", "x := ABS(nowhere);", "error P3001"),
    ("iec codesys scl tia", "x : INT;", "IF nowhere THEN x := 1; END_IF;", "error P3001"),
    // Standard functions take all their inputs, those that are blocks of the library too.
    ("iec codesys", "s : STRING;", "s := LEFT(s);", "error P3010"),
    ("iec codesys scl tia", "s : STRING;", "s := CONCAT(s);", "error P3010"),
    ("iec codesys", "i : INT;", "i := CODE_IN_TEXT('a');", "error P3008"),
    ("iec", "d : DATE;", "d := CONCAT_DATE(2024, 2);", "error P3010"),
    ("iec", "d : DATE;", "d := CONCAT_DATE(YEAR := 2024, DAY := 1);", "error P3010"),
    ("iec", "d : DATE;", "d := CONCAT_DATE(YEAR := 2024, YEAR := 2025, MONTH := 1, DAY := 1);", "error P3011"),
    ("iec", "d : DATE;", "SPLIT_DATE();", "error P3010"),
];

fn program(dialect: Dialect, declarations: &str, code: &str) -> String {
    match dialect {
        Dialect::Iec | Dialect::Codesys => format!("PROGRAM Main\nVAR\n  {declarations}\nEND_VAR\n{code}\nEND_PROGRAM\n"),
        Dialect::Scl => format!(
            "FUNCTION_BLOCK FB1\nVAR\n  {declarations}\nEND_VAR\nBEGIN\n{code}\nEND_FUNCTION_BLOCK\nORGANIZATION_BLOCK OB1\nBEGIN\n;\nEND_ORGANIZATION_BLOCK\n"
        ),
        _ => format!(
            "FUNCTION_BLOCK \"Test\"\nVAR\n  {declarations}\nEND_VAR\nBEGIN\n{code}\nEND_FUNCTION_BLOCK\nORGANIZATION_BLOCK \"Main\"\nBEGIN\n;\nEND_ORGANIZATION_BLOCK\n"
        ),
    }
}

fn said(dialect: Dialect, text: &str) -> Vec<(Severity, &'static str, String)> {
    let mut sources = Sources::default();
    sources.add("row.st", text);
    let options = Options { dialect: Some(dialect), ..Options::default() };
    let compiled = compile(&sources, &SymbolTable::default(), &options);
    // Whether there is an OB 1 is not what the rows are about.
    let messages = compiled.diagnostics.into_iter().filter(|one| one.problem.code() != "P3013");
    messages.map(|one| (one.severity(), one.problem.code(), one.message)).collect()
}

#[test]
fn each_dialect_says_what_the_row_says() {
    let mut failures = Vec::new();
    for &(dialects, declarations, code, verdict) in ROWS {
        for dialect in dialects.split(' ').map(|name| Dialect::from_name(name).expect("a row names dialects")) {
            let said = said(dialect, &program(dialect, declarations, code));
            let short: Vec<String> = said
                .iter()
                .map(|(severity, problem, _)| format!("{} {problem}", if *severity == Severity::Error { "error" } else { "warning" }))
                .collect();
            let fits = match verdict {
                "ok" => short.is_empty(),
                "error" => matches!(short.as_slice(), [one] if one.starts_with("error")),
                exact => short == [exact],
            };
            if !fits {
                failures.push(format!("{}: {declarations} | {code}\n    wanted {verdict}, got {said:?}", dialect.name()));
            }
        }
    }
    assert!(failures.is_empty(), "{} rows:\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn functions_that_call_themselves_are_told_once_for_each_circle() {
    let declare = |name: &str, called: &str| {
        format!("FUNCTION {name} : INT\nVAR_INPUT n : INT; END_VAR\nIF n > 0 THEN {name} := {called}(n - 1); END_IF;\nEND_FUNCTION\n")
    };
    let main = "PROGRAM Main\nVAR x : INT; END_VAR\nx := A(1) + S(2);\nEND_PROGRAM\n";
    let text = [declare("A", "B"), declare("B", "A"), declare("S", "S"), main.to_owned()].concat();
    for (dialect, problem) in [(Dialect::Iec, "P6050"), (Dialect::Codesys, "P6051")] {
        let said = said(dialect, &text);
        let codes: Vec<&str> = said.iter().map(|(_, problem, _)| *problem).collect();
        assert_eq!(codes, [problem; 2], "{said:?}");
    }
    let straight = [declare("A", "B"), declare("B", "ABS"), main.replace("S(2)", "B(2)")].concat();
    assert!(said(Dialect::Iec, &straight).is_empty());
}

#[test]
fn what_a_block_would_inherit_from_a_base_that_is_lacking_is_not_missed() {
    let timer = |base: &str| {
        format!(
            "FUNCTION_BLOCK Timer EXTENDS {base}\nVAR_OUTPUT n : INT; END_VAR\n  SUPER^(IN := IN, PT := PT);\n  Look();\n  IF Q THEN n := 1; END_IF;\nEND_FUNCTION_BLOCK\n\
             FUNCTION_BLOCK Second EXTENDS Timer\n  SUPER^();\n  n := n + more;\nEND_FUNCTION_BLOCK\n\
             PROGRAM Main\nVAR t : Timer; s : Second; x : BOOL; END_VAR\n  t(IN := x, PT := T#1s);\n  x := s.Q;\n  s.Look();\nEND_PROGRAM\n"
        )
    };
    for (dialect, base, code) in
        [("iec", "TONN", "P6280"), ("codesys", "Main", "P6280"), ("iec", "Second", "P6280"), ("tia", "TON", "P6050")]
    {
        let said = said(Dialect::from_name(dialect).expect("a dialect"), &timer(base));
        let wrong: Vec<_> = said.iter().filter(|(severity, ..)| *severity == Severity::Error).collect();
        assert!(!wrong.is_empty() && wrong.iter().all(|(_, problem, _)| *problem == code), "{dialect}, {base}: {said:?}");
    }
}

#[test]
fn timers_and_counters_remember_inputs_beside_them() {
    // The variables of an instance with their bytes and bits, and its bytes.
    let rows = [
        ("TON", "IN 0.0, M 0.1, PT 2.0, Q 6.0, ET 8.0, START 12.0: 16"),
        ("CTU", "CU 0.0, R 0.1, MU 0.2, PV 2.0, Q 4.0, CV 6.0: 8"),
        ("CTUD", "CU 0.0, CD 0.1, R 0.2, LD 0.3, MU 0.4, MD 0.5, PV 2.0, QU 4.0, QD 4.1, CV 6.0: 8"),
        // Blocks of the user lie as the manual says, whatever stands between their parameters.
        ("Own", "IN 0.0, PT 2.0, M 6.0: 8"),
    ];
    for (name, expected) in rows {
        let own = "FUNCTION_BLOCK Own\nVAR_INPUT IN : BOOL; END_VAR\nVAR M : BOOL; END_VAR\nVAR_INPUT PT : TIME; END_VAR\n  M := IN;\nEND_FUNCTION_BLOCK\n";
        let mut sources = Sources::default();
        sources.add("test.st", format!("{own}PROGRAM Main\nVAR x : {name}; END_VAR\n  x();\nEND_PROGRAM\n"));
        let program = compile(&sources, &SymbolTable::default(), &Options::default()).program;
        let instance = program.data.values().find_map(|block| match &block.structure.field("x")?.data_type {
            DataType::Instance { structure, .. } => Some(structure.clone()),
            _ => None,
        });
        let instance = instance.expect("an instance");
        let mut fields: Vec<_> = instance.fields.iter().collect();
        fields.sort_by_key(|field| field.offset);
        let fields: Vec<String> = fields.iter().map(|field| format!("{} {}.{}", field.name, field.offset / 8, field.offset % 8)).collect();
        assert_eq!(format!("{}: {}", fields.join(", "), instance.size), expected, "{name}");
    }
}

#[test]
fn messages_name_what_was_meant() {
    // Dialect, the statements behind the variables, what the whole diagnostic says.
    let rows: &[(&str, &str, &[&str])] = &[
        ("iec", "i := LIMT(1, 2, 3);", &["P3008", "write `LIMIT`"]),
        ("codesys", "i := LIMT(1, 2, 3);", &["P3008", "write `LIMIT`"]),
        ("tia", "i := LIMT(1, 2, 3);", &["P3008", "write `LIMIT`"]),
        // A function that only another dialect has is not what was meant.
        ("scl", "r := NROM_X(1.0);", &["P3008", "Correct the name"]),
        ("tia", "r := NROM_X(1.0);", &["P3008", "write `NORM_X`"]),
        ("iec", "TON();", &["P6217", "`TON` is a function block", "VAR inst : TON;", "inst(IN := …, PT := …)"]),
        ("iec", "i := CTU(CU := TRUE);", &["P6217", "VAR inst : CTU;"]),
        ("scl", "TON(IN := TRUE);", &["P6217", "VAR inst : TON;", "TON.DB20("]),
        ("codesys", "R_TRIG(CLK := TRUE);", &["P6217", "inst(CLK := …)"]),
        ("iec", "d := T#3s;", &["P6200", "DATE is wanted here, and this is TIME"]),
        ("iec", "i := d;", &["P6200", "INT is wanted here, and this is DATE", "`DATE_TO_INT`"]),
        ("codesys", "m := i;", &["P6200", "DATE_AND_TIME is wanted here, and this is INT", "`INT_TO_DT`"]),
        ("iec", "i := CODE_IN_TEXT('a');", &["P3008", "there is no function `CODE_IN_TEXT`"]),
        ("tia", "T_CONV(r, i);", &["P6219", "takes one value", "T_CONV(IN := y, OUT => x)"]),
        ("tia", "T_CONV(IN := r, OUT := i);", &["P6050", "Write `=>`"]),
        ("tia", "d := S_CONV('x');", &["P6322", "`S_CONV` makes no DATE of STRING"]),
        ("tia", "i := RD_SYS_T(i);", &["P4011", "a DTL, an LDT or a DATE_AND_TIME"]),
        ("tia", "i := T_COMBINE(d, d);", &["P6322", "INT is wanted here"]),
        ("tia", "r := T_DIFF(d, 5);", &["P4011", "a date, as the first value is"]),
        ("tia", "i := GET_ERROR(i);", &["P6218", "a statement of its own"]),
        ("tia", "GET_ERROR(i);", &["P4011", "Declare it as ErrorStruct"]),
        ("tia", "i := JOIN(i);", &["P6323", "CONCAT"]),
        ("tia", "i := ATH(i);", &["P3010", "leaves out `N`, `OUT`"]),
        ("tia", "HTA(IN := r, N := 2, OUT => i);", &["P4011", "`r` is REAL"]),
        ("tia", "i := TypeOf(i);", &["P6325", "IF TypeOf(v) = INT THEN"]),
        ("tia", "IF TypeOf(i) = 5 THEN i := 1; END_IF;", &["P6325", "a type is compared with a type"]),
        ("tia", "VariantGet(SRC := i, DST => r);", &["P4011", "moves values of one type"]),
        ("codesys", "i := ADR(i);", &["P6200", "An address has 64 bits"]),
        ("codesys", "i := INT;", &["P6200", "not the type INT"]),
        ("codesys", "i := __NEW(INT);", &["P6323", "Declare an array"]),
        ("iec", "i := DAYS_OF_DATE(2024, 1, 1);", &["P3008", "there is no function"]),
        ("iec", "t := 500;", &["P6200", "TIME is wanted here, not a number", "`T#500ms`"]),
        ("scl", "t := 500;", &["P6200", "`T#500ms`"]),
        ("iec", "IF t > 100 THEN i := 1; END_IF;", &["P6202", "`T#100ms`"]),
        ("iec", "d := 5;", &["P6200", "DATE is wanted here, not a number", "`D#2026-01-31`"]),
        ("iec", "w := w + 1;", &["P6202", "not with WORD", "`WORD_TO_UINT`", "`UINT_TO_WORD`"]),
        ("scl", "w := w + 1;", &["P6202", "not with WORD", "`WORD_TO_INT`"]),
        ("iec", "i := e;", &["P6200", "INT is wanted here", "`TO_INT`"]),
        ("iec", "r := INT_TO_REAL(e);", &["P6200", "INT is wanted here", "`TO_INT`"]),
        ("iec", "d := e;", &["P6200", "DATE is wanted here", "which `TO_INT` gives"]),
        ("iec", "e := 1;", &["P6200", "a number is none", "Write one of its values: `RED`, `GREEN`."]),
        ("iec", "e := i;", &["P6200", "and this is INT", "Write one of its values: `RED`, `GREEN`."]),
        ("iec", "t := -500;", &["P6200", "`T#500ms`"]),
        ("scl", "s := 5;", &["P6200", "`S5T#500ms`"]),
        ("iec", "i := t AND 5;", &["P6202", "Convert one of the two"]),
        ("iec", "e := 'RED';", &["P6200", "not a text", "Write one of its values: `RED`, `GREEN`."]),
        ("iec", "r := '1.5';", &["P6200", "REAL is wanted here, not a text", "`STRING_TO_REAL`"]),
        ("iec", "r := ii;", &["P3001", "`ii` is not declared", "write `i`", "If `i` is not meant, declare it"]),
        ("iec", "i := Other_TO_INT(e);", &["P3008", "there is no function `Other_TO_INT`"]),
    ];
    for (dialect, code, wanted) in rows {
        let dialect = Dialect::from_name(dialect).expect("a dialect");
        let of_siemens = matches!(dialect, Dialect::Scl | Dialect::Tia);
        let types = if of_siemens { "d : DATE; s : S5TIME;" } else { "d : DATE; m : DT; e : (RED, GREEN);" };
        let text = program(dialect, &format!("i : INT; r : REAL; t : TIME; w : WORD; {types}"), code);
        let mut sources = Sources::default();
        sources.add("test.st", text);
        let options = Options { dialect: Some(dialect), ..Options::default() };
        let mut found = compile(&sources, &SymbolTable::default(), &options).diagnostics;
        found.retain(|one| one.problem.code() != "P3013");
        let [found] = found.as_slice() else { panic!("{code}: {found:?}") };
        let whole = format!("{} {} {found:?}", found.problem.code(), found.message);
        assert!(wanted.iter().all(|part| whole.contains(part)), "{code}: {whole}");
    }
}

#[test]
fn variables_that_are_private_stay_in_their_block() {
    let base = "FUNCTION_BLOCK Base\nVAR PRIVATE a : INT; END_VAR\nVAR PROTECTED b : INT; END_VAR\nVAR c : INT; END_VAR\na := b + c;\nEND_FUNCTION_BLOCK\n";
    for (name, wrong) in [("a", true), ("THIS.a", true), ("b", false), ("c", false), ("THIS.c", false)] {
        let other = format!("FUNCTION_BLOCK Other EXTENDS Base\nVAR x : INT; END_VAR\nx := {name};\nEND_FUNCTION_BLOCK\n");
        match (wrong, said(Dialect::Iec, &[base, &other].concat()).as_slice()) {
            (false, []) => {}
            (true, [(Severity::Error, "P6284", message)]) if message.contains("`a` of `Base` is PRIVATE") => {}
            (_, said) => panic!("{name}: {said:?}"),
        }
    }
}

#[test]
fn a_call_by_position_gives_every_input() {
    let function = "FUNCTION Add3 : INT\nVAR_INPUT a, b, c : INT; END_VAR\nVAR_OUTPUT more : INT; END_VAR\nAdd3 := a + b + c; more := 1;\nEND_FUNCTION\n";
    let with_default = "FUNCTION Scaled : INT\nVAR_INPUT a : INT; factor : INT := 5; END_VAR\nScaled := a * factor;\nEND_FUNCTION\n";
    let method = "FUNCTION_BLOCK Adder\nMETHOD Add : INT\nVAR_INPUT a, b : INT; END_VAR\nAdd := a + b;\nEND_METHOD\nEND_FUNCTION_BLOCK\n";
    for (call, missing) in [
        ("Add3(1, 2, 3)", None),
        ("Add3(a := 1, c := 2)", None),
        ("Add3()", None),
        ("Add3(1)", Some("the call of `Add3` leaves out `b`, `c`")),
        ("Add3(1, 2)", Some("the call of `Add3` leaves out `c`")),
        ("Scaled(1)", None),
        ("Scaled()", None),
        ("adder.Add(1, 2)", None),
        ("adder.Add(1)", Some("leaves out `b`")),
    ] {
        for dialect in [Dialect::Iec, Dialect::Codesys] {
            let main = format!("PROGRAM Main\nVAR adder : Adder; x : INT; END_VAR\nx := {call};\nEND_PROGRAM\n");
            let said = said(dialect, &[function, with_default, method, &main].concat());
            match (missing, said.as_slice()) {
                (None, []) => {}
                (Some(missing), [(Severity::Error, "P3010", message)]) if message.contains(missing) => {}
                _ => panic!("{call}: {said:?}"),
            }
        }
    }
}

#[test]
fn a_call_gives_each_in_out_a_variable_unless_it_is_a_value_of_the_instance() {
    let block =
        "FUNCTION_BLOCK Adder\nVAR_IN_OUT sum : INT; END_VAR\nVAR_INPUT more : INT; END_VAR\nsum := sum + more;\nEND_FUNCTION_BLOCK\n";
    let main = |head: &str, end: &str| {
        format!("{block}{head}\nVAR adder : Adder; n : INT; END_VAR\nadder(sum := n, more := 1);\nadder(more := 2);\n{end}\n")
    };
    for dialect in [Dialect::Iec, Dialect::Codesys] {
        let said = said(dialect, &main("PROGRAM Main", "END_PROGRAM"));
        assert!(
            matches!(&said[..], [(Severity::Error, "P3010", message)] if message.contains("the call of `Adder` leaves out `sum`")),
            "{said:?}"
        );
    }
    for dialect in [Dialect::Scl, Dialect::Tia] {
        let said = said(dialect, &main("FUNCTION_BLOCK Main", "END_FUNCTION_BLOCK"));
        assert!(said.iter().all(|(severity, ..)| *severity != Severity::Error), "{said:?}");
    }
}

#[test]
fn references_do_not_outlive_what_they_refer_to() {
    let global =
        "VAR_GLOBAL\n  g : REF_TO INT;\n  gs : REF_TO S;\n  p : POINTER TO INT;\nEND_VAR\nTYPE S : STRUCT a : INT; END_STRUCT; END_TYPE\n";
    let iec = global.replace("  p : POINTER TO INT;\n", "");
    let codesys = global.replace("  g : REF_TO INT;\n  gs : REF_TO S;\n", "");
    let of_function = |variables: &str, code: &str| format!("FUNCTION F : INT\n{variables}\n{code}\nF := 0;\nEND_FUNCTION\n");
    let of_method = |variables: &str, code: &str| {
        format!(
            "FUNCTION_BLOCK B\nVAR\n  own : INT;\nEND_VAR\nMETHOD PUBLIC M : INT\n{variables}\n{code}\nM := 0;\nEND_METHOD\nEND_FUNCTION_BLOCK\n"
        )
    };
    // Variables, statements, whether the reference dangles.
    let rows = [
        ("VAR_INPUT a : INT; END_VAR", "g := REF(a);", true),
        ("VAR_OUTPUT a : INT; END_VAR", "g := REF(a);", true),
        ("VAR_IN_OUT a : INT; END_VAR", "g := REF(a);", true),
        ("VAR a : INT; END_VAR", "g := REF(a);", true),
        ("VAR_TEMP a : INT; END_VAR", "g := REF(a);", true),
        ("VAR_INPUT a : S; END_VAR", "gs := REF(a);", true),
        ("VAR_IN_OUT a : S; END_VAR", "gs := REF(a);", false),
    ];
    let dangling = |dialect, text: &str| {
        let said = said(dialect, text);
        let all_of_it = said.iter().all(|(severity, code, message)| {
            *severity == Severity::Warning || *code == "P6204" && message.contains("lives only until the block ends")
        });
        assert!(all_of_it, "{text}\n{said:?}");
        said.iter().filter(|(severity, ..)| *severity == Severity::Error).count()
    };
    for (variables, code, dangles) in rows {
        for text in [of_function(variables, code), of_method(variables, code)] {
            assert_eq!(dangling(Dialect::Iec, &format!("{iec}{text}")), usize::from(dangles), "{text}");
        }
    }
    assert_eq!(dangling(Dialect::Iec, &format!("{iec}{}", of_function("", "g := REF(F);"))), 1);
    assert_eq!(dangling(Dialect::Iec, &format!("{iec}{}", of_method("", "g := REF(M);"))), 1);
    assert_eq!(dangling(Dialect::Iec, &format!("{iec}{}", of_method("", "g := REF(own);"))), 0);
    // CODESYS points to anything as long as the block runs.
    let rows = [
        ("VAR_INPUT a : INT; END_VAR VAR q : POINTER TO INT; END_VAR", "q := ADR(a); q^ := 1;", 0),
        ("VAR_INPUT a : INT; END_VAR", "p := ADR(a);", 1),
        ("VAR_IN_OUT a : INT; END_VAR", "p := ADR(a);", 1),
        ("VAR a : INT; END_VAR", "p := ADR(a);", 1),
        ("VAR a : INT; r : REFERENCE TO INT; END_VAR", "r REF= a; r := 2;", 0),
    ];
    for (variables, code, expected) in rows {
        for text in [of_function(variables, code), of_method(variables, code)] {
            assert_eq!(dangling(Dialect::Codesys, &format!("{codesys}{text}")), expected, "{text}");
        }
    }
    let kept = of_method("VAR_INPUT a : INT; END_VAR", "kept REF= a;").replace("own : INT;", "own : INT; kept : REFERENCE TO INT;");
    assert_eq!(dangling(Dialect::Codesys, &kept), 1);
}
