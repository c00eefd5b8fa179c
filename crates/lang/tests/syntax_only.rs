//! `check --syntax-only`: one file alone is not blamed for what another one may define, and is told of its own mistakes.

use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Options, compile};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// A file that names what only other files can have, and a change that makes a mistake of its own.
struct Case {
    what: &'static str,
    /// `None` = STL.
    dialect: Option<Dialect>,
    text: &'static str,
    /// What is written instead of what, and the code of what comes of it.
    mistake: (&'static str, &'static str, &'static str),
}

const CASES: &[Case] = &[
    Case {
        what: "functions of the library",
        dialect: Some(Dialect::Iec),
        text: r##"FUNCTION Cut : STRING
VAR_INPUT s : STRING; END_VAR
  Cut := LEFT(s, FIND(s, ' ') - 1);
  Cut := CONCAT(s, INT_TO_STRING(3));
END_FUNCTION
"##,
        mistake: ("  Cut := CONCAT(s, INT_TO_STRING(3));", "  Cut := CONCAT(s, LEFT(s, s));", "P6200"),
    },
    Case {
        what: "bases, interfaces, lists and enumerations",
        dialect: Some(Dialect::Codesys),
        text: r##"FUNCTION_BLOCK F EXTENDS Base IMPLEMENTS IThing
VAR a : ARRAY[1..GVL.MAXN] OF INT; s : STRING(TEXT_LEN); r : REAL; e : E_Mode := E_Mode.Off; c : Cfg := (x := 1, y := Other.K); END_VAR
r := MATH.PI;
a[3] := inherited + 1;
inheritedFb(IN := TRUE);
IF inheritedFb.Q THEN s := 'x'; END_IF
SUPER^();
SUPER^.Run(a := 1);
THIS^.what := 3;
THIS^.DoIt();
Helper(1, 2);
CASE e OF
  E_Mode.Off: r := 1.0;
  E_Mode.On, E_Mode.Both: r := 2.0;
  SOME_CONST: r := 3.0;
  LOW..HIGH: r := 4.0;
END_CASE
c.z := c.y + GVL.other[3].name;
PRG.run();
PRG.x := 3;
Act1();
METHOD PUBLIC OVERRIDE M : Result
VAR_INPUT p : REFERENCE TO Thing; q : POINTER TO Thing; i : IThing; END_VAR
M := p.x;
M := q^.x;
i.Do(a := 3);
M.field := 1;
IF __QUERYINTERFACE(i, other) THEN RETURN; END_IF
p REF= GVL.thing;
END_METHOD
END_FUNCTION_BLOCK
"##,
        mistake: ("Helper(1, 2);", "Helper(1, 2); r := 'x';", "P6200"),
    },
    Case {
        what: "types of properties and methods",
        dialect: Some(Dialect::Codesys),
        text: r##"FUNCTION_BLOCK Robot
VAR task : TaskImpl; END_VAR
PROPERTY TheTask : ITask
GET
TheTask := task;
END_GET
END_PROPERTY
PROPERTY Ref : REFERENCE TO Other
GET
Ref REF= task;
END_GET
END_PROPERTY
PROPERTY Both : Other
GET
Both := task.both;
END_GET
SET
task.both := Both;
END_SET
END_PROPERTY
METHOD Get : REFERENCE TO Other
Get REF= task;
END_METHOD
METHOD Use : BOOL
Both := task.b;
Use := Both.ready;
Ref.x := 1;
THIS^.Both := task.b;
END_METHOD
END_FUNCTION_BLOCK
"##,
        mistake: ("Use := Both.ready;", "Use := 3.5;", "P6200"),
    },
    Case {
        what: "types of types",
        dialect: Some(Dialect::Codesys),
        text: r##"TYPE T_Axis EXTENDS T_Base :
STRUCT
  n : ARRAY[0..MAX_AXES - 1] OF LREAL := [MAX_AXES(0)];
  s : STRING(GVL.LEN);
  u : UINT(LOW..HIGH);
  p : POINTER TO T_Other;
  m : E_State := E_State.Idle;
END_STRUCT
END_TYPE
TYPE E_A : (One := FIRST, Two, Three := FIRST + 5); END_TYPE
TYPE A : T_Other; END_TYPE
"##,
        mistake: ("  m : E_State := E_State.Idle;", "  m : E_State := E_State.Idle;\n  q : INT := 'x';", "P4006"),
    },
    Case {
        what: "constants and global variables",
        dialect: Some(Dialect::Codesys),
        text: r##"VAR_GLOBAL CONSTANT
  A : INT := B + 1;
  C : REAL := Lib.K * 2;
END_VAR
VAR_GLOBAL
  x : ARRAY[1..A] OF Thing;
  f : FB_Thing(n := 3);
  y AT %I* : BOOL;
END_VAR
"##,
        mistake: ("  f : FB_Thing(n := 3);", "  f : FB_Thing(n := 3);\n  q : INT := TRUE;", "P4006"),
    },
    Case {
        what: "programs, instances and bits",
        dialect: Some(Dialect::Codesys),
        text: r##"PROGRAM P
VAR_EXTERNAL g : INT; END_VAR
VAR x : T_Axis; t : TON; fb : FB_Other; w : WORD; a AT %I* : INT; ref : REFERENCE TO Unknown; arr : ARRAY[0..5] OF FB_Other; END_VAR
x.n[3] := g;
fb(a := 1, b => w);
fb.Start(1);
w.ALARM_BIT := TRUE;
arr[2](q := 1);
arr[w].x := SEL(x.b, 1, 2);
w := SIZEOF(x);
w := MAX(fb.n, 3);
FOR w := 1 TO N_MAX DO ref.x := w; END_FOR
P2();
w := F_Calc(a := x, b := fb);
w := TO_WORD(fb.n);
t(IN := fb.Q, PT := T_DELAY);
WHILE fb.busy AND NOT x.y DO EXIT; END_WHILE
w := LIMIT(LOW_, x.z, HIGH_);
END_PROGRAM
"##,
        mistake: ("P2();", "P2(); t(IM := TRUE);", "P3009"),
    },
    Case {
        what: "external variables, programs and tasks",
        dialect: Some(Dialect::Iec),
        text: r##"FUNCTION_BLOCK FB1X
VAR_EXTERNAL g : Thing; k : INT; END_VAR
VAR_EXTERNAL CONSTANT N : INT; END_VAR
VAR a : ARRAY[1..N] OF INT; c : Color := Red; d : Color := Color#Green; t : Timer7; r : REF_TO Thing; END_VAR
a[1] := k;
c := Color#Blue;
t(IN := g.x);
IF t.Q THEN r^.x := 1; END_IF;
CASE c OF Red: k := 1; Color#Blue: k := 2; END_CASE;
k := Foo(a[1]);
END_FUNCTION_BLOCK
CONFIGURATION C
VAR_GLOBAL gg : Thing; END_VAR
RESOURCE R ON PLC
TASK T(INTERVAL := T#10ms, PRIORITY := 1);
PROGRAM P1 WITH T : Main;
END_RESOURCE
VAR_CONFIG R.P1.x AT %IX0.0 : BOOL; END_VAR
END_CONFIGURATION
"##,
        mistake: ("k := Foo(a[1]);", "k := Foo(a[1]) k := 1;", "P6054"),
    },
    Case {
        what: "classes",
        dialect: Some(Dialect::Iec),
        text: r##"CLASS K EXTENDS Base IMPLEMENTS I1, I2
VAR PUBLIC x : INT; END_VAR
METHOD PUBLIC OVERRIDE m : INT
m := SUPER.m() + inherited;
THIS.other(1);
END_METHOD
END_CLASS
INTERFACE II EXTENDS Other
METHOD q : Thing END_METHOD
END_INTERFACE
"##,
        mistake: ("THIS.other(1);", "THIS.other(1); x := TRUE;", "P6200"),
    },
    Case {
        what: "blocks of SCL",
        dialect: Some(Dialect::Scl),
        text: r##"FUNCTION_BLOCK FB10
VAR_INPUT a : INT; END_VAR
VAR inst : FB20; u : UDT5; v : "MyUdt"; t : TON; END_VAR
VAR_TEMP s : STRING[20]; i : INT; END_VAR
BEGIN
inst(x := a, y := 3);
i := inst.z;
u.f := i;
v.g := "Motor" OR FALSE;
"DB_Data".x[3] := i;
DB10.DW2 := W#16#1;
DB10.D2.3 := TRUE;
FB20.DB30(x := 1);
i := FC5(p := i);
"Proc"(a := 1);
Proc2(a := 1);
s := CONCAT(IN1 := 'a', IN2 := 'b');
s := LEFT(IN := s, L := 2);
t(IN := "Start", PT := T#1s);
WORD_TO_BLOCK_DB(MW0).DW4 := W#16#2;
i := SYMBOL_BARE;
SFC20(SRCBLK := u, RET_VAL := i, DSTBLK := v);
END_FUNCTION_BLOCK
DATA_BLOCK DB11 UDT7 BEGIN x := 1; END_DATA_BLOCK
DATA_BLOCK DB12 FB99 BEGIN END_DATA_BLOCK
DATA_BLOCK DB13 "Type" BEGIN x[3].b := 1; END_DATA_BLOCK
ORGANIZATION_BLOCK "Cyclic" VAR_TEMP i : ARRAY[0..19] OF BYTE; END_VAR BEGIN FC1(); END_ORGANIZATION_BLOCK
"##,
        mistake: ("i := SYMBOL_BARE;", "i := SYMBOL_BARE; i := 'x';", "P6200"),
    },
    Case {
        what: "blocks of TIA",
        dialect: Some(Dialect::Tia),
        text: r##"FUNCTION_BLOCK "Motor"
VERSION : 0.1
VAR_INPUT cmd : Bool; cfg : "typeCfg"; END_VAR
VAR t {InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME; inst : "Other"; arr : Array[0.."MAX_N"] of Int; m : Array[0..#K] of "U"; END_VAR
VAR CONSTANT K : Int := 3; L : Int := "GLOBAL_K"; END_VAR
VAR_TEMP s : String; v : Int; END_VAR
BEGIN
#t(IN := #cmd AND "tagStart", PT := #cfg.delay);
#inst(a := 1, b => #v);
#v := #inst.c;
"DB".field[#v].x := #arr[1];
"IEC_Timer_0_DB".TON(IN := #cmd, PT := T#1s);
"MyInstDb"(x := 1);
#v := "MyFc"(a := 1);
"MyFc2"(b := #v);
#s := LEFT(IN := #s, L := 2);
#s := CONCAT(IN1 := #s, IN2 := 'x');
CASE #v OF "C_ONE": ; "C_TWO".."C_THREE": ; END_CASE;
FOR #v := 0 TO "MAX_N" DO #m[#v].q := 1; END_FOR;
%DB5.DBW2 := 16#3;
"Tag" := INT_TO_WORD(#v);
END_FUNCTION_BLOCK
DATA_BLOCK "Inst" "FB_Unknown" BEGIN a.b := 3; END_DATA_BLOCK
DATA_BLOCK "Inst2" STRUCT a : "typeX"; END_STRUCT; BEGIN a.b := 3; END_DATA_BLOCK
ORGANIZATION_BLOCK "Main Cycle" BEGIN "Motor_DB"(cmd := TRUE); END_ORGANIZATION_BLOCK
TYPE "u" VERSION : 0.1
STRUCT a : "v"; b : Array[1.."N"] of "w"; END_STRUCT; END_TYPE
"##,
        mistake: ("\"Tag\" := INT_TO_WORD(#v);", "\"Tag\" := INT_TO_WORD(#v); #nothing := 1;", "P3001"),
    },
    Case {
        what: "blocks of STL",
        dialect: None,
        text: r##"FUNCTION_BLOCK "Motor"
TITLE = x
VAR_INPUT a : INT; u : "typ"; w : UDT 7; END_VAR
VAR inst : FB 20; t : SFB 4; o : "Other"; END_VAR
VAR_TEMP x : INT; END_VAR
BEGIN
CALL #inst (p := #a);
CALL #o (p := #a);
CALL FC 99 (q := #a, RET_VAL := #x);
CALL "Foo" (q := #a);
CALL FB 44, DB 45 (z := 1);
CALL "FbX", "DbX" (z := 1);
CALL SFB 4, DB 46 (IN := TRUE);
CALL FC 2 (IN_A := #a, B := #a);
CALL "CONCAT" (A1 := #a);
U "Start";
U Bare;
= "DB".x.y[3];
L #u.f; T #x;
L DB10.DBW 4;
L "DB".DBW 4;
AUF DB 4;
AUF "Dx";
L #w.z;
L #inst.q;
UC FC 77;
CC "fcx";
END_FUNCTION_BLOCK
FUNCTION "F2" : VOID
VAR_TEMP k : "typ"; y : INT; END_VAR
BEGIN
CALL "Motor", "MotorDb" (a := 3);
CALL "Motor", DB 7 (a := 3);
L "MotorDb".a;
CALL FB 44 , DB 45 (z := 1);
END_FUNCTION
DATA_BLOCK "MotorDb" "Motor" BEGIN a := 3; END_DATA_BLOCK
DATA_BLOCK "D2" "Unknown" BEGIN a := 3; END_DATA_BLOCK
DATA_BLOCK DB 4 UDT 99 BEGIN END_DATA_BLOCK
DATA_BLOCK DB 5 STRUCT x : UDT 98; y : "typ"; END_STRUCT BEGIN x.a := 1; y.q := 2; END_DATA_BLOCK
ORGANIZATION_BLOCK "Cycle" VAR_TEMP b : ARRAY[0..19] OF BYTE; END_VAR BEGIN CALL "F2"; END_ORGANIZATION_BLOCK
TYPE "ty" STRUCT a : "v"; END_STRUCT END_TYPE
"##,
        mistake: ("U Bare;", "U Bare; L #nothing;", "P3001"),
    },
];

/// The codes and messages of a file that is looked at alone.
fn findings(dialect: Option<Dialect>, text: &str) -> Vec<String> {
    let mut sources = Sources::default();
    sources.add(if dialect.is_some() { "part.st" } else { "part.awl" }, text);
    let options = Options { syntax_only: true, dialect, mnemonics: Some(Mnemonics::German), ..Options::default() };
    let compiled = compile(&sources, &SymbolTable::default(), &options);
    compiled.diagnostics.iter().map(|one| format!("{} {}", one.problem.code(), one.message)).collect()
}

#[test]
fn one_file_alone_is_not_blamed_for_what_others_may_define() {
    for case in CASES {
        assert_eq!(findings(case.dialect, case.text), [""; 0], "{}", case.what);
    }
}

#[test]
fn one_file_alone_is_told_of_its_own_mistakes() {
    let mut failed = Vec::new();
    for case in CASES {
        let (right, wrong, code) = case.mistake;
        assert!(case.text.contains(right), "{}", case.what);
        let found = findings(case.dialect, &case.text.replace(right, wrong));
        if found.len() != 1 || !found[0].starts_with(code) {
            failed.push(format!("{}: {found:?}", case.what));
        }
    }
    assert_eq!(failed, [""; 0]);
}

#[test]
fn a_block_named_by_a_symbol_is_looked_at_without_the_symbol_table() {
    let found = findings(None, "FUNCTION \"F\" : VOID\nBEGIN\nL #nothing;\nEND_FUNCTION\nFUNCTION \"F\" : VOID\nBEGIN\nEND_FUNCTION\n");
    let codes: Vec<&str> = found.iter().map(|one| &one[..5]).collect();
    assert_eq!(codes, ["P3002", "P3001", "P3002"]);
}
