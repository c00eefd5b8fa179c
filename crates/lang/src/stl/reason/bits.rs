//! Reasons of bit logic and the MCR.

use super::operands::Named;
use super::telling::Telling;
use crate::sentences::table::Sentence as S;
use crate::sentences::text::{Clause, Words};
use crate::stl::why::{Joint, Sense, Why};

/// Whether statements take effect: the MCR is not active, or every open zone is switched on.
pub(super) fn mcr_on(telling: &Telling<'_>) -> bool {
    let before = telling.before();
    before.ma & 1 == 0 || before.mcr & before.mcr.wrapping_add(1) == 0
}

/// `the input I 0.1 is 1, inverted 0`.
fn scanned(subject: &Words, bit: u64, sense: Sense) -> Words {
    let [english, german] = &subject.0;
    match sense {
        Sense::Plain => Words([format!("{english} is {bit}"), format!("{german} ist {bit}")]),
        Sense::Inverted => {
            let inverted = 1 - bit;
            Words([format!("{english} is {bit}, inverted {inverted},"), format!("{german} ist {bit}, negiert {inverted},")])
        }
    }
}

/// `A`, `ON`, `X` ….
pub(super) fn scan(telling: &Telling<'_>, named: &Named, joint: Joint, sense: Sense) -> Vec<Clause> {
    let (before, after) = (telling.before(), telling.after());
    let bit = after.sta & 1;
    let effective = if sense == Sense::Plain { bit } else { 1 - bit };
    let sentence = match (joint, before.rlo, effective) {
        _ if before.fc == 0 => S::ScanFirst,
        (Joint::And, ..) if before.or == 1 => S::AndBehindOr,
        (Joint::And, 0, _) => S::AndZero,
        (Joint::And, _, 1) => S::AndOne,
        (Joint::And, ..) => S::AndBreaks,
        (Joint::Or, 1, _) => S::OrKeeps,
        (Joint::Or, _, 1) => S::OrMakes,
        (Joint::Or, ..) => S::OrNone,
        (Joint::Xor, rlo, bit) if rlo == bit => S::XorEqual,
        (Joint::Xor, ..) => S::XorDiffers,
    };
    let scan = scanned(&named.subject, bit, sense);
    // A comma that opens an insertion is closed by the next word; at the end of the sentence or before a comma there is none.
    let at_end = |language: usize| {
        let language = crate::sentences::Language::ALL[language];
        let template = sentence.template(language);
        template.split_once("{scan}").is_none_or(|(_, behind)| behind.is_empty() || behind.starts_with([',', ';']))
    };
    let [english, german] = scan.0;
    let trim = |text: String, language| if at_end(language) { text.trim_end_matches(',').to_owned() } else { text };
    vec![Clause::new(sentence).with("scan", Words([trim(english, 0), trim(german, 1)]))]
}

/// `O` without operand.
pub(super) fn or_separator(telling: &Telling<'_>) -> Vec<Clause> {
    let before = telling.before();
    vec![Clause::new(match (before.fc, before.rlo) {
        (0, _) => S::OrSeparatorEmpty,
        (_, 1) => S::OrSeparatorOne,
        _ => S::OrSeparatorZero,
    })]
}

fn joint_words(joint: Joint, sense: Sense) -> Words {
    match sense {
        Sense::Plain => joint.words().into(),
        Sense::Inverted => {
            let [english, german] = joint.words();
            Words([format!("{english} NOT"), format!("{german} NICHT")])
        }
    }
}

/// `A(` and its like.
pub(super) fn open(telling: &Telling<'_>, joint: Joint, sense: Sense) -> Vec<Clause> {
    let later: Words = match sense {
        Sense::Plain => "".into(),
        Sense::Inverted => [", inverted", ", negiert,"].into(),
    };
    vec![match telling.before().fc {
        0 => Clause::new(S::OpenFirst).with("inverted_later", later),
        _ => Clause::new(S::Open).with("joint", joint_words(joint, sense)),
    }]
}

/// `)`: what was saved lies in the newest byte of the nesting stack, with the function of the bracket.
pub(super) fn close(telling: &Telling<'_>) -> Vec<Clause> {
    let before = telling.before();
    let entry = before.nesting;
    let (saved, or, fc) = (entry & 1, entry >> 1 & 1, entry >> 2 & 1);
    let function = entry >> 4 & 7;
    let sense = if function & 1 == 0 { Sense::Plain } else { Sense::Inverted };
    let joint = match function >> 1 {
        0 => Joint::And,
        1 => Joint::Or,
        _ => Joint::Xor,
    };
    let inner = match sense {
        Sense::Plain => Words([format!("the bracket gave {}", before.rlo), format!("die Klammer ergab {}", before.rlo)]),
        Sense::Inverted => {
            let inverted = 1 - before.rlo;
            Words([
                format!("the bracket gave {}, inverted {inverted}", before.rlo),
                format!("die Klammer ergab {}, negiert {inverted}", before.rlo),
            ])
        }
    };
    let clause = match (fc, joint, or) {
        (0, ..) => Clause::new(S::CloseFirst),
        (_, Joint::And, 1) => Clause::new(S::CloseBehindOr),
        _ => Clause::new(S::Close).with("saved", saved).with("joint", joint.words()),
    };
    vec![clause.with("inner", inner)]
}

/// `=`.
pub(super) fn assign(telling: &Telling<'_>) -> Vec<Clause> {
    let sentence = if mcr_on(telling) { S::Assign } else { S::AssignMcr };
    vec![Clause::new(sentence).with("bit", telling.after().sta)]
}

/// `S` and `R`.
pub(super) fn set_reset(telling: &Telling<'_>, why: Why) -> Vec<Clause> {
    let sentence = match (mcr_on(telling), telling.before().rlo, why) {
        (false, ..) => S::SetMcr,
        (_, 1, Why::Set) => S::SetOne,
        (_, 1, _) => S::ResetOne,
        _ => S::SetNothing,
    };
    vec![Clause::new(sentence).with("bit", telling.after().sta)]
}

/// `FP` and `FN`: what the edge memory held shows in the RLO behind them.
pub(super) fn edge(telling: &Telling<'_>, why: Why) -> Vec<Clause> {
    vec![Clause::new(match (why, telling.before().rlo, telling.after().rlo) {
        (Why::Rising, 1, 1) => S::RisingEdge,
        (Why::Rising, 1, _) => S::RisingSame,
        (Why::Rising, ..) => S::RisingLow,
        (_, 1, _) => S::FallingHigh,
        (_, _, 1) => S::FallingEdge,
        _ => S::FallingSame,
    })]
}

/// `MCR(`.
pub(super) fn mcr_open(telling: &Telling<'_>) -> Vec<Clause> {
    let before = telling.before();
    vec![Clause::new(match (before.ma, before.rlo) {
        (0, _) => S::McrNotActive,
        (_, 1) => S::McrOpenOn,
        _ => S::McrOpenOff,
    })]
}

/// `)MCR`.
pub(super) fn mcr_close(telling: &Telling<'_>) -> Vec<Clause> {
    let zones = u64::from(63 - telling.after().mcr.max(1).leading_zeros());
    vec![Clause::new(S::McrClose).with("zones", zones)]
}
