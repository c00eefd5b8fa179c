//! The words that begin a line of form A: what each element does, in a sentence, and the statements that it stands for.

use super::boxes::{BoxRow, CounterKind, TimerKind};
use super::flavour::Flavour;

/// An element by its word in form A.
#[derive(Debug)]
pub struct ElementRow {
    /// Its word.
    pub word: &'static str,
    /// How ladder draws it; empty if it has no sign of its own.
    pub sign: &'static str,
    /// Its statements, `…` for the logic before it; empty if it has none of its own.
    pub statements: &'static str,
    /// What it does.
    pub sentence: &'static str,
    /// The diagrams in which it is a coil.
    pub coil_in: &'static [Flavour],
}

const fn row(word: &'static str, sign: &'static str, statements: &'static str, sentence: &'static str) -> ElementRow {
    ElementRow { word, sign, statements, sentence, coil_in: &[] }
}

const S7: &[Flavour] = &[Flavour::S7];
const IEC: &[Flavour] = &[Flavour::Iec];
const BOTH: &[Flavour] = &[Flavour::S7, Flavour::Iec];

impl ElementRow {
    const fn coil(self, coil_in: &'static [Flavour]) -> Self {
        Self { coil_in, ..self }
    }
}

/// All elements that are no boxes with EN, no timers and no counters.
#[rustfmt::skip] // A table.
pub const ELEMENTS: &[ElementRow] = &[
    row("NO", "-| |-", "A x", "A normally open contact: the line goes on if the operand is 1."),
    row("NC", "-|/|-", "AN x", "A normally closed contact: the line goes on if the operand is 0."),
    row("P", "-(P)-", "…; FP m", "A rising edge of the line: 1 for one scan when all that stands to its left becomes 1. Its operand is the edge memory bit."),
    row("N", "-(N)-", "…; FN m", "A falling edge of the line: 1 for one scan when all that stands to its left becomes 0. Its operand is the edge memory bit."),
    row("POS", "POS", "A x; BLD 100; FP m", "A rising edge of one operand: 1 for one scan when it becomes 1."),
    row("NEG", "NEG", "A x; BLD 100; FN m", "A falling edge of one operand: 1 for one scan when it becomes 0."),
    row("NOT", "-|NOT|-", "…; NOT", "Negates all that stands to its left in its branch."),
    row("MID", "-(#)-", "…; = x; A x", "A midline output: writes the line so far to its operand, and the line goes on."),
    row("CMP", "CMP", "L a; L b; ==I", "A comparison of two numbers, drawn as a contact: the line goes on if it holds."),
    row("OR", "", "O x; O y", "Begins a branch of a parallel: the line goes on if one of the branches is 1."),
    row("AND", "", "A( …; )", "An & box of FBD: 1 if all of its inputs are 1."),
    row("XOR", "", "X x; X y", "An exclusive OR of FBD: 1 if an odd number of its inputs is 1."),
    row("COIL", "-( )", "…; = x", "A coil: writes the line to its operand in every scan.").coil(BOTH),
    row("SET", "-(S)", "…; S x", "Sets its operand to 1 while the line is 1, and leaves it alone otherwise.").coil(BOTH),
    row("RESET", "-(R)", "…; R x", "Resets its operand to 0 while the line is 1; a timer or counter starts from nothing. Otherwise it leaves it alone.").coil(BOTH),
    row("SAVE", "-(SAVE)", "…; SAVE", "Keeps the line in BR, the bit that is ENO of the block. The next network goes on with this line.").coil(S7),
    row("JMP", "-(JMP)", "…; JC lab", "Jumps to the network with the label if the line is 1; without logic before it always.").coil(BOTH),
    row("JMPN", "-(JMPN)", "…; JCN lab", "Jumps to the network with the label if the line is 0.").coil(BOTH),
    row("RET", "-(RET)", "…; SAVE; BEC", "Leaves the block if the line is 1; the line becomes its ENO in either case.").coil(BOTH),
    row("CC", "-(CALL)", "…; CC FC 1", "Calls a block without parameters if the line is 1.").coil(S7),
    row("UC", "-(CALL)", "UC FC 1", "Calls a block without parameters, whatever came before; it stands alone in its network."),
    row("OPN", "-(OPN)", "OPN DB 10", "Opens a data block; it stands alone in its network."),
    row("MCRA", "-(MCRA)", "MCRA", "Switches the master control relay on for this block; it stands alone."),
    row("MCRD", "-(MCRD)", "MCRD", "Switches the master control relay off for this block; it stands alone."),
    row("MCR<", "-(MCR<)", "…; MCR(", "Begins a zone: while the line is 0, coils in it write 0, and SET and RESET change nothing.").coil(S7),
    row("MCR>", "-(MCR>)", ")MCR", "Ends the zone that began last; it stands alone."),
    row("SP", "-(SP)", "…; L tv; SP T 1", "Starts a timer as a pulse: 1 for the time, and no longer than the line is 1.").coil(S7),
    row("SE", "-(SE)", "…; L tv; SE T 1", "Starts a timer as an extended pulse: 1 for the whole time, however short the line was 1.").coil(S7),
    row("SD", "-(SD)", "…; L tv; SD T 1", "Starts a timer as an on-delay: 1 when the line was 1 for the time, until it is 0.").coil(S7),
    row("SS", "-(SS)", "…; L tv; SS T 1", "Starts a timer as a stored on-delay: it runs on when the line becomes 0, and stays 1 until it is reset.").coil(S7),
    row("SF", "-(SF)", "…; L tv; SF T 1", "Starts a timer as an off-delay: 1 with the line, and for the time after it became 0.").coil(S7),
    row("SC", "-(SC)", "…; L pv; S C 1", "Sets a counter to a value when the line becomes 1.").coil(S7),
    row("CU", "-(CU)", "…; CU C 1", "Counts up by one when the line becomes 1, to 999 at most.").coil(S7),
    row("CD", "-(CD)", "…; CD C 1", "Counts down by one when the line becomes 1, to 0 at least.").coil(S7),
    row("PCOIL", "-(P)", "", "A coil of IEC 61131-3: 1 for one scan when the line becomes 1.").coil(IEC),
    row("NCOIL", "-(N)", "", "A coil of IEC 61131-3: 1 for one scan when the line becomes 0.").coil(IEC),
    row("LABEL", "", "lab:", "Names the network, for jumps."),
    row("BRANCH", "", "= L x.y; A L x.y", "Begins a branch of a T-branch: several rungs go on from one line, each evaluated once."),
    row("END", "", "", "Ends a parallel, a T-branch or an operand box of FBD."),
    row("TAP", "", "A L x.y", "The line that a T-branch taps, as an input of a box of FBD."),
    row("SR", "SR", "…; S m; …; R m; A m", "A flip-flop: S sets the bit, R resets it, and the reset wins."),
    row("RS", "RS", "…; R m; …; S m; A m", "A flip-flop: R resets the bit, S sets it, and the set wins."),
    row("CALL", "", "CALL FB 3, DB 6 ( … )", "A call of a block as a box, with a pin for each parameter, EN and ENO."),
];

impl ElementRow {
    /// The element of a word, in capitals.
    pub fn of(word: &str) -> Option<&'static Self> {
        ELEMENTS.iter().find(|row| row.word == word)
    }
}

/// A word that begins a coil.
pub fn is_coil(word: &str, flavour: Flavour) -> bool {
    ElementRow::of(word).is_some_and(|row| row.coil_in.contains(&flavour))
}

/// A word that begins a line of form A in diagrams of STEP 7. A circle stands before elements, not before boxes.
pub fn begins_line(word: &str) -> bool {
    let plain = word.trim_start_matches('/');
    is_box(word) || (ElementRow::of(plain).is_some() && !is_box(plain))
}

/// The name of a box of STEP 7.
pub fn is_box(word: &str) -> bool {
    matches!(word, "SR" | "RS" | "CALL")
        || BoxRow::of_name(word).is_some()
        || TimerKind::ALL.iter().any(|row| row.2 == word)
        || CounterKind::ALL.iter().any(|row| row.1 == word)
}
