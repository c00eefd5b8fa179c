//! Words glued to their operands and lines that lost their end: what would be understood if a space or a line end stood there.
//!
//! A reading is tried with the parser itself, and what the trial reported and built is thrown away.

use std::collections::HashSet;

use sieben_model::address::{Width, area_and_width};
use sieben_model::block::BlockKind;
use sieben_model::diagnostic::{Certainty, Diagnostic};
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;

use super::blocks::Keyword;
use super::statements::LABEL_MAX;
use super::{DIAGNOSTICS_MAX, Parser};
use crate::stl::ast::{Constant, Operand, Word};
use crate::stl::instructions::Instruction;
use crate::stl::lexer::{Raw, in_word, token};
use crate::stl::mnemonics::translate_instruction;
use crate::stl::operands::{Operand as Meant, OperandClass};
use crate::stl::syntax::SyntaxKind;

/// Characters of the longest instruction word; longer ones need not be tried.
const MNEMONIC_MAX: usize = 5;

/// Trials inside each other: a line that lost its end may hold a word glued to its operand, and nothing deeper.
const TRIALS_MAX: usize = 2;

/// The labels of a block.
#[derive(Default)]
pub(super) struct Labels {
    /// Where the block begins.
    of: usize,
    defined: HashSet<String>,
}

/// One way to read a word that is glued to its operand.
struct Reading {
    /// Bytes of the instruction word.
    length: usize,
    /// Where the operand ends.
    end: usize,
    /// What should stand there.
    right: String,
}

impl Parser<'_> {
    /// Reads something at a byte and forgets it again: what was read, where it ended, and what was reported.
    pub(super) fn try_at<T>(&mut self, position: usize, read: impl FnOnce(&mut Self) -> T) -> (T, usize, Vec<Diagnostic>) {
        let forgets = std::mem::replace(&mut self.forgets, true);
        let diagnostics = std::mem::take(&mut self.diagnostics);
        let foreign = std::mem::take(&mut self.foreign);
        let comments = std::mem::take(&mut self.comments);
        let (before, depth, over) = (self.position, self.depth, self.statement_over);
        self.trials += 1;
        self.advance(position);
        let result = read(self);
        let end = self.position;
        self.trials -= 1;
        self.advance(before);
        (self.depth, self.statement_over) = (depth, over);
        self.forgets = forgets;
        self.foreign = foreign;
        self.comments = comments;
        (result, end, std::mem::replace(&mut self.diagnostics, diagnostics))
    }

    /// The operand at a byte, if one of the instructions takes it and at most misprints with one reading are in it.
    fn operand_of(&mut self, position: usize, rows: &[Instruction]) -> Option<(Operand, usize)> {
        let wants_label = rows.iter().any(|row| row.operand() == OperandClass::Label);
        let (operand, end, diagnostics) =
            self.try_at(position, |parser| if parser.at_statement_end() { Operand::None } else { parser.operand(wants_label) });
        let certain = diagnostics.iter().all(|diagnostic| diagnostic.fix.as_ref().is_some_and(|fix| fix.certainty == Certainty::Certain));
        let suits = certain && rows.iter().any(|row| self.suits(row.operand(), &operand));
        suits.then_some((operand, end))
    }

    /// Whether an instruction takes what is written, as far as the source alone tells.
    fn suits(&mut self, class: OperandClass, operand: &Operand) -> bool {
        use OperandClass as Class;
        let bits = matches!(class, Class::ScanBit | Class::AssignBit);
        let values = matches!(class, Class::Load | Class::Transfer);
        let pointers =
            matches!(class, Class::PointerSource | Class::PointerSourceWithoutAr2 | Class::PointerTarget | Class::PointerTargetWithoutAr2);
        let timers = matches!(class, Class::ScanBit | Class::Load | Class::Timer | Class::TimerOrCounter);
        let counters = matches!(class, Class::ScanBit | Class::Load | Class::Counter | Class::TimerOrCounter);
        let blocks = matches!(class, Class::CallBlock | Class::Call | Class::OpenBlock);
        let at_letters = |letters: &str, bit: bool| match BlockKind::from_abbreviation(letters) {
            Some(BlockKind::DataBlock) => class == Class::OpenBlock,
            Some(_) => matches!(class, Class::CallBlock | Class::Call),
            None => match letters {
                "T" => timers,
                "C" | "Z" => counters,
                "DI" => class == Class::OpenBlock,
                _ => match area_and_width(letters) {
                    Some((_, Width::Bit)) => bits && bit,
                    Some((_, Width::DoubleWord)) => values || pointers,
                    Some(_) => values,
                    None => false,
                },
            },
        };
        match operand {
            Operand::None => class.accepts(&Meant::None),
            Operand::Constant(Constant { value: Some(value), .. }) => class.accepts(&Meant::Constant(value.clone())),
            Operand::AddressOf(_) | Operand::PointerTo { .. } => {
                matches!(class, Class::Load | Class::PointerSource | Class::PointerSourceWithoutAr2)
            }
            Operand::Absolute { letters, bit, .. } | Operand::InBlock { letters, bit, .. } => at_letters(letters, bit.is_some()),
            Operand::Indirect { letters, .. } => at_letters(letters, true),
            Operand::RegisterIndirect { letters, offset, .. } => {
                matches!(offset.value, Some(Value::Pointer(_)))
                    && match letters.as_str() {
                        "" => bits,
                        "B" | "W" | "D" => values,
                        letters => at_letters(letters, true),
                    }
            }
            Operand::BlockField { .. } => bits || values,
            // No name begins with a digit: `LC#5` is `L C#5`.
            Operand::Local { name, .. } if name.text.starts_with(|first: char| first.is_ascii_digit()) => false,
            Operand::Symbol { .. } | Operand::Local { .. } => bits || values || pointers || timers || counters || blocks,
            Operand::Name { word, path } => match word.text.to_ascii_uppercase().as_str() {
                _ if class == Class::Label => path.is_empty() && self.labels().defined.contains(&word.text),
                "STW" => class == Class::StatusWord,
                "DBLG" | "DBNO" | "DILG" | "DINO" => class == Class::DataBlockInfo,
                "AR2" => matches!(class, Class::PointerSource | Class::PointerTarget),
                "==0" | "<>0" | ">0" | "<0" | ">=0" | "<=0" | "UO" | "OV" | "OS" | "BR" | "BIE" => class == Class::ScanBit,
                name => self.declared.contains(name) && (bits || values || pointers || timers || counters || blocks),
            },
            Operand::Error
            | Operand::Constant(_)
            | Operand::Register { .. }
            | Operand::Scratch { .. }
            | Operand::List(_)
            | Operand::Call(_) => false,
        }
    }

    /// The labels of the block that is being read, looked for once.
    fn labels(&mut self) -> &Labels {
        if self.labels.as_ref().is_none_or(|labels| labels.of != self.block_start) {
            self.labels = Some(self.find_labels());
        }
        self.labels.get_or_insert_default()
    }

    fn find_labels(&mut self) -> Labels {
        let mut labels = Labels { of: self.block_start, ..Labels::default() };
        let mut at = self.block_start;
        // A heading begins a line: `FUNCTION FC 1 : VOID` is none.
        let mut first = false;
        loop {
            let (raw, end) = token(self.text, at);
            let word = &self.text[at..end];
            match raw {
                Raw::End => return labels,
                Raw::Word if first && self.ends_labels(word, end) => return labels,
                Raw::Word if token(self.text, self.behind_blanks(end)).0 == Raw::Colon => {
                    labels.defined.insert(word.to_owned());
                }
                _ => {}
            }
            first = raw == Raw::Newline || raw == Raw::Semicolon || (first && raw == Raw::Blank);
            at = end;
        }
    }

    /// Whether another block begins or this one ends at a word: with a keyword, or with a heading, which no jump names.
    fn ends_labels(&mut self, word: &str, end: usize) -> bool {
        if matches!(super::blocks::keyword_of(word), Some(Keyword::BlockStart(_) | Keyword::BlockEnd(_))) {
            return true;
        }
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
        if BlockKind::from_abbreviation(letters).is_none() {
            return false;
        }
        let (next, behind) = token(self.text, self.behind_blanks(end));
        match letters.len() < word.len() {
            true => next == Raw::Colon && !self.is_jumped_to(word),
            false => next == Raw::Number && token(self.text, self.behind_blanks(behind)).0 == Raw::Colon,
        }
    }

    /// Whether a jump of the source names the word.
    pub(super) fn is_jumped_to(&mut self, word: &str) -> bool {
        if self.jumps.is_none() {
            self.jumps = Some(self.find_jumps());
        }
        self.jumps.as_ref().is_some_and(|jumps| jumps.contains(word))
    }

    /// The words that stand behind the jumps of the source.
    fn find_jumps(&self) -> HashSet<String> {
        let mut jumps = HashSet::new();
        let (mut at, mut jump) = (0, false);
        loop {
            let (raw, end) = token(self.text, at);
            let word = &self.text[at..end];
            match raw {
                Raw::End => return jumps,
                Raw::Blank => {}
                Raw::Word if jump => {
                    jumps.insert(word.to_owned());
                    jump = false;
                }
                Raw::Word => {
                    jump = [Mnemonics::English, Mnemonics::German]
                        .into_iter()
                        .any(|mnemonics| Instruction::candidates(word, mnemonics).any(|row| row.operand() == OperandClass::Label));
                }
                _ => jump = false,
            }
            at = end;
        }
    }

    /// Whether the block has a label with this name.
    pub(super) fn is_label(&mut self, word: &str) -> bool {
        self.labels().defined.contains(word)
    }

    /// `TLB 5`, `LP#18.0`, `NOP1`, `JUnext`: the space after the instruction is missing. Nothing is taken if it is something else.
    pub(super) fn glued_mnemonic(&mut self) -> Option<Word> {
        if self.trials >= TRIALS_MAX || self.assigns() {
            return None;
        }
        let start = self.position;
        let mut readings = self.readings(self.mnemonics);
        if readings.is_empty() {
            readings = self.readings(self.mnemonics.other());
        }
        let first = readings.first()?;
        let (length, end) = (first.length, first.end);
        if readings.len() == 1 {
            let right = first.right.clone();
            self.slip(Problem::P2008, start, end, &right, "lacks a space after the instruction");
        } else {
            let ways: Vec<String> = readings.iter().map(|reading| format!("`{}`", reading.right)).collect();
            let message = format!("`{}` lacks a space, and can be read in several ways", self.slice(start, end).trim_end());
            let diagnostic = Diagnostic::new(Problem::P2008, self.span(start, end), message);
            self.report(diagnostic.help(format!("write {}", ways.join(" or "))));
        }
        let written = self.slice(start, start + length);
        let text = match Instruction::candidates(written, self.mnemonics).next() {
            Some(_) => written.to_owned(),
            None => translate_instruction(written, self.mnemonics.other()).unwrap_or(written).to_owned(),
        };
        self.bump_to(SyntaxKind::Mnemonic, start + length);
        Some(Word { text, span: self.span(start, start + length) })
    }

    /// How the word at the current token can be parted into an instruction of a language and an operand that it takes.
    fn readings(&mut self, mnemonics: Mnemonics) -> Vec<Reading> {
        let start = self.position;
        let text = self.text;
        let rest = &text[start..];
        let mut readings = Vec::new();
        for (length, _) in rest.char_indices().skip(1).take(MNEMONIC_MAX) {
            let word = &rest[..length];
            // `=Q 0.0` needs no space: behind a sign a word ends by itself.
            if !rest[length..].starts_with(in_word) || !word.ends_with(in_word) {
                continue;
            }
            let rows: Vec<Instruction> = Instruction::candidates(word, mnemonics).collect();
            if rows.is_empty() {
                continue;
            }
            let Some((operand, end)) = self.operand_of(start + length, &rows) else { continue };
            if operand == Operand::None {
                continue;
            }
            let word = match mnemonics == self.mnemonics {
                true => word,
                false => translate_instruction(word, mnemonics).unwrap_or(word),
            };
            // A local variable may stand without its `#`, but then nothing shows that it is one.
            let local = matches!(&operand, Operand::Name { word, .. } if self.declared.contains(&word.text.to_ascii_uppercase()));
            let local = if local && !rows.iter().any(|row| row.operand() == OperandClass::Label) { "#" } else { "" };
            readings.push(Reading { length, end, right: format!("{word} {local}{}", &text[start + length..end]) });
        }
        readings
    }

    /// Another statement begins at the current token, where the one before it has no `;` and no line end. Nothing is taken.
    pub(super) fn lost_line_end(&mut self) -> bool {
        if self.trials > 0 || self.at_statement_end() {
            return false;
        }
        let before = self.position;
        let at = self.behind_blanks(before);
        let (raw, word_end) = token(self.text, at);
        let label = raw == Raw::Word && token(self.text, self.behind_blanks(word_end)).0 == Raw::Colon;
        let end = match raw {
            Raw::Word if label && self.text[at..word_end].chars().count() <= LABEL_MAX => word_end,
            Raw::Word | Raw::Sign => match self.statement_at(at) {
                Some(end) => end,
                None => return false,
            },
            _ => return false,
        };
        if self.diagnostics.len() > DIAGNOSTICS_MAX {
            // Nothing of it would be shown; to look for the beginning of a very long line each time takes long.
            self.blanks();
            return true;
        }
        let line = self.text[..before].rfind(['\n', '\r']).map_or(0, |at| at + 1);
        let indentation: String = self.text[line..].chars().take_while(|character| matches!(character, ' ' | '\t')).collect();
        let line_end = self.line_break();
        let word = self.slice(at, end);
        let message = format!("`{word}` begins another statement, and no line end and no `;` stands before it");
        let diagnostic = Diagnostic::new(Problem::P2004, self.span(at, end), message);
        let span = self.span(before, end);
        let replacement = format!("{line_end}{indentation}{word}");
        let title = format!("write `{word}` on a line of its own");
        // A word at the end of the line that takes nothing may be a comment that lost its `//`.
        let last = matches!(token(self.text, self.behind_blanks(end)).0, Raw::Newline | Raw::LineComment | Raw::End);
        self.report(match last && !label {
            true => diagnostic.guess(span, replacement, title).help("write it on a line of its own, or `//` before a comment"),
            false => diagnostic.fix(span, replacement, title),
        });
        self.blanks();
        true
    }

    /// Where the instruction word of a whole statement at a byte ends.
    pub(super) fn statement_at(&mut self, at: usize) -> Option<usize> {
        let (mnemonic, end, diagnostics) = self.try_at(at, Self::mnemonic);
        let mnemonic = mnemonic?;
        if diagnostics.iter().any(|diagnostic| diagnostic.fix.as_ref().is_none_or(|fix| fix.certainty != Certainty::Certain)) {
            return None;
        }
        let mut rows: Vec<Instruction> = Instruction::candidates(&mnemonic.text, self.mnemonics).collect();
        if rows.is_empty() {
            rows = Instruction::candidates(&mnemonic.text, self.mnemonics.other()).collect();
        }
        if mnemonic.text.ends_with('(') {
            return (!rows.is_empty()).then_some(end);
        }
        let behind = self.behind_blanks(end);
        self.operand_of(behind, &rows)
            .or_else(|| {
                // `NOT A I 0.0`: what takes no operand, and another statement.
                let alone = rows.iter().any(|row| row.operand().accepts(&Meant::None));
                let next = matches!(token(self.text, behind).0, Raw::Word | Raw::Sign | Raw::ParenClose);
                (alone && next && behind > end && self.trials == 0 && self.try_next(behind)).then_some((Operand::None, end))
            })
            .map(|_| end)
    }

    /// Whether a statement begins at a byte, seen from a statement that is itself only tried.
    fn try_next(&mut self, at: usize) -> bool {
        self.trials += 1;
        let found = self.statement_at(at).is_some();
        self.trials -= 1;
        found
    }

    /// An instruction word at a byte, directly behind a number.
    pub(super) fn instruction_at(&self, at: usize) -> bool {
        let (raw, end) = token(self.text, at);
        raw == Raw::Word && Instruction::candidates(&self.text[at..end], self.mnemonics).next().is_some()
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::source::FileId;

    use super::*;
    use crate::stl::{self, parse};

    /// Operands that an instruction takes, with and without a space inside.
    fn samples(class: OperandClass, mnemonics: Mnemonics) -> Vec<String> {
        use OperandClass as Class;
        let english: &[&str] = match class {
            Class::ScanBit => &["I0.0", "M 1.0", "DBX2.0", "I[MD30]", "[AR1,P#0.0]", "\"Start\"", "#flag", "flag", "T5", "C5", "OV", "UO"],
            Class::AssignBit => &["Q0.0", "M 1.0", "DIX2.0", "M[AR2,P#1.0]", "\"Start\"", "#flag"],
            Class::Load => &[
                "IB0",
                "MW 10",
                "DBD4",
                "PIW256",
                "MW[MD30]",
                "W[AR1,P#2.0]",
                "B [AR1,P#1.0]",
                "10",
                "L#5",
                "W#16#FF",
                "DW#16#FF",
                "2#1010",
                "S5T#4S",
                "T#1S",
                "C#5",
                "P#18.0",
                "P#M10.0",
                "P##flag",
                "'AB'",
                "1.5",
                "\"Level\"",
                "#flag",
                "T5",
                "C5",
                "B#(1,10)",
            ],
            Class::Transfer => &["QB0", "MW 10", "DBD4", "PQW256", "DBW[MD40]", "LD[AR1,P#6.0]", "\"Level\"", "#flag"],
            Class::StatusWord => &["STW"],
            Class::DataBlockInfo => &["DBLG", "DINO"],
            Class::Timer => &["T5", "T[MW60]", "\"Timer\""],
            Class::Counter => &["C5", "C[MW60]", "\"Counter\""],
            Class::TimerOrCounter => &["T5", "C5"],
            Class::PointerSource | Class::PointerSourceWithoutAr2 => &["P#M10.0", "P##flag", "MD4", "LD20", "#flag"],
            Class::PointerTarget | Class::PointerTargetWithoutAr2 => &["MD4", "DBD 4", "#flag"],
            Class::OptionalPointerOffset => &["P#1.0"],
            Class::ByteConstant => &["5"],
            Class::IntConstant | Class::DoubleIntConstant => &[],
            Class::ShiftCount16 | Class::ShiftCount32 => &["4"],
            Class::OptionalConstant16 => &["W#16#FF"],
            Class::OptionalConstant32 => &["DW#16#FF"],
            Class::Label => &["next", "OVER"],
            Class::CallBlock => &["FC1", "FC 1", "SFC46"],
            Class::Call => &["FC1", "FC 1", "SFC46"],
            Class::OpenBlock => &["DB5", "DI 5", "DB[MW 100]", "\"Data\""],
            Class::Zero => &["0"],
            Class::One => &["1"],
            Class::None | Class::Extension => &[],
        };
        let german = |text: &str| {
            let converted = stl::convert(&format!("L {text}\nA I 0.0\n"), Some(Mnemonics::English), Mnemonics::German);
            converted.map_or_else(|_| text.to_owned(), |text| text.lines().next().unwrap_or("").trim_start_matches("L ").trim().to_owned())
        };
        english.iter().map(|text| if mnemonics == Mnemonics::German { german(text) } else { (*text).to_owned() }).collect()
    }

    fn source(statement: &str) -> String {
        format!("FUNCTION FC 1 : VOID\nVAR_TEMP\n flag : DWORD;\nEND_VAR\nBEGIN\n{statement}\nnext: NOP 0\nOVER: NOP 0\nEND_FUNCTION\n")
    }

    /// The statement after the fixes that need no question.
    fn fixed(statement: &str, mnemonics: Mnemonics) -> Option<String> {
        let text = source(statement);
        let parsed = parse(FileId::default(), &text, Some(mnemonics));
        let [diagnostic] = parsed.diagnostics.as_slice() else { return None };
        let fix = diagnostic.fix.as_ref().filter(|fix| fix.certainty == Certainty::Certain)?;
        let (before, behind) = (&text[..fix.span.start as usize], &text[fix.span.end as usize..]);
        let right = format!("{before}{}{behind}", fix.replacement);
        right.lines().nth(5).map(str::to_owned)
    }

    #[test]
    fn every_instruction_that_is_glued_to_its_operand_is_parted() {
        let (mut tried, mut failures) = (0, Vec::new());
        for mnemonics in [Mnemonics::English, Mnemonics::German] {
            for &row in Instruction::ALL {
                let word = row.mnemonic(mnemonics);
                for operand in samples(row.operand(), mnemonics) {
                    let glued = format!("{word}{operand}");
                    let parsed = parse(FileId::default(), &source(&glued), Some(mnemonics));
                    // `=Q0.0` and `L"Level"` need no space, and `TAW 4` begins with another instruction.
                    let first: String = glued.chars().take_while(|&character| in_word(character)).collect();
                    let whole = first.is_empty() || Instruction::candidates(&first, mnemonics).next().is_some();
                    if parsed.diagnostics.is_empty() || whole {
                        continue;
                    }
                    tried += 1;
                    let local = if operand == "flag" { "#" } else { "" };
                    let found = fixed(&glued, mnemonics);
                    if found.as_deref() != Some(format!("{word} {local}{operand}").as_str()) {
                        failures.push(format!("{glued}: {found:?} {:?}", parsed.diagnostics));
                    }
                }
            }
        }
        assert!(failures.is_empty(), "{} of {tried}\n{}", failures.len(), failures.join("\n"));
        assert!(tried > 300, "{tried}");
    }

    #[test]
    fn a_line_with_two_readings_is_left_to_its_author() {
        assert_eq!(fixed("JCNext\nNext: NOP 0", Mnemonics::English), Some("JC Next".to_owned()));
        assert_eq!(fixed("JCNext\nNext: NOP 0\next: NOP 0", Mnemonics::English), None);
    }

    /// Hostile lines: what is tried for each of them must not grow with the source. Quadratic, these take minutes.
    #[test]
    fn many_slips_take_no_longer_each() {
        let count = 20_000;
        for line in ["A I 0.0 ", "A I 0.0A I 0.0", "FC 1:\nJUx\nx: NOP 0\n", "FC1:\n", "LMW10\n", "L a b c\n"] {
            let parsed = parse(FileId::default(), &line.repeat(count), Some(Mnemonics::English));
            assert!(parsed.diagnostics.len() > DIAGNOSTICS_MAX, "{line}");
        }
    }
}
