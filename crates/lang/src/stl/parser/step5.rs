//! What STEP 5, the language before STL, wrote: flags, data words, constants with K, calls and jumps with `=`.

use sieben_model::block::BlockKind;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::literal;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;

use super::Parser;
use crate::stl::ast::{Constant, Operand, Word};
use crate::stl::lexer::{Raw, in_word, token};
use crate::stl::syntax::SyntaxKind;

/// The flags of STEP 5 and the bit memory of STL.
const FLAGS: [(&str, &str); 4] = [("F", "M"), ("FY", "MB"), ("FW", "MW"), ("FD", "MD")];

/// Seconds that the last digit of a time of STEP 5 stands for, in milliseconds.
const TIME_BASES: [u64; 4] = [10, 100, 1_000, 10_000];

/// What an operand of STEP 5 is in STL.
enum Step5 {
    /// Written so.
    Is(String),
    /// One of these, which only the user knows, and why.
    OneOf(Vec<String>, &'static str),
}

impl Parser<'_> {
    /// `F 10.0`, `KF +10`, `DW 5`: an operand of STEP 5 at the current word; nothing is taken if it is none.
    pub(super) fn step5_operand(&mut self) -> Option<Operand> {
        let (start, letters_end) = (self.position, self.end);
        if letters_end - start > 2 {
            return None;
        }
        let letters = self.current().to_ascii_uppercase();
        let at = self.behind_blanks(letters_end);
        if at == letters_end && !matches!(token(self.text, at).0, Raw::Sign) {
            return None;
        }
        let rest = &self.text[at..];
        let value = &rest[..rest.find(|c: char| !(in_word(c) || matches!(c, '.' | ',' | '+' | '-' | '\'' | ' '))).unwrap_or(rest.len())];
        let value = value.trim_end();
        let meant = step5(&letters, value, self.mnemonics)?;
        let end = at + value.len();
        let span = self.span(start, end);
        let written = self.slice(start, end);
        let message = format!("`{written}` is an operand of STEP 5");
        let diagnostic = Diagnostic::new(Problem::P2044, span, message);
        let (operand, diagnostic) = match meant {
            Step5::Is(right) => {
                let operand = self.step5_meaning(&right, start, end);
                (operand, diagnostic.fix(span, right.clone(), format!("write `{right}`")))
            }
            Step5::OneOf(ways, why) => {
                let ways: Vec<String> = ways.iter().map(|way| format!("`{way}`")).collect();
                (Operand::Error, diagnostic.help(format!("write {}: {why}", ways.join(" or "))))
            }
        };
        self.report(diagnostic);
        self.bump_to(SyntaxKind::Unexpected, end);
        Some(operand)
    }

    /// The operand that an address or a constant in the spelling of STL is.
    fn step5_meaning(&self, right: &str, start: usize, end: usize) -> Operand {
        let address = right.split_once(' ').and_then(|(letters, number)| {
            let (number, bit) = match number.split_once('.') {
                Some((byte, bit)) => (byte, Some(bit.parse().ok()?)),
                None => (number, None),
            };
            Some(Operand::Absolute { letters: letters.to_owned(), number: number.parse().ok()?, bit })
        });
        address.unwrap_or_else(|| {
            Operand::Constant(Constant { value: literal::parse(right).ok(), extended: false, span: self.span(start, end) })
        })
    }

    /// `JC =skip`, `JU FB 5`: what a jump of STEP 5 has behind it; nothing is taken if it is something else.
    pub(super) fn step5_label(&mut self, wants_label: bool, mnemonic: &Word) -> Option<Operand> {
        if !wants_label {
            return None;
        }
        let start = self.position;
        if self.raw == Raw::Sign && self.current() == "=" {
            let at = self.behind_blanks(self.end);
            let (raw, end) = token(self.text, at);
            if raw != Raw::Word {
                return None;
            }
            let label = self.slice(at, end).to_owned();
            let span = self.span(start, end);
            let message = format!("`={label}` is a label of STEP 5; STL writes it without `=`");
            self.report(Diagnostic::new(Problem::P2044, span, message).fix(span, label.clone(), format!("write `{label}`")));
            self.bump(SyntaxKind::Unexpected);
            self.blanks();
            return Some(Operand::Name { word: self.name_word(SyntaxKind::Name), path: Vec::new() });
        }
        let call = match mnemonic.text.to_ascii_uppercase().as_str() {
            "JU" | "SPA" => "UC",
            "JC" | "SPB" => "CC",
            _ => return None,
        };
        let word = self.current();
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let kind = BlockKind::from_abbreviation(letters).filter(|&kind| kind != BlockKind::DataBlock);
        let number = letters.len() < word.len() || self.raw_behind_blanks() == Raw::Number;
        let kind = kind.filter(|_| number && self.raw == Raw::Word && !self.is_label(word))?;
        let (_, end, _) = self.try_at(start, |parser| parser.operand(false));
        let block = self.slice(start, end);
        let (from, right) = (mnemonic.span.start as usize, format!("{call} {block}"));
        let span = self.span(from, end);
        let message = format!("`{}` calls a block in STEP 5; a jump of STL takes a label", self.slice(from, end));
        let diagnostic = Diagnostic::new(Problem::P2044, span, message);
        self.report(match kind {
            BlockKind::Function | BlockKind::SystemFunction => diagnostic.fix(span, right.clone(), format!("write `{right}`")),
            _ => diagnostic.help(format!("write `{right}`, or `CALL {block}` with its instance data block")),
        });
        self.bump_to(SyntaxKind::Unexpected, end);
        Some(Operand::Error)
    }

    /// `C DB 10`, and `A DB 10` in a source with SIMATIC mnemonics: STEP 5 opens a data block.
    pub(super) fn step5_open(&mut self) -> Option<Word> {
        let (letter, open) = match self.mnemonics {
            Mnemonics::English => ("C", "OPN"),
            Mnemonics::German => ("A", "AUF"),
        };
        let (start, end) = (self.position, self.end);
        if !self.at_word(letter) {
            return None;
        }
        let at = self.behind_blanks(end);
        let (raw, word_end) = token(self.text, at);
        let word = &self.text[at..word_end];
        let number = word.len() > 2 || token(self.text, self.behind_blanks(word_end)).0 == Raw::Number;
        let data = raw == Raw::Word
            && word.get(..2).is_some_and(|letters| letters.eq_ignore_ascii_case("DB"))
            && word[2..].bytes().all(|byte| byte.is_ascii_digit());
        if !data || !number || at == end {
            return None;
        }
        let span = self.span(start, end);
        let message = format!("`{}` with a data block is an instruction of STEP 5", self.slice(start, end));
        self.report(Diagnostic::new(Problem::P2044, span, message).fix(span, open, format!("write `{open}`")));
        self.bump(SyntaxKind::Mnemonic);
        Some(Word { text: open.to_owned(), span })
    }
}

/// What an operand of STEP 5 is in STL.
fn step5(letters: &str, value: &str, mnemonics: Mnemonics) -> Option<Step5> {
    let whole = || value.parse::<u64>().ok().filter(|_| value.bytes().all(|byte| byte.is_ascii_digit()));
    let is = |right: String| literal::parse(&right).is_ok().then_some(Step5::Is(right));
    if let Some((_, memory)) = FLAGS.iter().find(|(flag, _)| *flag == letters) {
        let bit = value.split_once('.').is_some_and(|(byte, bit)| byte.parse::<u32>().is_ok() && bit.parse::<u8>().is_ok());
        return (if letters == "F" { bit } else { whole().is_some() }).then(|| Step5::Is(format!("{memory} {value}")));
    }
    match letters {
        "DW" | "DD" | "DL" | "DR" => {
            let word = whole()?;
            let (own, byte) = match letters {
                "DD" => ("DBD", word * 2),
                "DL" => ("DBB", word * 2),
                "DR" => ("DBB", word * 2 + 1),
                _ => ("DBW", word * 2),
            };
            let why = "STEP 5 counts the words of a data block, STL its bytes; the same number is right only where the data block was written anew";
            Some(Step5::OneOf(vec![format!("{own} {byte}"), format!("{own} {word}")], why))
        }
        "D" => {
            let (word, bit) = value.split_once('.')?;
            let (word, bit) = (word.parse::<u64>().ok()?, bit.parse::<u64>().ok().filter(|&bit| bit < 16)?);
            // The high byte of a word comes first and has bits 8 to 15.
            let same = format!("DBX {}.{}", word * 2 + u64::from(bit < 8), bit % 8);
            let why = "STEP 5 counts the words of a data block and their bits up to 15, STL its bytes";
            Some(Step5::OneOf(vec![same, format!("DBX {word}.{}", bit % 8)], why))
        }
        "KF" => is(value.replace(' ', "").trim_start_matches('+').to_owned()),
        "KB" => is(whole()?.to_string()),
        "KH" => is(format!("W#16#{}", value.replace(' ', ""))),
        "KM" => is(format!("2#{}", value.split_whitespace().collect::<Vec<_>>().join("_"))),
        "KZ" => is(format!("C#{}", whole()?)),
        // The letters of a counter in English are those of characters in German.
        "KC" if mnemonics == Mnemonics::English && whole().is_some() => is(format!("C#{value}")),
        "KC" | "KS" => is(format!("'{}'", value.trim_matches('\''))),
        "KY" => is(format!("B#({})", value.replace(' ', ""))),
        "KT" => {
            let (number, base) = value.split_once('.')?;
            let base = TIME_BASES.get(base.parse::<usize>().ok()?)?;
            let milliseconds = number.parse::<u64>().ok()?.checked_mul(*base)?;
            is(if milliseconds % 1_000 == 0 { format!("S5T#{}S", milliseconds / 1_000) } else { format!("S5T#{milliseconds}MS") })
        }
        _ => None,
    }
}
