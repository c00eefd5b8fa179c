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

/// What a dialect does not have, although other tools take it.
#[rustfmt::skip] // A table.
const NOT_THERE: &[Row] = &[
    // A body in another language is one message.
    ("iec", "PROGRAM main
VAR x : INT; END_VAR
LD x
ADD 3
ST x
END_PROGRAM", &["3 P6331"]),
    ("iec", "PROGRAM main
VAR x : INT; b : BOOL; END_VAR
again: LD x
AND( b
OR x
)
JMPC again
END_PROGRAM", &["3 P6331"]),
    ("codesys", "FUNCTION_BLOCK seq
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT a : BOOL; END_VAR
INITIAL_STEP S0:
END_STEP
TRANSITION FROM S0 TO S1
 := go;
END_TRANSITION
STEP S1:
 a(N);
END_STEP
END_FUNCTION_BLOCK
PROGRAM main
VAR s : seq; b : BOOL; END_VAR
s(go := TRUE, a => b);
END_PROGRAM", &["4 P6331"]),
    // A PROGRAM is called in codesys only, and has instances of a CONFIGURATION only.
    ("iec", "PROGRAM main
sub(x := 1);
END_PROGRAM
PROGRAM sub VAR_INPUT x : INT; END_VAR x := x; END_PROGRAM", &["2 P6050", "4 P6050"]),
    ("iec", "PROGRAM p VAR n : INT; END_VAR n := n + 1; END_PROGRAM
PROGRAM main
VAR i : p; END_VAR
i();
END_PROGRAM", &["3 P3015"]),
    ("codesys", "PROGRAM p VAR n : INT; END_VAR n := n + 1; END_PROGRAM
PROGRAM main
VAR i : p; END_VAR
i();
END_PROGRAM", &["3 P3015"]),
    // An instance that does not last.
    ("iec", "FUNCTION f : INT
VAR t : TON; END_VAR
t(IN := TRUE, PT := T#1s);
f := 1;
END_FUNCTION", &["2 P6132"]),
    // What the grammar excludes.
    ("iec", "FUNCTION_BLOCK ABSTRACT FINAL a
END_FUNCTION_BLOCK
FUNCTION_BLOCK ABSTRACT b
METHOD PUBLIC ABSTRACT FINAL m
END_METHOD
END_FUNCTION_BLOCK", &["1 P6283", "4 P6283"]),
    ("iec", "PROGRAM a
VAR CONSTANT t : TON; END_VAR
t(IN := TRUE, PT := T#0s);
END_PROGRAM", &["3 P6204"]),
    ("iec", "TYPE INT : DINT; END_TYPE
TYPE LREAL : REAL; END_TYPE
PROGRAM a
VAR x : INT; END_VAR
x := 1;
END_PROGRAM", &["1 P6060", "2 P6060"]),
    ("iec", "PROGRAM p VAR x : INT; END_VAR x := 1; END_PROGRAM
CONFIGURATION c RESOURCE r ON PLC PROGRAM a : p; END_RESOURCE END_CONFIGURATION
CONFIGURATION c RESOURCE s ON PLC PROGRAM b : p; END_RESOURCE END_CONFIGURATION", &["3 P3006"]),
    // The access that an interface asks for.
    ("codesys", "INTERFACE im
METHOD INTERNAL set_state : BOOL
END_METHOD
METHOD go
END_METHOD
END_INTERFACE
FUNCTION_BLOCK m IMPLEMENTS im
METHOD INTERNAL set_state : BOOL
END_METHOD
METHOD INTERNAL go
END_METHOD
END_FUNCTION_BLOCK", &["10 P6283"]),
    // Arguments for another number of elements.
    ("codesys", "FUNCTION_BLOCK f
VAR k : INT; END_VAR
METHOD FB_init : BOOL
VAR_INPUT bInitRetains : BOOL; bInCopyCode : BOOL; n : INT; END_VAR
k := n;
END_METHOD
END_FUNCTION_BLOCK
PROGRAM main
VAR a : ARRAY[1..3] OF f[(n := 4), (n := 7)]; x : INT; END_VAR
x := a[2].k;
END_PROGRAM", &["9 P6327"]),
    // Arguments that are too many, have no input, or are left out for arrays of arrays.
    ("codesys", "FUNCTION_BLOCK f
VAR k : INT; END_VAR
METHOD FB_init : BOOL
VAR_INPUT bInitRetains : BOOL; bInCopyCode : BOOL; n : INT; END_VAR
k := n;
END_METHOD
END_FUNCTION_BLOCK
PROGRAM main
VAR
  a : f(1, 2);
  b : f(x := 3);
  c : ARRAY[1..2] OF ARRAY[1..2] OF f;
  d : ARRAY[1..2] OF ARRAY[1..2] OF f[(1), (2)];
  x : INT;
END_VAR
x := b.k;
END_PROGRAM", &["10 P6327", "11 P6327", "12 P3010", "13 P6327"]),
    // An input of the function does not last, and a constant of it does.
    ("codesys", "FUNCTION_BLOCK f
VAR k : INT; END_VAR
METHOD FB_init : BOOL
VAR_INPUT bInitRetains : BOOL; bInCopyCode : BOOL; n : INT; END_VAR
k := n;
END_METHOD
END_FUNCTION_BLOCK
FUNCTION g : INT
VAR_INPUT v : INT; END_VAR
VAR CONSTANT c : INT := 4; END_VAR
VAR a : f(v); b : f(c); END_VAR
g := a.k + b.k;
END_FUNCTION", &["11 P6327"]),
    // What has the size of itself.
    ("codesys", "PROGRAM main
VAR a : ARRAY[0..SIZEOF(a)] OF BYTE; END_VAR
a[0] := 1;
END_PROGRAM", &["2 P3016"]),
    ("codesys", "FUNCTION_BLOCK l
VAR
  a : ARRAY[1..SIZEOF(m)] OF BYTE;
  m : m2;
END_VAR
END_FUNCTION_BLOCK
FUNCTION_BLOCK m2
VAR a : ARRAY[1..SIZEOF(l)] OF BYTE; END_VAR
END_FUNCTION_BLOCK", &["4 P3016"]),
    // A constant of another block, in a declaration as in a statement.
    ("iec", "FUNCTION_BLOCK p
VAR CONSTANT n : INT := 3; END_VAR
END_FUNCTION_BLOCK
FUNCTION_BLOCK q
VAR a : ARRAY[1..p.n] OF INT; x : INT; END_VAR
x := p.n;
END_FUNCTION_BLOCK", &["5 P6050", "6 P6050"]),
    // A REFERENCE TO and nothing else is asked for.
    ("codesys", "PROGRAM main
VAR x : INT; b : BOOL; END_VAR
b := __ISVALIDREF(x);
END_PROGRAM", &["3 P4011"]),
];

/// Line, code and help of each error.
fn errors_with_help(dialect: &str, text: &str) -> Vec<(String, String)> {
    let mut sources = Sources::default();
    sources.add("program.st", text);
    let dialect = Dialect::from_name(dialect);
    let compiled = compile(&sources, &SymbolTable::default(), &Options { dialect, ..Options::default() });
    let errors = compiled.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error);
    let line = |start: u32| text[..start as usize].matches('\n').count() + 1;
    // Whether there is an OB 1 is not what the rows are about.
    let errors = errors.filter(|found| found.problem.code() != "P3013");
    let row = |place: String, help: &Option<String>| (place, help.clone().unwrap_or_default());
    errors.map(|found| row(format!("{} {}", line(found.span.start), found.problem.code()), &found.help)).collect()
}

fn errors(dialect: &str, text: &str) -> Vec<String> {
    errors_with_help(dialect, text).into_iter().map(|(error, _)| error).collect()
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

#[test]
fn of_what_a_dialect_does_not_have_only_that_is_said() {
    check(NOT_THERE);
}

/// A block, functions whose results hold instances of it, and one that works on what it is given.
const MADE: &str = "FUNCTION_BLOCK A
VAR_INPUT n : INT; END_VAR
METHOD Get : INT
Get := n;
END_METHOD
END_FUNCTION_BLOCK
TYPE S : STRUCT a : A; END_STRUCT END_TYPE
FUNCTION Make : A VAR a : A; END_VAR Make := a; END_FUNCTION
FUNCTION Whole : S VAR s : S; END_VAR Whole := s; END_FUNCTION
FUNCTION Get : INT VAR_INPUT x : A; END_VAR Get := x.Get(); END_FUNCTION
FUNCTION GetOf : INT VAR_INPUT s : S; END_VAR GetOf := s.a.Get(); END_FUNCTION
FUNCTION See : INT VAR_IN_OUT CONSTANT x : A; END_VAR See := x.n; END_FUNCTION
";

#[test]
fn an_instance_in_a_result_is_called_in_a_variable() {
    let of = |rest: &str| errors("codesys", &format!("{MADE}{rest}"));
    let main = "PROGRAM main VAR z : INT; a : A; s : S; END_VAR\n";
    let calls = "z := Get(Make());\nz := GetOf(Whole());\nz := See(Make());\n";
    assert_eq!(of(&format!("{main}{calls}END_PROGRAM")), ["14 P4011", "15 P4011", "16 P4011"]);
    let calls = "a := Make(); s := Whole(); z := Get(a) + GetOf(s) + See(a);";
    assert_eq!(of(&format!("{main}{calls} END_PROGRAM")), [""; 0]);
    let own = "FUNCTION Own : A VAR z : INT; END_VAR\nz := Own.Get();\nOwn.n := z;\nEND_FUNCTION
FUNCTION Part : S VAR z : INT; END_VAR\nPart.a();\nEND_FUNCTION";
    assert_eq!(of(own), ["14 P6217", "18 P6217"]);
}

#[test]
fn what_is_only_read_is_not_called() {
    let text = "FUNCTION_BLOCK G
VAR_INPUT k : INT; END_VAR
METHOD Get : INT
Get := k;
END_METHOD
END_FUNCTION_BLOCK
FUNCTION_BLOCK B
VAR_IN_OUT CONSTANT c : G; END_VAR
VAR n : INT; END_VAR
c(k := 9);
n := c.Get();
END_FUNCTION_BLOCK";
    assert_eq!(errors("codesys", text), ["10 P6204"]);
}

#[test]
fn a_negative_number_is_no_value_that_a_type_without_a_sign_counts_to() {
    let text = "PROGRAM main
VAR k : UINT; s : USINT; b : BYTE; x : INT; END_VAR
FOR k := 10 TO 1 BY -1 DO x := x + 1; END_FOR;
FOR s := 3 TO -1 DO x := x + 1; END_FOR;
FOR b := -3 TO 1 DO x := x + 1; END_FOR;
CASE s OF
-1: x := 2;
-100..100: x := 3;
END_CASE;
k := -1;
END_PROGRAM";
    assert_eq!(errors("codesys", text), ["3 P4001", "4 P4001", "5 P4001", "7 P4001", "8 P4001"]);
}

#[test]
fn an_address_and_a_shorter_number_do_not_meet() {
    let text = "PROGRAM main
VAR p : POINTER TO BYTE; d : DWORD; n : DINT; b : BOOL; END_VAR
d := p;
p := d;
b := p = d;
d := ADR(b);
p := n;
END_PROGRAM";
    let found = errors_with_help("codesys", text);
    let places: Vec<&str> = found.iter().map(|(place, _)| place.as_str()).collect();
    assert_eq!(places, ["3 P6200", "4 P6200", "5 P6202", "6 P6200", "7 P6200"]);
    assert!(found.iter().all(|(_, help)| help.contains("LWORD")), "{found:?}");
}

#[test]
fn a_program_with_several_instances_is_called_a_program() {
    let text = "PROGRAM sub
VAR n : INT; END_VAR
n := n + 1;
END_PROGRAM
PROGRAM main
sub();
END_PROGRAM
CONFIGURATION c RESOURCE r ON PLC
TASK t(INTERVAL := T#10ms, PRIORITY := 1);
PROGRAM a WITH t : sub; PROGRAM b WITH t : sub; PROGRAM m WITH t : main;
END_RESOURCE END_CONFIGURATION";
    let found = errors_with_help("codesys", text);
    let [(place, help)] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!(place, "6 P6217");
    assert!(help.contains("FUNCTION_BLOCK sub"), "{help}");
}

#[test]
fn a_call_without_brackets_is_told_to_have_some() {
    let text = "PROGRAM sub
VAR n : INT; END_VAR
n := n + 1;
END_PROGRAM
PROGRAM main
sub;
END_PROGRAM";
    let mut sources = Sources::default();
    sources.add("program.st", text);
    let dialect = Dialect::from_name("codesys");
    let compiled = compile(&sources, &SymbolTable::default(), &Options { dialect, ..Options::default() });
    let found: Vec<_> = compiled.diagnostics.iter().filter(|found| found.problem.code() == "P6051").collect();
    assert!(matches!(found.as_slice(), [one] if one.help.as_deref().is_some_and(|help| help.contains("`()`"))), "{found:?}");
}
