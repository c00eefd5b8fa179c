//! Form A: what is printed is parsed to the same, what is formatted stays, what is wrong is said.

use super::{format, parse, print};
use crate::network::flavour::{Drawing, Flavour};
use crate::network::model::{Content, Element, Kind};

/// Networks of STEP 7 in the usual layout.
const NETWORKS: &[&str] = &[
    "    OR\n        NO  \"Start\"\n    OR\n        NO  \"Pump\"\n    END\n    NC    \"Stop\"\n    MID   M 0.0\n    NC    M 0.1\n    COIL  \"Pump\"\n",
    "    CMP  >I MW 10, 100\n    BRANCH\n        NC  I 0.1\n        SUB_I MW 10, 100 => MW 12\n        MOVE MW 12 => QW 4\n        COIL  Q 4.1\n    BRANCH\n        SET  M 2.0\n    END\n",
    "    OR\n        NO  I 0.0\n    OR\n        NC  I 0.1\n        P   M 1.0\n    END\n    S_ODT T 5\n        TV := S5T#2S\n        R:\n            NO  I 0.7\n        BI => MW 20\n    COIL  Q 4.0\n",
    "    LABEL m001:\n    NO   I 0.0\n    JMP  m002\n",
    "    OPN  DB 10\n",
    "    NO  I 0.0\n    CALL FB 1, DB 1\n        START := I 0.1\n        STOP := /I 0.2\n        MODE:\n            OR\n                NO  I 0.3\n            OR\n                NO  I 0.4\n            END\n        N := MW 10\n        Q => M 0.0\n    COIL  Q 4.0\n",
    "    NO  I 0.1\n    S_CUD C 8\n        CD:\n            NO  I 0.2\n        S:\n            NO  I 0.0\n        PV := C#42\n        R:\n            NO  I 0.7\n        CV => QW 2\n    COIL  Q 0.0\n",
    "    NO   I 0.0\n    POS  I 0.1, M 1.0\n    NOT\n    BRANCH\n        SP  T 1, S5T#2S\n    BRANCH\n        SC  C 1, C#10\n    BRANCH\n        RESET  C 1\n    END\n",
    "    SHL_W IN := MW 10, N := MW 12 => MW 14\n",
];

#[test]
fn a_printed_network_is_the_same_again() {
    for text in NETWORKS {
        let parsed = parse(text, 0, text.len(), Flavour::S7);
        assert!(parsed.mistakes.is_empty(), "{text}{:?}", parsed.mistakes);
        assert_eq!(print(&parsed.network, Drawing::Lad, &|_, _| (Vec::new(), None)), **text);
        let fbd = print(&parsed.network, Drawing::Fbd, &|_, _| (Vec::new(), None));
        let again = parse(&fbd, 0, fbd.len(), Flavour::S7);
        assert_eq!(again.network, parsed.network, "{fbd}");
    }
}

#[test]
fn the_usual_layout_keeps_comments_and_what_belongs_together() {
    let text = "// the pump\nOR\nNO \"Start\"// field\nOR\n\tNO   \"Pump\"\nEND\n\nNC \"Stop\"\nCOIL   \"Pump\"\n// last\n";
    let parsed = parse(text, 0, text.len(), Flavour::S7);
    assert!(parsed.mistakes.is_empty(), "{:?}", parsed.mistakes);
    let once = format(text, 0, text.len(), &parsed);
    assert_eq!(
        once,
        "    // the pump\n    OR\n        NO  \"Start\"  // field\n    OR\n        NO  \"Pump\"\n    END\n\n    NC    \"Stop\"\n    COIL  \"Pump\"\n    // last\n"
    );
    let again = parse(&once, 0, once.len(), Flavour::S7);
    assert_eq!(again.network, parsed.network);
    assert_eq!(format(&once, 0, once.len(), &again), once);
}

#[test]
fn every_mistake_has_its_place_and_the_rest_is_read() {
    for (text, place, part) in [
        ("NO I 0.0\nFOO I 0.1\nCOIL Q 4.0\n", "FOO I 0.1", "`FOO` is no element of a diagram"),
        ("NO\nCOIL Q 4.0\n", "NO", "`NO` needs an operand"),
        ("NO I 0.0, I 0.1\nCOIL Q 4.0\n", "I 0.0, I 0.1", "has one operand"),
        ("OR\n    NO I 0.0\nOR\nEND\nCOIL Q 4.0\n", "OR", "short circuit"),
        ("OR\n    NO I 0.0\nCOIL Q 4.0\n", "OR", "no `END`"),
        ("NO I 0.0\nEND\nCOIL Q 4.0\n", "END", "closes nothing"),
        ("NO I 0.0\nCOIL Q 4.0\nNO I 0.1\n", "NO I 0.1", "after a coil"),
        ("CMP >X MW 0, 1\nCOIL Q 4.0\n", "CMP >X MW 0, 1", "no comparison"),
        ("CMP >I MW 0\nCOIL Q 4.0\n", "CMP >I MW 0", "two operands"),
        ("ADD_I MW 0, MW 2\n", "ADD_I MW 0, MW 2", "nothing is wired to OUT"),
        ("ADD_I MW 0, MW 2, MW 4 => MW 6\n", "MW 4 => MW 6", "has no pin `MW4`"),
        ("ADD_I\n    IN1 := MW 0\n    IN3 := MW 0\n", "IN3 := MW 0", "has no pin `IN3`"),
        ("ADD_I\n    IN1 := MW 0\n    IN1 := MW 0\n", "IN1 := MW 0", "wired twice"),
        ("NO I 0.0\nMOVE EN := I 0.0, IN := 1 => MW 0\n", "EN := I 0.0", "no pin `EN`"),
        ("NO I 0.0\nS_ODT T 1\nCOIL Q 0.0\n", "S_ODT T 1", "TV"),
        ("NO I 0.0\nSR M 0.0\n    R:\n    COIL Q 0.0\n", "R:", "nothing is wired"),
        ("NO I 0.0\nCALL FC 1\n    x :=\n", "x :=", "nothing is wired to `x`"),
        ("OPN DB 1\nNO I 0.0\n", "NO I 0.0", "stands alone"),
    ] {
        let parsed = parse(text, 0, text.len(), Flavour::S7);
        let found = parsed.mistakes.iter().find(|mistake| mistake.message.contains(part));
        let found = found.unwrap_or_else(|| panic!("{text}: {:?}", parsed.mistakes));
        assert_eq!(&text[found.start..found.end], place, "{text}");
    }
}

#[test]
fn what_is_too_large_or_too_deep_is_said_and_nothing_overflows() {
    let deep: String = (0..1000).map(|level| format!("{}OR\n", " ".repeat(level))).collect();
    let parsed = parse(&deep, 0, deep.len(), Flavour::S7);
    assert!(parsed.mistakes.iter().any(|mistake| mistake.message.contains("levels deep")), "{:?}", parsed.mistakes.first());
    let wide = "NO I 0.0\n".repeat(10_000);
    let parsed = parse(&wide, 0, wide.len(), Flavour::S7);
    assert!(parsed.mistakes.iter().any(|mistake| mistake.message.contains("at most")));
}

#[test]
fn an_operator_of_iec_with_pins_is_a_box_and_alone_it_is_logic() {
    let boxed = ["AND a, b => c\n", "OR\n    IN1 := a\n    IN2 := b\n    OUT => c\n", "XOR IN1 := a, IN2 := b => c\n", "NOT a => c\n"];
    for text in boxed {
        let parsed = parse(text, 0, text.len(), Flavour::Iec);
        assert!(parsed.mistakes.is_empty(), "{text}: {:?}", parsed.mistakes);
        let Content::Rung(rung) = &parsed.network.content else { panic!("{text}: {:?}", parsed.network) };
        assert!(matches!(rung.line.as_slice(), [Element { kind: Kind::Named(_), .. }]), "{text}: {rung:?}");
    }
    let logic = "AND\n    NO  a\nAND\n    OR\n        NO  b\n    OR\n        NC  c\n    END\nEND\nNOT\nCOIL x\n";
    let parsed = parse(logic, 0, logic.len(), Flavour::Iec);
    assert!(parsed.mistakes.is_empty(), "{:?}", parsed.mistakes);
    let Content::Rung(rung) = &parsed.network.content else { panic!("{:?}", parsed.network) };
    let kinds: Vec<&Kind> = rung.line.iter().map(|element| &element.kind).collect();
    assert!(matches!(kinds.as_slice(), [Kind::Contact { .. }, Kind::Parallel { .. }, Kind::Not]), "{kinds:?}");
}

#[test]
fn a_comparison_of_iec_is_a_box() {
    let text = "CMP > a, 10\nCOIL x\n";
    let parsed = parse(text, 0, text.len(), Flavour::Iec);
    let mistake = parsed.mistakes.first().expect("CMP is none of IEC");
    assert_eq!((&text[mistake.start..mistake.end], mistake.help.is_some()), ("CMP > a, 10", true), "{mistake:?}");
}
