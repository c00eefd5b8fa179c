//! An instruction of STL at a position, with its row of the instruction list.

use sieben_lang::stl::instructions::Instruction;
use sieben_model::mnemonics::Mnemonics;

use super::super::Bytes;
use super::super::context::line_before;
use super::{Hover, timers};

/// Longest mnemonic, in bytes: `==D` and `)MCR` are short ones.
const MNEMONIC_MAX: usize = 8;

/// The instruction at a byte.
pub(super) fn hover(text: &str, offset: usize, mnemonics: Mnemonics) -> Option<Hover> {
    let (range, rows) = at(text, offset, mnemonics)?;
    let first = rows.first()?;
    let mut markdown = format!("**{}**", first.mnemonic(mnemonics));
    let other = first.mnemonic(mnemonics.other());
    if other != first.mnemonic(mnemonics) {
        markdown.push_str(&format!(" (`{other}` in the other mnemonics)"));
    }
    markdown.push('\n');
    for row in &rows {
        markdown.push_str(&format!("\n{}\n\nOperand: {}.\n\n", row.doc(), row.operand().describe()));
        markdown.push_str("| BR | CC 1 | CC 0 | OV | OS | OR | STA | RLO | /FC |\n|---|---|---|---|---|---|---|---|---|\n|");
        row.status_row().split_whitespace().for_each(|effect| markdown.push_str(&format!(" {effect} |")));
        markdown.push('\n');
    }
    if let Some(diagram) = rows.iter().find_map(|row| timers::of_instruction(row.english())) {
        markdown.push_str(&diagram);
    }
    Some(Hover { range, markdown })
}

/// The rows of the instruction whose mnemonic is at a byte.
pub(super) fn at(text: &str, offset: usize, mnemonics: Mnemonics) -> Option<(Bytes, Vec<Instruction>)> {
    let (start, rows) = of_line(text, offset, mnemonics)?;
    let length = rows.first()?.mnemonic(mnemonics).len();
    let range = Bytes { start, end: start + length };
    (range.start <= offset && offset <= range.end).then_some((range, rows))
}

/// Where the statement around a byte begins, without its label, and the rows of its instruction.
pub(super) fn of_line(text: &str, offset: usize, mnemonics: Mnemonics) -> Option<(usize, Vec<Instruction>)> {
    let before = line_before(text, offset);
    let line_start = offset - before.len();
    let from = line_start + before.rfind(';').filter(|at| !before[*at..].contains('"')).map_or(0, |at| at + 1);
    let line = text.get(from..)?.split(['\n', '\r']).next()?;
    let mut start = from + (line.len() - line.trim_start().len());
    let rest = line.trim_start();
    // A label ends with a colon that begins no `:=`.
    if let Some(colon) = rest.find(':')
        && rest[..colon].chars().all(|sign| sign.is_alphanumeric() || sign == '_' || sign == ' ')
        && !rest[colon..].starts_with(":=")
    {
        let after = &rest[colon + 1..];
        start += colon + 1 + (after.len() - after.trim_start().len());
    }
    let word = text.get(start..)?;
    let longest = word.char_indices().map(|(at, sign)| at + sign.len_utf8()).take(MNEMONIC_MAX);
    let fits = |end: &usize| {
        let whole = &word[..*end];
        let is_cut = whole.ends_with(|sign: char| sign.is_alphanumeric())
            && word[*end..].starts_with(|next: char| next.is_alphanumeric() || next == '_');
        !is_cut && !whole.contains(char::is_whitespace) && Instruction::candidates(whole, mnemonics).next().is_some()
    };
    let end = longest.filter(fits).max()?;
    Some((start, Instruction::candidates(&word[..end], mnemonics).collect()))
}
