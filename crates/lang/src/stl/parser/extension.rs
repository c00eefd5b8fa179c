//! Extension words: `__ASSERT== MW 10, 5`, `__ACCU 1`, `SFC -1`.

use sieben_model::problems::Problem;

use super::Parser;
use crate::stl::ast::{Operand, Word};
use crate::stl::extension::{self, PREFIX, Selector, status_bit, translate_status_bit};
use crate::stl::lexer::{Raw, in_word, token};
use crate::stl::syntax::SyntaxKind;

impl Parser<'_> {
    /// `__ASSERT==`, `__STWRST`; nothing is taken if the word is none of the extension words.
    pub(super) fn extension_mnemonic(&mut self) -> Option<Word> {
        let word = self.current();
        if !word.starts_with(PREFIX) {
            return None;
        }
        if extension::Word::from_spelling(word).is_some() {
            return Some(self.take_mnemonic(word.to_ascii_uppercase(), self.position, self.end));
        }
        let at = self.behind_blanks(self.end);
        let rest = &self.text[at..];
        let signs = rest.bytes().take(2).take_while(|byte| b"=<>".contains(byte)).count();
        // `__ASSERT==R a, b`, but `__ASSERT==RET, 5` has an operand without a blank before it.
        let real = rest[signs..].starts_with(['R', 'r']) && !rest[signs + 1..].starts_with(|next| in_word(next) || next == '.');
        for length in [signs + usize::from(real), signs] {
            let spelled = format!("{word}{}", &rest[..length]).to_ascii_uppercase();
            if signs > 0 && extension::Word::from_spelling(&spelled).is_some() {
                return Some(self.take_mnemonic(spelled, at, at + length));
            }
        }
        None
    }

    /// The operands behind an extension word, with commas between them.
    pub(super) fn extension_operands(&mut self) -> Operand {
        self.start(SyntaxKind::Operand);
        let mut operands = Vec::new();
        loop {
            let start = self.position;
            let operand = self.operand(false);
            operands.push((operand, self.span(start, self.position)));
            if token(self.text, self.behind_blanks(self.position)).0 != Raw::Comma {
                break;
            }
            self.blanks();
            self.bump(SyntaxKind::Punctuation);
            self.blanks();
        }
        self.finish();
        Operand::List(operands)
    }

    /// `__ACCU 1`, `__STW VKE`, `__CNST_PI`; nothing is taken if the word is none of them.
    pub(super) fn extension_operand(&mut self) -> Option<Operand> {
        let start = self.position;
        let (name, selector) = extension::operand_name(self.current())?;
        self.bump_to(SyntaxKind::Name, start + name.len());
        let number = match selector {
            Selector::None => 0,
            Selector::Number(most) => {
                self.blanks();
                match self.selecting_number() {
                    Some(number) if (1..=most).contains(&number) => number,
                    _ => return Some(self.wrong_selector(start, &format!("`{name}` takes a number from 1 to {most}"))),
                }
            }
            Selector::StatusBit => {
                self.blanks();
                match self.selecting_status_bit() {
                    Some(number @ 0..=8) => number,
                    _ => return Some(self.wrong_selector(start, "`__STW` takes the name of a status bit or a number from 0 to 8")),
                }
            }
        };
        Some(Operand::Register { name: Word { text: name.to_owned(), span: self.span(start, self.position) }, number })
    }

    fn wrong_selector(&mut self, start: usize, message: &str) -> Operand {
        self.error(Problem::P2041, start, self.end.max(start + 1), message);
        self.skip_operand()
    }

    fn selecting_number(&mut self) -> Option<u32> {
        // The digits may be the rest of the word: `__ACCU1`.
        let rest = &self.text[self.position..];
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        let number = rest[..digits].parse().ok()?;
        self.bump_to(SyntaxKind::Number, self.position + digits);
        Some(number)
    }

    fn selecting_status_bit(&mut self) -> Option<u32> {
        if self.raw == Raw::Number || self.text[self.position..].starts_with(|c: char| c.is_ascii_digit()) {
            return self.selecting_number();
        }
        let start = self.position;
        let slash = usize::from(self.text[start..].starts_with('/'));
        let (raw, end) = token(self.text, start + slash);
        if raw != Raw::Word {
            return None;
        }
        let name = self.slice(start, end);
        let number = match status_bit(name, self.mnemonics) {
            Some(number) => number,
            None => {
                let number = status_bit(name, self.mnemonics.other())?;
                if let Some(right) = translate_status_bit(name, self.mnemonics.other()) {
                    self.foreign(start, end, right);
                }
                number
            }
        };
        self.bump_to(SyntaxKind::StatusBit, end);
        Some(number)
    }

    /// The number behind `SFC` or `SFB` if it is negative: `SFC -1` is 65535.
    pub(super) fn negative_number(&self, letters: &str, at: usize) -> Option<(u64, usize)> {
        if !["SFC", "SFB"].iter().any(|system| letters.eq_ignore_ascii_case(system)) || !self.text[at..].starts_with('-') {
            return None;
        }
        let (raw, end) = token(self.text, self.behind_blanks(at + 1));
        let digits = &self.text[self.behind_blanks(at + 1)..end];
        let number: u16 = digits.parse().ok().filter(|_| raw == Raw::Number)?;
        (1..=0x8000).contains(&number).then(|| (u64::from(number.wrapping_neg()), end))
    }
}
