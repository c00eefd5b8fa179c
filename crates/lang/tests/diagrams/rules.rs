//! One row for each rewrite and each reason, and the statements that make an element.

use sieben_lang::network::flavour::Drawing;
use sieben_lang::network::form_b::print;
use sieben_lang::network::model::{Content, Element, End, Kind, Rung};
use sieben_lang::network::read::notation::ByNotation;
use sieben_lang::network::read::{Answer, Mode, draw};
use sieben_lang::network::reasons::{Reason, Rewrite};
use sieben_lang::network::rules::ELEMENTS_MAX;
use sieben_lang::network::to_lad::to_lad;

use crate::statements::{PLAIN, statements};

/// Statements; what they are without a rewrite, if that is a refusal; the codes; the diagrams.
const REWRITES: &[(&str, &str, &str, &str)] = &[
    // W1: slots that are missing where one box fits.
    ("L MW0; T MW2", "R-NOP 2", "W1", "|- MOVE(MW0 => MW2)"),
    ("CALL FC1", "R-NOP 1", "W1", "|- CALL FC1"),
    ("A I0.0; L S5T#5S; SD T1; A T1; = Q4.0", "R-NOP 4", "W1", "I0.0 S_ODT[T1](TV := S5T#5S) -> = Q4.0"),
    ("A I0.0; L S5T#5S; SD T1; NOP 0; A T1; = Q4.0", "R-NOP 5", "W1", "I0.0 S_ODT[T1](TV := S5T#5S) -> = Q4.0"),
    ("A I0.0; L S5T#5S; SD T1; A I0.1; R T1; L T1; T MW0", "R-NOP 7", "W1", "I0.0 S_ODT[T1](TV := S5T#5S, R := I0.1, BI => MW0)"),
    ("A I0.0; CU C1; BLD 101; A I0.1; L C#3; S C1; A C1; = Q4.0", "R-NOP 7", "W1", "I0.0 S_CU[C1](S := I0.1, PV := C#3) -> = Q4.0"),
    (
        "A I0.0; CU C1; A I0.1; CD C1; A I0.2; R C1; L C1; T MW0; A C1; = Q4.0",
        "R-NOP 5",
        "W1",
        "I0.0 S_CUD[C1](CD := I0.1, R := I0.2, CV => MW0) -> = Q4.0",
    ),
    ("O I0.0; O I0.1; A I0.2; = Q4.0", "", "W2", "(I0.0 | I0.1) I0.2 -> = Q4.0"),
    ("O I0.0; A I0.1; = Q4.0", "", "W4", "I0.0 I0.1 -> = Q4.0"),
    ("A I0.0; O I0.1; = Q4.0", "", "W4", "(I0.0 | I0.1) -> = Q4.0"),
    ("SET; = M0.0; S M0.1", "R-OPCODE 1", "W5", "(M0.0 | /M0.0) -> = M0.0, S M0.1"),
    ("CLR; = M0.0", "R-OPCODE 1", "W5", "M0.0 /M0.0 -> = M0.0"),
    ("A I0.0; = Q4.0; A I0.1; = Q4.1", "R-TWO 3", "W6", "I0.0 -> = Q4.0 // I0.1 -> = Q4.1"),
    ("A I0.0; JC m1; A I0.1; = Q4.0; m1: A I0.2; = Q4.1", "R-JUMP 2", "W6", "I0.0 -> JMP m1 // I0.1 -> = Q4.0 // LABEL m1: I0.2 -> = Q4.1"),
    ("A I0.0; CU C1; A I0.1; L C#3; S C1; A C1; = Q4.0", "R-NOP 3", "W6", "I0.0 -> CU C1 // I0.1 -> SC C1 C#3 // C1 -> = Q4.0"),
    ("A I0.1; R T1; A I0.0; L S5T#5S; SD T1", "R-TWO 3", "W6", "I0.1 -> R T1 // I0.0 -> SD T1 S5T#5S"),
    ("A I0.0; = L40.0; A L40.0; A I0.1; = Q4.0; A L40.0; A I0.2; = Q4.1", "", "W7", "I0.0 { I0.1 -> = Q4.0 ; I0.2 -> = Q4.1 }"),
    ("L 5; T MW2; T MW4; T MW6", "R-STORE 3", "W8", "|- MOVE(5 => MW2) MOVE(5 => MW4) MOVE(5 => MW6)"),
    ("A I0.0; JCN m1; L MW0; T MW2; m1: NOP 0", "R-JUMP 2", "W9", "I0.0 MOVE(MW0 => MW2)"),
    ("A I0.0; JC m1; L MW0; L MW2; +I; T MW4; m1: NOP 0", "R-JUMP 2", "W9", "I0.0 ! ADD_I(MW0, MW2 => MW4)"),
    ("A I0.0; = #t; A #t; = Q4.0; A #t; A I0.1; = Q4.1", "R-TWO 5", "W10", "I0.0 { -> = Q4.0 ; I0.1 -> = Q4.1 }"),
    ("A I0.0; = L20.0; CALL FC1 (P := L20.0); NOP 0", "", "W11", "|- CALL FC1(P := I0.0)"),
    ("A I0.0; BLD 7; = Q4.0", "", "W11", "I0.0 -> = Q4.0"),
    ("A(; A I0.0; A I0.1; ); = Q4.0", "", "W12", "I0.0 I0.1 -> = Q4.0"),
];

fn refused(refusal: &sieben_lang::network::reasons::Refusal) -> String {
    format!("{} {}", refusal.reason, refusal.statement + 1)
}

#[test]
fn each_rewrite_makes_a_diagram_and_says_what_stood_in_the_way() {
    for (input, reason, codes, diagrams) in REWRITES {
        let Answer::Equivalent(reading, refusal) = draw(&statements(input), &PLAIN, 160, Mode::RewritingConstants) else {
            panic!("{input}")
        };
        let networks: Vec<String> = reading.networks.iter().map(|network| print(network, Drawing::Lad)).collect();
        let got: Vec<String> = reading.rewrites.iter().map(ToString::to_string).collect();
        assert_eq!((networks.join(" // ").as_str(), got.join(",").as_str()), (*diagrams, *codes), "{input}");
        assert_eq!(&refusal.as_ref().map(refused).unwrap_or_default(), reason, "{input}");
    }
    // The two that only ladder needs.
    for (input, code, line) in [
        ("AN(; A I0.0; A I0.1; ); = Q4.0", Rewrite::NegatedBracket, "I0.0 I0.1 ! -> = Q4.0"),
        ("X I0.0; XN I0.1; = Q4.0", Rewrite::ExclusiveOr, "(I0.0 I0.1 | /I0.0 /I0.1) -> = Q4.0"),
    ] {
        let Answer::Exact(network) = draw(&statements(input), &PLAIN, 160, Mode::Strict) else { panic!("{input}") };
        let (lad, rewrites) = to_lad(&network).unwrap_or_else(|refusal| panic!("{input}: {refusal:?}"));
        assert_eq!((print(&lad, Drawing::Lad).as_str(), rewrites.into_iter().collect::<Vec<_>>()), (line, vec![code]));
    }
}

/// Statements, and why they stay STL even with rewrites.
const REFUSALS: &[(&str, &str)] = &[
    ("A I0.0; A I0.1", "R-LOGIC 2"),
    // The ENO or Q of the last box is checked, and nothing is made of it: the end of the box cannot be open then.
    ("A I0.0; JNB _001; L MW0; L MW2; +I; T MW4; AN OV; SAVE; CLR; _001: A BR", "R-LOGIC 10"),
    ("L MW0; T MW2; SET; SAVE; CLR; A BR", "R-LOGIC 6"),
    ("CALL FC1; A BR", "R-LOGIC 2"),
    ("A I0.0; L S5T#5S; SD T1; NOP 0; NOP 0; NOP 0; A T1", "R-LOGIC 7"),
    ("A I0.0; S M0.0; A I0.1; R M0.0; A M0.0", "R-LOGIC 5"),
    ("L MW0; JZ m1", "R-JUMP 2"),
    ("A I0.0; JC m1; A I0.1; JNB m1; L 1; T MW0; m1: NOP 0", "R-JUMP 2"),
    ("A I0.0; m1: A I0.1; = Q4.0", "R-LABEL 2"),
    ("m1: A I0.0; JC m1", "R-JUMP 2"),
    ("L MB0; INC 1; T MB0", "R-OPCODE 2"),
    ("A [MD 10]; = Q4.0", "R-INDIRECT 1"),
    ("A I0.0; L MW0; T MW2", "R-UNCOND 2"),
    ("L MW0", "R-STORE 1"),
    ("L PIW256; T MW2; T MW4", "R-STORE 3"),
    ("L MW0; T MW0; T MW4", "R-STORE 3"),
    ("L MW0; ITD; DTR; T MD4", "R-CHAIN 3"),
    ("A I0.0; CD C1; A I0.1; L C#3; S C1; A I0.2; R C1; NOP 0; NOP 0; NOP 0; A C1; A I0.7; FP M0.0", "R-NOP 3"),
    ("A I0.0; SD T1", "R-ORDER 2"),
    ("A I0.0; L S5T#1S; SD T1; NOP 0; LC T1; T MW0; L T1; T MW2; NOP 0", "R-ORDER 5"),
    ("A I0.0; S C1", "R-ORDER 2"),
    ("A I0.0; JNB _001; L MW0; T MW2; AN OS; SAVE; CLR; _001: A BR; = Q4.0", "R-ENO 5"),
    ("A I0.0; A(; A I0.1", "R-BRACKET 2"),
    ("A(; A(; A(; A(; A(; A(; A(; A(; A I0.0; ); ); ); ); ); ); ); ); = Q4.0", "R-DEPTH 8"),
    ("A I0.0; = L20.0; A I0.1; = Q4.0", "R-BITLEFT 2"),
    ("A I0.0; = L20.0; A L20.0; = L20.1; A L20.1; BLD 102; = Q4.0; A L20.1; A(; O I0.1; O L20.0; ); = Q4.1", "R-BACK 11"),
    ("A I0.0; O; A I0.1; NOT; = Q4.0", "R-NEG 4"),
    ("L MB0; L MW2; +I; T MW4; NOP 0", "R-WIDTH 1"),
    ("L MW0; L MW2; +I; T MD4; NOP 0", "R-WIDTH 4"),
    ("L MW4; L MD0; SLW; T MW6; NOP 0", "R-WIDTH 2"),
    ("A I0.0; JNB _001; L MW0; L MW2; ==I; _001: NOP 0", "R-MIX 5"),
];

#[test]
fn each_reason_names_the_statement() {
    for (input, expected) in REFUSALS {
        match draw(&statements(input), &PLAIN, 160, Mode::RewritingConstants) {
            Answer::No(refusal) => assert_eq!(&refused(&refusal), expected, "{input}"),
            other => panic!("{input}: {other:?}"),
        }
    }
    let wide = format!("{}; = Q4.0", vec!["A I0.0"; ELEMENTS_MAX + 1].join("; "));
    let deep = format!("{}; = Q4.0", vec!["A I0.0; O I0.1"; 2000].join("; "));
    for (input, code) in [(wide, "R-SIZE"), (deep, "R-DEPTH")] {
        match draw(&statements(&input), &PLAIN, 160, Mode::RewritingConstants) {
            Answer::No(refusal) => assert_eq!(refusal.reason.code(), code),
            other => panic!("{code}: {other:?}"),
        }
    }
    let found = |reason: &&Reason| {
        let code = reason.code();
        if matches!(reason, Reason::Size | Reason::Carried) {
            return true;
        }
        REFUSALS.iter().any(|row| row.1.starts_with(code)) || REWRITES.iter().any(|row| row.1.starts_with(code))
    };
    let missing: Vec<_> = Reason::ALL.iter().filter(|reason| !found(reason)).collect();
    assert!(missing.is_empty(), "{missing:?}");
    let shown = |rewrite: &&Rewrite| REWRITES.iter().any(|row| row.2.split(',').any(|code| code == rewrite.code()));
    let missing: Vec<_> = Rewrite::ALL.iter().filter(|rewrite| !shown(rewrite)).collect();
    assert_eq!(missing, [&Rewrite::NegatedBracket, &Rewrite::ExclusiveOr]);
}

/// The caller of the block may read BR.
const CALLED: ByNotation = ByNotation { branch_result_matters: true };

#[test]
fn a_jump_around_boxes_stays_where_the_branch_result_is_read() {
    let input = statements("A I0.0; JCN m1; L MW0; T MW2; m1: NOP 0");
    let Answer::Equivalent(reading, _) = draw(&input, &CALLED, 160, Mode::Rewriting) else { panic!("it is split") };
    assert_eq!(reading.rewrites.into_iter().collect::<Vec<_>>(), [Rewrite::Placeholder, Rewrite::Split]);
    let networks: Vec<String> = reading.networks.iter().map(|network| print(network, Drawing::Lad)).collect();
    assert_eq!(networks.join(" // "), "I0.0 -> JMPN m1 // |- MOVE(MW0 => MW2) // LABEL m1: empty network");
}

/// Each element of a line with its statements.
fn places(rung: &Rung, out: &mut Vec<String>) {
    fn line(elements: &[Element], out: &mut Vec<String>) {
        for element in elements {
            out.push(format!("{}-{}", element.place.first, element.place.last));
            match &element.kind {
                Kind::Parallel { branches, .. } => branches.iter().for_each(|branch| line(&branch.line, out)),
                Kind::Timer(timer) => timer.reset.iter().for_each(|logic| line(logic, out)),
                Kind::Call { pins, .. } => {
                    for pin in pins {
                        if let sieben_lang::network::model::Actual::Logic(logic) = &pin.actual {
                            line(logic, out);
                        }
                    }
                }
                _ => {}
            }
        }
    }
    line(&rung.line, out);
    match &rung.end {
        End::Open => {}
        End::Outputs(outputs) => outputs.iter().for_each(|output| out.push(format!("{}-{}", output.place.first, output.place.last))),
        End::Branches(rungs) => rungs.iter().for_each(|rung| places(rung, out)),
    }
}

#[test]
fn every_element_knows_its_statements() {
    for (input, expected) in [
        ("A I0.0; A(; O I0.1; O I0.2; ); FP M0.0; = M0.1; A M0.1; = Q4.0; SAVE; BEC", "0-0 2-3 2-2 3-3 5-5 6-7 8-8 9-10"),
        ("A I0.0; = L20.0; A L20.0; BLD 102; = Q4.0; A L20.0; A I0.1; L S5T#1S; SD T1", "0-0 4-4 6-6 7-8"),
        ("A I0.0; L S5T#5S; SD T1; A I0.1; R T1; NOP 0; NOP 0; A T1; = Q4.0", "0-0 1-7 3-3 8-8"),
        ("A I0.0; = L20.0; BLD 103; A I0.1; JNB _001; CALL FC1 (P := L20.0); _001: A BR; = Q4.0", "3-3 4-6 0-0 7-7"),
        ("A(; L MW0; L MW2; ==I; ); A(; A I0.0; BLD 100; FP M0.0; ); = Q4.0", "1-3 6-8 10-10"),
    ] {
        let Answer::Exact(network) = draw(&statements(input), &PLAIN, 160, Mode::Strict) else { panic!("{input}") };
        let Content::Rung(rung) = &network.content else { panic!("{input}") };
        let mut out = Vec::new();
        places(rung, &mut out);
        assert_eq!(out.join(" "), expected, "{input}");
    }
}
