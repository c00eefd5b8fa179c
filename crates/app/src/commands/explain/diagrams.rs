//! `sieben explain NO`: elements of diagrams, why a network is not drawn (`R-TWO`), and what is rewritten (`W3`).

use sieben_lang::network::boxes::{BoxRow, COMPARISONS, CounterKind, TimerKind};
use sieben_lang::network::elements::ElementRow;
use sieben_lang::network::reasons::{Reason, Rewrite};
use sieben_lang::stl::instructions::Instruction;
use sieben_model::problems::Problem;

/// The code of comments between statements, which are no reason to leave a network as it is.
const COMMENTS: &str = "R-TEXT";

/// An element by its word in form A, which is also the name of a box.
pub(super) fn element(word: &str) -> Option<String> {
    let word = word.to_ascii_uppercase();
    if let Some(comparison) = word.strip_prefix("CMP ") {
        return compare(comparison.trim());
    }
    let plain = ElementRow::of(&word).map(plain);
    let boxed = BoxRow::of_name(&word).map(with_enable);
    let timer = TimerKind::ALL.iter().find(|row| row.2 == word).map(|row| timer(row.0));
    let counter = CounterKind::ALL.iter().find(|row| row.1 == word).map(|row| counter(row.0));
    plain.or(boxed).or(timer).or(counter)
}

fn plain(row: &ElementRow) -> String {
    let drawn = if row.sign.is_empty() { String::new() } else { format!("  drawn       {}\n", row.sign) };
    let statements = if row.statements.is_empty() { String::new() } else { format!("  statements  {}\n", row.statements) };
    format!("{}, an element of LAD and FBD\n  {}\n{drawn}{statements}", row.word, row.sentence)
}

/// `CMP >I`: the element, and what its comparison does.
fn compare(comparison: &str) -> Option<String> {
    let operation = COMPARISONS.iter().find(|known| **known == comparison)?;
    let (sign, kind) = operation.split_at(operation.len() - 1);
    let numbers = match kind {
        "I" => "INT (16 bits)",
        "D" => "DINT (32 bits)",
        _ => "REAL",
    };
    Some(format!(
        "CMP {operation}, a comparison of LAD and FBD\n  The line goes on if a {sign} b. It is a contact and has no EN.\n  \
         operands    two of {numbers}: `CMP {operation} a, b`, on one line `[a {operation} b]`\n  statements  L a; L b; {operation}\n",
    ))
}

/// What an instruction does, from its row.
fn doc(instruction: &str) -> &'static str {
    Instruction::ALL.iter().find(|row| row.english() == instruction).map_or("", |row| row.doc())
}

fn with_enable(row: &BoxRow) -> String {
    let sentence = match row.instruction {
        "" => "Copies IN to OUT, also between operands of different widths.".to_owned(),
        instruction => format!("Stands for `{instruction}`: {}", doc(instruction)),
    };
    let names = row.inputs.iter().copied().chain(["OUT"]);
    let pins: Vec<String> = names.zip(row.types).map(|(name, pin)| format!("{name} ({})", pin.name())).collect();
    let eno = if row.overflows { "0 if the result left its range, or if EN is 0" } else { "as EN" };
    format!("{}, a box of LAD and FBD with EN and ENO\n  {sentence}\n  pins        {}\n  ENO         {eno}\n", row.name, pins.join(", "))
}

fn timer(kind: TimerKind) -> String {
    format!(
        "{}, a timer box of LAD and FBD\n  Stands for `{}`: {}\n  pins        S (the line), TV (S5TIME), R, BI (WORD), BCD (WORD), Q\n",
        kind.box_name(),
        kind.instruction(),
        doc(kind.instruction())
    )
}

fn counter(kind: CounterKind) -> String {
    let (counts, pins) = match kind {
        CounterKind::Up => ("up", "CU (the line)"),
        CounterKind::Down => ("down", "CD (the line)"),
        CounterKind::UpDown => ("up and down", "CU (the line), CD"),
    };
    format!(
        "{}, a counter box of LAD and FBD\n  Counts {counts} between 0 and 999; S sets it to PV, R to 0, and Q is 1 unless it is 0.\n  \
         pins        {pins}, S, PV (WORD), R, CV (WORD), CV_BCD (WORD), Q\n",
        kind.box_name()
    )
}

/// `R-TWO`: the problem that a reason is.
pub(super) fn reason(word: &str) -> Option<Problem> {
    let reason = Reason::ALL.iter().find(|reason| reason.code().eq_ignore_ascii_case(word))?;
    Problem::from_code(&format!("P{}", reason.problem()))
}

/// `W3`: what a rewrite changes; also what becomes of comments between statements.
pub(super) fn rewrite(word: &str) -> Option<String> {
    if word.eq_ignore_ascii_case(COMMENTS) {
        return Some(format!(
            "{COMMENTS}, comments between the statements of a network\n  \
             They are no reason to leave a network as it is: `sieben convert` keeps each with the element of its statement.\n  \
             STEP 7 has no place for them in LAD and FBD, and may drop or move them.\n"
        ));
    }
    let rewrite = Rewrite::ALL.iter().find(|rewrite| rewrite.code().eq_ignore_ascii_case(word))?;
    let other = "  A rewrite keeps what the network does; `sieben convert --to lad --rewrite` applies it.\n";
    Some(format!("{}, a rewrite of networks that are drawn\n  {}\n{other}", rewrite.code(), rewrite.sentence()))
}

/// All words, for suggestions.
pub(super) fn words() -> impl Iterator<Item = &'static str> {
    let elements = sieben_lang::network::elements::ELEMENTS.iter().map(|row| row.word);
    let boxes = sieben_lang::network::boxes::BOXES.iter().map(|row| row.name);
    let codes = Reason::ALL.iter().map(|reason| reason.code()).chain(Rewrite::ALL.iter().map(|rewrite| rewrite.code()));
    elements.chain(boxes).chain(codes).chain([COMMENTS])
}

#[cfg(test)]
mod tests {
    use sieben_lang::network::elements::{ELEMENTS, begins_line};

    use super::*;

    #[test]
    fn every_word_of_a_diagram_is_explained() {
        for row in ELEMENTS {
            assert!(element(row.word).is_some(), "{}", row.word);
            assert!(begins_line(row.word), "{} begins no line", row.word);
        }
        for row in sieben_lang::network::boxes::BOXES {
            let text = element(row.name).unwrap_or_default();
            assert!(!text.contains(": \n"), "{} has no sentence", row.name);
        }
    }

    #[test]
    fn every_reason_has_its_problem() {
        for reason in Reason::ALL {
            let problem = super::reason(reason.code()).unwrap_or_else(|| panic!("{reason}"));
            assert!(problem.title().contains(reason.code()), "{reason}: {}", problem.title());
        }
    }
}
