//! Diagrams on one line.

use sieben_lang::network::flavour::{Drawing, Flavour};
use sieben_lang::network::form_b::{parse, print};
use sieben_lang::network::mistake::Mistake;
use sieben_lang::network::write::write;

use crate::statements::all_shown;

/// A line, how the other drawing writes it, and its statements.
const LINES: &[(&str, &str, &str)] = &[
    (
        "I 0.0 ! (I 0.1 | I 0.2) -> = Q 4.0",
        "I 0.0 ! -> and(., or(I 0.1, I 0.2)) -> = Q 4.0",
        "A I 0.0; NOT; A(; O I 0.1; O I 0.2; ); = Q 4.0",
    ),
    ("I 0.0 !(I 0.1 | I 0.2) -> = Q 4.0", "and(I 0.0, !or(I 0.1, I 0.2)) -> = Q 4.0", "A I 0.0; AN(; O I 0.1; O I 0.2; ); = Q 4.0"),
    (
        "DB 10.DBX 0.0 \"A\".b[1, 2] #x -> S \"a b\"",
        "and(DB 10.DBX 0.0, \"A\".b[1, 2], #x) -> S \"a b\"",
        "A DB 10.DBX 0.0; A \"A\".b[1, 2]; A #x; S \"a b\"",
    ),
    (
        "I 0.0 { -> = Q 4.0 ; -> SD T 5 S5T#2S }",
        "I 0.0 { -> = Q 4.0 ; -> SD T 5 S5T#2S }",
        "A I 0.0; = L 6.0; A L 6.0; BLD 102; = Q 4.0; A L 6.0; BLD 102; L S5T#2S; SD T 5",
    ),
    (
        "I 0.0 { I 0.2 SR[M 0.0](R := I 0.1) }",
        "I 0.0 { SR[M 0.0](S := and(., I 0.2), R := I 0.1) }",
        "A I 0.0; = L 6.0; A L 6.0; A I 0.2; S M 0.0; A I 0.1; R M 0.0; NOP 0",
    ),
    (
        "I 0.0 { (. | I 0.1) -> = Q 4.1 ; I 0.1 P(M 1.1) MOVE(1 => MW 0) }",
        "I 0.0 { or(., I 0.1) -> = Q 4.1 ; P(and(., I 0.1), M 1.1) -> MOVE(1 => MW 0) }",
        "A I 0.0; = L 6.0; O L 6.0; O I 0.1; = Q 4.1; A L 6.0; A I 0.1; FP M 1.1; JNB _001; L 1; T MW 0; _001: NOP 0",
    ),
    (
        "|- CALL FB 3, DB 6(IN := I 0.0, SPEED := MW 10, OUT => Q 4.0, B := \"x\")",
        "|- CALL FB 3, DB 6(IN := I 0.0, SPEED := MW 10, OUT => Q 4.0, B := \"x\")",
        "A I 0.0; = L 6.0; BLD 103; CALL FB 3, DB 6 ( IN := L 6.0, SPEED := MW 10, OUT := Q 4.0, B := \"x\" ); NOP 0",
    ),
    ("|- MOVE(\"Level\" => MW 0)", "|- MOVE(\"Level\" => MW 0)", "L \"Level\"; T MW 0; NOP 0"),
    (
        "I 0.0 S_CU[C 1](S := I 0.1, PV := 3)",
        "S_CU[C 1](CU := I 0.0, S := I 0.1, PV := 3)",
        "A I 0.0; CU C 1; BLD 101; A I 0.1; L 3; S C 1; NOP 0; NOP 0; NOP 0; NOP 0",
    ),
    ("|- MOVE(P#M 0.0 BYTE 4 => MD 0)", "|- MOVE(P#M 0.0 BYTE 4 => MD 0)", "L P#M 0.0 BYTE 4; T MD 0; NOP 0"),
    (
        "((I 0.0 I 0.1) | (I 0.2 I 0.3) | I 0.4 I 0.5) -> = Q 4.0, SAVE",
        "or((and(I 0.0, I 0.1)), (and(I 0.2, I 0.3)), and(I 0.4, I 0.5)) -> = Q 4.0, SAVE",
        "O(; A I 0.0; A I 0.1; ); O(; A I 0.2; A I 0.3; ); O; A I 0.4; A I 0.5; = Q 4.0; SAVE",
    ),
    ("LABEL m1: |- JMP m2", "LABEL m1: |- JMP m2", "m1: JU m2"),
];

#[test]
fn a_line_is_read_and_written_in_both_drawings_and_stands_for_statements() {
    for (lad, fbd, statements) in LINES {
        for (line, drawing) in [(lad, Drawing::Lad), (fbd, Drawing::Fbd)] {
            let network = parse(line, 0, Flavour::S7).unwrap_or_else(|wrong| panic!("{line}: {wrong:?}"));
            assert_eq!(&print(&network, drawing), line);
            assert_eq!(&print(&network, Drawing::Lad), lad, "{line}");
            assert_eq!(&all_shown(&write(&network, 48, &mut 0).statements), statements, "{line}");
        }
    }
}

const IEC: &[&str] = &[
    "a TON[t1](IN := ., PT := T#5s, Q => .) -> = x",
    "|- ADD(a, b, 5 => x)",
    "|- DIV(x, y => z, ENO => e)",
    "|- DIV(IN1 := x, IN2 := y, OUT => z, ENO => e)",
    "|- MOVE(TRUE => p)",
    "|- MOVE(a, => p)",
    "[BR] /[OV] -> = x",
    "|- MOVE(/a => p)",
    "|- MOVE(a.b => p)",
    "a /b POS(c) NEG(d) -> / x, P y, N z",
    "|- -> = lamp",
    "|- CTU[c](CU := a, R := /b, PV := 5, Q => q, CV => n)",
    "a -> RET",
    "|- RETURN",
    "a lib.Mixer[m1](START := (b | c) d, SPEED := /(e f), MODE := Mode#Fast) -> S x",
];

#[test]
fn boxes_of_iec_are_read_and_written() {
    for line in IEC {
        let network = parse(line, 0, Flavour::Iec).unwrap_or_else(|wrong| panic!("{line}: {wrong:?}"));
        assert_eq!(&print(&network, Drawing::Lad), line);
    }
}

/// A line, the byte where it is wrong, and what is expected there.
const WRONG: &[(&str, usize, &str)] = &[
    ("-> = Q 4.0", 3, "a coil needs logic before it"),
    ("I 0.0", 0, "this rung has no output"),
    ("I 0.0 BLINK(1 => MW 0)", 6, "there is no box `BLINK`"),
    ("I 0.0 MOVE(MW 0)", 6, "`OUT` of `MOVE` is not wired"),
    ("I 0.0 ADD_I(MW 0 => MW 2)", 6, "`IN2` of `ADD_I` is not wired"),
    ("I 0.0 SR(M 0.0)", 6, "`SR` needs its operand in square brackets"),
    ("I 0.0 S_ODT[T 5](R := I 0.1) -> = Q 4.0", 6, "`TV`, the time, of `S_ODT` is not wired"),
    ("I 0.0 S_ODT[T 5](TV := S5T#2S, X := I 0.1)", 31, "a pin of `S_ODT` is expected here"),
    ("I 0.0 (I 0.1 | I 0.2 -> = Q 4.0", 24, "an output stands inside of a bracket"),
    ("I 0.0 ( -> = Q 4.0", 8, "an operand is missing here"),
    ("I 0.0 -> = Q 4.0 )", 17, "`)` closes nothing"),
    ("I 0.0) -> = Q 4.0", 5, "`)` closes nothing"),
    ("(I 0.0 | ) -> = Q 4.0", 9, "an element is expected before `)`"),
    ("(I 0.0 | I 0.1] -> = Q 4.0", 14, "`(` is closed by `]`"),
    ("(I 0.0 | ] -> = Q 4.0", 9, "`(` is closed by `]`"),
    ("I 0.0 -> = Q 4.0 I 0.1", 17, "the network ends before this"),
    ("I 0.0 -> Q 4.0", 9, "the sign of the output is missing"),
    ("I 0.0 { -> Q 4.0 ; -> = Q 4.1 }", 11, "the sign of the output is missing"),
    ("I 0.0 = Q 4.0", 6, "`->` is missing before this output"),
    ("I 0.0 S Q 4.0", 6, "`->` is missing before this output"),
    ("I 0.0 SAVE", 6, "`->` is missing before this output"),
    ("I 0.0 | I 0.1 -> = Q 4.0", 6, "the branches that `|` divides stand in no bracket"),
    ("I 0.0 & I 0.1 -> = Q 4.0", 6, "`&` is no sign of this form"),
    ("I 0.0&I 0.1 -> = Q 4.0", 5, "`&` is no sign of this form"),
    ("I 0.0 -> = Q 4.0;", 16, "`;` divides the branches of a T-branch"),
    ("I 0.0 { -> = Q 4.0 ; }", 21, "this branch of the T-branch is empty"),
    ("I 0.0 { ; -> = Q 4.0 }", 8, "this branch of the T-branch is empty"),
    ("(I 0.0 | ", 9, "the line ends inside of `(`"),
    ("P(M 0.0) -> = Q 4.0", 0, "this acts on the line to its left, and there is none"),
    (". I 0.0 -> = Q 4.0", 0, "`.` stands for the line that a T-branch taps"),
    ("I 0.0 -> JMP m1, = Q 4.0", 9, "nothing may follow this coil"),
    ("I 0.0 { -> = Q 4.0", 18, "`;` or `}` is expected after a branch"),
    ("\"Start -> = Q 4.0", 0, "the closing `\"` of this name is missing"),
    ("I 0.0 [MW 0 = MW 2] -> = Q 4.0", 12, "a comparison is expected here"),
    ("I 0.0 CALL FC 1(IN := I 0.0, IN := I 0.1)", 6, "`IN` is wired twice"),
    ("I 0.0 ADD(1, 2 => MW 0)", 6, "there is no box `ADD`"),
];

#[test]
fn what_is_no_diagram_is_said_with_its_place() {
    for (line, at, message) in WRONG {
        let Err(wrong) = parse(line, 100, Flavour::S7) else { panic!("{line} is read") };
        assert_eq!(wrong.start, at + 100, "{line}: {wrong:?}");
        assert!(wrong.message.starts_with(message), "{line}: {wrong:?}");
        assert!(!wrong.message.contains("; "), "what to do is help: {wrong:?}");
    }
}

#[test]
fn a_sign_that_is_missing_is_said_in_iec_too() {
    for (line, at, message) in [
        ("a -> c", 5, "the sign of the output is missing"),
        ("a S c", 2, "`->` is missing before this output"),
        ("a & b -> = c", 2, "`&` is no sign of this form"),
    ] {
        let Err(wrong) = parse(line, 0, Flavour::Iec) else { panic!("{line} is read") };
        assert_eq!(wrong.start, at, "{line}: {wrong:?}");
        assert!(wrong.message.starts_with(message) && wrong.help.is_some(), "{line}: {wrong:?}");
    }
}

#[test]
fn deep_and_long_lines_are_answered() {
    let deep = "(".repeat(100_000);
    let Err(Mistake { start: at, message, .. }) = parse(&deep, 0, Flavour::S7) else { panic!("100,000 brackets are read") };
    assert!(at < 100 && message.contains("brackets nest deeper"), "{at}: {message}");
    for open in ["{", "/", "!(", "and(", "x SR[M 0.0](R := ", "I 0.0 {"] {
        assert!(parse(&open.repeat(10_000), 0, Flavour::S7).is_err(), "{open}");
    }
    let long = "I 0.0 ".repeat(10_000) + "-> = Q 4.0";
    assert!(parse(&long, 0, Flavour::S7).is_err_and(|mistake| mistake.message.contains("at most")));
    let boxes = "I 0.0 ".to_owned() + &"MOVE(1 => MW 0) ".repeat(8_000);
    let Err(wrong) = parse(&boxes, 0, Flavour::S7) else { panic!("8,000 boxes in a row need as many brackets") };
    assert!(wrong.message.contains("more than 7 brackets"), "{wrong:?}");
}
