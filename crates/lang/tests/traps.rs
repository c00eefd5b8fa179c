//! Traps in programs that run all the same, and slips of ST: what is said, and what is offered to write instead.

use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Options, compile};
use sieben_model::diagnostic::{Certainty, Diagnostic};
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

fn found(name: &str, text: &str, dialect: Option<Dialect>) -> Vec<Diagnostic> {
    let mut sources = Sources::default();
    sources.add(name, text);
    let options = Options { dialect, ..Options::default() };
    let all = compile(&sources, &SymbolTable::default(), &options).diagnostics;
    all.into_iter().filter(|one| !matches!(one.problem.code(), "P3013" | "P6222")).collect()
}

/// Statements of an OB 1, or whole blocks, and the traps in them by their lines.
#[rustfmt::skip] // A table.
const TRAPS: &[(&str, &[&str])] = &[
    // A condition that guards nothing.
    ("A I 1.0\nL IB 0", &["2 P5021"]),
    ("A I 1.0\nL IB 0\nT QB 4\nA I 1.1\n= Q 8.0", &["2 P5021"]),
    ("A(\nO I 1.0\nO I 1.1\n)\nL 5\nT MW 0\nSET\n= Q 0.0", &["5 P5021"]),
    ("A I 1.0\nL MW 0\nL 5\n>I\n= Q 0.0", &["2 P5021"]),
    ("A I 1.0\nJCN over\nL IB 0\nT QB 4\nover: A I 1.1\n= Q 8.0", &[]),
    ("A I 1.0\nL S5T#2S\nSD T 1\nA I 1.1\n= Q 8.0", &[]),
    ("A I 1.0\nL IB 0\nA I 1.1\n= Q 8.0", &[]),
    ("A I 1.0\n= Q 0.0\nL IB 0\nT QB 4", &[]),
    ("A I 1.0\nL C#5\nS C 1", &[]),
    ("A I 1.0\nL IB 0\nT QB 4\nBEC\nL 1\nT QB 5", &[]),
    ("A I 1.0\nL IB 0\nT QB 4\nSAVE", &[]),
    ("A I 0.0\nA(\nL MW 0\nL 5\n>I\n)\n= Q 0.0", &[]),
    ("L MW 0\nL 5\n>I\nA I 0.0\n= Q 0.0\nL 1\nT MW 2", &[]),
    ("A I 1.0\nL IB 0\nJU over\nover: T QB 4\n= Q 0.0", &[]),
    // A flip-flop.
    ("A I 0.0\nAN Q 0.0\nS Q 0.0\nA I 0.0\nA Q 0.0\nR Q 0.0", &["6 P5030"]),
    ("A I 0.0\nAN Q 0.0\nS Q 0.0\nBEC\nA I 0.0\nA Q 0.0\nR Q 0.0", &[]),
    ("A I 0.0\nAN Q 0.0\nS Q 0.0\nA I 0.1\nA Q 0.0\nR Q 0.0", &[]),
    ("A I 0.0\nS Q 0.0\nA I 0.1\nR Q 0.0", &[]),
    // Timers.
    ("A I 0.0\nL S5T#2S\nSD T 1\nA I 0.1\nL S5T#5S\nSE T 1", &["6 P5022"]),
    ("A M 0.0\nJCN m1\nA I 0.0\nL S5T#1S\nSD T 1\nm1: A M 0.0\nJC m2\nA I 0.0\nL S5T#5S\nSD T 1\nm2: NOP 0", &[]),
    ("FUNCTION_BLOCK FB 1 VAR_INPUT a : INT; END_VAR BEGIN\nLAR1 AR2;\nLAR2 P#2.0;\nL W [AR2,P#0.0];\nTAR1 AR2;\nL #a;\nT MW 0;\nEND_FUNCTION_BLOCK", &[]),
    ("A I 0.0\nJCN two\nA I 0.1\nL S5T#2S\nSD T 1\nJU end\ntwo: A I 0.2\nL S5T#2S\nSD T 1\nend: NOP 0", &[]),
    ("A I 0.0\nL S5T#2S\nSD T 1\nA I 0.1\nR T 1\nA T 1\n= Q 0.0", &[]),
    // The master control relay.
    ("A I 0.0\nMCR(\n= Q 0.0\n)MCR", &["2 P5023"]),
    ("MCRA\nA I 0.0\nMCR(\n= Q 0.0\n)MCR\nMCRD", &[]),
    ("MCRA\nMCRD\nA I 0.0\nMCR(\n= Q 0.0\n)MCR", &["4 P5023"]),
    ("A I 0.0\nMCR(\nMCRA\n= Q 0.0\n)MCR", &[]),
    // SAVE does not end the line of a diagram.
    ("NETWORK LAD\nNO I 0.0\nBRANCH\n    NO I 0.1\n    SAVE\nBRANCH\n    NO I 0.2\n    COIL Q 0.0\nEND", &["5 P2412"]),
    ("NETWORK LAD\nNO I 0.0\nBRANCH\n    NO I 0.1\n    SAVE\n    COIL M 0.0\nBRANCH\n    NO I 0.2\n    COIL Q 0.0\nEND", &[]),
    ("NETWORK LAD\nNO I 0.0\nBRANCH\n    NO I 0.2\n    COIL Q 0.0\nBRANCH\n    NO I 0.1\n    SAVE\nEND", &[]),
    ("NETWORK LAD\nNO I 0.0\nBRANCH\n    SAVE\nBRANCH\n    NO I 0.2\n    COIL Q 0.0\nEND", &[]),
    ("NETWORK LAD\nNO I 0.0\nBRANCH\n    NO I 0.3\n    BRANCH\n        COIL Q 0.1\n    BRANCH\n        SAVE\n    END\nBRANCH\n    NO I 0.2\n    COIL Q 0.0\nEND", &["8 P2412"]),
    ("NETWORK LAD\nNO I 0.0\nBRANCH\n    NO I 0.1\n    SAVE\nBRANCH\n    MOVE MW 0 => MW 2\nEND", &["5 P2412"]),
    ("NETWORK LAD\nNO I 0.0\nSAVE\nNETWORK LAD\nNO I 0.1\nCOIL Q 0.0", &["3 P2412"]),
    ("NETWORK LAD\nNO I 0.0\nSAVE\nNETWORK LAD\nADD_I MW 0, 1 => MW 0\nCOIL Q 0.0", &["3 P2412"]),
    ("NETWORK LAD\nNO I 0.0\nSAVE\nNETWORK LAD\nADD_I MW 0, 1 => MW 0", &[]),
    ("NETWORK LAD\nNO I 0.0\nSAVE\nNETWORK LAD\nCMP >I MW 0, 1\nCOIL Q 0.0", &[]),
    ("NETWORK LAD\nNO I 0.0\nRET\nNETWORK LAD\nNO I 0.1\nCOIL Q 0.0", &[]),
    ("NETWORK LAD\nNO I 0.0\nCOIL Q 0.0\nSAVE", &[]),
    // Calls in a chain of boxes, and what a block writes where logic is wired.
    ("FUNCTION FC 1 : VOID VAR_IN_OUT p : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR BEGIN\nA #p;\n= #p;\n= #q;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK LAD\nNO I 0.0\nCALL FC 1\n    p := =M 0.0\n    q => M 0.1\nCALL FC 1\n    p := =M 0.0\n    q => M 0.1\nCALL FC 1\n    p := M 0.0\n    q := M 0.1\nCOIL Q 0.0\nEND_ORGANIZATION_BLOCK", &["17 P2411", "18 P2411"]),
    ("FUNCTION FC 1 : VOID VAR_INPUT p : BOOL; END_VAR BEGIN\nA #p;\n= M 0.0;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK LAD\nNO I 0.0\nCALL FC 1\n    p := M 0.0\nEND_ORGANIZATION_BLOCK", &[]),
    ("FUNCTION FC 1 : VOID BEGIN\nBE;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nA(;\nA I 0.0;\nJNB m1;\nCALL FC 1;\nm1: A BR;\n);\nJNB m2;\nCALL FC 1;\nm2: NOP 0;\nEND_ORGANIZATION_BLOCK", &[]),
    ("FUNCTION FC 1 : VOID BEGIN\nBE;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nA(;\nA I 0.0;\nCALL FC 1;\nA I 0.1;\n);\n= Q 0.0;\nEND_ORGANIZATION_BLOCK", &["8 P2214"]),
    // Registers of a function block.
    ("FUNCTION_BLOCK FB 1 VAR_INPUT a : INT; END_VAR BEGIN\nLAR2 P#2.0;\nL #a;\nT MW 0;\nEND_FUNCTION_BLOCK", &["3 P5024"]),
    ("FUNCTION_BLOCK FB 1 VAR_INPUT a : INT; END_VAR BEGIN\nOPN DI 5;\nL #a;\nT MW 0;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 5 STRUCT x : INT; END_STRUCT BEGIN END_DATA_BLOCK", &["3 P5024"]),
    ("FUNCTION_BLOCK FB 1 VAR_INPUT a : INT; END_VAR VAR_TEMP s : DWORD; END_VAR BEGIN\nTAR2 #s;\nLAR2 P#2.0;\nL MW [AR2,P#0.0];\nLAR2 #s;\nL #a;\nT MW 0;\nEND_FUNCTION_BLOCK", &[]),
    ("FUNCTION_BLOCK FB 1 VAR_INPUT a : INT; END_VAR BEGIN\nL #a;\nT MW 0;\nLAR2 P#2.0;\nEND_FUNCTION_BLOCK", &[]),
    ("FUNCTION FC 1 : VOID VAR_INPUT s : STRUCT a : INT; b : INT; END_STRUCT; END_VAR BEGIN\nLAR1 P#M 10.0;\nL #s.b;\nT W [AR1,P#0.0];\nEND_FUNCTION", &["3 P5025"]),
    ("FUNCTION FC 1 : VOID VAR_INPUT s : STRUCT a : INT; b : INT; END_STRUCT; END_VAR BEGIN\nL #s.b;\nLAR1 P#M 10.0;\nT W [AR1,P#0.0];\nEND_FUNCTION", &[]),
    ("FUNCTION_BLOCK FB 1 VAR_INPUT p : DWORD; END_VAR BEGIN\nL MW [#p];\nT MW 0;\nEND_FUNCTION_BLOCK", &["2 P5026"]),
    ("FUNCTION_BLOCK FB 1 VAR_INPUT t : TIMER; END_VAR BEGIN\nA #t;\n= Q 0.0;\nEND_FUNCTION_BLOCK", &[]),
    ("FUNCTION FC 1 : VOID VAR_INPUT p : ANY; END_VAR BEGIN\nLAR1 P##p;\nL W [AR1,P#2.0];\nT MW 0;\nEND_FUNCTION", &["2 P5027"]),
    ("FUNCTION FC 1 : VOID VAR_INPUT p : ANY; END_VAR BEGIN\nL P##p;\nLAR1;\nL W [AR1,P#2.0];\nT MW 0;\nEND_FUNCTION", &[]),
    // Inputs.
    ("L 5\nT IW 0", &["2 P5028"]),
    ("A I 0.1\n= I 0.0", &["2 P5028"]),
    ("A I 0.1\nS I 0.0\nA I 0.2\nR I 0.0", &["2 P5028", "4 P5028"]),
    ("L IW 0\nT QW 0", &[]),
    // Times.
    ("A I 0.0\nL S5T#5MS\nSD T 1", &["2 P5029"]),
    ("A I 0.0\nL S5T#15MS\nSD T 1", &["2 P5029"]),
    ("A I 0.0\nL S5T#12S345MS\nSD T 1", &[]),
    ("L S5T#0MS\nT MW 0", &[]),
];

#[test]
fn a_trap_of_stl_is_said_and_what_looks_like_one_is_not() {
    let mut failures = Vec::new();
    for (text, wanted) in TRAPS {
        let line = |one: &Diagnostic| text[..one.span.start as usize].matches('\n').count() + 1;
        let said: Vec<String> = found("row.awl", text, None).iter().map(|one| format!("{} {}", line(one), one.problem.code())).collect();
        if said != *wanted {
            failures.push(format!("{text}\n    wanted {wanted:?}, got {said:?}"));
        }
    }
    assert!(failures.is_empty(), "{} rows:\n{}", failures.len(), failures.join("\n"));
}

/// A dialect, declarations, statements, and the codes that are said.
#[rustfmt::skip] // A table.
const TRAPS_OF_ST: &[(&str, &str, &str, &[&str])] = &[
    ("iec", "t : TON; a, b, q : BOOL;", "t(IN := a, PT := T#1s); t(IN := b, PT := T#2s, Q => q);", &["P5022"]),
    ("codesys", "t : TON; a, b, q : BOOL;", "t(IN := a, PT := T#1s); t(IN := NOT a, PT := T#2s, Q => q);", &["P5022"]),
    ("iec", "t : TON; a, q : BOOL;", "t(IN := FALSE); t(IN := a, PT := T#2s, Q => q);", &[]),
    ("iec", "t : TON; a, b, q : BOOL;", "IF q THEN t(IN := a, PT := T#1s); ELSE t(IN := b, PT := T#2s, Q => q); END_IF;", &[]),
    ("iec", "t : TON; a, b : BOOL; i : INT;", "CASE i OF 1: t(IN := a, PT := T#1s); 2: t(IN := b, PT := T#2s); END_CASE;", &[]),
    ("iec", "t : TON; a, b, q : BOOL;", "IF q THEN t(IN := a, PT := T#1s); END_IF; t(IN := b, PT := T#2s, Q => q);", &["P5022"]),
    ("iec", "t : TON; a, b, q : BOOL;", "IF q THEN t(IN := a, PT := T#1s); END_IF; IF NOT q THEN t(IN := b, PT := T#2s); END_IF;", &[]),
    ("iec", "t : TON; a, b, q : BOOL;", "IF q THEN t(IN := a, PT := T#1s); RETURN; END_IF; t(IN := b, PT := T#2s, Q => q);", &[]),
    ("iec", "t, u : TON; a, b : BOOL;", "t(IN := a, PT := T#1s); u(IN := b, PT := T#2s);", &[]),
    ("iec", "c : CTUD; a, b : BOOL;", "c(CU := a, PV := 3); c(CD := b);", &[]),
    ("iec", "a AT %IX0.0 : BOOL; w AT %IW2 : INT;", "a := TRUE; w := 5;", &["P5028", "P5028"]),
    ("iec", "a AT %IX0.0 : BOOL; q AT %QX0.0 : BOOL;", "q := a;", &[]),
    ("scl", "v : S5TIME;", "v := S_ODT(T_NO := T5, S := I0.0, TV := S5T#5ms); v := S_ODT(T_NO := T5, S := I0.1, TV := S5T#1s);", &["P5029", "P5022"]),
];

#[test]
fn a_trap_of_st_is_said_and_what_looks_like_one_is_not() {
    let mut failures = Vec::new();
    for (dialect, declarations, code, wanted) in TRAPS_OF_ST {
        let text = program(dialect, declarations, code);
        let mut said: Vec<&str> = found("row.st", &text, Dialect::from_name(dialect)).iter().map(|one| one.problem.code()).collect();
        let mut wanted = wanted.to_vec();
        said.sort_unstable();
        wanted.sort_unstable();
        if said != wanted {
            failures.push(format!("{dialect}: {code}\n    wanted {wanted:?}, got {said:?}"));
        }
    }
    assert!(failures.is_empty(), "{} rows:\n{}", failures.len(), failures.join("\n"));
}

fn program(dialect: &str, declarations: &str, code: &str) -> String {
    match dialect {
        "scl" => format!(
            "FUNCTION_BLOCK FB1\nVAR\n  {declarations}\nEND_VAR\nBEGIN\n{code}\nEND_FUNCTION_BLOCK\nORGANIZATION_BLOCK OB1\nBEGIN\n;\nEND_ORGANIZATION_BLOCK\n"
        ),
        _ => format!("PROGRAM Main\nVAR\n  {declarations}\nEND_VAR\n{code}\nEND_PROGRAM\n"),
    }
}

/// A dialect, declarations, statements, the code of the first message, what it offers to write (`!` before it: `--fix` does it), and how many messages there are.
#[rustfmt::skip] // A table.
const SLIPS: &[(&str, &str, &str, &str, &str, usize)] = &[
    ("iec", "c : CTU; a, q : BOOL;", "c(CU :=> a, PV := 3, Q => q);", "P2007", "!:=", 1),
    ("iec", "c : CTU; a, q : BOOL;", "c(CU := a, PV := 3, Q :=> q);", "P2007", "!=>", 1),
    ("codesys", "c : CTUD; a : BOOL;", "c(CU := a, CD := a, LD := a, PV := 3);", "P3009", "LOAD", 1),
    ("codesys", "c : CTUD; a : BOOL;", "c(CU := a, R := a, PV := 3);", "P3009", "RESET", 1),
    ("iec", "c : CTUD; a : BOOL;", "c(CU := a, RESET := a, PV := 3);", "P3009", "R", 1),
    ("iec", "c : CTUD; a : BOOL;", "c(CU := a, LOAD := a, PV := 3);", "P3009", "LD", 1),
    ("iec", "a, b : INT; q : BOOL;", "q := a ≥ b;", "P1005", "!>=", 1),
    ("iec", "a, b : INT; q : BOOL;", "q := a ≤ b;", "P1005", "!<=", 1),
    ("iec", "a, b : INT; q : BOOL;", "q := a ≠ b;", "P1005", "!<>", 1),
    ("iec", "a, b : INT;", "a := b − 1;", "P1005", "!-", 1),
    ("iec", "a, b : INT;", "a := b × 2;", "P1005", "!*", 1),
    ("iec", "s : STRING;", "s := ‘on’;", "P1005", "!'on'", 1),
    ("iec", "t1 : TON; b : BOOL;", "b := t2.Q;", "P3001", "t1", 1),
    ("iec", "t1 : TP; b : BOOL;", "t2(IN := b, PT := T#1s);", "P3008", "t1", 1),
];

#[test]
fn a_slip_of_st_has_one_message_that_says_what_is_meant() {
    let mut failures = Vec::new();
    for (dialect, declarations, code, problem, wanted, count) in SLIPS {
        let text = program(dialect, declarations, code);
        let all = found("row.st", &text, Dialect::from_name(dialect));
        let offered = all.first().and_then(|one| one.fix.as_ref()).map(|fix| match fix.certainty {
            Certainty::Certain => format!("!{}", fix.replacement),
            Certainty::Guess => fix.replacement.clone(),
        });
        let first = all.first().map(|one| one.problem.code());
        if first != Some(problem) || offered.as_deref() != Some(wanted) || all.len() != *count {
            failures.push(format!("{dialect}: {code}\n    wanted {problem} {wanted}, got {all:?}"));
        }
    }
    assert!(failures.is_empty(), "{} rows:\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn a_type_that_is_misspelled_is_suggested_by_its_letters() {
    for (declared, meant) in [("PT", "TP"), ("LUIMT", "ULINT"), ("BOLO", "BOOL"), ("INTE", "INT")] {
        let all = found("row.st", &program("iec", &format!("x : {declared};"), ""), Some(Dialect::Iec));
        let said: Vec<&str> = all.iter().map(|one| one.message.as_str()).collect();
        assert!(said.iter().any(|message| message.contains(&format!("did you mean `{meant}`"))), "{declared}: {said:?}");
    }
    // The letters count before a name of the project that is as near.
    let all = found("row.st", "PROGRAM p\nVAR\n  x : PT;\nEND_VAR\nEND_PROGRAM\n", Some(Dialect::Iec));
    assert!(all[0].message.contains("did you mean `TP`"), "{all:?}");
}

#[test]
fn a_declaration_among_the_statements_is_said_once_and_not_mended_into_a_call() {
    let text = program("iec", "go, q : BOOL;", "delay : TON;\ndelay(IN := go, PT := T#1s, Q => q);\nq := delay.Q;");
    let all = found("row.st", &text, Some(Dialect::Iec));
    let codes: Vec<&str> = all.iter().map(|one| one.problem.code()).collect();
    assert_eq!(codes, ["P6216"], "{all:?}");
    assert!(all[0].message.contains("`delay : TON` is a declaration") && all[0].fix.is_none(), "{all:?}");
    assert!(all[0].help.as_deref().is_some_and(|help| help.contains("VAR delay : TON; END_VAR")), "{all:?}");
}

#[test]
fn a_letter_with_a_mark_is_not_said_to_be_outside_the_latin_alphabet() {
    let all = found("row.st", &program("codesys", "Väljund, Ülesloendur : BOOL;", "Väljund := Ülesloendur;"), Some(Dialect::Codesys));
    assert!(all.iter().all(|one| !one.message.contains("Latin")), "{all:?}");
}
