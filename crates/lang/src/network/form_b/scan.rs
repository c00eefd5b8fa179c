//! Signs, words and operands of a line of form B.

use super::parse::{Parsed, Wrong};
use crate::network::flavour::Flavour;
use crate::network::mistake::MistakeKind;
use crate::network::model::Place;
use crate::network::operand::Operand;

/// How deep brackets of a line may nest; nothing that a CPU can run comes near it.
pub(super) const NESTING_MAX: usize = 64;

/// The line, and where in it the parser is.
pub(super) struct Scanner<'t> {
    text: &'t str,
    /// The next byte.
    pub(super) at: usize,
    /// Where the line begins in the text that it is part of.
    offset: usize,
    depth: usize,
    pub(super) flavour: Flavour,
}

impl<'t> Scanner<'t> {
    pub(super) fn new(text: &'t str, offset: usize, flavour: Flavour) -> Self {
        Self { text, at: 0, offset, depth: 0, flavour }
    }

    pub(super) fn rest(&self) -> &'t str {
        self.text.get(self.at..).unwrap_or_default()
    }

    pub(super) fn space(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    pub(super) fn ended(&mut self) -> bool {
        self.space();
        self.rest().is_empty()
    }

    /// A message at the next sign.
    pub(super) fn wrong<T>(&mut self, message: impl Into<String>) -> Parsed<T> {
        self.space();
        self.wrong_at(self.at, message)
    }

    /// A message at a byte of the line.
    pub(super) fn wrong_at<T>(&self, at: usize, message: impl Into<String>) -> Parsed<T> {
        Err(Wrong { at: self.offset + at, message: message.into(), kind: MistakeKind::Line })
    }

    /// A message at a byte of the text that the line is part of.
    pub(super) fn wrong_in_text<T>(&self, at: usize, message: impl Into<String>) -> Parsed<T> {
        self.wrong_at(at.saturating_sub(self.offset), message)
    }

    /// The operand is the first thing from a byte of the line on.
    pub(super) fn begins_at(&self, operand: &Operand, at: usize) -> bool {
        let rest = self.text.get(at..).unwrap_or_default();
        operand.start.map(|start| start as usize) == Some(self.offset + self.text.len() - rest.trim_start().len())
    }

    /// The sign is the last thing that was read.
    pub(super) fn follows(&self, sign: &str) -> bool {
        self.text.get(..self.at).unwrap_or_default().trim_end().ends_with(sign)
    }

    /// The innermost bracket that is open here.
    pub(super) fn open_bracket(&self) -> Option<char> {
        let (mut open, mut quote) = (Vec::new(), None);
        for sign in self.text.get(..self.at).unwrap_or_default().chars() {
            match (quote, sign) {
                (Some(end), sign) if end == sign => quote = None,
                (Some(_), _) => {}
                (None, '"' | '\'') => quote = Some(sign),
                (None, '(' | '[' | '{') => open.push(sign),
                (None, ')' | ']' | '}') => drop(open.pop()),
                _ => {}
            }
        }
        open.pop()
    }

    /// From a byte of the line to the last one that was read.
    pub(super) fn since(&self, from: usize) -> Place {
        let read = self.text.get(from..self.at).unwrap_or_default().trim_end().len();
        Place::new(self.offset + from, self.offset + from + read)
    }

    pub(super) fn see(&mut self, sign: &str) -> bool {
        self.space();
        self.rest().starts_with(sign)
    }

    /// The sign stands right here, without a space before it.
    pub(super) fn touches(&self, sign: char) -> bool {
        self.rest().starts_with(sign)
    }

    pub(super) fn eat(&mut self, sign: &str) -> bool {
        let found = self.see(sign);
        if found {
            self.at += sign.len();
        }
        found
    }

    /// The sign comes next; otherwise the message is said.
    pub(super) fn want(&mut self, sign: &str, message: &str) -> Parsed<()> {
        if self.eat(sign) { Ok(()) } else { self.wrong(message) }
    }

    /// The letters, digits and `_` that come next; in names of IEC 61131-3 also the dots between them.
    pub(super) fn word(&mut self) -> &'t str {
        self.space();
        let rest = self.rest();
        let dots = self.flavour == Flavour::Iec && !rest.starts_with('.');
        let end = rest.find(|sign: char| !(sign.is_alphanumeric() || sign == '_' || (dots && sign == '.'))).unwrap_or(rest.len());
        rest.get(..end).unwrap_or_default()
    }

    pub(super) fn eat_word(&mut self, word: &str) -> bool {
        let found = self.word() == word;
        if found {
            self.at += word.len();
        }
        found
    }

    /// Goes into a bracket; refuses where they nest too deep.
    pub(super) fn enter(&mut self) -> Parsed<()> {
        self.depth += 1;
        if self.depth <= NESTING_MAX {
            return Ok(());
        }
        let message = format!("brackets nest deeper than {NESTING_MAX}");
        Err(Wrong { at: self.offset + self.at, message, kind: MistakeKind::Size })
    }

    pub(super) fn leave(&mut self) {
        self.depth = self.depth.saturating_sub(1);
    }

    /// An operand, a constant or a name.
    pub(super) fn operand(&mut self) -> Parsed<Operand> {
        self.space();
        let from = self.at;
        self.operand_part()?;
        if self.flavour == Flavour::Iec
            && let Some((sign, instead)) = operator(self.text.get(from..self.at).unwrap_or_default(), self.rest())
        {
            let message = format!("`{sign}` belongs to an expression of Structured Text; in a line of a diagram {instead}");
            return self.wrong_at(from, message);
        }
        if self.at == from || self.text.get(from..self.at) == Some(".") {
            self.at = from;
            return self.wrong("an operand is missing here");
        }
        let mut address = true;
        while address && self.flavour == Flavour::S7 {
            address = self.spaced_number(from)?;
        }
        let mut written = String::new();
        let mut spaces = false;
        let mut quote = None;
        for sign in self.text.get(from..self.at).unwrap_or_default().chars() {
            match quote {
                Some(open) if open == sign => quote = None,
                None if matches!(sign, '"' | '\'') => quote = Some(sign),
                _ => {}
            }
            if quote.is_none() && sign.is_whitespace() {
                spaces = true;
                continue;
            }
            if std::mem::take(&mut spaces) {
                written.push(' ');
            }
            written.push(sign);
        }
        Ok(Operand::at(written, self.offset + from))
    }

    /// What comes without a space.
    fn operand_part(&mut self) -> Parsed<()> {
        let rest = self.rest();
        let from = self.at;
        let mut end = rest.len();
        let (mut depth, mut quote, mut escaped) = (0_usize, None, false);
        let mut signs = rest.char_indices().peekable();
        while let Some((index, sign)) = signs.next() {
            let next = signs.peek().map(|next| next.1);
            match (quote, sign) {
                (Some('\''), '$') if !escaped => {
                    escaped = true;
                    continue;
                }
                (Some(open), sign) if sign == open && !escaped => quote = None,
                (Some(_), _) => {}
                (None, '"' | '\'') => quote = Some(sign),
                (None, '[') if index > 0 => depth += 1,
                // `B#(1, 2)`
                (None, '(') if rest.get(..index).is_some_and(|before| before.eq_ignore_ascii_case("B#")) => depth += 1,
                (None, ']' | ')') if depth > 0 => depth -= 1,
                (None, _) if depth > 0 => {}
                (None, ',' | ')' | '(' | '|' | ';' | '[' | ']' | '{' | '}' | '!' | '/' | '=' | '<' | '>') => {
                    end = index;
                    break;
                }
                (None, '&') if self.flavour == Flavour::S7 => {
                    end = index;
                    break;
                }
                (None, ':') if next == Some('=') => {
                    end = index;
                    break;
                }
                (None, '-') if next == Some('>') => {
                    end = index;
                    break;
                }
                (None, sign) if sign.is_whitespace() => {
                    end = index;
                    break;
                }
                _ => {}
            }
            escaped = false;
        }
        if let Some(open) = quote {
            return self.wrong_at(from, format!("the closing `{open}` of this name is missing"));
        }
        if depth > 0 {
            return self.wrong_at(from, "a closing bracket of this operand is missing");
        }
        self.at += end;
        Ok(())
    }

    /// `I 0.0`, `DB 10.DBX 0.0`, `P#M 0.0 BYTE 4`: a number or a unit after a space belongs to the operand. Says whether one came.
    fn spaced_number(&mut self, from: usize) -> Parsed<bool> {
        let read = self.text.get(from..self.at).unwrap_or_default();
        let rest = self.rest();
        let after = rest.trim_start();
        if after.len() == rest.len() {
            return Ok(false);
        }
        let is_pointer = read.get(..2).is_some_and(|begin| begin.eq_ignore_ascii_case("P#"));
        let tail = read.rsplit(['.', '#']).next().unwrap_or_default();
        let is_letters =
            matches!(tail.len(), 1..=3) && tail.bytes().all(|byte| byte.is_ascii_alphabetic()) && (!read.contains('#') || is_pointer);
        let number = after.starts_with(|sign: char| sign.is_ascii_digit()) && (is_letters || (is_pointer && ends_with_unit(read)));
        let unit = is_pointer && tail.ends_with(|sign: char| sign.is_ascii_digit()) && begins_with_unit(after);
        if !number && !unit {
            return Ok(false);
        }
        self.space();
        self.operand_part()?;
        Ok(true)
    }
}

/// The units of a pointer to an area.
const UNITS: [&str; 14] =
    ["BOOL", "BYTE", "WORD", "DWORD", "INT", "DINT", "REAL", "CHAR", "DATE", "TIME", "S5TIME", "DATE_AND_TIME", "TIME_OF_DAY", "STRING"];

fn begins_with_unit(text: &str) -> bool {
    let end = text.find(|sign: char| !(sign.is_ascii_alphanumeric() || sign == '_')).unwrap_or(text.len());
    UNITS.iter().any(|unit| text.get(..end).is_some_and(|word| word.eq_ignore_ascii_case(unit)))
}

fn ends_with_unit(text: &str) -> bool {
    text.rsplit(char::is_whitespace).next().is_some_and(|word| UNITS.iter().any(|unit| word.eq_ignore_ascii_case(unit)))
}

/// Operators of Structured Text, and what stands for them in a line.
const OPERATORS: [(&str, &str); 15] = [
    ("<", "it is a box, `LT(a, b)`, or a contact of form A, `NO a < b`"),
    (">", "it is a box, `GT(a, b)`, or a contact of form A, `NO a > b`"),
    ("=", "it is a box, `EQ(a, b)`, or a contact of form A, `NO a = b`, and coils stand after `->`"),
    ("<>", "it is a box, `NE(a, b)`, or a contact of form A, `NO a <> b`"),
    ("<=", "it is a box, `LE(a, b)`, or a contact of form A, `NO a <= b`"),
    (">=", "it is a box, `GE(a, b)`, or a contact of form A, `NO a >= b`"),
    ("+", "a sum has no spaces, `a+b`"),
    ("-", "a difference has no spaces, `a-b`"),
    ("*", "a product has no spaces, `a*b`"),
    ("**", "a power has no spaces, `a**b`"),
    ("&", "a space is AND"),
    ("AND", "a space is AND"),
    ("OR", "OR is `(a | b)`"),
    ("XOR", "exclusive OR is `xor(a, b)`, and only FBD has it"),
    ("MOD", "it is a box, `MOD(a, b)`"),
];

/// An operator where an operand is wanted, and what stands for it; comparisons end what was read.
fn operator(read: &str, rest: &str) -> Option<(&'static str, &'static str)> {
    let word = match read {
        "" => rest.find(|sign| !matches!(sign, '<' | '>' | '=')).map_or(rest, |end| &rest[..end]),
        read => read,
    };
    OPERATORS.iter().copied().find(|(sign, _)| sign.eq_ignore_ascii_case(word))
}
