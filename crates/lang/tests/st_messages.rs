//! What is said of a whole program with one mistake: the message of the mistake, and none of what follows from it.

use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Options, compile};
use sieben_model::diagnostic::Severity;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// A dialect, a program, and the places and codes of all its errors in order.
type Row = (&'static str, &'static str, &'static [&'static str]);

/// Names that are declared twice: which of the two is meant where they are used, nobody knows.
#[rustfmt::skip] // A table.
const TWICE: &[Row] = &[
    ("iec", "PROGRAM main
VAR CONSTANT MAX : INT := 10; END_VAR
VAR max : REAL; a : ARRAY[0..MAX] OF INT; i : INT; END_VAR
FOR i := 0 TO MAX DO IF a[i] > max THEN max := a[i]; END_IF; END_FOR;
max := 1.5; i := max; max(i);
END_PROGRAM", &["3 P3006"]),
    ("iec", "TYPE motor : STRUCT speed : INT; on : BOOL; END_STRUCT; END_TYPE
FUNCTION_BLOCK motor
VAR_INPUT start : BOOL; END_VAR
VAR_OUTPUT run : BOOL; END_VAR
run := start;
END_FUNCTION_BLOCK
PROGRAM main
VAR m, n : motor; END_VAR
m(start := TRUE);
n.speed := 4; n.on := m.run;
END_PROGRAM", &["2 P3006"]),
    ("iec", "FUNCTION f : INT VAR_INPUT a : INT; END_VAR f := a; END_FUNCTION
FUNCTION F : REAL VAR_INPUT a, b : REAL; END_VAR F := a + b; END_FUNCTION
PROGRAM main
VAR i : INT; r : REAL; END_VAR
i := f(a := 1); r := f(a := 1.5, b := 2.0); r := f(1.5, 2.0);
END_PROGRAM", &["2 P3006"]),
    ("iec", "TYPE color : (red, green, RED); END_TYPE
PROGRAM main VAR c : color; i : INT; END_VAR
c := red;
CASE c OF green: i := 1; color#red: i := 2; END_CASE;
END_PROGRAM", &["1 P3006"]),
    ("iec", "TYPE rec : STRUCT x : INT; X : REAL; y : INT; END_STRUCT; END_TYPE
PROGRAM main VAR r : rec; i : INT; END_VAR
r.x := 1.5; r.x := 1; i := r.y;
END_PROGRAM", &["1 P3006"]),
    ("codesys", "FUNCTION_BLOCK drive
VAR_INPUT go : BOOL; Go : INT; END_VAR
VAR speed : INT; END_VAR
METHOD speed : REAL VAR_INPUT v : INT; END_VAR speed := v; END_METHOD
METHOD stop : REAL stop := 1.5; END_METHOD
METHOD stop : INT VAR_INPUT v : INT; END_VAR stop := v; END_METHOD
speed := 2.5; go := 3;
END_FUNCTION_BLOCK
PROGRAM main VAR d : drive; r : REAL; END_VAR
d(go := 2); r := d.speed(v := 1); r := d.speed; r := d.stop() + d.stop(v := 1);
END_PROGRAM", &["2 P3006", "4 P3006", "6 P3006"]),
    ("iec", "VAR_GLOBAL CONSTANT LIMIT : INT := 10; END_VAR
VAR_GLOBAL limit : INT; tank : INT; Tank : ARRAY[1..LIMIT] OF INT; END_VAR
PROGRAM main
VAR_EXTERNAL tank : INT; END_VAR
VAR i : INT; END_VAR
limit := 3;
FOR i := 1 TO LIMIT DO Tank[i] := tank; END_FOR;
END_PROGRAM", &["2 P3006", "2 P3006"]),
    ("scl", "FUNCTION_BLOCK FB10
VAR_INPUT start : BOOL; END_VAR
VAR_TEMP Start : INT; END_VAR
BEGIN
IF start THEN start := FALSE; END_IF; start := start + 1;
END_FUNCTION_BLOCK", &["3 P3006"]),
];

/// Declarations that cannot be read: names are unknown that could not have been declared there.
#[rustfmt::skip] // A table.
const UNREAD: &[Row] = &[
    ("iec", "PROGRAM main
VAR a INT; b : INT; END_VAR
a := 1; b := unknwn; b := k.x;
END_PROGRAM
FUNCTION_BLOCK other VAR z : Missing; END_VAR END_FUNCTION_BLOCK", &["2 P2020", "3 P3001", "3 P3001", "5 P3015"]),
    // Any name may be the one that is lost, also one that means something else outside.
    ("iec", "FUNCTION shape : INT shape := 1; END_FUNCTION
PROGRAM main
VAR a : INT; : REAL; END_VAR
a := b; shape := 2.5; shape.x := c;
END_PROGRAM", &["3 P2020"]),
    ("iec", "TYPE rec : STRUCT
  : INT;
  y : INT;
END_STRUCT; END_TYPE
FUNCTION_BLOCK fb VAR_INPUT r : rec; END_VAR VAR_OUTPUT q : INT; END_VAR q := r.x + r.y; END_FUNCTION_BLOCK
PROGRAM main
VAR r : rec := (x := 1, y := 2); f : fb; a : ARRAY[1..3] OF rec := [3((x := 1))]; i : INT; END_VAR
r.x := 1; f(r := r); i := f.q + r.x; a[1].x := 3;
END_PROGRAM", &["2 P2020"]),
    ("scl", "FUNCTION_BLOCK FB10
TITLE 'mixing, once more'
VERSION : '1.0'
VAR_INPUT a : INT; END_VAR
VAR_TEMP c : INT; END_VAR
BEGIN
c := a * 2;
END_FUNCTION_BLOCK
FUNCTION FC1 : INT
TITLE Hello world, this is it
VAR_INPUT x : INT; END_VAR
BEGIN
FC1 := x;
END_FUNCTION", &["2 P2014", "10 P2014"]),
    ("iec", "NAMESPACE
FUNCTION_BLOCK Valve VAR_INPUT open : BOOL; END_VAR END_FUNCTION_BLOCK
TYPE State : (a, b); END_TYPE
END_NAMESPACE
PROGRAM main
VAR v : Plant.Valve; s : Plant.State; END_VAR
v(open := TRUE); s := Plant.State#a;
END_PROGRAM", &["1 P2010"]),
    ("codesys", "FUNCTION_BLOCK T
VAR v : INT; END_VAR
PROPERTY p : INT
  p := v;
END_GET
SET v := p; END_SET
END_PROPERTY
END_FUNCTION_BLOCK
PROGRAM main
VAR t1 : T; i : INT; END_VAR
t1.p := 3; i := t1.p;
END_PROGRAM", &["4 P6056"]),
    ("iec", "TYPE Telegram : OVERLAP
  whole AT %D0 : DWORD;
  head AT %W0 : WORD;
END_STRUCT; END_TYPE
PROGRAM main VAR t1 : Telegram; END_VAR t1.whole := 16#1; t1.head := 16#2; END_PROGRAM", &["1 P2020"]),
    ("iec", "INTERFACE I METHOD m END_METHOD END_INTERFACE
CLASS Shape ABSTRACT IMPLEMENTS I
METHOD PUBLIC ABSTRACT m END_METHOD
END_CLASS", &["2 P2010"]),
    // A method without a result on one line.
    ("iec", "FUNCTION_BLOCK Acc
VAR s : INT; END_VAR
METHOD PUBLIC Reset s := 0; END_METHOD
METHOD PUBLIC Add THIS.Reset(); END_METHOD
END_FUNCTION_BLOCK", &[]),
    // The names of types in namespaces.
    ("iec", "NAMESPACE Plant
TYPE State : (a, b); END_TYPE
END_NAMESPACE
PROGRAM main
VAR s : Plant.State := Plant.State#b; i : INT; END_VAR
IF s = Plant.State#b THEN s := Plant.State#a; END_IF;
CASE s OF Plant.State#a: i := 1; Plant.State#b: i := 2; END_CASE;
END_PROGRAM", &[]),
];

/// Tokens that are lost in a declaration: what stands behind them is read.
#[rustfmt::skip] // A table.
const LOST: &[Row] = &[
    ("codesys", "FUNCTION f : INT
VAR_INPUT p : POINTER ARRAY[0..9] OF INT; r : REFERENCE INT; q : ARRAY[1..2] OF POINTER INT; END_VAR
f := p^[1] + r + q[1]^;
END_FUNCTION", &["2 P2020", "2 P2020", "2 P2020"]),
    ("codesys", "TYPE e : (off := 1, manual :=, auto := 3); END_TYPE
PROGRAM main
VAR m : e; END_VAR
IF m = off OR m = manual THEN m := auto; END_IF
END_PROGRAM", &["1 P2020"]),
    ("scl", "FUNCTION FC1 : INT
LABEL , there; END_LABEL
VAR_INPUT a : INT; END_VAR
BEGIN
IF a > 0 THEN GOTO there; END_IF;
FC1 := 1;
there: FC1 := 2;
END_FUNCTION", &["2 P2020"]),
    ("scl", "FUNCTION_BLOCK FB1
VAR a : INT; : STRUCT x, y : INT; END_STRUCT; b : [1..3] OF INT; END_VAR
VAR_TEMP i : INT; END_VAR
BEGIN
a := b[1] + i;
END_FUNCTION_BLOCK", &["2 P2020", "2 P2020"]),
    ("tia", "FUNCTION_BLOCK \"x\"
VAR a : INT; idle : INT := 0; run : INT := 1; END_VAR
BEGIN
CASE #a OF
  #idle: #a := 1;
  #run, #idle: #a := 2;
END_CASE;
END_FUNCTION_BLOCK", &["5 P6229"]),
];

fn errors(dialect: &str, text: &str) -> Vec<String> {
    let mut sources = Sources::default();
    sources.add("program.st", text);
    let dialect = Dialect::from_name(dialect);
    let compiled = compile(&sources, &SymbolTable::default(), &Options { dialect, ..Options::default() });
    let errors = compiled.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error);
    let line = |start: u32| text[..start as usize].matches('\n').count() + 1;
    // Whether there is an OB 1 is not what the rows are about.
    let errors = errors.filter(|found| found.problem.code() != "P3013");
    errors.map(|found| format!("{} {}", line(found.span.start), found.problem.code())).collect()
}

fn check(rows: &[Row]) {
    for (dialect, text, expected) in rows {
        assert_eq!(&errors(dialect, text), expected, "{dialect}\n{text}");
    }
}

#[test]
fn of_a_name_that_is_declared_twice_only_that_is_said() {
    check(TWICE);
}

#[test]
fn of_a_declaration_that_cannot_be_read_only_that_is_said() {
    check(UNREAD);
}

#[test]
fn behind_a_lost_token_of_a_declaration_all_is_read() {
    check(LOST);
}
