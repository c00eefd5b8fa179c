//! Diagrams and statements of any kind: they are answered, and what is understood comes back.

use super::boxes::{BOXES, COMPARISONS, TimerKind};
use super::flavour::{Drawing, Flavour};
use super::form_b::{parse, print};
use super::mistake::MistakeKind;
use super::model::Network;
use super::operand::Operand;
use super::read::compare::difference;
use super::read::notation::ByNotation;
use super::read::{Answer, Mode, draw};
use super::statement::{Parameter, Passing, Statement};
use super::to_lad::to_lad;
use super::write::write;

/// Nothing is known but how operands are written.
const NOTATION: ByNotation = ByNotation { branch_result_matters: false };

/// Survives any line; a diagram that is understood is printed so that it is understood again.
pub fn lines(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    for flavour in [Flavour::S7, Flavour::Iec] {
        match parse(&text, 7, flavour) {
            Ok(network) => comes_back(&network, flavour),
            Err(mistake) => {
                assert!(mistake.start >= 7 && text.is_char_boundary(mistake.start - 7), "the place lies in the line");
                assert!(!mistake.message.is_empty(), "a mistake is said");
            }
        }
    }
}

fn comes_back(network: &Network, flavour: Flavour) {
    for drawing in [Drawing::Lad, Drawing::Fbd] {
        let line = print(network, drawing);
        let again = match parse(&line, 0, flavour) {
            Ok(again) => again,
            // A long line of edges is a deep one in FBD.
            Err(mistake) if mistake.kind == MistakeKind::Size => continue,
            Err(mistake) => panic!("`{line}` is not read again: {mistake:?}"),
        };
        assert_eq!(&again, network, "`{line}` is another diagram");
    }
    if flavour == Flavour::S7 {
        let statements = write(network, 0, &mut 0).statements;
        answered(&statements);
    }
}

/// Survives any statements: two bytes are one of them. What is drawn exactly gives the same statements.
pub fn statements(data: &[u8]) {
    let mnemonics = mnemonics();
    let statement = |pair: &[u8]| {
        let (first, second) = (pair.first().copied().unwrap_or_default(), pair.get(1).copied().unwrap_or_default());
        let mnemonic = mnemonics.get(usize::from(first) % mnemonics.len()).copied().unwrap_or_default();
        let operand = OPERANDS.get(usize::from(second) % OPERANDS.len()).copied().unwrap_or_default();
        let mut statement = Statement::new(mnemonic, if takes_none(mnemonic) { "" } else { operand });
        if mnemonic == "CALL" {
            let name = Operand::from("IN");
            statement.parameters.push(Parameter { name, actual: operand.into(), passing: Passing::In });
        }
        if first >= 240 {
            statement.label = Some(Operand::from(if second < 128 { "_001" } else { "m1" }));
        }
        statement
    };
    answered(&data.chunks(2).map(statement).collect::<Vec<_>>());
}

fn answered(statements: &[Statement]) {
    for mode in [Mode::Strict, Mode::Rewriting, Mode::RewritingConstants] {
        match draw(statements, &NOTATION, 0, mode) {
            Answer::Exact(network) => {
                let written = write(&network, 0, &mut 0).statements;
                let same = statements.is_empty() || difference(statements, &written, &NOTATION).is_some_and(|codes| codes.is_empty());
                assert!(same, "an exact diagram gives the same statements");
            }
            Answer::Equivalent(reading, _) => {
                for network in &reading.networks {
                    let written = write(network, 0, &mut 0).statements;
                    let _ = to_lad(network);
                    let again = draw(&written, &NOTATION, 0, Mode::Strict);
                    assert!(matches!(again, Answer::Exact(_)), "what was rewritten is exact: {statements:?} {written:?} {again:?}");
                }
            }
            Answer::No(refusal) => assert!(refusal.statement < statements.len().max(1), "the statement is one of them"),
        }
    }
}

fn takes_none(mnemonic: &str) -> bool {
    mnemonic.ends_with('(') || COMPARISONS.contains(&mnemonic) || matches!(mnemonic, ")" | "NOT" | "SAVE" | "CLR" | "SET" | "BEC" | "BE")
}

const OPERANDS: &[&str] = &[
    "I0.0", "I0.1", "M0.0", "Q4.0", "L0.0", "L0.1", "#t1", "T1", "C1", "0", "101", "100", "103", "MW0", "MD4", "5", "S5T#1S", "_001", "m1",
    "BR", "OV",
];

fn mnemonics() -> Vec<&'static str> {
    let plain = [
        "A", "AN", "O", "ON", "X", "XN", "A(", "O(", "X(", "AN(", ")", "NOT", "FP", "FN", "=", "S", "R", "L", "T", "LC", "CU", "CD", "NOP",
        "BLD", "SAVE", "CLR", "SET", "BEC", "BE", "JNB", "JC", "JCN", "JU", "CALL", "CC", "UC", "OPN", "MCR(", ")MCR", "A", "A", "=", "L",
        "T", "NOP", "A(", ")",
    ];
    let timers = TimerKind::ALL.iter().map(|row| row.1);
    let boxes = BOXES.iter().map(|row| row.instruction).filter(|name| !name.is_empty()).take(4);
    plain.into_iter().chain(timers).chain(boxes).chain(COMPARISONS.into_iter().take(2)).collect()
}
