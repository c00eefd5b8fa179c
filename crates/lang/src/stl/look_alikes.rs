//! Characters that look like those of STL: letters of other alphabets, signs of typesetting, letters for digits.

use std::borrow::Cow;

use sieben_model::literal;

use crate::scan::{self, straight_quote};

/// Why a word with letters of other alphabets is a slip.
pub(super) const OTHER_ALPHABET: &str = "has letters of another alphabet that only look like Latin ones";

/// Why a number with letters is a slip.
const LETTERS_FOR_DIGITS: &str = "has letters that only look like digits";

/// The Latin text that a text with Cyrillic or Greek look-alikes seems to be; `None` if it has none or others.
pub fn latin(text: &str) -> Option<String> {
    if text.is_ascii() {
        return None;
    }
    text.chars()
        .map(|character| match character {
            'А' | 'а' | 'Α' | 'α' => Some('A'),
            'В' | 'в' | 'Β' => Some('B'),
            'С' | 'с' => Some('C'),
            'Е' | 'е' | 'Ε' => Some('E'),
            'Н' | 'Η' => Some('H'),
            'І' | 'і' | 'Ι' | 'ι' => Some('I'),
            'Ј' | 'ј' => Some('J'),
            'К' | 'к' | 'Κ' | 'κ' => Some('K'),
            'М' | 'м' | 'Μ' => Some('M'),
            'Ν' => Some('N'),
            'О' | 'о' | 'Ο' | 'ο' => Some('O'),
            'Р' | 'р' | 'Ρ' | 'ρ' => Some('P'),
            'Ѕ' | 'ѕ' => Some('S'),
            'Т' | 'т' | 'Τ' => Some('T'),
            'Ѡ' | 'Ԝ' | 'ԝ' => Some('W'),
            'Х' | 'х' | 'Χ' | 'χ' => Some('X'),
            'У' | 'у' | 'Υ' | 'Ү' => Some('Y'),
            'Ζ' => Some('Z'),
            // The wide forms of Asian fonts.
            '\u{ff10}'..='\u{ff19}' | '\u{ff21}'..='\u{ff3a}' | '\u{ff41}'..='\u{ff5a}' => char::from_u32(u32::from(character) - 0xfee0),
            character if character.is_ascii() => Some(character),
            _ => None,
        })
        .collect()
}

/// Characters or a symbol with straight quotes; `None` if its own are straight.
pub(super) fn straightened(text: &str) -> Option<String> {
    let (first, last) = (text.chars().next()?, text.chars().next_back()?);
    let quote = match straight_quote(first) {
        Some(quote) => quote,
        None if matches!(first, '\'' | '"') && straight_quote(last) == Some(first) => first,
        None => return None,
    };
    let inner = &text[first.len_utf8()..];
    let closed = last == quote || straight_quote(last) == Some(quote);
    let inner = if closed { inner.strip_suffix(last).unwrap_or(inner) } else { inner };
    Some(if closed { format!("{quote}{inner}{quote}") } else { format!("{quote}{inner}") })
}

/// The signs of STL that a sign of typesetting stands for; STL has no `=>`.
pub(super) fn typeset_sign(sign: char) -> Option<&'static str> {
    scan::typeset_sign(sign).filter(|signs| *signs != "=>")
}

/// A constant as it was meant, with Latin letters and with digits for the letters O and l, and why it is not read.
pub(super) fn meant_constant(text: &str) -> Option<(String, &'static str)> {
    let latin = latin(text).map_or(Cow::Borrowed(text), Cow::Owned);
    let reads = |text: &str| literal::parse(text).is_ok();
    if latin != text && reads(&latin) {
        return Some((latin.into_owned(), OTHER_ALPHABET));
    }
    let head = latin.rfind('#').map_or(0, |at| at + 1);
    let (head, digits) = latin.split_at(head);
    let with_digits: String = digits
        .chars()
        .map(|character| match character {
            'O' | 'o' => '0',
            'l' => '1',
            other => other,
        })
        .collect();
    let right = format!("{head}{with_digits}");
    let why = if text.is_ascii() { LETTERS_FOR_DIGITS } else { OTHER_ALPHABET };
    (right != text && reads(&right)).then_some((right, why))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_are_read_as_they_were_meant() {
        for (written, meant) in [
            ("2#1OOO_OOOO", Some("2#1000_0000")),
            ("W#16#1O", Some("W#16#10")),
            ("W#16#lF", Some("W#16#1F")),
            ("С#42", Some("C#42")),
            ("Р#М10.0", Some("P#M10.0")),
            ("S5T#1Os", Some("S5T#10s")),
            ("2#102", None),
            ("W#16#G", None),
            ("5", None),
        ] {
            assert_eq!(meant_constant(written).map(|(right, _)| right).as_deref(), meant, "{written}");
        }
    }

    #[test]
    fn quotes_are_made_straight() {
        assert_eq!(straightened("‘X6’").as_deref(), Some("'X6'"));
        assert_eq!(straightened("“name”").as_deref(), Some("\"name\""));
        assert_eq!(straightened("„name“").as_deref(), Some("\"name\""));
        assert_eq!(straightened("\"name”").as_deref(), Some("\"name\""));
        assert_eq!(straightened("‘X6").as_deref(), Some("'X6"));
        assert_eq!(straightened("\"name\""), None);
    }
}
