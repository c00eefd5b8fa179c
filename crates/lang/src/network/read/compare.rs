//! Whether two rows of statements are the same, and in what they differ if it makes no difference.

use std::collections::BTreeSet;

use super::Surroundings;
use super::prepare::is_opening;
use crate::network::reasons::Rewrite;
use crate::network::statement::Statement;

/// What may differ.
#[derive(Clone, Copy)]
struct Ignored {
    marks: bool,
    brackets: bool,
    bits: bool,
}

/// The rewrites that tell one from the other: none if they are the same; `None` if something else differs.
pub fn difference(original: &[Statement], written: &[Statement], around: &dyn Surroundings) -> Option<BTreeSet<Rewrite>> {
    let end = original.iter().rposition(|one| one.mnemonic != "BE").map_or(0, |last| last + 1);
    let original = original.get(..end).unwrap_or_default();
    // The fewest that explain it.
    let mut sets: Vec<u8> = (0..8).collect();
    sets.sort_by_key(|set| set.count_ones());
    for set in sets {
        let ignored = Ignored { marks: set & 1 != 0, brackets: set & 2 != 0, bits: set & 4 != 0 };
        if same(original, written, around, ignored) {
            let codes = [(ignored.marks, Rewrite::Marks), (ignored.brackets, Rewrite::Brackets), (ignored.bits, Rewrite::Renumber)];
            return Some(codes.into_iter().filter(|one| one.0).map(|one| one.1).collect());
        }
    }
    None
}

fn same(left: &[Statement], right: &[Statement], around: &dyn Surroundings, ignored: Ignored) -> bool {
    let counts = |one: &&Statement| {
        let mark = one.mnemonic == "BLD" && one.operand != "101";
        let bracket = is_opening(one) || one.mnemonic == ")";
        !((ignored.marks && mark) || (ignored.brackets && bracket))
    };
    let mut right = right.iter().filter(counts);
    let all = left.iter().filter(counts).all(|one| right.next().is_some_and(|other| same_statement(one, other, around, ignored)));
    all && right.next().is_none()
}

fn same_statement(left: &Statement, right: &Statement, around: &dyn Surroundings, ignored: Ignored) -> bool {
    let same_operand = |left: &str, right: &str| match (around.scratch(left), around.scratch(right)) {
        (Some(one), Some(other)) => ignored.bits || one == other,
        (None, None) => left == right || same_constant(left, right),
        _ => false,
    };
    let same_labels = match (&left.label, &right.label) {
        (None, None) => true,
        // Generated labels carry no meaning.
        (Some(one), Some(other)) => one == other || other.starts_with('_'),
        _ => ignored.brackets && (left.label.is_none() || right.label.is_none()),
    };
    left.mnemonic == right.mnemonic
        && same_labels
        && (left.mnemonic == "JNB" || same_operand(&left.operand, &right.operand))
        && left.instance == right.instance
        && left.parameters.len() == right.parameters.len()
        && left
            .parameters
            .iter()
            .zip(&right.parameters)
            .all(|(one, other)| one.name == other.name && same_operand(&one.actual, &other.actual))
}

/// The same hexadecimal constant with another number of zeros: `W#16#FF` and `W#16#00FF`.
fn same_constant(left: &str, right: &str) -> bool {
    let parts = |text: &str| text.rsplit_once("16#").map(|(kind, digits)| (kind.to_ascii_uppercase(), digits.replace('_', "")));
    match (parts(left), parts(right)) {
        (Some((one, left)), Some((other, right))) => {
            one == other && left.trim_start_matches('0').eq_ignore_ascii_case(right.trim_start_matches('0'))
        }
        _ => false,
    }
}
