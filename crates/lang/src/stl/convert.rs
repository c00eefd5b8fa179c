//! `sieben convert --mnemonics`: rewrites the words that differ between the mnemonic languages, byte for byte nothing else.

use rowan::NodeOrToken;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::FileId;

use super::extension::translate_status_bit;
use super::lexer::{Raw, token};
use super::mnemonics::{translate_instruction, translate_letters, translate_status};
use super::parser::parse_as;
use super::syntax::{SyntaxKind, SyntaxToken};
use crate::network::flavour::Drawing;

/// The source in the language `to`. Words that already are in it stay as they are.
///
/// Without `from` the language is judged. Errors of syntax are returned instead, because words next to them
/// might be taken for the wrong thing; a statement in the other language and a misprint are none of them.
pub fn convert(text: &str, from: Option<Mnemonics>, to: Mnemonics) -> Result<String, Vec<Diagnostic>> {
    convert_as(text, from, to, None)
}

/// The same for a source whose networks are drawn, unless they say something else.
pub fn convert_as(text: &str, from: Option<Mnemonics>, to: Mnemonics, drawing: Option<Drawing>) -> Result<String, Vec<Diagnostic>> {
    let parsed = parse_as(FileId::default(), text, from, drawing);
    let errors: Vec<Diagnostic> = parsed.diagnostics.iter().filter(|diagnostic| stops_rewriting(diagnostic)).cloned().collect();
    if !errors.is_empty() {
        return Err(errors);
    }
    let mut out = String::with_capacity(text.len() + text.len() / 16);
    for element in parsed.syntax().descendants_with_tokens() {
        if let NodeOrToken::Token(token) = element {
            match translated(&token, parsed.mnemonics, to) {
                Some(text) => out.push_str(&text),
                None => out.push_str(token.text()),
            }
        }
    }
    Ok(out)
}

/// A part of a source and what stands there in the other language.
pub type Translated = (std::ops::Range<usize>, String);

/// The words of a source that are others in the language `to`, in their order; none where the source has errors of syntax.
pub fn translations(text: &str, from: Option<Mnemonics>, to: Mnemonics, drawing: Option<Drawing>) -> Vec<Translated> {
    let parsed = parse_as(FileId::default(), text, from, drawing);
    if parsed.diagnostics.iter().any(stops_rewriting) {
        return Vec::new();
    }
    let tokens = parsed.syntax().descendants_with_tokens().filter_map(NodeOrToken::into_token);
    let word = |token: SyntaxToken| {
        let range = token.text_range();
        Some((usize::from(range.start())..usize::from(range.end()), translated(&token, parsed.mnemonics, to)?))
    };
    tokens.filter_map(word).collect()
}

/// The addresses of a diagram in another language; its words are the same in both.
fn diagram(text: &str, to: Mnemonics) -> Option<String> {
    let mut out = String::with_capacity(text.len());
    let mut before = Before::default();
    let mut position = 0;
    loop {
        let (raw, end) = token(text, position);
        let word = &text[position..end];
        if raw == Raw::End {
            return Some(out);
        }
        let mut next = end;
        while let (Raw::Blank, behind) = token(text, next) {
            next = behind;
        }
        let letters = word.trim_end_matches(|sign: char| sign.is_ascii_digit());
        let numbered = letters.len() < word.len() || matches!(token(text, next).0, Raw::Number);
        let right = match raw {
            Raw::Word if before.makes_a_name(&text[..position], &text[next..]) => None,
            Raw::Word if numbered => translate_letters(letters, to.other()),
            Raw::Word => translate_status(word, to.other()),
            _ => None,
        };
        match right {
            Some(right) => out.push_str(&(right.to_owned() + &word[letters.len()..])),
            None => out.push_str(word),
        }
        before.pass(raw, word);
        position = end;
    }
}

/// What stands before a word of a diagram on its line.
#[derive(Default)]
struct Before<'t> {
    /// The last word.
    word: &'t str,
    /// The line calls a block, whose pins may have any names.
    calls: bool,
}

impl<'t> Before<'t> {
    /// A word there is no address: a label, a component, the type of a comparison, a pin of a block. The texts are those before and after it.
    fn makes_a_name(&self, before: &str, after: &str) -> bool {
        let operators = before.trim_end_matches(['=', '<', '>']);
        let compares = before.len() > operators.len() && !before.ends_with("=>") && !matches!(&before[operators.len()..], "=");
        let is_pin = after.starts_with(":=")
            || after.starts_with(':') && self.word.is_empty()
            || after.starts_with("=>") && (self.word.is_empty() || self.calls);
        matches!(self.word, "LABEL" | "JMP" | "JMPN") || before.ends_with('.') || compares || is_pin
    }

    fn pass(&mut self, raw: Raw, word: &'t str) {
        match raw {
            Raw::Newline => *self = Self::default(),
            Raw::Word => {
                self.calls |= word == "CALL";
                self.word = word;
            }
            _ => {}
        }
    }
}

/// Whether a source with this diagnostic is not rewritten.
pub(super) fn stops_rewriting(diagnostic: &Diagnostic) -> bool {
    diagnostic.severity() == Severity::Error
        && !matches!(diagnostic.problem, Problem::P2002 | Problem::P2007 | Problem::P2008)
        && diagnostic.problem.code() < "P3000"
}

fn translated(token: &SyntaxToken, file: Mnemonics, to: Mnemonics) -> Option<String> {
    let text = token.text();
    let right = match token.kind() {
        SyntaxKind::Diagram => return diagram(text, to),
        // A word that both sets have is meant in the language of the file: `SE`.
        SyntaxKind::Mnemonic if file == to && translate_instruction(text, to).is_some() => return None,
        SyntaxKind::Mnemonic => translate_instruction(text, to.other())?,
        SyntaxKind::AddressLetters => translate_letters(text, to.other())?,
        SyntaxKind::StatusWord => translate_status(text, to.other())?,
        SyntaxKind::StatusBit => translate_status_bit(text, to.other())?,
        SyntaxKind::Constant => return translated_pointer(text, to),
        _ => return None,
    };
    (!right.eq_ignore_ascii_case(text)).then(|| in_case_of(text, right))
}

/// `P#I 1.0 BYTE 4` becomes `P#E 1.0 BYTE 4`.
fn translated_pointer(text: &str, to: Mnemonics) -> Option<String> {
    let behind = text.strip_prefix(['P', 'p'])?.strip_prefix('#')?;
    let start = text.len() - behind.trim_start().len();
    let length = text[start..].bytes().take_while(u8::is_ascii_alphabetic).count();
    let letters = &text[start..start + length];
    let right = translate_letters(letters, to.other())?;
    Some(format!("{}{}{}", &text[..start], in_case_of(letters, right), &text[start + length..]))
}

/// The right word in lower case if the written one is.
pub(super) fn in_case_of(written: &str, right: &str) -> String {
    let lower = written.bytes().any(|byte| byte.is_ascii_lowercase()) && !written.bytes().any(|byte| byte.is_ascii_uppercase());
    if lower { right.to_ascii_lowercase() } else { right.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_diagram_keeps_what_is_a_name() {
        for (english, german) in [
            ("NO I 0.0\nCMP >I 5, MW 0\nCOIL Q 4.0\n", "NO E 0.0\nCMP >I 5, MW 0\nCOIL A 4.0\n"),
            ("[IW 0 ==I 5] [MD 4 <>D 7] -> = Q 4.0\n", "[EW 0 ==I 5] [MD 4 <>D 7] -> = A 4.0\n"),
            ("NO BR\nJMP C1\nNETWORK\nLABEL C1:\nNC I0.1\nR C 1\n", "NO BIE\nJMP C1\nNETWORK\nLABEL C1:\nNC E0.1\nR Z 1\n"),
            ("MOVE IW0 => QW2\n", "MOVE EW0 => AW2\n"),
            (
                "CALL FB 1, DB 1\n    C1 := I 0.0\n    BR:\n        NO I 0.1\n    Q1 => Q 0.0\n",
                "CALL FB 1, DB 1\n    C1 := E 0.0\n    BR:\n        NO E 0.1\n    Q1 => A 0.0\n",
            ),
            ("CALL FB 1, DB 1 (C1 := =I 0.0, Q1 => Q 0.0)\n", "CALL FB 1, DB 1 (C1 := =E 0.0, Q1 => A 0.0)\n"),
            ("NO DB1.I1\nCOIL #a.C1\n", "NO DB1.I1\nCOIL #a.C1\n"),
        ] {
            assert_eq!(diagram(english, Mnemonics::German).as_deref(), Some(german));
            assert_eq!(diagram(german, Mnemonics::English).as_deref(), Some(english));
        }
    }
}
