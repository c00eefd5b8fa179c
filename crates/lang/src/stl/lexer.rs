//! Cuts STL text into tokens, one at a time and without knowledge of what stands around them.
//!
//! The parser asks for the token at a byte and may take less of it (`I0` is letters and a number)
//! or several at once (`=`, `=` and `I` are one instruction).

use super::look_alikes::latin;
pub(super) use crate::scan::in_word;
use crate::scan::{self, ends_in_escape, is_blank, straight_quote, while_in};

/// What a token looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Raw {
    End,
    /// Blanks, tabs and a byte order mark.
    Blank,
    /// CR LF, LF or CR.
    Newline,
    /// `// …` without the blanks at its end.
    LineComment,
    /// `(* … *)`, unterminated to the end of the text.
    BlockComment,
    /// Letters, digits and underscores, not beginning with a digit.
    Word,
    /// `5`, `1.5`, `1.0e+003`.
    Number,
    /// `W#16#FF`, `P#M 1.0 BYTE 4`, `2#1010`.
    Literal,
    /// `P##name`.
    AddressOf,
    /// `'text'`, unterminated to the end of the line.
    Characters,
    /// `"symbol"`, unterminated to the end of the line.
    Symbol,
    /// `#local`, `#"local"`.
    Local,
    Semicolon,
    Colon,
    /// `:=`.
    Becomes,
    Comma,
    /// `.`.
    Point,
    /// `..`.
    Range,
    ParenOpen,
    ParenClose,
    BracketOpen,
    BracketClose,
    BraceOpen,
    BraceClose,
    /// One of `= < > + - * /`.
    Sign,
    /// A character that begins nothing.
    Unknown,
}

/// The text without the blanks at its end.
pub(super) fn trim_blanks(text: &str) -> &str {
    text.trim_end_matches(is_blank)
}

/// The token that begins at byte `start`: its look and the byte behind it.
pub(super) fn token(text: &str, start: usize) -> (Raw, usize) {
    let rest = &text[start..];
    let Some(first) = rest.chars().next() else { return (Raw::End, start) };
    let one = start + first.len_utf8();
    let second = text.as_bytes().get(one).copied().unwrap_or(0);
    match first {
        '\r' if second == b'\n' => (Raw::Newline, one + 1),
        '\r' | '\n' | '\u{c}' => (Raw::Newline, one),
        first if is_blank(first) => (Raw::Blank, while_in(text, one, is_blank)),
        '/' if second == b'/' => {
            let line = &rest[..rest.find(['\r', '\n']).unwrap_or(rest.len())];
            (Raw::LineComment, start + trim_blanks(line).len())
        }
        '(' if second == b'*' => (Raw::BlockComment, text[one + 1..].find("*)").map_or(text.len(), |end| one + 1 + end + 2)),
        '(' => (Raw::ParenOpen, one),
        ')' => (Raw::ParenClose, one),
        '[' => (Raw::BracketOpen, one),
        ']' => (Raw::BracketClose, one),
        '{' => (Raw::BraceOpen, one),
        '}' => (Raw::BraceClose, one),
        ';' => (Raw::Semicolon, one),
        ',' => (Raw::Comma, one),
        ':' if second == b'=' => (Raw::Becomes, one + 1),
        ':' => (Raw::Colon, one),
        '.' if second == b'.' => (Raw::Range, one + 1),
        '.' => (Raw::Point, one),
        '=' | '<' | '>' | '+' | '-' | '*' | '/' => (Raw::Sign, one),
        '\'' => (Raw::Characters, quoted(text, one, '\'')),
        '"' => (Raw::Symbol, quoted(text, one, '"')),
        first if straight_quote(first).is_some() => match straight_quote(first) {
            Some('"') => (Raw::Symbol, typeset(text, one, '"')),
            _ => (Raw::Characters, typeset(text, one, '\'')),
        },
        '#' if second == b'"' => (Raw::Local, quoted(text, one + 1, '"')),
        '#' => match while_in(text, one, in_word) {
            end if end > one => (Raw::Local, end),
            _ => (Raw::Unknown, one),
        },
        '0'..='9' => number(text, start),
        first if in_word(first) => word(text, start),
        _ => (Raw::Unknown, one),
    }
}

/// Whether a token of characters, a symbol or a block comment has its end.
pub(super) fn is_terminated(raw: Raw, text: &str) -> bool {
    if matches!(raw, Raw::Characters | Raw::Symbol)
        && let Some(first) = text.chars().next().filter(|&first| straight_quote(first).is_some())
    {
        return text.chars().next_back().is_some_and(|last| {
            text.len() > first.len_utf8() && (straight_quote(last) == straight_quote(first) || Some(last) == straight_quote(first))
        });
    }
    match raw {
        Raw::Characters if text.ends_with(|last| straight_quote(last) == Some('\'')) => true,
        Raw::Symbol if text.ends_with(|last| straight_quote(last) == Some('"')) => true,
        Raw::Characters => text.len() > 1 && text.ends_with('\'') && quoted(text, 1, '\'') == text.len() && !ends_in_escape(text),
        Raw::Symbol => text.len() > 1 && text.ends_with('"'),
        Raw::Local => !text.starts_with("#\"") || (text.len() > 2 && text.ends_with('"')),
        Raw::BlockComment => text.len() > 3 && text.ends_with("*)"),
        _ => true,
    }
}

/// The byte after the next quote of a kind, straight or of typesetting, or the end of the line.
fn typeset(text: &str, start: usize, quote: char) -> usize {
    let closes = |c: char| c == quote || straight_quote(c) == Some(quote);
    match text[start..].char_indices().find(|&(_, c)| closes(c) || matches!(c, '\r' | '\n')) {
        Some((at, '\r' | '\n')) => start + trim_blanks(&text[start..start + at]).len(),
        Some((at, closing)) => start + at + closing.len_utf8(),
        None => text.len(),
    }
}

/// The byte behind the closing quote, or the end of the line.
fn quoted(text: &str, start: usize, quote: char) -> usize {
    let mut escaped = false;
    for (at, character) in text[start..].char_indices() {
        match character {
            // A straight quote may be closed by one of typesetting, where nothing else closes it.
            '\r' | '\n' if typeset(text, start, quote) < start + at => return typeset(text, start, quote),
            '\r' | '\n' => return start + trim_blanks(&text[start..start + at]).len(),
            _ if escaped => escaped = false,
            '$' if quote == '\'' => escaped = true,
            _ if character == quote => return start + at + 1,
            _ => {}
        }
    }
    typeset(text, start, quote)
}

fn number(text: &str, start: usize) -> (Raw, usize) {
    let bytes = text.as_bytes();
    let digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    let digits = |at: usize| while_in(text, at, |c| c.is_ascii_digit() || c == '_');
    let mut end = digits(start);
    if bytes.get(end) == Some(&b'#') {
        return (Raw::Literal, while_in(text, end + 1, in_word));
    }
    if bytes.get(end) == Some(&b'.') && digit(end + 1) {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if digit(end + 1 + sign) {
            end = digits(end + 1 + sign);
        }
    }
    (Raw::Number, end)
}

fn word(text: &str, start: usize) -> (Raw, usize) {
    let end = while_in(text, start, in_word);
    if text.as_bytes().get(end) != Some(&b'#') {
        return (Raw::Word, end);
    }
    let next = text.as_bytes().get(end + 1).copied().unwrap_or(0);
    let value = next.is_ascii_digit() || matches!(next, b'+' | b'-');
    let prefix = &text[start..end];
    let latin = latin(prefix);
    let is = |name: &str| latin.as_deref().unwrap_or(prefix).eq_ignore_ascii_case(name);
    if is("P") {
        return pointer(text, end + 1);
    }
    let bracket = while_in(text, end + 1, is_blank);
    if is("B") && latin.is_none() && text[bracket..].starts_with('(') {
        let rest = &text[end..];
        let close = rest.find([')', '\r', '\n', ';']);
        return (Raw::Literal, close.map_or(text.len(), |at| end + at + usize::from(rest.as_bytes()[at] == b')')));
    }
    let long = ["S5T", "S5TIME", "TIME", "DATE", "TOD", "TIME_OF_DAY", "DT", "DATE_AND_TIME", "DW"].into_iter().any(is);
    // `L#x` and `T#x` are an instruction and a local variable.
    if !(long || (value && ["L", "B", "W", "C", "T", "D"].into_iter().any(is))) {
        return (Raw::Word, end);
    }
    let calendar = ["D", "DATE", "TOD", "TIME_OF_DAY", "DT", "DATE_AND_TIME"].into_iter().any(is);
    let signed = end + 1 + usize::from(matches!(next, b'+' | b'-'));
    (Raw::Literal, while_in(text, signed, |c| in_word(c) || matches!(c, '#' | '.') || (calendar && matches!(c, '-' | ':'))))
}

/// `P##name`, `P#1.0`, `P#M 1.0`, `P#DB10.DBX 12.0 REAL 20`; `start` is behind the `#`.
fn pointer(text: &str, start: usize) -> (Raw, usize) {
    let bytes = text.as_bytes();
    if bytes.get(start) == Some(&b'#') {
        return match bytes.get(start + 1) {
            Some(b'"') => (Raw::AddressOf, quoted(text, start + 2, '"')),
            _ => (Raw::AddressOf, while_in(text, start + 1, in_word)),
        };
    }
    (Raw::Literal, scan::pointer(text, start))
}
